"""Loads and outputs of the random trees of `tools/spatial_trees.py`: statements with their meanings."""

from mpmath import mpf

import newton_euler as ne

SHORTEST = 0.05  # of a spring, in states that are kept
LOADS = ["force", "force", "drag", "torque", "torque", "drive", "spring", "spring", "damper"]
# For trees with orientations.
TURNING = ["drive", "bend", "bend"]


class Unsuitable(Exception):
    """A tree without any load or output."""


class Loads:
    """Forces, torques, springs, dampers and pins of a tree."""

    def act(self, links):
        for _ in range(self.rng.choice((0, 1, 1, 2, 3))):
            getattr(self, self.rng.choice(LOADS + TURNING * self.has_orientations))(links)
        if len(self.speeds) >= 5 and self.chance(0.35):
            self.pin(links)

    def point(self, links):
        """Returns a point of a body or frame: text, body, body coordinates. The name of a frame stands for its origin."""
        name = self.rng.choice(links)
        centroid = next((body.centroid for body in self.bodies if body.frame == name), None)
        choice = self.rng.random()
        if choice < 0.1:
            return name, name, centroid or [mpf(0)] * 3
        if centroid and choice < 0.2:
            return f"{name}.center", name, centroid
        if choice < 0.3:
            return f"{name}.origin", name, [mpf(0)] * 3
        text, own = self.vector()
        text = f"{name}.point{text}"
        if choice > 0.85:
            self.parameters += 1
            self.say(f"let tip{self.parameters} = {text};")
            text = f"tip{self.parameters}"
        return text, name, own

    def end(self, links):
        """A point of a body or of the ground: its text, and at a state its position, its velocity, columns of its Jacobian and γ."""
        if self.chance(0.3):
            text, place = self.vector(-2, 2, 0)
            zero = [mpf(0)] * 3
            return text, lambda k: (place, zero, [zero] * k.size, zero)
        text, name, own = self.point(links)
        drift = lambda k: k.acceleration(name, own, [mpf(0)] * k.size)
        return text, lambda k: (k.place(name, own), k.velocity(name, own), k.jacobian(name, own), drift(k))

    def load(self, links):
        """Returns a vector that may belong to a body: text, and components in the world at a state."""
        choice = self.rng.random()
        text, value = self.vector(-3, 3)
        if choice < 0.4:
            return text, lambda k: value
        if choice < 0.8:
            name = self.rng.choice(links)
            return f"{name}.vector{text}", lambda k: k.in_world(name, value)
        x = self.rng.randrange(len(self.names))
        return f"({self.names[x]}^2, 0.5, t)", lambda k: [k.q[x] ** 2, mpf("0.5"), k.t]

    def force(self, links):
        (text, load), (place, name, own) = self.load(links), self.point(links)
        self.say(f"force {text} at {place};")
        self.loads.append(lambda k: [ne.dot(column, load(k)) for column in k.jacobian(name, own)])

    def drag(self, links):
        place, name, own = self.point(links)
        text, c = self.number(0.1, 0.9)
        self.say(f"force -{text}*velocity({place}) at {place};")

        def load(k):
            drag = ne.times(-c, k.velocity(name, own))
            return [ne.dot(column, drag) for column in k.jacobian(name, own)]

        self.loads.append(load)

    def torque(self, links):
        (text, load), name = self.load(links), self.rng.choice(links)
        self.say(f"torque {text} on {name};")
        self.loads.append(lambda k: [ne.dot(column, load(k)) for column in k.spin_jacobian(name)])

    def drive(self, _):
        x, value = self.rng.randrange(len(self.speeds)), self.decimal(-2, 2)
        self.parameters += 1
        name = f"u{self.parameters}"
        target, rate = self.speeds[x]
        self.say(f"input {name} = {value}; force {target} = {name} - {rate}/4;")
        self.loads.append(lambda k: [(mpf(value) - k.v[x] / 4) * int(i == x) for i in range(k.size)])

    def bend(self, _):
        """Adds a potential of positions, which may be components of quaternions. Forces are its changes along the velocities."""
        i, j = self.rng.randrange(len(self.names)), self.rng.randrange(len(self.names))
        text, stiffness = self.number(0.5, 4)
        self.say(f"potential = {text}*({self.names[i]}^2/2 + {self.names[i]}*{self.names[j]});")
        self.potentials.append(lambda k: stiffness * (k.q[i] ** 2 / 2 + k.q[i] * k.q[j]))
        change = lambda k, column: (k.q[i] + k.q[j]) * column[i] + k.q[i] * column[j]
        self.loads.append(lambda k: [-stiffness * change(k, column) for column in k.rate_columns])

    def spring(self, links):
        ends = self.between(links)
        text, stiffness = self.number(0.5, 4)
        lines, rest = f"stiffness: {text};", mpf(0)
        if self.chance(0.7):
            text, rest = self.number(0.2, 1)
            lines += f" rest: {text};"
        self.say(f"spring {{ {ends.text} {lines} }}")
        self.loads.append(lambda k: ends.pulled(k, lambda length, _: stiffness * (length - rest)))
        self.potentials.append(lambda k: stiffness * (ends.length(k)[0] - rest) ** 2 / 2)

    def damper(self, links):
        ends = self.between(links)
        text, damping = self.number(0.1, 0.9)
        self.say(f"damper {{ {ends.text} damping: {text}; }}")
        self.loads.append(lambda k: ends.pulled(k, lambda _, rate: damping * rate))

    def between(self, links):
        (start, here), (end, there) = self.end(links), self.end(links)
        if "(" == start[0] == end[0]:
            raise Unsuitable
        return Ends(f"from: {start}; to: {end};", here, there)

    def pin(self, links):
        start, name, own = self.point(links)
        others = [link for link in links if link != name]
        if not others:
            return
        end, there = self.end(others)
        self.parameters += 1
        self.say(f"pin h{self.parameters} = {start} to {end};")
        self.pins.append((name, own, there))
        first = 3 * len(self.pins) - 3
        self.observed(f"h{self.parameters}.force", lambda k, a, multipliers: multipliers[first : first + 3])


class Outputs:
    """Outputs of a tree."""

    def observed(self, text, value):
        name = f"o{len(self.outputs) + 1}"
        self.say(f"output {name} = {text};")
        self.outputs.append((name, value))

    def observe(self, links):
        for _ in range(self.rng.choice((0, 1, 2, 3))):
            getattr(self, self.rng.choice(OUTPUTS + TURNS * 2 * self.has_orientations))(links)

    def axes(self, links):
        """Returns `in name` or an empty text, and the components of a vector there."""
        if self.chance(0.5):
            return "", lambda k, vector: vector
        name = self.rng.choice([*self.frames])
        return f" in {name}", lambda k, vector: k.in_axes(name, vector)

    def see_point(self, links):
        text, name, own = self.point(links)
        if "." not in text:
            return
        self.observed(text, lambda k, a, _: k.place(name, own))

    def see_velocity(self, links):
        (text, name, own), (axes, seen) = self.point(links), self.axes(links)
        self.observed(f"velocity({text}){axes}", lambda k, a, _: seen(k, k.velocity(name, own)))

    def see_acceleration(self, links):
        (text, name, own), (axes, seen) = self.point(links), self.axes(links)
        self.observed(f"acceleration({text}){axes}", lambda k, a, _: seen(k, k.acceleration(name, own, a)))

    def see_spin(self, links):
        name, (axes, seen) = self.rng.choice([*self.frames]), self.axes(links)
        self.observed(f"angular_velocity({name}){axes}", lambda k, a, _: seen(k, k.spin(name)))

    def see_angular_acceleration(self, links):
        name, (axes, seen) = self.rng.choice([*self.frames]), self.axes(links)
        value = lambda k, a, _: seen(k, k.angular_acceleration(name, a))
        self.observed(f"angular_acceleration({name}){axes}", value)

    def see_vector(self, links):
        name, (axes, seen), (text, own) = self.rng.choice([*self.frames]), self.axes(links), self.vector()
        self.observed(f"{name}.vector{text}{axes}", lambda k, a, _: seen(k, k.in_world(name, own)))

    def see_momentum(self, links):
        body, (axes, seen) = self.rng.choice(self.bodies), self.axes(links)
        self.observed(f"linear_momentum({body.frame}){axes}", lambda k, a, _: seen(k, body.linear_momentum(k)))

    def see_angular_momentum(self, links):
        body, (axes, seen) = self.rng.choice(self.bodies), self.axes(links)
        text, about = ("", [mpf(0)] * 3) if self.chance(0.4) else self.vector()
        if text:
            text = f", {text}"
        value = lambda k, a, _: seen(k, body.angular_momentum(k, about))
        self.observed(f"angular_momentum({body.frame}{text}){axes}", value)


    def turn_velocity(self, _):
        index = self.rng.randrange(len(self.speeds))
        self.observed(self.speeds[index][1], lambda k, a, _: [k.v[index]])

    def turn_rate(self, _):
        index = self.rng.randrange(len(self.names))
        self.observed(f"dot({self.names[index]})", lambda k, a, _: [k.rates[index]])

    def turn_acceleration(self, _):
        index = self.rng.randrange(len(self.speeds))
        self.observed(f"dot({self.speeds[index][1]})", lambda k, a, _: [a[index]])


class Ends:
    """Returns two ends of a spring or damper."""

    def __init__(self, text, here, there):
        self.text, self.here, self.there = text, here, there

    def length(self, k):
        """Returns length, its rate, and the direction from one end to the other."""
        (p, p_rate, *_), (q, q_rate, *_) = self.here(k), self.there(k)
        d = ne.minus(q, p)
        length = ne.sqrt(ne.dot(d, d))
        if length < SHORTEST:
            raise Unsuitable
        along = ne.times(1 / length, d)
        return length, ne.dot(along, ne.minus(q_rate, p_rate)), along

    def pulled(self, k, tension):
        length, rate, along = self.length(k)
        pull = ne.times(tension(length, rate), along)
        pairs = zip(self.here(k)[2], self.there(k)[2])
        return [ne.dot(ne.minus(here, there), pull) for here, there in pairs]


OUTPUTS = [name for name in vars(Outputs) if name.startswith("see_")]
# For trees with orientations.
TURNS = [name for name in vars(Outputs) if name.startswith("turn_")]
