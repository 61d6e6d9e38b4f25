#!/usr/bin/env python3
"""Prints what `cargo bench --bench evaluation` measured last: emitted code against the best by hand."""

import json
import os
from pathlib import Path

TARGET = Path(os.environ.get("CARGO_TARGET_DIR") or Path(__file__).resolve().parent.parent / "target")
SYSTEMS = ["double pendulum"]
SYSTEMS += ["absolute 2", "absolute 5", "absolute 10", "absolute 20", "relative 4", "relative 8"]


def medians(system):
    """Median nanoseconds by the name of the implementation."""
    found = {}
    for file in (TARGET / "criterion" / system).glob("*/new/estimates.json"):
        found[file.parent.parent.name] = json.loads(file.read_text())["median"]["point_estimate"]
    return found


def main():
    print(f"{'':<16} {'emitted':>9} {'by hand':>9}  ratio")
    for system in SYSTEMS:
        by_hand = medians(system)
        emitted = by_hand.pop("emitted")
        best = min(by_hand, key=by_hand.get)
        ratio = emitted / by_hand[best]
        print(f"{system:<16} {emitted:6.0f} ns {by_hand[best]:6.0f} ns {ratio:6.2f}  ({best})")


if __name__ == "__main__":
    main()
