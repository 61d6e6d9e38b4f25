"""Derivatives by parameters and inputs, code, plots and films."""

import re

import lagrange
import numpy as np
import pytest

SLIDER = """
    struct SlidingRod;
    param m: kg = 2, k: N/m = 8, l: m = 0.5;
    gravity = (0, -9.81);
    coord x: m = 1;
    input u: N, w: N;
    body block { mass: m; shape: rectangle(l, l); center: (x, 0); angle: 0; }
    potential = 1/2 * k * x^2;
    force x = u - w * x / l;
"""
TOP = """
    struct Top; gravity = (0, 0, -9.81); body rotor { mass: 0.5; shape: cone(0.05, 0.1); }
    ball tip = ground to rotor;
    start tip_qw = 1, tip_qx = 0.2, tip_qy = 0, tip_qz = 0, tip_wx = 0, tip_wy = 0, tip_wz = 60;
"""
POINT = "coord x = 1; kinetic = 1/2 * dot(x)^2;"


def slider(**values):
    return lagrange.System(SLIDER).with_parameters(**{"u": 0.5, "w": 0.25} | values)


def test_derivatives_by_parameters_are_exact():
    """Checks a = (u - w x / l - k x) / m at x = 0.75."""
    found = slider().parameter_jacobian(0.0, [0.75, -3.0])
    force = 0.5 - 0.25 * 0.75 / 0.5 - 8 * 0.75
    exact = [[0, 0, 0], [-force / 2**2, -0.75 / 2, 0.25 * 0.75 / 0.5**2 / 2]]
    np.testing.assert_allclose(found, exact, rtol=1e-13)


def test_derivatives_by_inputs_are_exact():
    found = slider().input_jacobian(0.0, [0.75, -3.0])
    np.testing.assert_allclose(found, [[0, 0], [1 / 2, -0.75 / 0.5 / 2]], rtol=1e-13)


def test_derivatives_are_those_of_differences_and_follow_values():
    y, names = [0.3, 2.0], ["m", "k", "l", "u", "w"]
    for values in [{}, {"m": 3.0, "w": -1.0}]:
        system = slider(**values)
        found = np.hstack([system.parameter_jacobian(1.0, y), system.input_jacobian(1.0, y)])
        for column, name in zip(found.T, names):
            step = 1e-6
            rates = [
                system.with_parameters(**{name: system.parameters[name] + side * step}).rhs(1.0, y)
                for side in (-1, 1)
            ]
            np.testing.assert_allclose(column, (rates[1] - rates[0]) / (2 * step), atol=1e-8)


def test_without_parameters_or_inputs_there_are_no_columns():
    system = lagrange.System(POINT)
    assert system.parameter_jacobian(0.0, [1.0, 0.0]).shape == (2, 0)
    assert system.input_jacobian(0.0, [1.0, 0.0]).shape == (2, 0)
    with pytest.raises(ValueError, match="a state has 2 entries"):
        slider().parameter_jacobian(0.0, [1.0])


def test_rust_is_the_code_of_the_macro():
    code = slider().rust()
    assert "pub struct SlidingRod" in code or "struct SlidingRod" in code
    assert "impl ::lagrange::system::OdeSystem for SlidingRod" in code


def test_plots_have_a_panel_for_each_column(tmp_path):
    motion = slider().simulate(until=1, every=0.1, energy=True)
    plot = motion.plot()
    assert plot._repr_svg_() == plot.svg and plot.svg.startswith("<svg")
    assert repr(plot) == "<Plot of 2 panels>"
    assert repr(motion.plot("energy")) == "<Plot of 1 panels>"
    assert motion.plot("x_dot", x="x").svg != motion.plot("x_dot").svg
    plot = motion.plot("x")
    for name, start in [("plot.svg", b"<svg"), ("plot.png", b"\x89PNG")]:
        plot.save(tmp_path / name)
        assert (tmp_path / name).read_bytes().startswith(start)
    with pytest.raises(KeyError, match="no column `y`; there are t, x, x_dot, energy"):
        motion.plot("y")
    with pytest.raises(KeyError, match="no column `s`"):
        motion.plot("x", x="s")
    with pytest.raises(ValueError):
        plot.save(tmp_path / "plot.pdf")
    with pytest.raises(OSError):
        plot.save(tmp_path / "nowhere" / "plot.svg")


@pytest.mark.parametrize(("text", "own"), [(SLIDER, "svg"), (TOP, "glb")])
def test_films_are_pages_in_frames(tmp_path, text, own):
    system = lagrange.System(text)
    if system.inputs:
        system = system.with_parameters(u=0, w=0)
    motion = system.simulate(until=0.2, every=0.04, energy=True)
    film = system.film(motion, height=300)
    assert film.html.startswith("<!DOCTYPE html>") and "energy" in film.html
    assert "energy" not in system.film(motion, energy=False).html
    # A weight is labelled with G.
    assert ">G<" in system.film(motion, forces=True).html and ">G<" not in film.html
    frame = film._repr_html_()
    page = re.fullmatch(r'<iframe srcdoc="([^"]*)" sandbox="allow-scripts" .* height="300" .*></iframe>', frame)
    assert page.group(1).replace("&quot;", '"').replace("&amp;", "&") == film.html
    for name in ["film.html", "film.gif", f"film.{own}"]:
        film.save(tmp_path / name)
        assert (tmp_path / name).stat().st_size > 1000
    with pytest.raises(ValueError, match="name of a format"):
        film.save(tmp_path / "film.mp4")


def test_what_is_no_film_is_refused():
    point = lagrange.System(POINT)
    with pytest.raises(ValueError, match="a film needs bodies"):
        point.film(point.simulate(until=1))
    with pytest.raises(ValueError, match="another system"):
        slider().film(lagrange.System(TOP).simulate(until=0.1))
    with pytest.raises(TypeError):
        slider().film([0.0, 1.0])


def test_films_follow_parameters():
    system = slider()
    motion = system.simulate(until=0.2, every=0.1)
    assert system.film(motion).html != system.with_parameters(l=0.25).film(motion).html
    assert system.film(motion).html == slider().film(motion).html
