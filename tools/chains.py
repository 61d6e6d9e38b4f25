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


def numbered(letter, n):
    return [f"{letter}{k}" for k in range(1, n + 1)]


def type_name(kind, n):
    return f"{kind.capitalize()}{n}"


def declaration(kind, n):
    """The declaration as text, from the doc comment of the struct to the potential."""
    lines = [
        f"/// {n} point masses on massless rods in {kind} angles.",
        f"pub(crate) struct {type_name(kind, n)};",
        f"param {', '.join(numbered('m', n) + numbered('l', n))}, g;",
        f"coord {', '.join(numbered('q', n))};",
    ]
    for k in range(1, n + 1):
        angle = f"q{k}"
        if kind == "relative":
            angle = f"a{k}"
            lines.append(f"let a{k} = {f'a{k - 1} + ' if k > 1 else ''}q{k};")
        x, y = (f"x{k - 1} + ", f"y{k - 1} ") if k > 1 else ("", "")
        lines.append(f"let (x{k}, y{k}) = ({x}l{k} * sin({angle}), {y}{'- ' if y else '-'}l{k} * cos({angle}));")
    lines += [f"kinetic = 1/2 * m{k} * (dot(x{k})^2 + dot(y{k})^2);" for k in range(1, n + 1)]
    lines += [f"potential = m{k} * g * y{k};" for k in range(1, n + 1)]
    return lines


def module(kind, n, attributes):
    """A Rust module with the emitted type and a constructor from arrays."""
    name, masses, lengths = type_name(kind, n), numbered("m", n), numbered("l", n)
    documentation, *rest = declaration(kind, n)
    indent = lambda lines: "\n".join(f"    {line}" for line in lines)
    return f"""//! Written by `tools/chains.py`.

lagrange::system! {{
{indent([documentation, *attributes, *rest])}
}}

#[rustfmt::skip]
pub(crate) fn chain(m: &[f64; {n}], l: &[f64; {n}], g: f64) -> {name} {{
    let [{', '.join(masses)}] = *m;
    let [{', '.join(lengths)}] = *l;
    {name} {{ {', '.join(masses + lengths)}, g }}
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
