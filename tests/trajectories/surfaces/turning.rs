//! Rolling and spinning friction, against closed forms.

use lagrange::Simulate;
use lagrange::contact::{Friction, Stepped};
use lagrange::integrate::Radau5;

use crate::{G, assert_near, drift, flat};

/// Declares a ball of 2 kg and radius 0.1 m on a surface, with a contact of these coefficients.
macro_rules! ball {
    ($name:ident, { $($surface:tt)* } $($coefficients:tt)*) => {
        lagrange::system! {
            #[derive(Clone, Debug)]
            struct $name<S>;

            param r = 0.1, slope = 0;
            gravity = (0, 0, -9.81);
            $($surface)*
            body ball { mass: 2; shape: solid_sphere(r); }
            free ball;
            contact touch = ball on board { friction: 1/2; $($coefficients)* }
            output moments = (touch.rolling.x, touch.rolling.y, touch.spinning);
        }
    };
}

ball!(Ball, { param rho = 0.002, zeta = 0.0005; plane board { normal: (slope, 0, 1); } } rolling: rho; spinning: zeta;);
ball!(Plain, { plane board { normal: (slope, 0, 1); } });
ball!(Hill, { param rho = 0.002, zeta = 0.0005; terrain board { height(x, y): -slope * x; } } rolling: rho; spinning: zeta;);
ball!(Soft, { param rho = 0.002, zeta = 0.0005; plane board { normal: (slope, 0, 1); } }
    rolling: rho; spinning: zeta; stiffness: 1e6; dissipation: 1; stiction: 1e-4; stiction_rate: 1e-4;);

lagrange::system! {
    /// A wheel in plane motion.
    #[derive(Clone, Debug)]
    struct Wheel<S>;

    param rho = 0.002;
    coord x, y, phi;
    gravity = (0, -9.81);
    body wheel { mass: 2; center: (x, y); angle: phi; shape: disk(0.1); }
    contact touch = wheel on ground { friction: 1/2; rolling: rho; }
    output moment = touch.rolling;
}

lagrange::system! {
    /// A ball on a turntable.
    #[derive(Clone, Debug)]
    struct Table<S>;

    param zeta = 0.0005, rate = 3;
    gravity = (0, 0, -9.81);
    body table { mass: 1; inertia: (1, 1, 1); }
    revolute angle = ground to table { axis: (0, 0, 1); }
    constraint steady = dot(angle) - rate;
    plane top { on: table; }
    body ball { mass: 2; shape: solid_sphere(0.1); }
    free ball;
    contact touch = ball on top { spinning: zeta; }
}

lagrange::system! {
    /// A coin of radius 1 that stands on its rim.
    #[derive(Clone, Debug)]
    struct Coin;

    gravity = (0, 0, -9.81);
    body coin { mass: 1; inertia: (1/4, 1/4, 1/2); }
    free coin;
    contact touch = coin on ground { rim: 1; friction: 1; rolling: 0; spinning: 0.01; }
}

/// Returns the state of a ball that rolls along x at a speed, and spins about the vertical.
fn rolling(speed: f64, spin: f64) -> [f64; 13] {
    let [x, y, z, a, b, c, d, ..] = flat([0.0, 0.0, 0.1], [0.0; 3]);
    [x, y, z, a, b, c, d, speed, 0.0, 0.0, 0.0, speed / 0.1, spin]
}

/// Returns the deceleration ρ g/r · 1/(1 + 2/5) of a rolling ball.
fn deceleration(rho: f64) -> f64 {
    rho * G / 0.1 * 5.0 / 7.0
}

#[test]
fn a_rolling_ball_is_slowed_and_stops() {
    let a = deceleration(0.002);
    let ball = Ball::<f64>::default();
    let run = ball.simulate(rolling(0.2, 0.0)).until(1.0).outputs().run().expect("rolls");
    let [x, .., vx, _, _, _, wy, _] = run.last();
    assert_near(&[x, vx, wy], &[0.2 - 0.5 * a, 0.2 - a, (0.2 - a) / 0.1], 1e-12);
    let last = ["moments.x", "moments.y", "moments.z"].map(|name| run.column(name).expect("recorded")[1]);
    // The first tangent of this plane is y.
    assert_near(&last, &[-0.002 * 2.0 * G, 0.0, 0.0], 1e-12);
    let end = ball.simulate(rolling(0.2, 0.0)).until(5.0).run().expect("stops");
    let [x, .., vx, _, _, _, wy, _] = end.last();
    assert_near(&[x, vx, wy], &[0.04 / (2.0 * a), 0.0, 0.0], 1e-10);
    assert_eq!(end.system_at_end().map(|end| end.touch_rolling), Some(Friction::Sticks));
    let single =
        Ball::<f32>::default().simulate(rolling(0.2, 0.0).map(|entry| entry as f32)).until(1.0).run();
    let [x, .., vx, _, _, _, _, _] = single.expect("rolls").last().map(f64::from);
    assert_near(&[x, vx], &[0.2 - 0.5 * a, 0.2 - a], 1e-5);
}

#[test]
fn a_spinning_ball_stops_after_two_fifths() {
    let (spin, inertia) = (3.0, 0.4 * 2.0 * 0.01);
    let time = inertia * spin / (0.0005 * 2.0 * G);
    for share in [0.5, 0.999, 1.001, 3.0] {
        let run =
            Ball::<f64>::default().simulate(rolling(0.0, spin)).until(share * time).run().expect("spins");
        let left = spin * (1.0 - share).max(0.0);
        assert_near(&run.last()[10..], &[0.0, 0.0, left], 1e-11);
        let angle = spin * time * 0.5 * (1.0 - (1.0 - share).max(0.0).powi(2));
        assert_near(&run.last()[3..7], &[(0.5 * angle).cos(), 0.0, 0.0, (0.5 * angle).sin()], 1e-10);
    }
    let mode = |share: f64| {
        let run =
            Ball::<f64>::default().simulate(rolling(0.0, spin)).until(share * time).run().expect("spins");
        run.system_at_end().map(|end| end.touch_spinning)
    };
    assert_eq!([mode(0.999), mode(1.001)], [Some(Friction::SlipsForwards), Some(Friction::Sticks)]);
}

/// On a slope, a ball stays if tan φ < ρ/r; else it rolls with 5/7 (g sin φ − ρ g cos φ/r).
#[test]
fn a_ball_on_a_slope_starts_to_roll_beyond_the_ratio_of_lengths() {
    for slope in [0.0_f64, 0.0199, 0.0201, 0.1] {
        let (sin, cos) = slope.atan().sin_cos();
        let start = flat([0.1 * sin, 0.0, 0.1 * cos], [0.0; 3]);
        let along = 5.0 / 7.0 * G * (sin - 0.02 * cos).max(0.0);
        let wanted = [along * cos, 0.0, -along * sin];
        let ball = Ball { slope, ..Ball::<f64>::default() };
        let run = ball.simulate(start).until(1.0).run().expect("stays or rolls");
        assert_near(&run.last()[7..10], &wanted, 1e-11);
        let hill = Hill { slope, ..Hill::<f64>::default() };
        let run = hill.simulate(start).until(1.0).run().expect("stays or rolls");
        assert_near(&run.last()[7..10], &wanted, 1e-9);
    }
}

#[test]
fn coefficients_of_zero_change_nothing() {
    let start = [0.0, 0.0, 0.1, 1.0, 0.0, 0.0, 0.0, 0.5, 0.3, 0.0, 2.0, -1.0, 3.0];
    let ball = Ball { rho: 0.0, zeta: 0.0, ..Ball::<f64>::default() };
    let found = ball.simulate(start).until(2.0).tolerance(1e-12).energy().run().expect("rolls");
    let wanted = Plain::<f64>::default().simulate(start).until(2.0).tolerance(1e-12).run().expect("rolls");
    assert_near(&found.last(), &wanted.last(), 1e-11);
    let rolls = ball.simulate(rolling(0.2, 3.0)).until(2.0).tolerance(1e-12).energy().run().expect("rolls");
    assert!(drift(rolls.column("energy")) < 1e-12);
}

/// Both limits together: a ball that rolls and spins, in steps and on soft ground.
#[test]
fn steps_and_soft_ground_agree() {
    let (start, a) = (rolling(0.2, 3.0), deceleration(0.002));
    let exact = Ball::<f64>::default().simulate(start).until(1.0).tolerance(1e-12).run().expect("rolls");
    assert!((exact.last()[7] - (0.2 - a)).abs() < 1e-11);
    let stepped = Ball::<f64>::default().simulate(start).until(1.0).method(Stepped::every(1e-3)).run();
    assert_near(&stepped.expect("rolls").last(), &exact.last(), 2e-3);
    let soft = Soft::<f64>::default().simulate(start).until(1.0).method(Radau5::tolerance(1e-9)).run();
    assert_near(&soft.expect("rolls").last(), &exact.last(), 2e-3);
    // At rest it creeps: below the angular stiction speed on a slope that it would not roll down.
    let soft = Soft { slope: 0.01, ..Soft::<f64>::default() };
    let run =
        soft.simulate(flat([0.001, 0.0, 0.1], [0.0; 3])).until(1.0).method(Radau5::tolerance(1e-9)).run();
    let speed = run.expect("creeps").last()[11];
    assert!((speed - 1e-4 / 3.0_f64.sqrt()).abs() < 1e-6, "{speed:e}");
}

/// In the plane, a solid wheel is slowed by ρ g/r · 1/(1 + 1/2).
#[test]
fn a_wheel_in_the_plane_is_slowed() {
    let a = 0.002 * G / 0.1 / 1.5;
    let run = Wheel::<f64>::default().simulate([0.0, 0.1, 0.0, 0.5, 0.0, -5.0]).until(1.0).outputs().run();
    let run = run.expect("rolls");
    assert_near(&run.last(), &[0.5 - 0.5 * a, 0.1, -5.0 + 5.0 * a, 0.5 - a, 0.0, -5.0 + 10.0 * a], 1e-11);
    assert_near(&run.column("moment").expect("recorded")[1..2], &[0.002 * 2.0 * G], 1e-12);
}

/// The ball spins relative to the table, which it follows in the end.
#[test]
fn a_turntable_turns_a_ball() {
    let time = 0.4 * 2.0 * 0.01 * 3.0 / (0.0005 * 2.0 * G);
    for share in [0.5, 2.0] {
        let mut start = [0.0; 15];
        (start[3], start[4], start[8]) = (0.1, 1.0, 3.0);
        let run = Table::<f64>::default().simulate(start).until(share * time).run().expect("turns");
        assert_near(&run.last()[12..], &[0.0, 0.0, 3.0_f64.min(3.0 * share)], 1e-10);
    }
}

/// A coin of inertia 1/4 about its diameter.
#[test]
fn a_coin_on_its_rim_stops_spinning() {
    let half = 0.5_f64.sqrt();
    // The axis of the coin points along −y, its own y is up.
    let start = [0.0, 0.0, 1.0, half, half, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 2.0, 0.0];
    let run = Coin::default().simulate(start).until(1.0).run().expect("spins");
    assert_near(&run.last()[10..], &[0.0, 2.0 - 0.01 * G / 0.25, 0.0], 1e-10);
}
