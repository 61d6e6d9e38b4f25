"""Impacts on a Hunt–Crossley contact: the reference of tests/trajectories/compliant.

    python3 tools/compliant.py      writes tests/trajectories/compliant/impacts.csv (a minute)

A mass m hits a contact of stiffness k at the speed v. At the depth x the force is k x (1 + d x'). Taylor's method
of mpmath integrates m x'' = m g - k x (1 + d x') until x = 0. The ratio of the speeds and the duration are written with
15 digits. Without gravity, x dx = -m/k u du / (1 + d u) has the solution u - ln(1 + d u) / d = const at x = 0, so that
w = 1 - d e v satisfies w - ln w = 1 + d v - ln(1 + d v): w = -W(-(1 + d v) exp(-(1 + d v))) with Lambert's W. Both must
agree to 20 digits.
"""

from pathlib import Path

from mpmath import exp, findroot, lambertw, mp, mpf, nstr, odefun, pi, re, sqrt

MASS, STIFFNESS = mpf("1.3"), mpf(20000)
CASES = [(d, v, g) for g, speeds in (("0", ("0.01", "0.1", "1", "5")), ("9.81", ("0.5", "2", "5")))
         for d in ("0", "0.1", "0.5", "2") for v in speeds]
TARGET = Path(__file__).resolve().parent.parent / "tests" / "trajectories" / "compliant" / "impacts.csv"


def impact(d, v, g):
    """Returns the ratio of the speeds after and before, and the duration."""
    omega = sqrt(STIFFNESS / MASS)
    motion = odefun(lambda t, y: [y[1], g - omega**2 * y[0] * (1 + d * y[1])], 0, [mpf(0), v])
    end = mpf("1.5") / omega
    while motion(end)[0] > 0:
        end += mpf("0.05") / omega
    end = findroot(lambda t: motion(t)[0], (end - mpf("0.05") / omega, end), solver="anderson")
    return -motion(end)[1] / v, end


def main():
    mp.dps = 30
    rows = ["dissipation,speed,gravity,restitution,duration"]
    for case in CASES:
        d, v, g = map(mpf, case)
        ratio, duration = impact(d, v, g)
        if g == 0:
            fast = 1 + d * v
            closed = (1 - re(-lambertw(-fast * exp(-fast)))) / (d * v) if d else mpf(1)
            assert abs(ratio - closed) < mpf("1e-20"), (case, ratio, closed)
        if d == g == 0:
            assert abs(duration - pi * sqrt(MASS / STIFFNESS)) < mpf("1e-20")
        rows.append(",".join([*case, nstr(ratio, 15), nstr(duration, 15)]))
    TARGET.write_text("\n".join(rows) + "\n")


main()
