#!/usr/bin/env python3
"""Writes the robots of benches/spatial and benches/prepared: `tools/spatial_benches.py` fills benches/spatial/robots/ and
benches/prepared/robots.rs from the declarations in `lagrange-core/tests/spatial/models`, which `tools/spatial_models.py` has written.

Each file of the former contains a declaration at two levels of accuracy, and the same numbers joint by joint for handwritten
algorithms; the latter contains declarations with the numbers of bodies as parameters.
"""

import math
import re
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
MODELS = ROOT / "lagrange-core" / "tests" / "spatial" / "models"
TARGET = ROOT / "benches" / "spatial" / "robots"
PREPARED = ROOT / "benches" / "prepared" / "robots.rs"
ROBOTS = ["ur5", "panda", "universal_5", "universal_10"]
GRAVITY = "gravity = (0, 0, -9.81);"
LINK = re.compile(r"body (\w+) \{(.*)\}")
JOINT = re.compile(r"(revolute|universal) (\w+|\(\w+, \w+\)) = (\w+) to (\w+)(?:;| \{(.*)\})")
LABEL = re.compile(r"(\w+): (\([^)]*\)|[^;]*);")
QUARTERS = {"pi/2": "FRAC_PI_2", "-pi/2": "-FRAC_PI_2"}
AXES = {"(1, 0, 0)": 0, "(0, 1, 0)": 1, "(0, 0, 1)": 2}


def number(text):
    if text in QUARTERS:
        return QUARTERS[text]
    above, _, below = text.partition("/")
    value = float(above) / float(below or 1)
    assert math.isfinite(value)
    return repr(value)


def array(text, size=3):
    """Returns a vector of the language in Rust."""
    entries = [number(entry.strip()) for entry in text.strip("()").split(",")]
    return f"[{', '.join(entries + ['0.0'] * (size - len(entries)))}]"


def labels(text):
    return dict(LABEL.findall(text or ""))


def joints(lines):
    """Returns rows in Rust: each joint with its link, which is massless between the two axes of a universal joint."""
    zero, links, rows, last = "(0, 0, 0)", {}, [], "ground"
    for line in lines:
        if line == GRAVITY:
            continue
        if link := LINK.fullmatch(line):
            links[link[1]] = labels(link[2])
            continue
        kind, _, carrier, carried, text = JOINT.fullmatch(line).groups()
        assert carrier == last, "a robot is one chain"
        last, given, link = carried, labels(text), links[carried]
        place = (given.get("at", zero), given.get("turned", zero))
        massive = (link["mass"], link.get("centroid", zero), link["inertia"])
        if kind == "revolute":
            rows.append(row(*place, AXES[given.get("axis", "(0, 0, 1)")], *massive))
        else:
            rows += [row(*place, 0, "0", zero, zero), row(zero, zero, 1, *massive)]
    return rows


def row(at, turned, axis, mass, centroid, inertia):
    return (
        f"Joint {{ at: {array(at)}, turned: {array(turned)}, axis: {axis}, "
        f"mass: {number(mass)}, centroid: {array(centroid)}, inertia: {array(inertia, 6)} }},"
    )


def declaration(head, lines):
    return "\n".join(["lagrange::system! {", *(f"    {line}" for line in [*head, *lines]), "}"])


def module(name, lines):
    struct, rows = name.title().replace("_", ""), joints(lines)
    quarters = "use std::f64::consts::FRAC_PI_2;\n\n" if any("FRAC_PI_2" in row for row in rows) else ""
    documentation = f"/// `{name}` of `lagrange-core/tests/spatial/models`"
    standard = declaration([f"{documentation}.", f"pub(crate) struct {struct};"], lines)
    fast = [f"{documentation}, with fast sines.", "#[accuracy(fast)]", f"pub(crate) struct Fast{struct};"]
    only = ["emit { no mass_matrix, no momenta, no inverse_dynamics }"]
    table = "\n".join(f"    {row}" for row in rows)
    return f"""//! Written by `tools/spatial_benches.py`.

{quarters}use crate::rigid_bodies::Joint;

{standard}

{declaration(fast, lines + only)}

/// The robot for handwritten algorithms.
#[rustfmt::skip]
pub(crate) const JOINTS: [Joint; {len(rows)}] = [
{table}
];
"""


def with_parameters(lines):
    """Returns the statements with every nonzero number of a body as the default of a parameter; parameters come first."""
    parameters = []

    def parameter(text):
        if float(text) == 0:
            return text
        parameters.append(f"p{len(parameters)} = {text}")
        return parameters[-1].split()[0]

    def label(match):
        entries = [parameter(entry.strip()) for entry in match[2].strip("()").split(",")]
        return f"{match[1]}: ({', '.join(entries)});" if match[2].startswith("(") else f"{match[1]}: {entries[0]};"

    statements = [LABEL.sub(label, line) if line.startswith("body") else line for line in lines]
    return [f"param {', '.join(parameters[k:k + 6])};" for k in range(0, len(parameters), 6)] + statements


def prepared(name, lines):
    head = [
        f"/// `{name}` of `lagrange-core/tests/spatial/models`; its inertias are parameters.",
        f"pub(crate) struct {name.title()};",
    ]
    only = ["emit { prepared, no momenta, no forcing, no kinetic_energy, no potential_energy, no energy }"]
    return declaration(head, with_parameters(lines) + only)


def main():
    TARGET.mkdir(parents=True, exist_ok=True)
    for name in ROBOTS:
        lines = (MODELS / f"{name}.lag").read_text().splitlines()
        (TARGET / f"{name}.rs").write_text(module(name, lines))
    robots = [prepared(name, (MODELS / f"{name}.lag").read_text().splitlines()) for name in ["ur5", "panda"]]
    head = "//! Robots with inertia as parameters. Written by `tools/spatial_benches.py`."
    PREPARED.parent.mkdir(parents=True, exist_ok=True)
    PREPARED.write_text("\n\n".join([head, *robots]) + "\n")
    modules = "\n".join(f"pub(crate) mod {name};" for name in sorted(ROBOTS))
    (TARGET / "mod.rs").write_text(f"//! Robots as declarations and as tables. Written by `tools/spatial_benches.py`.\n\n{modules}\n")


if __name__ == "__main__":
    main()
