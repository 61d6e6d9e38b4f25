"""Matrices of the dynamics of arms by Pinocchio, in `lagrange-core/tests/spatial/matrices.txt`.

    pip install pin example-robot-data
    python3 tools/dynamics_matrices.py

The Coriolis matrix is that of `computeCoriolisMatrix` (Echeandia and Wensing, "Numerical methods to compute the Coriolis matrix and
Christoffel symbols for rigid-body systems", J. Comput. Nonlinear Dynam. 16 (2021) 091004). Its inverse of the mass matrix is that of `computeMinverse`. Derivatives
of the inverse dynamics, by positions and then by velocities, are those of `computeRNEADerivatives`.
Arms are the public descriptions of
`tools/spatial_models.py`, and a planar arm that is declared here and there.
"""

from pathlib import Path

import numpy as np
import pinocchio as pin
import spatial_models as robots

TARGET = Path(__file__).resolve().parent.parent / "lagrange-core" / "tests" / "spatial" / "matrices.txt"
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


def lines(name, declared, model):
    data, rng = model.createData(), np.random.default_rng(41)
    yield f"system {name}"
    yield from (f"> {line}" for line in declared)
    for (q, v), _ in zip(robots.states(model), range(STATES)):
        coriolis = pin.computeCoriolisMatrix(model, data, q, v)
        inverse = pin.computeMinverse(model, data, q)
        inverse = np.triu(inverse) + np.triu(inverse, 1).T
        wanted = rng.integers(-128, 128, model.nv, endpoint=True) / 64
        by_place, by_speed, _ = pin.computeRNEADerivatives(model, data, q, v, wanted)
        words = {"state": [0], "q": robots.positions(model, q), "v": v, "wanted": wanted, "coriolis_matrix": coriolis.flatten()}
        words |= {"inverse_mass_matrix": inverse.flatten(), "condition": [float(f"{np.linalg.cond(inverse, 1):.2e}")]}
        words["inverse_dynamics_jacobian"] = np.hstack([by_place, by_speed]).flatten()
        yield from (f"{word} {' '.join(repr(float(x)) for x in numbers)}" for word, numbers in words.items())


def main():
    rows = {name: robots.joints_of(robots.MODELS[name]()) for name in ("ur5", "panda")}
    arms = [(name, robots.declaration(row).splitlines(), robots.rebuilt(row)) for name, row in rows.items()]
    arms.append(("planar", planar_declaration(), planar()))
    written = [line for arm in arms for line in lines(*arm)]
    TARGET.write_text("\n".join(["# Written by tools/dynamics_matrices.py.", *written, ""]))


if __name__ == "__main__":
    main()
