// How things are seen: from a direction, as large as fits at first, then zoomed and shifted.
function turnsAbout(space) {
  const [azimuth, elevation] = space.view;
  const first = { azimuth, elevation, zoom: 1, shift: [0, 0] };
  const free = { side: 28, above: document.querySelector("#space .title") ? 44 : 28, below: 32 };
  const places = extremes(space);
  let view = { ...first };
  // The picture, where its middle is in the first view, and pixels to a length in that view and in this one.
  let [size, middle, largest, fitting] = [[1, 1], [0, 0], 1, 1];

  function axes() {
    const [sin, cos, rise, level] = [Math.sin(view.azimuth), Math.cos(view.azimuth), Math.sin(view.elevation), Math.cos(view.elevation)];
    return [[-sin, cos, 0], [-rise * cos, -rise * sin, level], [level * cos, level * sin, rise]];
  }
  // To the right, upwards and towards the eye, in lengths of the world.
  function seen(place, directions = axes()) {
    const [x, y, z] = directions.map((axis) => axis[0] * place[0] + axis[1] * place[1] + axis[2] * place[2]);
    const larger = 1 / (1 - space.near * z);
    return [larger * x, larger * y, z];
  }
  // The largest scale at which all can be seen, whatever the film shows.
  function fitted() {
    const directions = axes();
    const room = [size[0] - 2 * free.side, size[1] - free.above - free.below].map((side) => Math.max(side, 20));
    const reach = [0.02, 0.02];
    for (const place of places) {
      const point = seen(place, directions);
      reach.forEach((farthest, k) => { reach[k] = Math.max(farthest, Math.abs(point[k] - middle[k])); });
    }
    return Math.min(...room.map((side, k) => 0.5 * side / reach[k]));
  }
  function fit(wanted) {
    size = wanted.map((side) => Math.max(side, 1));
    const now = view;
    view = first;
    const directions = axes();
    const points = places.map((place) => seen(place, directions));
    middle = [0, 1].map((k) => points.map((point) => point[k])).map((along) => 0.5 * (Math.min(...along) + Math.max(...along)));
    largest = fitted();
    view = now;
    turned();
  }
  // What is turned is never larger than what fits.
  function turned() {
    fitting = Math.min(largest, fitted());
  }
  function zoom(factor, [x, y] = [0.5 * size[0], 0.5 * size[1]]) {
    const wanted = Math.min(Math.max(view.zoom * factor, 0.1), 100);
    const around = [x - 0.5 * size[0], 0.5 * size[1] - y];
    view.shift = view.shift.map((value, k) => around[k] + wanted / view.zoom * (value - around[k]));
    view.zoom = wanted;
  }
  return {
    axes,
    fit,
    zoom,
    size: () => size,
    // Pixels to a length, and where the middle of the world is, in pixels from the middle of the picture.
    scale: () => fitting * view.zoom,
    shift: () => middle.map((value, k) => view.shift[k] - fitting * view.zoom * value + (k ? 0.5 * (free.below - free.above) : 0)),
    isFirst: () => view.zoom === 1 && view.azimuth === azimuth && view.elevation === elevation && !view.shift.some(Boolean),
    reset() {
      view = { ...first, shift: [0, 0] };
      turned();
    },
    turn(about, up) {
      view.azimuth = (view.azimuth + about) % (2 * Math.PI);
      view.elevation = Math.min(Math.max(view.elevation + up, -0.5 * Math.PI), 0.5 * Math.PI);
      turned();
    },
    move(right, down) { view.shift = [view.shift[0] + right, view.shift[1] - down]; },
    // In pixels from the upper left corner.
    point(place) {
      const [x, y] = seen(place);
      const [right, up] = this.shift();
      return [0.5 * size[0] + right + this.scale() * x, 0.5 * size[1] - up - this.scale() * y];
    },
  };
}

// Directions all around: R. Swinbank, R. J. Purser, Fibonacci Grids, Quarterly Journal of the Royal Meteorological Society 132 (2006).
function sphere(count) {
  const turn = Math.PI * (3 - Math.sqrt(5));
  return Array.from({ length: count }, (_, k) => {
    const z = (2 * k + 1) / count - 1;
    const level = Math.sqrt(1 - z * z);
    return [level * Math.cos(turn * k), level * Math.sin(turn * k), z];
  });
}

// Of some places those that are the farthest in one of these directions.
function farthest(places, directions) {
  const found = new Set();
  for (const [x, y, z] of directions) {
    let [most, best] = [-Infinity, null];
    for (const place of places) {
      const height = x * place[0] + y * place[1] + z * place[2];
      if (height > most) [most, best] = [height, place];
    }
    if (best) found.add(best);
  }
  return [...found];
}

// Places that all lies between, at some moments.
function extremes(space) {
  const around = sphere(26);
  const long = 1e3; // a stretch that is long beside all of a mesh
  const meshes = space.meshes.map((mesh) => {
    const corners = cornersOf(mesh).map((corner) => [corner[0], corner[1], corner[2] + long * corner[3], corner]);
    return farthest(corners, around).map(([, , , corner]) => corner);
  });
  const last = film.times.length - 1;
  const count = Math.min(last, 60);
  const moments = Array.from({ length: count + 1 }, (_, k) => (count ? Math.round(k * last / count) : 0));
  const poses = moments.flatMap((moment) => placements(space, moment, 0).map((pose, k) => [space.things[k], pose]));
  const shown = poses.filter(([, { scale }]) => scale > 0);
  const places = shown.flatMap(([thing, pose]) => meshes[thing.mesh].map((corner) => placed(pose, corner)));
  for (const list of space.traces.flatMap(({ past, points }) => [past, points])) {
    for (let k = 0; k < list.length; k += 3) places.push(list.slice(k, k + 3).map((value) => space.unit * value));
  }
  return farthest(places, sphere(150));
}

// Drags, wheels, touches and keys.
function followsHands(canvas, camera, changed) {
  const RADIANS = 0.008; // to a pixel
  const held = new Map();
  const place = (event) => [event.offsetX, event.offsetY];
  const mean = (points) => [0, 1].map((k) => points.reduce((sum, point) => sum + point[k], 0) / points.length);
  const apart = ([a, b]) => Math.hypot(a[0] - b[0], a[1] - b[1]);

  canvas.addEventListener("pointerdown", (event) => {
    canvas.setPointerCapture(event.pointerId);
    held.set(event.pointerId, place(event));
  });
  canvas.addEventListener("pointermove", (event) => {
    if (!held.has(event.pointerId)) return;
    const before = [...held.values()];
    held.set(event.pointerId, place(event));
    const after = [...held.values()];
    const [dx, dy] = [0, 1].map((k) => mean(after)[k] - mean(before)[k]);
    const isShift = after.length > 1 || event.shiftKey || (event.buttons & 6) !== 0;
    if (isShift) camera.move(dx, dy); else if (!canvas.matches(".grabbed")) camera.turn(-RADIANS * dx, RADIANS * dy);
    if (after.length === 2 && apart(before) > 0) camera.zoom(apart(after) / apart(before), mean(after));
    changed();
  });
  for (const end of ["pointerup", "pointercancel"]) canvas.addEventListener(end, (event) => held.delete(event.pointerId));
  canvas.addEventListener("contextmenu", (event) => event.preventDefault());
  canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    const pixels = event.deltaY * [1, 16, 400][event.deltaMode];
    camera.zoom(Math.exp(-0.0015 * pixels), place(event));
    changed();
  }, { passive: false });
  canvas.addEventListener("dblclick", () => { camera.reset(); changed(); });

  const STEP = Math.PI / 36;
  const keys = {
    ArrowLeft: () => camera.turn(STEP, 0), ArrowRight: () => camera.turn(-STEP, 0),
    ArrowUp: () => camera.turn(0, -STEP), ArrowDown: () => camera.turn(0, STEP),
    "+": () => camera.zoom(1.2), "=": () => camera.zoom(1.2), "-": () => camera.zoom(1 / 1.2), 0: () => camera.reset(),
  };
  canvas.addEventListener("keydown", (event) => {
    const action = keys[event.key];
    if (!action || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    event.stopPropagation();
    action();
    changed();
  });
}

