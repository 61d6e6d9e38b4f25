// Places names beside what they name, so that none lies on another.
function placesLabels(space) {
  const GAPS = [7, 26];
  const around = [[0.8, -0.8], [1, 0], [-1, 0], [0, 1], [0, -1], [-0.8, -0.8], [0.8, 0.8], [-0.8, 0.8]];
  const places = GAPS.flatMap((gap) => around.map((side) => [side, gap]));
  const labels = [];
  space.things.forEach(({ label }, thing) => { if (label) labels.push({ ...label, thing }); });
  space.traces.forEach(({ label }, trace) => { if (label !== null) labels.push({ number: label, trace }); });
  for (const label of labels) {
    label.span = element(`label-${label.number}`);
    label.side = 0;
  }

  // Where a label belongs, and for arrows the direction in which they point; none if there is nothing to name.
  function target(label, camera, things, traces) {
    if (label.trace !== undefined) return [camera.point(traces[label.trace].tip), null];
    const pose = things[label.thing];
    if (pose.scale <= 0) return [null, null];
    const point = camera.point(placed(pose, label.at));
    if (!label.tip) return [point, null];
    const from = camera.point(pose.origin);
    const way = [point[0] - from[0], point[1] - from[1]];
    const length = Math.hypot(...way);
    return [point, length > 1e-3 ? way.map((value) => value / length) : null];
  }
  function box([x, y], [right, down], gap, [width, height], [wide, high]) {
    const left = x + right * gap + 0.5 * width * (right - 1);
    const top = y + down * gap + 0.5 * height * (down - 1);
    const [low, across] = [Math.min(Math.max(left, 2), wide - width - 2), Math.min(Math.max(top, 2), high - height - 2)];
    return [low, across, low + width, across + height];
  }
  const meet = (a, b) => a[0] < b[2] + 4 && b[0] < a[2] + 4 && a[1] < b[3] && b[1] < a[3];

  function draw(camera, things, traces) {
    const taken = [];
    const window = camera.size();
    for (const label of labels) {
      const [point, way] = target(label, camera, things, traces);
      const isInside = point !== null && point.every((value, k) => value >= 0 && value <= window[k]);
      label.span.hidden = !isInside;
      if (!isInside) continue;
      label.size ??= [label.span.offsetWidth, label.span.offsetHeight];
      // A label stays on its side as long as it can.
      const sides = [way ? [way, GAPS[0]] : places[label.side], ...places];
      const boxes = sides.map(([side, gap]) => box(point, side, gap, label.size, window));
      const free = Math.max(boxes.findIndex((one) => !taken.some((other) => meet(one, other))), 0);
      if (free > 0) label.side = free - 1;
      taken.push(boxes[free]);
      label.span.style.transform = `translate(${boxes[free][0].toFixed(1)}px,${boxes[free][1].toFixed(1)}px)`;
    }
  }
  return { draw };
}
