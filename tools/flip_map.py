"""References of `examples/flip_map.rs`: handwritten equations of motion, for SciPy.

    python3 tools/flip_map.py

Two equal masses on rods of equal lengths l, released at rest, in absolute angles a and b:

    2 a'' + cos(a - b) b'' = -sin(a - b) b'^2 - 2 g/l sin a
    cos(a - b) a'' + b''   =  sin(a - b) a'^2 -   g/l sin b

Prints the times at which b first passes pi or -pi, by DOP853 with two tolerances, if these agree.
"""

import numpy
from scipy.integrate import solve_ivp

AGREEMENT = 2e-12
STARTS = [(1.0, -3.0), (-2.0, 2.0), (2.5, 1.0)]


def rates(t, y, g=9.81):
    a, b, da, db = y
    s, c = numpy.sin(a - b), numpy.cos(a - b)
    mass = numpy.array([[2.0, c], [c, 1.0]])
    force = numpy.array([-s * db**2 - 2 * g * numpy.sin(a), s * da**2 - g * numpy.sin(b)])
    return numpy.concatenate([[da, db], numpy.linalg.solve(mass, force)])


def over_the_top(t, y):
    return y[1] ** 2 - numpy.pi**2


over_the_top.terminal = True
over_the_top.direction = 1.0


def flip(start, step):
    run = solve_ivp(
        rates, (0.0, 20.0), [*start, 0.0, 0.0], "DOP853", rtol=3e-14, atol=1e-14, max_step=step, events=over_the_top
    )
    return run.t_events[0][0]


for start in STARTS:
    coarse, fine = flip(start, 0.01), flip(start, 0.004)
    assert abs(coarse - fine) < AGREEMENT, (start, coarse, fine)
    print(f"    ({list(start)}, {fine:.12f}),")
