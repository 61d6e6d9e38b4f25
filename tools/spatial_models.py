"""Public models of robots as declarations of the language, with Pinocchio's results, in `lagrange-core/tests/spatial/models`.

    pip install pin example-robot-data
    python3 tools/spatial_models.py

Arms and a quadruped come from their public descriptions; chains of universal and of ball joints are built here. The base of the quadruped
is free; a second model carries it by three prismatic joints along x, y, z and three revolute ones about z, y, x, on frames. Pinocchio
keeps the scalar part of a quaternion last and velocities of free bodies in their own axes; the files follow the language: scalar
parts first, velocities of free bodies in the world, angular velocities in rotated axes. References are accelerations without torques
(articulated bodies, Pinocchio's `aba`), torques for accelerations (`rnea`) and the mass matrix (`crba`): Featherstone, *Rigid Body Dynamics
Algorithms*, chapters 5 to 7. Declarations and references are made from the same model. Descriptions print pi/2 with eleven digits, so
entries of rotations that are nearly 0, 1 or -1 are rounded to these first.

NAME.lag is the declaration; NAME.txt contains its states in the lines that `lagrange-core/tests/spatial/cases.rs` describes.
"""

import sys
from pathlib import Path

import numpy as np
import pinocchio as pin

TARGET = Path(__file__).resolve().parent.parent / "lagrange-core" / "tests" / "spatial" / "models"
ROBOTS = "cmeel.prefix/share/example-robot-data/robots"
SNAPPED = 1e-9  # distance from 0, 1 and -1 within which an entry of a rotation is that number
STATES = 8
MATRIX_EVERY = 5  # states, so that the last one, with zeros only, has a matrix
NEGLIGIBLE = 1e-15  # of centres of mass in metres, such as rounding errors in sums of symmetric links
AXES = {"X": (1, 0, 0), "Y": (0, 1, 0), "Z": (0, 0, 1)}
FULL = {"Spherical": "ball", "FreeFlyer": "free"}
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
    """Returns the model without motion of the fingers."""
    model = description("panda_description/urdf/panda.urdf")
    fingers = [model.getJointId(name) for name in model.names if "finger" in name]
    return pin.buildReducedModel(model, fingers, pin.neutral(model))


def go2_free():
    return description("go2_description/urdf/go2.urdf", pin.JointModelFreeFlyer())


def go2():
    base = pin.JointModelComposite()
    for joint in BASE:
        base.addJoint(joint())
    return description("go2_description/urdf/go2.urdf", base)


def universal(count):
    """Returns rods of unit length, each on a universal joint at the end of the previous one."""
    model, carrier = pin.Model(), 0
    inertia = pin.Inertia(1.0, np.array([0, 0, -0.5]), np.diag([1 / 12, 1 / 12, 0.005]))
    for k in range(1, count + 1):
        end = pin.SE3(np.eye(3), np.array([0, 0, -1.0 if k > 1 else 0.0]))
        fork = model.addJoint(carrier, pin.JointModelRX(), end, f"a{k}")
        carrier = model.addJoint(fork, pin.JointModelRY(), pin.SE3.Identity(), f"b{k}")
        model.appendBodyToJoint(carrier, inertia, pin.SE3.Identity())
    return model


def balls(count):
    """Returns the same rods on ball joints."""
    model, carrier = pin.Model(), 0
    inertia = pin.Inertia(1.0, np.array([0, 0, -0.5]), np.diag([1 / 12, 1 / 12, 0.005]))
    for k in range(1, count + 1):
        end = pin.SE3(np.eye(3), np.array([0, 0, -1.0 if k > 1 else 0.0]))
        carrier = model.addJoint(carrier, pin.JointModelSpherical(), end, f"b{k}")
        model.appendBodyToJoint(carrier, inertia, pin.SE3.Identity())
    return model


MODELS = {
    "ur5": ur5,
    "panda": panda,
    "go2": go2,
    "universal_2": lambda: universal(2),
    "universal_5": lambda: universal(5),
    "universal_10": lambda: universal(10),
    "go2_free": go2_free,
    "ball_2": lambda: balls(2),
    "ball_5": lambda: balls(5),
}


def joints_of(model):
    """Returns name, kind, axis, carrier, placement and inertia of every joint. Composite joints are split; carriers are numbers, -1 for the ground."""
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
    """Returns the keyword for a joint, and the axis, if it has one."""
    name = joint.shortname().removeprefix("JointModel")
    if name in FULL:
        return FULL[name], None
    kind = {"R": "revolute", "P": "prismatic"}[name[0]]
    axis = AXES.get(name[1:])
    return kind, axis if axis else tuple(float(x) for x in joint.extract().axis)


def snapped(rotation):
    rotation = rotation.copy()
    for value in (0.0, 1.0, -1.0):
        rotation[np.abs(rotation - value) < SNAPPED] = value
    return rotation


def rebuilt(rows):
    """The model of a declaration."""
    model, ids = pin.Model(), [0]
    joints = {
        ("revolute", AXES["X"]): pin.JointModelRX, ("revolute", AXES["Y"]): pin.JointModelRY,
        ("revolute", AXES["Z"]): pin.JointModelRZ, ("prismatic", AXES["X"]): pin.JointModelPX,
        ("prismatic", AXES["Y"]): pin.JointModelPY, ("prismatic", AXES["Z"]): pin.JointModelPZ,
        ("ball", None): pin.JointModelSpherical, ("free", None): pin.JointModelFreeFlyer,
    }
    for index, (kind, axis, carrier, placement, inertia) in enumerate(rows):
        place = pin.SE3(snapped(placement.rotation), placement.translation)
        joint = joints[kind, axis]()
        ids.append(model.addJoint(ids[carrier + 1], joint, place, f"j{index}"))
        model.appendBodyToJoint(ids[-1], inertia, pin.SE3.Identity())
    return model


def number(x):
    """Returns the shortest decimal, without an exponent."""
    x = float(x)
    return "0" if x == 0 else np.format_float_positional(x, trim="-")


def vector(components):
    return f"({', '.join(number(x) for x in components)})"


def angles(rotation):
    """Returns roll, pitch and yaw, with quarter turns by name."""
    def word(angle):
        quarters = angle / (np.pi / 2)
        exact = {0: "0", 1: "pi/2", -1: "-pi/2", 2: "pi", -2: "-pi"}
        return exact[round(quarters)] if abs(quarters - round(quarters)) < SNAPPED else number(angle)

    return f"({', '.join(word(angle) for angle in pin.rpy.matrixToRpy(snapped(rotation)))})"


def declaration(rows):
    """Returns one body or frame and one joint per line."""
    lines = ["gravity = (0, 0, -9.81);"]
    names = ["ground"] + [f"{'l' if row[4].mass > 0 else 'f'}{index}" for index, row in enumerate(rows, 1)]
    for index, (kind, axis, carrier, placement, inertia) in enumerate(rows):
        name, on = names[index + 1], names[carrier + 1]
        lines.append(link(name, inertia))
        if kind == "free":
            lines.append(f"free {name};")
            continue
        labels = []
        if np.any(placement.translation):
            labels.append(f"at: {vector(placement.translation)};")
        if np.any(snapped(placement.rotation) != np.eye(3)):
            labels.append(f"turned: {angles(placement.rotation)};")
        if axis not in (None, AXES["Z"]):
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


def states(model):
    """Returns random states, then states with exact zeros; except for quaternions, numbers have few digits."""
    rng = np.random.default_rng(16)
    fraction = lambda count, reach: rng.integers(-64 * reach, 64 * reach, count, endpoint=True) / 64
    rest, zero = pin.neutral(model), np.zeros(model.nv)

    def place():
        q = fraction(model.nq, 2)
        for first in quaternions(model):
            q[first : first + 4] /= np.linalg.norm(q[first : first + 4])
        return q

    yield from ((place(), fraction(model.nv, 1)) for _ in range(STATES))
    yield rest, fraction(model.nv, 1)
    yield place(), zero
    yield rest, zero


def quaternions(model):
    """Returns the indices of the first components of quaternions in Pinocchio's positions."""
    for joint in model.joints[1:]:
        name = joint.shortname().removeprefix("JointModel")
        if name in FULL:
            yield joint.idx_q + (3 if name == "FreeFlyer" else 0)


def positions(model, q):
    """Returns positions with scalar parts first."""
    q = q.copy()
    for first in quaternions(model):
        q[first : first + 4] = np.roll(q[first : first + 4], 1)
    return q


def turning(model, q, v):
    """Returns T and b in Pinocchio's velocities T u and accelerations T u' + b for u as used here."""
    matrix, drift = np.eye(model.nv), np.zeros(model.nv)
    for joint in model.joints[1:]:
        if joint.shortname().endswith("FreeFlyer"):
            i, k = joint.idx_v, joint.idx_q + 3
            rotation = pin.Quaternion(q[k + 3], *q[k : k + 3]).toRotationMatrix()
            matrix[i : i + 3, i : i + 3] = rotation.T
            drift[i : i + 3] = -np.cross(v[i + 3 : i + 6], rotation.T @ v[i : i + 3])
    return matrix, drift


def references(model):
    data, rng = model.createData(), np.random.default_rng(61)
    for index, (q, v) in enumerate(states(model)):
        wanted = rng.integers(-128, 128, model.nv, endpoint=True) / 64
        own, drift = turning(model, q, v)
        mass_matrix = pin.crba(model, data, q)
        mass_matrix = np.triu(mass_matrix) + np.triu(mass_matrix, 1).T
        mass_matrix = own.T @ mass_matrix @ own
        accelerations = pin.aba(model, data, q, own @ v, np.zeros(model.nv))
        forces = pin.rnea(model, data, q, own @ v, own @ wanted + drift)
        yield "state", [0]
        yield "q", positions(model, q)
        yield "v", v
        yield "wanted", wanted
        yield "condition", [float(f"{np.linalg.cond(mass_matrix, 1):.2e}")]
        yield "accelerations", own.T @ (accelerations - drift)
        yield "inverse_dynamics", own.T @ forces
        if index % MATRIX_EVERY == 0:
            yield "mass_matrix", mass_matrix.flatten()


def main():
    TARGET.mkdir(parents=True, exist_ok=True)
    for name, build in MODELS.items():
        rows = joints_of(build())
        chain, _, count = name.partition("_")
        text = chain_declaration(int(count)) if chain == "universal" else declaration(rows)
        (TARGET / f"{name}.lag").write_text(text)
        lines = (f"{word} {' '.join(repr(float(x)) for x in numbers)}" for word, numbers in references(rebuilt(rows)))
        head = "# Written by tools/spatial_models.py."
        (TARGET / f"{name}.txt").write_text("\n".join([head, f"system {name}", *lines, ""]))


if __name__ == "__main__":
    main()
