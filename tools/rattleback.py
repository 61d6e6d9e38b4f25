"""Motions of a rattleback, for tests/trajectories/surfaces/rattleback.rs.

    pip install numpy scipy
    python3 tools/rattleback.py

An ellipsoid rolls on a plane without slipping. Its principal axes of inertia are turned against those of the ellipsoid. In body axes, with
the upward vertical u, the angular velocity w, and the vector r from the centre of mass to the point of contact:

    I w' + w x I w = r x F,    F = m (g u + v' + w x v),    v = -w x r,    u' = u x w.

Sources: Garcia and Hubbard, "Spin reversal of the rattleback: theory and experiment", Proc. R. Soc. A 418 (1988) 165-197, without
friction; numbers of Kane and Levinson, "Realistic mathematical modeling of the rattleback", Int. J. Non-Linear Mech. 17 (1982) 175-186,
without air resistance. The body axis z points up.
"""

from pathlib import Path

import numpy as np
from scipy.integrate import solve_ivp

TARGET = Path(__file__).parent.parent / "tests/trajectories/surfaces/rattleback.csv"
G, MASS, LOW = 9.81, 1.0, 0.01
AXES = np.array([0.2, 0.03, 0.02])
INERTIA = np.array([[2e-4, -2e-5, 0], [-2e-5, 1.6e-3, 0], [0, 0, 1.7e-3]])
TILT, TIMES = np.radians(0.5), np.arange(0, 8.01, 0.5)


def contact(u):
    """Returns the vector from the centre of mass to the point of contact, and its derivatives by u."""
    squares = AXES**2
    size = np.sqrt(squares @ u**2)
    point = -squares * u / size
    slopes = -np.diag(squares) / size + np.outer(squares * u, squares * u) / size**3
    return point + np.array([0, 0, LOW]), slopes


def cross(r):
    """Returns the matrix of the product with r from the left."""
    x, y, z = r
    return np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])


def terms(state):
    """Returns the angular acceleration and the force of the contact."""
    u, w = state[:3], state[3:]
    r, slopes = contact(u)
    along, turn = cross(r), cross(w)
    # v' = r x w' - w x r', so that the force is F = m r x w' + known.
    known = MASS * (G * u - turn @ (slopes @ cross(u) @ w) - turn @ turn @ r)
    turning = np.linalg.solve(INERTIA - MASS * along @ along, along @ known - turn @ INERTIA @ w)
    return turning, known + MASS * along @ turning


def rates(_, state):
    return np.concatenate([cross(state[:3]) @ state[3:], terms(state)[0]])


def energy(state):
    u, w = state[:3], state[3:]
    r, _ = contact(u)
    v = cross(r) @ w
    return MASS * (v @ v / 2 - G * r @ u) + w @ INERTIA @ w / 2


def main():
    lines = ["spin,time,vertical and angular velocity"]
    for spin in [5.0, -5.0]:
        start = np.array([0, np.sin(TILT), np.cos(TILT), 0, 0, spin])
        run = solve_ivp(rates, (0, TIMES[-1]), start, "DOP853", rtol=1e-13, atol=1e-14, dense_output=True)
        states = run.y.T
        forces = [terms(state)[1] for state in states]
        loads = [force @ state[:3] for force, state in zip(forces, states)]
        ratios = [np.linalg.norm(cross(force) @ state[:3]) / load for force, state, load in zip(forces, states, loads)]
        drift = max(abs(energy(state) - energy(start)) for state in states)
        around = [state[3:] @ state[:3] for state in states]
        print(f"{spin}: least load {min(loads):.3f} N, largest ratio {max(ratios):.3f}, energy drifts by {drift:.1e} J, spin from {min(around):.3f}"
              f" to {max(around):.3f}, {len(run.t)} steps")
        for time in TIMES:
            lines.append(",".join([str(spin), str(time), *(f"{float(x):.15e}" for x in run.sol(time))]))
    TARGET.write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
