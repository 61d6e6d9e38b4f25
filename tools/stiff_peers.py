"""Stiff motions by Radau5, SciPy's Radau and SUNDIALS' CVODES (through CasADi), in alternation, for docs/peers.md.

The first argument is the built benchmark `stiff`, which prints the rows of this crate:

    pip install numpy scipy casadi
    cargo bench -p lagrange-benches --bench stiff --no-run
    python3 tools/stiff_peers.py target/release/deps/stiff-…

Functions of CasADi are compiled by the C compiler. Times are the shortest of five runs; errors are relative to the sizes of `tools/stiff.py`.
"""

import csv
import subprocess
import sys
import time

import casadi
import numpy as np
from scipy.integrate import solve_ivp

import stiff

TURNS = 5
TOLERANCES = ["1e-4", "1e-6", "1e-9"]


def van_der_pol(_, y):
    x, v = y
    return [v, ((1 - x**2) * v - x) / 1e-6]


def van_der_pol_in_casadi(y):
    return casadi.vertcat(*van_der_pol(0, (y[0], y[1])))


def elastic_pendulum_in_casadi(y):
    r, a, v, w = (y[i] for i in range(4))
    return casadi.vertcat(
        v, w, r * w**2 - 1e8 * (r - 1) - 2e4 * v + 9.81 * casadi.cos(a), -(2 * v * w + 9.81 * casadi.sin(a)) / r
    )


def bounce_in_casadi(y):
    d = casadi.fmax(-y[0], 0)
    return casadi.vertcat(y[1], -9.81 + 1e8 * d**1.5 * (1 - 0.3 * y[1]))


def stick_slip_in_casadi(y):
    w, z, v = (y[i] for i in range(3))
    rate = v - 1e5 * casadi.fabs(v) / (1 + 0.5 * casadi.exp(-((v / 1e-3) ** 2))) * z
    return casadi.vertcat(0.1 - v, rate, 2 * w - (1e5 * z + np.sqrt(1e5) * rate + 0.4 * v))


# Name, equations, equations in CasADi, start, end, sizes.
CASES = [
    ("elastic_pendulum", stiff.elastic_pendulum, elastic_pendulum_in_casadi, [1, 1, 0, 0], 4, [1, 1, 1, 1]),
    ("van_der_pol", van_der_pol, van_der_pol_in_casadi, [2, 0], 2, [1, 1]),
    ("bounce", stiff.bounce, bounce_in_casadi, [0.5, 0], 0.6, [1e-3, 1]),
    ("stick_slip", stiff.stick_slip, stick_slip_in_casadi, [0, 0, 0], 20, [1, 1e-5, 1e-2]),
]


def reference(name, end):
    if name == "van_der_pol":
        return [1.706167732170483, -0.8928097010247975]
    rows = csv.reader(stiff.TARGET.read_text().splitlines())
    return [[float(x) for x in row[2:]] for row in rows if row[0] == name and float(row[1]) == end][0]


def by_scipy(case, tolerance):
    name, equations, _, start, end, sizes = case
    began = time.perf_counter()
    motion = solve_ivp(
        equations, (0, end), np.array(start, float), "Radau", rtol=tolerance, atol=tolerance * min(sizes),
        jac=lambda _, y: stiff.jacobian(equations, y),
    )
    seconds = time.perf_counter() - began
    return motion.y[:, -1], seconds, [motion.nfev, motion.njev, motion.nlu // 2]


def by_cvodes(case, tolerance, known={}):
    name, _, equations, start, end, sizes = case
    if (name, tolerance) not in known:
        y = casadi.SX.sym("y", len(start))
        options = {
            "reltol": tolerance, "abstol": tolerance * min(sizes), "max_num_steps": 10_000_000, "jit": True,
            "compiler": "shell", "jit_options": {"flags": ["-O3"]},
        }
        known[name, tolerance] = casadi.integrator("motion", "cvodes", {"x": y, "ode": equations(y)}, 0, end, options)
    motion = known[name, tolerance]
    began = time.perf_counter()
    state = motion(x0=start)["xf"]
    seconds = time.perf_counter() - began
    stats = motion.stats()
    counts = [stats.get(key, -1) for key in ("nfevals", "nlinsetups", "nlinsetups")]
    return np.array(state).ravel(), seconds, counts


def main():
    best = {}

    def keep(solver, name, tolerance, error, seconds, counts):
        key = (name, tolerance, solver)
        if key not in best or seconds < best[key][1]:
            best[key] = (error, seconds, counts)

    for turn in range(TURNS):
        rows = subprocess.run([sys.argv[1], "--bench"], capture_output=True, text=True, check=True).stdout
        for solver, name, tolerance, error, seconds, *counts in csv.reader(rows.splitlines()):
            keep(solver, name, tolerance, float(error), float(seconds), [int(count) for count in counts])
        for case in CASES:
            name, end, sizes = case[0], case[4], case[5]
            expected = np.array(reference(name, end))
            for tolerance in TOLERANCES:
                for solver, run in (("SciPy Radau", by_scipy), ("CVODES", by_cvodes)):
                    if solver == "SciPy Radau" and turn > 1:
                        continue
                    state, seconds, counts = run(case, float(tolerance))
                    error = np.max(np.abs(state - expected) / (np.array(sizes) + np.abs(expected)))
                    keep(solver, name, tolerance, error, seconds, counts)
    print("| motion | tolerance | solver | error | f | J | LU | µs |")
    print("|---|---|---|---|---|---|---|---|")
    for (name, tolerance, solver), (error, seconds, (f, j, lu)) in sorted(best.items()):
        counts = " | ".join("" if count < 0 else str(count) for count in (f, j, lu))
        print(f"| {name} | {tolerance} | {solver} | {error:.1e} | {counts} | {seconds * 1e6:.0f} |")


main()
