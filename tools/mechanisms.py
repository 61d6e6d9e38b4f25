"""Reference motions of mechanisms with 30 digits, without constraints, multipliers or accelerations.

    python3 tools/mechanisms.py            writes tests/references/mechanisms.csv (a few minutes)
    python3 tools/mechanisms.py NAME...    computes only these cases and keeps the others

- A mechanism with one degree of freedom and no losses has T = I(s) s'^2/2, so its energy gives time as a quadrature,
  t = integral of sqrt(I/(2 (E - V))) ds (Landau, Lifshitz, *Mechanics*, section 11). Other coordinates follow
  from s by geometry: circles that meet, right triangles.
- A sleigh on a blade: its body velocities in closed form (Neimark, Fufaev, *Dynamics of Nonholonomic Systems*),
  its position by quadrature.
- A disk that rolls on a plane: Newton's and Euler's equations in the frame of its axis and its track, with the ground forces
  eliminated by hand, and Taylor's method of `tools/references.py`.

Everything is computed twice with different numbers of digits, and written only if both agree to DIGITS + 1 digits. The columns
are those of `tests/references/states.csv`; times are nearest numbers of 53 bits for the column `binary`.
"""

import csv
import sys
from pathlib import Path

from mpmath import asin, atan2, cos, floor, mp, mpf, nstr, pi, quad, sech, sin, sqrt, tanh

from references import DIGITS, converter, names, rounded, taylor

ACCURACIES = (44, 52)  # decimal digits of the arithmetic
TARGET = Path(__file__).resolve().parent.parent / "tests" / "references" / "mechanisms.csv"


def panels(function, start, end, size):
    """Integrates an analytic function over panels of at most `size`."""
    count = max(1, int(mp.ceil(abs(end - start) / size)))
    points = [start + (end - start) * k / count for k in range(count + 1)]
    return quad(function, points)


class OneFreedom:
    """A motion in which s turns continuously: 2 E = inertia(s) s'^2 + 2 potential(s)."""

    def __init__(self, inertia, potential, start, rate):
        self.inertia, self.potential, self.start = inertia, potential, start
        self.sign = 1 if rate > 0 else -1
        self.energy = inertia(start) * rate**2 / 2 + potential(start)
        self.turn = self.time(self.sign * 2 * pi)

    def rate(self, s):
        return self.sign * sqrt(2 * (self.energy - self.potential(s)) / self.inertia(s))

    def time(self, travelled):
        return panels(lambda s: 1 / self.rate(s), self.start, self.start + travelled, pi / 8)

    def at(self, t):
        """Returns s and its rate, by counting whole turns and Newton's method for the remainder."""
        turns = floor(t / self.turn)
        rest = t - turns * self.turn
        s = self.sign * 2 * pi * rest / self.turn
        for _ in range(60):
            change = (rest - self.time(s)) * self.rate(self.start + s)
            s += change
            if abs(change) < mpf(10) ** (4 - mp.dps):
                s += self.start + self.sign * 2 * pi * turns
                return s, self.rate(s)
        raise ArithmeticError("no place is found")


def four_bar(of):
    """Crank 0.1, coupler 0.3, rocker 0.3, ground 0.4 m; uniform bars of 10 kg/m; gravity."""
    a, b, c, d, g = (of(x) for x in ("0.1", "0.3", "0.3", "0.4", "9.81"))
    m1, m2, m3 = mpf(1), mpf(3), mpf(3)

    def angles(s):
        """Returns the angles of coupler and rocker: their joint is the intersection of two circles above the line of their centres."""
        x, y = a * cos(s), a * sin(s)
        dx, dy = d - x, -y
        squared = dx * dx + dy * dy
        along = (squared + b * b - c * c) / (2 * squared)
        across = sqrt(b * b / squared - along * along)
        jx, jy = along * dx - across * dy, along * dy + across * dx
        return atan2(jy, jx), atan2(y + jy, x + jx - d)

    def ratios(s):
        """Returns the rates of the angles of coupler and rocker per rate of the crank, from the velocity of the joint along either bar."""
        p, r = angles(s)
        return a * sin(r - s) / (b * sin(p - r)), a * sin(p - s) / (c * sin(p - r))

    def inertia(s):
        (p, _), (k2, k3) = angles(s), ratios(s)
        middle = (a * sin(s) + b / 2 * k2 * sin(p)) ** 2 + (a * cos(s) + b / 2 * k2 * cos(p)) ** 2
        return m1 * a**2 / 3 + m2 * (middle + b**2 / 12 * k2**2) + m3 * c**2 / 3 * k3**2

    def potential(s):
        p, r = angles(s)
        return g * (m1 * a / 2 * sin(s) + m2 * (a * sin(s) + b / 2 * sin(p)) + m3 * c / 2 * sin(r))

    motion = OneFreedom(inertia, potential, mpf(0), mpf(30))

    def state(t):
        s, rate = motion.at(t)
        (p, r), (k2, k3) = angles(s), ratios(s)
        return [s, p, r, rate, k2 * rate, k3 * rate]

    return state, motion.turn


def n_four_bar(of):
    """Forty windows of bars of 1 m and 1 kg with parallel cranks; upright, the upper joints move at 1 m/s."""
    windows, g = 40, of("9.81")
    inertia = mpf(windows + 1) / 3 + windows
    weight = g * (mpf(windows + 1) / 2 + windows)
    motion = OneFreedom(lambda s: inertia, lambda s: weight * sin(s), pi / 2, mpf(-1))

    def state(t):
        s, rate = motion.at(t)
        return [s, rate]

    return state, motion.turn


def sleigh(of):
    """m = 1.2, j = 0.3, centre of mass 0.4 ahead of the blade; at rest except for a rotation at 2 rad/s."""
    m, j, a = of("1.2"), of("0.3"), of("0.4")
    turning = mpf(2)
    about_blade = j + m * a * a
    fastest = turning * sqrt(about_blade / m)
    pace = a * turning**2 / fastest

    def heading(t):
        return 2 * turning / pace * mp.atan(tanh(pace * t / 2))

    def speed(t):
        return fastest * tanh(pace * t)

    def state(t):
        x, y = (panels(lambda s: speed(s) * f(heading(s)), mpf(0), t, mpf(1) / 2) for f in (cos, sin))
        angle, u = heading(t), speed(t)
        return [x, y, angle, u * cos(angle), u * sin(angle), turning * sech(pace * t)]

    return state, None


def ladder(of):
    """l = 3; at rest at 60 degrees to the floor. The angle falls until the ladder leaves the wall at 2/3 of its height."""
    l, g = of("3"), of("9.81")
    start = of(nstr(pi / 3, 60))
    end = asin(2 * sin(start) / 3)
    # With angle = start - u^2 the square root at the start vanishes, and differences of sines are products.
    slope = lambda u: cos(start - u * u / 2) * mp.sinc(u * u / 2)
    leaving = panels(lambda u: 2 / sqrt(3 * g / l * slope(u)), mpf(0), sqrt(start - end), mpf(1) / 8)
    # Afterwards the centre moves sideways at a constant speed; the rest of the energy rotates and drops the ladder.
    sideways = sqrt(g * l * sin(start) ** 3) / 3
    rate = lambda s: sqrt((g * l * sin(start) - sideways**2 - g * l * sin(s)) / (l * l * (cos(s) ** 2 / 4 + mpf(1) / 12)))
    landing = leaving + panels(lambda s: 1 / rate(s), mpf(0), end, mpf(1) / 8)
    return [leaving, end, rate(end), landing, rate(mpf(0)), sideways]


def rolling_disk(of):
    """m = r = 1, A = 1/4, C = 1/2. State: x y phi theta psi and, instead of rates, angular velocities 1 2 3."""
    g, inertia, axial = of("9.81"), mpf(1) / 4, mpf(1) / 2

    def build(x):
        turn, tilt, own = 5, 6, 7  # about the track, about the line to the centre, about the axis
        s_tilt, c_tilt = x.sin_cos(3)
        s_head, c_head = x.sin_cos(2)
        phi_dot = x.quotient(tilt, s_tilt)
        about_axis = x.product(phi_dot, c_tilt)
        psi_dot = x.linear((1, own), (-1, about_axis))
        pull = x.linear((inertia, x.product(about_axis, tilt)), (-(axial + 1), x.product(tilt, own)), (-g, c_tilt))
        lean = x.linear((axial / inertia, x.product(turn, own)), (-1, x.product(turn, about_axis)))
        return [
            x.linear((-1, x.product(psi_dot, c_head))),
            x.linear((-1, x.product(psi_dot, s_head))),
            phi_dot,
            x.linear((1, turn)),
            psi_dot,
            x.linear((1 / (inertia + 1), pull)),
            lean,
            x.linear((1 / (axial + 1), x.product(turn, tilt))),
        ]

    start = [mpf(0), mpf(0), mpf(0), of("1.2"), mpf(0)]
    phi_dot, theta_dot, psi_dot = mpf(1) / 2, mpf(0), mpf(-4)
    s, c = sin(start[3]), cos(start[3])
    start += [theta_dot, phi_dot * s, phi_dot * c + psi_dot]

    def state(t):
        order = mp.dps + 2
        ((x, y, phi, theta, psi, turn, tilt, own),), _ = taylor(build, start, [t], order)
        phi_dot = tilt / sin(theta)
        psi_dot = own - phi_dot * cos(theta)
        return [x, y, phi, theta, psi, -psi_dot * cos(phi), -psi_dot * sin(phi), phi_dot, turn, psi_dot]

    return state, None


# name, components, times; "turn N" is the end of that many periods
CASES = {
    "four_bar": (four_bar, names("crank", "coupler", "rocker"), ["0", "1", "turn 1", "turn 1000"]),
    "n_four_bar": (n_four_bar, names("crank"), ["0", "1", "10", "turn 1"]),
    "chaplygin_sleigh": (sleigh, names("x", "y", "theta"), ["0", "1", "10"]),
    "rolling_disk": (rolling_disk, names("x", "y", "phi", "theta", "psi"), ["0", "1", "10"]),
    "ladder": (ladder, ["leaving", "angle_leaving", "rate_leaving", "landing", "rate_landing", "sideways"], None),
}


def times_of(texts, turn, numbers):
    """Returns end times; those of the column `binary` are numbers of 53 bits."""
    for text in texts:
        t = turn * int(text.split()[1]) if text.startswith("turn") else mpf(text)
        yield mpf(float(t)) if numbers == "binary" else t


def rows_of(case, numbers):
    """Returns times with their components."""
    system, _, texts = CASES[case]
    found = system(converter(numbers))
    if texts is None:
        return [(mpf(0), found)]
    state, turn = found
    return [(t, state(t)) for t in times_of(texts, turn, numbers)]


def checked(case, numbers):
    """Returns the rows, if two computations agree."""
    results = []
    for digits in ACCURACIES:
        mp.dps = digits
        results.append(rows_of(case, numbers))
    off = max(abs(a - b) / (1 + abs(b)) for (_, xs), (_, ys) in zip(*results) for a, b in zip(xs, ys))
    print(f"{case:<18} {numbers:<8} apart by {nstr(off, 2)}", flush=True)
    assert off < mpf(10) ** (-DIGITS - 1), "the two computations do not agree"
    return results[1]


def kept():
    """Returns the rows of the table, by case."""
    rows = {}
    if TARGET.exists():
        with TARGET.open(newline="") as file:
            for row in list(csv.reader(file))[1:]:
                rows.setdefault(row[0], []).append(row)
    return rows


def main():
    rows = kept()
    for case in sys.argv[1:] or CASES:
        rows[case] = [
            [case, numbers, nstr(t, 40), name, rounded(value)]
            for numbers in ("decimal", "binary")
            for t, state in checked(case, numbers)
            for name, value in zip(CASES[case][1], state)
        ]
    with TARGET.open("w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["case", "numbers", "time", "component", "value"])
        for case in CASES:
            writer.writerows(rows.get(case, []))


if __name__ == "__main__":
    main()
