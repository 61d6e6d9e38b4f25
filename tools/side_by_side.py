#!/usr/bin/env python3
"""The systems of docs/coming_from/side_by_side.md by SymPy, heyoka, Drake and lagrange, for the tables there.

    pip install sympy scipy heyoka drake example-robot-data
    tools/side_by_side.py [--write]

All programs are taken from the page, and the double pendulum by SymPy and lagrange from docs/coming_from/sympy.md. The tools must
agree before they are timed. `--write` replaces the tables of the page.
"""

import logging
import multiprocessing
import os
import re
import shutil
import subprocess
import sys
import sysconfig
import tempfile
import time
import warnings
from pathlib import Path
from queue import Empty

import heyoka
import numpy as np
import pydrake.all as drake
import sympy
from scipy.integrate import solve_ivp

from sympy_peers import ROOT, error, reference, shortest

PAGE = ROOT / "docs" / "coming_from" / "side_by_side.md"
SYMPY_PAGE = ROOT / "docs" / "coming_from" / "sympy.md"
CRATE = ROOT / "target" / "side_by_side"
ROBOT = "cmeel.prefix/share/example-robot-data/robots/panda_description/urdf/panda.urdf"
WANTED = 1e-9
# Seconds after which SymPy's equations of the arm are given up.
LIMIT = 900
TOLERANCES = [10 ** (-k / 2) for k in range(10, 32)]
AGREEMENT = 1e-9

# Start and end of motions, and a state at which accelerations are compared.
MOTIONS = {
    "double_pendulum": ([2.0, 1.5, 0.0, 0.0], 10.0, [0.5, 1.0, 0.3, -0.2]),
    "cart_pole": ([0.0, 3.0, 0.0, 0.0], 5.0, [0.1, 2.5, 0.2, -0.4]),
}
# The state of examples/cart_pole.rs, from 160-bit arithmetic.
LEFT_ALONE = [0.020042933115664744, -2.8370839467698628, -0.05381218271021493, -1.2409591267549178]
PANDA = (
    [0.1, -0.3, 0.2, -1.5, 0.3, 1.2, 0.4, 0.01, 0.02],
    [0.3, -0.2, 0.1, 0.4, -0.1, 0.2, -0.3, 0.05, 0.02],
    [0.5, 0.1, -0.4, 0.3, 0.2, -0.6, 0.7, 0.1, -0.1],
)
TOOLS = ["SymPy", "heyoka", "Drake", "here"]

MAIN = """
use std::hint::black_box;
use std::time::Instant;
use lagrange::integrate::{Verner98, integrate};

mod double_pendulum { DOUBLE_PENDULUM }
mod cart_pole { CART_POLE }
mod panda { include!("panda.rs"); }

fn shortest(times: usize, mut run: impl FnMut()) -> f64 {
    (0..times).map(|_| { let start = Instant::now(); run(); start.elapsed().as_secs_f64() }).fold(f64::MAX, f64::min)
}

macro_rules! measure {
    ($system:expr, $start:expr, $end:expr, $at:expr) => {{
        let (system, at): (_, [f64; 4]) = ($system, $at);
        let (q, v) = ([at[0], at[1]], [at[2], at[3]]);
        println!("{:?}", system.acceleration(0.0, &q, &v));
        // Each evaluation depends on the one before.
        println!("{}", shortest(2000, || {
            let mut a = [0.0; 2];
            (0..1000).for_each(|_| a = system.acceleration(0.0, &[0, 1].map(|i| q[i] + 1e-9 * a[i]), &v));
            black_box(a);
        }) / 1000.0);
        for tolerance in TOLERANCES {
            let run = || integrate(&system, 0.0, $start, $end, &Verner98::tolerance(tolerance), |_, _| {}).expect("a motion");
            println!("{} {:?}", shortest(200, || { black_box(run()); }), run());
        }
    }};
}

fn main() {
    measure!(double_pendulum::DoublePendulum::default(), START_0, END_0, AT_0);
    measure!(cart_pole::CartPole::default(), START_1, END_1, AT_1);
    let (arm, (mut q, v, a)) = (panda::Panda::default(), PANDA);
    println!("{:?}", arm.inverse_dynamics(0.0, &q, &v, &a));
    println!("{}", shortest(2000, || (0..1000).for_each(|_| q[0] += 1e-12 * arm.inverse_dynamics(0.0, &q, &v, &a)[0])) / 1000.0);
}
"""


def programs(page):
    text = page.read_text(encoding="utf-8")
    return re.findall(r"```(python|rust)\n(.*?)```", text, re.DOTALL)


def lines(program):
    return len([line for line in program.strip().splitlines() if line.strip()])


def executed(program, repeat=3):
    """Runs a program; returns its names and the shortest time."""
    names = {}

    def run():
        names.clear()
        # Code that heyoka has compiled before is not compiled again.
        heyoka.llvm_state.clear_memcache()
        exec(program, names)

    return names, shortest(run, repeat)


def measured(build, rates, run, system, evaluation):
    """A column of the table: seconds to build, of one evaluation, and of a motion that reaches the wanted error."""
    start, _, at = MOTIONS[system]
    expected = reference() if system == "double_pendulum" else LEFT_ALONE
    reaching = next((tolerance for tolerance in TOLERANCES if error(run(start, tolerance), expected) <= WANTED), None)
    motion = reaching and shortest(lambda: run(start, reaching), 5)
    return {"acceleration": list(rates(at)), "build": build, "evaluation": evaluation, "motion": motion}


def by_sympy(program, system):
    start, end, at = MOTIONS[system]
    values = {"m": 1, "l": 1, "g": 9.81} if system == "double_pendulum" else {"M": 1, "m": 0.1, "l": 0.5, "g": 9.81}
    names = {}

    def prepare():
        names.clear()
        exec(program, names)
        method = names["method"]
        solved = method.mass_matrix.LUsolve(method.forcing).subs({names[name]: value for name, value in values.items()})
        solved = solved.subs({names["u"]: 0}) if "u" in names else solved
        variables = [*method.q, *method.u]
        names["acceleration"] = sympy.lambdify(variables, list(solved), modules="math", cse=True)

    build = shortest(prepare, 3)
    acceleration = names["acceleration"]

    def run(start, tolerance):
        rates = lambda _, y: [y[2], y[3], *acceleration(*y.tolist())]
        return solve_ivp(rates, (0, end), start, method="DOP853", rtol=tolerance, atol=tolerance).y[:, -1]

    evaluation = shortest(lambda: [acceleration(*at) for _ in range(1000)], 50) / 1000
    return measured(build, lambda at: acceleration(*at), run, system, evaluation)


def by_heyoka(program, system):
    _, end, at = MOTIONS[system]
    names, build = executed(program)
    parameters = [0.0] if system == "cart_pole" else []

    def run(start, tolerance):
        if tolerance not in runs:
            runs[tolerance] = heyoka.taylor_adaptive(names["rates"], start, pars=parameters, tol=tolerance)
        integrator = runs[tolerance]
        integrator.time, integrator.state[:] = 0.0, start
        integrator.propagate_until(end)
        return list(integrator.state)

    runs = {}
    variables = [variable for variable, _ in names["rates"]]
    compiled = heyoka.cfunc([rate for _, rate in names["rates"]][2:], variables)
    many = np.tile(np.array(at)[:, None], 10000)
    with_parameters = {"pars": np.array([[0.0] * 10000])} if parameters else {}
    evaluation = shortest(lambda: compiled(many, **with_parameters), 50) / 10000
    once = {"pars": parameters} if parameters else {}
    return measured(build, lambda at: compiled(at, **once), run, system, evaluation)


def by_drake(program, system):
    _, end, at = MOTIONS[system]
    names, build = executed(program)
    plant, context = names["plant"], names["context"]
    # The second angle of the pendulum is relative there.
    is_relative = system == "double_pendulum"
    there = lambda y: [y[0], y[1] - y[0], y[2], y[3] - y[2]] if is_relative else list(y)
    back = lambda y: [y[0], y[0] + y[1], y[2], y[2] + y[3]] if is_relative else list(y)

    def rates(at):
        plant.SetPositionsAndVelocities(context, there(at))
        change = plant.EvalTimeDerivatives(context).CopyToVector()
        return back([0, 0, *change[2:]])[2:]

    def run(start, tolerance):
        simulator = drake.Simulator(plant, context.Clone())
        drake.ResetIntegratorFromFlags(simulator, "runge_kutta5", 0.1)
        simulator.get_mutable_integrator().set_target_accuracy(tolerance)
        plant.SetPositionsAndVelocities(simulator.get_mutable_context(), there(start))
        simulator.AdvanceTo(end)
        return back(plant.GetPositionsAndVelocities(simulator.get_context()))

    evaluation = shortest(lambda: [rates(at) for _ in range(1000)], 10) / 1000
    return measured(build, rates, run, system, evaluation)


def panda_by_drake(program):
    names, build = executed(program)
    plant, context = names["plant"], names["context"]
    q, v, a = PANDA
    forces = drake.MultibodyForces(plant)

    def torques():
        plant.SetPositions(context, q)
        plant.SetVelocities(context, v)
        plant.CalcForceElementsContribution(context, forces)
        return plant.CalcInverseDynamics(context, a, forces)

    return {"torques": torques(), "build": build, "evaluation": shortest(lambda: [torques() for _ in range(1000)], 10) / 1000}


def within_limit(function, program, queue):
    queue.put(function(program))


def limited(function, program):
    """The result of a function in a process of its own; `None` if it takes too long."""
    context = multiprocessing.get_context("fork")
    queue = context.Queue()
    process = context.Process(target=within_limit, args=(function, program, queue))
    process.start()
    try:
        return queue.get(timeout=LIMIT)
    except Empty:
        return None
    finally:
        process.kill()


def panda_by_sympy(program):
    begin = time.perf_counter()
    names, _ = executed(program, 1)
    system = names["system"]
    functions = sympy.lambdify([list(system.q), list(system.u)], [system.mass_matrix, system.forcing], modules="numpy", cse=True)
    build = time.perf_counter() - begin
    q, v, a = PANDA

    def torques():
        mass, forcing = functions(q, v)
        return mass @ np.array(a) - forcing.ravel()

    return {"torques": torques(), "build": build, "evaluation": shortest(lambda: [torques() for _ in range(20)], 10) / 20}


def by_lagrange(pendulum, cart, robot):
    (CRATE / "src").mkdir(parents=True, exist_ok=True)
    manifest = f'[package]\nname = "side_by_side"\nedition = "2024"\n\n[workspace]\n\n[dependencies]\nlagrange = {{ path = "{ROOT}" }}\n'
    (CRATE / "Cargo.toml").write_text(manifest, encoding="utf-8")
    command = ["cargo", "run", "--quiet", "--package", "lagrange-cli", "--", "urdf", robot]
    declaration = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True).stdout
    (CRATE / "src" / "panda.rs").write_text(declaration, encoding="utf-8")
    builds = [seconds_to_build(program) for program in (pendulum, cart, declaration)]
    body = MAIN.replace("DOUBLE_PENDULUM", pendulum).replace("CART_POLE", cart)
    for index, (start, end, at) in enumerate(MOTIONS.values()):
        body = body.replace(f"START_{index}", str(start)).replace(f"END_{index}", str(end)).replace(f"AT_{index}", str(at))
    body = body.replace("TOLERANCES", str(TOLERANCES)).replace("PANDA", str(PANDA))
    (CRATE / "src" / "main.rs").write_text(body, encoding="utf-8")
    run = ["cargo", "run", "--quiet", "--release"]
    output = iter(subprocess.run(run, cwd=CRATE, capture_output=True, text=True, check=True).stdout.splitlines())
    columns = []
    for system, build in zip(MOTIONS, builds):
        expected = reference() if system == "double_pendulum" else LEFT_ALONE
        column = {"acceleration": eval(next(output)), "build": build, "evaluation": float(next(output))}
        runs = [next(output).split(" ", 1) for _ in TOLERANCES]
        runs = [(float(seconds), error(eval(state), expected)) for seconds, state in runs]
        columns.append({**column, "motion": next((seconds for seconds, off in runs if off <= WANTED), None)})
    return columns, {"torques": eval(next(output)), "build": builds[2], "evaluation": float(next(output))}


def seconds_to_build(declaration):
    """Seconds of a release build of a crate with one declaration, after its dependencies."""
    build, main = ["cargo", "build", "--quiet", "--release"], CRATE / "src" / "main.rs"
    main.write_text("fn main() {}\n", encoding="utf-8")
    subprocess.run(build, cwd=CRATE, check=True)
    main.write_text(f"#![allow(dead_code)]\n{declaration}\nfn main() {{}}\n", encoding="utf-8")
    return shortest(lambda: subprocess.run(build, cwd=CRATE, check=True), 1)


def check(name, columns, key):
    first, *others = columns
    size = max(abs(value) for value in first[key])
    for other in others:
        assert error(other[key], first[key]) < AGREEMENT * size, (name, columns)


def amount(seconds):
    for limit, unit, factor in [(1e-6, "ns", 1e9), (1e-3, "µs", 1e6), (1, "ms", 1e3)]:
        if seconds is not None and seconds < limit:
            return f"{factor * seconds:.2g} {unit}" if factor * seconds < 100 else f"{factor * seconds:.0f} {unit}"
    return "–" if seconds is None else f"{seconds:.2g} s" if seconds < 10 else f"{seconds:.0f} s"


def table(title, tools, rows):
    text = f"| {title}| {' | '.join(tools)} |\n|---|{'---|' * len(tools)}\n"
    return text + "".join(f"| {name} | {' | '.join(cells)} |\n" for name, cells in rows)


def main():
    logging.getLogger("drake").setLevel(logging.ERROR)
    warnings.simplefilter("ignore")
    pythons = [program for language, program in programs(PAGE) if language == "python"]
    cart = next(program for language, program in programs(PAGE) if language == "rust").split("# fn main")[0]
    sympy_program, pendulum = (dict(reversed(programs(SYMPY_PAGE)))[language] for language in ("python", "rust"))
    pendulum = pendulum.split("fn main")[0]
    heyoka_pendulum, drake_pendulum, sympy_cart, heyoka_cart, drake_cart, drake_panda, sympy_panda = pythons
    robot = Path(sysconfig.get_paths()["purelib"]) / ROBOT

    (own_pendulum, own_cart), own_panda = by_lagrange(pendulum, cart, robot)
    tables = {}
    for system, written, own in [
        ("double_pendulum", [sympy_program, heyoka_pendulum, drake_pendulum, pendulum], own_pendulum),
        ("cart_pole", [sympy_cart, heyoka_cart, drake_cart, cart], own_cart),
    ]:
        peers = [by(program, system) for by, program in zip([by_sympy, by_heyoka, by_drake], written)]
        columns = [*peers, own]
        check(system, columns, "acceleration")
        end = MOTIONS[system][1]
        tables[system] = table("", TOOLS, [
            ("lines of the model", [str(lines(program)) for program in written]),
            ("from source text to a function", [amount(column["build"]) for column in columns]),
            ("accelerations once", [amount(column["evaluation"]) for column in columns]),
            (f"{end:.0f} s to an error of {WANTED:.0e}".replace("e-0", "e-"), [amount(column["motion"]) for column in columns]),
        ])
        print(tables[system])
    with tempfile.TemporaryDirectory() as folder:
        shutil.copy(robot, folder)
        here = Path.cwd()
        try:
            os.chdir(folder)
            arms = [limited(panda_by_sympy, sympy_panda), panda_by_drake(drake_panda), own_panda]
        finally:
            os.chdir(here)
    check("panda", [arm for arm in arms if arm], "torques")
    late = {"build": None, "evaluation": None}
    arms = [arm or late for arm in arms]
    tables["panda"] = table("", ["SymPy", "Drake", "here"], [
        ("lines of the model", [str(lines(sympy_panda)), str(lines(drake_panda)), "1 command"]),
        ("from source text to a function", [amount(arm["build"]) if arm is not late else f"not in {LIMIT // 60} min" for arm in arms]),
        ("inverse dynamics once", [amount(arm["evaluation"]) for arm in arms]),
    ])
    print(tables["panda"])
    if sys.argv[1:] == ["--write"]:
        text = PAGE.read_text(encoding="utf-8")
        for number, new in enumerate(tables.values()):
            found = list(re.finditer(r"^TABLE \w+\n|^\| \|(.*\n\|)+.*\n", text, re.MULTILINE))[number]
            text = text[: found.start()] + new + text[found.end() :]
        PAGE.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
