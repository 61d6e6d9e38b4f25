"""Joints of the random trees of `tools/spatial_trees.py`: statements with their motions."""

from mpmath import mpf, pi

import newton_euler as ne

AXES = dict(zip("xyz", ne.IDENTITY))
KINDS = [
    "revolute", "revolute", "revolute", "revolute", "prismatic", "prismatic", "screw", "cylindrical", "universal",
    "planar", "weld",
]
# For trees with orientations.
BALLS = ["ball"] * 11


class Joints:
    """Joints, each of which makes names of coordinates, a motion and lines of its statement."""

    def joint_frame(self):
        lines, fixed = [], ne.translation(0, 0, 0)
        if self.chance(0.8):
            text, at = self.vector()
            lines.append(f"at: {text};")
            fixed = ne.translation(*at)
        if self.chance(0.5):
            angles = [self.angle() for _ in range(3)]
            lines.append(f"turned: ({', '.join(text for text, _ in angles)});")
            rotation = ne.roll_pitch_yaw(*(value for _, value in angles))
            fixed = ne.product(fixed, ne.homogeneous(rotation, [0, 0, 0]))
        return lines, fixed

    def axis(self):
        """Returns a direction with its line."""
        if self.chance(0.3):
            return [], AXES["z"]
        if self.chance(0.6):
            place, sign = self.rng.randrange(3), self.rng.choice((1, -1, 2))
            components = [sign * int(k == place) for k in range(3)]
            return [f"axis: ({', '.join(map(str, components))});"], ne.direction([mpf(c) for c in components])
        text, value = self.vector()
        if ne.dot(value, value) < 0.01:
            return [], AXES["z"]
        return [f"axis: {text};"], ne.direction(value)

    def damping(self, count=1):
        """Adds damping to the joint with the last velocities."""
        if not self.chance(0.2):
            return []
        text, value = self.number(0.1, 0.9)
        end = len(self.speeds)
        damped = range(end - count, end)
        self.loads.append(lambda k: [-value * k.v[i] if i in damped else mpf(0) for i in range(k.size)])
        return [f"damping: {text};"]

    def revolute(self):
        name, q = self.coordinate("q")
        lines, axis = self.axis()
        return [name], lambda x: ne.turned(axis, x[q]), lines + self.damping()

    def prismatic(self):
        name, s = self.coordinate("s")
        lines, axis = self.axis()
        return [name], lambda x: ne.translation(*(x[s] * c for c in axis)), lines + self.damping()

    def screw(self):
        name, q = self.coordinate("q")
        lines, axis = self.axis()
        text, pitch = self.number(0.1, 0.9)

        def motion(x):
            advance = x[q] * (pitch / (2 * pi))
            return ne.product(ne.turned(axis, x[q]), ne.translation(*(advance * c for c in axis)))

        return [name], motion, [*lines, f"pitch: {text};", *self.damping()]

    def cylindrical(self):
        (turn, q), (move, s) = self.coordinate("q"), self.coordinate("s")
        lines, axis = self.axis()

        def motion(x):
            return ne.product(ne.turned(axis, x[q]), ne.translation(*(x[s] * c for c in axis)))

        return [turn, move], motion, lines

    def universal(self):
        (first, a), (second, b) = self.coordinate("q"), self.coordinate("q")
        motion = lambda x: ne.product(ne.turned(AXES["x"], x[a]), ne.turned(AXES["y"], x[b]))
        return [first, second], motion, []

    def planar(self):
        (first, x), (second, y), (turn, phi) = (self.coordinate(stem) for stem in "xyq")
        motion = lambda q: ne.product(ne.translation(q[x], q[y], 0), ne.turned(AXES["z"], q[phi]))
        return [first, second, turn], motion, []

    def weld(self):
        return [], lambda _: ne.translation(0, 0, 0), []

    def ball(self):
        name = f"j{len(self.speeds) + 1}"
        q = self.orientation(name)
        return [name], lambda x: ne.homogeneous(ne.oriented(x[q : q + 4]), [0, 0, 0]), self.damping(3)

    def free(self, name):
        """Writes the statement for a body or frame."""
        self.say(f"free {name};")
        first = len(self.names)
        self.names += [f"{name}_{axis}" for axis in "xyz"]
        # A force along a velocity may also name the coordinate.
        self.speeds += [(self.rng.choice((f"{name}_v{axis}", f"{name}_{axis}")), f"{name}_v{axis}") for axis in "xyz"]
        q = self.orientation(name)
        motion = lambda x, t: ne.homogeneous(ne.oriented(x[q : q + 4]), x[first : first + 3])
        self.frames[name] = ("ground", motion)

    def orientation(self, name):
        """Returns names of a quaternion and of its angular velocity, and the index where the quaternion begins."""
        first = len(self.names)
        self.orientations.append(first)
        self.names += [f"{name}_q{part}" for part in "wxyz"]
        self.speeds += [(f"{name}_w{axis}",) * 2 for axis in "xyz"]
        return first
