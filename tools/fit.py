"""Data and references of `examples/fit.rs` and `tests/fit`.

    python3 tools/fit.py        writes examples/data/double_pendulum.csv, prints the references (half a minute)

A double pendulum with friction in both joints is integrated by the Runge-Kutta method DOP853 of SciPy. Its angles get noise and are
rounded, and some are left out, as if a camera had not seen a mark. SciPy's `least_squares` fits the masses, friction and
initial angles, with derivatives by differences of motions; standard errors follow from its Jacobian. Equations of motion are
handwritten; nothing comes from this project.
"""

from pathlib import Path

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import least_squares

TARGET = Path(__file__).resolve().parent.parent / "examples" / "data" / "double_pendulum.csv"
L1, L2, G, M1 = 0.5, 0.4, 9.81, 0.3
TRUE = {"m2": 0.2, "c1": 0.01, "c2": 0.004, "theta1": 1.0, "theta2": -0.5}
NOISE = {"theta1": 0.01, "theta2": 0.02}


def rates(_, y, m2, c1, c2):
    """θ̈ from M(θ) θ̈ = forces, with torques -c1 θ̇1 and -c2 (θ̇2 - θ̇1) in the joints."""
    a, b, u, v = y
    cosine, sine = np.cos(a - b), np.sin(a - b)
    mass = [[(M1 + m2) * L1**2, m2 * L1 * L2 * cosine], [m2 * L1 * L2 * cosine, m2 * L2**2]]
    between = c2 * (v - u)
    forces = [
        -m2 * L1 * L2 * sine * v**2 - (M1 + m2) * G * L1 * np.sin(a) - c1 * u + between,
        m2 * L1 * L2 * sine * u**2 - m2 * G * L2 * np.sin(b) - between,
    ]
    return [u, v, *np.linalg.solve(mass, forces)]


def angles(values, times):
    m2, c1, c2, theta1, theta2 = values
    start = [theta1, theta2, 0.0, 0.0]
    found = solve_ivp(rates, (0.0, times[-1]), start, "DOP853", times, args=(m2, c1, c2), rtol=1e-11, atol=1e-12)
    return found.y[:2]


def write():
    """Writes the data."""
    times = np.round(np.arange(0.0, 4.0001, 0.02), 2)
    noise = np.random.default_rng(1)
    columns = angles(list(TRUE.values()), times)
    lines = ["t in s,theta1 in rad,theta2 in rad"]
    columns = [column + level * noise.standard_normal(len(times)) for column, level in zip(columns, NOISE.values())]
    for row, (time, *cells) in enumerate(zip(times, *columns)):
        cells = [f"{cell:.4f}" for cell in cells]
        if row % 17 == 5:
            cells[1] = ""
        lines.append(",".join([f"{time}", *cells]))
    TARGET.write_text("\n".join(lines) + "\n")


def read():
    rows = [[float(cell) if cell else np.nan for cell in line.split(",")] for line in TARGET.read_text().splitlines()[1:]]
    return np.array(rows).T


def fit(names, bounds, start):
    """Prints the fit of these variables; the others have their true values."""
    times, *measured = read()
    levels = np.array([[level] for level in NOISE.values()])

    def residuals(x):
        values = dict(TRUE, **dict(zip(names, x)))
        left = (angles(list(values.values()), times) - np.array(measured)) / levels
        return left[np.isfinite(left)]

    settings = dict(jac="3-point", x_scale="jac", xtol=1e-13, ftol=1e-13, gtol=1e-13, bounds=bounds)
    found = least_squares(residuals, start, **settings)
    free = found.active_mask == 0
    covariance = np.linalg.inv(found.jac[:, free].T @ found.jac[:, free])
    print(f"chi^2 {2 * found.cost:.10f} of {len(found.fun)} values")
    for name, value, is_free in zip(names, found.x, free):
        error = np.sqrt(covariance[np.sum(free[: names.index(name)]), np.sum(free[: names.index(name)])]) if is_free else 0.0
        print(f'    ("{name}", {value:.9e}, {error:.5e}),')


if __name__ == "__main__":
    write()
    free = (-np.inf, np.inf)
    fit(list(TRUE), free, [0.5, 0.02, 0.02, 1.1, -0.4])
    # The bound on the second friction is half of its true value.
    fit(["m2", "c1", "c2"], ([0.01, 0.0, 0.0], [5.0, 1.0, 0.002]), [0.5, 0.02, 0.001])
