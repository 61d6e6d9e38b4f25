// The page: `model` has names, units, starts and ranges; `functions` are those of the system.
const STEP = 0.02; // seconds
const KEPT = 3000; // moments in the plots
const SPAN = 10; // seconds in the plots
const AHEAD = 5; // seconds that decide on the first window
const BUDGET = 40; // milliseconds of work for a frame
const REACHING = 20; // milliseconds of work for a move of a body

const motion = startsMotion(model, functions);
const picture = model.scene && showsScene(model.scene);
const columns = [...model.states, ...model.outputs, ...(functions.energy ? [{ name: "energy", label: "energy", unit: model.energyUnit }] : [])];
const start = model.states.map((state) => state.value);
const fields = model.quantities.map((field) => field.value);
let samples = []; // [t, values of all columns]
let [isPlaying, lastTick, firstEnergy, isSlow] = [false, null, NaN, false];
let grip = null; // how a body is dragged
const isShown = columns.map((column, index) => index < Math.min(model.positions, 3));

const written = (value, digits = 4) => (Number.isFinite(value) ? value.toPrecision(digits).replace(/-/g, "−") : "none");
const withUnit = (value, unit, digits) => written(value, digits) + (unit && unit !== "1" ? ` ${unit}` : "");
const call = (name, t = motion.t, y = motion.y) => {
  const out = [];
  functions[name]?.(t, y, motion.p, out);
  return out;
};
const values = () => [...motion.y, ...call("outputs"), ...call("energy")];

function sample() {
  samples.push([motion.t, values()]);
  if (samples.length > KEPT) samples = samples.slice(-KEPT / 2);
}
// Begins at the start; true if its state has values.
function begin() {
  motion.start(start, fields);
  samples = [];
  if (!motion.y.every(Number.isFinite)) return false;
  firstEnergy = motion.energy();
  sample();
  return true;
}
function restart() {
  if (begin()) picture?.fit(ahead());
  draw();
}
// Scenes of the next seconds, so that the window need not grow at once.
function ahead() {
  const other = startsMotion(model, functions, 1e-4);
  const scenes = [call("drawing")];
  other.start(start, fields);
  const deadline = performance.now() + 150;
  for (let k = 1; k <= 50 && other.advance(k * AHEAD / 50, deadline) && performance.now() < deadline; k++) {
    const out = [];
    functions.drawing?.(other.t, other.y, other.p, out);
    scenes.push(out);
  }
  return scenes;
}

function draw() {
  if (motion.y.every(Number.isFinite)) picture?.show(call("drawing"), Boolean(grip));
  element("time").textContent = `t = ${motion.t.toFixed(2)} s`;
  const energy = motion.energy();
  element("energy").textContent = functions.energy ? `energy ${withUnit(energy, model.energyUnit)}, changed by ${withUnit(energy - firstEnergy, model.energyUnit, 2)}` : "";
  const { count, name, t } = motion.events;
  element("events").textContent = count ? `${count} event${count > 1 ? "s" : ""}, last ${name} at ${t.toFixed(3)} s` : "";
  const slow = isSlow ? "The motion is slower than real time here." : "";
  element("message").textContent = motion.failure ?? slow;
  plot();
}

const style = (name) => colours.getPropertyValue(name).trim();
const colours = getComputedStyle(document.documentElement);
const dashes = [[], [7, 3], [2, 3], [9, 3, 2, 3], [12, 4], [9, 3, 2, 3, 2, 3]];

// A plot for each unit of what is shown.
function plot() {
  const shown = columns.map((column, index) => ({ ...column, index })).filter(({ index }) => isShown[index]);
  const units = [...new Set(shown.map(({ unit }) => unit))];
  const charts = element("charts");
  while (charts.children.length > units.length) charts.lastChild.remove();
  while (charts.children.length < units.length) charts.append(document.createElement("canvas"));
  const last = samples.length ? samples[samples.length - 1][0] : 0;
  const from = Math.max(0, last - SPAN);
  const visible = samples.filter(([t]) => t >= from);
  units.forEach((unit, k) => chart(charts.children[k], unit, shown.filter((column) => column.unit === unit), visible, [from, from + SPAN]));
  columns.forEach((_, index) => {
    element(`value-${index}`).textContent = samples.length ? written(samples[samples.length - 1][1][index]) : "";
  });
}
function chart(canvas, unit, shown, visible, [from, to]) {
  const [width, height, ratio] = [canvas.clientWidth, canvas.clientHeight, devicePixelRatio];
  [canvas.width, canvas.height] = [width, height].map((side) => Math.round(side * ratio));
  canvas.setAttribute("role", "img");
  canvas.setAttribute("aria-label", `${shown.map(({ name }) => name).join(", ")} over time`);
  const paper = canvas.getContext("2d");
  paper.scale(ratio, ratio);
  const all = visible.flatMap(([, values]) => shown.map(({ index }) => values[index])).filter(Number.isFinite);
  let [low, high] = [Math.min(...all), Math.max(...all)];
  if (!(high - low > 1e-9 * Math.max(Math.abs(low), Math.abs(high), 1e-6))) [low, high] = [low - 0.5 * (Math.abs(low) || 1), high + 0.5 * (Math.abs(high) || 1)];
  const [left, right, top, bottom] = [58, width - 8, 8, height - 22];
  const x = (t) => left + (t - from) / (to - from) * (right - left);
  const y = (value) => bottom - (value - low) / (high - low) * (bottom - top);
  paper.font = "12px system-ui, sans-serif";
  paper.fillStyle = style("--ink");
  paper.strokeStyle = style("--faint");
  paper.textBaseline = "middle";
  paper.textAlign = "right";
  for (const value of ticks(low, high, 3)) {
    paper.fillText(Number(value.toPrecision(6)).toString().replace("-", "−"), left - 6, y(value));
    paper.strokeRect(left, y(value), right - left, 0);
  }
  paper.textAlign = "center";
  for (const t of ticks(from, to, 5)) paper.fillText(`${Number(t.toPrecision(6))}`, x(t), height - 8);
  paper.textAlign = "left";
  if (unit && unit !== "1") paper.fillText(unit, 2, top + 4);
  for (const { index } of shown) {
    paper.beginPath();
    let isPen = false;
    for (const [t, values] of visible) {
      const value = values[index];
      if (Number.isFinite(value)) isPen ? paper.lineTo(x(t), y(value)) : paper.moveTo(x(t), y(value));
      isPen = Number.isFinite(value);
    }
    paper.strokeStyle = style(`--curve-${index % 6}`);
    paper.lineWidth = 2;
    paper.setLineDash(dashes[index % 6]);
    paper.stroke();
    paper.setLineDash([]);
  }
}
function ticks(low, high, count) {
  const raw = (high - low) / count;
  const power = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 5, 10].map((factor) => factor * power).find((size) => size >= raw);
  const first = Math.ceil(low / step - 1e-9);
  return Array.from({ length: Math.max(0, Math.floor(high / step + 1e-9) - first + 1) }, (_, k) => (first + k) * step);
}

function setForces(isToDraw) {
  picture.draws(isToDraw);
  document.querySelectorAll("#picture .note").forEach((note) => { note.hidden = !isToDraw; });
  draw();
}
function setPlaying(isToPlay) {
  if (isToPlay && motion.failure) restart();
  isPlaying = isToPlay && !motion.failure;
  [lastTick, isSlow] = [null, false];
  element("play").textContent = isPlaying ? "Pause" : "Play";
  if (isPlaying) requestAnimationFrame(frame);
}
function frame(milliseconds) {
  if (!isPlaying) return;
  // A page that was not seen for a while goes on from where it was.
  if (lastTick !== null) goOn(Math.min((milliseconds - lastTick) / 1000, 0.1) * Number(element("speed").value));
  lastTick = milliseconds;
  if (isPlaying) requestAnimationFrame(frame);
}
function goOn(seconds) {
  const goal = motion.t + seconds;
  motion.advance(goal, performance.now() + BUDGET);
  isSlow = !motion.failure && motion.t < goal;
  sample();
  if (motion.failure) setPlaying(false);
  draw();
}
function stepOn() {
  setPlaying(false);
  goOn(STEP);
}

// A slider for each value; `changed` is called with the new one. Returns functions that move the sliders, by index.
function panel(title, rows, changed) {
  const setters = [];
  if (!rows.length) return new Map();
  const set = document.createElement("fieldset");
  set.append(Object.assign(document.createElement("legend"), { textContent: title }));
  for (const row of rows) {
    const line = Object.assign(document.createElement("label"), { className: "row" });
    const name = Object.assign(document.createElement("span"), { innerHTML: row.label });
    const slider = Object.assign(document.createElement("input"), { type: "range", min: row.low, max: row.high, step: "any", id: `${title}-${row.name}` });
    const output = document.createElement("output");
    slider.value = row.value;
    const show = (value) => {
      output.textContent = withUnit(value, row.unit);
      slider.setAttribute("aria-valuetext", output.textContent);
    };
    slider.addEventListener("input", () => { show(Number(slider.value)); changed(row.index, Number(slider.value)); });
    show(row.value);
    setters.push((value) => {
      [slider.min, slider.max] = [Math.min(slider.min, value), Math.max(slider.max, value)];
      slider.value = value;
      show(value);
    });
    line.append(name, slider, output);
    set.append(line);
  }
  element("panels").append(set);
  return new Map(rows.map((row, k) => [row.index, setters[k]]));
}
function setsField(index, value) {
  fields[index] = value;
  if (motion.failure) return restart();
  motion.change(fields);
  draw();
}
function setsStart(index, value) {
  start[index] = value;
  setPlaying(false);
  restart();
}
panel("Inputs", model.quantities.filter((field) => field.isInput), setsField);
panel("Parameters", model.quantities.filter((field) => !field.isInput), setsField);
const starts = panel("Start", model.states.filter((state) => state.low < state.high), setsStart);

// Bodies follow the pointer. Where they are put is a start, with the velocities of the start.
function drags(canvas) {
  let [wasPlaying, hovered] = [false, null];
  const pixels = (event) => [event.offsetX, event.offsetY];
  // How a body at these pixels is moved; null if there is none, or it cannot move.
  function below(at) {
    const found = motion.y.every(Number.isFinite) && picture.grab(call("drawing"), at);
    const reach = found && reaches(model, functions, found.point);
    return reach && reach.isFree(motion.y, motion.p) ? { reach, target: found.target, at } : null;
  }
  function begins(event) {
    // Two fingers, other buttons and the shift key move the view.
    if (grip) return letsGo();
    grip = !event.isPrimary || event.button || event.shiftKey ? null : below(pixels(event));
    if (!grip) return;
    grip.id = event.pointerId;
    wasPlaying = isPlaying;
    setPlaying(false);
    canvas.setPointerCapture(event.pointerId);
    canvas.classList.add("grabbed");
  }
  // Looks below the pointer once for a frame.
  function hovers(at) {
    if (!hovered) requestAnimationFrame(() => {
      const last = hovered;
      hovered = null;
      if (!grip) canvas.style.cursor = below(last) ? "move" : "";
    });
    hovered = at;
  }
  function moves(event) {
    if (!grip && !event.buttons) hovers(pixels(event));
    if (grip?.id !== event.pointerId || pixels(event).every((value, k) => value === grip.at[k])) return;
    grip.at = pixels(event);
    for (let i = 0; i < model.positions - model.firstOrder; i++) start[i] = motion.y[i];
    grip.reach.to(start, fields, grip.target(grip.at), performance.now() + REACHING).forEach((value, i) => { start[i] = value; });
    starts.forEach((moveTo, i) => moveTo(start[i]));
    begin();
    draw();
  }
  function letsGo() {
    grip = null;
    canvas.classList.remove("grabbed");
    draw();
    setPlaying(wasPlaying);
  }
  canvas.addEventListener("pointerdown", begins);
  canvas.addEventListener("pointermove", moves);
  for (const end of ["pointerup", "pointercancel"]) canvas.addEventListener(end, (event) => { if (grip?.id === event.pointerId) letsGo(); });
  // Touching a body must not scroll the page.
  canvas.addEventListener("touchstart", (event) => { if (grip) event.preventDefault(); }, { passive: false });
}
if (picture) drags(element("canvas"));

element("legend").innerHTML = columns.map((column, index) =>
  `<li><label><input type="checkbox" id="show-${index}"${isShown[index] ? " checked" : ""}> <svg viewBox="0 0 35 12" aria-hidden="true"><path class="curve-${index % 6}" d="M0 8H35"/></svg> ${column.label} <output id="value-${index}"></output></label></li>`).join("");
columns.forEach((_, index) => element(`show-${index}`).addEventListener("change", (event) => { isShown[index] = event.target.checked; plot(); }));

const keys = { " ": () => setPlaying(!isPlaying), ArrowRight: stepOn, Home: () => { restart(); setPlaying(false); } };
document.addEventListener("keydown", (event) => {
  const isOwn = event.target.matches("select, [type=range]") || (event.key === " " && event.target.matches("button, [type=checkbox]"));
  if (!keys[event.key] || isOwn || event.ctrlKey || event.metaKey || event.altKey) return;
  event.preventDefault();
  keys[event.key]();
});
element("play").addEventListener("click", () => setPlaying(!isPlaying));
element("step").addEventListener("click", stepOn);
element("restart").addEventListener("click", restart);
document.addEventListener("visibilitychange", () => { lastTick = null; });
scheme().addEventListener("change", draw);
new ResizeObserver(() => draw()).observe(document.querySelector("main"));

element("with-forces").hidden = !model.scene?.hasLoads;
element("forces").addEventListener("change", (event) => setForces(event.target.checked));
document.querySelectorAll("#picture .note").forEach((note) => { note.hidden = true; });
element("controls").hidden = false;
element("keys").hidden = false;
restart();
setPlaying(!matchMedia("(prefers-reduced-motion: reduce)").matches);
