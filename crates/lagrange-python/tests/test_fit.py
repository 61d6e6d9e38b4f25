"""Fits against SciPy, closed forms and the motions behind the data."""

import os
import signal
import threading
import time

import lagrange
import numpy as np
import pytest
from scipy.integrate import solve_ivp

OSCILLATOR = """
    param m: kg = 1, k: N/m = 3, c: N*s/m = 0.1;
    coord x: m = 1;
    kinetic = 1/2 * m * dot(x)^2;
    potential = 1/2 * k * x^2;
    dissipation = 1/2 * c * dot(x)^2;
    output twice: m = 2 * x;
"""
TIMES = np.linspace(0.1, 6, 60)


def noisy(scale=1e-2):
    """Returns x = exp(-t/10) cos(2 t) from (1, -0.1), the solution for k = 4.01 and c = 0.2, with noise."""
    return np.exp(-TIMES / 10) * np.cos(2 * TIMES) + scale * np.random.default_rng(5).standard_normal(60)


def test_fits_are_those_of_scipy():
    optimize = pytest.importorskip("scipy.optimize")
    x = noisy()
    fit = lagrange.System(OSCILLATOR).fit({"t": TIMES, "x": x}, vary={"k": (0.1, 10), "c": None, "x": None}, start=[1, -0.1], begin=0, tolerance=1e-11)

    def residuals(p):
        k, c, start = p
        run = solve_ivp(lambda t, y: [y[1], -k * y[0] - c * y[1]], (0, 6), [start, -0.1], "DOP853", TIMES, rtol=1e-11, atol=1e-12)
        return run.y[0] - x

    reference = optimize.least_squares(residuals, [3, 0.1, 1], x_scale=[1, 0.1, 1], jac="3-point", xtol=1e-12, ftol=1e-14)
    np.testing.assert_allclose(list(fit.values.values()), reference.x, rtol=1e-6)
    covariance = np.linalg.inv(reference.jac.T @ reference.jac) * 2 * reference.cost / 57
    np.testing.assert_allclose(fit.covariance, covariance, rtol=1e-4, atol=1e-9)
    errors = np.sqrt(np.diag(covariance))
    np.testing.assert_allclose(list(fit.standard_errors.values()), errors, rtol=1e-4)
    np.testing.assert_allclose(fit.correlations, covariance / np.outer(errors, errors), atol=1e-4)
    assert list(fit.values) == ["k", "c", "x"] and fit.degrees_of_freedom == 57
    assert fit.chi_square == pytest.approx(2 * reference.cost, rel=1e-8)
    assert fit.system.parameters["k"] == fit.values["k"] and fit.start[0] == fit.values["x"]
    assert "k = 4.0" in str(fit) and fit.iterations > 0


def test_fits_find_what_made_the_data():
    system = lagrange.System(OSCILLATOR)
    exact = np.exp(-TIMES / 10) * np.cos(2 * TIMES)
    missing = [None if index % 7 == 0 else 2 * value for index, value in enumerate(exact)]
    fit = system.fit({"t": TIMES, "x": exact, "twice": missing}, vary=["k", "c"], start=[1, -0.1], noise={"x": 0.01, "twice": 0.02}, begin=0)
    assert fit.values == pytest.approx({"k": 4.01, "c": 0.2}, abs=1e-7)
    bound = system.fit({"t": TIMES, "x": exact}, vary={"k": (None, 3.5), "c": (0, None)}, start=[1, -0.1], begin=0)
    assert bound.values["k"] == 3.5 and bound.standard_errors["k"] is None
    assert system.parameters["k"] == 3
    # For a swinging rod, by an event, and for an input.
    arm = lagrange.System("param g = 9; coord a = 0.5; input u = 0; kinetic = 1/2*dot(a)^2; potential = -g*cos(a); force a = u; event low = a, crossing => { dot(a) = 0.9 * dot(a); }")
    times = np.linspace(0, 3, 31)
    made = arm.with_parameters(g=9.81, u=0.3).simulate(until=3, every=0.1, tolerance=1e-12)
    fit = arm.fit({"t": times, "a": made["a"]}, vary=["g", "u"])
    assert fit.values == pytest.approx({"g": 9.81, "u": 0.3}, abs=1e-6)


def test_fits_name_what_data_do_not_tell():
    system = lagrange.System(OSCILLATOR)
    with pytest.raises(lagrange.FitError, match="do not tell all") as raised:
        system.fit({"t": TIMES, "x": noisy()}, vary={"m": (0.1, 10), "k": (0.1, 100), "c": (0, 10)}, start=[1, -0.1], begin=0)
    best = raised.value.fit
    # Mass, stiffness and damping may all grow by the same factor.
    np.testing.assert_allclose(np.abs(list(best.weakest.values())), np.full(3, np.sqrt(1 / 3)), atol=1e-4)
    assert best.covariance is None and best.correlations is None
    with pytest.raises(lagrange.FitError, match="1 iterations"):
        system.fit({"t": TIMES, "x": noisy()}, vary=["k", "c"], start=[1, -0.1], begin=0, max_iterations=1)
    falling = lagrange.System("param a = 1; coord x = 1; start dot(x) = -1; kinetic = 1/2*dot(x)^2; force x = -a*sqrt(x);")
    with pytest.raises(lagrange.FitError, match="no motion reaches"):
        falling.fit({"t": [1, 2, 3], "x": [1, 1, 1]}, vary=["a"])


def test_fits_that_make_no_sense_are_refused():
    system = lagrange.System(OSCILLATOR)
    x = noisy()
    cases = [
        ({"x": x}, {}, "no times"),
        ({"t": TIMES}, {}, "0 values"),
        ({"t": [], "x": []}, {}, "0 values"),
        ({"t": TIMES, "x": x[:5]}, {}, "5 values for 60 times"),
        ({"t": TIMES, "x": np.zeros((60, 2))}, {}, "column `x`"),
        ({"t": TIMES, "x": "much"}, {}, "column `x`"),
        ({"t": TIMES, "x": np.where(TIMES > 3, np.nan, x)}, {}, "not finite"),
        ({"t": TIMES[::-1], "x": x}, {}, "time in row"),
        ({"t": TIMES, "y": x}, {}, "no `y`; known are `x`, `x_dot`, `twice`"),
        ({"t": TIMES, "x": x}, {"vary": []}, "nothing varies"),
        ({"t": TIMES, "x": x}, {"vary": {"q": None}}, "no `q`; known are `m`, `k`, `c`, `x`"),
        ({"t": TIMES, "x": x}, {"vary": {"k": (4, 5)}}, "`k` cannot vary: its value 3.0 is not between"),
        ({"t": TIMES, "x": x}, {"vary": {"k": 4}}, "`vary` must be"),
        ({"t": TIMES, "x": x}, {"noise": {"x": -1}}, "not a positive number"),
        ({"t": TIMES, "x": x, "twice": x}, {}, "`x` needs a noise level"),
        ({"t": TIMES, "x": x}, {"starts": 0}, "at least one"),
        ({"t": TIMES, "x": x}, {"begin": 1.0}, "before the start"),
        ({"t": TIMES, "x": x}, {"start": [1]}, "2 entries"),
    ]
    for data, settings, message in cases:
        with pytest.raises(ValueError, match=message):
            system.fit(data, **{"vary": ["k"], **settings})


def test_data_are_frames_and_files_too(tmp_path):
    pandas = pytest.importorskip("pandas")
    polars = pytest.importorskip("polars")
    system, columns = lagrange.System(OSCILLATOR), {"t": TIMES, "x": noisy()}
    wanted = system.fit(columns, vary=["k", "c"]).values
    for frame in (pandas.DataFrame, polars.DataFrame):
        assert system.fit(frame(columns), vary=["k", "c"]).values == wanted
    path = tmp_path / "noisy.csv"
    pandas.DataFrame(columns).rename(columns={"t": "t in s", "x": "x in m"}).to_csv(path, index=False)
    for file in (path, str(path)):
        assert system.fit(file, vary=["k", "c"]).values == wanted


def test_what_is_no_table_is_refused(tmp_path):
    system = lagrange.System(OSCILLATOR)
    with pytest.raises(TypeError, match="a dictionary or a data frame"):
        system.fit([1, 2], vary=["k"])
    with pytest.raises(ValueError, match="no times, `t`; their columns are time, x"):
        system.fit({"time": [0, 1], "x": [1, 1]}, vary=["k"])
    with pytest.raises(OSError, match="missing.csv"):
        system.fit(tmp_path / "missing.csv", vary=["k"])


def test_fits_can_be_interrupted():
    system = lagrange.System(OSCILLATOR)
    times = np.linspace(0, 5, 50)
    data = {"t": times, "x": np.cos(times)}
    # Processes in the background ignore Ctrl-C. The first motion ends within two seconds on busy machines, too.
    signal.signal(signal.SIGINT, signal.default_int_handler)
    interrupt = threading.Timer(2, lambda: os.kill(os.getpid(), signal.SIGINT))
    interrupt.start()
    began = time.monotonic()
    with pytest.raises(KeyboardInterrupt) as raised:
        system.fit(data, vary={"k": (0.1, 10), "c": (0, 1)}, start=[1, 0], starts=100_000)
    assert time.monotonic() - began < 20
    assert 0.1 <= raised.value.fit.values["k"] <= 10


def test_a_fit_is_interrupted_within_a_motion():
    system = lagrange.System(OSCILLATOR)
    signal.signal(signal.SIGINT, signal.default_int_handler)
    interrupt = threading.Timer(0.5, lambda: os.kill(os.getpid(), signal.SIGINT))
    interrupt.start()
    began = time.monotonic()
    with pytest.raises(KeyboardInterrupt) as raised:
        system.fit({"t": [0, 1e6, 1e7], "x": [1, 0, 0]}, vary=["k"], start=[1, 0])
    assert time.monotonic() - began < 5
    assert not hasattr(raised.value, "fit"), "no motion reached the end of the data"
