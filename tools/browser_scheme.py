"""Colours of pages for readers who prefer light or dark, for `browser_check.py` and `space_check.py`."""

import base64
import json
import time
import zlib

# What a picture of a canvas has the most of is its ground; pixels whose contrast with it is that of lines.
CONTRAST = """(() => {
  REDRAW;
  const shown = document.querySelector("#picture canvas");
  const copy = Object.assign(document.createElement("canvas"), { width: shown.width, height: shown.height });
  const paper = copy.getContext("2d");
  paper.fillStyle = getComputedStyle(document.body).backgroundColor;
  paper.fillRect(0, 0, copy.width, copy.height);
  paper.drawImage(shown, 0, 0);
  const pixels = paper.getImageData(0, 0, copy.width, copy.height).data;
  const linear = (part) => (part / 255 <= 0.04045 ? part / 255 / 12.92 : ((part / 255 + 0.055) / 1.055) ** 2.4);
  const luminance = ([r, g, b]) => 0.2126 * linear(r) + 0.7152 * linear(g) + 0.0722 * linear(b) + 0.05;
  const counts = new Map();
  for (let k = 0; k < pixels.length; k += 4) {
    const colour = pixels.slice(k, k + 3).join();
    counts.set(colour, (counts.get(colour) ?? 0) + 1);
  }
  const all = [...counts].map(([colour, count]) => ({ colour: colour.split(",").map(Number), count }));
  const ground = luminance(all.reduce((most, one) => (one.count > most.count ? one : most)).colour);
  const contrast = (colour) => Math.max(luminance(colour), ground) / Math.min(luminance(colour), ground);
  const names = [...document.querySelectorAll("#labels span, #space .title, #space .note")].map((name) => getComputedStyle(name).color.match(/\\d+/g).map(Number));
  const lines = all.filter(({ colour }) => contrast(colour) >= 3).reduce((sum, { count }) => sum + count, 0);
  return JSON.stringify({ lines, names: Math.min(21, ...names.map(contrast)) });
})()"""


def corner(browser):
    """Red, green and blue of what the screen shows in the corner of the picture."""
    browser.evaluate("scrollTo(0, 0)")
    box = json.loads(browser.evaluate("JSON.stringify(document.querySelector('#picture').getBoundingClientRect())"))
    clip = {"x": box["x"] + 3, "y": box["y"] + 3, "width": 1, "height": 1, "scale": 1}
    png = base64.b64decode(browser.send("Page.captureScreenshot", format="png", clip=clip)["data"])
    packed, at = b"", 8
    while at < len(png):
        size = int.from_bytes(png[at : at + 4], "big")
        packed += png[at + 8 : at + 8 + size] if png[at + 4 : at + 8] == b"IDAT" else b""
        at += 12 + size
    return tuple(zlib.decompress(packed)[1:4])


def check_scheme(browser, checks, redraw):
    """Changes the scheme while the page is open."""
    lines = {}
    for scheme in ("light", "dark", "light"):
        media = [("prefers-reduced-motion", "reduce"), ("prefers-color-scheme", scheme)]
        browser.send("Emulation.setEmulatedMedia", features=[{"name": name, "value": value} for name, value in media])
        time.sleep(0.3)
        ground = corner(browser)
        checks.that(sum(ground) < 150 if scheme == "dark" else sum(ground) == 765, f"{scheme} ground where that is preferred: {ground}")
        found = json.loads(browser.evaluate(CONTRAST.replace("REDRAW", redraw)))
        checks.that(found["names"] >= 4.5, f"names contrast with it: {found['names']:.1f}")
        lines[scheme] = found["lines"]
    checks.that(lines["dark"] > 0.5 * lines["light"] > 0, f"as many pixels contrast with the ground as on paper: {lines}")
