#!/usr/bin/env python3
"""Regenerates the pictures of docs/gallery by the commands in its README.md.

    tools/gallery.py            writes the pictures into docs/gallery
    tools/gallery.py --check    lists those that differ, and fails if any does
    tools/gallery.py --check --made     does the same for existing pictures in target/gallery, and for live pages

Each command is run as written there, and writes its pictures to target/gallery. Those with `--release` take minutes and show chaotic
motions, which round differently elsewhere, so only the first of these lines runs them. Numbers in text (SVG, HTML) may differ by a
hundredth of a pixel, since elementary functions of platforms differ in their last bit; everything else must be identical.
"""

import re
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
KEPT = ROOT / "docs" / "gallery"
MADE = ROOT / "target" / "gallery"
COMMAND = re.compile(r"`(cargo run [^`]*)`")
PICTURE = re.compile(r"\]\((\w+\.\w+)\)")
LONG = "--release"
QUICK = "-p lagrange-cli"
NUMBER = re.compile(r"-?\d+(?:\.\d+)?")
LEEWAY = 0.011


def main():
    text = (KEPT / "README.md").read_text(encoding="utf-8")
    writes_all = not sys.argv[1:]
    commands = [command for command in dict.fromkeys(COMMAND.findall(text)) if writes_all or LONG not in command]
    for command in [command for command in commands if "--made" not in sys.argv[1:] or QUICK in command]:
        print(command, flush=True)
        subprocess.run(command.split(), cwd=ROOT, check=True, stdout=subprocess.DEVNULL)
    # The pictures of each command precede it.
    *parts, _ = COMMAND.split(text)
    shown = {name: command for before, command in zip(parts[::2], parts[1::2]) for name in PICTURE.findall(before)}
    missing = [name for name in shown if "--check" in sys.argv[1:] and not (KEPT / name).is_file()]
    strangers = {path.name for path in KEPT.iterdir()} - set(shown) - {"README.md"}
    wrong = [f"{name} is not in README.md" for name in sorted(strangers)] + [f"{name} is missing" for name in missing]
    wrong += [problem for name, command in shown.items() if command in commands and (problem := keep(name))]
    for problem in wrong:
        print(problem, file=sys.stderr)
    return 1 if wrong else 0


def keep(name):
    """Copies a picture, or describes how it differs if only checking."""
    made, kept = MADE / name, KEPT / name
    if not made.is_file():
        return f"{name} is written by no command"
    if "--check" not in sys.argv[1:]:
        shutil.copyfile(made, kept)
        return None
    return None if not kept.is_file() or same(made, kept) else f"{name} differs from what its command writes"


def same(made, kept):
    if made.suffix not in (".svg", ".html"):
        return made.read_bytes() == kept.read_bytes()
    made, kept = made.read_text(encoding="utf-8"), kept.read_text(encoding="utf-8")
    if NUMBER.split(made) != NUMBER.split(kept):
        return False
    numbers = zip(NUMBER.findall(made), NUMBER.findall(kept))
    return all(abs(float(a) - float(b)) <= LEEWAY for a, b in numbers)


if __name__ == "__main__":
    sys.exit(main())
