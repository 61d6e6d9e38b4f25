"""Public models of robots as declarations of the language, with what Pinocchio computes of them, in `lagrange-core/tests/spatial/models`.

    pip install pin example-robot-data
    python3 tools/spatial_models.py

Arms and a quadruped come from their public descriptions, chains of universal joints are made here. The free base of the quadruped
is three prismatic joints along x, y, z and three revolute ones about z, y, x, on frames. References are accelerations without torques
(articulated bodies, Pinocchio's `aba`), torques for accelerations (`rnea`) and the mass matrix (`crba`): Featherstone, *Rigid Body Dynamics
Algorithms*, chapters 5 to 7. Declarations and references are made from the same model: descriptions print pi/2 with eleven digits, so
that entries of rotations which are nearly 0, 1 or -1 are made exactly that first.

NAME.lag is the declaration, NAME.txt holds its states in the lines that `lagrange-core/tests/spatial/cases.rs` describes.
"""

import sys
from pathlib import Path

import numpy as np
import pinocchio as pin

TARGET = Path(__file__).resolve().parent.parent / "lagrange-core" / "tests" / "spatial" / "models"
ROBOTS = "cmeel.prefix/share/example-robot-data/robots"
SNAPPED = 1e-9  # distance from 0, 1 and -1 within which an entry of a rotation is that number
STATES = 8
MATRIX_EVERY = 5  # states, so that the last one, where all is zero, has one
NEGLIGIBLE = 1e-15  # of centres of mass in metres: sums of links that are symmetric leave such rests
AXES = {"X": (1, 0, 0), "Y": (0, 1, 0), "Z": (0, 0, 1)}
BASE = [pin.JointModelPX, pin.JointModelPY, pin.JointModelPZ, pin.JointModelRZ, pin.JointModelRY, pin.JointModelRX]


def description(path, *root):
    for folder in sys.path:
        file = Path(folder) / ROBOTS / path
        if file.exists():
            return pin.buildModelFromUrdf(str(file), *root)
    raise SystemExit(f"{path} is missing: pip install example-robot-data")


def ur5():
    return description("ur_description/urdf/ur5_robot.urdf")


def panda():
    """Without motion of the fingers."""
    model = description("panda_description/urdf/panda.urdf")
    fingers = [model.getJointId(name) for name in model.names if "finger" in name]
    return pin.buildReducedModel(model, fingers, pin.neutral(model))


def go2():
    base = pin.JointModelComposite()
    for joint in BASE:
        base.addJoint(joint())
    return description("go2_description/urdf/go2.urdf", base)


def universal(count):
    """Rods of length one, each on a universal joint at the end of the one before."""
    model, carrier = pin.Model(), 0
    inertia = pin.Inertia(1.0, np.array([0, 0, -0.5]), np.diag([1 / 12, 1 / 12, 0.005]))
    for k in range(1, count + 1):
        end = pin.SE3(np.eye(3), np.array([0, 0, -1.0 if k > 1 else 0.0]))
        fork = model.addJoint(carrier, pin.JointModelRX(), end, f"a{k}")
        carrier = model.addJoint(fork, pin.JointModelRY(), pin.SE3.Identity(), f"b{k}")
        model.appendBodyToJoint(carrier, inertia, pin.SE3.Identity())
    return model


MODELS = {
    "ur5": ur5,
    "panda": panda,
    "go2": go2,
    "universal_2": lambda: universal(2),
    "universal_5": lambda: universal(5),
    "universal_10": lambda: universal(10),
}


def joints_of(model):
    """Name, kind, axis, carrier, placement and inertia of every joint, those of a composite one by one; carriers by number, -1 is the ground."""
    rows, last = [], {0: -1}
    for index in range(1, model.njoints):
        joint, placement = model.joints[index], model.jointPlacements[index]
        parts, carrier = [joint], last[model.parents[index]]
        if "Composite" in joint.shortname():
            parts = list(joint.extract().joints)
        for number, part in enumerate(parts):
            kind, axis = motion(part)
            is_last = number == len(parts) - 1
            inertia = cleaned(model.inertias[index]) if is_last else pin.Inertia.Zero()
            rows.append((kind, axis, carrier, placement, inertia))
            carrier, placement = len(rows) - 1, pin.SE3.Identity()
        last[index] = carrier
    return rows


def cleaned(inertia):
    lever = np.where(np.abs(inertia.lever) < NEGLIGIBLE, 0.0, inertia.lever)
    return pin.Inertia(inertia.mass, lever, inertia.inertia)


def motion(joint):
    """`revolute` or `prismatic`, and the axis."""
    name = joint.shortname().removeprefix("JointModel")
    kind = {"R": "revolute", "P": "prismatic"}[name[0]]
    axis = AXES.get(name[1:])
    return kind, axis if axis else tuple(float(x) for x in joint.extract().axis)


def snapped(rotation):
    rotation = rotation.copy()
    for value in (0.0, 1.0, -1.0):
        rotation[np.abs(rotation - value) < SNAPPED] = value
    return rotation


def rebuilt(rows):
    """The model that the declaration describes."""
    model, ids = pin.Model(), [0]
    joints = {
        ("revolute", AXES["X"]): pin.JointModelRX, ("revolute", AXES["Y"]): pin.JointModelRY,
        ("revolute", AXES["Z"]): pin.JointModelRZ, ("prismatic", AXES["X"]): pin.JointModelPX,
        ("prismatic", AXES["Y"]): pin.JointModelPY, ("prismatic", AXES["Z"]): pin.JointModelPZ,
    }
    for index, (kind, axis, carrier, placement, inertia) in enumerate(rows):
        place = pin.SE3(snapped(placement.rotation), placement.translation)
        joint = joints[kind, axis]()
        ids.append(model.addJoint(ids[carrier + 1], joint, place, f"j{index}"))
        model.appendBodyToJoint(ids[-1], inertia, pin.SE3.Identity())
    return model


def number(x):
    """The shortest decimal, without an exponent."""
    x = float(x)
    return "0" if x == 0 else np.format_float_positional(x, trim="-")


def vector(components):
    return f"({', '.join(number(x) for x in components)})"


def angles(rotation):
    """Roll, pitch and yaw, quarter turns by name."""
    def word(angle):
        quarters = angle / (np.pi / 2)
        exact = {0: "0", 1: "pi/2", -1: "-pi/2", 2: "pi", -2: "-pi"}
        return exact[round(quarters)] if abs(quarters - round(quarters)) < SNAPPED else number(angle)

    return f"({', '.join(word(angle) for angle in pin.rpy.matrixToRpy(snapped(rotation)))})"


def declaration(rows):
    """One body or frame and one joint a line."""
    lines = ["gravity = (0, 0, -9.81);"]
    names = ["ground"] + [f"{'l' if row[4].mass > 0 else 'f'}{index}" for index, row in enumerate(rows, 1)]
    for index, (kind, axis, carrier, placement, inertia) in enumerate(rows):
        name, on = names[index + 1], names[carrier + 1]
        lines.append(link(name, inertia))
        labels = []
        if np.any(placement.translation):
            labels.append(f"at: {vector(placement.translation)};")
        if np.any(snapped(placement.rotation) != np.eye(3)):
            labels.append(f"turned: {angles(placement.rotation)};")
        if axis != AXES["Z"]:
            labels.append(f"axis: {vector(axis)};")
        tail = f" {{ {' '.join(labels)} }}" if labels else ";"
        lines.append(f"{kind} q{index + 1} = {on} to {name}{tail}")
    return "\n".join(lines) + "\n"


def link(name, inertia):
    if inertia.mass == 0:
        return f"frame {name};"
    j = inertia.inertia
    tensor = vector((j[0, 0], j[1, 1], j[2, 2], j[0, 1], j[0, 2], j[1, 2]))
    place = f" centroid: {vector(inertia.lever)};" if np.any(inertia.lever) else ""
    return f"body {name} {{ mass: {number(inertia.mass)};{place} inertia: {tensor}; }}"


def chain_declaration(count):
    lines = ["gravity = (0, 0, -9.81);"]
    for k in range(1, count + 1):
        lines.append(f"body l{k} {{ mass: 1; centroid: (0, 0, -0.5); inertia: (1/12, 1/12, 0.005); }}")
        tail = " { at: (0, 0, -1); }" if k > 1 else ";"
        lines.append(f"universal (a{k}, b{k}) = {f'l{k - 1}' if k > 1 else 'ground'} to l{k}{tail}")
    return "\n".join(lines) + "\n"


def states(size):
    """Random ones, then those with exact zeros; numbers of few digits."""
    rng = np.random.default_rng(16)
    fraction = lambda reach: rng.integers(-64 * reach, 64 * reach, size, endpoint=True) / 64
    zero = np.zeros(size)
    yield from ((fraction(2), fraction(1)) for _ in range(STATES))
    yield zero, fraction(1)
    yield fraction(2), zero
    yield zero, zero


def references(model):
    data, rng = model.createData(), np.random.default_rng(61)
    for index, (q, v) in enumerate(states(model.nv)):
        wanted = rng.integers(-128, 128, model.nv, endpoint=True) / 64
        mass_matrix = pin.crba(model, data, q)
        mass_matrix = np.triu(mass_matrix) + np.triu(mass_matrix, 1).T
        yield "state", [0]
        yield "q", q
        yield "v", v
        yield "wanted", wanted
        yield "condition", [float(f"{np.linalg.cond(mass_matrix, 1):.2e}")]
        yield "accelerations", pin.aba(model, data, q, v, np.zeros(model.nv))
        yield "inverse_dynamics", pin.rnea(model, data, q, v, wanted)
        if index % MATRIX_EVERY == 0:
            yield "mass_matrix", mass_matrix.flatten()


def main():
    TARGET.mkdir(parents=True, exist_ok=True)
    for name, build in MODELS.items():
        rows = joints_of(build())
        _, _, count = name.partition("_")
        text = chain_declaration(int(count)) if count else declaration(rows)
        (TARGET / f"{name}.lag").write_text(text)
        lines = (f"{word} {' '.join(repr(float(x)) for x in numbers)}" for word, numbers in references(rebuilt(rows)))
        head = "# Written by tools/spatial_models.py."
        (TARGET / f"{name}.txt").write_text("\n".join([head, f"system {name}", *lines, ""]))


if __name__ == "__main__":
    main()
