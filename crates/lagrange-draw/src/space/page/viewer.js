// Shows things in space. `film.space` has meshes, where things are at each moment, and how all is seen at first; lengths are such that
// all ever lies within 1 of the middle.
function viewer() {
  const space = film.space;
  const [box, canvas, reset] = ["space", "canvas", "reset"].map(element);
  const painter = paintsThings(canvas, space);
  if (!painter) {
    element("no-space").hidden = false;
    return () => {};
  }
  box.hidden = false;
  element("flat").hidden = true;
  const camera = turnsAbout(space);
  const labels = placesLabels(space);
  let moment = [0, 0];
  let isAsked = false;

  function draw() {
    isAsked = false;
    const things = placements(space, ...moment);
    const traces = space.traces.map((trace) => traced(trace, ...moment, space.unit));
    reset.hidden = camera.isFirst();
    painter.draw(camera, things, traces);
    labels.draw(camera, things, traces);
  }
  function changed() {
    if (!isAsked) requestAnimationFrame(draw);
    isAsked = true;
  }
  new ResizeObserver(() => { camera.fit([canvas.clientWidth, canvas.clientHeight]); draw(); }).observe(canvas);
  camera.fit([canvas.clientWidth, canvas.clientHeight]);
  followsHands(canvas, camera, changed);
  reset.addEventListener("click", () => { camera.reset(); canvas.focus({ preventScroll: true }); changed(); });
  scheme().addEventListener("change", draw);
  canvas.addEventListener("webglcontextlost", (event) => event.preventDefault());
  canvas.addEventListener("webglcontextrestored", () => { painter.build(); changed(); });
  return Object.assign((index, part) => { moment = [index, part]; draw(); }, { camera });
}

// Numbers of a moment, each of `width`, in a list that has a single one if they never change.
function at(list, width, index) {
  const start = list.length === width ? 0 : width * index;
  return list.slice(start, start + width);
}

// Numbers a part of the way from a moment to the next.
function onTheWay(list, width, index, part) {
  const from = at(list, width, index);
  if (part === 0 || list.length === width) return from;
  const to = at(list, width, index + 1);
  return from.map((value, k) => value + part * (to[k] - value));
}

// The rotation a part of the way between two: K. Shoemake, Animating Rotation with Quaternion Curves, SIGGRAPH 1985.
function rotation(list, index, part) {
  const unit = (four) => four.map((value) => value / Math.hypot(...four));
  const a = unit(at(list, 4, index));
  if (part === 0 || list.length === 4) return a;
  let b = unit(at(list, 4, index + 1));
  let cosine = a.reduce((sum, value, k) => sum + value * b[k], 0);
  if (cosine < 0) [cosine, b] = [-cosine, b.map((value) => -value)];
  if (cosine > 0.9999) return unit(a.map((value, k) => value + part * (b[k] - value)));
  const angle = Math.acos(cosine);
  const [p, q] = [Math.sin((1 - part) * angle), Math.sin(part * angle)].map((sine) => sine / Math.sin(angle));
  return a.map((value, k) => p * value + q * b[k]);
}

// A matrix by columns.
function matrix([x, y, z, w]) {
  return [
    1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y),
    2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x),
    2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y),
  ];
}

// Where things are; a page that moves them by itself has their `poses`.
function placements(space, index, part) {
  return space.poses?.[index] ?? space.things.map((thing) => placement(thing, index, part, space.unit));
}

// Where a thing is.
function placement(thing, index, part, unit) {
  return {
    origin: onTheWay(thing.at, 3, index, part).map((value) => unit * value),
    turn: matrix(rotation(thing.turn, index, part)),
    stretch: unit * onTheWay(thing.stretch, 1, index, part)[0],
    scale: onTheWay(thing.scale, 1, index, part)[0] / 1e4,
  };
}

// Where a corner of a thing is.
function placed({ origin, turn, stretch, scale }, [x, y, z, share]) {
  const own = [scale * x, scale * y, scale * z + share * stretch];
  return origin.map((value, k) => value + turn[k] * own[0] + turn[k + 3] * own[1] + turn[k + 6] * own[2]);
}

// How many points of a trace are passed, and the point that has been reached.
function traced(trace, index, part, unit) {
  const tip = onTheWay(trace.points, 3, index, part).map((value) => unit * value);
  return { passed: trace.past.length / 3 + index + 1, tip };
}

