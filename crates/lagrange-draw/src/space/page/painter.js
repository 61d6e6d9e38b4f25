// Paints faces with shades, edges, and lines that are some pixels wide, by WebGL 2; none without it.
function paintsThings(canvas, space) {
  const gl = canvas.getContext("webgl2", { antialias: true });
  if (!gl) return null;
  const REACH = 1.05; // Beyond this nothing is painted.
  const common = `#version 300 es
    precision highp float;
    uniform mat3 axes, turn;
    uniform vec3 origin;
    uniform vec2 scale, shift;
    uniform float near, stretch, size;
    vec3 placed(vec4 corner) { return origin + turn * (size * corner.xyz + vec3(0.0, 0.0, corner.w * stretch)); }
    vec4 seen(vec3 place) {
      vec3 v = place * axes;
      float w = 1.0 - near * v.z;
      return vec4(v.xy * scale + shift * w, near * ${REACH} - v.z / ${REACH}, w);
    }`;
  const faceVertex = `${common}
    layout(location = 0) in vec4 corner;
    layout(location = 1) in vec3 normal;
    out vec3 across;
    void main() { gl_Position = seen(placed(corner)); across = (turn * normal) * axes; }`;
  const faceFragment = `#version 300 es
    precision highp float;
    uniform vec3 colour, shadow, light;
    uniform float shade;
    in vec3 across;
    out vec4 pixel;
    void main() {
      float brightness = shade + (1.0 - shade) * max(dot(normalize(across), light), 0.0);
      pixel = vec4(mix(shadow, colour, brightness), 1.0);
    }`;
  // A line is a rectangle across the view, a little longer than itself. One between two faces that go on smoothly is painted if it is
  // the outline: if one of them is seen and the other is not.
  const lineVertex = `${common}
    layout(location = 0) in vec4 a;
    layout(location = 1) in vec4 b;
    layout(location = 2) in vec3 left;
    layout(location = 3) in vec3 right;
    uniform vec2 pixels;
    uniform float width;
    void main() {
      vec3 start = placed(a), end = placed(b);
      vec3 eye = axes[2] - near * start;
      bool isHidden = dot(left, left) > 0.0 && dot(turn * left, eye) * dot(turn * right, eye) > 0.0;
      vec4 from = seen(start), to = seen(end);
      vec2 way = (to.xy / to.w - from.xy / from.w) * pixels;
      vec2 along = length(way) > 1e-6 ? normalize(way) : vec2(1.0, 0.0);
      bool isEnd = gl_VertexID > 1;
      vec2 across = vec2(-along.y, along.x) * ((gl_VertexID & 1) == 0 ? 1.0 : -1.0);
      vec4 place = isEnd ? to : from;
      place.xy += (across + along * (isEnd ? 0.5 : -0.5)) * width / pixels * place.w;
      place.z -= 0.0006 * place.w;
      gl_Position = isHidden ? vec4(2.0, 2.0, 2.0, 1.0) : place;
    }`;
  const lineFragment = `#version 300 es
    precision highp float;
    uniform vec3 colour;
    out vec4 pixel;
    void main() { pixel = vec4(colour, 1.0); }`;
  const TRACE = { origin: [0, 0, 0], turn: [1, 0, 0, 0, 1, 0, 0, 0, 1], stretch: 0, scale: 1 };
  const [EDGE, BYTES] = [14, 4]; // numbers of an edge, bytes of a number
  let faces, lines, meshes, traces, tip;

  function program(vertex, fragment) {
    const program = gl.createProgram();
    for (const [kind, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
      const shader = gl.createShader(kind);
      gl.shaderSource(shader, text);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS) && !gl.isContextLost()) throw new Error(gl.getProgramInfoLog(program));
    const places = {};
    for (let k = 0; k < gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS); k++) {
      const { name } = gl.getActiveUniform(program, k);
      places[name] = gl.getUniformLocation(program, name);
    }
    return { program, places };
  }
  // Numbers on the graphics processor. Each attribute: how many of them it has, where they begin; a line has a `step` to the next.
  function buffer(numbers, attributes, step, isInstanced) {
    const array = gl.createVertexArray();
    gl.bindVertexArray(array);
    const store = gl.createBuffer();
    gl.bindBuffer(gl.ARRAY_BUFFER, store);
    gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(numbers), gl.STATIC_DRAW);
    attributes.forEach(([count, start], location) => {
      gl.enableVertexAttribArray(location);
      gl.vertexAttribPointer(location, count, gl.FLOAT, false, BYTES * step, BYTES * start);
      if (isInstanced) gl.vertexAttribDivisor(location, 1);
    });
    return { array, store, count: numbers.length / step };
  }
  function built(mesh) {
    const corners = cornersOf(mesh);
    const unit = (list, k) => {
      const normal = at(list, 3, k);
      return normal.map((value) => value / Math.hypot(...normal));
    };
    const groups = (list, width) => Array.from({ length: list.length / width }, (_, k) => list.slice(width * k, width * (k + 1)));
    const points = groups(mesh.points, 4).flatMap(([corner, ...normal]) => [...corners[corner], ...normal]);
    const face = buffer(points, [[4, 0], [3, 4]], 7, false);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, new Uint32Array(mesh.triangles), gl.STATIC_DRAW);
    face.count = mesh.triangles.length;
    const edge = ([a, b], normals = [0, 0, 0, 0, 0, 0]) => [...corners[a], ...corners[b], ...normals];
    const smooth = ([a, b, left, right]) => edge([a, b], [...unit(mesh.flat, left), ...unit(mesh.flat, right)]);
    const segments = (numbers) => buffer(numbers, [[4, 0], [4, 4], [3, 8], [3, 11]], EDGE, true);
    const edges = [...groups(mesh.sharp, 2).flatMap((ends) => edge(ends)), ...groups(mesh.smooth, 4).flatMap(smooth)];
    return { face, edges: segments(edges), lines: segments(groups(mesh.lines, 2).flatMap((ends) => edge(ends))) };
  }
  function path({ past, points }) {
    const all = [...past, ...points];
    const places = Array.from({ length: all.length / 3 }, (_, k) => [...at(all, 3, k).map((v) => space.unit * v), 0]);
    // The end of each piece is the start of the next.
    return { ...buffer(places.flat(), [[4, 0], [4, 4]], 4, true), places };
  }
  function build() {
    faces = program(faceVertex, faceFragment);
    lines = program(lineVertex, lineFragment);
    meshes = space.meshes.map(built);
    traces = space.traces.map(path);
    tip = buffer([0, 0, 0, 0, 0, 0, 0, 0], [[4, 0], [4, 4]], 8, true);
  }
  const rgb = (pair) => [1, 3, 5].map((digit) => parseInt(tinted(pair).slice(digit, digit + 2), 16) / 255);
  function use({ program, places }, camera) {
    const [size, scale, shift, axes] = [camera.size(), camera.scale(), camera.shift(), camera.axes()];
    gl.useProgram(program);
    gl.uniformMatrix3fv(places.axes, false, axes.flat());
    gl.uniform2fv(places.scale, size.map((side) => 2 * scale / side));
    gl.uniform2fv(places.shift, size.map((side, k) => 2 * shift[k] / side));
    gl.uniform1f(places.near, space.near);
    gl.uniform2f(places.pixels ?? null, ...size);
    gl.uniform3fv(places.light ?? null, space.light);
    gl.uniform3fv(places.shadow ?? null, rgb(space.shadow));
    gl.uniform1f(places.shade ?? null, space.shade);
  }
  function put({ places }, { origin, turn, stretch, scale }, colour) {
    gl.uniform3fv(places.origin, origin);
    gl.uniformMatrix3fv(places.turn, false, turn);
    gl.uniform1f(places.stretch, stretch);
    gl.uniform1f(places.size, scale);
    gl.uniform3fv(places.colour, rgb(colour));
  }
  function rule({ array, count }, width) {
    if (count < 1) return;
    gl.uniform1f(lines.places.width, width);
    gl.bindVertexArray(array);
    gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, count);
  }
  function paintThings(camera, things, isAbove) {
    const shown = space.things.map((thing, k) => [thing, things[k]]).filter(([thing, { scale }]) => thing.above === isAbove && scale > 0);
    use(faces, camera);
    // Of surfaces that are touched from inside, the near side is not painted.
    gl.enable(gl.CULL_FACE);
    for (const [thing, pose] of shown) {
      const { face } = meshes[thing.mesh];
      put(faces, pose, thing.colour);
      gl.bindVertexArray(face.array);
      gl.drawElements(gl.TRIANGLES, face.count, gl.UNSIGNED_INT, 0);
    }
    gl.disable(gl.CULL_FACE);
    use(lines, camera);
    for (const [thing, pose] of shown) {
      put(lines, pose, thing.edge);
      rule(meshes[thing.mesh].edges, space.edge);
      put(lines, pose, thing.line);
      rule(meshes[thing.mesh].lines, thing.width);
    }
  }
  function paintTraces(states) {
    space.traces.forEach((trace, k) => {
      const { passed, tip: end } = states[k];
      put(lines, TRACE, trace.colour);
      rule({ ...traces[k], count: passed - 1 }, trace.width);
      gl.bindBuffer(gl.ARRAY_BUFFER, tip.store);
      gl.bufferSubData(gl.ARRAY_BUFFER, 0, new Float32Array([...traces[k].places[passed - 1], ...end, 0]));
      rule(tip, trace.width);
    });
  }
  function draw(camera, things, states) {
    const [width, height] = camera.size().map((side) => Math.round(side * devicePixelRatio));
    if (canvas.width !== width || canvas.height !== height) [canvas.width, canvas.height] = [width, height];
    gl.viewport(0, 0, width, height);
    gl.clearColor(...rgb(space.ground), 1);
    gl.enable(gl.DEPTH_TEST);
    gl.depthFunc(gl.LEQUAL);
    gl.enable(gl.POLYGON_OFFSET_FILL);
    gl.polygonOffset(1, 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    paintThings(camera, things, false);
    paintTraces(states);
    // Arrows are not hidden by the bodies that they begin in.
    gl.clear(gl.DEPTH_BUFFER_BIT);
    paintThings(camera, things, true);
  }
  build();
  return { build, draw };
}

// Corners of a mesh, each with its share of a stretch.
function cornersOf({ unit, corners }) {
  return Array.from({ length: corners.length / 4 }, (_, k) => {
    const [x, y, z, share] = at(corners, 4, k);
    return [unit * x, unit * y, unit * z, share / 1e4];
  });
}

