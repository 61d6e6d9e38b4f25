#!/usr/bin/env python3
"""Writes systems.rs: the declarations of this directory as invocations of `lagrange::system!`.

    python3 declare.py [--check]

With --check nothing is written; the exit code is zero if systems.rs is up to date.
"""

import json
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
# Systems whose mass matrix depends on the velocities, so that its method takes them.
MOVING_MASS_MATRIX = {"relativistic_charge"}
HEAD = """\
//! The systems of this directory, compiled. Written by `declare.py`.
"""


def declaration(name):
    lines = (HERE / f"{name}.lag").read_text().splitlines()
    body = "".join(f"    {line}\n" for line in lines if not line.startswith("//"))
    energies = "separate" if "kinetic" in json.loads((HERE / f"{name}.json").read_text())["states"][0] else "joint"
    mass_matrix = "state" if name in MOVING_MASS_MATRIX else "positions"
    return f"\ndeclare! {{ {name}, energies: {energies}, mass_matrix: {mass_matrix};\n{body}}}\n"


def systems():
    names = sorted(path.stem for path in HERE.glob("*.lag"))
    return HEAD + "".join(map(declaration, names))


def main():
    path, text = HERE / "systems.rs", systems()
    if "--check" in sys.argv[1:]:
        sys.exit(0 if path.exists() and path.read_text() == text else f"{path.name} is out of date")
    path.write_text(text)


if __name__ == "__main__":
    main()
