"""Random trees of bodies in space with their accelerations, in twenty digits, for `lagrange-core/tests/spatial/trees.txt`.

    pip install mpmath
    python3 tools/spatial_trees.py          writes all (half a minute)
    python3 tools/spatial_trees.py 17 64    prints only these trees

Each tree is built twice from the same random choices: as statements of the language, and as poses, masses and loads for
`tools/newton_euler.py`, which computes with forty digits and is independent of the language. Numbers in statements have few digits and
states are fractions of 64, so both use the same numbers. The seed of a tree is its number.

The lines of the file are those that `lagrange-core/tests/spatial/cases.rs` describes.
"""

import random
import sys
from pathlib import Path

from mpmath import mp, mpf, nstr, pi

import newton_euler as ne
from newton_euler import Series
from spatial_bodies import matter
from spatial_joints import AXES, BALLS, KINDS, Joints
from spatial_loads import Loads, Outputs, Unsuitable

COUNT = 200
MOST_BODIES = 8
MOST_COORDINATES = 9
DIGITS = 20
# One in this many has free bodies or ball joints.
PERIOD = 3
# Quaternions of the identity, of quarter and half turns about axes, of a third of a turn about a diagonal, and of one and a half and two turns.
QUATERNIONS = [
    [mpf(c) for c in quaternion]
    for quaternion in (
        (1, 0, 0, 0), (1, 1, 0, 0), (1, 0, -1, 0), (-1, 0, 0, 1), (0, 1, 0, 0), (0, 0, 1, 0), (0, 0, 0, -1), (1, 1, 1, 1),
        (-1, 0, 0, 0),
    )
]
# Trees with worse conditioned matrices have nearly no inertia somewhere.
WORST_CONDITION = 1e6
TARGET = Path(__file__).resolve().parent.parent / "lagrange-core" / "tests" / "spatial" / "trees.txt"


class Tree(Joints, Loads, Outputs):
    """Statements, and their meanings."""

    def __init__(self, seed):
        self.rng = random.Random(seed)
        # Two thirds of the trees have no quaternions.
        self.has_orientations = seed % PERIOD == 0
        self.statements, self.names = [], []
        self.speeds = []  # velocities: the names of forces along them, and their own names
        self.orientations = []  # indices at which quaternions begin among the positions
        self.frames = {}  # name: (carrier, function of coordinates and time)
        self.bodies, self.loads, self.potentials, self.pins, self.outputs = [], [], [], [], []
        self.parameters = 0
        self.gravity = [mpf(0)] * 3
        self.build()

    # Words and numbers.

    def say(self, statement):
        self.statements.append(statement)

    def chance(self, probability):
        return self.rng.random() < probability

    def decimal(self, low, high):
        """Returns a number of few digits as text."""
        digits = self.rng.choice((1, 2))
        return f"{self.rng.uniform(low, high):.{digits}f}"

    def number(self, low, high):
        """Returns a number, or a parameter with a number as its default: text and value."""
        text = self.decimal(low, high)
        if self.chance(0.1):
            self.parameters += 1
            name = f"p{self.parameters}"
            self.say(f"param {name} = {text};")
            return name, mpf(text)
        return text, mpf(text)

    def vector(self, low=-1.0, high=1.0, sparse=0.2):
        """Returns a vector as text and value; some components are zero."""
        parts = [("0", mpf(0)) if self.chance(sparse) else self.number(low, high) for _ in range(3)]
        return f"({', '.join(text for text, _ in parts)})", [value for _, value in parts]

    def angle(self):
        """Returns a constant angle, often a quarter turn."""
        if self.chance(0.6):
            text, quarters = self.rng.choice((("0", 0), ("pi/2", 1), ("-pi/2", -1), ("pi", 2), ("-pi", -2)))
            return text, quarters * pi / 2
        return self.number(-3, 3)

    def coordinate(self, stem):
        name = f"{stem}{len(self.names) + 1}"
        self.names.append(name)
        self.speeds.append((name, f"dot({name})"))
        return name, len(self.names) - 1

    # Frames.

    def build(self):
        if self.chance(0.8):
            text, self.gravity = self.rng.choice(
                [("(0, 0, -9.81)", [0, 0, mpf("-9.81")]), ("(1.5, -0.25, -9.5)", [mpf("1.5"), mpf("-0.25"), mpf("-9.5")])]
            )
            self.say(f"gravity = {text};")
        links = ["ground"]
        for index in range(self.rng.randint(1, self.rng.randint(1, MOST_BODIES))):
            if len(self.speeds) >= MOST_COORDINATES - 2:
                break
            name = f"b{index + 1}"
            if self.is_free(index):
                self.set_free(name)
            elif self.chance(0.12):
                self.place_by_hand(name)
            else:
                carrier = self.rng.choice(links[-2:] if self.chance(0.7) else links)
                if self.chance(0.2):
                    carrier = self.frame_on(carrier, f"f{index + 1}")
                self.say_body(name, "")
                balls = BALLS * (1 if index else 3) if self.has_orientations else []
                self.join(carrier, name, self.rng.choice(KINDS + balls))
            links.append(name)
        if not self.names or bool(self.orientations) != self.has_orientations:
            raise Unsuitable
        self.act([*self.frames])
        self.observe([*self.frames])

    def is_free(self, index):
        """True if a body moves freely, which is most likely for the first of a tree."""
        is_possible = self.has_orientations and len(self.speeds) <= MOST_COORDINATES - 3
        return is_possible and self.chance(0.2 if index else 0.5)

    def set_free(self, name):
        """Returns the body itself, or a frame to which it is fixed."""
        if self.chance(0.8):
            self.say_body(name, "")
            self.free(name)
            return
        frame = f"f{name}"
        self.say(f"frame {frame};")
        self.free(frame)
        self.say_body(name, "")
        self.join(frame, name, "weld")

    def frame_on(self, carrier, name):
        """Adds a massless link between two joints."""
        self.say(f"frame {name};")
        kind = self.rng.choice(["weld", "weld", "revolute", "prismatic"] + ["ball"] * self.has_orientations)
        self.join(carrier, name, kind)
        return name

    def say_body(self, name, place):
        text, mass, centroid, tensor = matter(self)
        self.say(f"body {name} {{ {text}{place} }}")
        self.bodies.append(ne.Body(name, mass, centroid, tensor))

    def join(self, carrier, name, kind):
        lines, fixed = self.joint_frame()
        coordinates, motion, more = getattr(self, kind)()
        lines += more
        tail = f" {{ {' '.join(lines)} }}" if lines else ";"
        made = ", ".join(coordinates)
        made = f"({made}) = " if len(coordinates) > 1 else f"{made} = " * len(coordinates)
        self.say(f"{kind} {made}{carrier} to {name}{tail}")
        self.frames[name] = (carrier, lambda q, t: ne.product(fixed, motion(q)))

    # Bodies with an explicit pose.

    def place_by_hand(self, name):
        place = [self.length() for _ in range(3)]
        word = self.rng.choice(("origin", "center"))
        lines = f" {word}: ({', '.join(text for text, _ in place)});"
        rotation = lambda q, t: ne.IDENTITY
        if self.chance(0.85):
            letters = self.sequence()
            angles = [self.turn() for _ in range(3)]
            lines += f" angles: ({', '.join(text for text, _ in angles)}); sequence: {letters};"

            def rotation(q, t):
                total = ne.IDENTITY
                for letter, (_, angle) in zip(letters, angles):
                    total = ne.product(total, ne.rotation(AXES[letter], angle(q, t)))
                return total

        self.say_body(name, lines)
        centroid = self.bodies[-1].centroid if word == "center" else [mpf(0)] * 3

        def pose(q, t):
            turned = rotation(q, t)
            arm = ne.product(turned, [[-c] for c in centroid])
            return ne.homogeneous(turned, [p(q, t) + a for (_, p), (a,) in zip(place, arm)])

        self.frames[name] = ("ground", pose)

    def sequence(self):
        letters = self.rng.choice("xyz")
        while len(letters) < 3:
            letters += self.rng.choice([letter for letter in "xyz" if letter != letters[-1]])
        return letters

    def length(self):
        """Returns a component of a position, as a function of coordinates and time."""
        return self.moving("x")

    def turn(self):
        return self.moving("a")

    def moving(self, stem):
        choice = self.rng.random()
        if choice < 0.6 and len(self.speeds) < MOST_COORDINATES:
            name, q = self.coordinate(stem)
            self.say(f"coord {name};")
            return self.rng.choice((
                (name, lambda x, t: x[q]),
                (name, lambda x, t: x[q]),
                (f"-{name}/2 + t/5", lambda x, t: t / 5 - x[q] / 2),
                (f"{name} + sin({name})/3", lambda x, t: x[q] + x[q].sin() / 3),
            ))
        if choice < 0.8:
            text = self.decimal(-1, 1)
            return text, lambda x, t: Series(text)
        return self.rng.choice((
            ("sin(2*t)/5", lambda x, t: (2 * t).sin() / 5),
            ("t^2/4 - t", lambda x, t: t * t / 4 - t),
        ))

    # Results.

    def poses(self, q, t):
        placed = {"ground": ne.translation(0, 0, 0)}
        for name, (carrier, motion) in self.frames.items():
            placed[name] = ne.product(placed[carrier], motion(q, t))
        del placed["ground"]
        return placed

    def text(self):
        """Makes sure that the declaration is recognised as spatial."""
        text = "\n".join(self.statements)
        is_said = any(word in text for word in ("gravity", "at:", "centroid", "turned", "angles"))
        return text if is_said else f"gravity = (0, 0, 0);\n{text}"


def mechanics(tree, t, q, v, wanted):
    """Returns the expected results at a state, as lines."""
    k = ne.Kinematics(tree.poses, t, q, v, tree.orientations)
    mass_matrix, bias = ne.undivided(k, tree.bodies)
    loads = [mpf(0)] * k.size
    for body in tree.bodies:
        weight = ne.times(body.mass, tree.gravity)
        loads = [q + ne.dot(column, weight) for q, column in zip(loads, k.jacobian(body.frame, body.centroid))]
    for load in tree.loads:
        loads = ne.plus(loads, load(k))
    constraints, drifts = constrained(tree, k)
    right = ne.minus(loads, bias)
    try:
        accelerations, multipliers, condition = ne.solved(mass_matrix, right, constraints, drifts)
        # Pins may constrain a motion without inertia, which the language refuses.
        _, _, unconstrained = ne.solved(mass_matrix, right, [], [])
    except ZeroDivisionError as singular:
        raise Unsuitable from singular
    if max(condition, unconstrained) > WORST_CONDITION:
        raise Unsuitable
    torques = [ne.dot(row, wanted) - rest for row, rest in zip(mass_matrix, right)]
    kinetic = sum(body.kinetic_energy(k) for body in tree.bodies)
    weights = (-body.mass * ne.dot(tree.gravity, k.place(body.frame, body.centroid)) for body in tree.bodies)
    potential = sum(weights) + sum((energy(k) for energy in tree.potentials), mpf(0))
    lines = [("condition", [condition], 3), ("accelerations", accelerations, DIGITS)]
    if multipliers:
        lines.append(("multipliers", multipliers, DIGITS))
    lines += [("inverse_dynamics", torques, DIGITS), ("kinetic", [kinetic], DIGITS), ("potential", [potential], DIGITS)]
    for name, value in tree.outputs:
        lines.append((f"output {name}", value(k, accelerations, multipliers), DIGITS))
    return lines


def constrained(tree, k):
    """Returns rows of the Jacobian of the pins, and the terms without accelerations."""
    rows, drifts = [], []
    zero = [mpf(0)] * k.size
    for name, own, there in tree.pins:
        columns = [ne.minus(a, b) for a, b in zip(k.jacobian(name, own), there(k)[2])]
        rows += [[column[axis] for column in columns] for axis in range(3)]
        drift = ne.minus(k.acceleration(name, own, zero), there(k)[3])
        drifts += drift
    return rows, drifts


def oriented(tree, q, chosen):
    """Returns positions with unit quaternions, up to rounding to doubles."""
    q = list(q)
    for first in tree.orientations:
        quaternion = chosen(q[first : first + 4])
        if not any(quaternion):
            raise Unsuitable
        q[first : first + 4] = [mpf(float(c)) for c in ne.direction(quaternion)]
    return q


def states(tree):
    """Returns random states and exact zeros: t, q, v. Orientations include the identity, and rotations by simple angles."""
    fraction = lambda reach: mpf(tree.rng.randint(-64 * reach, 64 * reach)) / 64
    vector = lambda reach: [fraction(reach) for _ in tree.speeds]
    zero, rest = [mpf(0)] * len(tree.speeds), [mpf(0)] * len(tree.names)
    random = lambda: oriented(tree, [fraction(2) for _ in tree.names], lambda quaternion: quaternion)
    special = lambda place: oriented(tree, place, lambda _: tree.rng.choice(QUATERNIONS))
    unturned = oriented(tree, rest, lambda _: QUATERNIONS[0])
    yield fraction(1), random(), vector(2)
    yield mpf(0), unturned, zero
    yield tree.rng.choice(((mpf(0), unturned, vector(2)), (fraction(1), random(), zero)))
    if tree.orientations:
        yield fraction(1), special(random()), vector(2)
        yield mpf(0), special(rest), zero


def written(number, digits):
    if abs(number) < mpf("1e-30"):
        return "0"
    text = nstr(number, digits, min_fixed=-4, max_fixed=24, strip_zeros=True)
    return text[:-2] if text.endswith(".0") else text


def described(seed):
    """Returns the lines of a tree."""
    tree = Tree(seed)
    lines = [f"> {line}" for line in tree.text().splitlines()]
    for index, (t, q, v) in enumerate(states(tree)):
        wanted = [mpf(tree.rng.randint(-192, 192)) / 64 for _ in v]
        try:
            values = mechanics(tree, t, q, v, wanted)
        except Unsuitable:
            if index == 0:
                raise
            continue
        given = [("state", [t]), ("q", q), ("v", v), ("wanted", wanted)]
        values = [(word, numbers, DIGITS) for word, numbers in given] + values
        lines += [f"{word} {' '.join(written(x, digits) for x in numbers)}" for word, numbers, digits in values]
    return lines


def trees():
    """Returns the numbers of all valid trees, with their lines."""
    seed = 0
    while True:
        seed += 1
        try:
            yield seed, described(seed)
        except Unsuitable:
            continue


def main():
    mp.dps = 40
    if sys.argv[1:]:
        for seed in map(int, sys.argv[1:]):
            print("\n".join([f"system tree {seed}", *described(seed)]))
        return
    with TARGET.open("w") as file:
        file.write("# Written by tools/spatial_trees.py.\n")
        for _, (seed, lines) in zip(range(COUNT), trees()):
            file.write("\n".join(["", f"system tree {seed}", *lines, ""]))


if __name__ == "__main__":
    main()
