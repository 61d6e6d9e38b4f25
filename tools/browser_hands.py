"""Mice and fingers on the bodies of live pages, for `browser_check.py`."""

import json
import statistics
import time

# Goes back to the start.
RESET = """
  scrollTo(0, 0);
  model.states.forEach((state, i) => { start[i] = state.value; });
  restart();
  setPlaying(false);
"""
# Places at which bodies that can move are grabbed, and one where nothing is painted; true if something is painted near all of them.
GRASPED = """(() => {
  RESET
  const shown = element("canvas");
  const [canvas, ratio] = [shown.getBoundingClientRect(), shown.width / shown.clientWidth];
  const copy = Object.assign(document.createElement("canvas"), { width: shown.width, height: shown.height });
  const paper = copy.getContext("2d");
  draw();
  paper.drawImage(shown, 0, 0);
  const pixels = new Uint32Array(paper.getImageData(0, 0, copy.width, copy.height).data.buffer);
  const near = [-12, -8, -4, 0, 4, 8, 12];
  const isPainted = (x, y) => near.some((right) => near.some((down) => pixels[Math.round((x + right) * ratio) + copy.width * Math.round((y + down) * ratio)] !== pixels[0]));
  const seen = call("drawing");
  const free = (x, y) => {
    const held = picture.grab(seen, [x, y]);
    return held && reaches(model, functions, held.point).isFree(motion.y, motion.p);
  };
  const hits = [];
  let empty = null;
  for (let x = 20; x < canvas.width - 20; x += 8)
    for (let y = 20; y < canvas.height - 20; y += 8) {
      if (free(x, y)) hits.push([x, y]);
      else if (!isPainted(x, y)) empty = [x, y];
    }
  const some = [0.5, 0.75, 0.25, 0.9].map((part) => hits[Math.floor(part * hits.length)]);
  return JSON.stringify({ hits: hits.length ? some : [], empty, corner: [canvas.x, canvas.y], isPainted: hits.every((hit) => isPainted(...hit)) });
})()""".replace("RESET", RESET)
# How far the grabbed point is from the pointer; in space, in pixels.
FAR = "(() => { const [point, place] = [held.point(call('drawing')), model.scene.space ? [X, Y] : held.target([X, Y])]; return Math.hypot(point[0] - place[0], point[1] - place[1]); })()"
HELD = """Math.max(0, ...(model.constraints ? call("position_residuals") : []).map(Math.abs),
  ...model.quaternions.map((first) => Math.abs(Math.hypot(...motion.y.slice(first, first + 4)) - 1)))"""
SLIDERS = """model.states.every((state, i) => {
  const slider = element(`Start-${state.name}`);
  return !slider || Math.abs(slider.value - start[i]) < 1e-6 * (1 + Math.abs(start[i]));
})"""

# Half of all drags leave less than this part of the way.
NEAR = 0.6


class Hand:
    """A mouse or a finger on the canvas."""

    def __init__(self, browser, corner, is_finger=False):
        self.browser, self.corner, self.is_finger = browser, corner, is_finger

    def send(self, kind, *places):
        points = [{"x": self.corner[0] + x, "y": self.corner[1] + y} for x, y in places]
        if self.is_finger:
            kind = {"Pressed": "touchStart", "Moved": "touchMove", "Released": "touchEnd"}[kind]
            points = [{**point, "id": number} for number, point in enumerate(points)]
            self.browser.send("Input.dispatchTouchEvent", type=kind, touchPoints=[] if kind == "touchEnd" else points)
        else:
            self.browser.send("Input.dispatchMouseEvent", type=f"mouse{kind}", button="left", buttons=1, clickCount=1, **points[0])

    def drag(self, place, by):
        """Returns how far the grabbed point is from the pointer when it moves, first and at the end."""
        x, y = place
        far = lambda dx, dy: self.browser.evaluate(FAR.replace("X", str(x + dx)).replace("Y", str(y + dy)))
        self.browser.evaluate(f"window.held = picture.grab(call('drawing'), [{x}, {y}]); 0")
        before = far(*by)
        self.send("Pressed", place)
        for part in (0.25, 0.5, 0.75, 1.0):
            self.send("Moved", (x + part * by[0], y + part * by[1]))
        after = far(*by)
        self.send("Released", (x + by[0], y + by[1]))
        return before, after


def check_dragging(browser, checks):
    found = json.loads(browser.evaluate(GRASPED))
    checks.that(found["hits"], "a body can be grabbed")
    if not found["hits"]:
        return
    checks.that(found["isPainted"], "where one is painted")
    state = lambda: json.loads(browser.evaluate("JSON.stringify(start)"))
    count, first = browser.evaluate("model.positions"), state()
    for is_finger in (False, True):
        browser.send("Emulation.setTouchEmulationEnabled", enabled=is_finger)
        hand, name = Hand(browser, found["corner"], is_finger), "finger" if is_finger else "mouse"
        # Some bodies cannot move in all directions.
        parts = []
        for place, by in [(place, by) for place in found["hits"] for by in [(12, 6), (-12, 6), (12, -6), (-12, -6)]]:
            browser.evaluate(RESET)
            before, after = hand.drag(place, by)
            parts.append(after / before)
        best, middle = min(parts), statistics.median(parts)
        checks.that(best < 0.1, f"and follows the {name}: up to {best:.1e} of its way")
        checks.that(is_finger or middle < NEAR, f"half of the time up to {middle:.1e}")
        moved = state()
        checks.that(moved[:count] != first[:count] and moved[count:] == first[count:], "which changes places of the start alone")
        held = browser.evaluate(HELD)
        checks.that(held < 1e-9, f"constraints hold to {held:.1e}")
    checks.that(browser.evaluate(SLIDERS), "sliders follow")
    checks.that(browser.evaluate("motion.t") == 0 and browser.evaluate("motion.failure") is None, "the motion begins there")
    check_other_hands(browser, checks, found, state)


def check_other_hands(browser, checks, found, state):
    """Checks that clicks, drags of the ground and two fingers leave the state."""
    mouse, fingers = [Hand(browser, found["corner"], is_finger) for is_finger in (False, True)]
    x, y = found["hits"][0]
    browser.send("Emulation.setTouchEmulationEnabled", enabled=False)
    browser.evaluate(RESET)
    browser.evaluate("goOn(0.02)")
    before = state(), browser.evaluate("motion.t")
    mouse.send("Pressed", (x, y))
    mouse.send("Released", (x, y))
    checks.that((state(), browser.evaluate("motion.t")) == before, "a click changes nothing")
    is_in_space = browser.evaluate("Boolean(model.scene.space)")
    x, y = found["empty"]
    mouse.send("Pressed", (x, y))
    mouse.send("Moved", (x - 15, y - 5))
    mouse.send("Released", (x - 15, y - 5))
    time.sleep(0.3)
    checks.that((state(), browser.evaluate("motion.t")) == before, "dragging the ground leaves the state")
    if not is_in_space:
        return
    checks.that(browser.evaluate("!reset.hidden"), "and turns the view")
    browser.click("#reset")
    browser.send("Emulation.setTouchEmulationEnabled", enabled=True)
    body, ground = found["hits"][0], found["empty"]
    for first, other, where in [(body, (body[0] + 40, body[1]), "on a body"), (ground, body, "if the second lands on a body")]:
        browser.evaluate(RESET)
        fingers.send("Pressed", first)
        fingers.send("Pressed", first, other)
        for apart in (5, 10, 20):
            fingers.send("Moved", first, (other[0] + apart, other[1]))
        fingers.send("Released")
        time.sleep(0.3)
        checks.that(state() == before[0] and browser.evaluate("!reset.hidden"), f"two fingers move the view, even {where}")
        browser.send("Emulation.setTouchEmulationEnabled", enabled=False)
        browser.click("#reset")
        browser.send("Emulation.setTouchEmulationEnabled", enabled=True)
    browser.send("Emulation.setTouchEmulationEnabled", enabled=False)
