"""Motions of plates on feet with Coulomb friction, for the tests of friction in a plane.

    pip install numpy scipy
    python3 tools/plates.py            writes tests/trajectories/plates.csv

A plate of mass 1 and moment of inertia 0.02, seen from above, slides on feet whose friction is 1 each.
The friction is regularised as -s/sqrt(|s|^2 + w^2) and integrated by SciPy's Radau method. The remaining
error at w = 1e-6 is proportional to w, and removed by extrapolation from 2e-6. Positions are taken when
all speeds first fall below 1e-5; afterwards plates move less than 1e-9.
"""

from pathlib import Path

import numpy as np
from scipy.integrate import solve_ivp

TARGET = Path(__file__).resolve().parent.parent / "tests" / "trajectories" / "plates.csv"
FEET = {
    3: [(0.2, 0.0), (-0.2, 0.1), (-0.2, -0.1)],
    4: [(0.2, 0.15), (-0.2, 0.15), (0.2, -0.15), (-0.2, -0.15)],
    5: [(0.2, 0.15), (-0.2, 0.15), (0.2, -0.15), (-0.2, -0.15), (0.0, 0.0)],
}
STARTS = [(0.0, 0.0, 0.0, 0.0, 0.0, 5.0), (0.0, 0.0, 0.0, 1.0, 0.3, 5.0), (0.0, 0.0, 0.3, 1.0, 1.0, 0.0)]


def rates(feet, w):
    feet = np.array(feet)

    def function(_, state):
        phi, v, omega = state[2], state[3:5], state[5]
        cos, sin = np.cos(phi), np.sin(phi)
        arms = feet @ np.array([[cos, sin], [-sin, cos]])
        slips = v + omega * np.stack([-arms[:, 1], arms[:, 0]], axis=1)
        forces = -slips / np.sqrt((slips**2).sum(axis=1) + w * w)[:, None]
        moment = (arms[:, 0] * forces[:, 1] - arms[:, 1] * forces[:, 0]).sum()
        return [*v, omega, *forces.sum(axis=0), moment / 0.02]

    return function


def end(feet, start, w):
    def slow(_, state):
        return np.abs(state[3:]).max() - 1e-5

    slow.terminal = True
    found = solve_ivp(rates(feet, w), (0, 2), start, method="Radau", rtol=1e-10, atol=1e-13, events=slow)
    return found.y[:3, -1]


def main():
    lines = ["feet,start,x,y,phi"]
    for count, feet in FEET.items():
        for number, start in enumerate(STARTS):
            fine, coarse = (end(feet, start, w) for w in (1e-6, 2e-6))
            position = 2 * fine - coarse
            lines.append(f"{count},{number}," + ",".join(f"{value:.9f}" for value in position))
    TARGET.write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
