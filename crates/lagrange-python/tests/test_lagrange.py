"""The module against closed forms and SciPy."""

import os
import signal
import threading
import time

import lagrange
import numpy as np
import pytest
from scipy.integrate import solve_ivp

DOUBLE = """
    param m1: kg = 1, m2: kg = 1, l1: m = 1, l2: m = 1, g: m/s^2 = 9.81;
    coord theta1: rad = 2, theta2: rad = 1.5;
    let (x1, y1) = (l1 * sin(theta1), -l1 * cos(theta1));
    let (x2, y2) = (x1 + l2 * sin(theta2), y1 - l2 * cos(theta2));
    kinetic = 1/2 * m1 * (dot(x1)^2 + dot(y1)^2) + 1/2 * m2 * (dot(x2)^2 + dot(y2)^2);
    potential = m1 * g * y1 + m2 * g * y2;
    output height: m = y2;
"""
CART = """
    coord x = 1;
    input u;
    kinetic = 1/2 * dot(x)^2;
    potential = 2 * x^2;
    force x = u;
"""
BALL = """
    param e in 0..=1 = 0.8;
    coord h: m = 2;
    const m: kg = 1, g: m/s^2 = 10;
    kinetic = 1/2 * m * dot(h)^2;
    potential = m * g * h;
    event floor = h, falling => { dot(h) = -e * dot(h); }
    event low = dot(h) + 100 [m/s], falling => stop;
"""


def by_hand(t, y, g=9.81):
    """Returns accelerations of the double pendulum with unit masses and lengths, from its 2 x 2 system."""
    a, b, da, db = y
    mass = np.array([[2.0, np.cos(a - b)], [np.cos(a - b), 1.0]])
    force = [-np.sin(a - b) * db**2 - 2 * g * np.sin(a), np.sin(a - b) * da**2 - g * np.sin(b)]
    return np.concatenate([[da, db], np.linalg.solve(mass, force)])


def test_rates_are_those_by_hand():
    system = lagrange.System(DOUBLE)
    random = np.random.default_rng(1)
    for _ in range(50):
        y = random.uniform(-3, 3, 4)
        np.testing.assert_allclose(system.rhs(0.0, y), by_hand(0.0, y), rtol=1e-12, atol=1e-12)
        np.testing.assert_allclose(system.accelerations(0.0, y), by_hand(0.0, y)[2:], rtol=1e-12, atol=1e-12)
        cosine = np.cos(y[0] - y[1])
        np.testing.assert_allclose(system.mass_matrix(0.0, y), [[2, cosine], [cosine, 1]], atol=1e-14)
        height = -np.cos(y[0]) - np.cos(y[1])
        assert system.outputs(0.0, y) == pytest.approx({"height": height}, abs=1e-14)


def test_products_are_derived_by_name():
    system = lagrange.System(DOUBLE)
    y, a = np.array([0.3, -0.7, 0.5, 2.0]), np.array([1.0, -0.5])
    sine = np.sin(y[0] - y[1])
    coriolis = system.product("coriolis_matrix", 0.0, y)
    np.testing.assert_allclose(coriolis, [[0, sine * y[3]], [-sine * y[2], 0]], atol=1e-14)
    mass, inverse = system.mass_matrix(0.0, y), system.product("inverse_mass_matrix", 0.0, y)
    np.testing.assert_allclose(mass @ inverse, np.eye(2), atol=1e-14)
    torques = system.product("inverse_dynamics", 0.0, y, a)
    np.testing.assert_allclose(torques, mass @ (a - system.accelerations(0.0, y)), atol=1e-13)
    assert system.product("inverse_dynamics_jacobian", 0.0, y, a).shape == (2, 4)
    assert system.product("energy", 0.0, y) == system.energy(0.0, y)
    np.testing.assert_array_equal(system.with_parameters(g=0).product("bias", 0.0, 0 * y), 0)
    for arguments, message in [
        (("coriolis", 0.0, y), "there is no product `coriolis`; known are mass_matrix"),
        (("inverse_dynamics", 0.0, y), "`inverse_dynamics` needs `a`"),
        (("bias", 0.0, y, a), "`bias` does not depend on accelerations"),
        (("center_of_mass", 0.0, y), "without rigid bodies"),
    ]:
        with pytest.raises(ValueError, match=message):
            system.product(*arguments)


@pytest.mark.parametrize("text", [DOUBLE, CART.replace("input u;", "input u = 0.3;"), BALL])
def test_machine_code_has_the_bits_of_the_interpreter(text):
    compiled, interpreted = lagrange.System(text), lagrange.System(text, compile=False)
    assert compiled.is_compiled and not interpreted.is_compiled
    assert compiled.with_parameters().is_compiled
    motions = [system.simulate(until=2, every=0.1, energy=True) for system in (compiled, interpreted)]
    np.testing.assert_array_equal(motions[0].y, motions[1].y)
    np.testing.assert_array_equal(motions[0]["energy"], motions[1]["energy"])
    assert [event[:2] for event in motions[0].events] == [event[:2] for event in motions[1].events]
    y = compiled.start(**dict.fromkeys(compiled.state_names, 0.3))
    for function in ("rhs", "mass_matrix", "jacobian", "parameter_jacobian"):
        found, wanted = (getattr(system, function)(0.4, y) for system in (compiled, interpreted))
        np.testing.assert_array_equal(found, wanted)


def test_noise_follows_its_seed_and_has_its_density():
    system = lagrange.System("coord x = 0; kinetic = 1/2 * dot(x)^2; noise push, density: 0.5; force x = push;")
    for method in ("maruyama", "stochastic"):
        settings = {"until": 2, "method": method, "step": 0.1}
        default, zero, other = (system.simulate(**settings, **seed).y for seed in ({}, {"seed": 0}, {"seed": 7}))
        np.testing.assert_array_equal(default, zero)
        assert (default[-1] != other[-1]).all()
        # Velocities are normal, with the variance 0.5 * 2: the bounds are four standard errors.
        ends = system.ensemble({"x": np.zeros(4000)}, seed=7, **settings).y[:, 1]
        assert abs(ends.mean()) < 4 / 4000**0.5
        assert abs(ends.var() - 1) < 4 * (2 / 4000) ** 0.5
    for wrong in ({}, {"method": "rk4", "step": 0.1}):
        with pytest.raises(ValueError, match="`seed` chooses the noise"):
            system.simulate(until=1, seed=1, **wrong)
        with pytest.raises(ValueError, match="`seed` chooses the noise"):
            system.ensemble(until=1, seed=1, **wrong)


def test_a_ball_bounces_and_a_block_stops():
    ball = lagrange.System(
        "param g = 9.81, e = 0.6; coord h = 2; kinetic = 1/2 * dot(h)^2; potential = g * h;"
        "event floor = h, falling => impact(e); output push = floor;"
    )
    motion = ball.simulate(until=4, tolerance=1e-12)
    fall = (4 / 9.81) ** 0.5
    bounces = [fall * (1 + 2 * (0.6 - 0.6 ** (n + 1)) / 0.4) for n in range(10)]
    np.testing.assert_allclose([event[1] for event in motion.events][:10], bounces, rtol=1e-9)
    assert motion["h"][-1] == 0 and abs(motion["push"][-1] - 9.81) < 1e-12
    assert ball.accelerations(0, [1, 0]) == [-9.81] and ball.outputs(0, [1, 0]) == {"push": 0}
    stepped = ball.simulate(until=4, method="stepped", step=1e-3)
    assert abs(stepped["h"][-1]) < 1e-9
    ends = ball.ensemble({"h": [1, 2]}, until=4, method="stepped", step=1e-3)
    assert abs(ends.y).max() < 1e-9
    with pytest.raises(ValueError, match="`stepped` needs contacts"):
        lagrange.System(DOUBLE).simulate(until=1, method="stepped", step=1e-3)
    block = lagrange.System("coord x = 0; start dot(x) = 2; kinetic = 1/2 * dot(x)^2; friction rub = dot(x), 3;")
    assert abs(block.simulate(until=2)["x"][-1] - 2 / 3) < 1e-9
    assert block.rhs(0, [0, 2]).tolist() == [2, -3]
    pushed = lagrange.System("coord x = 0; input u; kinetic = 1/2 * dot(x)^2; force x = u; friction rub = dot(x), 3;")
    motion = pushed.simulate(until=2, method="stepped", step=1e-3, inputs=lambda t, y: 5.0 if t < 1 else 0.0)
    assert abs(motion["x"][-1] - (1 + 2 / 3)) < 5e-3, "2 m/s after 1 s, and 2/3 s until it stops"


def test_motions_are_those_of_scipy():
    system = lagrange.System(DOUBLE)
    motion = system.simulate(until=5, every=0.5, tolerance=1e-12, energy=True)
    times = np.linspace(0, 5, 11)
    reference = solve_ivp(by_hand, (0, 5), [2, 1.5, 0, 0], "DOP853", times, rtol=1e-13, atol=1e-13)
    np.testing.assert_allclose(motion.t, times)
    np.testing.assert_allclose(motion.y, reference.y.T, atol=1e-8)
    np.testing.assert_array_equal(motion["theta2"], motion.y[:, 1])
    np.testing.assert_allclose(motion["energy"], motion["energy"][0], rtol=1e-11)
    assert motion.units["theta1_dot"] == "rad/s" and motion.ending == "reached" and len(motion) == 11
    assert system.energy(0.0, motion.y[0]) == motion["energy"][0]


def test_methods_and_starts():
    system = lagrange.System(DOUBLE)
    reference = system.simulate(until=1, tolerance=1e-13).y[-1]
    for settings in [{"method": "taylor", "tolerance": 1e-12}, {"method": "radau", "tolerance": 1e-10}, {"method": "rk4", "step": 1e-3}, {"method": "gauss", "step": 5e-3}]:
        np.testing.assert_allclose(system.simulate(until=1, **settings).y[-1], reference, atol=1e-7)
    np.testing.assert_array_equal(system.start(theta1=0.5), [0.5, 1.5, 0, 0])
    same = [system.simulate(start, until=1).y[-1] for start in ([0.5, 1.5, 0, 0], {"theta1": 0.5}, np.array([0.5, 1.5, 0, 0]))]
    np.testing.assert_array_equal(same[0], same[1])
    np.testing.assert_array_equal(same[0], same[2])
    heavy = system.with_parameters(g=20.0)
    assert heavy.parameters["g"] == 20 and system.parameters["g"] == 9.81
    np.testing.assert_allclose(heavy.rhs(0, [1, 1, 0, 0]), by_hand(0, [1, 1, 0, 0], 20.0))


def test_series_are_refused_with_the_reason():
    late = lagrange.System("state x = 1; dot(x) = -delay(x, 1);")
    for refused in (late.simulate, late.ensemble):
        with pytest.raises(ValueError, match="`taylor` cannot be combined with delayed signals"):
            refused([[1.0]] if refused == late.ensemble else [1.0], until=1, method="taylor")
    cart = lagrange.System(CART)
    with pytest.raises(ValueError, match="inputs that change"):
        cart.simulate(cart.start(x=0), until=1, method="taylor", inputs=lambda t, y: 0.0)


def test_inputs_drive():
    system = lagrange.System(CART)
    assert system.inputs == ["u"]
    # ẍ = −4x + 2 cos t from (1, 0): x = (2 cos t + cos 2t)/3.
    motion = system.simulate(until=3, every=0.1, tolerance=1e-12, inputs=lambda t, y: 2 * np.cos(t))
    exact = (2 * np.cos(motion.t) + np.cos(2 * motion.t)) / 3
    np.testing.assert_allclose(motion["x"], exact, atol=1e-10)
    np.testing.assert_allclose(motion["u"], 2 * np.cos(motion.t))
    constant = system.with_parameters(u=4.0).simulate(until=1, tolerance=1e-12)
    np.testing.assert_allclose(constant["x"], 1.0, atol=1e-12)


def test_errors_of_inputs_arrive():
    system = lagrange.System(CART)

    def law(t, y):
        if t > 0.5:
            raise ZeroDivisionError("mine")
        return [0.0]

    with pytest.raises(ZeroDivisionError, match="mine"):
        system.simulate(until=1, inputs=law)
    with pytest.raises(lagrange.SimulationError, match="u") as failure:
        system.simulate(until=1, inputs=lambda t, y: float("nan") if t > 0.3 else 0.0)
    assert 0 < failure.value.trajectory.t[-1] <= 0.5
    with pytest.raises(ValueError, match="`inputs` returns 2 values for 1 input$"):
        system.simulate(until=1, inputs=lambda t, y: [0.0, 1.0])
    with pytest.raises(TypeError, match="the result of `inputs` must be an array of numbers, not str"):
        system.simulate(until=1, inputs=lambda t, y: "much")
    with pytest.raises(TypeError, match="function"):
        system.simulate(until=1, inputs=[1.0])


def test_parameters_need_values():
    system = lagrange.System("param k; coord x = 1; kinetic = 1/2 * dot(x)^2; potential = 1/2 * k * x^2;")
    assert np.isnan(system.parameters["k"])
    with pytest.raises(ValueError, match="`k` has no value"):
        system.simulate(until=1)
    motion = system.with_parameters(k=4).simulate(until=1, tolerance=1e-12)
    assert motion["x"][-1] == pytest.approx(np.cos(2), abs=1e-11)


def test_delays_and_parameters_out_of_range_are_refused():
    system = lagrange.System("param lag = 1, k > 0 = 1; state x = 1; let past = delay(x, lag); dot(x) = -k * past;")
    assert system.simulate(until=1)["x"][-1] == pytest.approx(0, abs=1e-12)
    with pytest.raises(ValueError, match="the delay of `past` is -1.0"):
        system.with_parameters(lag=-1).simulate(until=1)
    with pytest.raises(ValueError, match="the parameter `k` is -1.0"):
        system.with_parameters(k=-1).simulate(until=1)


def test_a_motion_that_leaves_its_range_is_kept():
    system = lagrange.System("state x in ..=1 = 0; dot(x) = 1;")
    with pytest.raises(lagrange.SimulationError, match="`x`") as failure:
        system.simulate(until=5)
    assert 0 < failure.value.trajectory["t"][-1] <= 1


def test_events():
    motion = lagrange.System(BALL).simulate(until=2, every=0.25, tolerance=1e-12)
    name, time, state = motion.events[0]
    assert name == "floor" and time == pytest.approx(np.sqrt(0.4), abs=1e-11)
    np.testing.assert_allclose(state, [0, -np.sqrt(40)], atol=1e-9)
    thrown = lagrange.System(BALL).simulate({"h": 2000}, until=50)
    assert thrown.ending == "stopped" and thrown.t[-1] == pytest.approx(10, abs=1e-9)


def test_mistakes_have_places():
    with pytest.raises(lagrange.DeclarationError) as mistake:
        lagrange.System("coord x;\nkinetic = 1/2 * dot(x)^2;\npotential = 9.81 * sine(x);")
    assert mistake.value.line == 3 and mistake.value.column == 20
    assert "sine" in str(mistake.value) and "sin" in mistake.value.help
    with pytest.raises(OSError):
        lagrange.System.read("missing.lag")
    for text in ["", "coord", "\0", "kinetic = " + "(" * 10_000]:
        with pytest.raises(lagrange.DeclarationError):
            lagrange.System(text)


def test_wrong_values_are_refused():
    system = lagrange.System(DOUBLE)
    with pytest.raises(ValueError, match="4 entries, theta1, theta2"):
        system.rhs(0, [1, 2, 3])
    with pytest.raises(ValueError, match="4 entries"):
        system.simulate([1, 2], until=1)
    with pytest.raises(ValueError, match="theta3"):
        system.simulate({"theta3": 1}, until=1)
    with pytest.raises(KeyError, match="m3"):
        system.with_parameters(m3=1)
    with pytest.raises(KeyError, match="phi"):
        system.simulate(until=1)["phi"]
    with pytest.raises(ValueError, match="unknown method `euler`"):
        system.simulate(until=1, method="euler")
    with pytest.raises(ValueError, match="needs a `step`"):
        system.simulate(until=1, method="rk4")
    with pytest.raises((ValueError, lagrange.SimulationError)):
        system.simulate([float("nan"), 0, 0, 0], until=1)
    with pytest.raises(ValueError, match="the start of `theta1` is missing or NaN"):
        system.simulate({"theta1": float("nan")}, until=1)
    with pytest.raises(ValueError, match="not both zero$"):
        system.simulate(until=1, tolerance=0)
    for until in [float("nan"), float("inf")]:
        with pytest.raises((ValueError, lagrange.SimulationError)):
            system.simulate(until=until)
    with pytest.raises(ValueError, match="e"):
        lagrange.System(BALL).with_parameters(e=2.0).simulate(until=1)


def test_values_of_other_types_are_refused_by_name():
    system = lagrange.System(CART)
    model = system.linearise([0, 0])
    cases = [
        (lambda: system.rhs(0, "much"), "`y` must be an array of numbers, not str"),
        (lambda: system.energy(0, ["a", "b"]), "`y` must be an array of numbers, not list"),
        (lambda: system.mass_matrix(0, np.zeros((2, 2))), "`y` must be an array of numbers, not ndarray"),
        (lambda: system.input_jacobian(0, 7), "`y` must be an array of numbers, not int"),
        (lambda: system.simulate("far", until=1), "`start` must be an array of numbers, not str"),
        (lambda: system.linearise("rest"), "`state` must be an array of numbers, not str"),
        (lambda: system.equilibrium("rest"), "`near` must be an array of numbers, not str"),
        (lambda: system.equilibrium(hold="x"), "`hold` must be a list of names, not str"),
        (lambda: system.equilibrium(trim=[1]), "`trim` must be a list of names, not list"),
        (lambda: system.with_parameters(k="stiff"), "`k` must be a number, not str"),
        (lambda: system.start(x=[1]), "`x` must be a number, not list"),
        (lambda: model.lqr("large", [[1]]), "`q` must be an array of numbers with two dimensions, not str"),
        (lambda: model.lqr(np.eye(2), [1]), "`r` must be an array of numbers with two dimensions, not list"),
    ]
    for call, message in cases:
        with pytest.raises(TypeError) as error:
            call()
        assert str(error.value) == message


def test_columns_are_shared_and_cannot_be_written_to():
    system = lagrange.System(CART)
    for found in (system.simulate(until=1, every=0.1), system.ensemble({"x": [1, 2]}, until=1)):
        assert found["x"] is found["x"] and found.columns()["x"] is found["x"] and found["t"] is found.t
        assert found["x"].flags.c_contiguous
        with pytest.raises(ValueError, match="read-only"):
            found["x"][0] = 7
        copied = found["x"].copy()
        copied[0] = 7
        assert found.y[0, 0] != 7
        found.y[0, 0] = 7


def test_frames():
    motion = lagrange.System(DOUBLE).simulate(until=1, every=0.1)
    pandas = pytest.importorskip("pandas")
    frame = motion.to_pandas()
    assert isinstance(frame, pandas.DataFrame) and list(frame.columns) == motion.names and len(frame) == 11
    polars = pytest.importorskip("polars")
    assert isinstance(motion.to_polars(), polars.DataFrame)


def test_texts():
    system = lagrange.System(DOUBLE)
    assert "theta1" in system.equations() and r"\ddot" in system.latex()
    assert system._repr_latex_().startswith("$$")
    header, source = system.c()
    assert "#include" in source and "double" in header


def test_threads_run_side_by_side():
    system = lagrange.System(DOUBLE)
    ends = [None] * 4

    def run(index):
        ends[index] = system.simulate({"theta1": 1 + 0.1 * index}, until=20).y[-1]

    threads = [threading.Thread(target=run, args=[index]) for index in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for index, end in enumerate(ends):
        np.testing.assert_array_equal(end, system.simulate({"theta1": 1 + 0.1 * index}, until=20).y[-1])


PUSHED_CART = """
param M: kg = 1, m: kg = 0.2, l: m = 0.5, g: m/s^2 = 9.81;
coord x: m, theta: rad = 3;
input u: N = 0;
let p = (x + l * sin(theta), -l * cos(theta));
kinetic = 1/2 * M * dot(x)^2 + kinetic_energy(m, dot(p));
potential = m * g * p.y;
force x = u;
output tip: m = p.x;
"""


def test_linear_models_are_those_by_hand():
    system = lagrange.System(PUSHED_CART)
    upright = system.equilibrium({"x": 0.5}, hold=["x"])
    np.testing.assert_allclose(upright.state, [0.5, np.pi, 0, 0], atol=1e-12)
    assert upright.inputs == {} and upright.freedom == 0 and upright.iterations > 0
    model = system.linearise(upright.state)
    assert model.states == ["x", "theta", "x_dot", "theta_dot"] and model.inputs == ["u"]
    heavy, light, length, g = 1, 0.2, 0.5, 9.81
    a = np.zeros((4, 4))
    a[0, 2] = a[1, 3] = 1
    a[2, 1], a[3, 1] = light * g / heavy, (heavy + light) * g / (heavy * length)
    np.testing.assert_allclose(model.a, a, atol=1e-12)
    np.testing.assert_allclose(model.b[:, 0], [0, 0, 1 / heavy, 1 / (heavy * length)], atol=1e-12)
    np.testing.assert_allclose(model.c, [[1, -length, 0, 0]], atol=1e-12)
    assert model.d.shape == (1, 1) and model.is_stable is False
    grows = max(mode.eigenvalue.real for mode in model.modes())
    assert abs(grows - np.sqrt(a[3, 1])) < 1e-12


def test_regulators_are_those_of_scipy():
    linalg = pytest.importorskip("scipy.linalg")
    model = lagrange.System(PUSHED_CART).linearise({"theta": np.pi})
    q, r = np.diag([1.0, 2, 3, 4]), np.array([[0.5]])
    gain = model.lqr(q, r)
    solution = linalg.solve_continuous_are(model.a, model.b, q, r)
    np.testing.assert_allclose(gain, np.linalg.solve(r, model.b.T @ solution), rtol=1e-8)
    assert np.linalg.eigvals(model.a - model.b @ gain).real.max() < 0
    with pytest.raises(ValueError, match="q"):
        model.lqr([[1.0], [2.0, 3.0]], r)


def test_equilibria_follow_parameters_and_trim_inputs():
    text = "param m = 1, l = 1, g = 9.81; coord a; input u = 0; kinetic = 1/2*m*(l*dot(a))^2;"
    text += "potential = -m*g*l*cos(a); force a = u;"
    arm = lagrange.System(text)
    held = arm.equilibrium({"a": 0.3}, hold=["a"], trim=["u"])
    assert abs(held.inputs["u"] - 9.81 * np.sin(0.3)) < 1e-12
    heavier = arm.with_parameters(m=2.0).equilibrium({"a": 0.3}, hold=["a"], trim=["u"])
    assert abs(heavier.inputs["u"] - 2 * 9.81 * np.sin(0.3)) < 1e-12
    mode = arm.linearise([0.0, 0.0]).modes()[0]
    assert abs(mode.natural_frequency - np.sqrt(9.81)) < 1e-12 and set(mode.shape) == {"a", "a_dot"}
    with pytest.raises(lagrange.EquilibriumError, match="`b` is not among") as raised:
        arm.equilibrium({"a": 0.3}, hold=["b"])
    assert raised.value.state[0] == 0.3
    with pytest.raises(lagrange.DeclarationError, match="clock|discrete"):
        lagrange.System(text + "discrete n = 0; every 0.1 => { n = n + 1; }").linearise([0.0, 0.0, 0.0])
    with pytest.raises(lagrange.EquilibriumError, match="remains"):
        lagrange.System("coord x = 0; kinetic = dot(x)^2; potential = -x;").equilibrium()


def test_jacobians_are_those_of_differences():
    system = lagrange.System(DOUBLE)
    random = np.random.default_rng(2)
    for y in [np.zeros(4), *random.uniform(-3, 3, (20, 4))]:
        steps = 1e-6 * np.eye(4)
        differences = np.array([(by_hand(0, y + step) - by_hand(0, y - step)) / 2e-6 for step in steps]).T
        np.testing.assert_allclose(system.jacobian(0.0, y), differences, rtol=1e-6, atol=1e-6)
    cart = lagrange.System(CART)
    np.testing.assert_array_equal(cart.jacobian(0, [3, 5]), [[0, 1], [-4, 0]])
    heavy = lagrange.System("param k = 1; coord x = 1; kinetic = 1/2 * dot(x)^2; potential = 1/2 * k * x^2;")
    heavy.jacobian(0, [0, 0])
    np.testing.assert_array_equal(heavy.with_parameters(k=9).jacobian(0, [0, 0]), [[0, 1], [-9, 0]])
    with pytest.raises(ValueError, match="4 entries"):
        system.jacobian(0, [1, 2])
    stiff = solve_ivp(system.rhs, (0, 1), [2, 1.5, 0, 0], "Radau", jac=system.jacobian, rtol=1e-8, atol=1e-8)
    np.testing.assert_allclose(stiff.y[:, -1], system.simulate(until=1, tolerance=1e-12).y[-1], atol=1e-5)


@pytest.mark.parametrize("settings", [{}, {"method": "taylor"}, {"method": "radau", "tolerance": 1e-8}, {"method": "rk4", "step": 0.01}])
def test_motions_of_ensembles_have_the_bits_of_single_runs(settings):
    system = lagrange.System(DOUBLE)
    random = np.random.default_rng(3)
    starts, lengths = random.uniform(-2, 2, (9, 4)), random.uniform(0.5, 2, 9)
    ends = system.ensemble(starts, until=2, parameters={"l1": lengths, "g": 5}, **settings)
    assert len(ends) == 9 and ends.failures == [] and ends.y.shape == (9, 4)
    for start, length, end, height in zip(starts, lengths, ends.y, ends["height"]):
        single = system.with_parameters(l1=length, g=5).simulate(start, until=2, **settings)
        np.testing.assert_array_equal(end, single.y[-1])
        assert height == single["height"][-1]
    np.testing.assert_array_equal(ends["l1"], lengths)
    np.testing.assert_array_equal(ends.t, np.full(9, 2.0))
    for threads in [1, 3]:
        again = system.ensemble(starts, until=2, parameters={"l1": lengths, "g": 5}, threads=threads, **settings)
        np.testing.assert_array_equal(again.y, ends.y)


def test_ensembles_are_the_closed_form():
    system = lagrange.System("param k; coord x = 1; input u; kinetic = 1/2 * dot(x)^2; potential = 1/2 * k * x^2; force x = u;")
    k, u = np.linspace(1, 5, 40), np.linspace(-1, 1, 40)
    ends = system.ensemble({"x": 2.0}, until=3, parameters={"k": k, "u": u}, tolerance=1e-12)
    np.testing.assert_allclose(ends["x"], u / k + (2 - u / k) * np.cos(3 * np.sqrt(k)), atol=1e-10)
    starts = system.with_parameters(k=4).ensemble({"x": k, "x_dot": 1}, until=1, tolerance=1e-12)
    np.testing.assert_allclose(starts["x"], k * np.cos(2) + np.sin(2) / 2, atol=1e-10)
    declared = system.ensemble(until=0.5, parameters={"k": [4]}, tolerance=1e-12)
    assert declared["x"] == pytest.approx([np.cos(1)], abs=1e-11) and len(declared) == 1
    assert list(ends.to_pandas().columns) == ends.names == ["t", "x", "x_dot", "k", "u"]


def test_failures_of_ensembles_leave_the_other_runs():
    system = lagrange.System("coord x = 1; start dot(x) = -1; kinetic = 1/2 * dot(x)^2; force x = -sqrt(x);")
    ends = system.ensemble([[1, -1], [1, 9], [np.nan, 0]], until=2)
    assert [index for index, _, _, _ in ends.failures] == [0, 2]
    _, time, state, message = ends.failures[0]
    assert 0.5 < time < 1 and abs(state[0]) < 1e-6 and "x_ddot" in message and "motion 0" in message
    assert np.isnan(ends.y[[0, 2]]).all() and np.isfinite(ends.y[1]).all()
    np.testing.assert_array_equal(ends.y[1], system.simulate([1, 9], until=2).y[-1])
    stopped = lagrange.System(BALL).ensemble({"h": [2, 2000]}, until=50, parameters={"e": [2.0, 0.5]})
    assert [index for index, _, _, _ in stopped.failures] == [0] and "e" in stopped.failures[0][3]
    assert stopped.t[1] == pytest.approx(10, abs=1e-9)


def test_ensembles_that_make_no_sense_are_refused():
    system = lagrange.System(DOUBLE)
    cases = [
        ((), {}, ValueError, "number of runs"),
        (([],), {}, ValueError, "at least one"),
        ((np.zeros((0, 4)),), {}, ValueError, "at least one"),
        (([1, 2, 3, 4],), {}, ValueError, r"shape \(runs, 4\)"),
        ((np.zeros((2, 3)),), {}, ValueError, "4 entries, theta1"),
        ((np.zeros((2, 2, 4)),), {}, ValueError, r"shape \(runs, 4\)"),
        (("many",), {}, ValueError, r"shape \(runs, 4\)"),
        (({"theta3": [1]},), {}, ValueError, "theta3"),
        (({"theta1": "far"},), {}, ValueError, "theta1"),
        ((np.zeros((2, 4)),), {"parameters": {"m1": [1, 2, 3]}}, ValueError, "`m1` is for 3 runs, and `starts` for 2"),
        ((np.zeros((2, 4)),), {"parameters": {"m3": [1, 2]}}, KeyError, "m3"),
        ((np.zeros((2, 4)),), {"method": "euler"}, ValueError, "euler"),
        ((np.zeros((2, 4)),), {"threads": 0}, ValueError, "thread"),
        ((np.zeros((2, 4)),), {"until": float("nan")}, ValueError, "end|time"),
        ((np.zeros((2, 4)),), {"tolerance": -1}, ValueError, "tolerance"),
    ]
    for arguments, settings, kind, message in cases:
        with pytest.raises(kind, match=message):
            system.ensemble(*arguments, **{"until": 1, **settings})
    with pytest.raises(ValueError, match="`k` has no value"):
        lagrange.System("param k; coord x = 1; kinetic = k * dot(x)^2;").ensemble([[1, 0]], until=1)


def test_ensembles_let_other_threads_run():
    system = lagrange.System(DOUBLE)
    done, steps = threading.Event(), []

    def compute():
        system.ensemble(np.full((8, 4), 1.0), until=40)
        done.set()

    thread = threading.Thread(target=compute)
    thread.start()
    while not done.wait(0.001):
        steps.append(None)
    thread.join()
    assert len(steps) > 5


def test_sampled_inputs_are_linear_between_samples():
    cart = lagrange.System("coord x = 0; start dot(x) = 0; input u, w; kinetic = 1/2 * dot(x)^2; force x = u + 2*w;")
    # The first input jumps at 1, and the last values hold.
    times, values = np.array([0, 1, 1, 2.0]), np.array([[0, 0], [1, 0], [3, 0], [3, 1.0]])
    motion = cart.simulate(until=3, every=1, inputs=(times, values))
    np.testing.assert_allclose(motion["x_dot"], [0, 0.5, 4.5, 9.5], rtol=0, atol=1e-12)
    np.testing.assert_allclose(motion["x"], [0, 1 / 6, 2.5, 9.5], rtol=0, atol=1e-12)
    one = lagrange.System(CART)
    ramp = one.simulate(until=2, every=0.5, inputs=([0, 2], [0, 4]))
    law = one.simulate(until=2, every=0.5, inputs=lambda t, y: 2 * t)
    np.testing.assert_allclose(ramp.y, law.y, rtol=0, atol=1e-9)
    # Constant before the first sample.
    late = one.simulate(until=2, every=0.5, method="rk4", step=0.01, inputs=([5], [1]))
    np.testing.assert_allclose(late["x"], 0.25 + 0.75 * np.cos(2 * late.t), rtol=0, atol=1e-7)


def test_sampled_inputs_that_make_no_sense_are_refused():
    cart = lagrange.System(CART)
    cases = [
        (([], []), ValueError, "0 values of inputs for 0 times"),
        (([0, 1], [1]), ValueError, "1 values of inputs for 2 times"),
        (([0, 1], [[1, 2], [3, 4]]), ValueError, "2 values at a time for 1 inputs"),
        (([1, 0], [1, 2]), ValueError, "decrease from 1 to 0"),
        (([0, 1], [1, np.nan]), ValueError, "finite"),
        (7, TypeError, "a pair of times and values"),
        (("early", [1]), TypeError, "times of `inputs` must be an array of numbers, not str"),
        (([0, 1], "much"), TypeError, "values of `inputs` must be an array of numbers, with a column"),
        (([0, 1], [[1], ["b"]]), TypeError, "values of `inputs` must be an array of numbers, with a column"),
    ]
    for inputs, error, message in cases:
        with pytest.raises(error, match=message):
            cart.simulate(until=1, inputs=inputs)


def interrupted(compute):
    """Returns the `KeyboardInterrupt` of a computation that Ctrl-C interrupts, and the seconds until then."""
    # Processes in the background ignore Ctrl-C.
    signal.signal(signal.SIGINT, signal.default_int_handler)
    interrupt = threading.Timer(1, lambda: os.kill(os.getpid(), signal.SIGINT))
    began = time.monotonic()
    interrupt.start()
    with pytest.raises(KeyboardInterrupt) as raised:
        compute()
    return raised.value, time.monotonic() - began


def test_simulations_can_be_interrupted():
    cart = lagrange.System(CART)
    error, seconds = interrupted(lambda: cart.simulate(until=1e7, every=1e3))
    assert seconds < 5
    assert 0 < error.trajectory.t[-1] < 1e7
    _, seconds = interrupted(lambda: cart.simulate(until=1e7, every=1e3, inputs=lambda t, y: 0.0))
    assert seconds < 5


def test_ensembles_can_be_interrupted():
    cart = lagrange.System(CART)
    starts = np.ones((20_000, 2))
    _, seconds = interrupted(lambda: cart.ensemble(starts, until=1e4, threads=2))
    assert seconds < 5
    _, seconds = interrupted(lambda: cart.ensemble(starts[:1], until=1e7))
    assert seconds < 5, "a single motion of an ensemble ends, too"
    ends = cart.ensemble(starts[:3], until=1)
    assert len(ends.t) == 3
