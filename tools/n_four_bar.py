#!/usr/bin/env python3
"""Writes tests/mechanisms/n_four_bar.rs: `tools/n_four_bar.py`.

N windows side by side: N + 1 cranks on fixed joints, one metre apart, with ends connected by N couplers. All bars are uniform, 1 m
long and 1 kg. The cranks stay parallel, so one degree of freedom remains; when all bars are aligned, the constraints
are dependent. Definition: González, Dopico, Naya, Cuadrado, *A benchmarking system for MBS simulation software*, Multibody
System Dynamics 16 (2006), after Bayo and Avello, *Singularity-free augmented Lagrangian algorithms for constrained multibody
dynamics*, Nonlinear Dynamics 5 (1994). Coordinates are the angles of all bars; each window is a loop to be closed.
"""

from pathlib import Path

WINDOWS = 40
TARGET = Path(__file__).resolve().parent.parent / "tests" / "mechanisms" / "n_four_bar.rs"


def declaration():
    lines = ["param m = 1.0, l = 1.0, g = 9.81;"]
    for k in range(WINDOWS + 1):
        lines += [
            f"coord crank{k};" if k == 0 else f"coord coupler{k}, crank{k};",
            f"let y{k} = l * sin(crank{k});",
            f"kinetic = 1/6 * m * l^2 * dot(crank{k})^2;",
            f"potential = m * g * y{k} / 2;",
        ]
        if k == 0:
            continue
        lines += [
            f"let (u{k}, w{k}) = (l * cos(crank{k - 1}) + l/2 * cos(coupler{k}), y{k - 1} + l/2 * sin(coupler{k}));",
            f"kinetic = 1/2 * m * (dot(u{k})^2 + dot(w{k})^2) + 1/24 * m * l^2 * dot(coupler{k})^2;",
            f"potential = m * g * w{k};",
            f"constraint closed_x{k} = l * (cos(crank{k - 1}) + cos(coupler{k}) - cos(crank{k}) - 1);",
            f"constraint closed_y{k} = l * (sin(crank{k - 1}) + sin(coupler{k}) - sin(crank{k}));",
        ]
    return "\n".join(f"    {line}" for line in lines)


def module():
    return f"""//! Many four-bar linkages in a row. Written by `tools/n_four_bar.py`.

lagrange::system! {{
    /// {WINDOWS} windows of uniform bars, 1 m and 1 kg each, in the angles of all bars.
    #[derive(Clone, Debug)]
    pub(crate) struct Windows;

{declaration()}
    emit {{ no inverse_dynamics, no forcing }}
}}

/// Returns all cranks at an angle, turning at a rate; the couplers between them are level.
pub(crate) fn state(crank: f64, rate: f64) -> [f64; {2 * (2 * WINDOWS + 1)}] {{
    std::array::from_fn(|i| match (i / {2 * WINDOWS + 1}, i % {2 * WINDOWS + 1} % 2) {{
        (_, 1) => 0.0,
        (0, _) => crank,
        _ => rate,
    }})
}}
"""


if __name__ == "__main__":
    TARGET.write_text(module())
