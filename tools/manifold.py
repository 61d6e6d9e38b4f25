"""Distances and depths of random pairs of cuboids and capsules: the reference of
crates/lagrange-runtime/src/manifold/tests.rs.

    python3 tools/manifold.py      writes crates/lagrange-runtime/src/manifold/tests/gaps.csv (minutes)

The distance of the cores is a least-squares problem with bounds, min |p - q| over the points of both, solved by the
active sets of SciPy (BVLS). The depth is the distance of the origin from the nearest facet of the convex hull of all
differences of corners, by Qhull. Neither uses separating axes. Pairs come from a linear congruential generator.
"""

from itertools import product
from pathlib import Path

import numpy as np
from scipy.optimize import lsq_linear
from scipy.spatial import ConvexHull

COUNT = 12_000
TARGET = (
    Path(__file__).resolve().parent.parent / "crates/lagrange-runtime/src/manifold/tests/gaps.csv"
)
state = 1


def within(a, b):
    global state
    state = (state * 6_364_136_223_846_793_005 + 1_442_695_040_888_963_407) % 2**64
    return a + (b - a) * (state >> 11) / 2**53


def block(reach, is_aligned):
    """Returns centre, axes in rows, half sizes and radius. Aligned blocks have sizes and positions in tenths."""
    grid = (lambda x: np.floor(10 * x) / 10) if is_aligned else (lambda x: x)
    is_cuboid = within(0, 1) < 0.6
    half = [grid(within(0.1, 1.1)) for _ in range(3)]
    radius = 0.0 if is_cuboid else grid(within(0.1, 0.6))
    if not is_cuboid:
        half[0] = half[1] = 0.0
    w, x, y, z = (within(-1, 1) for _ in range(4))
    length = np.sqrt(w * w + x * x + y * y + z * z)
    w, x, y, z = (1, 0, 0, 0) if is_aligned else (w / length, x / length, y / length, z / length)
    axes = np.array([
        [1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)],
        [2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)],
        [2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)],
    ])
    center = np.array([grid(within(-reach, reach)) for _ in range(3)])
    return center, axes, np.array(half), radius


def distance(first, second):
    """Returns the distance of the cores."""
    (c1, a1, h1, _), (c2, a2, h2, _) = first, second
    columns = [h * a for h, a in zip(h1, a1) if h > 0] + [-h * a for h, a in zip(h2, a2) if h > 0]
    found = lsq_linear(np.array(columns).T, c2 - c1, (-1, 1), "bvls", tol=1e-15)
    return np.linalg.norm(found.fun)


def depth(first, second):
    """Returns the depth of overlapping cores; zero if they are flat together."""
    corners = lambda c, a, h: [c + np.array(s) * h @ a for s in product([-1, 1], repeat=3)]
    a, b = (np.unique(np.round(corners(*block[:3]), 15), axis=0) for block in (first, second))
    if len(a) == len(b) == 2:
        return 0.0
    hull = ConvexHull([p - q for p in a for q in b])
    return max(0.0, -hull.equations[:, 3].max())


lines = []
for number in range(COUNT):
    is_aligned = number % 8 == 0
    first, second = block(1.6, is_aligned), block(0.5, is_aligned)
    gap = distance(first, second)
    if gap < 1e-9:
        gap = -depth(first, second)
    lines.append(f"{gap - first[3] - second[3]:.12g}")
TARGET.parent.mkdir(exist_ok=True)
TARGET.write_text("\n".join(lines) + "\n")
