#!/usr/bin/env python3
"""Reference values of the examples gyroscope, t_handle and furuta, with twenty digits.

    pip install mpmath
    tools/spatial_examples.py

Nothing here uses the equations that the library derives. The gyroscope and the handle are solved by quadratures and
elliptic integrals (Goldstein, Poole, Safko, Classical Mechanics, 5.7; Landau, Lifshitz, Mechanics, 37), the Furuta
pendulum by Taylor series of the equations of Cazzolato, Prime, On the Dynamics of the Furuta Pendulum, Journal of Control
Science and Engineering (2011), eqs. 33 and 34, without damping and torques.
"""

from mpmath import mp, mpf, quad, sqrt, ellipk, sin, cos, acos, odefun, pi

mp.dps = 40


def show(name, *values):
    print(name, *(mp.nstr(value, 20) for value in values))


def gyroscope():
    """A disk on a thin axle, released at 60 degrees from the vertical with 60 rad/s about its axis."""
    m, r, h, l, g = mpf(1), mpf("0.1"), mpf("0.02"), mpf("0.12"), mpf("9.81")
    axial = m * r**2 / 2
    mass, length = mpf("0.05"), mpf("0.2")
    across = m * (r**2 / 4 + h**2 / 12) + m * l**2 + mass * length**2 / 3
    moment = (m * l + mass * length / 2) * g
    spin, start = mpf(60), cos(pi / 3)
    a, b = axial * spin / across, 2 * moment / across
    # u' ^ 2 = (u0 - u) (b (1 - u^2) - a^2 (u0 - u)), u = cos(theta); u1 is the turning point.
    root = sqrt(a**4 - 4 * b * (a**2 * start - b))
    low, high = (a**2 - root) / (2 * b), (a**2 + root) / (2 * b)
    # u = u1 + (u0 - u1) sin(x)^2 removes the square roots.
    place = lambda x: low + (start - low) * sin(x) ** 2
    rate = lambda x: 2 / sqrt(b * (high - place(x)))
    turn = lambda x: a * (start - place(x)) / (1 - place(x) ** 2)
    period = 2 * quad(rate, [0, pi / 2])
    precession = 2 * quad(lambda x: rate(x) * turn(x), [0, pi / 2])
    show("gyroscope: nutation from, to, period, precession", acos(start), acos(low), period, precession)


def t_handle():
    """Two cylinders of steel, which rotate about the axis of the middle moment of inertia, slightly disturbed."""
    r, bar, stem, density = mpf("0.01"), mpf("0.10"), mpf("0.06"), mpf(7800)
    masses = [density * pi * r**2 * length for length in (bar, stem)]
    # The bar along y with its middle in the origin, the stem along x from the bar on.
    places = [mpf(0), stem / 2]
    center = sum(m * x for m, x in zip(masses, places)) / sum(masses)
    slim = [m * (r**2 / 4 + length**2 / 12) for m, length in zip(masses, (bar, stem))]
    thick = [m * r**2 / 2 for m in masses]
    steiner = [m * (x - center) ** 2 for m, x in zip(masses, places)]
    xx = slim[0] + thick[1]
    yy = thick[0] + steiner[0] + slim[1] + steiner[1]
    zz = slim[0] + steiner[0] + slim[1] + steiner[1]
    moments = sorted([xx, yy, zz])
    show("t_handle: moments x, y, z", xx, yy, zz)
    middle = [xx, yy, zz].index(moments[1])
    rates = [mpf("0.01")] * 3
    rates[middle] = mpf(12)
    inertia = [xx, yy, zz]
    energy = sum(i * w**2 for i, w in zip(inertia, rates)) / 2
    momentum = sum((i * w) ** 2 for i, w in zip(inertia, rates))
    low, mid, top = moments
    if momentum > 2 * energy * mid:
        speed = sqrt((top - mid) * (momentum - 2 * energy * low) / (low * mid * top))
        m = (mid - low) * (2 * energy * top - momentum) / ((top - mid) * (momentum - 2 * energy * low))
    else:
        speed = sqrt((mid - low) * (2 * energy * top - momentum) / (low * mid * top))
        m = (top - mid) * (momentum - 2 * energy * low) / ((mid - low) * (2 * energy * top - momentum))
    show("t_handle: axis of the middle moment, from flip to flip", middle, 2 * ellipk(m) / speed)


def furuta():
    """A horizontal arm about the vertical with a pendulum at its end, released from rest."""
    m1, m2, l1, l2, g = mpf("0.3"), mpf("0.075"), mpf("0.278"), mpf("0.3"), mpf("9.81")
    # Thin rods: centres of mass in their middles.
    j0 = m1 * l1**2 / 3 + m2 * l1**2
    j2 = m2 * l2**2 / 3
    k = m2 * l1 * l2 / 2

    def rates(_, y):
        phi, theta, v, w = y
        s, c = sin(theta), cos(theta)
        # theta from the lower rest position; M (phi'', theta'') = b.
        mass = [[j0 + j2 * s**2, k * c], [k * c, j2]]
        b = [-2 * j2 * s * c * v * w + k * s * w**2, j2 * s * c * v**2 - m2 * g * l2 / 2 * s]
        det = mass[0][0] * mass[1][1] - mass[0][1] ** 2
        return [v, w, (b[0] * mass[1][1] - b[1] * mass[0][1]) / det, (b[1] * mass[0][0] - b[0] * mass[0][1]) / det]

    solution = odefun(rates, 0, [mpf(0), mpf("2.5"), mpf(3), mpf(0)])
    for end in (1, 3):
        show(f"furuta: phi theta phi' theta' after {end} s", *solution(end))


if __name__ == "__main__":
    gyroscope()
    t_handle()
    furuta()
