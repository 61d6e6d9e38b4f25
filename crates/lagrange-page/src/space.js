// Shows meshes of films where a motion has them. Of a thing, `scene.things` says which numbers place it; all lengths are divided by the
// radius of the ball that holds what has been seen, and the ball grows with what leaves it.
function showsScene(scene) {
  const { space, things, middle: about } = scene;
  // The viewer of films knows them as one.
  Object.assign(film, { space });
  let [ball, show] = [null, null];
  // Forces and moments have a scale of their own each, so that the largest seen so far has the longest arrow.
  const largest = { force: 0, moment: 0 };
  let hasForces = false;
  // Bodies are grabbed some pixels beside them, too. A point that can stay on its plane parallel to the screen does so, since its height
  // counts; it counts less than its pixels.
  const AROUND = Array.from({ length: 8 }, (_, k) => [6 * Math.cos(k * Math.PI / 4), 6 * Math.sin(k * Math.PI / 4)]);
  const DEPTH = 0.05;
  const subtract = (a, b) => a.map((value, k) => value - b[k]);
  const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  const unit = (a) => { const size = Math.hypot(...a); return size > 0 ? a.map((value) => value / size) : null; };
  // Columns of a rotation whose third is a direction: T. Duff et al., Building an Orthonormal Basis, Revisited, JCGT 6 (2017).
  function along([x, y, z]) {
    const sign = z < 0 || Object.is(z, -0) ? -1 : 1;
    const [a, b] = [-1 / (sign + z), -x * y / (sign + z)];
    return [1 + sign * x * x * a, sign * b, -sign * x, b, sign + y * y * a, -y, x, y, z];
  }
  // The same with the first column near one before, so that nothing spins.
  function near(before, third) {
    const first = before && unit(subtract(before.slice(0, 3), third.map((value) => value * before.slice(0, 3).reduce((sum, b, k) => sum + b * third[k], 0))));
    return first ? [...first, ...cross(third, first), ...third] : along(third);
  }
  const last = things.map(() => null);
  function spanned(k, from, to) {
    const way = subtract(to, from);
    const third = unit(way);
    if (third) last[k] = near(last[k], third);
    return { origin: from, turn: last[k] ?? [1, 0, 0, 0, 1, 0, 0, 0, 1], stretch: Math.hypot(...way) };
  }
  const columns = (rows) => [0, 1, 2].flatMap((column) => [0, 1, 2].map((row) => rows[3 * row + column]));
  function body(numbers) {
    const [centroid, center, rotation] = [numbers.slice(0, 3), numbers.slice(3, 6), numbers.slice(6, 15)];
    const origin = center.map((value, row) => value - centroid.reduce((sum, c, k) => sum + rotation[3 * row + k] * c, 0));
    return { origin, turn: columns(rotation), stretch: 0 };
  }
  const poses = {
    body: (numbers) => body(numbers),
    frame: (numbers) => ({ origin: numbers.slice(9, 12), turn: columns(numbers), stretch: 0 }),
    surface: (numbers, k, { place }) => {
      const rows = numbers.slice(3, 12);
      const origin = numbers.slice(0, 3).map((value, row) => value + place.reduce((sum, p, column) => sum + rows[3 * row + column] * p, 0));
      return { origin, turn: columns(rows), stretch: 0 };
    },
    connector: (numbers, k, { lane }) => {
      const pose = spanned(k, numbers.slice(0, 3), numbers.slice(3, 6));
      return { ...pose, origin: pose.origin.map((value, row) => value + lane * pose.turn[row]) };
    },
    joint: (numbers) => ({ origin: numbers.slice(0, 3), turn: along(unit(numbers.slice(3, 6)) ?? [0, 0, 1]), stretch: 0 }),
    rod: (numbers, k, { outer }, all) => {
      const from = numbers.slice(0, 3);
      return spanned(k, from, outer ? poses[outer.kind](all.slice(outer.at)).origin : from);
    },
  };
  poses.load = (numbers, k, { isMoment }) => {
    const [from, vector, kind] = [numbers.slice(0, 3), numbers.slice(3, 6), isMoment ? "moment" : "force"];
    const size = Math.hypot(...vector);
    if (Number.isFinite(size)) largest[kind] = Math.max(largest[kind], size);
    const pose = spanned(k, from, from.map((value, i) => value + scene.longest / largest[kind] * vector[i]));
    const part = pose.stretch / scene.shortest;
    return { ...pose, part: hasForces && part >= 0.05 ? Math.min(part, 1) : 0 };
  };
  const posesOf = (values) => things.map((thing, k) => poses[thing.kind](values.slice(thing.at), k, thing, values));
  // In the page's own lengths, which are those of the first radius over that of the ball.
  const inBall = ({ origin, turn, stretch, part = 1 }) => ({
    origin: subtract(origin, ball.middle).map((value) => value / ball.radius), turn, stretch: stretch / ball.radius, scale: part * scene.radius / ball.radius,
  });
  const corners = space.meshes.map(cornersOf);
  const radii = space.things.map(({ mesh }) => Math.max(0, ...corners[mesh].map((corner) => Math.hypot(...corner.slice(0, 3)))));
  // Bodies, and surfaces that hide them.
  const seen = () => space.poses[0].flatMap((pose, k) => {
    const [thing, { mesh }] = [things[k], space.things[k]];
    const isBody = ["body", "frame"].includes(thing.kind);
    return isBody || thing.kind === "surface" ? [{ ...thing, isBody, pose, mesh: space.meshes[mesh], corners: corners[mesh], radius: radii[k] }] : [];
  });
  function grow(all) {
    for (const pose of all) {
      pose.forEach(({ origin, turn, stretch, part }, k) => {
        if (part === 0) return;
        const ends = [origin, origin.map((value, row) => value + stretch * turn[6 + row])];
        for (const end of ends.filter((place) => place.every(Number.isFinite))) {
          ball.radius = Math.max(ball.radius, Math.hypot(...subtract(end, ball.middle)) + radii[k] * scene.radius);
        }
      });
    }
  }
  return {
    fit(moments) {
      ball = { middle: about, radius: 1e-9 };
      Object.assign(largest, { force: 0, moment: 0 });
      moments.forEach(posesOf);
      last.fill(null);
      const all = moments.map(posesOf);
      last.fill(null);
      grow(all);
      if (show) return;
      // What is seen at first decides how large everything is.
      space.poses = all.map((poses) => poses.map(inBall));
      film.times = space.poses.map((_, k) => k);
      show = viewer();
    },
    draws(forces) { hasForces = forces; },
    // The point of a body that is seen at these pixels or beside them: of a scene, its pixels and its height, and the same where the pointer is.
    grab(values, pixels) {
      if (!show.camera) return null;
      const all = seen();
      const met = (offset) => nearest(all, sight(show.camera, space.near, pixels.map((value, k) => value + offset[k])));
      const { thing, height } = AROUND.reduce((found, offset) => found ?? met(offset), met([0, 0])) ?? {};
      if (!thing?.isBody) return null;
      const { foot, way } = sight(show.camera, space.near, pixels);
      const place = foot.map((value, k) => ball.middle[k] + ball.radius * (value + height * way[k]));
      const pose = (scene) => poses[thing.kind](scene.slice(thing.at));
      const { origin, turn } = pose(values);
      const own = [0, 3, 6].map((column) => subtract(place, origin).reduce((sum, value, row) => sum + turn[column + row] * value, 0));
      const depth = (height) => DEPTH * show.camera.scale() * height;
      const point = (scene) => {
        const inBall = subtract(placed({ ...pose(scene), scale: 1 }, [...own, 0]), ball.middle).map((value) => value / ball.radius);
        return [...show.camera.point(inBall), depth(show.camera.axes()[2].reduce((sum, value, k) => sum + value * inBall[k], 0))];
      };
      return { point, target: (pixels) => [...pixels, depth(height)] };
    },
    // Shows a moment. Nothing grows below the hand that holds a body.
    show(values, isHeld) {
      const pose = posesOf(values);
      if (!isHeld) grow([pose]);
      space.poses = [pose.map(inBall)];
      show(0, 0);
    },
  };
}
