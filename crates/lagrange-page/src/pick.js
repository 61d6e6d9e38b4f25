// Finds what is seen at some pixels. Places are in lengths of the viewer, and heights are those towards the eye.
// Places on the line of sight through these pixels are foot + height * way.
function sight(camera, near, [px, py]) {
  const [[right, up, towards], [wide, high], shift] = [camera.axes(), camera.size(), camera.shift()];
  const [x, y] = [px - 0.5 * wide - shift[0], 0.5 * high - shift[1] - py].map((part) => part / camera.scale());
  const foot = right.map((value, k) => x * value + y * up[k]);
  return { foot, way: towards.map((value, k) => value - near * foot[k]) };
}

// The nearest of some things on a line, each with its pose and mesh, and the height where it is met; null if there is none. Things keep
// their placed corners for further lines. Faces are seen from outside only, as they are painted: T. Möller, B. Trumbore, Fast, Minimum
// Storage Ray/Triangle Intersection, J. Graphics Tools 2 (1997).
function nearest(things, { foot, way }) {
  const minus = (a, b) => a.map((value, k) => value - b[k]);
  const dot = (a, b) => a.reduce((sum, value, k) => sum + value * b[k], 0);
  const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  // The height at which the line passes through a triangle.
  function met([a, b, c]) {
    const [first, second, from] = [minus(b, a), minus(c, a), minus(foot, a)];
    const across = cross(second, way);
    const size = dot(first, across);
    const [u, v] = [dot(from, across) / size, dot(cross(first, from), way) / size];
    return size > 0 && u >= 0 && v >= 0 && u + v <= 1 ? -dot(cross(first, second), from) / size : -Infinity;
  }
  let best = null;
  for (const thing of things) {
    const { pose, mesh: { points, triangles }, corners, radius } = thing;
    const away = Math.hypot(...cross(minus(pose.origin, foot), way)) / Math.hypot(...way);
    if (away > pose.scale * radius + pose.stretch) continue;
    const places = thing.places ??= corners.map((corner) => placed(pose, corner));
    for (let k = 0; k < triangles.length; k += 3) {
      const height = met(triangles.slice(k, k + 3).map((point) => places[points[4 * point]]));
      if (height > (best?.height ?? -Infinity)) best = { thing, height };
    }
  }
  return best;
}
