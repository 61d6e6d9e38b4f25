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


MOTIONS = {
    "double pendulum": (double_pendulum(), [2.0, 1.5, 0.0, 0.0], 10.0),
    "Kepler": (kepler(), [0.4, 0.0, 0.0, 5.0], 20 * math.pi),
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
    points = sorted(points, reverse=True)
    if points[-1][0] > error:
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
