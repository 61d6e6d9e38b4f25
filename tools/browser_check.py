#!/usr/bin/env python3
"""Plays films and live pages in a real browser: `tools/browser_check.py film.html film.svg page.html …`

Starts chromium without a window, opens each file and acts like a user: waits, presses buttons and keys, moves the slider. The
files must contain something that moves. Needs only Python 3 and chromium: commands go through the browser's own pipe
(https://chromedevtools.github.io/devtools-protocol/, option --remote-debugging-pipe). With `--pictures FOLDER` it saves
screenshots there, light and dark, of the start and of the middle.
"""

import argparse
import base64
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time

from browser_hands import check_dragging
from browser_scheme import check_scheme, corner

FLAGS = [
    "--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
    "--disable-component-update", "--disable-sync", "--window-size=900,1000", "--remote-debugging-pipe",
]
# Pages of bodies in space use a software renderer.
WITH_GRAPHICS = [flag for flag in FLAGS if flag != "--disable-gpu"] + [
    "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
]
# Position on the screen and shape of everything visible in the picture.
SEEN = """(() => {
  const picture = document.querySelector("#picture svg") || document.documentElement;
  const drawn = [...picture.querySelectorAll("path, text")].filter((mark) => mark.getClientRects().length);
  const marks = drawn.map((mark) => [mark, getComputedStyle(mark)]);
  return JSON.stringify(marks.filter(([, style]) => style.visibility === "visible").map(([mark, style]) => {
    const box = mark.getBoundingClientRect();
    return [box.x, box.y, box.width, box.height].map(Math.round).join(" ") + style.d + style.strokeDashoffset;
  }));
})()"""
# The same in the picture's own units, for pages with more room.
SHAPES = """(() => {
  const picture = document.querySelector("#picture svg");
  const marks = [...picture.querySelectorAll("path, text")].map((mark) => [mark, getComputedStyle(mark)]);
  return JSON.stringify(marks.filter(([, style]) => style.visibility === "visible").map(([mark, style]) => {
    const { a, b, c, d, e, f } = picture.getScreenCTM().inverse().multiply(mark.getScreenCTM());
    return [a, b, c, d, e, f].map((part) => Math.round(100 * part)).join(" ") + style.d + style.strokeDashoffset;
  }));
})()"""
# Shares of the picture and the plot in the window, and true if the whole page fits.
FILLED = """(() => {
  const areas = [...document.querySelectorAll("#picture, .plot")].map((part) => part.getBoundingClientRect());
  const part = areas.reduce((sum, area) => sum + area.width * area.height, 0) / (innerWidth * innerHeight);
  return document.documentElement.scrollHeight <= innerHeight ? part : 0;
})()"""
WINDOWS = [(1280, 720), (640, 900), (900, 1000)]
CURSOR = "document.querySelector('#cursor').getBoundingClientRect().x"


class Browser:
    """A browser controlled through a pipe."""

    def __init__(self, program, flags=FLAGS):
        self.profile = tempfile.mkdtemp()
        commands_out, self.commands = os.pipe()
        self.answers, answers_in = os.pipe()

        def connect():
            # The browser reads commands from 3 and answers on 4. Both are moved out of the way first.
            reading, writing = os.dup(commands_out), os.dup(answers_in)
            os.dup2(reading, 3)
            os.dup2(writing, 4)

        arguments = [program, *flags, f"--user-data-dir={self.profile}", "about:blank"]
        self.process = subprocess.Popen(
            arguments, preexec_fn=connect, close_fds=False, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
        )
        os.close(commands_out)
        os.close(answers_in)
        self.rest = b""
        self.number = 0
        self.session = None
        target = self.send("Target.createTarget", url="about:blank")["targetId"]
        self.session = self.send("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        self.problems = []
        self.send("Runtime.enable")
        self.send("Page.enable")

    def send(self, method, **parameters):
        self.number += 1
        message = {"id": self.number, "method": method, "params": parameters}
        if self.session:
            message["sessionId"] = self.session
        os.write(self.commands, json.dumps(message).encode() + b"\0")
        while True:
            answer = self.receive()
            if answer.get("method") == "Runtime.exceptionThrown":
                self.problems.append(answer["params"]["exceptionDetails"])
            if answer.get("id") == self.number:
                if "error" in answer:
                    raise RuntimeError(f"{method}: {answer['error']}")
                return answer["result"]

    def receive(self):
        while b"\0" not in self.rest:
            part = os.read(self.answers, 1 << 16)
            if not part:
                raise RuntimeError("the browser went away")
            self.rest += part
        message, self.rest = self.rest.split(b"\0", 1)
        return json.loads(message)

    def evaluate(self, expression):
        result = self.send("Runtime.evaluate", expression=expression, returnByValue=True)
        if "exceptionDetails" in result:
            raise RuntimeError(f"{expression}: {result['exceptionDetails']}")
        return result["result"].get("value")

    def open(self, path, features=(), has_scripts=True):
        media = [{"name": name, "value": value} for name, value in features]
        self.send("Emulation.setEmulatedMedia", features=media)
        self.send("Emulation.setScriptExecutionDisabled", value=not has_scripts)
        self.send("Page.navigate", url=path.resolve().as_uri())
        self.wait(lambda: self.evaluate("document.readyState") == "complete", "the file is open")

    def wait(self, condition, what):
        for _ in range(100):
            if condition():
                return
            time.sleep(0.1)
        raise RuntimeError(f"never: {what}")

    def press(self, key):
        code = {" ": 32, "ArrowLeft": 37, "ArrowRight": 39, "Home": 36, "End": 35}[key]
        for kind in ("rawKeyDown", "keyUp"):
            self.send("Input.dispatchKeyEvent", type=kind, key=key, windowsVirtualKeyCode=code)

    def click(self, selector):
        found = f"document.querySelector({json.dumps(selector)})"
        self.evaluate(f"{found}.scrollIntoView({{ block: 'nearest' }})")
        box = json.loads(self.evaluate(f"JSON.stringify({found}.getBoundingClientRect())"))
        middle = {"x": box["x"] + box["width"] / 2, "y": box["y"] + box["height"] / 2}
        for kind in ("mousePressed", "mouseReleased"):
            self.send("Input.dispatchMouseEvent", type=kind, button="left", clickCount=1, **middle)

    def picture(self, path):
        data = self.send("Page.captureScreenshot", format="png")["data"]
        path.write_bytes(base64.b64decode(data))

    def close(self):
        self.process.terminate()
        self.process.wait()
        shutil.rmtree(self.profile, ignore_errors=True)


class Checks:
    def __init__(self, name):
        self.name = name
        self.failures = 0

    def that(self, is_so, what):
        print(f"{'ok  ' if is_so else 'FAIL'} {self.name}: {what}")
        self.failures += not is_so


def moves(browser, seconds=0.6):
    """True if something in the picture changes within this time."""
    before = browser.evaluate(SEEN)
    time.sleep(seconds)
    return browser.evaluate(SEEN) != before


def check_svg(browser, path, checks, pictures):
    browser.open(path, [("prefers-reduced-motion", "reduce")])
    checks.that(not moves(browser), "is still where less motion is preferred")
    checks.that(browser.evaluate("document.querySelector('.still').getBoundingClientRect().width") > 0, "shows its first picture there")
    browser.open(path)
    seek = "document.documentElement.{}"
    checks.that(moves(browser), "plays by itself")
    browser.evaluate(seek.format("pauseAnimations()"))
    checks.that(not moves(browser), "stands still while paused")
    duration = float(browser.evaluate("parseFloat(document.querySelector('[dur]').getAttribute('dur'))"))
    seen = []
    for part in (0.0, 0.5, 1.0, 1.5):
        browser.evaluate(seek.format(f"setCurrentTime({part * duration})"))
        seen.append(browser.evaluate(SEEN))
        if part < 1.0 and pictures:
            browser.picture(pictures / f"{path.stem}-svg-{part}.png")
    checks.that(seen[0] != seen[1], "the middle differs from the start")
    checks.that(seen[0] == seen[2] and seen[1] == seen[3], "starts again after its duration")


def check_page(browser, path, checks, pictures):
    browser.open(path, [("prefers-reduced-motion", "reduce")])
    has_curves = browser.evaluate("film.chart !== null")
    first, shapes = browser.evaluate(SEEN), browser.evaluate(SHAPES)
    checks.that(not moves(browser), "waits where less motion is preferred")
    checks.that(browser.evaluate("play.textContent") == "Play", "offers to play")
    cursor = browser.evaluate(CURSOR) if has_curves else 0

    for width, height in WINDOWS:
        browser.send("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=False)
        part = browser.evaluate(FILLED)
        checks.that(part > 0.6, f"fills a window of {width} by {height}: {part:.2f}")
        if pictures:
            browser.picture(pictures / f"{path.stem}-{width}x{height}.png")
    browser.send("Emulation.clearDeviceMetricsOverride")
    browser.wait(lambda: browser.evaluate(SEEN) == first, "the page is as large again as it was")

    browser.click("#play")
    checks.that(moves(browser), "plays after a click")
    browser.press(" ")
    checks.that(not moves(browser), "space on the button pauses")
    checks.that(browser.evaluate("play.textContent") == "Play" and browser.evaluate("now") > 0.3, "pauses where it is")
    if has_curves:
        checks.that(browser.evaluate(CURSOR) > cursor, "the cursor went along")

    browser.evaluate("slider.value = duration / 2; slider.dispatchEvent(new Event('input'))")
    middle = browser.evaluate(SEEN)
    checks.that(middle != first, "the slider moves the picture")
    checks.that(abs(browser.evaluate("now - duration / 2")) < 1e-3, "to where it is put")
    if has_curves:
        ends = json.loads(browser.evaluate("JSON.stringify(document.querySelector('.chart .axis').getBoundingClientRect())"))
        there = ends["x"] + ends["width"] / 2
        browser_cursor = browser.evaluate("document.querySelector('#cursor path').getBoundingClientRect().x")
        checks.that(abs(browser_cursor - there) < 4, "and the cursor to the middle of the plot")
        checks.that("NaN" not in browser.evaluate("document.querySelector('.legend').textContent"), "values are numbers")
    if pictures:
        browser.picture(pictures / f"{path.stem}-light.png")

    browser.evaluate("document.activeElement.blur()")
    browser.press("Home")
    checks.that(browser.evaluate(SEEN) == first, "Home shows the first picture again")
    browser.press("ArrowRight")
    checks.that(browser.evaluate("now === elapsed[1]"), "an arrow goes to the next picture")
    browser.press("ArrowLeft")
    checks.that(browser.evaluate("now === 0"), "and back")
    browser.press("End")
    checks.that(browser.evaluate("now === duration"), "End shows the last picture")
    browser.press(" ")
    checks.that(browser.evaluate("isPlaying") and browser.evaluate("now < duration"), "space plays from the start again")

    browser.evaluate("speed.value = '4'; show(0); repeat.checked = false")
    before, then = browser.evaluate("now"), time.monotonic()
    time.sleep(min(0.3, browser.evaluate("duration") / 16))
    went, took = browser.evaluate("now") - before, time.monotonic() - then
    checks.that(2 * took < went < 6 * took, f"four times as fast: {went:.2f} s in {took:.2f} s")
    browser.wait(lambda: not browser.evaluate("isPlaying"), "the film ends")
    checks.that(browser.evaluate("now === duration"), "stops at the end unless it repeats")

    browser.open(path, [("prefers-color-scheme", "dark")])
    checks.that(moves(browser), "plays by itself")
    dark = browser.evaluate("getComputedStyle(document.body).backgroundColor")
    checks.that(sum(int(part) for part in dark[4:-1].split(",")) < 150, "is dark where that is preferred")
    checks.that(sum(corner(browser)) < 150, "and so is the ground of the picture")
    if pictures:
        browser.picture(pictures / f"{path.stem}-dark.png")

    browser.open(path, has_scripts=False)
    checks.that(browser.evaluate(SHAPES) == shapes, "shows the first picture without scripts")
    checks.that(browser.evaluate("document.querySelector('#controls').hidden"), "and no buttons that would do nothing")
    if pictures:
        browser.picture(pictures / f"{path.stem}-no-script.png")


# A hash of the pixels of a live page, in the same task in which they are drawn.
PIXELS = """(() => {
  const shown = document.querySelector("#picture canvas");
  if (!shown) return null;
  draw();
  const copy = Object.assign(document.createElement("canvas"), { width: shown.width, height: shown.height });
  const paper = copy.getContext("2d");
  paper.drawImage(shown, 0, 0);
  const pixels = paper.getImageData(0, 0, copy.width, copy.height).data;
  let [sum, ink] = [0, 0];
  for (let k = 0; k < pixels.length; k += 4) {
    const value = pixels[k + 3] ? pixels[k] + 3 * pixels[k + 1] + 7 * pixels[k + 2] : 2805;
    if (value < 2600) ink += 1;
    sum = (sum * 31 + value) % 2147483647;
  }
  return JSON.stringify({ sum, ink });
})()"""
# Largest distance between initial positions as the page computes them and as they are written for films.
APART = """(() => {
  restart();
  const { space } = model.scene;
  // Arrows are hidden at first.
  const shown = space.things.map((thing, k) => [thing, k]).filter(([, k]) => space.poses[0][k].scale > 0);
  const apart = shown.map(([thing, k]) => {
    const [live, written] = [space.poses[0][k], placement(thing, 0, 0, space.unit)];
    const pairs = [...live.origin.map((value, i) => [value / live.scale, written.origin[i]]), ...live.turn.map((value, i) => [value, written.turn[i]])];
    return Math.max(...[...pairs, [live.stretch / live.scale, written.stretch]].map(([a, b]) => Math.abs(a - b)));
  });
  return Math.max(...apart);
})()"""
# Twenty frames.
FRAMES = "for (let k = 0; k < 20; k++) goOn(1 / 60)"
OVERFLOW = "document.documentElement.scrollWidth - innerWidth"
WIDTHS = [(400, 800), (900, 1000), (1600, 900)]


def processor_time(browser, script):
    """Milliseconds of processor time that the page's thread takes for a script, however busy the machine is."""
    browser.send("Performance.enable", timeDomain="threadTicks")

    def spent():
        metrics = browser.send("Performance.getMetrics")["metrics"]
        return next(metric["value"] for metric in metrics if metric["name"] == "TaskDuration")

    before = spent()
    browser.evaluate(script)
    return 1000 * (spent() - before)


def check_live(browser, path, checks, pictures):
    def shown():
        return json.loads(browser.evaluate(PIXELS) or "null")

    def slide(selector, part):
        """Moves the slider to a fraction of its range by a click."""
        browser.evaluate(f"document.querySelector({json.dumps(selector)}).scrollIntoView({{ block: 'center' }})")
        script = f"JSON.stringify(document.querySelector({json.dumps(selector)}).getBoundingClientRect())"
        box = json.loads(browser.evaluate(script))
        place = {"x": box["x"] + part * box["width"], "y": box["y"] + box["height"] / 2}
        for kind in ("mousePressed", "mouseReleased"):
            browser.send("Input.dispatchMouseEvent", type=kind, button="left", clickCount=1, **place)
        time.sleep(0.5)

    browser.open(path, [("prefers-reduced-motion", "reduce")])
    has_picture = browser.evaluate("model.scene !== null")
    time.sleep(0.3)
    checks.that(browser.evaluate("motion.t") == 0, "waits where less motion is preferred")
    first = shown()
    checks.that(not has_picture or first["ink"] > 300, f"draws the start {first or ''}")
    for width, height in WIDTHS:
        browser.send("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=False)
        time.sleep(0.2)
        checks.that(browser.evaluate(OVERFLOW) <= 0, f"fits a width of {width}")
        if pictures:
            browser.picture(pictures / f"{path.stem}-{width}.png")
    browser.send("Emulation.clearDeviceMetricsOverride")
    if browser.evaluate("Boolean(model.scene?.space)"):
        checks.that(browser.evaluate(APART) < 1e-3, "in space, things are where a film has them at the start")

    clicked = time.monotonic()
    browser.click("#play")
    browser.wait(lambda: browser.evaluate("motion.t > 0"), "a click plays")
    time.sleep(0.6)
    browser.click("#play")
    reached, took = browser.evaluate("motion.t"), time.monotonic() - clicked
    # A busy machine shows few frames, each of which goes on by a tenth of a second at most.
    checks.that(0 < reached < took, f"plays no faster than real time after a click: {reached:.2f} s in {took:.2f} s")
    checks.that(browser.evaluate("play.textContent") == "Play" and browser.evaluate("motion.failure") is None, "pauses")
    then = shown()
    checks.that(not has_picture or then["sum"] != first["sum"], "the picture has changed")
    time.sleep(0.3)
    checks.that(browser.evaluate("motion.t") == reached, "stands still while paused")
    browser.click("#step")
    checks.that(abs(browser.evaluate("motion.t") - reached - 0.02) < 1e-9, "makes a step")
    checks.that("NaN" not in browser.evaluate("document.body.innerText"), "values are numbers")
    frame = min(processor_time(browser, FRAMES) for _ in range(4)) / 20
    checks.that(frame < 1000 / 60, f"a frame takes {frame:.1f} ms of the processor to compute and draw")

    if browser.evaluate("model.quantities.length") > 0:
        before = browser.evaluate("JSON.stringify(fields)")
        slide("#panels fieldset input[type=range]", 0.7)
        checks.that(browser.evaluate("JSON.stringify(fields)") != before, "a slider of a value sets it")
        checks.that(browser.evaluate("JSON.stringify(motion.p.slice(0, model.fields)) === JSON.stringify(fields)"), "and the motion has it")
    if browser.evaluate("document.querySelectorAll('[id^=Start-]').length") > 0:
        slide("[id^=Start-]", 0.2)
        checks.that(browser.evaluate("motion.t") == 0 and not browser.evaluate("isPlaying"), "a slider of a start restarts")
    if has_picture:
        check_dragging(browser, checks)
    browser.evaluate("document.activeElement.blur()")
    browser.press(" ")
    browser.wait(lambda: browser.evaluate("motion.t > 0"), "space plays")
    browser.press("Home")
    checks.that(browser.evaluate("motion.t") == 0, "Home restarts")
    browser.evaluate("const rates = functions.rhs; functions.rhs = (t, y, p, out) => { rates(t, y, p, out); if (t > 0.1) out.fill(NaN); }; for (let k = 0; k < 20; k++) goOn(0.02)")
    said = browser.evaluate("element('message').textContent")
    checks.that("finite" in said and browser.evaluate("motion.y.every(Number.isFinite)"), f"stops at the last good state and says so: {said}")

    if has_picture:
        browser.open(path, [("prefers-reduced-motion", "reduce")])
        check_scheme(browser, checks, "draw()")
    browser.open(path, [("prefers-color-scheme", "dark")])
    browser.wait(lambda: browser.evaluate("motion.t > 0.2"), "the page plays by itself")
    dark = browser.evaluate("getComputedStyle(document.body).backgroundColor")
    checks.that(sum(int(part) for part in dark[4:-1].split(",")) < 150, "is dark where that is preferred")
    if pictures:
        browser.picture(pictures / f"{path.stem}-dark.png")
    browser.open(path, has_scripts=False)
    checks.that(browser.evaluate("document.querySelector('#controls').hidden"), "without scripts, no buttons that would do nothing")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("films", nargs="+", type=pathlib.Path)
    parser.add_argument("--pictures", type=pathlib.Path)
    parser.add_argument("--browser", default=shutil.which("chromium") or shutil.which("google-chrome"))
    options = parser.parse_args()
    if not options.browser:
        sys.exit("no chromium found; on Debian: apt-get install chromium")
    if options.pictures:
        options.pictures.mkdir(parents=True, exist_ok=True)
    kinds = {".svg": check_svg, ".html": check_page}
    failures = 0
    for film in options.films:
        checks = Checks(film.name)
        is_live = film.suffix == ".html" and "startsMotion" in film.read_text()
        browser = Browser(options.browser, WITH_GRAPHICS if is_live else FLAGS)
        try:
            (check_live if is_live else kinds[film.suffix])(browser, film, checks, options.pictures)
            checks.that(not browser.problems, f"no errors of scripts {browser.problems or ''}")
        finally:
            browser.close()
        failures += checks.failures
    sys.exit(failures > 0)


if __name__ == "__main__":
    main()
