#!/usr/bin/env python3
"""Compares units of the Functional Mock-up Interface 2.0 and 3.0, run by FMPy, with `lagrange simulate` and SciPy.

    tools/fmi_check.py PATH_OF_LAGRANGE
"""

import csv
import ctypes
import math
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np
from fmpy import extract, read_model_description, simulate_fmu
from fmpy.fmi2 import FMU2Model, FMU2Slave
from fmpy.fmi3 import FMU3Model, FMU3Slave
from fmpy.validation import validate_fmu
from scipy.integrate import solve_ivp

PENDULUM = """struct DoublePendulum;
param m1: kg = 1.0, m2: kg = 1.0, l1: m = 1.0, l2: m = 1.0, g: m/s^2 = 9.81;
coord theta1: rad = 0.5, theta2: rad = 0.2;
let (x1, y1) = (l1 * sin(theta1), -l1 * cos(theta1));
let (x2, y2) = (x1 + l2 * sin(theta2), y1 - l2 * cos(theta2));
kinetic = 1/2 * m1 * (dot(x1)^2 + dot(y1)^2) + 1/2 * m2 * (dot(x2)^2 + dot(y2)^2);
potential = m1 * g * y1 + m2 * g * y2;"""

BOUNCE = """struct Bounce; param g: m/s^2 = 9.81, e in 0..=1 = 0.8; coord h: m = 1;
kinetic = 1/2 * (1 [kg]) * dot(h)^2; potential = (1 [kg]) * g * h;
event floor = h, falling => { dot(h) = -e * dot(h); }
event top = dot(h), falling => record;"""

SERVO = """struct Servo; param j = 0.4, k = 30, d = 3; input target = 0; coord angle = 0.1;
kinetic = 1/2 * j * dot(angle)^2; force angle = k * (target - angle) - d * dot(angle) - sin(angle);
output moment = k * (target - angle) - d * dot(angle);"""

ROD = """struct Rod; param m = 1.0, g = 9.81; coord x = 0.6, y = -0.8;
kinetic = 1/2 * m * (dot(x)^2 + dot(y)^2); potential = m * g * y;
constraint length = x^2 + y^2 - 1; output tension = 2 * length;"""

SPRING = """struct Spring; param m: g = 250, c: N/mm = 0.02, l: cm = 20, g: m/s^2 = 9.81;
coord r: m = 0.3, phi: rad = 0.4;
kinetic = 1/2 * m * (dot(r)^2 + (r * dot(phi))^2); potential = 1/2 * c * (r - l)^2 - m * g * r * cos(phi);
output tension: N = c * (r - l); output place: m = (r * sin(phi), -r * cos(phi));"""

DUFFING = """struct Duffing; param a = 0.4, w = 1.3; coord x = 0.5;
kinetic = 1/2 * dot(x)^2; potential = 1/4 * x^4 - 1/2 * x^2 + 0.3 * abs(x);
force x = a * cos(w * t) - 0.1 * dot(x) + if t > 2.5 { 0.2 } else { 0 };"""

MOTOR = """struct Motor; param j = 0.01, r = 0.5, l = 0.02, k = 0.05; input voltage = 6.0;
coord phi = 0; state current = 0; kinetic = 1/2 * j * dot(phi)^2; force phi = k * current;
dot(current) = (voltage - r * current - k * dot(phi)) / l; output moment = k * current;"""

SWING = """struct Swing; param m: kg = 1, l: m = 1, g: m/s^2 = 9.81, a: rad = 0.5; coord theta: rad = a / 2;
kinetic = 1/2 * m * (l * dot(theta))^2; potential = -m * g * l * cos(theta);
output height: m = -l * cos(theta);"""

TOP = """struct Top; param m = 0.5, l = 0.1, i1 = 2e-3, i3 = 1e-3, g = 9.81; gravity = (0, 0, -g);
body rotor { mass: m; centroid: (0, 0, l); inertia: (i1, i1, i3); }
ball tip = ground to rotor; output height = rotor.center.z;"""

SAMPLED = """struct Sampled; param period = 0.17; coord x = 1; discrete held = 0;
kinetic = 1/2 * dot(x)^2; force x = held - sin(x);
every period => { held = -2 * x - dot(x); }
event middle = x, crossing => { dot(x) = 0.9 * dot(x); }"""

# A compliant contact: the wheel bounces, and rolls.
WHEEL = """struct Wheel; param k = 500, d = 0.4, mu = 0.3; gravity = (0, -9.81);
coord x = 0, y = 0.3, phi = 0; start dot(x) = 1;
body wheel { mass: 1; shape: disk(0.1); center: (x, y); angle: phi; }
contact touch = wheel on ground { stiffness: k; dissipation: d; friction: mu; stiction: 0.1; }"""

END, EVERY = 3.0, 0.0625

# Declaration, values of parameters, of the initial state, and of inputs.
SYSTEMS = {
    "double pendulum": (PENDULUM, {}, {}, {}),
    "bounce": (BOUNCE, {}, {}, {}),
    "servo": (SERVO, {}, {}, {"target": 0.7}),
    "rod": (ROD, {}, {}, {}),
    "spring": (SPRING, {}, {}, {}),
    "duffing": (DUFFING, {}, {}, {}),
    "motor": (MOTOR, {}, {}, {"voltage": 4.5}),
    "swing": (SWING, {"g": 1.62, "l": 2.0, "a": 1.4}, {}, {}),
    "top": (TOP, {}, {"tip_qw": 0.8, "tip_qx": 0.6, "tip_qy": 0.0, "tip_qz": 0.0, "tip_wz": 40.0}, {}),
    "sampled": (SAMPLED, {}, {}, {}),
    "wheel": (WHEEL, {}, {}, {}),
}

VERSIONS = (2, 3)

# Largest accepted difference.
LARGEST = 1e-9
# Tolerance of both kinds. CVode of FMPy integrates by backward differentiation formulas: at 1e-12 its error for the top is 2e-8.
TOLERANCE = 1e-13
# Settings of FMPy by which it handles the events of co-simulations, at which steps end.
HANDLED = {"use_event_mode": True, "early_return_allowed": True}


def command(lagrange, *arguments):
    subprocess.run([lagrange, *map(str, arguments)], check=True)


def columns(path):
    with open(path, newline="") as file:
        names, *rows = csv.reader(file)
    return {name.split(" in ")[0]: np.array(column, float) for name, column in zip(names, zip(*rows))}


def assignments(option, values):
    return [part for name, value in values.items() for part in (f"--{option}", f"{name}={value!r}")]


def expected(lagrange, folder, file, sets, starts):
    options = assignments("set", sets) + assignments("start", starts)
    output = folder / "expected.csv"
    command(lagrange, "simulate", file, "--until", END, "--every", EVERY, "--tolerance", "1e-13", "-o", output, *options)
    return columns(output)


def simulated(unit, kind, names, values, inputs, **more):
    signal = None
    if inputs:
        signal = np.array([(0.0, *inputs.values()), (END, *inputs.values())], [("time", float)] + [(n, float) for n in inputs])
    # CVode takes at most 500 steps between two outputs.
    solver = {"solver": "CVode", "output_interval": EVERY / 4} if kind == "ModelExchange" else {"output_interval": EVERY}
    return simulate_fmu(
        str(unit), fmi_type=kind, stop_time=END, start_values=values, input=signal,
        output=names, relative_tolerance=TOLERANCE, **solver, **more,
    )


def compare(lagrange, folder, name):
    """Compares one system with `lagrange simulate`; returns the ends of its co-simulations."""
    text, parameters, starts, inputs = SYSTEMS[name]
    file = folder / "system.lag"
    file.write_text(text)
    reference = expected(lagrange, folder, file, {**parameters, **inputs}, starts)
    return [compare_version(lagrange, folder, name, version, reference) for version in VERSIONS]


def compare_version(lagrange, folder, name, version, reference):
    _, parameters, starts, inputs = SYSTEMS[name]
    unit = folder / f"{name.replace(' ', '_')}_{version}.fmu"
    command(lagrange, "fmu", folder / "system.lag", "--fmi", version, "-o", unit, *assignments("start", starts))
    problems = validate_fmu(str(unit))
    assert not problems, problems
    names = [column for column in reference if column != "t"]
    differences, last = [], None
    runs = [("CoSimulation", {}), ("ModelExchange", {})]
    if version == 3:
        runs += [("CoSimulation", HANDLED), ("CoSimulation", {"use_event_mode": True})]
    for kind, more in runs:
        result = simulated(unit, kind, names, parameters, inputs, **more)
        # At events there are two rows, the last of which is after them.
        times = result["time"]
        rows = [np.flatnonzero(np.abs(times - t) < 1e-9)[-1] for t in reference["t"]]
        scale = {column: max(1.0, np.abs(reference[column]).max()) for column in names}
        differences.append(max(np.abs(result[column][rows] - reference[column]).max() / scale[column] for column in names))
        assert differences[-1] < LARGEST, f"{name}, {kind} {more}: {differences[-1]}"
        last = last if last is not None else {column: result[column][-1] for column in names}
    handled = f"   event mode {max(differences[2:]):.1e}" if version == 3 else ""
    print(f"{name:16} FMI {version}.0   co-simulation {differences[0]:.1e}   model exchange {differences[1]:.1e}{handled}")
    return last


def solved(rates, start, until=END, first=0.0):
    return solve_ivp(rates, (first, until), start, method="DOP853", rtol=1e-13, atol=1e-14).y[:, -1]


def pendulum_rates(_, y):
    a, b, u, v = y
    mass = np.array([[2.0, math.cos(a - b)], [math.cos(a - b), 1.0]])
    forces = [-math.sin(a - b) * v * v - 2 * 9.81 * math.sin(a), math.sin(a - b) * u * u - 9.81 * math.sin(b)]
    return [u, v, *np.linalg.solve(mass, forces)]


def bounced():
    """Returns the ball after its bounces, in closed form."""
    g, e, t = 9.81, 0.8, math.sqrt(2 / 9.81)
    speed = e * g * t
    while t + 2 * speed / g < END:
        t += 2 * speed / g
        speed *= e
    rest = END - t
    return [speed * rest - g * rest**2 / 2, speed - g * rest]


def motor_rates(_, y):
    return [y[2], (4.5 - 0.5 * y[1] - 0.05 * y[2]) / 0.02, 0.05 * y[1] / 0.01]


def compare_with_scipy(ends):
    answers = {
        "double pendulum": (("theta1", "theta2", "theta1_dot", "theta2_dot"), solved(pendulum_rates, [0.5, 0.2, 0, 0])),
        "bounce": (("h", "h_dot"), bounced()),
        "motor": (("phi", "current", "phi_dot"), solved(motor_rates, [0, 0, 0])),
        "swing": (("theta", "theta_dot"), solved(lambda _, y: [y[1], -0.81 * math.sin(y[0])], [0.7, 0])),
    }
    for name, (names, answer) in answers.items():
        pairs = [(end[column], value) for end in ends[name] for column, value in zip(names, answer)]
        difference = max(abs(found - value) for found, value in pairs)
        print(f"{name:16} beside SciPy or closed forms {difference:.1e}")
        assert difference < LARGEST, name


def compare_signal(folder, version):
    """A target that jumps at t = 1."""
    unit = folder / f"servo_{version}.fmu"
    signal = np.array([(0, 0.0), (1, 0.0), (1, 0.7), (END, 0.7)], [("time", float), ("target", float)])
    rates = lambda target: lambda _, y: [y[1], (30 * (target - y[0]) - 3 * y[1] - math.sin(y[0])) / 0.4]
    answer = solved(rates(0.7), solved(rates(0.0), [0.1, 0], 1.0), END, 1.0)
    kinds = [("CoSimulation", {}), ("ModelExchange", {"solver": "CVode"})]
    kinds += [("CoSimulation", HANDLED)] if version == 3 else []
    for kind, solver in kinds:
        result = simulate_fmu(str(unit), fmi_type=kind, stop_time=END, output_interval=EVERY, input=signal,
                              output=["angle", "angle_dot"], relative_tolerance=TOLERANCE, **solver)
        difference = max(abs(result[-1][1] - answer[0]), abs(result[-1][2] - answer[1]))
        print(f"jump of an input, FMI {version}.0, {kind} {difference:.1e}")
        assert difference < LARGEST


class Opened:
    """A unit under the functions of the standard, with one interface for both versions."""

    def __init__(self, unit, is_exchange, guid=None):
        self.description = read_model_description(str(unit))
        self.reference = {variable.name: variable.valueReference for variable in self.description.modelVariables}
        self.is_three = self.description.fmiVersion.startswith("3")
        kinds = (FMU3Slave, FMU3Model) if self.is_three else (FMU2Slave, FMU2Model)
        section = self.description.modelExchange if is_exchange else self.description.coSimulation
        self.fmu = kinds[is_exchange](guid=guid or self.description.guid or self.description.instantiationToken,
                                      unzipDirectory=extract(str(unit)), modelIdentifier=section.modelIdentifier,
                                      instanceName="check")

    def start(self, **settings):
        self.fmu.instantiate(**settings)
        if self.is_three:
            self.fmu.enterInitializationMode(tolerance=1e-12, startTime=0.0)
        else:
            self.fmu.setupExperiment(tolerance=1e-12, startTime=0.0)
            self.fmu.enterInitializationMode()
        self.fmu.exitInitializationMode()
        return self.fmu

    def read(self, references):
        return self.fmu.getFloat64(references) if self.is_three else self.fmu.getReal(references)

    def get(self, *names):
        return self.read([self.reference[name] for name in names])

    def set(self, reference, value):
        write = self.fmu.setFloat64 if self.is_three else self.fmu.setReal
        return write([reference], [value])

    def other_type(self):
        return self.fmu.getInt32([0]) if self.is_three else self.fmu.getInteger([0])


def fails(action):
    """Requires an error of the unit."""
    try:
        action()
    except Exception as error:
        assert "fmi2Error" in str(error) or "status 3" in str(error) or "instantiate" in str(error), error
        return
    raise AssertionError("no error")


def check_sizes(opened):
    """Returns arguments; version 3.0 also passes numbers of values."""
    fmu, one = opened.fmu, [opened.reference["angle"]]
    for action in (
        lambda: fmu.getFloat64(one, nValues=2),
        lambda: fmu.setFloat64([opened.reference["target"]], [0.0, 1.0]),
        lambda: fmu.getDirectionalDerivative(one, one, [1.0, 1.0]),
        lambda: fmu.getAdjointDerivative(one, one, [math.nan]),
        lambda: fmu.getOutputDerivatives(one, [1]),
        lambda: fmu.enterConfigurationMode(),
        # This instance has no event mode.
        lambda: fmu.enterEventMode(),
        lambda: fmu.enterStepMode(),
    ):
        fails(action)


def check_errors(folder, version):
    unit = folder / f"servo_{version}.fmu"
    wrong = Opened(unit, False, "{00000000-0000-0000-0000-000000000000}")
    fails(wrong.fmu.instantiate)
    opened = Opened(unit, False)
    fmu = opened.start()
    for action in (
        lambda: opened.read([4711]),
        lambda: opened.set(4711, 1.0),
        opened.other_type,
        lambda: opened.set(opened.reference["target"], math.nan),
        lambda: opened.set(opened.reference["moment"], 1.0),
        lambda: opened.set(opened.reference["t"], 1.0),
        lambda: fmu.doStep(math.nan, 0.1),
        lambda: fmu.doStep(0.0, -0.1),
        lambda: fmu.doStep(5.0, 0.1),
    ):
        fails(action)
    if version == 3:
        check_sizes(opened)
    # It continues after all of these.
    fmu.doStep(0.0, 0.5)
    state = fmu.getFMUState()
    before = opened.get("angle", "angle_dot", "t")
    fmu.doStep(0.5, 0.25)
    once = opened.get("angle", "angle_dot", "t")
    fmu.setFMUState(state)
    assert opened.get("angle", "angle_dot", "t") == before != once
    bytes_of_state = fmu.serializeFMUState(state)
    fmu.doStep(0.5, 0.25)
    assert opened.get("angle", "angle_dot", "t") == once
    fmu.setFMUState(fmu.deserializeFMUState(bytes_of_state))
    assert opened.get("angle", "angle_dot", "t") == before
    fmu.freeFMUState(state)
    fails(lambda: fmu.deserializeFMUState(bytes_of_state[:-1]))
    fmu.terminate()
    fmu.freeInstance()
    print(f"errors and copies of the state, FMI {version}.0")


def check_derivatives(folder, version):
    """Checks derivatives of the servo, by hand."""
    opened = Opened(folder / f"servo_{version}.fmu", True)
    fmu = opened.start()
    angle = 0.9
    opened.set(opened.reference["angle"], angle)
    unknowns = [opened.reference[name] for name in ("der(angle)", "der(angle_dot)", "moment")]
    answers = {
        "angle": [0, (-30 - math.cos(angle)) / 0.4, -30], "angle_dot": [1, -3 / 0.4, -3], "target": [0, 30 / 0.4, 30],
    }
    for known, answer in answers.items():
        found = fmu.getDirectionalDerivative(unknowns, [opened.reference[known]], [2.0])
        assert np.allclose(found, 2 * np.array(answer), rtol=1e-14), (known, found)
    knowns = [opened.reference[name] for name in answers]
    if version == 3:
        found = fmu.getAdjointDerivative(unknowns, knowns, [2.0, 3.0, -1.0])
        assert np.allclose(found, np.array(list(answers.values())) @ [2.0, 3.0, -1.0], rtol=1e-14), found
    # Parameters and rates are not knowns; parameters are not unknowns.
    for name in ("k", "der(angle)"):
        fails(lambda: fmu.getDirectionalDerivative(unknowns, [opened.reference[name]], [1.0]))
    fails(lambda: fmu.getDirectionalDerivative([opened.reference["j"]], knowns[:1], [1.0]))
    fmu.freeInstance()
    print(f"directional derivatives, FMI {version}.0")


def check_nominals(lagrange, folder, version):
    """Checks that nominal values of states are those declared."""
    file, unit = folder / "mirror.lag", folder / "mirror.fmu"
    file.write_text("struct Mirror; coord tilt: mm nominal 0.1 = 1; state heat = 3; kinetic = 1/2 * (1 kg) * dot(tilt)^2; dot(heat) = 0;")
    command(lagrange, "fmu", file, "--fmi", version, "-o", unit)
    opened = Opened(unit, True)
    nominals = (ctypes.c_double * 3)()
    opened.start().getNominalsOfContinuousStates(nominals, 3)
    assert list(nominals) == [1e-4, 1.0, 1e-4], list(nominals)
    opened.fmu.freeInstance()
    print(f"nominal values, FMI {version}.0")


def check_periods(folder, version):
    """Checks that a running clock keeps its period if the new one is not valid."""
    opened = Opened(folder / f"sampled_{version}.fmu", False)
    fmu = opened.start()
    fmu.doStep(0.0, 0.25)
    for period in (0.0, -1.0, 1e-300):
        fails(lambda: opened.set(opened.reference["period"], period))
    assert opened.get("period") == [0.17]
    fmu.doStep(0.25, 0.25)
    fmu.terminate()
    fmu.freeInstance()
    print(f"periods of clocks, FMI {version}.0")


def check_end(lagrange, folder):
    """Checks a declared end: version 2.0 discards the step, version 3.0 requests the end."""
    file, unit = folder / "drop.lag", folder / "drop.fmu"
    file.write_text(BOUNCE.replace("{ dot(h) = -e * dot(h); }", "stop;"))
    command(lagrange, "fmu", file, "--fmi", 3, "-o", unit)
    opened = Opened(unit, False)
    _, is_end, is_early, time = opened.start().doStep(0.0, 1.0)
    assert is_end and not is_early and abs(time - math.sqrt(2 / 9.81)) < 1e-12, (is_end, is_early, time)
    print("a declared end")


def check_events(lagrange, folder):
    """Checks that steps end at the events that the program handles, and at ticks of clocks."""
    file, unit = folder / "sampled.lag", folder / "sampled.fmu"
    file.write_text("""struct Sampled; coord x = 0; discrete count = 0; kinetic = 1/2 * dot(x)^2; force x = 2;
        every 0.75 => { count = count + 1; } event one = x - 1, rising => { dot(x) = 0; }""")
    command(lagrange, "fmu", file, "--fmi", 3, "-o", unit)
    opened = Opened(unit, False)
    fmu = opened.start(eventModeUsed=True, earlyReturnAllowed=True)
    # The first tick is that at the start.
    assert fmu.updateDiscreteStates()[3:] == (True, True, 0.75)
    fails(lambda: fmu.doStep(0.0, 2.0))
    fmu.enterStepMode()
    fails(fmu.updateDiscreteStates)
    # x = t² up to t = 1.
    expected = [(0.75, 0.5625, 1.5, 1.5, 2.0), (1.0, 1.0, 2.0, 0.0, 2.0), (1.5, 1.25, 1.0, 1.0, 3.0)]
    time = 0.0
    for at, x, before, after, count in expected:
        needs_events, is_end, is_early, last = fmu.doStep(time, 2.0 - time)
        assert needs_events and is_early and not is_end and abs(last - at) < 1e-12, (needs_events, is_early, last)
        assert np.allclose(opened.get("x", "x_dot", "t"), [x, before, at], atol=1e-11), opened.get("x", "x_dot", "t")
        # The event awaits event mode.
        fails(lambda: fmu.doStep(last, 2.0 - last))
        fmu.enterEventMode()
        fmu.updateDiscreteStates()
        fmu.enterStepMode()
        assert np.allclose(opened.get("x", "x_dot", "count"), [x, after, count], atol=1e-11), (at, opened.get("x_dot", "count"))
        time = last
    assert fmu.doStep(time, 0.5) == (False, False, False, 2.0)
    fmu.terminate()
    fmu.freeInstance()
    print("event mode in co-simulation")


def check_failure(lagrange, folder, version):
    """Checks that a motion that cannot continue stops at its last good state."""
    file, unit = folder / "root.lag", folder / "root.fmu"
    file.write_text("struct Root; coord x = 1; kinetic = 1/2 * dot(x)^2; force x = -1 - 0.1 * sqrt(x);")
    command(lagrange, "fmu", file, "--fmi", version, "-o", unit)
    opened = Opened(unit, False)
    fmu = opened.start()
    fails_at_end = False
    try:
        fmu.doStep(0.0, 2.0)
    except Exception as error:
        fails_at_end = "iscard" in str(error) or "status 2" in str(error)
    x, time = opened.get("x", "t")
    assert fails_at_end and 0 < x < 1e-3 and 1.3 < time < 1.5, (fails_at_end, x, time)
    # FMPy continues after discarded steps of version 2.0, up to an error.
    if version == 2:
        fails(lambda: simulate_fmu(str(unit), fmi_type="CoSimulation", stop_time=2.0))
    print(f"a failure, FMI {version}.0")


def main():
    lagrange = str(Path(sys.argv[1]).resolve())
    with tempfile.TemporaryDirectory() as place:
        folder = Path(place)
        ends = {name: compare(lagrange, folder, name) for name in SYSTEMS}
        compare_with_scipy(ends)
        check_end(lagrange, folder)
        check_events(lagrange, folder)
        for version in VERSIONS:
            compare_signal(folder, version)
            check_errors(folder, version)
            check_derivatives(folder, version)
            check_nominals(lagrange, folder, version)
            check_periods(folder, version)
            check_failure(lagrange, folder, version)


if __name__ == "__main__":
    main()
