"""Accelerations of bodies in space, one of which is far heavier, lighter, longer or shorter, for tests/extremes/space.

    python3 tools/spatial_extremes.py          writes tests/extremes/space/*.csv (seconds)

The scenes are those of tests/extremes/space/*.lag, repeated as poses for `tools/newton_euler.py`, which solves Newton's and Euler's
equations in the world with sixty digits. Positions and velocities are fractions of 64, and quaternions are normalised. Twenty digits
are printed. Nothing comes from this project.
"""

import csv
import random
from pathlib import Path

from mpmath import mp, mpf, nstr, sqrt

import newton_euler as ne
from newton_euler import IDENTITY, Body, Kinematics, Series, translation, turned

mp.dps = 60
DIGITS = 20
TARGET = Path(__file__).resolve().parent.parent / "tests" / "extremes" / "space"
X, Y, Z = IDENTITY
GRAVITY = mpf(9.81)  # the nearest number of 53 bits
# One parameter at a time differs from 1.
ROWS = [{}, {"m1": 1e9}, {"m1": 1e-9}, {"m2": 1e9}, {"m2": 1e-9}, {"l1": 1e9}, {"l1": 1e-9}, {"l2": 1e9}, {"l2": 1e-9}]


def chained(*poses):
    whole = poses[0]
    for pose in poses[1:]:
        whole = ne.product(whole, pose)
    return whole


def oriented(w, x, y, z):
    """Returns the rotation of a unit quaternion."""
    rows = [
        [w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z],
    ]
    return ne.homogeneous(rows, [0, 0, 0])


def arm(p, q):
    b1 = turned(Z, q[0])
    b2 = chained(b1, translation(0, 0, p["l1"]), turned(Y, q[1]))
    b3 = chained(b2, translation(p["l2"], 0, 0), turned(Y, q[2]))
    return [b1, b2, b3, chained(b3, translation(p["l3"], 0, 0), turned(X, q[3]))]


def six_joint_arm(p, q):
    poses = [turned(Z, q[0]), chained(turned(Z, q[0]), translation(0, 0, p["l1"]), turned(Y, q[1]))]
    for k, axis in ((2, Y), (3, X), (4, Y), (5, X)):
        poses.append(chained(poses[-1], translation(p[f"l{k}"], 0, 0), turned(axis, q[k])))
    return poses


def universal(a, b):
    return chained(turned(X, a), turned(Y, b))


def universal_chain(p, q):
    b1 = universal(q[0], q[1])
    return [b1, chained(b1, translation(0, 0, -p["l1"]), universal(q[2], q[3]))]


def universal_and_hinge(p, q):
    b1 = universal(q[0], q[1])
    return [b1, chained(b1, translation(0, 0, -p["l1"]), turned(Y, q[2]))]


def universal_arm(p, q):
    b1 = turned(Z, q[0])
    b2 = chained(b1, translation(p["l1"], 0, 0), universal(q[1], q[2]))
    return [b1, b2, chained(b2, translation(0, 0, -p["l2"]), turned(Y, q[3]))]


def ball_chain(p, q):
    b1 = oriented(*q[0:4])
    return [b1, chained(b1, translation(0, 0, -p["l1"]), oriented(*q[4:8]))]


def free_body(p, q):
    b1 = chained(translation(*q[0:3]), oriented(*q[3:7]))
    return [b1, chained(b1, translation(p["l1"], 0, 0), turned(Y, q[7]))]


UPRIGHT, HANGING, LYING = [0, 0, mpf(1) / 2], [0, 0, -mpf(1) / 2], [mpf(1) / 2, 0, 0]
ROD, BEAM = [12, 11, 50], [50, 12, 12]  # moments are m l^2 divided by these
QUATERNION = ["qw", "qx", "qy", "qz"]


def ball(name):
    return [f"{name}_{c}" for c in QUATERNION], [f"{name}_w{c}" for c in "xyz"]


# name: poses, names of positions, names of velocities, centroids by length and divisors of moments of the bodies
SCENES = {
    "arm": (
        arm,
        ["q1", "q2", "q3", "q4"],
        None,
        [(UPRIGHT, ROD), (LYING, BEAM), (LYING, BEAM), ([mpf(1) / 2, mpf(1) / 5, 0], [50, 12, 11])],
    ),
    "six_joint_arm": (
        six_joint_arm,
        [f"q{k + 1}" for k in range(6)],
        None,
        [(UPRIGHT, ROD), *[(LYING, BEAM)] * 4, ([mpf(1) / 2, mpf(1) / 5, 0], [50, 12, 11])],
    ),
    "universal_chain": (universal_chain, ["a1", "a2", "a3", "a4"], None, [(HANGING, ROD), (HANGING, ROD)]),
    "universal_and_hinge": (universal_and_hinge, ["a1", "a2", "q"], None, [(HANGING, ROD), (HANGING, ROD)]),
    "universal_arm": (universal_arm, ["q1", "a1", "a2", "q2"], None, [([0, 0, 0], ROD), (HANGING, ROD), (HANGING, ROD)]),
    "ball_chain": (ball_chain, ball("j1")[0] + ball("j2")[0], ball("j1")[1] + ball("j2")[1], [(HANGING, ROD), (HANGING, ROD)]),
    "free_body": (
        free_body,
        ["b1_x", "b1_y", "b1_z", *ball("b1")[0], "hinge"],
        ["b1_vx", "b1_vy", "b1_vz", *ball("b1")[1], "dot hinge"],
        [([0, 0, 0], [12, 11, 10]), (LYING, BEAM)],
    ),
}


class Oriented(Kinematics):
    """Solves with quaternions among the positions: `rates(velocities, q)` are q' and q'' at constant velocities."""

    def __init__(self, poses, rates, q, v):
        self.rates = rates
        self.t, self.q, self.v = mpf(0), q, v
        self.size = len(v)
        self.motion = self.along(poses, Series(0, 1), v)
        unit = lambda column: [mpf(int(k == column)) for k in range(self.size)]
        self.columns = [self.along(poses, Series(0), unit(column)) for column in range(self.size)]

    def along(self, poses, t, velocities):
        first, second = self.rates(velocities, self.q)
        placed = poses([Series(x, a, b / 2) for x, a, b in zip(self.q, first, second)], t)
        return {name: ne.Placed(pose) for name, pose in placed.items()}


def quaternions(names):
    """Returns the indices of scalar parts."""
    return [i for i, name in enumerate(names) if name.endswith("_qw")]


def turning(quaternion, w):
    """Returns q times (0, w) / 2."""
    s, v = quaternion[0], quaternion[1:]
    return [-ne.dot(v, w) / 2, *(x / 2 for x in ne.plus(ne.times(s, w), ne.cross(v, w)))]


def rates_of(names):
    firsts = quaternions(names)

    def rates(velocities, q):
        first, second, velocities = [], [], list(velocities)
        i = 0
        while i < len(q):
            if i in firsts:
                w, velocities = velocities[:3], velocities[3:]
                rate = turning(q[i : i + 4], w)
                first, second, i = first + rate, second + turning(rate, w), i + 4
            else:
                first, second, i = first + [velocities.pop(0)], second + [mpf(0)], i + 1
        return first, second

    return rates


def accelerations(scene, parameters, q, v):
    poses, names, _, shapes = SCENES[scene]
    frames = lambda q, t: dict(enumerate(poses(parameters, q)))
    kinematics = Oriented(frames, rates_of(names), q, v)
    bodies = []
    for k, (centroid, divisors) in enumerate(shapes):
        m, l = parameters[f"m{k + 1}"], parameters[f"l{k + 1}"]
        tensor = [[m * l * l / divisors[i] if i == j else mpf(0) for j in range(3)] for i in range(3)]
        bodies.append(Body(k, m, ne.times(l, centroid), tensor))
    mass_matrix, bias = ne.undivided(kinematics, bodies)
    forces = [-b for b in bias]
    for body in bodies:
        for i, column in enumerate(kinematics.jacobian(body.frame, body.centroid)):
            forces[i] -= body.mass * GRAVITY * column[2]
    return ne.solved(mass_matrix, forces, [], [])[0]


def rows(scene):
    _, names, speeds, shapes = SCENES[scene]
    speeds = speeds or [f"dot {name}" for name in names]
    rng = random.Random(scene)
    parameters = [f"{kind}{k + 1}" for kind in "ml" for k in range(len(shapes))]
    rates = [f"d{name}" if name.startswith("dot ") else f"dot {name}" for name in speeds]
    yield [*parameters, *names, *speeds, *rates]
    for settings in ROWS:
        values = {name: mpf(settings.get(name, 1)) for name in parameters}
        q, v = ([mpf(rng.randrange(-96, 97)) / 64 for _ in which] for which in (names, speeds))
        written = [*q]
        for i in quaternions(names):
            length = sqrt(ne.dot(q[i : i + 4], q[i : i + 4]))
            q[i : i + 4] = [x / length for x in q[i : i + 4]]
        found = accelerations(scene, values, q, v)
        yield [*(repr(float(x)) for x in (*values.values(), *written, *v)), *(nstr(a, DIGITS) for a in found)]


def main():
    for scene in SCENES:
        with (TARGET / f"{scene}.csv").open("w", newline="") as file:
            csv.writer(file, lineterminator="\n").writerows(rows(scene))


if __name__ == "__main__":
    main()
