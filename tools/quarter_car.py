"""Road and reference motion of `examples/quarter_car.rs`.

    python3 tools/quarter_car.py        writes examples/data/road.csv, prints the reference (a few seconds)

The road represents a measured one: heights every 0.25 m, rounded to 0.1 mm, of sines whose amplitudes decrease with the square of
their wave number, as in the road profiles of ISO 8608. The motion of the car over the natural cubic spline through them (SciPy's
`CubicSpline`) is computed in two ways, and printed if both agree to DIGITS digits. The Runge-Kutta method DOP853 restarts at each
point of the table, where the third derivative of the road jumps. Matrix exponentials of the linear equations have the cubic
polynomial of each piece among their unknowns. Equations of motion are handwritten; nothing comes from this project.
"""

from pathlib import Path

import numpy as np
from scipy.integrate import solve_ivp
from scipy.interpolate import CubicSpline
from scipy.linalg import expm

DIGITS = 12
TARGET = Path(__file__).resolve().parent.parent / "examples" / "data" / "road.csv"
LENGTH, SPACING, SPEED = 50.0, 0.25, 20.0
BODY, WHEEL, SPRING, DAMPER, TYRE = 290.0, 59.0, 16800.0, 1000.0, 190000.0


def road():
    """Returns the points of the road, which is level at its start."""
    x = np.arange(0.0, LENGTH + SPACING / 2, SPACING)
    waves = np.arange(1, 41)
    phases = 2 * np.pi * ((waves * (1 + 5**0.5) / 2) % 1)
    heights = sum(0.06 / k**2 * np.sin(2 * np.pi * k * x / 60 + phase) for k, phase in zip(waves, phases))
    fade = np.minimum(x / 5, 1.0) ** 2
    return x, np.round((heights - heights[0]) * fade, 4) + 0.0


def rates(spline):
    def of(t, y):
        body, wheel, body_rate, wheel_rate = y
        strut = SPRING * (wheel - body) + DAMPER * (wheel_rate - body_rate)
        tyre = TYRE * (spline(SPEED * t) - wheel)
        return [body_rate, wheel_rate, strut / BODY, (tyre - strut) / WHEEL]

    return of


def by_runge_kutta(x, spline):
    y, of = np.zeros(4), rates(spline)
    for start, end in zip(x[:-1] / SPEED, x[1:] / SPEED):
        run = solve_ivp(of, (start, end), y, method="DOP853", rtol=1e-13, atol=1e-18)
        y = run.y[:, -1]
    return y


def by_exponentials(x, spline):
    """Returns the equations for the state, the height of the road and its first three derivatives by time."""
    matrix = np.zeros((8, 8))
    matrix[0, 2] = matrix[1, 3] = 1
    matrix[2, :4] = np.array([-SPRING, SPRING, -DAMPER, DAMPER]) / BODY
    matrix[3, :5] = np.array([SPRING, -SPRING - TYRE, DAMPER, -DAMPER, TYRE]) / WHEEL
    matrix[4, 5] = matrix[5, 6] = matrix[6, 7] = 1
    step = expm(matrix * (SPACING / SPEED))
    y = np.zeros(4)
    for i in range(len(x) - 1):
        cubic, square, slope, value = spline.c[:, i]
        height = [value, slope * SPEED, 2 * square * SPEED**2, 6 * cubic * SPEED**3]
        y = (step @ np.concatenate([y, height]))[:4]
    return y


def main():
    x, heights = road()
    lines = ["# Height of a road, measured every 0.25 m; made by tools/quarter_car.py", "distance in m, height in m"]
    lines += [f"{a:.2f}, {b:.4f}" for a, b in zip(x, heights)]
    TARGET.parent.mkdir(exist_ok=True)
    TARGET.write_text("\n".join(lines) + "\n")
    spline = CubicSpline(x, heights, bc_type="natural")
    ways = by_runge_kutta(x, spline), by_exponentials(x, spline)
    error = np.abs(ways[0] - ways[1]) / np.maximum(np.abs(ways[1]), 1e-3)
    assert error.max() < 0.5 * 10.0**-DIGITS, error
    for name, value in zip(["body", "wheel", "body_dot", "wheel_dot"], ways[1]):
        print(f"{name:>10} {value:.13e}")
    acceleration = rates(spline)(x[-1] / SPEED, ways[1])[2]
    print(f"{'comfort':>10} {acceleration:.13e}")
    print("two ways differ by", error.max())


if __name__ == "__main__":
    main()
