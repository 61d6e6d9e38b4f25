//! Systems with at least as many constraints as coordinates: supports that share a load, and states
//! without solution.

use lagrange::Simulate;
use lagrange::integrate::{GaussLegendre4, RungeKutta4, Variational};

lagrange::system! {
    /// A beam, pinned at both ends, whose centre of mass is not in the middle.
    #[derive(Clone, Debug)]
    struct Beam;

    param m = 2.0, g = 9.81, c = 0.4, d = 0.3;
    gravity = (0, -g);
    coord x, y, phi;
    body beam { mass: m; inertia: 0.5; origin: (x, y); centroid: (d, 0); angle: phi; }
    pin left = beam.point(-1, 0) to (-cos(c), -sin(c));
    pin right = beam.point(1, 0) to (cos(c), sin(c));
    output on_left = left.force;
    output on_right = right.force;
    emit { jacobian, momentum_rates }
}

#[test]
fn a_beam_between_two_pins_rests_on_the_smallest_forces() {
    for (c, d) in [(0.4_f64, 0.3), (0.0, 0.0), (-1.3, 1.0), (std::f64::consts::FRAC_PI_2, -0.5)] {
        let beam = Beam { m: 2.0, g: 9.81, c, d };
        let (q, v) = ([0.0, 0.0, c], [0.0; 3]);
        let accelerations = beam.acceleration(0.0, &q, &v);
        assert!(accelerations.iter().all(|entry| entry.abs() < 1e-12), "{accelerations:?}");
        // Half of the weight each, and a couple across the beam.
        let (sin, cos) = c.sin_cos();
        let (half, across) = (0.5 * 2.0 * 9.81, 0.5 * 2.0 * 9.81 * d * cos);
        let couple = [-across * sin, across * cos];
        let expected = [[-couple[0], half - couple[1]], [couple[0], half + couple[1]]];
        let found = [beam.on_left(0.0, &q, &v), beam.on_right(0.0, &q, &v)];
        for (found, expected) in found.as_flattened().iter().zip(expected.as_flattened()) {
            assert!((found - expected).abs() < 1e-11, "{found} is not {expected} at {c}, {d}");
        }
    }
}

#[test]
fn every_method_leaves_a_held_beam_at_rest() {
    let (beam, start) = (Beam::default(), [0.0, 0.0, 0.4, 0.0, 0.0, 0.0]);
    let step = 1e-2;
    let runs = [
        ("adaptive", beam.simulate(start).until(1.0).run()),
        ("Runge-Kutta", beam.simulate(start).until(1.0).method(RungeKutta4 { step }).run()),
        ("in momenta", beam.simulate(start).until(1.0).method(GaussLegendre4 { step }).run()),
        ("plain", beam.simulate(start).until(1.0).method(GaussLegendre4 { step }.plain()).run()),
        ("variational", beam.simulate(start).until(1.0).method(Variational { step }).run()),
    ];
    let lasts = runs.map(|(name, run)| (name, run.map(|run| run.last())));
    for (name, last) in lasts {
        let last = last.unwrap_or_else(|error| panic!("{name}: {error}"));
        assert!(
            last.iter().zip(start).all(|(found, start)| (found - start).abs() < 1e-9),
            "{name}: {last:?}"
        );
    }
}

lagrange::system! {
    /// A joint held by three bars.
    struct Truss;

    param m = 2.0, g = 9.81;
    coord x, y;
    kinetic = kinetic_energy(m, dot((x, y)));
    potential = m * g * y;
    constraint left = hypot(x + 1, y - 1) - sqrt(2);
    constraint middle = hypot(x, y - 1) - 1;
    constraint right = hypot(x - 1, y - 1) - sqrt(2);
}

#[test]
fn a_statically_indeterminate_truss_has_the_smallest_forces() {
    let weight = 2.0 * 9.81;
    // The shortest of all (s, n, s) with √2 s + n = −m g.
    let expected = [0.5_f64.sqrt(), 1.0, 0.5_f64.sqrt()].map(|share| -share * weight / 2.0);
    let found = Truss::default().multipliers(0.0, &[0.0; 2], &[0.0; 2]);
    assert!(
        found.iter().zip(expected).all(|(found, expected)| (found - expected).abs() < 1e-12),
        "{found:?}"
    );
}

lagrange::system! {
    /// A bead on an inclined rail given by three constraints, any one of which suffices.
    struct Rail<S>;

    param slope = 0.75, g = 9.81;
    coord x, y;
    kinetic = kinetic_energy(1, dot((x, y)));
    potential = g * y;
    constraint first = y - slope * x;
    constraint second = sin(y - slope * x);
    constraint third = (y - slope * x) * (1 + x^2);
}

#[test]
fn more_constraints_than_coordinates_may_leave_a_motion() {
    let last = Rail::<f64>::default().simulate([0.0; 4]).until(1.0).run().expect("a bead that slides").last();
    // The acceleration along the rail is g · 3/5.
    let slid = 0.5 * 9.81 * 0.6;
    for (found, expected) in last.iter().zip([-0.8 * slid, -0.6 * slid, -1.6 * slid, -1.2 * slid]) {
        assert!((found - expected).abs() < 1e-6, "{last:?}");
    }
    let [ax, ay] = Rail::<f32>::default().acceleration(0.0, &[0.0; 2], &[0.0; 2]);
    assert!((ax + 9.81 * 0.48).abs() < 1e-5 && (ay + 9.81 * 0.36).abs() < 1e-5, "{ax}, {ay}");
}

lagrange::system! {
    /// A plate in space on three pins, with nine constraints for six velocities.
    struct Plate;

    gravity = (0, 0, -9.81);
    body plate { mass: 3; inertia: (1, 1, 2); }
    free plate;
    pin a = plate.point(1, 0, 0) to (1, 0, 0);
    pin b = plate.point(-1, 1, 0) to (-1, 1, 0);
    pin c = plate.point(-1, -1, 0) to (-1, -1, 0);
    output on_a = a.force;
    output on_b = b.force;
}

#[test]
fn a_plate_on_three_pins_hangs_without_horizontal_forces() {
    let (q, v) = ([0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0], [0.0; 6]);
    let plate = Plate;
    assert!(plate.acceleration(0.0, &q, &v).iter().all(|entry| entry.abs() < 1e-12));
    for (force, share) in [(plate.on_a(0.0, &q, &v), 0.5), (plate.on_b(0.0, &q, &v), 0.25)] {
        let expected = [0.0, 0.0, share * 3.0 * 9.81];
        assert!(force.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-11), "{force:?}");
    }
}

lagrange::system! {
    /// A body with two aligned slides, whose direction is a parameter.
    struct Slides;

    param c = 0.5;
    gravity = (0, -9.81);
    coord x, y, phi;
    body block { mass: 2; inertia: 0.3; center: (x, y); angle: phi; }
    line wall { through: (0, 0); angle: c; }
    slide upper = block.point(1, 0) on wall;
    slide middle = block on wall;
    slide lower = block.point(-1, 0) on wall;
    output shares = (lower.normal, middle.normal, upper.normal);
}

#[test]
fn slides_on_one_line_share_the_load_and_let_go_along_it() {
    for c in [0.5_f64, 0.0, -1.1] {
        let (slides, q, v) = (Slides { c }, [0.0, 0.0, c], [0.0; 3]);
        let [ax, ay, turn] = slides.acceleration(0.0, &q, &v);
        let along = -9.81 * c.sin();
        let misses = [ax - along * c.cos(), ay - along * c.sin(), turn];
        assert!(misses.iter().all(|miss| miss.abs() < 1e-12), "{misses:?} at {c}");
        for share in slides.shares(0.0, &q, &v) {
            assert!((share - 2.0 * 9.81 * c.cos() / 3.0).abs() < 1e-12, "{share} at {c}");
        }
    }
}

lagrange::system! {
    /// A wheel that rolls on a line while its centre slides on a parallel one, and so does not
    /// turn.
    struct Wheel;

    param c = 0.5, r = 0.4;
    gravity = (0, -9.81);
    coord x, y, phi;
    body wheel { mass: 2; inertia: 0.1; origin: (x, y); angle: phi; }
    line floor { through: (0, 0); angle: c; }
    line rail { through: (-r * sin(c), r * cos(c)); angle: c + sin(c)^2 + cos(c)^2 - 1; }
    roll contact = wheel on floor, radius: r;
    slide axle = wheel on rail;
    constraint brake = sin(phi);
}

lagrange::system! {
    /// A point on three lines that never meet.
    struct Contradiction;

    coord x, y;
    kinetic = kinetic_energy(1, dot((x, y)));
    constraint first = x + y - 1;
    constraint second = x - y;
    constraint third = x + 2 * y - 7;
}

lagrange::system! {
    /// A point driven apart by two constraints.
    struct Torn;

    coord x;
    kinetic = kinetic_energy(1, dot(x));
    constraint first = x - t^2;
    constraint second = sin(x) - t^3;
}

#[test]
fn a_braked_wheel_hangs_on_what_holds_it() {
    let wheel = Wheel::default();
    let (sin, cos) = wheel.c.sin_cos();
    let q = [-wheel.r * sin, wheel.r * cos, 0.0];
    let accelerations = wheel.acceleration(0.0, &q, &[0.0; 3]);
    assert!(accelerations.iter().all(|entry| entry.abs() < 1e-12), "{accelerations:?}");
}

#[test]
fn contradicting_constraints_end_a_run_by_name() {
    let error = Contradiction.simulate([0.5, 0.5, 0.0, 0.0]).until(1.0).run().expect_err("no such point");
    assert!(error.to_string().contains("violate the constraint `third`"), "{error}");
    let error = Torn.simulate([0.0, 0.0]).until(1.0).run().expect_err("no such motion");
    assert!(error.to_string().contains("`x_ddot` is NaN"), "{error}");
    assert!(Torn.acceleration(0.0, &[0.0], &[0.0])[0].is_nan());
}
