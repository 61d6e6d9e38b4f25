// Shows pictures of marks: `layers` says what changes of the first one.
function viewer() {
  const counts = { M: 2, L: 2, C: 6, Z: 0 };

  function pathData(kinds, numbers) {
    let next = 0;
    const piece = (kind) => kind + numbers.slice(next, (next += counts[kind])).join(" ");
    return [...kinds].map(piece).join("");
  }

  // Each kind of layer: the layer, its group, the mark within it, the picture, the way to the next.
  const changes = {
    shows: (layer, group, mark, index) => layer.track.some(([from, to]) => from <= index && index < to),
    moves: (layer, group, mark, index, part) => {
      const pose = between(layer.track, index, part);
      if (pose === null) return false;
      const [x, y, angle] = pose;
      group.setAttribute("transform", `translate(${x} ${y})` + (angle ? ` rotate(${angle})` : ""));
      return true;
    },
    grows: (layer, group, mark, index, part) => {
      const length = between(layer.track, index, part);
      if (length === null) return false;
      mark.setAttribute("stroke-dashoffset", layer.length - length);
      return true;
    },
    bends: (layer, group, mark, index, part) => {
      const numbers = between(layer.track, index, part);
      if (numbers === null) return false;
      mark.setAttribute("d", pathData(layer.kinds, numbers));
      return true;
    },
  };

  const groups = film.layers.map((layer, number) => element(`layer-${number}`));

  return (index, part) => {
    film.layers.forEach((layer, number) => {
      const group = groups[number];
      const isShown = changes[layer.change](layer, group, group.firstElementChild, index, part);
      group.setAttribute("visibility", isShown ? "visible" : "hidden");
    });
  };
}
