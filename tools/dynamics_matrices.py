"""Matrices of the dynamics of robots by Pinocchio, in `matrices.txt` and `centroidal.txt` of `lagrange-core/tests/spatial`.

    pip install pin example-robot-data
    python3 tools/dynamics_matrices.py

The Coriolis matrix is that of `computeCoriolisMatrix` (Echeandia and Wensing, "Numerical methods to compute the Coriolis matrix and
Christoffel symbols for rigid-body systems", J. Comput. Nonlinear Dynam. 16 (2021) 091004). The inverse of the mass matrix is that of
`computeMinverse`. Derivatives of the inverse dynamics, by positions and then by velocities, are those of `computeRNEADerivatives`. Centres
of mass and centroidal momenta are those of `centerOfMass` and `ccrba`; angular momenta come first here. Robots are the public descriptions
of `tools/spatial_models.py`, and a planar arm that is declared here and there.
"""

from pathlib import Path

import numpy as np
import pinocchio as pin
import spatial_models as robots

TARGET = Path(__file__).resolve().parent.parent / "lagrange-core" / "tests" / "spatial"
STATES = 3
# Mass, inertia about the centre, distance of the centre and length of the links of the planar arm.
LINKS = [(2.0, 0.25, 0.375, 1.0), (1.5, 0.125, 0.5, 0.75), (0.5, 0.0625, 0.25, 0.5)]


def planar():
    """Returns the model of an arm in the plane of x and y, with gravity along -y."""
    model, carrier, place = pin.Model(), 0, 0.0
    model.gravity.linear = np.array([0, -9.81, 0])
    for mass, inertia, centre, length in LINKS:
        carrier = model.addJoint(carrier, pin.JointModelRZ(), pin.SE3(np.eye(3), np.array([place, 0, 0])), f"q{carrier + 1}")
        body = pin.Inertia(mass, np.array([centre, 0, 0]), np.diag([inertia] * 3))
        model.appendBodyToJoint(carrier, body, pin.SE3.Identity())
        place = length
    return model


def planar_declaration():
    lines, place = ["gravity = (0, -9.81);"], 0
    for k, (mass, inertia, centre, length) in enumerate(LINKS, 1):
        lines.append(f"body l{k} {{ mass: {mass}; inertia: {inertia}; centroid: ({centre}, 0); }}")
        at = f" {{ at: ({place}, 0); }}" if place else ";"
        lines.append(f"revolute q{k} = {f'l{k - 1}' if k > 1 else 'ground'} to l{k}{at}")
        place = length
    return lines


def matrices(model, data, q, v, rng):
    wanted = rng.integers(-128, 128, model.nv, endpoint=True) / 64
    by_place, by_speed, _ = pin.computeRNEADerivatives(model, data, q, v, wanted)
    inverse = pin.computeMinverse(model, data, q)
    inverse = np.triu(inverse) + np.triu(inverse, 1).T
    yield "wanted", wanted
    yield "coriolis_matrix", pin.computeCoriolisMatrix(model, data, q, v)
    yield "inverse_mass_matrix", inverse
    yield "condition", [float(f"{np.linalg.cond(inverse, 1):.2e}")]
    yield "inverse_dynamics_jacobian", np.hstack([by_place, by_speed])


def totals(model, data, q, v, _):
    own, _ = robots.turning(model, q, v)
    is_planar = not np.any(model.gravity.linear[2])
    # Rows of angular momenta, then those of linear ones.
    matrix = (pin.ccrba(model, data, q, own @ v) @ own)[[5, 0, 1] if is_planar else [3, 4, 5, 0, 1, 2]]
    yield "center_of_mass", pin.centerOfMass(model, data, q)[: 2 if is_planar else 3]
    yield "centroidal_momentum", matrix @ v
    yield "centroidal_momentum_matrix", matrix


def lines(results, name, declared, model):
    data, rng = model.createData(), np.random.default_rng(41)
    yield f"system {name}"
    yield from (f"> {line}" for line in declared)
    for (q, v), _ in zip(robots.states(model), range(STATES)):
        state = [("state", [0]), ("q", robots.positions(model, q)), ("v", v)]
        for word, numbers in (*state, *results(model, data, q, v, rng)):
            yield f"{word} {' '.join(repr(float(x)) for x in np.ravel(numbers))}"


def write(file, results, systems):
    written = (line for system in systems for line in lines(results, *system))
    (TARGET / file).write_text("\n".join(["# Written by tools/dynamics_matrices.py.", *written, ""]))


def main():
    rows = {name: robots.joints_of(robots.MODELS[name]()) for name in ("ur5", "panda", "go2_free")}
    ur5, panda, go2 = [(name, robots.declaration(row).splitlines(), robots.rebuilt(row)) for name, row in rows.items()]
    arm = ("planar", planar_declaration(), planar())
    write("matrices.txt", matrices, (ur5, panda, arm))
    write("centroidal.txt", totals, (ur5, go2, arm))


if __name__ == "__main__":
    main()
