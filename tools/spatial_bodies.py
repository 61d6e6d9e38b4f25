"""Random bodies in space for `tools/spatial_trees.py`: their text, mass, centre of mass and tensor of inertia.

Moments of solids: Meriam, Kraige, *Engineering Mechanics: Dynamics*, table D/4.
"""

from mpmath import mpf, pi

import newton_euler as ne

# Principal moments for unit mass; lengths, radii and sides have the names of the table.
SOLIDS = {
    "point_mass": (0, lambda: (0, 0, 0)),
    "slender_rod": (1, lambda l: (0, l**2 / 12, l**2 / 12)),
    "solid_sphere": (1, lambda r: (2 * r**2 / 5,) * 3),
    "thin_sphere": (1, lambda r: (2 * r**2 / 3,) * 3),
    "ellipsoid": (3, lambda a, b, c: ((b**2 + c**2) / 5, (c**2 + a**2) / 5, (a**2 + b**2) / 5)),
    "cuboid": (3, lambda a, b, c: ((b**2 + c**2) / 12, (c**2 + a**2) / 12, (a**2 + b**2) / 12)),
    "disk": (1, lambda r: (r**2 / 4, r**2 / 4, r**2 / 2)),
    "thin_ring": (1, lambda r: (r**2 / 2, r**2 / 2, r**2)),
    "solid_cylinder": (2, lambda r, h: ((3 * r**2 + h**2) / 12, (3 * r**2 + h**2) / 12, r**2 / 2)),
    "hollow_cylinder": (3, lambda i, o, h: (*[(3 * (i**2 + o**2) + h**2) / 12] * 2, (i**2 + o**2) / 2)),
    "cone": (2, lambda r, h: (*[3 * (4 * r**2 + h**2) / 80] * 2, 3 * r**2 / 10)),
}
# Volumes of solids that are cut out.
HOLES = {
    "solid_sphere": lambda r: 4 * pi * r**3 / 3,
    "solid_cylinder": lambda r, h: pi * r**2 * h,
    "cuboid": lambda a, b, c: a * b * c,
}


def matter(tree):
    """Returns text, mass, centre of mass and tensor of a body."""
    kinds = [with_tensor, with_tensor, with_principal_moments, with_shape, with_shape, compound]
    return tree.rng.choice(kinds)(tree)


def diagonal(moments):
    return [[moments[i] if i == j else mpf(0) for j in range(3)] for i in range(3)]


def with_centroid(tree):
    if tree.chance(0.2):
        return "", [mpf(0)] * 3
    text, value = tree.vector(-0.4, 0.4)
    return f" centroid: {text};", value


def second_moments(tree):
    """Returns the sum of w p p^T over some points, with few digits."""
    total = [[mpf("0.05") if i == j else mpf(0) for j in range(3)] for i in range(3)]
    for _ in range(4):
        weight, point = tree.rng.uniform(0.1, 1), [tree.rng.uniform(-0.5, 0.5) for _ in range(3)]
        total = [[total[i][j] + weight * point[i] * point[j] for j in range(3)] for i in range(3)]
    return total


def with_tensor(tree):
    mass_text, mass = tree.number(0.4, 5)
    moments = second_moments(tree)
    trace = sum(moments[i][i] for i in range(3))
    places = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)]
    texts = [f"{float((trace if i == j else 0) - moments[i][j]):.3f}" for i, j in places]
    tensor = diagonal([mpf(0)] * 3)
    for (i, j), text in zip(places, texts):
        tensor[i][j] = tensor[j][i] = mpf(text)
    centroid_text, centroid = with_centroid(tree)
    return f"mass: {mass_text};{centroid_text} inertia: ({', '.join(texts)});", mass, centroid, tensor


def with_principal_moments(tree):
    mass_text, mass = tree.number(0.4, 5)
    shares = [mpf(tree.decimal(0.1, 0.6)) for _ in range(3)]
    moments = [shares[1] + shares[2], shares[2] + shares[0], shares[0] + shares[1]]
    texts = ", ".join(str(float(moment)) for moment in moments)
    moments = [mpf(str(float(moment))) for moment in moments]
    centroid_text, centroid = with_centroid(tree)
    return f"mass: {mass_text};{centroid_text} inertia: ({texts});", mass, centroid, diagonal(moments)


def solid(tree, names=tuple(SOLIDS), low=0.2, high=0.8):
    """Returns text, name, dimensions."""
    name = tree.rng.choice(names)
    dimensions = sorted(tree.decimal(low, high) for _ in range(SOLIDS[name][0]))
    if name == "hollow_cylinder":
        dimensions[1] = str(mpf(dimensions[1]) + 1)
    return f"{name}({', '.join(dimensions)})", name, [mpf(d) for d in dimensions]


def of_solid(name, dimensions, mass):
    """Returns the centre of mass and the tensor about it in the solid's coordinates."""
    centroid = [mpf(0), mpf(0), dimensions[1] / 4 if name == "cone" else mpf(0)]
    return centroid, diagonal([mass * mpf(moment) for moment in SOLIDS[name][1](*dimensions)])


def with_shape(tree):
    mass_text, mass = tree.number(0.4, 5)
    text, name, dimensions = solid(tree)
    centroid, tensor = of_solid(name, dimensions, mass)
    return f"mass: {mass_text}; shape: {text};", mass, centroid, tensor


def compound(tree):
    """Returns a block with a hole, and parts fixed to it."""
    text, name, sides = solid(tree, ["cuboid"], 0.6, 0.9)
    mass_text, mass = tree.number(2, 5)
    lines, parts = [f"{text}, mass: {mass_text};"], [(mass, *of_solid(name, sides, mass))]
    if tree.chance(0.7):
        text, name, dimensions = solid(tree, tuple(HOLES), 0.15, 0.25)
        missing = 0.8 * mass * HOLES[name](*dimensions) / (sides[0] * sides[1] * sides[2])
        missing = f"{float(missing):.4f}"
        lines, parts = added(tree, lines, parts, f"hole {text}", (name, dimensions, missing), -1, 0.1)
    for _ in range(tree.rng.choice((0, 1, 2))):
        text, name, dimensions = solid(tree)
        lines, parts = added(tree, lines, parts, text, (name, dimensions, tree.decimal(0.3, 2)), 1, 0.8)
    mass = sum(part[0] for part in parts)
    centroid = ne.times(1 / mass, [sum(part[0] * part[1][k] for part in parts) for k in range(3)])
    tensor = diagonal([mpf(0)] * 3)
    for part in parts:
        tensor = [ne.plus(a, b) for a, b in zip(tensor, about(part, centroid))]
    return f"compound {{ {' '.join(lines)} }}", mass, centroid, tensor


def added(tree, lines, parts, text, described, sign, reach):
    """Returns a part with its position; a hole has negative mass and tensor."""
    name, dimensions, mass = described
    centroid, tensor = of_solid(name, dimensions, sign * mpf(mass))
    line, at, rotation = f"{text}, mass: {mass}", [mpf(0)] * 3, ne.IDENTITY
    if tree.chance(0.8):
        place, at = tree.vector(-reach, reach)
        line += f", at: {place}"
    if tree.chance(0.6):
        angles = [tree.angle() for _ in range(3)]
        line += f", turned: ({', '.join(angle for angle, _ in angles)})"
        rotation = ne.roll_pitch_yaw(*(value for _, value in angles))
    centroid = ne.plus(at, ne.applied(rotation, centroid))
    tensor = ne.product(ne.product(rotation, tensor), ne.transposed(rotation))
    return [*lines, f"{line};"], [*parts, (sign * mpf(mass), centroid, tensor)]


def about(part, point):
    """Returns the tensor of a part about a point (Steiner, Huygens)."""
    mass, centroid, tensor = part
    d = ne.minus(centroid, point)
    square = ne.dot(d, d)
    return [[tensor[i][j] + mass * (square * (i == j) - d[i] * d[j]) for j in range(3)] for i in range(3)]
