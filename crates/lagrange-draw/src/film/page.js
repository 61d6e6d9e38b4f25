"use strict";

// The film: `times` in seconds; `curves` and where the `chart` has them; and what the viewer shows.
const film = JSON.parse(document.getElementById("film").textContent);
const element = (id) => document.getElementById(id);
const [play, slider, speed, repeat] = ["play", "slider", "speed", "repeat"].map(element);

const start = film.times[0];
const elapsed = film.times.map((time) => Math.abs(time - start));
const duration = elapsed[elapsed.length - 1];
const direction = film.times[film.times.length - 1] < start ? -1 : 1;
const decimals = duration < 1 ? 4 : duration < 100 ? 2 : 1;

// Shows a picture, or what is a part of the way from it to the next.
const showPicture = viewer();

let now = 0; // seconds since the start of the film
let isPlaying = false;
let lastTick = null; // when the film was last moved on, in milliseconds

// The picture that is shown at a time, and how far it is on the way to the next.
function place(time) {
  let [low, high] = [0, elapsed.length - 1];
  while (low < high) {
    const middle = Math.ceil((low + high) / 2);
    if (elapsed[middle] <= time) low = middle; else high = middle - 1;
  }
  if (low === elapsed.length - 1) return [low, 0];
  return [low, (time - elapsed[low]) / (elapsed[low + 1] - elapsed[low])];
}

// A value between two pictures; where the next has none, that of this one.
function between(track, index, part) {
  const [a, b] = [track[index], track[index + 1]];
  if (a === null || part === 0 || b === null || b === undefined) return a;
  return Array.isArray(a) ? a.map((value, i) => value + part * (b[i] - value)) : a + part * (b - a);
}

function showCurves(index, part) {
  if (!film.chart) return;
  const { left, right, top, bottom, low, high } = film.chart;
  const x = left + (duration > 0 ? now / duration : 0) * (right - left);
  const cursor = element("cursor");
  cursor.setAttribute("transform", `translate(${x} 0)`);
  film.curves.forEach((curve, number) => {
    const value = between(curve.values, index, part);
    const dot = cursor.querySelectorAll("circle")[number];
    dot.setAttribute("visibility", value === null ? "hidden" : "visible");
    if (value !== null) dot.setAttribute("cy", bottom - (value - low) / (high - low) * (bottom - top));
    element(`value-${number}`).textContent = value === null ? "none" : value.toPrecision(5).replace(/-/g, "−");
  });
}

function show(time) {
  now = Math.min(Math.max(time, 0), duration);
  const [index, part] = place(now);
  showPicture(index, part);
  showCurves(index, part);
  const text = `t = ${(start + direction * now).toFixed(decimals)} s`.replace("-", "−");
  slider.value = now;
  slider.setAttribute("aria-valuetext", text);
  element("time").textContent = text;
}

function setPlaying(isToPlay) {
  if (isToPlay && now >= duration) show(0);
  isPlaying = isToPlay && duration > 0;
  lastTick = null;
  play.textContent = isPlaying ? "Pause" : "Play";
  if (isPlaying) requestAnimationFrame(tick);
}

function tick(milliseconds) {
  if (!isPlaying) return;
  if (lastTick !== null) moveOn((milliseconds - lastTick) / 1000 * Number(speed.value));
  lastTick = milliseconds;
  if (isPlaying) requestAnimationFrame(tick);
}

function moveOn(seconds) {
  const time = now + seconds;
  if (time < duration) return show(time);
  if (repeat.checked) return show(time % duration);
  show(duration);
  setPlaying(false);
}

// The picture before or after; of what is between two pictures, the nearest of both.
function step(direction) {
  const [index, part] = place(now);
  const wanted = direction > 0 ? index + 1 : part > 0 ? index : index - 1;
  setPlaying(false);
  show(elapsed[Math.min(Math.max(wanted, 0), elapsed.length - 1)]);
}

const keys = {
  " ": () => setPlaying(!isPlaying),
  ArrowLeft: () => step(-1),
  ArrowRight: () => step(1),
  Home: () => { setPlaying(false); show(0); },
  End: () => { setPlaying(false); show(duration); },
};

document.addEventListener("keydown", (event) => {
  const isOwn = event.target.matches("select") || (event.key === " " && event.target.matches("button, [type=checkbox]"));
  const action = keys[event.key];
  if (!action || isOwn || event.ctrlKey || event.metaKey || event.altKey) return;
  event.preventDefault();
  action();
});
play.addEventListener("click", () => setPlaying(!isPlaying));
slider.addEventListener("input", () => { setPlaying(false); show(Number(slider.value)); });
// A page that is not seen gets no ticks; the film waits meanwhile.
document.addEventListener("visibilitychange", () => { lastTick = null; });

element("controls").hidden = false;
element("keys").hidden = false;
show(0);
setPlaying(!matchMedia("(prefers-reduced-motion: reduce)").matches);
