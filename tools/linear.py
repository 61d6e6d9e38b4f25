"""Eigenvalues by NumPy and Riccati equations by SciPy: references of the feature `linear`.

Writes three files within seconds:
- `tests/linear/eigenvalues.csv`: eigenvalues of 1,000 matrices, one per line, as alternating real and imaginary parts. The tests repeat the
  generator of the matrices.
- `tests/linear/riccati.csv`: weights of the states and of the input, then the gains of the upright cart-pole of `tests/linear/regulators.rs`.
- `tests/linear/designs.csv`: for the same system the kind, the period, four weights and one, then the gain, or A and B over a period.

    pip install numpy scipy
    python3 tools/linear.py
"""

from pathlib import Path

import numpy as np
from scipy.linalg import expm, solve_continuous_are, solve_discrete_are

TARGET = Path(__file__).parent.parent / "tests" / "linear"


class Generator:
    """Numbers from -1/2 to 1/2 by Knuth's linear congruential generator."""

    def __init__(self):
        self.state = 1

    def next(self):
        self.state = (self.state * 6364136223846793005 + 1442695040888963407) % 2**64
        return (self.state >> 11) / 2**53 - 0.5


def matrix(generator, index):
    """Returns a full, sparse, badly scaled or antisymmetric matrix of one to six rows."""
    n = 1 + index % 6
    a = np.array([[generator.next() for _ in range(n)] for _ in range(n)])
    kind = index // 6 % 4
    if kind == 1:
        a[(a < 0.2) & ~np.eye(n, dtype=bool)] = 0
    elif kind == 2:
        a = np.array([[a[i, j] * 2.0 ** (8 * (i - j)) for j in range(n)] for i in range(n)])
    elif kind == 3:
        a = a - a.T
    return a


def cart_pole():
    """Returns A and B of a cart of 1 kg with a pole of 0.1 kg at 0.5 m, upright."""
    cart, pole, length, g = 1.0, 0.1, 0.5, 9.81
    a, b = np.zeros((4, 4)), np.zeros((4, 1))
    a[0, 2] = a[1, 3] = 1
    a[2, 1] = pole * g / cart
    a[3, 1] = (cart + pole) * g / (cart * length)
    b[2, 0], b[3, 0] = 1 / cart, 1 / (cart * length)
    return a, b


def designs():
    """Returns sampled models, their regulators and Kalman gains, and Kalman gains in continuous time; the position of the tip is measured."""
    a, b = cart_pole()
    c = np.array([[1, -0.5, 0, 0]])
    weights = [([1, 1, 1, 1], 1), ([10, 100, 1, 1], 0.1), ([1e-4] * 4, 1e4), ([1, 0, 0, 0], 1)]
    for period in [0.01, 0.1, 1.0]:
        both = expm(period * np.block([[a, b], [np.zeros((1, 5))]]))
        ad, bd = both[:4, :4], both[:4, 4:]
        yield ["held", period, 0, 0, 0, 0, 0, *ad.flatten(), *bd.flatten()]
        for q, r in weights:
            q_matrix, r_matrix = np.diag(np.array(q, float)), np.array([[float(r)]])
            x = solve_discrete_are(ad, bd, q_matrix, r_matrix)
            yield ["regulator", period, *q, r, *np.linalg.solve(r_matrix + bd.T @ x @ bd, bd.T @ x @ ad).flatten()]
            if all(q):
                p = solve_discrete_are(ad.T, c.T, q_matrix, r_matrix)
                yield ["observer", period, *q, r, *(ad @ p @ c.T @ np.linalg.inv(r_matrix + c @ p @ c.T)).flatten()]
    for q, r in weights[:3]:
        p = solve_continuous_are(a.T, c.T, np.diag(np.array(q, float)), np.array([[float(r)]]))
        yield ["observer", 0, *q, r, *(p @ c.T / r).flatten()]


def main():
    generator = Generator()
    lines = []
    for index in range(1000):
        values = np.linalg.eigvals(matrix(generator, index))
        values = [value for value in np.atleast_1d(values) if value.imag >= 0]
        lines.append(",".join(f"{value.real:.11e},{value.imag:.11e}" for value in values))
    (TARGET / "eigenvalues.csv").write_text("\n".join(lines) + "\n")
    a, b = cart_pole()
    lines = []
    for q, r in [([1, 1, 1, 1], 1), ([10, 100, 1, 1], 0.1), ([100] * 4, 1e-6), ([1e-4] * 4, 1e4), ([1, 0, 0, 0], 1)]:
        x = solve_continuous_are(a, b, np.diag(np.array(q, float)), np.array([[float(r)]]))
        gain = (b.T @ x / r)[0]
        lines.append(",".join(repr(float(value)) for value in [*q, r, *gain]))
    (TARGET / "riccati.csv").write_text("\n".join(lines) + "\n")
    lines = [",".join([kind, *(repr(float(value)) for value in values)]) for kind, *values in designs()]
    (TARGET / "designs.csv").write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
