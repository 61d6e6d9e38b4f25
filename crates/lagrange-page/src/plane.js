// Draws bodies, lines, connectors, joints and loads of the plane on a canvas. `scene` has the items in order; their numbers stand one after the
// other. Sizes that no item has are pixels. Shapes are those of films.
function showsScene(scene) {
  const canvas = document.getElementById("canvas");
  const paper = canvas.getContext("2d");
  const MARGIN = 34;
  const NAMES = ["ground", "ink", "pale", "hatching", "load"];
  // Of the reader's scheme, when a moment is shown.
  let GROUND, INK, PALE, HATCHING, LOAD;
  const REACH = 12; // pixels from a body in which it is grabbed
  const FONT = "'STIX Two Text', Cambria, 'Times New Roman', serif";
  // The length of the longest arrow as a part of the picture; length and half width of heads, and their largest part of an arrow.
  const [LONGEST, HEAD, HALF, SHARE] = [0.25, 9, 3.2, 0.6];
  // The largest force seen so far, and the arcs of moments about each body.
  let [hasForces, largest, rings] = [false, 0, {}];
  let [numbers, window_, next] = [[], null, 0];
  const take = (count) => numbers.slice(next, (next += count));

  const turned = ([x, y], angle) => [Math.cos(angle) * x - Math.sin(angle) * y, Math.sin(angle) * x + Math.cos(angle) * y];
  const add = (a, b) => [a[0] + b[0], a[1] + b[1]];
  const arc = (radius, from, to, [a, b] = [radius, radius]) =>
    Array.from({ length: 49 }, (_, k) => from + (to - from) * k / 48).map((angle) => [a * Math.cos(angle), b * Math.sin(angle)]);
  const round = (radius) => arc(radius, 0, 2 * Math.PI);
  // Closed lines of each outline, in its own coordinates, and the part of a radius that shows how it is turned; `half` is half the width
  // of what has no thickness.
  const outlines = {
    PointMass: (half) => ({ rings: [round(half)] }),
    SlenderRod: (half, l) => ({ rings: [[...arc(half, -Math.PI / 2, Math.PI / 2).map((p) => add(p, [l / 2, 0])), ...arc(half, Math.PI / 2, 1.5 * Math.PI).map((p) => add(p, [-l / 2, 0]))]] }),
    Disk: (half, r) => ({ rings: [round(r)], radius: [0.4 * r, r] }),
    Annulus: (half, inner, outer) => ({ rings: [round(outer), round(inner)], radius: [inner, outer] }),
    Ring: (half, r) => ({ rings: [round(r + half), round(r - half)], radius: [0.8 * r, r] }),
    Rectangle: (half, a, b) => ({ rings: [[[-a / 2, -b / 2], [a / 2, -b / 2], [a / 2, b / 2], [-a / 2, b / 2]]] }),
    SemicircularDisk: (half, r) => ({ rings: [arc(r, 0, Math.PI)] }),
    CircularSector: (half, r, angle) => ({ rings: [[[0, 0], ...arc(r, -angle / 2, angle / 2)]] }),
    RightTriangle: (half, a, b) => ({ rings: [[[0, 0], [a, 0], [0, b]]] }),
    Triangle: (half, a, b, c) => {
      const x = (a * a + c * c - b * b) / (2 * a);
      return { rings: [[[0, 0], [a, 0], [x, Math.sqrt(c * c - x * x)]]] };
    },
    Ellipse: (half, a, b) => ({ rings: [arc(a, 0, 2 * Math.PI, [a, b])] }),
    RegularPolygon: (half, n, r) => ({ rings: [Array.from({ length: Math.round(n) }, (_, k) => turned([r, 0], 2 * Math.PI * k / n))] }),
    Polygon: (half, ...c) => ({ rings: [Array.from({ length: c.length / 2 }, (_, k) => [c[2 * k], c[2 * k + 1]])] }),
  };

  const width = () => canvas.clientWidth;
  const height = () => canvas.clientHeight;
  const scale = () => Math.min((width() - 2 * MARGIN) / window_.size[0], (height() - 2 * MARGIN) / window_.size[1]);
  const place = ([x, y]) => [window_.middle[0] + (x - width() / 2) / scale(), window_.middle[1] - (y - height() / 2) / scale()];
  const pixel = ([x, y]) => [width() / 2 + scale() * (x - window_.middle[0]), height() / 2 - scale() * (y - window_.middle[1])];

  function line(points, { isClosed = false, fill = null, colour = INK, thickness = 1.5, rule = "nonzero" } = {}) {
    paper.beginPath();
    for (const ring of isClosed ? points : [points]) {
      ring.forEach((point, k) => (k ? paper.lineTo(...point) : paper.moveTo(...point)));
      if (isClosed) paper.closePath();
    }
    if (fill) { paper.fillStyle = fill; paper.fill(rule); }
    paper.strokeStyle = colour;
    paper.lineWidth = thickness;
    paper.stroke();
  }
  function hatch(segments) {
    paper.beginPath();
    for (const [from, to] of segments) { paper.moveTo(...from); paper.lineTo(...to); }
    paper.strokeStyle = HATCHING;
    paper.lineWidth = 1;
    paper.stroke();
  }
  function arrowhead(tip, back) {
    const [x, y] = add(back, tip.map((part) => -part)).map((part) => HALF / HEAD * part);
    line([[tip, add(back, [-y, x]), add(back, [y, -x])]], { isClosed: true, fill: LOAD, colour: LOAD });
  }
  // A curve with hatching on its right.
  function hatched(points) {
    line(points);
    const strokes = [];
    let [along, next] = [0, 0];
    for (let k = 1; k < points.length; k++) {
      const [from, to] = [points[k - 1], points[k]];
      const [way, size] = [[to[0] - from[0], to[1] - from[1]], Math.hypot(to[0] - from[0], to[1] - from[1])];
      for (; next <= along + size && size > 0; next += 9) {
        const at = add(from, way.map((part) => part * (next - along) / size));
        strokes.push([at, add(at, [-way[1] - way[0], way[0] - way[1]].map((part) => 6 * part / size))]);
      }
      along += size;
    }
    hatch(strokes);
  }
  // True if a horizontal line from a place crosses a closed line an odd number of times.
  const isWithin = (ring, [x, y]) => ring.reduce((isIn, [x1, y1], k) => {
    const [x0, y0] = ring[(k || ring.length) - 1];
    return (y0 > y) !== (y1 > y) && x < x0 + (x1 - x0) * (y - y0) / (y1 - y0) ? !isIn : isIn;
  }, false);
  const circle = (at, radius, fill, colour = INK) => line([round(radius).map((p) => add(at, p))], { isClosed: true, fill, colour });

  // Each kind of item: its numbers, taken in order, as a function that draws it and places that must be seen.
  const kinds = {
    body({ colour, label, parts }) {
      const [cx, cy, x, y, angle] = take(5);
      const origin = add([x, y], turned([-cx, -cy], angle));
      const shapes = parts.map(({ variant, count, hole }) => {
        const dimensions = take(count);
        const [px, py, turn] = take(3);
        const own = (point) => add(origin, turned(add([px, py], turned(point, turn)), angle));
        return { own, hole, shape: (half) => outlines[variant](half, ...dimensions) };
      });
      const draw = () => {
        const [solid, holes] = [shapes.filter(({ hole }) => !hole), shapes.filter(({ hole }) => hole)];
        const half = 4 / scale();
        const rings = ({ own, shape }) => shape(half).rings.map((ring) => ring.map((point) => pixel(own(point))));
        for (const part of solid) {
          line([...rings(part), ...holes.flatMap(rings)], { isClosed: true, fill: tinted(colour), rule: "evenodd" });
          const { radius } = part.shape(half);
          if (radius) line(radius.map((r) => pixel(part.own([r, 0]))));
        }
        const center = pixel([x, y]);
        if (!shapes.length) circle(center, 4, tinted(colour));
        // A name stands in its body, or beside one that is too small.
        const size = Math.max(0, ...solid.flatMap(({ own, shape }) => shape(half).rings.flat().map((p) => Math.hypot(...add(pixel(own(p)), center.map((c) => -c))))));
        return { label, at: size < 16 ? add(center, [0, -size - 12]) : center };
      };
      const seen = shapes.flatMap(({ own, shape }) => shape(0).rings.flat().map(own));
      // Pixels between a place and the body; zero within it.
      const distance = (at) => {
        const half = 4 / scale();
        const rings = shapes.filter(({ hole }) => !hole).flatMap(({ own, shape }) => shape(half).rings.map((ring) => ring.map((p) => pixel(own(p)))));
        const to = (p) => Math.hypot(p[0] - at[0], p[1] - at[1]);
        return rings.some((ring) => isWithin(ring, at)) ? 0 : Math.min(to(pixel([x, y])), ...rings.flat().map(to));
      };
      const point = (p) => add(origin, turned(p, angle));
      return { draw, seen: [...seen, [x, y]], distance, point, ofBody: (place) => turned([place[0] - origin[0], place[1] - origin[1]], -angle) };
    },
    line() {
      const [x, y, angle] = take(3);
      const draw = () => {
        const reach = 0.5 * Math.hypot(width(), height()) / scale();
        const at = (along, aside = 0) => pixel(add([x, y], turned([along, -aside / scale()], angle)));
        const foot = turned([window_.middle[0] - x, window_.middle[1] - y], -angle)[0];
        line([at(foot - reach), at(foot + reach)]);
        const gap = 9 / scale();
        const [first, last] = [-1, 1].map((side) => Math.round((foot + side * reach) / gap));
        hatch(Array.from({ length: last - first + 1 }, (_, k) => (first + k) * gap).map((place) => [at(place), at(place - 0.7 * gap, 7)]));
      };
      return { draw, seen: [[x, y]] };
    },
    circle({ inside }) {
      const [x, y, , radius] = take(4);
      const points = round(radius).map((p) => add([x, y], p));
      return { draw: () => hatched((inside ? points : points.toReversed()).map(pixel)), seen: points };
    },
    terrain({ pieces }) {
      const [x, y, angle] = take(3);
      const at = (p) => pixel(add([x, y], turned(p, angle)));
      return { draw: () => pieces.forEach((piece) => hatched(piece.map(at))), seen: [] };
    },
    connector({ variant, label }) {
      const [x0, y0, x1, y1] = take(5);
      const draw = () => {
        const [from, to] = [pixel([x0, y0]), pixel([x1, y1])];
        const length = Math.hypot(to[0] - from[0], to[1] - from[1]);
        const angle = Math.atan2(to[1] - from[1], to[0] - from[0]);
        const at = (along, aside) => add(from, turned([along, aside], angle));
        const middle = at(length / 2, variant.endsWith("Damper") ? 17 : -17);
        if (variant.startsWith("Torsion")) {
          const spiral = Array.from({ length: 60 }, (_, k) => turned([4 + 0.2 * k, 0], k / 4));
          line(spiral.map((p) => add(from, p)), { colour: variant === "TorsionSpring" ? INK : PALE });
        } else if (variant === "Spring") {
          const [turns, ends] = [12, Math.min(12, 0.2 * length)];
          const zigzag = Array.from({ length: turns }, (_, k) => at(ends + (length - 2 * ends) * (k + 0.5) / turns, k % 2 ? 7 : -7));
          line([from, at(ends, 0), ...zigzag, at(length - ends, 0), to]);
        } else {
          const [start, end] = [0.35 * length, 0.65 * length];
          line([at(end, -7), at(start, -7), at(start, 7), at(end, 7)], { colour: PALE });
          line([from, at(start, 0)], { colour: PALE });
          line([to, at(0.5 * length, 0)], { colour: PALE });
          line([at(0.5 * length, -6), at(0.5 * length, 6)], { colour: PALE });
        }
        for (const end of [from, to]) circle(end, 2, INK);
        return { label, at: middle };
      };
      return { draw, seen: [[x0, y0], [x1, y1]] };
    },
    joint({ variant }) {
      const place = take(2);
      const draw = () => {
        const at = pixel(place);
        if (variant === "Anchor") {
          line([[at, add(at, [-9, 15]), add(at, [9, 15])]], { isClosed: true, fill: GROUND });
          hatch([-12, -6, 0, 6, 12].map((k) => [add(at, [k, 15]), add(at, [k - 5, 21])]));
        }
        if (variant === "Slide") line([[[-8, -5], [8, -5], [8, 5], [-8, 5]].map((p) => add(at, p))], { isClosed: true, fill: GROUND });
        circle(at, variant === "Roll" ? 2.5 : 4, variant === "Roll" ? INK : GROUND);
      };
      return { draw, seen: [place] };
    },
    force({ label }) {
      const [x, y, ...force] = take(4);
      const size = Math.hypot(...force);
      if (Number.isFinite(size)) largest = Math.max(largest, size);
      const arrow = () => force.map((part) => LONGEST * Math.min(width() - 2 * MARGIN, height() - 2 * MARGIN) / largest * part);
      const draw = () => {
        const [from, [along, up]] = [pixel([x, y]), arrow()];
        const length = Math.hypot(along, up);
        if (!hasForces || !(length >= 1)) return null;
        const tip = add(from, [along, -up]);
        const head = Math.min(HEAD, SHARE * length);
        const back = add(tip, [-along, up].map((part) => part * head / length));
        line([from, back], { colour: LOAD });
        arrowhead(tip, back);
        // Labels of short arrows would lie on each other.
        return { label: length > 2 * HEAD && label, at: add(tip, [along, -up].map((part) => 14 * part / length)), colour: LOAD };
      };
      const tip = () => (hasForces && size > 0 ? [add([x, y], arrow().map((part) => part / scale()))] : []);
      return { draw, seen: [], tip };
    },
    moment({ label, center }) {
      const place = take(2);
      const [moment] = take(1);
      const about = center === null ? place : numbers.slice(center, center + 2);
      const ring = rings[about] ?? 0;
      rings[about] = ring + 1;
      const draw = () => {
        if (!hasForces || !(Math.abs(moment) > 0)) return null;
        const [radius, sweep, sign] = [20 + 8 * ring, 1.5 * Math.PI, Math.sign(moment)];
        const from = 0.5 * Math.PI - 0.5 * sign * sweep;
        const to = from + sign * sweep;
        const at = ([px, py]) => add(pixel(about), [px, -py]);
        const points = arc(radius, from, to - sign * HEAD / radius).map(at);
        line(points, { colour: LOAD });
        arrowhead(at([radius * Math.cos(to), radius * Math.sin(to)]), points[points.length - 1]);
        return { label, at: add(pixel(about), [0, -radius - 10]), colour: LOAD };
      };
      return { draw, seen: [] };
    },
    cone() {
      take(5);
      return { draw: () => null, seen: [] };
    },
    omitted: () => ({ draw: () => null, seen: [] }),
  };
  function items(values) {
    [numbers, next, rings] = [values, 0, {}];
    return scene.items.map((item) => kinds[item.kind](item));
  }
  const finite = (places) => places.filter((place) => place.every(Number.isFinite));

  function cover(places) {
    const all = [...(window_ ? [0, 1].map((end) => window_.middle.map((m, k) => m + (end - 0.5) * window_.size[k])) : []), ...finite(places)];
    const [low, high] = [Math.min, Math.max].map((f) => [0, 1].map((k) => all.reduce((best, place) => f(best, place[k]), all[0]?.[k] ?? 0)));
    const size = [0, 1].map((k) => high[k] - low[k]);
    const least = 0.1 * Math.max(...size) || 1;
    window_ = { middle: [0, 1].map((k) => (low[k] + high[k]) / 2), size: size.map((s) => Math.max(s, least)) };
  }
  return {
    // The window in which all of these moments can be seen; it grows with what leaves it.
    fit(moments) {
      [window_, largest] = [null, 0];
      cover(moments.flatMap((values) => items(values).flatMap(({ seen }) => seen)));
    },
    draws(forces) { hasForces = forces; },
    // The point of a body at these pixels or near them, as a function of a scene, and where it belongs if the pointer is at others; the last
    // body lies on the others.
    grab(values, at) {
      const bodies = items(values).map((item, index) => ({ ...item, index })).filter(({ distance }) => distance);
      const near = bodies.map((body) => ({ ...body, far: body.distance(at) })).filter(({ far }) => far <= REACH);
      const best = near.reduce((found, body) => (found && found.far < body.far ? found : body), null);
      if (!best) return null;
      const own = best.ofBody(place(at));
      const point = (scene) => {
        const seen = largest;
        const point = items(scene)[best.index].point(own);
        // Forces of scenes that are only tried do not count.
        largest = seen;
        return point;
      };
      return { point, target: place };
    },
    // Shows a moment. Nothing grows below the hand that holds a body.
    show(values, isHeld) {
      [GROUND, INK, PALE, HATCHING, LOAD] = NAMES.map((name) => tinted(scene.colours[name]));
      const drawn = items(values);
      if (!isHeld) {
        cover(drawn.flatMap(({ seen }) => seen));
        cover(drawn.flatMap(({ tip }) => tip?.() ?? []));
      }
      const ratio = devicePixelRatio;
      const [wide, high] = [width(), height()].map((side) => Math.round(side * ratio));
      if (canvas.width !== wide || canvas.height !== high) [canvas.width, canvas.height] = [wide, high];
      paper.setTransform(ratio, 0, 0, ratio, 0, 0);
      paper.clearRect(0, 0, width(), height());
      paper.lineJoin = paper.lineCap = "round";
      const labels = drawn.map(({ draw }) => draw()).filter((mark) => mark?.label);
      paper.textAlign = "left";
      paper.lineWidth = 4;
      paper.strokeStyle = GROUND;
      for (const { label, at, colour = INK } of labels) {
        // A text, or a letter with its subscript.
        const parts = [label].flat().map((text, k) => ({ text, font: `italic ${k ? 11 : 15}px ${FONT}`, down: k ? 8 : 5 }));
        for (const part of parts) {
          paper.font = part.font;
          part.width = paper.measureText(part.text).width;
        }
        let x = at[0] - parts.reduce((sum, { width }) => sum + width, 0) / 2;
        for (const { text, font, down, width } of parts) {
          Object.assign(paper, { font, fillStyle: colour });
          paper.strokeText(text, x, at[1] + down);
          paper.fillText(text, x, at[1] + down);
          x += width;
        }
      }
    },
  };
}
