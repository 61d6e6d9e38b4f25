"""Six systems in Python: this module, heyoka, CasADi and SciPy, for docs/peers.md.

    pip install heyoka casadi scipy sympy numpy ./crates/lagrange-python
    python3 tools/python_peers.py            # a few minutes; `--write` rewrites the table of docs/peers.md

Each tool gets the energies, written for it as its users would. Equations for SciPy are derived by SymPy and compiled by `lambdify`; those
for CasADi are derivatives of its expressions. The time to make lasts until the first evaluation. Each tool runs at the loosest tolerance
that reaches the error at all samples; the time to run is the shortest of several. Both are processor times. References are series of
heyoka at rounding accuracy, with which the other tools have to agree.
"""

import argparse
import datetime
import importlib.metadata
import inspect
import math
import os
import pathlib
import re
import textwrap
import time

import casadi as ca
import heyoka as hy
import lagrange
import numpy as np
import sympy as sp
from scipy.integrate import solve_ivp

PAGE = pathlib.Path(__file__).parent.parent / "docs/peers.md"
TOOLS = ["lagrange", "heyoka", "CasADi", "SciPy"]
# Tolerances that are tried, in parts of the error.
TOLERANCES = [10 ** (1 - k / 2) for k in range(0, 13)]
# Runs and constructions are repeated for this long, in seconds.
BUDGET = 0.3
# Largest difference of any tool.
AGREEMENT = 1e-5


class DoublePendulum:
    title, start, end, error, stiff = "double pendulum", [2.0, 1.5, 0.0, 0.0], 10.0, 1e-9, False

    def lagrange():
        return lagrange.System("""
            coord a, b;
            let (x, y) = (sin(a), -cos(a));
            let (u, w) = (x + sin(b), y - cos(b));
            kinetic = 1/2 * (dot(x)^2 + dot(y)^2 + dot(u)^2 + dot(w)^2);
            potential = 9.81 * (y + w);
        """)

    def heyoka():
        a, b, v, w = hy.make_vars("a", "b", "v", "w")
        kinetic = v**2 + w**2 / 2 + v * w * hy.cos(a - b)
        potential = -9.81 * (2 * hy.cos(a) + hy.cos(b))
        return hy.lagrangian(kinetic - potential, [a, b], [v, w])

    def casadi():
        q, v = ca.SX.sym("q", 2), ca.SX.sym("v", 2)
        x = ca.cumsum(ca.vertcat(ca.sin(q[0]), ca.sin(q[1])))
        y = ca.cumsum(ca.vertcat(-ca.cos(q[0]), -ca.cos(q[1])))
        speeds = ca.jtimes(ca.vertcat(x, y), q, v)
        return q, v, rates_in_casadi(ca.sumsqr(speeds) / 2 - 9.81 * ca.sum1(y), q, v)

    def scipy():
        a, b, v, w = q_and_v = sp.symbols("a b v w")
        x, y = [sp.sin(a), sp.sin(a) + sp.sin(b)], [-sp.cos(a), -sp.cos(a) - sp.cos(b)]
        speeds = sp.Matrix(x + y).jacobian([a, b]) * sp.Matrix([v, w])
        return rates_by_sympy(speeds.dot(speeds) / 2 - sp.Float(9.81) * sum(y), [a, b], [v, w])


class CartPole:
    title, start, end, error, stiff = "pole on a cart with friction", [0.0, 2.5, 0.0, 0.0], 10.0, 1e-9, False

    def lagrange():
        return lagrange.System("""
            coord s, a;
            let (x, y) = (s + 0.5 * sin(a), -0.5 * cos(a));
            kinetic = 1/2 * dot(s)^2 + 1/2 * 0.3 * (dot(x)^2 + dot(y)^2);
            potential = 0.3 * 9.81 * y;
            dissipation = 1/2 * 0.1 * dot(s)^2;
        """)

    def heyoka():
        s, a, v, w = hy.make_vars("s", "a", "v", "w")
        kinetic = v**2 / 2 + 0.15 * (v**2 + v * w * hy.cos(a) + 0.25 * w**2)
        potential = -0.3 * 9.81 * 0.5 * hy.cos(a)
        return hy.lagrangian(kinetic - potential, [s, a], [v, w], 0.05 * v**2)

    def casadi():
        q, v = ca.SX.sym("q", 2), ca.SX.sym("v", 2)
        x, y = q[0] + 0.5 * ca.sin(q[1]), -0.5 * ca.cos(q[1])
        kinetic = v[0] ** 2 / 2 + 0.15 * ca.sumsqr(ca.jtimes(ca.vertcat(x, y), q, v))
        return q, v, rates_in_casadi(kinetic - 0.3 * 9.81 * y, q, v, ca.vertcat(-0.1 * v[0], 0))

    def scipy():
        s, a, v, w = sp.symbols("s a v w")
        x, y = s + sp.sin(a) / 2, -sp.cos(a) / 2
        speeds = sp.Matrix([x, y]).jacobian([s, a]) * sp.Matrix([v, w])
        kinetic = v**2 / 2 + 0.15 * speeds.dot(speeds)
        return rates_by_sympy(kinetic - 0.3 * 9.81 * y, [s, a], [v, w], [-0.1 * v, 0])


class Kepler:
    title, start, end, error, stiff = "Kepler, e = 0.6", [0.4, 0.0, 0.0, 2.0], 10 * math.pi, 1e-9, False

    def lagrange():
        return lagrange.System("""
            coord x, y;
            kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
            potential = -1 / sqrt(x^2 + y^2);
        """)

    def heyoka():
        x, y, v, w = hy.make_vars("x", "y", "v", "w")
        return hy.lagrangian((v**2 + w**2) / 2 + (x**2 + y**2) ** -0.5, [x, y], [v, w])

    def casadi():
        q, v = ca.SX.sym("q", 2), ca.SX.sym("v", 2)
        return q, v, rates_in_casadi(ca.sumsqr(v) / 2 + 1 / ca.norm_2(q), q, v)

    def scipy():
        x, y, v, w = sp.symbols("x y v w")
        return rates_by_sympy((v**2 + w**2) / 2 + 1 / sp.sqrt(x**2 + y**2), [x, y], [v, w])


class HeavyTop:
    title, start, end, error, stiff = "heavy top", [0.5, 0.0, 0.0, 0.0, 0.0, 20.0], 5.0, 1e-9, False

    def lagrange():
        return lagrange.System("""
            coord tilt, turn, spin;
            kinetic = 1/2 * 0.3 * (dot(tilt)^2 + dot(turn)^2 * sin(tilt)^2)
                + 1/2 * 0.1 * (dot(spin) + dot(turn) * cos(tilt))^2;
            potential = 9.81 * 0.5 * cos(tilt);
        """)

    def heyoka():
        a, b, c, u, v, w = hy.make_vars("a", "b", "c", "u", "v", "w")
        kinetic = 0.15 * (u**2 + (v * hy.sin(a)) ** 2) + 0.05 * (w + v * hy.cos(a)) ** 2
        return hy.lagrangian(kinetic - 9.81 * 0.5 * hy.cos(a), [a, b, c], [u, v, w])

    def casadi():
        q, v = ca.SX.sym("q", 3), ca.SX.sym("v", 3)
        kinetic = 0.15 * (v[0] ** 2 + (v[1] * ca.sin(q[0])) ** 2) + 0.05 * (v[2] + v[1] * ca.cos(q[0])) ** 2
        return q, v, rates_in_casadi(kinetic - 9.81 * 0.5 * ca.cos(q[0]), q, v)

    def scipy():
        a, b, c, u, v, w = sp.symbols("a b c u v w")
        kinetic = 0.15 * (u**2 + (v * sp.sin(a)) ** 2) + 0.05 * (w + v * sp.cos(a)) ** 2
        return rates_by_sympy(kinetic - 9.81 * 0.5 * sp.cos(a), [a, b, c], [u, v, w])


class Chain:
    title, start, end, error, stiff = "chain of three pendulums", [1.0] * 3 + [0.0] * 3, 5.0, 1e-9, False

    def lagrange():
        return lagrange.System("""
            coord q[3];
            for i in 0..3 {
                let p[i] = (if i > 0 { p[i-1] } else { (0, 0) }) + (sin(q[i]), -cos(q[i]));
                kinetic = kinetic_energy(1, dot(p[i]));
                potential = gravitational_energy(1, 9.81, p[i].y);
            }
        """)

    def heyoka():
        q, v = (hy.make_vars(*[f"{name}{i}" for i in range(3)]) for name in "qv")
        below = [[3 - max(i, j) for j in range(3)] for i in range(3)]
        kinetic = sum(below[i][j] / 2 * v[i] * v[j] * hy.cos(q[i] - q[j]) for i in range(3) for j in range(3))
        potential = -9.81 * sum(below[i][i] * hy.cos(q[i]) for i in range(3))
        return hy.lagrangian(kinetic - potential, q, v)

    def casadi():
        q, v = ca.SX.sym("q", 3), ca.SX.sym("v", 3)
        x, y = ca.cumsum(ca.sin(q)), -ca.cumsum(ca.cos(q))
        speeds = ca.jtimes(ca.vertcat(x, y), q, v)
        return q, v, rates_in_casadi(ca.sumsqr(speeds) / 2 - 9.81 * ca.sum1(y), q, v)

    def scipy():
        q, v = list(sp.symbols("q:3")), list(sp.symbols("v:3"))
        x = [sum(sp.sin(a) for a in q[: i + 1]) for i in range(3)]
        y = [-sum(sp.cos(a) for a in q[: i + 1]) for i in range(3)]
        speeds = sp.Matrix(x + y).jacobian(q) * sp.Matrix(v)
        return rates_by_sympy(speeds.dot(speeds) / 2 - 9.81 * sum(y), q, v)


class StiffPendulum:
    title, start, end, error, stiff = "pendulum on a stiff spring", [1.0, 1.0, 0.0, 0.0], 4.0, 1e-6, True

    def lagrange():
        return lagrange.System("""
            coord r, a;
            kinetic = 1/2 * (dot(r)^2 + r^2 * dot(a)^2);
            potential = 1/2 * 1e8 * (r - 1)^2 - 9.81 * r * cos(a);
            dissipation = 1/2 * 2e4 * dot(r)^2;
        """)

    def heyoka():
        r, a, v, w = hy.make_vars("r", "a", "v", "w")
        potential = 0.5e8 * (r - 1) ** 2 - 9.81 * r * hy.cos(a)
        return hy.lagrangian((v**2 + r**2 * w**2) / 2 - potential, [r, a], [v, w], 1e4 * v**2)

    def casadi():
        q, v = ca.SX.sym("q", 2), ca.SX.sym("v", 2)
        potential = 0.5e8 * (q[0] - 1) ** 2 - 9.81 * q[0] * ca.cos(q[1])
        kinetic = (v[0] ** 2 + q[0] ** 2 * v[1] ** 2) / 2
        return q, v, rates_in_casadi(kinetic - potential, q, v, ca.vertcat(-2e4 * v[0], 0))

    def scipy():
        r, a, v, w = sp.symbols("r a v w")
        potential = 0.5e8 * (r - 1) ** 2 - 9.81 * r * sp.cos(a)
        return rates_by_sympy((v**2 + r**2 * w**2) / 2 - potential, [r, a], [v, w], [-2e4 * v, 0])


SYSTEMS = [DoublePendulum, CartPole, Kepler, HeavyTop, Chain, StiffPendulum]


def rates_in_casadi(lagrangian, q, v, forces=0):
    momenta = ca.gradient(lagrangian, v)
    bias = ca.jtimes(momenta, q, v) - ca.gradient(lagrangian, q) - forces
    return ca.vertcat(v, -ca.solve(ca.jacobian(momenta, v), bias))


def rates_by_sympy(lagrangian, q, v, forces=None):
    momenta = sp.Matrix([lagrangian]).jacobian(v).T
    forcing = sp.Matrix([lagrangian]).jacobian(q).T - momenta.jacobian(q) * sp.Matrix(v) + sp.Matrix(forces or [0] * len(q))
    terms = sp.lambdify([*q, *v], [momenta.jacobian(v), forcing], cse=True)

    def rates(_, y):
        mass, forcing = terms(*y)
        return np.concatenate([y[len(q) :], np.linalg.solve(mass, forcing)[:, 0]])

    return rates


def times(system):
    return np.linspace(0, system.end, 101)


# A maker returns a function that computes the states at all samples.


def make_lagrange(system, tolerance):
    declared = system.lagrange()
    declared.rhs(0, system.start)
    method = "radau" if system.stiff else "verner"

    def run():
        return declared.simulate(system.start, until=system.end, every=system.end / 100, method=method, tolerance=tolerance).y

    return run


def make_heyoka(system, tolerance):
    integrator = hy.taylor_adaptive(system.heyoka(), system.start, tol=tolerance, compact_mode=len(system.start) > 4)

    def run():
        integrator.time, integrator.state[:] = 0, system.start
        return integrator.propagate_grid(times(system))[-1]

    return run


def make_casadi(system, tolerance):
    q, v, rates = system.casadi()
    equations = {"x": ca.vertcat(q, v), "ode": rates}
    options = {"reltol": tolerance, "abstol": tolerance, "max_num_steps": 1_000_000}
    if not system.stiff:
        options |= {"linear_multistep_method": "adams", "nonlinear_solver_iteration": "functional"}
    integrator = ca.integrator("motion", "cvodes", equations, 0, times(system), options)

    def run():
        return integrator(x0=system.start)["xf"].full().T

    return run


def make_scipy(system, tolerance):
    rates = system.scipy()
    method = "Radau" if system.stiff else "DOP853"

    def run():
        return solve_ivp(rates, (0, system.end), system.start, method, times(system), rtol=tolerance, atol=tolerance).y.T

    return run


MAKERS = dict(zip(TOOLS, [make_lagrange, make_heyoka, make_casadi, make_scipy]))
SHARED = {"lagrange": [], "heyoka": [], "CasADi": [rates_in_casadi], "SciPy": [rates_by_sympy]}


def lines(function):
    """Returns the number of lines of a function, without its head and empty ones."""
    return sum(1 for line in inspect.getsource(function).splitlines()[1:] if line.strip() not in ("", '""")'))


def lines_of(tool, system):
    return sum(lines(function) for function in [getattr(system, tool.lower()), MAKERS[tool], *SHARED[tool]])


def forget():
    """Empties what tools remember of systems made before."""
    hy.llvm_state.clear_memcache()
    sp.core.cache.clear_cache()


def shortest(action):
    """Returns the shortest of several processor times in seconds, which other programs change little."""
    best, end = math.inf, time.process_time() + BUDGET
    while math.isinf(best) or time.process_time() < end:
        began = time.process_time()
        action()
        best = min(best, time.process_time() - began)
    return best


def error_of(states, reference):
    """Returns the largest difference at a sample, relative to quantities larger than one."""
    return np.max(np.abs(states - reference) / np.maximum(1, np.abs(reference).max(axis=0)))


def measured(tool, system, reference):
    """Returns lines, and the seconds to make and to run at the loosest tolerance that reaches the error, if one does."""
    make = MAKERS[tool]
    for tolerance in (system.error * part for part in TOLERANCES):
        run = make(system, tolerance)
        states = run()
        assert states.shape == reference.shape, (tool, states.shape)
        error = error_of(states, reference)
        if error <= system.error:
            break
    # Tools that do not reach the error still compute this motion, and not another.
    assert error < AGREEMENT, f"{tool} differs by {error:.1e} on the {system.title}"
    seconds = shortest(run) if error <= system.error else None

    def make_afresh():
        forget()
        make(system, tolerance)

    return lines_of(tool, system), shortest(make_afresh), seconds


def reference_of(system):
    """Returns the states of series at rounding accuracy, which tighter settings would not improve."""
    return make_heyoka(system, 1e-18)()


def machine():
    """Returns processor, load and versions in sentences."""
    models = re.findall(r"model name\s*: (.*)", pathlib.Path("/proc/cpuinfo").read_text())
    packages = ", ".join(f"{name} {importlib.metadata.version(name)}" for name in ("heyoka", "casadi", "scipy", "sympy", "numpy"))
    load = os.getloadavg()[0]
    text = (
        f"Measured on {datetime.date.today()} on {len(models)} cores of {models[0]}. Other programs had {load:.1f} "
        f"runnable processes. Versions: {packages}."
    )
    return textwrap.fill(text, 100)


def table():
    """Measures all systems, and returns the rows of the table."""
    rows = ["| system | error | | " + " | ".join(TOOLS) + " |", "|---" * (3 + len(TOOLS)) + "|"]
    for system in SYSTEMS:
        reference = reference_of(system)
        found = [measured(tool, system, reference) for tool in TOOLS]
        for name, index, scale, digits in (("lines", 0, 1, 0), ("to make, ms", 1, 1e3, 1), ("to run, ms", 2, 1e3, 3)):
            head = f"{system.title} | {system.error:.0e}" if index == 0 else " | "
            cells = ["–" if result[index] is None else f"{scale * result[index]:.{digits}f}" for result in found]
            rows.append(f"| {head} | {name} | {' | '.join(cells)} |")
            print(rows[-1], flush=True)
    return "\n".join(rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--write", action="store_true", help="rewrite the table of docs/peers.md")
    is_written = parser.parse_args().write
    # Otherwise heyoka loads what an earlier run compiled.
    hy.llvm_state.set_diskcache_enabled(False)
    text = f"{machine()}\n\n{table()}"
    if is_written:
        begin, end = "<!-- begin python -->\n", "<!-- end python -->"
        before, rest = PAGE.read_text().split(begin)
        PAGE.write_text(f"{before}{begin}\n{text}\n\n{end}{rest.split(end)[1]}")


if __name__ == "__main__":
    main()
