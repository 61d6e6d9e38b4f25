"""Balls on curved terrain without friction, and a disk that rolls on a road: the reference of
tests/trajectories/surfaces/terrain.rs.

    python3 tools/terrain.py      writes tests/trajectories/surfaces/terrain.csv (seconds)

The centre of a ball of radius r that touches z = h(u, v) is o(u, v) = p + r n, the parallel surface. SymPy derives the
equations of L = 1/2 |do/dt|^2 - g o_z in u and v. A disk on a road rolls with the angular velocity -|do/dt|/r, and has
the kinetic energy 3/4 |do/dt|^2. DOP853 of SciPy integrates with a relative tolerance of 3e-14.
"""

from pathlib import Path

import numpy as np
import sympy as sp
from scipy.integrate import solve_ivp

G = 9.81
TIMES = [0.0, 0.25, 0.5, 0.75, 1.0]
TARGET = Path(__file__).resolve().parent.parent / "tests" / "trajectories" / "surfaces" / "terrain.csv"
u, v, du, dv = sp.symbols("u v du dv")


def solved(kinetic, potential, count, turning, start):
    """Returns states at all times: coordinates, rates and an angle with the given rate."""
    coordinates, rates = [u, v][:count], [du, dv][:count]
    mass = sp.hessian(kinetic, rates)
    momentum = sp.Matrix([sp.diff(kinetic, rate) for rate in rates])
    slope = sp.Matrix([sp.diff(kinetic - potential, q) for q in coordinates])
    force = slope - momentum.jacobian(sp.Matrix(coordinates)) * sp.Matrix(rates)
    of = sp.lambdify([coordinates, rates], [mass, force, turning], cse=True)

    def rhs(_, y):
        q, w = y[:count], y[count : 2 * count]
        m, f, rate = of(q, w)
        return [*w, *np.linalg.solve(np.array(m, float), np.array(f, float)[:, 0]), rate]

    return solve_ivp(rhs, (0, TIMES[-1]), [*start, 0.0], "DOP853", TIMES, rtol=3e-14, atol=1e-14).y.T


def ball(height, r, start):
    """Returns positions and velocities of the centre of a ball without friction."""
    hu, hv = sp.diff(height, u), sp.diff(height, v)
    w = sp.sqrt(1 + hu**2 + hv**2)
    center = sp.Matrix([u - r * hu / w, v - r * hv / w, height + r / w])
    rate = center.jacobian([u, v]) * sp.Matrix([du, dv])
    states = solved(rate.dot(rate) / 2, G * center[2], 2, 0, start)
    place = sp.lambdify([u, v, du, dv], list(center) + list(rate), cse=True)
    return [place(*state[:4]) for state in states]


def road(height, r, start):
    """Returns position, angle and velocity of the centre of a disk that rolls on a curve."""
    slope = sp.diff(height, u)
    w = sp.sqrt(1 + slope**2)
    center = sp.Matrix([u - r * slope / w, height + r / w])
    along = sp.diff(center, u)
    speed = along[0] * w * du  # The tangent is (1, h')/w.
    states = solved(sp.Rational(3, 4) * speed**2, G * center[1], 1, -speed / r, start)
    place = sp.lambdify([u, du], list(center) + list(along * du), cse=True)
    rows = [(place(*state[:2]), state[2]) for state in states]
    return [[x, y, angle, vx, vy] for (x, y, vx, vy), angle in rows]


def main():
    bowl = (u**2 + v**2) / 2
    hills = sp.Rational(1, 10) * sp.sin(2 * u) * sp.cos(3 * v)
    wave = sp.Rational(1, 20) * sp.sin(4 * u)
    scenes = {
        "bead": ball(bowl, 0, [0.6, 0.0, 0.1, 0.7]),
        "ball": ball(bowl, sp.Rational(1, 4), [0.6, 0.0, 0.1, 0.7]),
        "hills": ball(hills, sp.Rational(1, 20), [0.3, 0.2, 0.8, 0.5]),
        "road": road(wave, sp.Rational(1, 10), [0.1, 1.5]),
    }
    rows = [[scene, str(time), *(f"{float(x):.15e}" for x in state)]
            for scene, states in scenes.items() for time, state in zip(TIMES, states)]
    TARGET.write_text("\n".join(["scene,time,state"] + [",".join(row) for row in rows]) + "\n")


if __name__ == "__main__":
    main()
