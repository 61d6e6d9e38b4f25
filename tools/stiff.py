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


def elastic_rod():
    """The matrices of mass, damping, stiffness and inertial coupling, and the moments of the rod, over its density."""
    density, young, width, length, circle = 7870.0, 0.2e12, 0.008, 0.3, 3.1415927
    volume, springs = width**2 * length, young * width**2 / length
    mass = density * volume * np.array([[0.5, 0, 0, 0], [0, 0.5, 0, 0], [0, 0, 8, 1], [0, 0, 1, 2]])
    bending = circle**4 * (width / length) ** 2
    stiffness = springs * np.diag([bending / 24, 2 * bending / 3, 16 / 3, 7 / 3])
    stiffness[2, 3] = stiffness[3, 2] = -8 / 3 * springs
    damping = np.diag([5, 25, 0.5 * 230.8375455264791, 0.5 * 421.7421837156818])
    damping[2, 3] = damping[3, 2] = -0.5 * 262.688487992052
    coupling = np.zeros((4, 4))
    coupling[0, 2], coupling[0, 3], coupling[1, 3] = -16 / circle**3, 8 / circle**3 - 1 / circle, 0.5 / circle
    coupling = density * volume * (coupling - coupling.T)
    along = density * volume * np.array([0, 0, 2 / 3, 1 / 6])
    across = density * volume * np.array([2 / circle, 0, 0, 0])
    turning_along = density * volume * length * np.array([0, 0, 1 / 3, 1 / 6])
    turning_across = density * volume * length * np.array([1 / circle, -0.5 / circle, 0, 0])
    return mass, damping, stiffness, coupling, along, across, turning_along, turning_across


ROD = elastic_rod()


def slider_crank(_, y):
    """A crank that turns at 150 rad/s, an elastic rod, a slider.

    Angle of the crank, four deflections of the rod, and their rates. The angle of the rod follows from them. Accelerations and the
    forces in the rod's end solve one linear system, as in problem CRANK of Mazzia and Magherini, *Test Set for Initial Value Problem
    Solvers*, 2.4, with damping.
    """
    mass, damping, stiffness, coupling, along, across, turning_along, turning_across = ROD
    short, long, rod_mass, rod_inertia, slider = 0.15, 0.3, 0.151104, 0.0045339259, 0.075552
    turn, crank, q, u = 150.0, y[0], y[1:5], y[5:]
    rod = np.arcsin(-short * np.sin(crank) / (long + q[3]))
    sine, cosine = np.sin(rod), np.cos(rod)
    spin = -(short * np.cos(crank) * turn + sine * u[3]) / ((long + q[3]) * cosine)
    s, c = np.sin(crank - rod), np.cos(crank - rod)
    # Accelerations of the rod's angle, the slider and the deflections, then the forces of both constraints.
    matrix = np.zeros((8, 8), dtype=np.asarray(y).dtype)
    matrix[0, 0] = rod_inertia + q @ mass @ q + 2 * turning_along @ q
    matrix[0, 2:6] = matrix[2:6, 0] = turning_across + q @ coupling
    matrix[1, 1] = slider
    matrix[2:6, 2:6] = mass
    gradients = np.zeros((2, 6), dtype=matrix.dtype)
    gradients[:, 0] = (long + q[3]) * cosine, (long + q[3]) * sine
    gradients[:, 1] = 0, 1
    gradients[:, 5] = sine, -cosine
    matrix[6:, :6], matrix[:6, 6:] = gradients, gradients.T
    forces = np.zeros(8, dtype=matrix.dtype)
    forces[0] = short * turn**2 * (0.5 * long * rod_mass * s + s * (along @ q) - c * (across @ q))
    forces[0] -= 2 * spin * (turning_along @ u + u @ mass @ q)
    forces[2:6] = spin**2 * (mass @ q + turning_along) + short * turn**2 * (c * along + s * across) + 2 * spin * (coupling @ u)
    forces[2:6] -= stiffness @ q + damping @ u
    reach, stretching = (long + q[3]) * spin**2, 2 * spin * u[3]
    forces[6] = short * np.sin(crank) * turn**2 + reach * sine - stretching * cosine
    forces[7] = -(short * np.cos(crank) * turn**2 + reach * cosine + stretching * sine)
    return [turn, *u, *np.linalg.solve(matrix, forces)[2:6]]


# Of the test set: without vibrations at first.
SLIDER_CRANK = [0, 0, 0, 0.103339863e-4, 0.169327969e-4, 0.444896105, 0.463434311e-2, -0.178591076e-5, -0.268938672e-5]

# Name, equations, start, times, the size of each component.
MOTIONS = [
    ("elastic_pendulum", elastic_pendulum, [1, 1, 0, 0], [1, 4], [1, 1, 1, 1]),
    ("relaxation", relaxation, [2, 0.5, 0, 0], [5, 20], [1, 1, 1, 1]),
    ("bounce", bounce, [0.5, 0], [0.3, 0.6], [1e-3, 1]),
    ("stick_slip", stick_slip, [0, 0, 0], [5, 7.5, 20], [1, 1e-5, 1e-2]),
    ("slider_crank", slider_crank, SLIDER_CRANK, [0.02, 0.1], [1] + 4 * [1e-4] + 4 * [0.1]),
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
