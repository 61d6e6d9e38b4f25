"""Regressors of public robots by Pinocchio, in `lagrange-core/tests/spatial/regressors.txt`.

    pip install pin example-robot-data
    python3 tools/regressors.py

The declarations are those of `tools/spatial_models.py`. Pinocchio's `computeJointTorqueRegressor` orders the parameters of a body m, h_x,
h_y, h_z, J_xx, J_xy, J_yy, J_xz, J_yz, J_zz about the origin of its joint: Garofalo, Ott, Albu-Schäffer, "On the closed form computation of
the dynamic matrices and their differentiations", IROS 2013. Columns are in lines `column BODY.PARAMETER`; those that vanish in all states
are left out. `rank` is the number of base parameters: the rank of the regressors of many states, by singular values.
"""

from pathlib import Path

import numpy as np
import pinocchio as pin
import spatial_models as robots

TARGET = Path(__file__).resolve().parent.parent / "lagrange-core" / "tests" / "spatial" / "regressors.txt"
NAMES = ("mass", "mx", "my", "mz", "xx", "xy", "yy", "xz", "yz", "zz")
# Number of states, and of bodies with written columns.
WRITTEN = {"ur5": (3, 6), "panda": (2, 7), "ball_2": (3, 2), "go2_free": (1, 4)}
SAMPLES = 200
GAP = 1e-9


def regressor(model, data, q, v, a):
    own, drift = robots.turning(model, q, v)
    return own.T @ pin.computeJointTorqueRegressor(model, data, q, own @ v, own @ a + drift)


def samples(model):
    rng = np.random.default_rng(32)
    for _ in range(SAMPLES):
        q = rng.uniform(-3, 3, model.nq)
        for first in robots.quaternions(model):
            q[first : first + 4] /= np.linalg.norm(q[first : first + 4])
        yield q, rng.uniform(-3, 3, model.nv), rng.uniform(-3, 3, model.nv)


def rank(model, data):
    values = np.linalg.svd(np.vstack([regressor(model, data, *sample) for sample in samples(model)]), compute_uv=False)
    return int(np.sum(values > GAP * values[0]))


def lines(name, states, bodies):
    model = robots.rebuilt(robots.joints_of(robots.MODELS[name]()))
    data, rng = model.createData(), np.random.default_rng(23)
    yield f"system {name}"
    found = []
    for (q, v), _ in zip(robots.states(model), range(states)):
        wanted = rng.integers(-128, 128, model.nv, endpoint=True) / 64
        found.append((q, v, wanted, regressor(model, data, q, v, wanted)))
    kept = [k for k in range(10 * bodies) if any(np.any(y[:, k]) for *_, y in found)]
    for q, v, wanted, y in found:
        yield "state 0"
        yield f"rank {rank(model, data)}"
        for word, numbers in (("q", robots.positions(model, q)), ("v", v), ("wanted", wanted)):
            yield f"{word} {' '.join(repr(float(x)) for x in numbers)}"
        for k in kept:
            yield f"column l{k // 10 + 1}.{NAMES[k % 10]} {' '.join(repr(float(x)) for x in y[:, k])}"


if __name__ == "__main__":
    written = [line for name, (states, bodies) in WRITTEN.items() for line in lines(name, states, bodies)]
    TARGET.write_text("\n".join(["# Written by tools/regressors.py.", *written, ""]))
