"""References of `examples/long_chain.rs` and `examples/spring_lattice.rs`: handwritten equations of motion, for SciPy.

    python3 tools/many_of_a_kind.py

The chain of n point masses on massless rods, in absolute angles, obeys

    sum_j S_ij l^2 cos(a_i - a_j) a_j'' = -sum_j S_ij l^2 sin(a_i - a_j) a_j'^2 - S_ii g l sin a_i,

where S_ij is the mass below the lower joint. The lattice obeys Newton's law with the forces of its springs. Both are integrated by
DOP853 with two tolerances, and printed if they agree to the digits that the examples compare.
"""

import numpy
from scipy.integrate import solve_ivp

AGREEMENT = 1e-12


def chain_rates(t, y, n=30, m=0.1, l=0.1, g=9.81):
    angles, speeds = y[:n], y[n:]
    below = m * (n - numpy.arange(n))
    shared = numpy.minimum.outer(below, below) * l**2
    turned = angles[:, None] - angles[None, :]
    forces = -(shared * numpy.sin(turned)) @ speeds**2 - below * g * l * numpy.sin(angles)
    return numpy.concatenate([speeds, numpy.linalg.solve(shared * numpy.cos(turned), forces)])


def lattice_rates(t, y, n=5, k=20.0, rest=1.0):
    u, v, rates = y[: n * n].reshape(n, n), y[n * n : 2 * n * n].reshape(n, n), y[2 * n * n :]
    # Masses with the fixed points around them.
    x, z = numpy.meshgrid(numpy.arange(-1.0, n + 1), numpy.arange(-1.0, n + 1))
    x[1:-1, 1:-1] += u
    z[1:-1, 1:-1] += v
    masses = 1 + numpy.add.outer(numpy.arange(n), numpy.arange(n)) / 10
    force = numpy.zeros((2, n, n))
    inner = (slice(1, -1), slice(1, -1))
    for shift, axis in ((1, 0), (-1, 0), (1, 1), (-1, 1)):
        dx = (numpy.roll(x, shift, axis) - x)[inner]
        dz = (numpy.roll(z, shift, axis) - z)[inner]
        length = numpy.sqrt(dx**2 + dz**2)
        force += k * (length - rest) / length * numpy.array([dx, dz])
    return numpy.concatenate([rates, (force / masses).reshape(-1)])


def integrated(rates, start, end):
    """Returns the final state, if both tolerances agree."""
    found = [
        solve_ivp(rates, (0, end), start, method="DOP853", rtol=1e-13, atol=1e-15, max_step=step).y[:, -1]
        for step in (5e-4, 2.5e-4)
    ]
    difference = abs(found[0] - found[1]).max()
    assert difference < AGREEMENT, difference
    print(f"both sizes of steps agree to {difference:.1e}")
    return found[1]


def main():
    n = 30
    start = numpy.concatenate([0.3 + 0.01 * numpy.arange(n), numpy.zeros(n)])
    print("chain, accelerations at the start", [f"{chain_rates(0, start)[n + i]:.16e}" for i in (0, 14, 29)])
    end = integrated(chain_rates, start, 1.0)
    print("chain, angles", [f"{end[i]:.16e}" for i in (0, 14, 29)])
    print("chain, speed", f"{end[n + 29]:.16e}")

    n = 5
    rows, columns = numpy.indices((n, n))
    start = numpy.concatenate(
        [(0.2 * numpy.sin(1 + rows + 2 * columns)).reshape(-1), (0.2 * numpy.cos(3 * rows - columns)).reshape(-1), numpy.zeros(2 * n * n)]
    )
    end = integrated(lattice_rates, start, 2.0)
    print("lattice, u", [f"{end[n * i + j]:.16e}" for i, j in ((0, 0), (2, 2), (4, 1))])
    print("lattice, v", [f"{end[n * n + n * i + j]:.16e}" for i, j in ((0, 0), (2, 2), (4, 1))])
    print("lattice, rate of u", f"{end[2 * n * n + n * 2 + 2]:.16e}")


if __name__ == "__main__":
    main()
