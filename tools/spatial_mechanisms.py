"""Reference motions of mechanisms in space, without constraints, multipliers or kinematics in body axes.

    python3 tools/spatial_mechanisms.py            writes tests/references/spatial_mechanisms.csv (some minutes)
    python3 tools/spatial_mechanisms.py NAME...    computes only these cases and keeps the others

- bricard: five rods and six revolute joints (benchmark A04 of the IFToMM library of González, Dopico, Naya and Cuadrado, *A benchmarking
  system for MBS simulation software*, Multibody System Dynamics 16, 2006). The angles between neighbours are a, b, a, b, a, b with
  2 cos(a/2) cos(b/2) = 1 (Chen, You, Tarnai, *Threefold-symmetric Bricard linkages for deployable structures*, International Journal of
  Solids and Structures 42, 2005: cos a + cos b + cos a cos b = 0 at right twists). That curve is closed and has a smooth parameter p;
  T = I(p) p'^2/2, so energy gives time as a quadrature. The mechanism swings between two positions of rest, where
  p = middle - half cos(x) removes the roots from the integrand; its Fourier series is integrated term by term. Every written
  position is asserted to close all joints.
  x, y, z are those of P3, where second and third rod meet; they lie on the published curves as far as these can be read.
- slider_crank: a crank about the x axis, a rod with a ball joint and a universal joint, a slider along the x axis (the spatial slider-crank
  of the IFToMM library, after Haug, *Computer-Aided Kinematics and Dynamics of Mechanical Systems*, 1989). The crank turns
  continuously; time is a quadrature again. Angles of the universal joint follow from the position of the crank's end.
- governor: the stiff flyball governor (benchmark A05). The angular momentum about the axis is conserved, which leaves two degrees of
  freedom, the angle of the rods and the height of the slider. Their Lagrange equations are handwritten, and solved by Taylor's method of `tools/references.py`.
  The height lies on the published curve as far as that can be read.

Everything is computed twice with different numbers of digits, and written only if both agree to DIGITS + 1 digits. The columns
are those of `tests/references/states.csv`; times are nearest numbers of 53 bits for the column `binary`.
"""

import csv
import sys
from pathlib import Path

from mpmath import asin, atan2, cos, floor, mp, mpf, nstr, pi, sin, sqrt

import newton_euler as ne
from mechanisms import OneFreedom, times_of
from newton_euler import Series
from references import converter, taylor

DIGITS = 20
ACCURACIES = (32, 38)  # decimal digits of the arithmetic
TERMS = 96  # of the Fourier series
TARGET = Path(__file__).resolve().parent.parent / "tests" / "references" / "spatial_mechanisms.csv"


def cuboid(m, a, b, c):
    """Returns principal moments."""
    return [m * (b * b + c * c) / 12, m * (c * c + a * a) / 12, m * (a * a + b * b) / 12]


class Swing:
    """A motion in which p swings between rest at `start` and rest at `end`: 2 E = inertia(p) p'^2 + 2 potential(p)."""

    def __init__(self, inertia, potential, start, end, count):
        self.middle, self.half = (start + end) / 2, (end - start) / 2
        energy = (potential(start) + potential(end)) / 2

        def slope(x):
            """dt/dx"""
            p = self.middle - self.half * cos(x)
            return abs(self.half) * sin(x) * sqrt(inertia(p) / (2 * (energy - potential(p))))

        nodes = [(k + mpf(1) / 2) * pi / count for k in range(count)]
        values = [slope(x) for x in nodes]
        self.terms = [mp.fdot(values, [cos(j * x) for x in nodes]) * 2 / count for j in range(count)]
        self.terms[0] /= 2
        self.turn = 2 * pi * self.terms[0]

    def time(self, x):
        return self.terms[0] * x + mp.fsum(c * sin(j * x) / j for j, c in enumerate(self.terms) if j)

    def rate(self, x):
        return 1 / mp.fsum(c * cos(j * x) for j, c in enumerate(self.terms))

    def at(self, t):
        """Returns p and its rate."""
        turns = floor(t / self.turn)
        rest = t - turns * self.turn
        x = 2 * pi * rest / self.turn
        for _ in range(60):
            change = (rest - self.time(x)) * self.rate(x)
            x += change
            if abs(change) < mpf(10) ** (4 - mp.dps):
                return self.middle - self.half * cos(x), self.half * sin(x) * self.rate(x)
        raise ArithmeticError("no place is found")


# Joints in order: axis, and direction of the rod behind it; the last rod is the ground. Initially all axes are parallel to those of the world.
X, Y, Z = [1, 0, 0], [0, 1, 0], [0, 0, 1]
BRICARD = [(Y, X), (Z, ne.times(-1, Y)), (X, Z), (Y, ne.times(-1, X)), (Z, Y), (X, ne.times(-1, Z))]


def bricard_angles(p):
    """Returns the angles of the six joints and their slopes, zero at p = pi/4: sin(a/2) = r cos p, sin(b/2) = r sin p."""
    s, c = sin(2 * p), cos(2 * p)
    root = sqrt(1 - 3 * s * s / 4)
    squared = mpf(3) / 2 / (1 + root)
    r = sqrt(squared)
    slope = mpf(3) / 2 * (3 * s * c / (2 * root)) / (1 + root) ** 2 / (2 * r)
    a, b = (pi / 2 - 2 * asin(r * f(p)) for f in (cos, sin))
    rate = lambda half, change: -2 * change / sqrt(1 - half**2)
    rates = rate(r * cos(p), slope * cos(p) - r * sin(p)), rate(r * sin(p), slope * sin(p) + r * cos(p))
    return [a, b] * 3, [*rates] * 3


def bricard_frames(angles, slopes):
    """Returns the frames behind the six joints as functions of p."""
    pose, frames = ne.translation(0, 0, 0), []
    for (axis, along), angle, slope in zip(BRICARD, angles, slopes):
        pose = ne.product(pose, ne.turned(axis, Series(angle, slope)))
        frames.append(ne.Placed(pose))
        pose = ne.product(pose, ne.translation(*along))
    return frames + [ne.Placed(pose)]


def bricard(of):
    """Rods of 1 m and 1 kg with a square section of 0.1 m, along the edges of a cube; at rest, gravity along -y."""
    g, m, d = of("9.81"), mpf(1), of("0.1")

    def frames(p):
        return bricard_frames(*bricard_angles(p))

    def inertia(p):
        total = mpf(0)
        for (_, along), frame in zip(BRICARD[:5], frames(p)):
            moments = [m * (d * d if axis else (1 + d * d) / 2) / 6 for axis in along]
            own = ne.applied(ne.transposed(frame.rotations[0]), frame.angular_velocity())
            v = frame.point(ne.times(mpf(1) / 2, along), 1)
            total += m * ne.dot(v, v) + sum(i * w * w for i, w in zip(moments, own))
        return total

    def potential(p):
        return sum(m * g * frame.point(ne.times(mpf(1) / 2, along), 0)[1] for (_, along), frame in zip(BRICARD[:5], frames(p)))

    assert abs(potential(pi / 4) - potential(3 * pi / 4)) < mpf(10) ** (4 - mp.dps)
    motion = Swing(inertia, potential, pi / 4, 3 * pi / 4, TERMS)

    def state(t):
        p, rate = motion.at(t)
        (angles, slopes), placed = bricard_angles(p), frames(p)
        assert_closed(placed[-1])
        place, slope = (placed[2].point([0, 0, 0], order) for order in (0, 1))
        return [*angles[:5], *place, *(rate * x for x in (*slopes[:5], *slope))]

    return state, motion.turn


def assert_closed(frame):
    """Asserts that the chain of rods closes at the ground."""
    off = [x - y for row, unit in zip(frame.rotations[0], ne.IDENTITY) for x, y in zip(row, unit)]
    assert max(abs(x) for x in (*off, *frame.places[0])) < mpf(10) ** (4 - mp.dps)


def slider_crank(of):
    """Crank 0.08, rod 0.3 m; the axis of the crank is 0.1 m beside and 0.12 m above that of the slider; 6 rad/s upright, gravity along -z."""
    crank, rod, beside, above, g = (of(x) for x in ("0.08", "0.3", "0.1", "0.12", "9.81"))
    m2, m3, i1 = of("0.5"), mpf(2), of("1e-4")
    ix, iy, iz = of("4e-4"), of("4e-3"), of("4e-3")

    def place(s):
        """Returns the end of the crank and its slopes, and the slider."""
        y, z, y1, z1 = beside - crank * sin(s), above + crank * cos(s), -crank * cos(s), -crank * sin(s)
        return y, z, y1, z1, sqrt(rod**2 - y * y - z * z)

    def slopes(s):
        """Returns slopes of the slider's position and of the angles of the universal joint."""
        y, z, y1, z1, x = place(s)
        squared, along = y * y + z * z, y * y1 + z * z1
        return -along / x, (y * z1 - y1 * z) / squared, along / sqrt(squared) / x

    def inertia(s):
        (y, z, y1, z1, x), (x1, a1, b1) = place(s), slopes(s)
        squared = y * y + z * z
        spins = ix * (a1 * x / rod) ** 2 + iy * b1**2 + iz * a1**2 * squared / rod**2
        return i1 + m3 * x1**2 + m2 * (x1**2 + y1**2 + z1**2) / 4 + spins

    motion = OneFreedom(inertia, lambda s: m2 * g * place(s)[1] / 2, mpf(0), mpf(6))

    def state(t):
        s, rate = motion.at(t)
        y, z, _, _, x = place(s)
        angles = [s, x, atan2(-y, z), atan2(sqrt(y * y + z * z), x)]
        return [*angles, rate, *(rate * slope for slope in slopes(s))]

    return state, motion.turn


def governor(of):
    """Rods of 1 m on a shaft of 1 m with balls of 5 kg, each connected in its middle by a spring and a damper to a slider of 3 kg; 2 pi rad/s."""
    g, e, k, damping = of("9.81"), of("0.05"), mpf(800000), mpf(40000)
    m, ball, slider, half, rest = of("0.3"), mpf(5), mpf(3), mpf(1) / 2, mpf(1) / 2
    along, across, _ = cuboid(m, 1, of("0.01"), of("0.01"))
    fixed = 2 * m * of("0.01") ** 2 / 12 + 2 * slider * of("0.1") ** 2 / 12
    about_joint = across + m * half**2 + ball
    start = of(nstr(pi / 6, 60))

    def about_shaft(c, s):
        return fixed + 2 * (m * (e + half * c) ** 2 + across * c * c + along * s * s + ball * (e + c) ** 2)

    momentum = about_shaft(cos(start), sin(start)) * of(nstr(2 * pi, 60))

    def build(x):
        angle, height, angle1, height1 = 1, 2, 3, 4
        s, c = x.sin_cos(angle)
        cc, cs = x.product(c, c), x.product(c, s)
        # J = J0 + J1 c + J2 c^2 about the shaft, and its slope by the angle.
        j0 = fixed + 2 * (m * e * e + along + ball * e * e)
        j1, j2 = 4 * e * (m * half + ball), 2 * (m * half**2 + across - along + ball)
        inertia = x.linear((j1, c), (j2, cc), constant=j0)
        one = x.linear(constant=1)
        inverse = x.quotient(one, inertia)
        spin = x.linear((momentum, inverse))
        slope = x.linear((-j1, s), (-2 * j2, cs))
        # The spring from the middle of a rod to the slider.
        outwards, upwards = x.linear((half, c)), x.linear((-half, s), (-1, height), constant=1)
        length = x.power(x.linear((1, x.product(outwards, outwards)), (1, x.product(upwards, upwards))), half)
        by_angle = x.linear((-half, x.product(outwards, s)), (-half, x.product(upwards, c)))
        rate = x.linear((1, x.product(by_angle, angle1)), (-1, x.product(upwards, height1)))
        # Its force by its length is k (1 - rest/l) + damping l' / l, with l l' = rate.
        inverse_length = x.quotient(one, length)
        stretched = x.product(x.product(rate, inverse_length), inverse_length)
        tension = x.linear((-k * rest, inverse_length), (damping, stretched), constant=k)
        lift = x.product(x.product(spin, spin), slope)
        return [
            spin,
            x.linear((1, angle1)),
            x.linear((1, height1)),
            x.linear(
                (1 / (4 * about_joint), lift),
                (g * (m * half + ball) / about_joint, c),
                (-1 / about_joint, x.product(tension, by_angle)),
            ),
            x.linear((2 / slider, x.product(tension, upwards)), constant=-g),
        ]

    def state(t):
        order = mp.dps + 2
        ((turn, angle, height, angle1, height1),), _ = taylor(build, [mpf(0), start, half, mpf(0), mpf(0)], [t], order)
        spin = momentum / about_shaft(cos(angle), sin(angle))
        return [turn, height, angle, angle, spin, height1, angle1, angle1]

    return state, None


# name, components, times; "turn N" is the end of that many periods
CASES = {
    "bricard": (bricard, ["q1", "q2", "q3", "q4", "q5", "x", "y", "z"], ["1", "9.5", "10"]),
    "spatial_slider_crank": (slider_crank, ["crank", "x", "a", "b"], ["0", "1", "20"]),
    "governor": (governor, ["turn", "s", "right", "left"], ["0", "0.1", "1", "10"]),
}


def checked(case, numbers):
    """Returns times with their components, if two computations agree."""
    system, _, texts = CASES[case]
    results = []
    for digits in ACCURACIES:
        mp.dps = digits
        state, turn = system(converter(numbers))
        results.append([(t, state(t)) for t in times_of(texts, turn, numbers)])
    off = max(abs(a - b) / (1 + abs(b)) for (_, xs), (_, ys) in zip(*results) for a, b in zip(xs, ys))
    print(f"{case:<18} {numbers:<8} apart by {nstr(off, 2)}", flush=True)
    assert off < mpf(10) ** (-DIGITS - 1), "the two computations do not agree"
    return results[1]


def main():
    rows = kept()
    for case in sys.argv[1:] or CASES:
        names = CASES[case][1]
        rows[case] = [
            [case, numbers, nstr(t, 40), name, nstr(value, DIGITS + 2)]
            for numbers in ("decimal", "binary")
            for t, state in checked(case, numbers)
            for name, value in zip([*names, *(f"{name}_dot" for name in names)], state)
        ]
    with TARGET.open("w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["case", "numbers", "time", "component", "value"])
        for case in CASES:
            writer.writerows(rows.get(case, []))


def kept():
    """Returns the rows of the table, by case."""
    rows = {}
    if TARGET.exists():
        with TARGET.open(newline="") as file:
            for row in list(csv.reader(file))[1:]:
                rows.setdefault(row[0], []).append(row)
    return rows


if __name__ == "__main__":
    main()
