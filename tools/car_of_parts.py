"""Reference motion of the car in `tests/api/car.rs`.

    python3 tools/car_of_parts.py        prints the shift, and the final state (a minute)

An engine with a map drives the rear wheels of a car on four struts, through a clutch, two gears and a differential. The equations are
handwritten. SciPy's DOP853 restarts where the clutch sticks or slips, and at the shift. The state is printed if two tolerances agree
to DIGITS digits.
"""

import numpy as np
from scipy.interpolate import CubicSpline
from scipy.integrate import solve_ivp

DIGITS = 11
END = 5.0
MASS, PITCH, ROLL, GRAVITY, HEIGHT = 1200.0, 1500.0, 500.0, 9.81, 0.4
ENGINE, WHEEL, RADIUS = 0.2, 1.2, 0.3
RATIOS, SHIFT, CAPACITY = (11.0, 6.0), 300.0, 130.0
STIFFNESS, DAMPING, LENGTH = 20000.0, 1500.0, 0.5
ALONG, ACROSS = np.array([1.2, 1.2, -1.3, -1.3]), np.array([0.7, -0.7, 0.7, -0.7])
GRIP, SOFTNESS = (0.8, 0.7), 0.5
SPEEDS, THROTTLES = [50.0, 200.0, 350.0, 500.0], [0.0, 0.5, 1.0]
TORQUES = [[-5.0, 50.0, 70.0], [-10.0, 65.0, 100.0], [-18.0, 60.0, 105.0], [-30.0, 40.0, 80.0]]
START = [0.0, 0.36, 0.01, 0.02, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 100.0, 1.0 / RADIUS, 1.0 / RADIUS]

ROWS = [CubicSpline(THROTTLES, row, bc_type="natural") for row in TORQUES]


def torque(speed, throttle):
    return float(CubicSpline(SPEEDS, [float(row(throttle)) for row in ROWS], bc_type="natural")(speed))


def loads(y):
    _, z, pitch, roll = y[:4]
    _, z_dot, pitch_dot, roll_dot = y[7:11]
    heights = z - ALONG * pitch + ACROSS * roll
    rates = z_dot - ALONG * pitch_dot + ACROSS * roll_dot
    return STIFFNESS * (LENGTH - heights) - DAMPING * rates


def pushes(y):
    on = loads(y)[2:]
    slips = RADIUS * y[12:14] - y[7]
    return [grip * load * np.tanh(slip / SOFTNESS) for grip, load, slip in zip(GRIP, on, slips)]


def drive(t, y):
    return torque(y[11], 1.0 - np.exp(-t / 0.3))


def held(t, y, ratio):
    """Returns the moment with which the clutch sticks."""
    resistance = RADIUS * sum(pushes(y))
    return (drive(t, y) / ENGINE + ratio * resistance / (2 * WHEEL)) / (1 / ENGINE + ratio**2 / (2 * WHEEL))


def slip(y, ratio):
    return y[11] - ratio * (y[12] + y[13]) / 2


def rates(side, ratio):
    """Returns the rates; `side` is the sign of the slip, or 0 if the clutch sticks."""

    def of(t, y):
        on, push = loads(y), pushes(y)
        moment = CAPACITY * side if side else held(t, y, ratio)
        accelerations = [
            sum(push) / MASS,
            on.sum() / MASS - GRAVITY,
            (-(ALONG * on).sum() - HEIGHT * sum(push)) / PITCH,
            (ACROSS * on).sum() / ROLL,
            (drive(t, y) - moment) / ENGINE,
            (ratio * moment / 2 - RADIUS * push[0]) / WHEEL,
            (ratio * moment / 2 - RADIUS * push[1]) / WHEEL,
        ]
        return np.concatenate([y[7:], accelerations])

    return of


def terminal(function, direction):
    function.terminal, function.direction = True, direction
    return function


def motion(tolerance):
    t, y, gear, side, changes = 0.0, np.array(START), 0, 1, []
    while t < END:
        ratio = RATIOS[gear]
        upshift = terminal(lambda t, y: y[11] - SHIFT if gear == 0 else 1.0, 1)
        if side:
            change = terminal(lambda t, y: slip(y, ratio), -side)
        else:
            change = terminal(lambda t, y: abs(held(t, y, ratio)) - CAPACITY, 1)
        run = solve_ivp(rates(side, ratio), (t, END), y, method="DOP853", rtol=tolerance, atol=tolerance * 1e-2,
                        events=[upshift, change])
        t, y = run.t[-1], run.y[:, -1]
        if len(run.t_events[0]):
            changes.append((t, "shift"))
            gear = 1
            side = np.sign(slip(y, RATIOS[gear]))
        elif len(run.t_events[1]):
            moment = held(t, y, ratio)
            side = np.sign(moment) if not side or abs(moment) > CAPACITY else 0
            changes.append((t, "slips" if side else "sticks"))
    return y, changes


def main():
    (first, changes), (second, _) = motion(2.3e-14), motion(1e-12)
    difference = np.max(np.abs(first - second) / np.maximum(1, np.abs(first)))
    print(changes, "difference", difference)
    assert difference < 10.0**-DIGITS
    print(", ".join(f"{value:.{DIGITS + 2}e}" for value in first))


if __name__ == "__main__":
    main()
