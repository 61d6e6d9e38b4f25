//! Systems whose equations are evaluated for several motions side by side. `tests/oracle.rs`
//! compares the bits of more declarations.

mod pair;

use lagrange::Number;
use lagrange::scalar::Lanes;
use lagrange::system::{Equations, LanesSystem, LanesVisitor, OdeSystem};

use pair::Pair;

lagrange::system! {
    /// Every kind of condition: in motion, at kinks, at jumps, and on parameters alone.
    struct Winch;

    param m = 2, r = 0.5, k = 300, limit = 40, stop = 1.2, if_less = 0.25, g = 9.81;
    coord x, theta;
    input u = 40;
    kinetic = 1/2 * m * dot(x)^2 + 1/4 * m * r^2 * dot(theta)^2;
    potential = m * g * r * sin(theta);
    force x = min(u * x, limit) - if x < stop { 0 } else { k * sqrt(x - stop) };
    force x = -max(0, dot(x) - dot(theta)) * sign(x);
    force theta = -abs(dot(theta)) * dot(theta) * if r > 1 { r } else if if_less >= r { 1 / (r - if_less) } else { 1 };
    force theta = -if x <= theta { min(k, limit) } else { x / (x - theta) };
    emit { lanes }
}

lagrange::system! {
    /// A type parameter with the name of an emitted one.
    #[accuracy(fast)]
    struct Crane<L>;

    param trolley = 800, load = 450, l = 8, g = 9.81, c = 1/3;
    coord x, theta;
    velocity u = dot(x);
    input drive = 10;
    kinetic = 1/2 * trolley * u^2 + kinetic_energy(load, dot((x + l*sin(theta), -l*cos(theta))));
    potential = -load * g * l * cos(theta);
    force x = drive * if load > 400 { c } else { 1 } - c * u;
    emit { lanes, prepared }
    reduce Braked { freeze x = 0; }
}

lagrange::system! {
    struct Plain<V>;

    coord x;
    kinetic = 1/2 * dot(x)^2;
    potential = 1/2 * x^2;
    emit { lanes }
}

lagrange::system! {
    /// A type with the name of the type parameter.
    #[scalar(f32)]
    struct S;

    param c = 0.1;
    coord x;
    kinetic = 1/2 * dot(x)^2;
    potential = 1/3 * x^2 + c * ln(x);
    // This number is near the middle of two numbers in single precision, so it must not be rounded
    // twice.
    force x = 1.000000059604644775390625000000001 * x^3;
    emit { lanes }
}

lagrange::system! {
    /// Tables of one to three arguments, with evenly and unevenly spaced points, and a function
    /// of the crate.
    struct Hoist;

    table motor(rate) = [(0, 90), (1, 140), (2, 120), (3, 60)], interpolation: monotone, outside: clamp;
    table hill(x) = [(-1, 0), (0.5, 1), (4, 0.5), (6, 2)], interpolation: natural, outside: extend;
    table drag(rate, x) = [(0, -1, 0), (0, 1, 1), (10, -1, 3), (10, 1, 2)], interpolation: linear, outside: error;
    table wind(x, y, rate) = [
        (0, 0, 0, 1), (0, 1, 0, 2), (1, 0, 0, 4), (1, 1, 0, 3),
        (0, 0, 2, 0), (0, 1, 2, 1), (1, 0, 2, -2), (1, 1, 2, 5),
    ], interpolation: natural, outside: extend;
    table grip(x, rate) = [[0, 1, 1], [0, 3, 4]], rows: [-1, 2], columns: [0, 1, 3],
        interpolation: monotone, outside: extend;
    function stiffness(x);
    param m = 2, g = 9.81;
    coord x, y;
    kinetic = kinetic_energy(m, dot((x, hill(x)))) + kinetic_energy(m, dot(y));
    potential = m * g * hill(x);
    force x = motor(dot(x)) - drag(abs(dot(x)), y) + grip(y, dot(x));
    force y = -stiffness(y) * y + wind(x, y, dot(x));
    emit { lanes }
}

/// Returns the stiffness in any number type, scalar or lanes.
fn stiffness<S: Number>(x: S) -> S {
    let stretch = x.abs() - S::ONE;
    S::select(stretch.less(S::ZERO), S::ONE, S::ONE + stretch * stretch)
}

lagrange::system! {
    struct Unasked;

    coord x;
    kinetic = 1/2 * dot(x)^2;
}

/// Critical values, including the boundaries of the winch.
const VALUES: [f64; 9] = [0.0, -0.0, 1.0, 1.2, -0.7, 40.0, 1e-300, f64::NAN, f64::INFINITY];

fn same_bits(found: &[f64], expected: &[f64]) -> bool {
    let is_same = |(a, b): (&f64, &f64)| a.to_bits() == b.to_bits() || a.is_nan() && b.is_nan();
    found.len() == expected.len() && found.iter().zip(expected).all(is_same)
}

/// Returns all states of four entries taken from the values.
fn states() -> impl Iterator<Item = [f64; 4]> {
    let count = VALUES.len();
    (0..count.pow(4))
        .map(move |index| [1, count, count.pow(2), count.pow(3)].map(|n| VALUES[index / n % count]))
}

#[test]
fn conditions_select_what_branches_choose() {
    let winches = [
        Winch::default(),
        Winch { r: 0.25, stop: -0.0, ..Winch::default() },
        Winch { r: 1.5, u: -3.0, ..Winch::default() },
    ];
    for winch in winches {
        let lanes = winch.lanes(|parameter| parameter);
        for y in states() {
            let (found, expected) = (lanes.rhs(0.0, &y), winch.rhs(0.0, &y));
            assert!(same_bits(&found, &expected), "{found:?} is not {expected:?} at {y:?}");
        }
    }
}

/// Neighbouring lanes are on other sides of conditions, or NaN.
#[test]
fn lanes_do_not_affect_each_other() {
    let (left, right) = (Winch::default(), Winch { m: 3.0, r: 1.5, limit: 2.0, u: 5.0, ..Winch::default() });
    let mut lanes = left.lanes(|parameter| Pair([parameter; 2]));
    right.set_lane(&mut lanes, 1);
    for (y, z) in states().zip(states().skip(2477)) {
        let side_by_side = [0, 1, 2, 3].map(|entry| Pair([y[entry], z[entry]]));
        let rates = lanes.rhs(Pair([0.0, 1.0]), &side_by_side);
        let expected = [left.rhs(0.0, &y), right.rhs(1.0, &z)];
        for (lane, expected) in expected.iter().enumerate() {
            let found = rates.map(|rate| rate.0[lane]);
            assert!(
                same_bits(&found, expected),
                "{found:?} is not {expected:?} in {lane} at {y:?} beside {z:?}"
            );
        }
    }
}

/// Lanes contain knots, points between and beyond them, and NaN, side by side.
#[test]
fn tables_and_functions_of_the_crate_give_the_same_side_by_side() {
    let hoist = Hoist { m: 1.5, ..Hoist::default() };
    let mut lanes = hoist.lanes(|parameter| Lanes::<f64, 4>([parameter; 4]));
    Hoist::default().set_lane(&mut lanes, 2);
    let values = [0.5, -1.0, 0.3, 1.0, 3.999, 4.0, 7.5, -3.0, f64::NAN, 2.0, 0.0, 6.0, 1e300];
    for shift in 0..values.len() {
        let at = |entry: usize, lane: usize| values[(shift * (entry + 1) + 3 * entry + lane) % values.len()];
        let state = [0, 1, 2, 3].map(|entry| Lanes([0, 1, 2, 3].map(|lane| at(entry, lane))));
        let rates = lanes.rhs(Lanes([0.0; 4]), &state);
        for lane in 0..4 {
            let hoist = if lane == 2 { Hoist::default() } else { Hoist { m: 1.5, ..Hoist::default() } };
            let alone = [0, 1, 2, 3].map(|entry| at(entry, lane));
            let (found, expected) = (rates.map(|rate| rate.0[lane]), hoist.rhs(0.0, &alone));
            assert!(same_bits(&found, &expected), "{found:?} is not {expected:?} at {alone:?}");
        }
    }
}

#[test]
fn systems_of_any_number_type_have_lanes() {
    let (crane, y) = (Crane::<f64>::default(), [0.5, 0.3, 0.2, 0.1]);
    let lanes: CraneLanes<f64> = crane.lanes(|parameter| parameter);
    assert!(same_bits(&lanes.rhs(0.0, &y), &crane.rhs(0.0, &y)));
    let braked = Braked { l: 3.0, ..Braked::default() };
    assert!(same_bits(
        &braked.lanes(|parameter| parameter).rhs(0.0, &[0.3, 0.1]),
        &braked.rhs(0.0, &[0.3, 0.1])
    ));
    let narrow = Crane::<f32>::default();
    let narrowed = y.map(|entry| entry as f32);
    assert_eq!(narrow.lanes(|parameter| parameter).rhs(0.0, &narrowed), narrow.rhs(0.0, &narrowed));
    assert_eq!(Plain::<f64>::default().lanes(|_| 0.0).rhs(0.0, &[2.0, 1.0]), [1.0, -2.0]);
}

/// Constants are rounded to single precision first, as in the system.
#[test]
fn constants_are_those_of_the_scalar() {
    let single = S::default();
    for y in [[1.0, 0.1], [3.0e-20, 0.0], [-1.0, 2.0]] {
        let found: [f32; 2] = single.lanes(|parameter| parameter).rhs(0.0, &y);
        assert_eq!(found.map(f32::to_bits), single.rhs(0.0, &y).map(f32::to_bits));
    }
    let lanes: SLanes<f64> = single.lanes(f64::from);
    assert_eq!(lanes.c, f64::from(0.1_f32));
}

/// A visitor without results, to see whether a system offers lanes.
struct Offered;

impl<M> LanesVisitor<M> for Offered {
    type Output = ();
    fn visit(self) {}
}

#[test]
fn a_system_offers_lanes_unless_runs_stop_at_its_surfaces() {
    assert!(Crane::<f64>::with_lanes(Offered).is_ok());
    assert!(Plain::<f32>::with_lanes(Offered).is_ok());
    assert!(Winch::with_lanes(Offered).is_err());
    fn offers<M: OdeSystem>() -> bool {
        M::with_lanes(Offered).is_ok()
    }
    assert!(offers::<Braked<f64>>() && !offers::<Unasked>());
}
