// How things are seen: from a direction, as large as fits at first, then zoomed and shifted.
function turnsAbout(space) {
  const [azimuth, elevation] = space.view;
  const first = { azimuth, elevation, zoom: 1, shift: [0, 0] };
  const free = { side: 28, above: document.querySelector("#space .title") ? 44 : 28, below: 32 };
  const places = extremes(space);
  let view = { ...first };
  let [size, middle, fitting] = [[1, 1], [0, 0], 1];

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
  // The largest scale at which all can be seen from the first direction, whatever the film shows.
  function fit(wanted) {
    size = wanted.map((side) => Math.max(side, 1));
    const now = view;
    view = first;
    const directions = axes();
    const ends = [[Infinity, -Infinity], [Infinity, -Infinity]];
    for (const place of places) {
      const point = seen(place, directions);
      ends.forEach((range, k) => { range[0] = Math.min(range[0], point[k]); range[1] = Math.max(range[1], point[k]); });
    }
    view = now;
    const room = [size[0] - 2 * free.side, size[1] - free.above - free.below].map((side) => Math.max(side, 20));
    fitting = Math.min(...ends.map(([low, high], k) => room[k] / Math.max(high - low, 0.05)));
    middle = ends.map(([low, high]) => 0.5 * (low + high));
    middle[1] += 0.5 * (free.above - free.below) / fitting;
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
    shift: () => middle.map((value, k) => view.shift[k] - fitting * view.zoom * value),
    isFirst: () => view.zoom === 1 && view.azimuth === azimuth && view.elevation === elevation && !view.shift.some(Boolean),
    reset: () => { view = { ...first, shift: [0, 0] }; },
    turn(about, up) {
      view.azimuth = (view.azimuth + about) % (2 * Math.PI);
      view.elevation = Math.min(Math.max(view.elevation + up, -0.5 * Math.PI), 0.5 * Math.PI);
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

// Places of the farthest corners of things at some moments, and points of traces.
function extremes(space) {
  const steps = [-1, 0, 1];
  const directions = steps.flatMap((x) => steps.flatMap((y) => steps.map((z) => [x, y, z])));
  const farthest = (mesh) => {
    const corners = cornersOf(mesh);
    const height = (corner, [x, y, z]) => x * corner[0] + y * corner[1] + z * (corner[2] + 1e3 * corner[3]);
    const ends = directions.map((direction) => corners.reduce((a, b) => (height(b, direction) > height(a, direction) ? b : a)));
    return [...new Set(ends)];
  };
  const meshes = space.meshes.map(farthest);
  const step = Math.max(1, Math.floor(film.times.length / 60));
  const places = [];
  for (let index = 0; index < film.times.length; index += step) {
    const moments = index + step < film.times.length ? [index] : [index, film.times.length - 1];
    for (const [moment, thing] of moments.flatMap((moment) => space.things.map((thing) => [moment, thing]))) {
      const pose = placement(thing, moment, 0, space.unit);
      if (pose.scale > 0) places.push(...meshes[thing.mesh].map((corner) => placed(pose, corner)));
    }
  }
  for (const { past, points } of space.traces) {
    for (const list of [past, points]) for (let k = 0; k < list.length; k += 3) places.push(at(list, 3, k / 3).map((v) => space.unit * v));
  }
  return places;
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
    if (isShift) camera.move(dx, dy); else camera.turn(-RADIANS * dx, RADIANS * dy);
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

