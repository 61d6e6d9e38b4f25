//! Ranges of parameters: checked at the start of runs and on demand.

use std::ops::Bound;

use lagrange::Simulate;
use lagrange::system::{OutOfRange, RangedKind, StepFailure};

lagrange::system! {
    /// A mass on a spring, with every kind of range.
    #[derive(Clone, Debug)]
    struct Slider;

    param m: kg > 0 = 2, k: N/m in 0.. = 20, mu in 0..=1 = 0.25, tilt: deg in -90..90 = 30;
    param rest: mm in 10..=500 = 100, top: m < 3 = 1, c[2]: N*s/m >= 0 = [1, 2], nu > -1 <= 1/2 = 0.5;
    coord x: m = 0.2;
    kinetic = kinetic_energy(m, dot(x));
    potential = spring_energy(k, x - rest) + m * 9.81 [m/s^2] * sin(tilt) * x;
    dissipation = 1/2 * (c[0] + c[1]) * (1 + mu + nu) * dot(x)^2;
    output below: m = top - x;
    reduce Held { small x; }
}

/// Returns the message of a run with these parameters, which must equal that of the check.
fn refused(slider: &Slider) -> String {
    let checked = slider.check_parameters().expect_err("a value outside of its range");
    let run = slider.simulate(slider.start()).until(1.0).run().expect_err("a run with that value");
    // As text, since NaN differs from itself.
    assert_eq!(format!("{:?}", run.cause), format!("{:?}", StepFailure::OutOfRange(checked)));
    let held = Held::from(slider).check_parameters();
    assert_eq!(format!("{held:?}"), format!("{:?}", Err::<(), _>(checked)));
    assert!(run.to_string().contains(&checked.to_string()), "{run}");
    checked.to_string()
}

#[test]
fn values_in_their_ranges_run() {
    let slider = Slider::default();
    assert_eq!(slider.check_parameters(), Ok(()));
    assert!(slider.simulate(slider.start()).until(1.0).run().is_ok());
    let at_bounds = Slider { k: 0.0, mu: 1.0, rest: 0.01, c: [0.0, 0.0], nu: 0.5, ..slider };
    assert_eq!(at_bounds.check_parameters(), Ok(()));
    assert!(at_bounds.simulate(at_bounds.start()).until(1.0).run().is_ok());
}

#[test]
fn values_outside_of_their_ranges_are_named_with_value_and_range() {
    let slider = Slider::default();
    let m = refused(&Slider { m: 0.0, ..slider.clone() });
    assert_eq!(m, "the parameter `m` is 0.0 kg, but it must be greater than 0.0 kg");
    let k = refused(&Slider { k: -1e-300, ..slider.clone() });
    assert_eq!(k, "the parameter `k` is -1e-300 N/m, but it must be at least 0.0 N/m");
    let mu = refused(&Slider { mu: 1.5, ..slider.clone() });
    assert_eq!(mu, "the parameter `mu` is 1.5, but it must be from 0.0 to 1.0");
    let rest = refused(&Slider { rest: 0.6, ..slider.clone() });
    assert_eq!(rest, "the parameter `rest` is 0.6 m, but it must be from 0.01 to 0.5 m");
    let top = refused(&Slider { top: 3.0, ..slider.clone() });
    assert_eq!(top, "the parameter `top` is 3.0 m, but it must be less than 3.0 m");
    let c = refused(&Slider { c: [0.0, -2.0], ..slider.clone() });
    assert_eq!(c, "the parameter `c[1]` is -2.0 N*s/m, but it must be at least 0.0 N*s/m");
    let nu = refused(&Slider { nu: -1.0, ..slider.clone() });
    assert_eq!(nu, "the parameter `nu` is -1.0, but it must be greater than -1.0 and at most 0.5");
    let tilt = refused(&Slider { tilt: std::f64::consts::FRAC_PI_2, ..slider });
    assert!(tilt.contains("must be at least -1.57"), "{tilt}");
}

#[test]
fn nan_is_in_no_range() {
    let slider = Slider { k: f64::NAN, ..Slider::default() };
    assert!(refused(&slider).contains("`k` is NaN"));
}

lagrange::system! {
    /// A range in any number type.
    struct Ball<S>;

    param g > 0 = 9.81, bounce in 0..=1 = 0.5, radius in 0..;
    coord y;
    kinetic = 1/2 * dot(y)^2;
    potential = g * y;
    event floor = y - radius, falling => impact(bounce);
}

#[test]
fn random_values_run_where_the_range_contains_them() {
    // Marsaglia, "Xorshift RNGs", Journal of Statistical Software 8 (2003).
    let mut state = 88_172_645_463_325_252_u64;
    let mut random = || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 40) as f32 / (1 << 23) as f32 - 1.0
    };
    let (mut inside, mut outside) = (0, 0);
    for _ in 0..400 {
        let ball = Ball::<f32> {
            g: random() + 0.5,
            bounce: 1.5 * random(),
            radius: random() + 0.7,
            ..Ball::of(0.0)
        };
        let is_inside = ball.g > 0.0 && ball.bounce >= 0.0 && ball.bounce <= 1.0 && ball.radius >= 0.0;
        assert_eq!(ball.check_parameters().is_ok(), is_inside);
        let run = ball.simulate([2.0, 0.0]).until(0.1).run();
        assert_eq!(run.is_ok(), is_inside, "{:?} {:?} {:?}", ball.g, ball.bounce, ball.radius);
        if is_inside { inside += 1 } else { outside += 1 }
    }
    assert!(inside > 50 && outside > 50, "{inside} {outside}");
}

impl<S: lagrange::Scalar> Ball<S> {
    /// Returns a ball of this radius, which has no default.
    fn of(radius: S) -> Self {
        Ball {
            g: S::from_f64(9.81),
            bounce: S::from_f64(0.5),
            radius,
            floor: lagrange::contact::Contact::Open,
        }
    }
}

lagrange::system! {
    struct Arm;

    param m > 0 = 1, l > 0 = 0.5;
    coord theta;
    kinetic = 1/2 * m * l^2 * dot(theta)^2;
    potential = -9.81 * m * l * cos(theta);
    emit { prepared }
}

#[test]
fn prepared_systems_are_checked_like_the_system() {
    let arm = Arm { l: -0.5, ..Arm::default() };
    let refused = arm.prepared().simulate([0.1, 0.0]).until(1.0).run().expect_err("a negative length");
    assert!(refused.to_string().contains("the parameter `l` is -0.5"), "{refused}");
}

#[test]
fn the_first_parameter_outside_is_reported_as_a_value() {
    let ball = Ball { g: -1.0, bounce: 2.0, ..Ball::of(1.0) };
    let expected = OutOfRange {
        kind: RangedKind::Parameter,
        name: "g",
        value: -1.0,
        range: (Bound::Excluded(0.0), Bound::Unbounded),
        unit: "",
    };
    assert_eq!(ball.check_parameters(), Err(expected));
}
