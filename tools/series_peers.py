"""Taylor series of this crate and of heyoka in alternation, for docs/peers.md.

The first argument is the built benchmark `series`, which prints the rows of this crate:

    pip install heyoka
    cargo bench -p lagrange-benches --bench series --no-run
    python3 tools/series_peers.py target/release/deps/series-…

heyoka integrates handwritten accelerations. Times are the shortest of several runs, errors those of the largest component of the
final state, against heyoka at 1e-18. Times at equal errors are interpolated between tolerances, in logarithms.
"""

import math
import re
import subprocess
import sys
import time

import heyoka
import numpy as np

ROUNDING = 1e-17
TURNS = 3
RUNS = 60
TOLERANCES = [1e-4, 1e-6, 1e-9, 1e-12, 1e-14]
ERRORS = [1e-6, 1e-9, 1e-12, 2e-14]


def double_pendulum():
    a, b, v, w = heyoka.make_vars("a", "b", "v", "w")
    s, c, g = heyoka.sin(a - b), heyoka.cos(a - b), 9.81
    first, second = -w * w * s - 2 * g * heyoka.sin(a), v * v * s - g * heyoka.sin(b)
    below = 2 - c**2
    return [(a, v), (b, w), (v, (first - c * second) / below), (w, (2 * second - c * first) / below)]


def kepler():
    r, phi, u, w = heyoka.make_vars("r", "phi", "u", "w")
    return [(r, u), (phi, w), (u, r * w**2 - r**-2.0), (w, -2 * u * w / r)]


def chain():
    """Six unit masses on unit rods, with the mass matrix solved by an unrolled factorisation."""
    n, g = 6, 9.81
    angles = heyoka.make_vars(*[f"q{i}" for i in range(n)])
    rates = heyoka.make_vars(*[f"v{i}" for i in range(n)])
    beyond = [[n - max(i, j) for j in range(n)] for i in range(n)]
    matrix = [[beyond[i][j] * heyoka.cos(angles[i] - angles[j]) for j in range(i + 1)] for i in range(n)]
    right = [
        -(n - i) * g * heyoka.sin(angles[i])
        - sum(beyond[i][j] * heyoka.sin(angles[i] - angles[j]) * rates[j] ** 2 for j in range(n) if j != i)
        for i in range(n)
    ]
    factor = [[None] * n for _ in range(n)]
    pivots = [None] * n
    for j in range(n):
        pivots[j] = matrix[j][j] - sum(factor[j][k] ** 2 * pivots[k] for k in range(j))
        for i in range(j + 1, n):
            gained = sum(factor[i][k] * factor[j][k] * pivots[k] for k in range(j))
            factor[i][j] = (matrix[i][j] - gained) / pivots[j]
    found = [None] * n
    for i in range(n):
        found[i] = right[i] - sum(factor[i][k] * found[k] for k in range(i))
    found = [value / pivot for value, pivot in zip(found, pivots)]
    for i in reversed(range(n)):
        found[i] = found[i] - sum(factor[k][i] * found[k] for k in range(i + 1, n))
    return list(zip(angles, rates)) + list(zip(rates, found))


def top():
    """Euler's equations in body axes, with a quaternion."""
    a, c, h = 1.0, 0.5, 0.7
    w, x, y, z = heyoka.make_vars("qw", "qx", "qy", "qz")
    r, s, t = heyoka.make_vars("wx", "wy", "wz")
    # The vertical in body axes.
    down, aside = 2 * (x * z - w * y), 2 * (y * z + w * x)
    return [
        (w, -0.5 * (x * r + y * s + z * t)),
        (x, 0.5 * (w * r + y * t - z * s)),
        (y, 0.5 * (w * s + z * r - x * t)),
        (z, 0.5 * (w * t + x * s - y * r)),
        (r, ((a - c) * s * t + h * aside) / a),
        (s, ((c - a) * t * r - h * down) / a),
        (t, heyoka.expression(0.0)),
    ]


# Masses, positions and velocities as in the benchmark.
PLANET_MASSES = [1.00000597682, 0.000954786104043, 0.000285583733151, 0.0000437273164546, 0.0000517759138449, 1 / 1.3e8]
PLANETS = [
    [0.0] * 6,
    [-3.5023653, -3.8169847, -1.5507963, 0.00565429, -0.00412490, -0.00190589],
    [9.0755314, -3.0458353, -1.6483708, 0.00168318, 0.00483525, 0.00192462],
    [8.3101420, -16.2901086, -7.2521278, 0.00354178, 0.00137102, 0.00055029],
    [11.4707666, -25.7294829, -10.8169456, 0.00288930, 0.00114527, 0.00039677],
    [-15.5387357, -25.2225594, -3.1902382, 0.00276725, -0.00170702, -0.00136504],
]


def planets():
    return heyoka.model.nbody(6, masses=PLANET_MASSES, Gconst=2.95912208286e-4)


MOTIONS = {
    "double pendulum": (double_pendulum(), [2.0, 1.5, 0.0, 0.0], 10.0),
    "Kepler": (kepler(), [0.4, 0.0, 0.0, 5.0], 20 * math.pi),
    "chain of six": (chain(), [1.0, 1.2, 1.4, 1.6, 1.8, 2.0] + 6 * [0.0], 3.0),
    "heavy top": (top(), [0.9, 0.3, 0.1, 0.3, 0.1, 0.2, 5.0], 10.0),
    "outer planets": (planets(), np.concatenate(PLANETS).tolist(), 20_000.0),
}


def of_heyoka(integrator, start, end):
    """Returns microseconds and the final state."""
    best = math.inf
    for _ in range(RUNS):
        integrator.time, integrator.state[:] = 0.0, start
        began = time.perf_counter_ns()
        outcome = integrator.propagate_until(end, max_steps=100_000)[0]
        best = min(best, (time.perf_counter_ns() - began) / 1e3)
        assert outcome == heyoka.taylor_outcome.time_limit, outcome
    return best, integrator.state.copy()


def of_this_crate(benchmark):
    """Returns errors and microseconds by motion and tolerance."""
    output = subprocess.run([benchmark], capture_output=True, text=True, check=True).stdout
    row = r"\s*(.+?) (\S+): series\s+\d+ steps (\S+)\s+(\S+) "
    return {(m[1], float(m[2])): (float(m[3]), float(m[4])) for m in re.finditer(row, output)}


def at(error, points):
    """Returns the time at an error, between neighbours, or None if it is not reached."""
    # Errors below rounding, or equal ones, have no logarithms or slopes.
    best = {}
    for reached, microseconds in points:
        reached = max(reached, ROUNDING)
        best[reached] = min(best.get(reached, math.inf), microseconds)
    points = sorted(best.items(), reverse=True)
    if len(points) < 2 or points[-1][0] > error:
        return None
    x = [math.log(e) for e, _ in points]
    y = [math.log(t) for _, t in points]
    place = next((i for i in range(len(x) - 2) if x[i + 1] <= math.log(error)), len(x) - 2)
    slope = (y[place + 1] - y[place]) / (x[place + 1] - x[place])
    return math.exp(y[place] + slope * (math.log(error) - x[place]))


def main():
    integrators, references = {}, {}
    for name, (equations, start, end) in MOTIONS.items():
        exact = heyoka.taylor_adaptive(equations, start, tol=1e-18)
        references[name] = of_heyoka(exact, start, end)[1]
        for tolerance in TOLERANCES:
            integrators[name, tolerance] = heyoka.taylor_adaptive(equations, start, tol=tolerance)
    ours, theirs = {}, {}
    for _ in range(TURNS):
        for key, (error, microseconds) in of_this_crate(sys.argv[1]).items():
            ours[key] = min(ours.get(key, (error, math.inf)), (error, microseconds))
        for key, integrator in integrators.items():
            _, start, end = MOTIONS[key[0]]
            microseconds, state = of_heyoka(integrator, start, end)
            error = np.max(np.abs(state - references[key[0]]))
            theirs[key] = min(theirs.get(key, (error, math.inf)), (error, microseconds))
    print("| motion | error | heyoka | `Taylor` | ratio |\n|---|---|---|---|---|")
    for name in MOTIONS:
        here, there = ([points[name, t] for t in TOLERANCES] for points in (ours, theirs))
        for error in ERRORS:
            a, b = at(error, here), at(error, there)
            ratio = a / b if a and b else None
            cells = ["–" if number is None else f"{number:.{digits}f}" for number, digits in [(b, 0), (a, 0), (ratio, 2)]]
            print(f"| {name} | {error:.0e} | {' | '.join(cells)} |")


if __name__ == "__main__":
    main()
