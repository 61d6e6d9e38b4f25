#!/usr/bin/env python3
"""Rotates films of bodies in space in a real browser: `tools/space_check.py film.html …`

Opens each page without a window, with a software renderer, and acts like a user: plays, drags, zooms, presses
keys, moves the slider. The films must contain something that moves, and a name. Needs only Python 3 and chromium. With
`--pictures FOLDER` it saves screenshots there.
"""

import argparse
import json
import pathlib
import shutil
import sys
import time

from browser_check import FLAGS, WITH_GRAPHICS, Browser, Checks
from browser_scheme import check_scheme

WIDE, NARROW = (1280, 720), (390, 844)
# The picture is read in the same task in which it is drawn.
SEEN = """(() => {
  show(now);
  const gl = canvas.getContext("webgl2");
  const pixels = new Uint8Array(4 * canvas.width * canvas.height);
  gl.readPixels(0, 0, canvas.width, canvas.height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  let [sum, ink] = [0, 0];
  for (let k = 0; k < pixels.length; k += 4) {
    if (pixels[k] + pixels[k + 1] + pixels[k + 2] < 740) {
      ink += 1;
      sum = (sum * 31 + k * (pixels[k] + 3 * pixels[k + 1] + 7 * pixels[k + 2])) % 2147483647;
    }
  }
  return JSON.stringify({ sum, part: ink / (canvas.width * canvas.height), error: gl.getError() });
})()"""
LABELS = """JSON.stringify([...document.querySelectorAll("#labels span:not([hidden])")].map((label) => {
  const [a, b] = [label.getBoundingClientRect(), canvas.getBoundingClientRect()];
  return { text: label.textContent, x: a.x - b.x, y: a.y - b.y, inside: a.x >= b.x && a.right <= b.right && a.y >= b.y && a.bottom <= b.bottom };
}))"""


def seen(browser):
    return json.loads(browser.evaluate(SEEN))


def labels(browser):
    return json.loads(browser.evaluate(LABELS))


def box(browser):
    return json.loads(browser.evaluate("JSON.stringify(canvas.getBoundingClientRect())"))


def settle(browser):
    """Waits for the next picture, which is drawn after the pointer has moved."""
    browser.evaluate("window.isSettled = false; requestAnimationFrame(() => requestAnimationFrame(() => { isSettled = true; }))")
    browser.wait(lambda: browser.evaluate("isSettled"), "a picture is drawn")


def drag(browser, by, button="left"):
    area = box(browser)
    x, y = area["x"] + area["width"] / 2, area["y"] + area["height"] / 2
    mouse = lambda kind, x, y: browser.send(
        "Input.dispatchMouseEvent", type=kind, x=x, y=y, button=button, buttons={"left": 1, "right": 2}[button], clickCount=1
    )
    mouse("mousePressed", x, y)
    for step in range(1, 6):
        mouse("mouseMoved", x + by[0] * step / 5, y + by[1] * step / 5)
    mouse("mouseReleased", x + by[0], y + by[1])
    settle(browser)


def wheel(browser, by):
    area = box(browser)
    middle = {"x": area["x"] + area["width"] / 3, "y": area["y"] + area["height"] / 2}
    browser.send("Input.dispatchMouseEvent", type="mouseWheel", deltaX=0, deltaY=by, **middle)
    time.sleep(0.2)
    settle(browser)


def double_click(browser):
    area = box(browser)
    middle = {"x": area["x"] + area["width"] / 2, "y": area["y"] + area["height"] / 2}
    for count in (1, 2):
        for kind in ("mousePressed", "mouseReleased"):
            browser.send("Input.dispatchMouseEvent", type=kind, button="left", clickCount=count, **middle)
    settle(browser)


def pinch(browser, by):
    area = box(browser)
    x, y = area["x"] + area["width"] / 2, area["y"] + area["height"] / 2
    points = lambda apart: [{"x": x - apart, "y": y, "id": 0}, {"x": x + apart, "y": y, "id": 1}]
    browser.send("Input.dispatchTouchEvent", type="touchStart", touchPoints=points(50))
    for step in range(1, 6):
        browser.send("Input.dispatchTouchEvent", type="touchMove", touchPoints=points(50 + by * step / 5))
    browser.send("Input.dispatchTouchEvent", type="touchEnd", touchPoints=[])
    settle(browser)


def key(browser, name, code):
    for kind in ("rawKeyDown", "keyUp"):
        browser.send("Input.dispatchKeyEvent", type=kind, key=name, windowsVirtualKeyCode=code)
    settle(browser)


def resize(browser, size, ratio=1, is_touched=False):
    browser.send("Emulation.setDeviceMetricsOverride", width=size[0], height=size[1], deviceScaleFactor=ratio, mobile=is_touched)
    browser.send("Emulation.setTouchEmulationEnabled", enabled=is_touched)


def check_hands(browser, checks):
    first, names = seen(browser), labels(browser)
    checks.that(first["error"] == 0, "no errors of graphics")
    checks.that(first["part"] > 0.005, f"{first['part']:.1%} of the picture is not white")
    checks.that(names and all(name["inside"] for name in names), f"{len(names)} names are inside the picture")

    drag(browser, (120, 40))
    turned, followed = seen(browser), labels(browser)
    checks.that(turned["sum"] != first["sum"], "a drag turns the picture")
    moved = [a for a in names for b in followed if a["text"] == b["text"] and abs(a["x"] - b["x"]) + abs(a["y"] - b["y"]) > 2]
    checks.that(len(moved) > 0, f"{len(moved)} names follow")
    checks.that(browser.evaluate("!reset.hidden"), "the first view is offered")
    double_click(browser)
    checks.that(seen(browser)["sum"] == first["sum"], "a double click shows the first view")
    checks.that(browser.evaluate("reset.hidden"), "which is offered no more")

    wheel(browser, -600)
    checks.that(seen(browser)["sum"] != first["sum"], "the wheel zooms")
    browser.click("#reset")
    settle(browser)
    checks.that(seen(browser)["sum"] == first["sum"], "the button shows the first view")
    drag(browser, (60, 30), "right")
    checks.that(seen(browser)["sum"] != first["sum"], "the right button shifts")
    browser.evaluate("canvas.focus()")
    key(browser, "0", 48)
    checks.that(seen(browser)["sum"] == first["sum"], "0 shows the first view")
    before = browser.evaluate("now")
    key(browser, "ArrowLeft", 37)
    checks.that(seen(browser)["sum"] != first["sum"] and browser.evaluate("now") == before, "an arrow turns, and the film stays")
    key(browser, "ArrowRight", 39)
    checks.that(abs(seen(browser)["part"] - first["part"]) < 1e-3, "and back")
    key(browser, "0", 48)


def check_directions(browser, checks):
    """Checks that the picture never reaches its border, from any viewpoint."""
    border = """(() => {
      show(now);
      const gl = canvas.getContext("webgl2");
      const pixels = new Uint8Array(4 * canvas.width * canvas.height);
      gl.readPixels(0, 0, canvas.width, canvas.height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
      let ink = 0;
      for (let k = 0; k < canvas.width * canvas.height; k++) {
        const [x, y] = [k % canvas.width, Math.floor(k / canvas.width)];
        const isBorder = x < 4 || y < 4 || x >= canvas.width - 4 || y >= canvas.height - 4;
        if (isBorder && pixels[4 * k] + pixels[4 * k + 1] + pixels[4 * k + 2] < 740) ink += 1;
      }
      return ink;
    })()"""
    inks = [browser.evaluate(border)]
    for by in [(150, 0), (150, 60), (0, 200), (130, 0), (130, -150), (0, -200), (100, -100)]:
        drag(browser, by)
        inks.append(browser.evaluate(border))
    checks.that(not any(inks), f"nothing is cut off in {len(inks)} views")
    double_click(browser)


def check_film(browser, checks):
    first = seen(browser)
    browser.evaluate("canvas.blur(); setPlaying(true)")
    time.sleep(0.6)
    checks.that(browser.evaluate("now") > 0.2, "plays")
    browser.press(" ")
    checks.that(not browser.evaluate("isPlaying") and seen(browser)["sum"] != first["sum"], "something has moved")
    browser.evaluate("slider.value = duration * 0.6; slider.dispatchEvent(new Event('input'))")
    later = seen(browser)
    checks.that(later["sum"] != first["sum"], "the slider moves the picture")
    browser.evaluate("show(0.5 * (elapsed[0] + elapsed[1]))")
    between = seen(browser)
    browser.evaluate("show(elapsed[1])")
    checks.that(len({first["sum"], between["sum"], seen(browser)["sum"]}) == 3, "there are pictures between two moments")
    browser.press("Home")
    checks.that(seen(browser)["sum"] == first["sum"], "Home shows the first picture again")


def check(browser, path, checks, pictures):
    def leave(name):
        if pictures:
            browser.picture(pictures / f"{path.stem}-{name}.png")

    still = [("prefers-reduced-motion", "reduce")]
    resize(browser, WIDE)
    browser.open(path, still)
    checks.that(not browser.evaluate("isPlaying"), "waits where less motion is preferred")
    settle(browser)
    leave("start")
    check_hands(browser, checks)
    check_directions(browser, checks)
    check_film(browser, checks)
    browser.evaluate("show(duration * 0.7)")
    settle(browser)
    leave("later")
    drag(browser, (200, 120))
    leave("turned")
    wheel(browser, -700)
    leave("zoomed")

    resize(browser, NARROW, 3, is_touched=True)
    browser.open(path, still)
    settle(browser)
    leave("narrow")
    first = seen(browser)
    width = browser.evaluate("document.documentElement.scrollWidth")
    checks.that(width <= NARROW[0], f"nothing is beside a narrow window: {width}")
    checks.that(browser.evaluate("canvas.width === Math.round(canvas.clientWidth * 3)"), "is as sharp as the screen")
    pinch(browser, 60)
    checks.that(seen(browser)["sum"] != first["sum"], "two fingers zoom")
    leave("narrow-zoomed")

    resize(browser, WIDE)
    browser.open(path, still)
    check_scheme(browser, checks, "show(now)")
    browser.open(path, [("prefers-color-scheme", "dark")])
    checks.that(browser.evaluate("isPlaying"), "plays by itself")
    leave("dark")
    browser.open(path, has_scripts=False)
    shown = "document.querySelector('#flat svg').getBoundingClientRect().height > 100 && document.querySelector('#space').hidden"
    checks.that(browser.evaluate(shown), "shows the first picture without scripts")
    leave("no-script")


def check_without_graphics(program, films, failures):
    browser = Browser(program, [*FLAGS, "--disable-webgl", "--disable-3d-apis"])
    try:
        for film in films:
            checks = Checks(film.name)
            browser.open(film)
            checks.that(browser.evaluate("!element('no-space').hidden && element('space').hidden"), "says that it cannot turn without WebGL")
            checks.that(browser.evaluate("element('flat').getBoundingClientRect().height") > 100, "and shows the first picture")
            checks.that(not browser.problems, f"no errors of scripts {browser.problems or ''}")
            failures += checks.failures
    finally:
        browser.close()
    return failures


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
    failures = 0
    browser = Browser(options.browser, WITH_GRAPHICS)
    try:
        for film in options.films:
            checks = Checks(film.name)
            browser.problems = []
            check(browser, film, checks, options.pictures)
            checks.that(not browser.problems, f"no errors of scripts {browser.problems or ''}")
            failures += checks.failures
    finally:
        browser.close()
    sys.exit(check_without_graphics(options.browser, options.films, failures) > 0)


if __name__ == "__main__":
    main()
