"""Pinocchio's results for URDF files, for the tests of `lagrange-import` and for `docs/robots.md`.

    pip install pin example-robot-data
    python3 tools/urdf.py            # writes crates/lagrange-import/tests/data/*.txt
    python3 tools/urdf.py --robots   # measures all robots of example-robot-data and writes docs/robots.md

Pinocchio reads the same file independently. It keeps the scalar part of a quaternion last, and velocities of floating and planar joints in the
axes of the moving link. The output follows the language: scalar parts first, rates of the components of a position, angular velocities in
rotated axes. Accelerations are those under damping and without motors: `aba`, or, where joints mimic others, Gᵀ M G a = Gᵀ (τ − b) with
M and b of `crba` and `rnea` of all joints, whose velocities are G times the independent ones (joints that move no mass are at rest; Featherstone,
*Rigid Body Dynamics Algorithms*, §3.3).
Each state is a line `state` and a line for each moving joint: its name in the file, positions, velocities and accelerations, separated by
tabs. A free base is called `root_joint`.
"""

import json
import math
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import numpy as np
import pinocchio as pin

ROOT = Path(__file__).resolve().parent.parent
DATA = ROOT / "crates" / "lagrange-import" / "tests" / "data"
ROBOTS = "cmeel.prefix/share/example-robot-data/robots"
STATES = 6
BASE = "root_joint"
SNAPPED = 1e-9  # distance within which an angle counts as a multiple of a quarter turn, as in the language
# File, true if the base is free, and the file for Pinocchio if it differs.
CASES = {
    "every_joint": ("every_joint.urdf", False, None),
    "tree_of_30": ("tree_of_30.urdf", False, None),
    "tree_of_5_free": ("tree_of_5.urdf", True, None),
    # Pinocchio takes every plane to be normal to z, so it reads prismatic and revolute joints instead of the planar one.
    "tilted_plane": ("tilted_plane.urdf", False, "tilted_plane_by_hand.urdf"),
}


def model_of(path, is_free):
    return pin.buildModelFromUrdf(str(path), *([pin.JointModelFreeFlyer()] if is_free else []))


def held_of(model):
    """Returns joints that move no mass: nothing determines their accelerations."""
    carried = [inertia.mass for inertia in model.inertias]
    for index in range(model.njoints - 1, 0, -1):
        carried[model.parents[index]] += carried[index]
    return [index for index in range(1, model.njoints) if carried[index] == 0]


def kind(joint):
    return joint.shortname().removeprefix("JointModel")


def followers(path, model, held):
    """Returns follower, leader, multiplier and offset by joint ids, leaders first."""
    rows = {}
    for joint in ElementTree.parse(path).getroot().findall("joint"):
        mimic = joint.find("mimic")
        if mimic is None or joint.get("type") == "fixed":
            continue
        numbers = float(mimic.get("multiplier", 1)), float(mimic.get("offset", 0))
        rows[model.getJointId(joint.get("name"))] = (model.getJointId(mimic.get("joint")), *numbers)
    rows = {follower: row for follower, row in rows.items() if follower not in held}
    moving = set(range(1, model.njoints)) - set(held)
    if any(row[0] not in moving for row in rows.values()):
        raise ValueError("a joint mimics one that does not move")
    ordered = []
    while rows:
        ready = [follower for follower, row in rows.items() if row[0] not in rows]
        ordered += [(follower, *rows.pop(follower)) for follower in ready]
    return ordered


def places(model):
    """Returns id, kind, and slices of positions and velocities for each joint."""
    for index in range(1, model.njoints):
        joint = model.joints[index]
        q, v = slice(joint.idx_q, joint.idx_q + joint.nq), slice(joint.idx_v, joint.idx_v + joint.nv)
        yield index, kind(joint), q, v


def states(model, rows, held):
    """Returns random states in the language's positions and velocities, and one at rest; except for quaternions, numbers have few digits."""
    rng = np.random.default_rng(9)
    fraction = lambda count, reach: rng.integers(-64 * reach, 64 * reach, count, endpoint=True) / 64
    for number in range(STATES + 1):
        q, v = {}, {}
        for index, name, _, _ in places(model):
            count = {"FreeFlyer": 7, "Planar": 3}.get(name, 1)
            q[index], v[index] = fraction(count, 2), fraction(min(count, 6), 1)
            if name == "FreeFlyer":
                q[index][3:] /= np.linalg.norm(q[index][3:])
            if number == STATES:
                q[index], v[index] = np.zeros(count), np.zeros(min(count, 6))
                q[index][3:4] = 1
        for index in held:
            q[index], v[index] = 0 * q[index], 0 * v[index]
        for follower, leader, multiplier, offset in rows:
            q[follower], v[follower] = multiplier * q[leader] + offset, multiplier * v[leader]
        yield q, v


def into_pinocchio(model, q, v):
    """Returns positions, T and b of Pinocchio's velocities T u and accelerations T u' + b for u as used here, and velocities u."""
    positions, rates = pin.neutral(model), np.zeros(model.nv)
    matrix, drift = np.eye(model.nv), np.zeros(model.nv)
    for index, name, at, along in places(model):
        own, rates[along], first = q[index], v[index], along.start
        if name == "FreeFlyer":
            positions[at] = [*own[:3], *own[4:], own[3]]
            rotation = pin.Quaternion(*own[3:]).toRotationMatrix()
            place = slice(first, first + 3)
            matrix[place, place] = rotation.T
            drift[place] = -np.cross(v[index][3:], rotation.T @ v[index][:3])
        elif name == "Planar":
            sine, cosine = math.sin(own[2]), math.cos(own[2])
            positions[at] = [own[0], own[1], cosine, sine]
            turn, place = np.array([[cosine, sine], [-sine, cosine]]), slice(first, first + 2)
            matrix[place, place] = turn
            x, y = turn @ v[index][:2]
            drift[place] = v[index][2] * np.array([y, -x])
        elif model.joints[index].nq == 2:  # unbounded: cosine and sine
            positions[at] = [math.cos(own[0]), math.sin(own[0])]
        else:
            positions[at] = own
    return positions, rates, matrix, drift


def accelerations(model, rows, held, q, v):
    """Returns accelerations in the language's velocities, by one way, and by a second one where it exists."""
    data = model.createData()
    positions, rates, matrix, drift = into_pinocchio(model, q, v)
    velocities = matrix @ rates
    forces = -model.damping * velocities
    mass_matrix = pin.crba(model, data, positions)
    mass_matrix = np.triu(mass_matrix) + np.triu(mass_matrix, 1).T
    bias = pin.rnea(model, data, positions, velocities, np.zeros(model.nv))
    free = np.eye(model.nv)
    for index in held:
        free[model.joints[index].idx_v] = 0
    for follower, leader, multiplier, _ in rows:
        follower, leader = model.joints[follower].idx_v, model.joints[leader].idx_v
        free[follower] = multiplier * free[leader]
    free = free[:, np.any(free != 0, axis=0)]
    found = free @ np.linalg.solve(free.T @ mass_matrix @ free, free.T @ (forces - bias))
    ways = [found] if rows or held else [pin.aba(model, data, positions, velocities, forces), found]
    return [np.linalg.solve(matrix, way - drift) for way in ways]


def snapped(path):
    """Returns the text of a file with quarter turns to the precision of a double."""
    tree = ElementTree.parse(path)
    for origin in tree.iter("origin"):
        if origin.get("rpy"):
            origin.set("rpy", " ".join(repr(quarter(float(angle))) for angle in origin.get("rpy").split()))
    return ElementTree.tostring(tree.getroot(), encoding="unicode")


def quarter(angle):
    whole = round(angle / (math.pi / 2)) * (math.pi / 2)
    return whole if abs(angle - whole) < SNAPPED else angle


def references(path, is_free, is_snapped=False, spreads=None):
    """Returns lines of states; `spreads` receives the differences between two ways of Pinocchio."""
    if is_snapped:
        with tempfile.NamedTemporaryFile("w", suffix=".urdf") as copy:
            copy.write(snapped(path))
            copy.flush()
            model = model_of(copy.name, is_free)
    else:
        model = model_of(path, is_free)
    held = held_of(model)
    rows = followers(path, model, held)
    for q, v in states(model, rows, held):
        found, *other = accelerations(model, rows, held, q, v)
        spread = [np.max(np.abs(way - found)) / max(1, np.max(np.abs(found))) for way in other]
        if spreads is not None:
            spreads += spread
        yield "state"
        for index, _, _, along in places(model):
            if index in held:
                continue
            numbers = (" ".join(repr(float(x)) for x in row) for row in (q[index], v[index], found[along]))
            yield "\t".join([model.names[index], *numbers])


def write_tests():
    for count in (5, 30):
        (DATA / f"tree_of_{count}.urdf").write_text(tree(count))
    for name, (file, is_free, read) in CASES.items():
        lines = [f"# Written by tools/urdf.py.", *references(DATA / (read or file), is_free)]
        (DATA / f"{name}.txt").write_text("\n".join(lines) + "\n")


def tree(count):
    """Returns a robot with random branches, joints and inertia, in numbers of few digits."""
    rng = np.random.default_rng(count)
    text = lambda numbers: " ".join(f"{x:.3g}" for x in numbers)
    lines = [f'<robot name="TreeOf{count}">', '  <link name="trunk">', *inertial(rng), "  </link>"]
    for index in range(1, count):
        parent = rng.integers(max(0, index - 4), index)
        axis = [[1, 0, 0], [0, 1, 0], [0, 0, 1], rng.normal(size=3)][rng.integers(4)]
        quarters = rng.random() < 0.5
        angles = rng.integers(-2, 3, 3) * math.pi / 2 if quarters else rng.normal(size=3)
        rpy = " ".join(repr(float(x)) for x in angles) if quarters else text(angles)
        joint = ["revolute", "continuous", "prismatic", "fixed"][rng.choice(4, p=[0.5, 0.2, 0.15, 0.15])]
        lines += [
            f'  <link name="link{index}">', *inertial(rng), "  </link>",
            f'  <joint name="joint{index}" type="{joint}">',
            f'    <parent link="{"trunk" if parent == 0 else f"link{parent}"}"/>',
            f'    <child link="link{index}"/>',
            f'    <origin xyz="{text(rng.normal(size=3) / 4)}" rpy="{rpy}"/>',
            f'    <axis xyz="{text(axis)}"/>',
            f'    <limit lower="-1" upper="1" effort="10" velocity="2"/>',
            "  </joint>",
        ]
    return "\n".join([*lines, "</robot>", ""])


def inertial(rng):
    """Returns the inertia of a possible body: moments of random masses on three axes, rotated."""
    a, b, c = np.round(rng.uniform(0.01, 0.1, 3), 4)
    place = " ".join(f"{x:.3g}" for x in rng.normal(size=3) / 10)
    turned = "0 0 0" if rng.random() < 0.5 else " ".join(f"{x:.3g}" for x in rng.normal(size=3))
    return [
        "    <inertial>",
        f'      <origin xyz="{place}" rpy="{turned}"/>',
        f'      <mass value="{rng.uniform(0.5, 4):.3g}"/>',
        f'      <inertia ixx="{b + c:.4g}" ixy="0" ixz="0" iyy="{a + c:.4g}" iyz="0" izz="{a + b:.4g}"/>',
        "    </inertial>",
    ]


def robots():
    for folder in sys.path:
        if (Path(folder) / ROBOTS).exists():
            return sorted((Path(folder) / ROBOTS).rglob("*.urdf")), Path(folder) / ROBOTS
    raise SystemExit("the robots are missing: pip install example-robot-data")


def beside(tool, path, is_free, trusts):
    """Returns degrees of freedom, constraints, operations and differences of a robot, or the reason why there are none. Files that Pinocchio cannot
    read are left to the importer."""
    spreads = []
    try:
        lines = list(references(path, is_free, is_snapped=True, spreads=spreads))
    except (ValueError, RuntimeError, ElementTree.ParseError) as error:
        lines, refusal = [], str(error).strip().splitlines()[0]
    with tempfile.NamedTemporaryFile("w", suffix=".txt") as file:
        file.write("\n".join(lines) + "\n")
        file.flush()
        options = ["--free"] * is_free + ["--trust-inertia"] * trusts
        result = subprocess.run([tool, path, file.name, *options], capture_output=True, text=True)
    if result.returncode == 0 and not lines:
        raise SystemExit(f"{path}: imported, but Pinocchio says {refusal}")
    if result.returncode != 0:
        reasons = result.stdout.strip().splitlines()
        return False, reasons
    *cells, _ = result.stdout.split()
    return True, [*cells, f"{max(spreads):.1e}" if spreads else "–"]


def row(tool, path, is_free):
    """Returns cells of the table, and a remark."""
    imported, found = beside(tool, path, is_free, False)
    if imported:
        return found, ""
    reason = found[0] + (f"; and {len(found) - 1} more" if len(found) > 1 else "")
    if all("no body has" in line for line in found):
        imported, cells = beside(tool, path, is_free, True)
        if imported:
            return cells, f"{len(found)} × inertia that no body has: with `--trust-inertia`"
    return ["–"] * 5, f"refused: line {reason}"


def write_robots():
    tool = subprocess.run(
        ["cargo", "build", "--quiet", "--release", "-p", "lagrange-import", "--example", "beside_pinocchio", "--message-format=json"],
        cwd=ROOT, check=True, capture_output=True, text=True,
    )
    built = (json.loads(line) for line in tool.stdout.splitlines())
    tool = next(message["executable"] for message in built if message.get("executable"))
    files, root = robots()
    lines, counts = [], {"imported": 0, "trusted": 0, "refused": 0}
    for path in files:
        for is_free in (False, True):
            cells, reason = row(tool, path, is_free)
            counts["trusted" if "trust" in reason else "refused" if reason else "imported"] += 1
            # Markdown would mistake elements for HTML.
            reason = re.sub(r"<\w+>", r"`\g<0>`", " ".join(reason.replace("|", "\\|").split()))
            name = f"`{path.relative_to(root)}`" if not is_free else ""
            freedoms, constraints, operations, difference, own = cells
            cells = [name, "free" if is_free else "fixed", freedoms, constraints, operations, difference, own, reason]
            lines.append(f"| {' | '.join(cells)} |")
            print(lines[-1], flush=True)
    page = ROOT / "docs" / "robots.md"
    text = page.read_text()
    before, rest = text.split("<!-- Robots: tools/urdf.py -->\n", 1)
    after = rest.split("<!-- End of robots -->", 1)[1]
    head = "| file | base | freedoms | constraints | operations | difference | of Pinocchio | remark |\n|---|---|---|---|---|---|---|---|"
    summary = f"{len(files)} files, each with a fixed and with a free base: {counts['imported']} imported as they are, {counts['trusted']} with `--trust-inertia`, {counts['refused']} refused."
    table = "\n".join([summary, "", head, *lines])
    page.write_text(f"{before}<!-- Robots: tools/urdf.py -->\n{table}\n<!-- End of robots -->{after}")


if __name__ == "__main__":
    write_robots() if "--robots" in sys.argv else write_tests()
