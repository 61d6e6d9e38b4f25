"""Reference states of stiff motions, by SciPy's Radau at 1e-11 (a tenth of it in the units of the state).

Writes `tests/trajectories/stiff_references.csv`: the name of a motion, a time, and the state there. The equations are handwritten,
independently of the declarations in `tests/trajectories/damped.rs`. Jacobians are complex-step derivatives. Takes ten minutes.

    pip install numpy scipy
    python3 tools/stiff.py
"""

import sys
from pathlib import Path

import numpy as np
from scipy.integrate import solve_ivp

TARGET = Path(__file__).parent.parent / "tests" / "trajectories" / "stiff_references.csv"


def elastic_pendulum(_, y):
    """A point mass on a spring with a damper, in polar coordinates."""
    r, a, v, w = y
    return [v, w, r * w**2 - 1e8 * (r - 1) - 2e4 * v + 9.81 * np.cos(a), -(2 * v * w + 9.81 * np.sin(a)) / r]


def relaxation(_, y):
    """Van der Pol's oscillator of mass 1, with a pendulum of mass 0.1 and length 1."""
    x, a, v, w = y
    sine, cosine = np.sin(a), np.cos(a)
    # 1.1 x'' + 0.1 cos a a'' = force, cos a x'' + a'' = -9.81 sin a
    force = -x + 100 * (1 - x**2) * v + 0.1 * sine * w**2
    acceleration = (force + 0.1 * 9.81 * sine * cosine) / (1.1 - 0.1 * cosine**2)
    return [v, w, acceleration, -9.81 * sine - cosine * acceleration]


def bounce(_, y):
    """A ball that meets the ground with the force k d^1.5 (1 + 1.5 c d')."""
    x, v = y
    d = -x if np.real(x) < 0 else 0 * x
    return [v, -9.81 + 1e8 * d * np.sqrt(d) * (1 - 0.3 * v)]


def stick_slip(_, y):
    """A block pulled by a spring over ground with LuGre friction: extension of the spring, bristle, velocity."""
    w, z, v = y
    size = v if np.real(v) > 0 else -v
    rate = v - 1e5 * size / (1 + 0.5 * np.exp(-((v / 1e-3) ** 2))) * z
    return [0.1 - v, rate, 2 * w - (1e5 * z + np.sqrt(1e5) * rate + 0.4 * v)]


def whip(_, y):
    """A rod with a mass at its end, and another one attached by a spring of stiffness 1e7 and a damper."""
    a, x, z, w, u, v = y
    sine, cosine = np.sin(a), np.cos(a)
    dx, dz = x - sine, z + cosine
    length = np.sqrt(dx**2 + dz**2)
    rate = (dx * (u - cosine * w) + dz * (v - sine * w)) / length
    force = 1e7 * (length - 1) + 2e3 * rate
    fx, fz = force * dx / length, force * dz / length
    return [w, u, v, fx * cosine + (fz - 9.81) * sine, -fx, -fz - 9.81]


# Name, equations, start, times, the size of each component.
MOTIONS = [
    ("elastic_pendulum", elastic_pendulum, [1, 1, 0, 0], [1, 4], [1, 1, 1, 1]),
    ("relaxation", relaxation, [2, 0.5, 0, 0], [5, 20], [1, 1, 1, 1]),
    ("bounce", bounce, [0.5, 0], [0.3, 0.6], [1e-3, 1]),
    ("stick_slip", stick_slip, [0, 0, 0], [5, 7.5, 20], [1, 1e-5, 1e-2]),
    ("whip", whip, [1, np.sin(1), -np.cos(1) - 1, 0, 0, 0], [0.5, 1], [1, 1, 1, 1, 1, 1]),
]


def jacobian(equations, y):
    columns = []
    for column in range(len(y)):
        moved = np.array(y, dtype=complex)
        moved[column] += 1e-30j
        columns.append(np.imag(np.array(equations(0, moved), dtype=complex)) / 1e-30)
    return np.array(columns).T


def main():
    rows = []
    for name, equations, start, times, sizes in MOTIONS:
        if len(sys.argv) > 1 and name not in sys.argv[1:]:
            continue
        state, time = np.array(start, float), 0.0
        for end in times:
            motion = solve_ivp(
                equations, (time, end), state, "Radau", rtol=1e-11, atol=1e-12 * np.array(sizes),
                jac=lambda _, y: jacobian(equations, y),
            )
            assert motion.success, motion.message
            state, time = motion.y[:, -1], end
            rows.append(",".join([name, repr(float(end)), *(f"{x:.17g}" for x in state)]))
            print(rows[-1], flush=True)
    if len(sys.argv) == 1:
        TARGET.write_text("\n".join(rows) + "\n")


if __name__ == "__main__":
    main()
