#!/usr/bin/env python3
"""The double pendulum of docs/coming_from/sympy.md by SymPy with SciPy, and by lagrange, for the table there.

    pip install sympy scipy
    tools/sympy_peers.py

Both programs are taken from the page. SymPy solves for accelerations symbolically, and `lambdify` makes Python of them with common
subexpressions, on plain floats, which was its fastest form. Motions last 10 s from θ = (2, 1.5) at rest. Each method runs at the
loosest tolerance of two per decade that reaches the error; references have 30 digits. Times are the shortest of several runs.
"""

import csv
import re
import subprocess
import time
from pathlib import Path

from scipy.integrate import solve_ivp
from sympy import lambdify

ROOT = Path(__file__).resolve().parent.parent
PAGE = (ROOT / "docs" / "coming_from" / "sympy.md").read_text(encoding="utf-8")
CRATE = ROOT / "target" / "sympy_peers"
START = [2.0, 1.5, 0.0, 0.0]
END = 10.0
ERRORS = [1e-3, 1e-6, 1e-9]
TOLERANCES = [10 ** (-k / 2) for k in range(4, 28)]

MAIN = """
use std::time::Instant;
use lagrange::integrate::{Verner98, integrate};

const START: [f64; 4] = [2.0, 1.5, 0.0, 0.0];

fn shortest(mut run: impl FnMut()) -> f64 {
    (0..2000).map(|_| { let start = Instant::now(); run(); start.elapsed().as_secs_f64() }).fold(f64::MAX, f64::min)
}

fn main() {
    let pendulum = DoublePendulum::default();
    let evaluations = shortest(|| {
        let mut v = [0.0; 2];
        // Each depends on the one before.
        (0..1000).for_each(|_| v = pendulum.acceleration(0.0, &[2.0 + 1e-9 * v[0], 1.5 + 1e-9 * v[1]], &v.map(|v| 1e-9 * v)));
        std::hint::black_box(v);
    });
    println!("{}", evaluations / 1000.0);
    for tolerance in TOLERANCES {
        let run = || integrate(&pendulum, 0.0, START, 10.0, &Verner98::tolerance(tolerance), |_, _| {}).expect("a motion");
        println!("{} {:?}", shortest(|| { std::hint::black_box(run()); }), run());
    }
}
"""


def block(language):
    return re.search(rf"```{language}\n(.*?)```", PAGE, re.DOTALL)[1]


def shortest(run, times):
    found = []
    for _ in range(times):
        start = time.perf_counter()
        run()
        found.append(time.perf_counter() - start)
    return min(found)


def reference():
    with open(ROOT / "tests" / "references" / "states.csv", newline="", encoding="utf-8") as file:
        rows = [row for row in csv.reader(file) if row[:2] == ["double_pendulum", "binary"] and float(row[2]) == END]
    return [float(value) for *_, value in rows]


def error(state, expected):
    return max(abs(a - b) for a, b in zip(state, expected))


def by_sympy(expected):
    names = {}

    def prepare():
        exec(block("python"), names)  # the program of the page
        method, (p, q), t = names["method"], (names["p"], names["q"]), names["t"]
        solved = method.mass_matrix.LUsolve(method.forcing).subs({names["m"]: 1, names["l"]: 1, names["g"]: 9.81})
        names["acceleration"] = lambdify([p, q, p.diff(t), q.diff(t)], list(solved), modules="math", cse=True)

    # The first call fills SymPy's caches.
    preparation = shortest(prepare, 3)
    acceleration = names["acceleration"]
    evaluation = shortest(lambda: [acceleration(*START) for _ in range(1000)], 50) / 1000

    def rates(_, y):
        return [y[2], y[3], *acceleration(*y.tolist())]

    def run(tolerance):
        return solve_ivp(rates, (0, END), START, method="DOP853", rtol=tolerance, atol=tolerance).y[:, -1]

    motions = []
    for wanted in ERRORS:
        reaching = next((tolerance for tolerance in TOLERANCES if error(run(tolerance), expected) <= wanted), None)
        motions.append(reaching and shortest(lambda: run(reaching), 5))
    return preparation, evaluation, motions


def by_lagrange(expected):
    declaration = block("rust").split("fn main", 1)[0]
    (CRATE / "src").mkdir(parents=True, exist_ok=True)
    manifest = f'[package]\nname = "peers"\nedition = "2024"\n\n[workspace]\n\n[dependencies]\nlagrange = {{ path = "{ROOT}" }}\n'
    (CRATE / "Cargo.toml").write_text(manifest, encoding="utf-8")
    build = ["cargo", "build", "--quiet", "--release"]
    body = MAIN.replace("TOLERANCES", str(TOLERANCES))
    (CRATE / "src" / "main.rs").write_text("fn main() {}\n", encoding="utf-8")
    subprocess.run(build, cwd=CRATE, check=True)
    start = time.perf_counter()
    (CRATE / "src" / "main.rs").write_text(declaration + body, encoding="utf-8")
    subprocess.run(build, cwd=CRATE, check=True)
    preparation = time.perf_counter() - start
    evaluation, *runs = subprocess.run([CRATE / "target/release/peers"], capture_output=True, text=True, check=True).stdout.splitlines()
    runs = [line.split(" ", 1) for line in runs]
    runs = [(float(seconds), error(eval(state), expected)) for seconds, state in runs]
    return preparation, float(evaluation), [next((s for s, off in runs if off <= wanted), None) for wanted in ERRORS]


def main():
    expected = reference()
    results = [by_sympy(expected), by_lagrange(expected)]
    lines = [len(block("python").strip().splitlines()), len(block("rust").split("fn main")[0].strip().splitlines())]
    print("| | SymPy, SciPy's DOP853 | here, `Verner98` |\n|---|---|---|")
    row = lambda title, cells: print(f"| {title} | {' | '.join(cells)} |")
    row("lines of the model", [str(number) for number in lines])
    row("from its text to a function, s", [f"{result[0]:.1f}" for result in results])
    row("accelerations once, µs", [f"{1e6 * result[1]:.3g}" for result in results])
    for index, wanted in enumerate(ERRORS):
        times = [result[2][index] for result in results]
        row(f"10 s to an error of {wanted:.0e}, ms", ["–" if seconds is None else f"{1e3 * seconds:.3g}" for seconds in times])


if __name__ == "__main__":
    main()
