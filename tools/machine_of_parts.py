"""Reference motion of the machine in `tests/api/parts.rs`.

    python3 tools/machine_of_parts.py        prints the final state (a few seconds)

A motor with a controller turns a drum through a gear with backlash, with an angle filter in the loop. The equations are handwritten.
SciPy's DOP853 restarts wherever the teeth touch or separate, since the moment jumps there; events are located to rounding. The state
is printed if two tolerances agree to DIGITS digits.
"""

import numpy as np
from scipy.integrate import solve_ivp

DIGITS = 11
END = 2.0
ROTOR, DRUM, BEARING, TARGET = 0.002, 0.5, 0.2, 1.0
RESISTANCE, INDUCTANCE, CONSTANT = 1.0, 0.01, 0.05
RATIO, STIFFNESS, DAMPING, BACKLASH = 10.0, 400.0, 0.5, 0.02
KP, KI, KD, FILTER, SENSOR = 40.0, 5.0, 2.0, 0.02, 0.05


def twist(y):
    return y[0] / RATIO - y[1]


def rates(side):
    """Returns the rates; `side` is 1, 0 or -1, for the flanks in contact, if any."""

    def of(t, y):
        phi, theta, measured, integral, smoothed, current, phi_dot, theta_dot = y
        error = TARGET - measured
        voltage = KP * error + KI * integral + KD * (error - smoothed) / FILTER
        moment = 0.0
        if side:
            moment = STIFFNESS * (twist(y) - side * BACKLASH / 2) + DAMPING * (phi_dot / RATIO - theta_dot)
        return [
            phi_dot,
            theta_dot,
            (theta - measured) / SENSOR,
            error,
            (error - smoothed) / FILTER,
            (voltage - RESISTANCE * current - CONSTANT * phi_dot) / INDUCTANCE,
            (CONSTANT * current - moment / RATIO) / ROTOR,
            (moment - BEARING * theta_dot) / DRUM,
        ]

    return of


def surfaces(side):
    """Returns the flanks that the twist can reach from this side."""
    found = []
    for flank, other in ((1, 1), (-1, -1)):
        if side in (0, flank):

            def surface(t, y, flank=flank):
                return twist(y) - flank * BACKLASH / 2

            surface.terminal = True
            surface.direction = flank if side == 0 else -flank
            found.append((surface, other if side == 0 else 0))
    return found


def motion(tolerance):
    t, y, side, crossings = 0.0, np.zeros(8), 0, 0
    while t < END:
        known = surfaces(side)
        run = solve_ivp(
            rates(side), (t, END), y, method="DOP853", rtol=tolerance, atol=tolerance * 1e-3, max_step=0.005,
            events=[surface for surface, _ in known],
        )
        t, y = run.t[-1], run.y[:, -1]
        for (_, after), times in zip(known, run.t_events):
            if len(times):
                side, crossings = after, crossings + 1
    return y, crossings


def main():
    (first, crossings), (second, _) = motion(2.3e-14), motion(1e-12)
    difference = np.max(np.abs(first - second) / np.maximum(1, np.abs(first)))
    print(crossings, "crossings, difference", difference)
    assert difference < 10.0**-DIGITS
    print(", ".join(f"{value:.{DIGITS + 2}e}" for value in first))


if __name__ == "__main__":
    main()
