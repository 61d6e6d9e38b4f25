"""Reference motion of `tests/delays/loops.rs`: an inverted pendulum under delayed feedback.

    python3 tools/delay.py        writes tests/references/delay.csv (a second)

The method of steps: in the k-th interval of length TAU the delayed values are those of the previous interval, at the same points. Each
interval is solved by Chebyshev collocation: with y at the Chebyshev points, y = y(0) + integral of the rates is iterated to a fixed
point, and polynomials of two degrees must agree to DIGITS digits. Jumps of derivatives only lie at the ends of intervals, so
convergence is spectral. Equations are handwritten; nothing comes from this project.
"""

from pathlib import Path

import numpy as np
from numpy.polynomial import chebyshev

DIGITS = 13
TARGET = Path(__file__).resolve().parent.parent / "tests" / "references" / "delay.csv"
MASS, LENGTH, GRAVITY, STIFFNESS, DAMPING, TAU = 1.0, 1.0, 9.81, 30.0, 6.0, 0.05
START, END, INTERVAL = (0.3, 0.0), 4.0, 0.2


def integration(degree):
    """Returns Chebyshev points from -1 to 1, and the matrix of integrals from -1 to each of them."""
    points = -np.cos(np.pi * np.arange(degree + 1) / degree)
    values = np.linalg.inv(chebyshev.chebvander(points, degree))
    integrals = np.array([chebyshev.chebval(points, chebyshev.chebint(column, lbnd=-1)) for column in values.T])
    return integrals.T


def rates(state, delayed):
    angle, velocity = state
    torque = MASS * GRAVITY * LENGTH * np.sin(angle) - STIFFNESS * delayed[0] - DAMPING * delayed[1]
    return np.array([velocity, torque / (MASS * LENGTH**2)])


def motion(degree):
    """Returns the states at the ends of all intervals."""
    matrix = integration(degree) * TAU / 2
    delayed = np.repeat(np.array(START)[:, None], degree + 1, axis=1)
    ends = [np.array(START)]
    for _ in range(round(END / TAU)):
        state = np.repeat(ends[-1][:, None], degree + 1, axis=1)
        for _ in range(60):
            state = ends[-1][:, None] + rates(state, delayed) @ matrix.T
        ends.append(state[:, -1])
        delayed = state
    return np.array(ends)


def main():
    coarse, fine = motion(16), motion(24)
    assert np.abs(coarse - fine).max() < 10.0**-DIGITS * max(1.0, np.abs(fine).max()), np.abs(coarse - fine).max()
    every = round(INTERVAL / TAU)
    lines = ["t,theta,theta_dot"]
    lines += [f"{index * TAU:.1f},{angle:.15g},{rate:.15g}" for index, (angle, rate) in enumerate(fine) if index % every == 0]
    TARGET.write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
