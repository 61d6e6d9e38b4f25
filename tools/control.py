"""Reference motions of controlled systems for tests and examples.

    python3 tools/control.py            writes tests/references/control.csv (a minute)

Equations of motion, control laws and sampled controllers are handwritten below; nothing comes from this project. Motions
between two sampling instants of a controller are integrated by the extrapolated modified midpoint rule (Hairer, Norsett, Wanner,
*Solving Ordinary Differential Equations I*, section II.9) in multi-precision arithmetic. Everything is computed twice, with different
steps and orders, and written only if both agree to DIGITS digits. The columns are those of `tests/references/states.csv`; all numbers
are exact decimals.

- cart_pole: a cart that carries a pendulum, with friction in the joint, under a linear feedback.
- sampled_cart_pole: the same with the force held for 0.02 s.
- arm: two links whose controller assumes a wrong mass, on a path by computed torque (Spong, Hutchinson, Vidyasagar, *Robot
  Modeling and Control*, section 8.3).
- integral_cart_pole: the cart with the pendulum in wind, under a linear feedback with the integral of its position.
- motor_arm: an arm turned against gravity by a motor with inductance and a gear, with the supplied energy and the heat.
- dynamo: a weight that turns a dynamo, which feeds a resistor through a diode (Shockley's equation).
- pid: a mass with spring and damper, a sampled PID controller whose output saturates, and whose integral is then frozen
  (Astrom, Hagglund, *Advanced PID Control*, section 3.5).
"""

import csv
from pathlib import Path

from mpmath import cos, exp, log, mp, mpf, nstr, pi, sin

DIGITS = 20
RUNS = ((34, mpf("0.02"), 8), (40, mpf("0.0125"), 9))  # decimal digits, step, columns of the extrapolation
TARGET = Path(__file__).resolve().parent.parent / "tests" / "references" / "control.csv"


def midpoint(rates, t, y, step, count):
    """Applies the modified midpoint rule with its smoothing step, in an even number of parts."""
    h = step / count
    before, here = y, [a + h * b for a, b in zip(y, rates(t, y))]
    for k in range(1, count):
        before, here = here, [a + 2 * h * b for a, b in zip(before, rates(t + k * h, here))]
    end = rates(t + step, here)
    return [(a + b + h * c) / 2 for a, b, c in zip(before, here, end)]


def extrapolated(rates, t, y, step, columns):
    counts = [2 * (k + 1) for k in range(columns)]
    row = []
    for j, count in enumerate(counts):
        new = [midpoint(rates, t, y, step, count)]
        for k in range(1, j + 1):
            ratio = mpf(count) ** 2 / mpf(counts[j - k]) ** 2
            new.append([a + (a - b) / (ratio - 1) for a, b in zip(new[k - 1], row[k - 1])])
        row = new
    return row[-1]


def integrate(rates, y, start, end, step, columns):
    parts = max(1, int(mp.ceil((end - start) / step)))
    h = (end - start) / parts
    for k in range(parts):
        y = extrapolated(rates, start + k * h, y, h, columns)
    return y


def sampled(rates, controller, y, period, count, step, columns):
    """`rates(t, y, u)` with u = controller(t, y) held over each period."""
    for k in range(count):
        u = controller(k * period, y)
        y = integrate(lambda t, y: rates(t, y, u), y, k * period, (k + 1) * period, step, columns)
    return y


def cart_pole_rates(t, y, u):
    """T = (mc + mp) x'^2/2 + mp l x' th' cos th + mp l^2 th'^2/2, V = -mp g l cos th."""
    mc, m, l, c, g = mpf(1), mpf("0.1"), mpf("0.5"), mpf("0.01"), mpf("9.81")
    _, th, v, w = y
    a11, a12, a22 = mc + m, m * l * cos(th), m * l * l
    f1, f2 = u + m * l * w * w * sin(th), -m * g * l * sin(th) - c * w
    d = a11 * a22 - a12 * a12
    return [v, w, (a22 * f1 - a12 * f2) / d, (a11 * f2 - a12 * f1) / d]


def cart_pole_force(t, y):
    gains = [mpf(k) for k in ("1.8", "-30.8", "3.1", "-6.3")]
    return sum(k * d for k, d in zip(gains, [y[0], y[1] - pi, y[2], y[3]]))


def cart_pole(step, columns):
    start = [mpf(0), pi - mpf("0.3"), mpf(0), mpf(0)]
    return integrate(lambda t, y: cart_pole_rates(t, y, cart_pole_force(t, y)), start, mpf(0), mpf(10), step, columns)


def sampled_cart_pole(step, columns):
    start = [mpf(0), pi - mpf("0.3"), mpf(0), mpf(0)]
    return sampled(cart_pole_rates, cart_pole_force, start, mpf("0.02"), 250, step, columns)


def integral_cart_pole(step, columns):
    gains = [mpf(k) for k in ("4.7", "-39.7", "5.3", "-8.3", "1.6")]
    wind = mpf("0.3")

    def rates(t, y):
        x, th, integral, v, w = y
        u = sum(k * d for k, d in zip(gains, [x, th - pi, v, w, integral]))
        v, w, dv, dw = cart_pole_rates(t, [x, th, v, w], u + wind)
        return [v, w, x, dv, dw]

    return integrate(rates, [mpf(0), pi - mpf("0.2"), mpf(0), mpf(0), mpf(0)], mpf(0), mpf(5), step, columns)


def motor_arm(step, columns):
    """A rod of 1 kg and 0.5 m on a gear of 50 to 1, k = 0.05 Nm/A, R = 1.2 ohm, L = 50 mH, at 1 V from rest."""
    inertia = mpf(1) / 12 + 50**2 * mpf("1e-4")
    torque, r, inductance, c = 50 * mpf("0.05"), mpf("1.2"), mpf("0.05"), mpf("0.02")
    weight = mpf("9.81") / 4

    def rates(t, y):
        th, i, _, _, w = y
        return [w, (1 - r * i - torque * w) / inductance, i, r * i * i + c * w * w,
                (torque * i - c * w - weight * sin(th)) / inertia]

    return integrate(rates, [mpf(0)] * 5, mpf(0), mpf("0.5"), step, columns)


def diode_drop(emf, r, leak, thermal):
    """Returns the voltage across a diode in series with a resistor, by Newton's method until nothing changes."""
    drop = thermal * log(1 + max(emf, mpf(0)) / (r * leak))
    for _ in range(200):
        grown = exp(drop / thermal)
        step = (leak * (grown - 1) - (emf - drop) / r) / (leak * grown / thermal + 1 / r)
        drop -= step
        if abs(step) <= mpf(10) ** (5 - mp.dps) * (abs(drop) + thermal):
            return drop
    raise ArithmeticError(f"no drop of {emf} V")


def dynamo(step, columns):
    """A weight of 0.2 kg on a drum of 2 cm and 2 g m^2, k = 0.05 V s, R = 5 ohm, a diode of 1 nA and 50 mV, thrown up at 5 rad/s."""
    m, radius, drum, g = mpf("0.2"), mpf("0.02"), mpf("0.002"), mpf("9.81")
    k, r, leak, thermal = mpf("0.05"), mpf(5), mpf("1e-9"), mpf("0.05")

    def rates(t, y):
        w = y[2]
        current = (k * w - diode_drop(k * w, r, leak, thermal)) / r
        return [w, k * w * current, (m * g * radius - k * current) / (drum + m * radius * radius)]

    return integrate(rates, [mpf(0), mpf(0), mpf(-5)], mpf(0), mpf(3), step, columns)


def arm_dynamics(load, q1, q2, w1, w2):
    """Returns the mass matrix and the other forces of two links of 1 m with point masses at their ends, the second of them `load`. Angles
    are relative to each other, gravity is 9.81 m/s^2 downwards, and q1 = 0 is horizontal."""
    m1, m2, g = mpf("1.5"), load, mpf("9.81")
    c2, s2 = cos(q2), sin(q2)
    m = [[m1 + 2 * m2 + 2 * m2 * c2, m2 + m2 * c2], [m2 + m2 * c2, m2]]
    h = [
        -m2 * s2 * (2 * w1 * w2 + w2 * w2) + (m1 + m2) * g * cos(q1) + m2 * g * cos(q1 + q2),
        m2 * s2 * w1 * w1 + m2 * g * cos(q1 + q2),
    ]
    return m, h


def arm_torques(t, y):
    q1, q2, w1, w2 = y
    path = [sin(t) / 2, 3 * cos(2 * t) / 10]
    rate = [cos(t) / 2, -6 * sin(2 * t) / 10]
    acceleration = [-sin(t) / 2, -12 * cos(2 * t) / 10]
    wanted = [a + 16 * (v - w) + 64 * (p - q)
              for a, v, w, p, q in zip(acceleration, rate, (w1, w2), path, (q1, q2))]
    m, h = arm_dynamics(mpf(1), q1, q2, w1, w2)
    return [m[i][0] * wanted[0] + m[i][1] * wanted[1] + h[i] for i in range(2)]


def arm_rates(t, y):
    q1, q2, w1, w2 = y
    m, h = arm_dynamics(mpf("1.25"), q1, q2, w1, w2)
    f = [u - h for u, h in zip(arm_torques(t, y), h)]
    d = m[0][0] * m[1][1] - m[0][1] * m[1][0]
    return [w1, w2, (m[1][1] * f[0] - m[0][1] * f[1]) / d, (m[0][0] * f[1] - m[1][0] * f[0]) / d]


def arm(step, columns):
    return integrate(arm_rates, [mpf(0), mpf(0), mpf(0), mpf(0)], mpf(0), mpf(5), step, columns)


class Pid:
    def __init__(self):
        self.integral = mpf(0)

    def __call__(self, t, y):
        error = mpf(1) - y[0]
        wanted = 40 * error + self.integral - 8 * y[1]
        force = min(max(wanted, mpf(-15)), mpf(15))
        if force == wanted:
            self.integral += 60 * mpf("0.05") * error
        return force


def pid(step, columns):
    m, c, k = mpf(2), mpf("0.5"), mpf(10)
    rates = lambda t, y, u: [y[1], (u - c * y[1] - k * y[0]) / m]
    return sampled(rates, Pid(), [mpf(0), mpf(0)], mpf("0.05"), 120, step, columns)


CASES = {
    "cart_pole": (cart_pole, "10.0", ["x", "theta"]),
    "sampled_cart_pole": (sampled_cart_pole, "5.0", ["x", "theta"]),
    "arm": (arm, "5.0", ["q1", "q2"]),
    "pid": (pid, "6.0", ["x"]),
    "integral_cart_pole": (integral_cart_pole, "5.0", ["x", "theta"], ["integral"]),
    "motor_arm": (motor_arm, "0.5", ["theta"], ["current", "supplied", "heat"]),
    "dynamo": (dynamo, "3.0", ["theta"], ["heat"]),
}


def main():
    rows = []
    for name, (case, time, coordinates, *states) in CASES.items():
        results = []
        for digits, step, columns in RUNS:
            with mp.workdps(digits):
                results.append(case(step, columns))
        components = [*coordinates, *sum(states, []), *(f"{coordinate}_dot" for coordinate in coordinates)]
        for component, one, other in zip(components, *results):
            if abs(one - other) > mpf(10) ** -DIGITS * max(1, abs(other)):
                raise ArithmeticError(f"{name}: {component} is {one} or {other}")
            rows.append([f"controlled_{name}", "decimal", time, component, nstr(other, DIGITS, strip_zeros=False)])
        print(name, [nstr(value, 15) for value in results[1]], flush=True)
    with TARGET.open("w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["case", "numbers", "time", "component", "value"])
        writer.writerows(rows)


if __name__ == "__main__":
    main()
