"""Reference of `examples/quadcopter.rs`: handwritten Newton-Euler equations of a quadcopter.

    python3 tools/quadcopter.py

Mass, centre of mass and moments of inertia are sums over the parts, by the parallel axis theorem. With the thrusts f of the rotors

    m r'' = -m g e_z + R e_z (f1 + f2 + f3 + f4),   J w' = M - w x J w,   q' = q (0, w) / 2,
    M = (a (f2 - f4), a (f3 - f1), d (f1 - f2 + f3 - f4)),

where r is the centre of mass, and w is in body axes. Thrusts are scripted, f = m g/4 (1 + c sin(s t)). The motion is integrated twice in
multi-precision arithmetic by `tools/control.py`, and printed if both agree to its DIGITS.
"""

from mpmath import mp, mpf, nstr, sin

from control import DIGITS, RUNS, integrate

SHARES = ("0.2", "-0.15", "0.1", "0.25")
RATES = (3, 5, 7, 4)
END = mpf("1.5")


def parts():
    """Mass, moments of inertia about its own centre, and the centre."""
    a, h, r = mpf("0.25"), mpf("0.04"), mpf("0.11")
    m = mpf("0.9")
    wide, high = mpf("0.16"), mpf("0.06")
    yield m, (m * (wide**2 + high**2) / 12, m * (wide**2 + high**2) / 12, m * wide**2 / 6), (0, 0, 0)
    m = mpf("0.1")
    rod = m * (2 * a) ** 2 / 12
    yield m, (0, rod, rod), (0, 0, 0)
    yield m, (rod, 0, rod), (0, 0, 0)
    m = mpf("0.03")
    for place in ((a, 0, h), (0, a, h), (-a, 0, h), (0, -a, h)):
        yield m, (m * r**2 / 4, m * r**2 / 4, m * r**2 / 2), place


def geometry():
    """Returns mass, height of the centre of mass, and principal moments about it; products vanish by symmetry."""
    mass = sum(m for m, _, _ in parts())
    height = sum(m * at[2] for m, _, at in parts()) / mass
    inertia = [mpf(0)] * 3
    for m, own, (x, y, z) in parts():
        x, y, z = mpf(x), mpf(y), z - height
        steiner = (y**2 + z**2, x**2 + z**2, x**2 + y**2)
        inertia = [j + i + m * s for j, i, s in zip(inertia, own, steiner)]
    return mass, height, inertia


def rates_of(mass, inertia, g=mpf("9.81"), a=mpf("0.25"), d=mpf("0.02")):
    def rates(t, y):
        w, i, j, k = y[3:7]
        velocity, (p, q, r) = y[7:10], y[10:13]
        f = [mass * g / 4 * (1 + mpf(c) * sin(s * t)) for c, s in zip(SHARES, RATES)]
        pull = sum(f) / mass
        up = (2 * (i * k + w * j), 2 * (j * k - w * i), 1 - 2 * (i**2 + j**2))
        (jx, jy, jz) = inertia
        moment = (a * (f[1] - f[3]), a * (f[2] - f[0]), d * (f[0] - f[1] + f[2] - f[3]))
        turning = [
            (moment[0] - (jz - jy) * q * r) / jx,
            (moment[1] - (jx - jz) * r * p) / jy,
            (moment[2] - (jy - jx) * p * q) / jz,
        ]
        quaternion = [
            (-i * p - j * q - k * r) / 2,
            (w * p + j * r - k * q) / 2,
            (w * q + k * p - i * r) / 2,
            (w * r + i * q - j * p) / 2,
        ]
        return [*velocity, *quaternion, pull * up[0], pull * up[1], pull * up[2] - g, *turning]

    return rates


def motion(digits, step, columns):
    mp.dps = digits
    mass, height, inertia = geometry()
    start = [mpf(0), mpf(0), height, mpf(1)] + [mpf(0)] * 9
    return integrate(rates_of(mass, inertia), start, mpf(0), END, step, columns)


def main():
    ends = [motion(*run) for run in RUNS]
    for one, other in zip(*ends):
        assert abs(one - other) <= mpf(10) ** -DIGITS * max(1, abs(one)), (one, other)
    mass, height, inertia = geometry()
    print("mass, height of its centre, moments of inertia:", [float(nstr(x, 25)) for x in (mass, height, *inertia)])
    print("hover thrust:", float(nstr(mass * mpf("9.81") / 4, 25)))
    for name, x in zip("x y z qw qx qy qz vx vy vz wx wy wz".split(), ends[1]):
        print(name, float(nstr(x, 25)))


if __name__ == "__main__":
    main()
