// The motion of a system from a start: the time, the state, and p with parameters, inputs and sides of switches. Steps are those of
// J. R. Dormand, P. J. Prince, A family of embedded Runge-Kutta formulae, J. Comput. Appl. Math. 6 (1980), with control of their errors.
const NODES = [0, 1 / 5, 3 / 10, 4 / 5, 8 / 9, 1, 1];
const ROWS = [
  [],
  [1 / 5],
  [3 / 40, 9 / 40],
  [44 / 45, -56 / 15, 32 / 9],
  [19372 / 6561, -25360 / 2187, 64448 / 6561, -212 / 729],
  [9017 / 3168, -355 / 33, 46732 / 5247, 49 / 176, -5103 / 18656],
  [35 / 384, 0, 500 / 1113, 125 / 192, -2187 / 6784, 11 / 84],
];
const ERRORS = [71 / 57600, 0, -71 / 16695, 71 / 1920, -17253 / 339200, 22 / 525, -1 / 40];
// Moments within a step at which signs of events are looked at, too.
const WITHIN = [0.2, 0.4, 0.6, 0.8, 1];

// Brings quaternions of a state, by their first entries, to length one.
function normalised(y, quaternions) {
  for (const first of quaternions) {
    const size = Math.hypot(...y.slice(first, first + 4));
    for (let k = first; k < first + 4; k++) y[k] /= size;
  }
  return y;
}

function startsMotion(model, functions, tolerance = 1e-10) {
  const { positions, velocities, firstOrder, quaternions } = model;
  const at = (name, t, y, p = motion.p) => {
    const out = [];
    functions[name](t, y, p, out);
    return out;
  };
  const has = (name) => name in functions;
  const motion = { t: 0, y: [], p: [], failure: null, events: { count: 0 }, energy: () => (has("energy") ? at("energy", motion.t, motion.y)[0] : NaN) };
  let [length, rates, signs, origin, recent, crossed] = [0, null, [], [], [], []];

  const areFinite = (values) => values.every(Number.isFinite);
  const rhs = (t, y) => at("rhs", t, y);
  const fails = (message) => {
    motion.failure ??= `${message} at t = ${motion.t.toPrecision(6)} s.`;
    return false;
  };
  // Functions of events, then those of switches.
  const surfaces = (t, y) => [...(has("events") ? at("events", t, y) : []), ...(has("switches") ? at("switches", t, y) : [])];

  function step(h) {
    const { t, y } = motion;
    const k = [rates ?? rhs(t, y)];
    let [after, size] = [y, 0];
    for (let stage = 1; stage < 7; stage++) {
      after = y.map((value, i) => value + h * ROWS[stage].reduce((sum, a, j) => sum + a * k[j][i], 0));
      k.push(rhs(t + NODES[stage] * h, after));
    }
    for (let i = 0; i < y.length; i++) {
      const error = h * ERRORS.reduce((sum, e, j) => sum + e * k[j][i], 0);
      size += (error / (tolerance * (1 + Math.max(Math.abs(y[i]), Math.abs(after[i]))))) ** 2;
    }
    const isFinite = areFinite(after) && areFinite(k[6]);
    return { h, y: after, rates: k[6], first: k[0], error: isFinite ? Math.sqrt(size / Math.max(y.length, 1)) : Infinity };
  }

  // The state within a step: cubic, which serves to look for signs only.
  function within({ h, y, rates: last, first }, part) {
    const rest = 1 - part;
    return motion.y.map((from, i) => {
      const cubic = (1 - 2 * part) * (y[i] - from) + (part - 1) * h * first[i] + part * h * last[i];
      return rest * from + part * y[i] + part * (part - 1) * cubic;
    });
  }

  // Signs on the way from this moment on; where a function is zero, that of its change along the rates, as far as it is seen.
  function signsAt(values) {
    const isThere = (value, i) => value === 0 || recent.includes(i);
    if (!values.some(isThere)) return values.map(Math.sign);
    const slope = rhs(motion.t, motion.y);
    const noise = 1e-14 * (1 + Math.max(...motion.y.map(Math.abs)));
    const changes = values.map(() => 0);
    for (let h = 1e-7; h < 1; h *= 100) {
      const next = surfaces(motion.t + h, motion.y.map((value, i) => value + h * slope[i]));
      values.forEach((value, i) => { if (Math.abs(changes[i]) < noise) changes[i] = next[i] - value; });
    }
    return values.map((value, i) => (isThere(value, i) ? Math.sign(changes[i]) || 1 : Math.sign(value)));
  }
  function choosesSides() {
    const first = model.fields;
    if (!has("switches")) return;
    at("switches", motion.t, motion.y).forEach((value, i) => { motion.p[first + i] = Math.sign(value) || 1; });
    signsAt(surfaces(motion.t, motion.y)).slice(model.events.length).forEach((sign, i) => { motion.p[first + i] = sign; });
  }
  function begins(values = []) {
    const before = signs;
    rates = null;
    origin = surfaces(motion.t, motion.y);
    // What an event has not changed is not passed, even if it is beyond by rounding.
    signs = signsAt(origin).map((sign, i) => (origin[i] === values[i] && !recent.includes(i) ? before[i] : sign));
    // A switch is left on the side on which it is computed.
    model.switches.forEach((_, i) => { signs[model.events.length + i] = motion.p[model.fields + i]; });
  }
  // True if a function passes zero in a direction that counts. One that was just beyond, by rounding, must go on beyond.
  const crosses = (i, value) => {
    const direction = model.events[i]?.direction ?? 0;
    const [rises, falls] = [signs[i] < 0 && value >= 0 && value > origin[i], signs[i] > 0 && value <= 0 && value < origin[i]];
    return (direction >= 0 && rises) || (direction <= 0 && falls);
  };
  // The first part of a step after which surfaces are crossed, with the part before.
  function crossing(taken) {
    if (!signs.length) return null;
    let before = 0;
    for (const part of WITHIN) {
      const values = surfaces(motion.t + part * taken.h, part === 1 ? taken.y : within(taken, part));
      if (values.some((value, i) => crosses(i, value))) return [before, part];
      before = part;
    }
    return null;
  }
  // Shortens a step to where it has just crossed; steps of their own, so that nothing is interpolated.
  function located(taken, [low, high]) {
    let [from, to] = [low * taken.h, high * taken.h];
    let last = null;
    for (let k = 0; k < 60 && to - from > 4 * Number.EPSILON * Math.max(Math.abs(motion.t), to); k++) {
      const middle = 0.5 * (from + to);
      const trial = step(middle);
      if (surfaces(motion.t + middle, trial.y).some((value, i) => crosses(i, value))) [to, last] = [middle, trial]; else from = middle;
    }
    return last ?? step(to);
  }

  // N δ in the positions: a small displacement of the velocities' kind.
  function displaced(y, change) {
    const q = y.slice(0, positions);
    const moved = at("position_rates", motion.t, [...q, ...change]);
    const atRest = at("position_rates", motion.t, [...q, ...change.map(() => 0)]);
    return y.map((value, i) => (i < positions - firstOrder ? value + moved[i] - atRest[i] : value));
  }
  // Newton's steps, least by mass, back to the constraints of positions, then of velocities. Stabilised ones hold by themselves once they
  // are met.
  function held(t, y, isToMeet = false) {
    normalised(y, quaternions);
    if (!model.constraints || (model.isStabilised && !isToMeet)) return y;
    const corrected = (residuals, state) => at("correction", t, state, [...motion.p, ...residuals]);
    for (let [k, before] = [0, Infinity]; k < 20; k++) {
      const residuals = at("position_residuals", t, y);
      const size = Math.max(...residuals.map(Math.abs));
      // What no longer shrinks is rounding.
      if (!(size > 0 && size < 0.5 * before)) break;
      y = normalised(displaced(y, corrected(residuals, y)), quaternions);
      before = size;
    }
    const change = corrected(at(model.constraintVelocity, t, y), y);
    return y.map((value, i) => (i < positions ? value : value + change[i - positions]));
  }
  const isHeld = (t, y) => areFinite(y) && (!model.constraints || Math.max(...at("position_residuals", t, y).map(Math.abs)) < 1e-8);

  function accepts(taken, t) {
    const y = held(t, taken.y);
    if (!areFinite(y)) return fails("The constraints could not be met");
    [motion.t, motion.y, rates] = [t, y, y === taken.y ? taken.rates : null];
    return true;
  }
  function reacts() {
    const values = surfaces(motion.t, motion.y);
    const hit = values.map((_, i) => i).filter((i) => crosses(i, values[i]));
    for (const i of hit) {
      const { t, count } = crossed[i] ?? { t: -Infinity, count: 0 };
      crossed[i] = { t: motion.t, count: motion.t - t < 1e-8 * (1 + Math.abs(motion.t)) ? count + 1 : 0 };
      if (crossed[i].count > 4) return fails("Events follow each other without end, or the motion slides along a switch,");
      if (i >= model.events.length) {
        motion.p[model.fields + i - model.events.length] *= -1;
        continue;
      }
      const { name, action } = model.events[i];
      motion.events = { count: motion.events.count + 1, name, t: motion.t };
      if (action === "stop") fails(`The event ${name} ends the motion`);
      if (action === "replace") motion.y = held(motion.t, at(`after_event_${i}`, motion.t, motion.y));
    }
    recent = hit;
    if (!areFinite(motion.y)) return fails("The state after an event is not a number");
    // What was not assigned may have passed a switch with what was.
    if (has("switches") && hit.some((i) => model.events[i]?.action === "replace")) choosesSides();
    begins(values);
    recent = [];
    return true;
  }
  function ticks() {
    const next = periods().map((period) => Math.round(motion.t / period) * period);
    next.forEach((time, i) => {
      if (Math.abs(time - motion.t) <= 1e-12 * (1 + Math.abs(motion.t))) motion.y = at(`after_clock_${i}`, motion.t, motion.y);
    });
    choosesSides();
    begins();
  }
  const periods = () => (has("clock_periods") ? at("clock_periods", 0, []) : []);
  const nextTick = () => Math.min(...periods().map((period) => (Math.floor(motion.t / period + 1e-9) + 1) * period), Infinity);

  // Starts from a state, which is brought onto the constraints; false if that fails.
  motion.start = (y, p) => {
    Object.assign(motion, { t: 0, y: [...y], p: [...p, ...model.switches.map(() => 1)], failure: null, events: { count: 0 } });
    [length, recent, crossed] = [1e-3, [], []];
    motion.change(motion.p);
    if (!motion.failure && model.clocks) ticks();
    return !motion.failure && areFinite(rhs(0, motion.y)) || fails("The accelerations are not finite numbers at the start,");
  };
  // Continues with other parameters and inputs.
  motion.change = (p) => {
    motion.p = [...p.slice(0, model.fields), ...motion.p.slice(model.fields)];
    const y = held(motion.t, [...motion.y], true);
    if (!isHeld(motion.t, y)) return fails("The state cannot be brought onto the constraints");
    motion.y = y;
    choosesSides();
    begins();
    return true;
  };
  // Moves on until a time, or as far as it gets before a deadline in milliseconds; false if the motion has ended.
  motion.advance = (end, deadline = Infinity) => {
    while (motion.t < end && !motion.failure && performance.now() < deadline) {
      // Shorter steps are lost in the rounding of the time.
      if (length < 1e-15 * Math.max(1, Math.abs(motion.t))) return fails("The accelerations are no longer finite numbers, or change too fast,");
      const tick = nextTick();
      const goal = Math.min(end, tick);
      const wanted = Math.min(length, goal - motion.t);
      const taken = step(wanted);
      if (!(taken.error <= 1)) {
        length = wanted * (taken.error < Infinity ? Math.max(0.2, 0.9 * taken.error ** -0.2) : 0.1);
        continue;
      }
      const place = crossing(taken);
      const used = place ? located(taken, place) : taken;
      const isAtGoal = !place && wanted === goal - motion.t;
      if (!accepts(used, isAtGoal ? goal : motion.t + used.h)) return false;
      // A step that only the goal has made short says nothing of the next.
      if (wanted === length) length *= Math.min(5, 0.9 * Math.max(taken.error, 1e-10) ** -0.2);
      if (place) {
        if (!reacts()) return false;
      } else if (signs.length) {
        origin = surfaces(motion.t, motion.y);
        if (origin.some(Number.isNaN)) return fails("The function of an event or a switch is not a number");
        // Zeros in the other direction do not count, and are passed without notice.
        model.events.forEach(({ direction }, i) => { if (direction && Math.sign(origin[i]) === -direction) signs[i] = -direction; });
      }
      if (goal === tick && motion.t === goal) ticks();
    }
    return !motion.failure;
  };
  return motion;
}
