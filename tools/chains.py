#!/usr/bin/env python3
"""Writes the pendulum chains that benches derive and evaluate, and those that tests/large.rs compiles:
`tools/chains.py` fills benches/chains/, benches/fast_chains/ and benches/strict_chains/.

n point masses on massless rods under gravity, as a user would write them down: in absolute angles from the
downward vertical, or in relative angles, each rod against the one before. All masses and lengths are
parameters.
"""

from pathlib import Path

CHAINS = [("absolute", n) for n in (2, 5, 10, 20, 30, 100)] + [("relative", n) for n in (4, 8, 20)]
# Those of tests/large.rs beside them.
LARGE = [("relative", 100), ("absolute", 200), ("relative", 200)]
# Some of the same with `#[accuracy(strict)]`.
STRICT_CHAINS = [chain for chain in CHAINS if chain[1] in (5, 8, 10, 20)]
BENCHES = Path(__file__).resolve().parent.parent / "benches"


def type_name(kind, n):
    return f"{kind.capitalize()}{n}"


def declaration(kind, n):
    """The declaration as text, from the doc comment of the struct to the potential."""
    angle = "q[i]" if kind == "absolute" else "a[i]"
    turned = ["    let a[i] = if i > 0 { a[i-1] + q[i] } else { q[i] };"] if kind == "relative" else []
    place = f"l[i] * (sin({angle}), -cos({angle}))"
    return [
        f"/// {n} point masses on massless rods in {kind} angles.",
        f"pub(crate) struct {type_name(kind, n)};",
        f"const n = {n};",
        "param m[n], l[n], g;",
        "coord q[n];",
        "for i in 0..n {",
        *turned,
        f"    let p[i] = if i > 0 {{ p[i-1] + {place} }} else {{ {place} }};",
        "    kinetic = kinetic_energy(m[i], dot(p[i]));",
        "    potential = gravitational_energy(m[i], g, p[i].y);",
        "}",
    ]


def module(kind, n, attributes):
    """A Rust module with the emitted type and a constructor from arrays."""
    name = type_name(kind, n)
    documentation, *rest = declaration(kind, n)
    indent = lambda lines: "\n".join(f"    {line}" for line in lines)
    return f"""//! Written by `tools/chains.py`.

lagrange::system! {{
{indent([documentation, *attributes, *rest])}
}}

pub(crate) fn chain(m: &[f64; {n}], l: &[f64; {n}], g: f64) -> {name} {{
    {name} {{ m: *m, l: *l, g }}
}}
"""


def index(chains):
    """The module that holds the others."""
    modules = "\n".join(f"pub(crate) mod {kind}_{n};" for kind, n in sorted(chains))
    return f"""//! Pendulum chains as declarations. Written by `tools/chains.py`.
#![allow(dead_code, reason = "each target that includes this module measures some of the chains")]

{modules}
"""


def write(folder, chains, attributes):
    folder.mkdir(exist_ok=True)
    for kind, n in chains:
        (folder / f"{kind}_{n}.rs").write_text(module(kind, n, attributes))
    (folder / "mod.rs").write_text(index(chains))


def main():
    write(BENCHES / "chains", CHAINS, [])
    for kind, n in LARGE:
        (BENCHES / "chains" / f"{kind}_{n}.rs").write_text(module(kind, n, []))
    write(BENCHES / "fast_chains", CHAINS, ["#[accuracy(fast)]"])
    write(BENCHES / "strict_chains", STRICT_CHAINS, ["#[accuracy(strict)]"])


if __name__ == "__main__":
    main()
