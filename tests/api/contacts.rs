//! Contacts, friction and events of declarations, as methods of the emitted types.

use lagrange::Simulate;
use lagrange::contact::{Contact, Friction};
use lagrange::event::Direction;
use lagrange::integrate::StepFailure;
use lagrange::system::{OdeSystem, OutOfRange};

lagrange::system! {
    /// A crate that falls onto a belt.
    #[derive(Clone, Debug)]
    struct Crate;

    param m = 2.0, g = 9.81, bounce = 0.8, mu = 0.2, belt = 0.5;
    coord x, y;
    kinetic = 1/2 * m * (dot(x)^2 + dot(y)^2);
    potential = m * g * y;
    event floor = y, falling => impact(bounce);
    event gate = x - 1, rising => { dot(x) = -dot(x); x = 2 - x; };
    event apex = dot(y), falling => record;
    event end = x - 10, crossing => stop;
    friction rub = dot(x) - belt, kinetic: mu * floor, static: 1.5 * mu * floor;
    output load = floor / (m * g);
}

lagrange::system! {
    /// A slider on a rail, with a pendulum through which the normal force depends on friction.
    #[derive(Clone, Debug)]
    struct Slider;

    param mc = 1.0, mp = 0.4, l = 0.5, mu = 0.3, g = 9.81;
    coord x, y, theta;
    let (px, py) = (x + l * sin(theta), y - l * cos(theta));
    kinetic = 1/2 * mc * (dot(x)^2 + dot(y)^2) + 1/2 * mp * (dot(px)^2 + dot(py)^2);
    potential = mc * g * y + mp * g * py;
    constraint rail = y - x / 2;
    friction rub = dot(x) + dot(y) / 2, mu * rail;
}

lagrange::system! {
    /// Smooth friction on a rail.
    struct Smooth;

    param m = 2.0, g = 9.81, mu = 0.3;
    coord x, y;
    kinetic = 1/2 * m * (dot(x)^2 + dot(y)^2);
    potential = m * g * y;
    constraint rail = y;
    friction rub = dot(x), mu * rail, smooth: 0.01;
}

const Q: [f64; 3] = [0.2, 0.1, 0.7];
const V: [f64; 3] = [0.8, 0.4, -1.1];

#[test]
fn modes_are_fields_that_decide_which_forces_act() {
    let open = Crate::default();
    assert_eq!((open.floor, open.rub), (Contact::Open, Friction::Slips));
    assert_eq!(open.acceleration(0.0, &[0.0, 1.0], &[1.0, 0.0]), [0.0, -9.81]);
    let closed = Crate { floor: Contact::Closed, rub: Friction::SlipsForwards, ..open };
    let [sideways, up] = closed.acceleration(0.0, &[0.0, 0.0], &[1.0, 0.0]);
    crate::assert_close(sideways, -0.2 * 9.81);
    assert_eq!(up, 0.0);
    crate::assert_close(closed.load(0.0, &[0.0, 0.0], &[1.0, 0.0]), 1.0);
    let [normal, friction] = closed.reactions(0.0, &[0.0, 0.0], &[1.0, 0.0]);
    crate::assert_close(normal, 2.0 * 9.81);
    crate::assert_close(friction, -0.2 * 2.0 * 9.81);
    let stuck = Crate { rub: Friction::Sticks, ..closed };
    assert_eq!(stuck.acceleration(0.0, &[0.0, 0.0], &[0.5, 0.0]), [0.0, 0.0]);
}

#[test]
fn events_are_listed_in_the_order_of_declaration() {
    let names = Crate::EVENTS.iter().map(|event| (event.name, event.direction)).collect::<Vec<_>>();
    let (falling, rising) = (Direction::Falling, Direction::Rising);
    let declared = [("floor", falling), ("gate", rising), ("apex", falling), ("end", Direction::Crossing)];
    assert_eq!(names[..4], declared);
    assert_eq!(names[4], ("rub", falling));
    let mut values = [f64::NAN; 5];
    Crate::default().event_values(0.0, &[3.0, 0.25, 0.7, -0.4], &mut values);
    assert_eq!(values[..4], [0.25, 2.0, -0.4, -7.0]);
}

#[test]
fn assignments_see_the_state_before_all_of_them() {
    use lagrange::event::Action;
    let answer = Crate::default().react(1, 0.0, 0.0, &[1.5, 0.25, 0.7, -0.4]).expect("it reacts");
    assert_eq!(answer.action, Action::Replace([0.5, 0.25, -0.7, -0.4]));
    let end = Crate::default().react(3, 0.0, 0.0, &[1.5, 0.25, 0.7, -0.4]).expect("it stops");
    assert_eq!(end.action, Action::Stop);
}

/// The friction of the crate is its second reaction and its fifth event.
#[test]
fn the_event_of_a_reaction_switches_that_reaction() {
    let sliding = Crate { floor: Contact::Closed, rub: Friction::SlipsForwards, ..Crate::default() };
    let answer = sliding.react(4, 0.0, 0.0, &[0.0, 0.0, sliding.belt, 0.0]).expect("it reacts");
    assert_eq!(
        answer.system.map(|system| (system.floor, system.rub)),
        Some((Contact::Closed, Friction::Sticks))
    );
}

/// M a = f + Aᵀλ + Dᵀr, A a = 0 and the law of friction hold, whatever the algorithm.
#[test]
fn friction_that_depends_on_the_normal_force_balances_all_equations() {
    for (rub, sign) in [(Friction::SlipsForwards, -1.0), (Friction::SlipsBackwards, 1.0)] {
        let slider = Slider { rub, ..Slider::default() };
        let (a, [rail]) = (slider.acceleration(0.0, &Q, &V), slider.multipliers(0.0, &Q, &V));
        let [friction] = slider.reactions(0.0, &Q, &V);
        crate::assert_close(friction, sign * 0.3 * rail.abs());
        let (mass, forcing) = (slider.mass_matrix(0.0, &Q), slider.forcing(0.0, &Q, &V));
        let held = slider.constraint_forces(0.0, &Q, &V);
        for i in 0..3 {
            let inertia: f64 = (0..3).map(|j| mass[i][j] * a[j]).sum();
            let rubbing = [1.0, 0.5, 0.0][i] * friction;
            assert!((inertia - forcing[i] - held[i] - rubbing).abs() < 1e-13, "row {i}");
        }
        assert!((a[1] - a[0] / 2.0).abs() < 1e-13);
    }
}

#[test]
fn sticking_holds_the_slip_velocity() {
    let slider = Slider { rub: Friction::Sticks, ..Slider::default() };
    let [x, y, _] = slider.acceleration(0.0, &Q, &[0.0, 0.0, -1.1]);
    assert!(x.abs() < 1e-13 && y.abs() < 1e-13);
}

#[test]
fn smooth_friction_has_no_mode_and_follows_the_hyperbolic_tangent() {
    let smooth = Smooth { m: 2.0, g: 9.81, mu: 0.3 };
    let [a, _] = smooth.acceleration(0.0, &[0.0, 0.0], &[0.004, 0.0]);
    crate::assert_close(a, -0.3 * 9.81 * 0.4_f64.tanh());
    assert!(Smooth::EVENTS.is_empty());
}

lagrange::system! {
    /// A block on two rough feet.
    #[derive(Clone, Debug)]
    struct Footed;

    param m = 1.0, a = 0.3, b = 0.5, g = 9.81, mu = 1.0;
    coord x, y, phi;
    gravity = (0, -g);
    line floor { angle: 0; }
    body block { mass: m; center: (x, y); angle: phi; shape: rectangle(2 * a, 2 * b); }
    event left = floor.distance(block.point(-a, -b)), falling => impact(0);
    event right = floor.distance(block.point(a, -b)), falling => impact(0);
    friction rub_left = dot(floor.along(block.point(-a, -b))), mu * left;
    friction rub_right = dot(floor.along(block.point(a, -b))), mu * right;
}

lagrange::system! {
    /// A block on one of these feet.
    #[derive(Clone, Debug)]
    struct OneFooted;

    param m = 1.0, a = 0.3, b = 0.5, g = 9.81, mu = 1.0;
    coord x, y, phi;
    gravity = (0, -g);
    line floor { angle: 0; }
    body block { mass: m; center: (x, y); angle: phi; shape: rectangle(2 * a, 2 * b); }
    event right = floor.distance(block.point(a, -b)), falling => impact(0);
    friction rub_right = dot(floor.along(block.point(a, -b))), mu * right;
}

/// A foot in the air has no effect, however rough the floor and whatever its friction would be
/// there.
#[test]
fn an_open_contact_takes_no_part() {
    let mut seed = 0_u64;
    let mut random = || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (seed >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    };
    let slips = [Friction::Slips, Friction::SlipsForwards, Friction::SlipsBackwards, Friction::Sticks];
    for case in 0..2000 {
        let mu = [0.3, 1.0, 2.0, 10.0][case % 4];
        let (rub_left, rub_right) = (slips[case / 4 % 3], slips[case / 12 % 4]);
        let right = if case / 48 % 4 == 0 { Contact::Open } else { Contact::Closed };
        let (q, v) = ([0.0, 0.5, 0.1 * random()], [random(), random(), random()]);
        let one = OneFooted { mu, right, rub_right, ..OneFooted::default() };
        let two = Footed { mu, right, rub_left, rub_right, ..Footed::default() };
        let (found, wanted) = (two.acceleration(0.0, &q, &v), one.acceleration(0.0, &q, &v));
        for (found, wanted) in found.into_iter().zip(wanted) {
            let size = wanted.abs().max(1.0);
            assert!((found - wanted).abs() < 1e-12 * size, "{found} for {wanted} at {q:?} {v:?}");
        }
        let [left, _, rub_left, _] = two.reactions(0.0, &q, &v);
        assert_eq!([left, rub_left], [0.0; 2]);
    }
}

lagrange::system! {
    /// A ball between a floor and a ceiling, with restitution by parameters and by speed.
    #[derive(Clone, Debug)]
    struct Restituted;

    param g = 9.81, e = 0.5, share = 1.0, loss = 0.1;
    coord y;
    kinetic = 1/2 * dot(y)^2;
    potential = g * y;
    event floor = y, falling => impact(e * share);
    event ceiling = 1 - y, falling => impact(1 - loss * dot(y));
}

/// A constant coefficient is checked before the first step, and one that depends on the state at
/// each impact.
#[test]
fn a_coefficient_of_restitution_that_is_not_from_0_to_1_is_an_error() {
    let cause = |ball: Restituted, start: [f64; 2]| {
        ball.simulate(start).until(3.0).run().map_err(|error| {
            assert_eq!(error.time() == 0.0, error.trajectory.len() == 1);
            (error.cause, error.to_string(), error.time())
        })
    };
    for (e, share) in [(1.01, 1.0), (-0.01, 1.0), (f64::NAN, 1.0), (0.6, 2.0), (f64::INFINITY, 1.0)] {
        let refused = cause(Restituted { e, share, ..Restituted::default() }, [0.5, 0.0]);
        let Err((StepFailure::OutOfRange(OutOfRange { name, value, .. }), said, 0.0)) = refused else {
            panic!("{refused:?}")
        };
        assert_eq!(name, "coefficient of restitution of contact `floor`");
        assert_eq!(value.to_bits(), (e * share).to_bits());
        let wanted = format!(
            "the coefficient of restitution of contact `floor` is {value:?}, but it must be from 0.0 to 1.0"
        );
        assert!(said.starts_with(&wanted), "{said}");
    }
    for (e, share) in [(1.0, 1.0), (0.0, 1.0), (-0.5, -1.0), (2.0, 0.5)] {
        assert!(cause(Restituted { e, share, ..Restituted::default() }, [0.5, 0.0]).is_ok(), "{e} {share}");
    }
    // Moving down, its formula exceeds one at the ceiling; moving up at 4 m/s it is −1 for the
    // second of these.
    assert!(cause(Restituted::default(), [0.5, -1.0]).is_ok());
    let refused = cause(Restituted { loss: 0.5, ..Restituted::default() }, [0.0, 6.0]);
    let Err((StepFailure::Restitution { contact: "ceiling", value }, _, time)) = refused else {
        panic!("{refused:?}")
    };
    let speed = (36.0_f64 - 2.0 * 9.81).sqrt();
    assert!((value - (1.0 - 0.5 * speed)).abs() < 1e-9 && (time - (6.0 - speed) / 9.81).abs() < 1e-9);
}
