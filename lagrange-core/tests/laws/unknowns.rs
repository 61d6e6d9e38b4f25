//! Algebraic unknowns give the same results as their closed-form solutions, where these exist.

use std::sync::LazyLock;

use lagrange_core::derive::StrategyChoice;
use lagrange_core::model::Product;
use lagrange_core::pipeline::{NumericSystem, parse};
use proptest::prelude::{prop_assert, prop_assert_eq, proptest};

use crate::printing::{emitted, printed_and_read, read};

fn system(text: &str) -> NumericSystem {
    let derived = parse(text).expect("a correct declaration").derive(StrategyChoice::Cheapest);
    NumericSystem::new(&derived.expect("a regular system"))
}

/// Returns a bead whose height, weight and drag are unknowns of equations, or written out.
fn bead(unknowns: &str) -> String {
    format!(
        "param a = 2, b = 3/2, g = 9.81; coord x, z; state s;
        {unknowns}
        kinetic = kinetic_energy(2, dot((x, height))) + 1/2 * dot(z)^2;
        potential = g * height + 1/2 * a * stretch^2;
        force z = -drag;
        dot(s) = drag - s * height;
        output speed = dot(height);
        output lift = ddot(height);
        emit {{ jacobian, parameter_jacobian }}"
    )
}

const SOLVED: &str = "
    solve height: 0 = height^2 - (1 + x^2), start: 1;
    solve stretch: 0 = (a + x^2) * stretch - b * (z - sin(x));
    solve drag: 0 = ln(drag) - dot(z) / b, start: 1 + max(0, dot(z));
";
const WRITTEN: &str = "
    let height = sqrt(1 + x^2);
    let stretch = b * (z - sin(x)) / (a + x^2);
    let drag = exp(dot(z) / b);
";

/// Both beads, each derived once.
static BEADS: LazyLock<[NumericSystem; 2]> =
    LazyLock::new(|| [SOLVED, WRITTEN].map(|unknowns| system(&bead(unknowns))));

proptest! {
    #[test]
    fn an_equation_means_its_solution(
        x in -2.0..2.0_f64, z in -2.0..2.0_f64, s in -1.0..1.0_f64, u in -2.0..2.0_f64, w in -1.5..1.5_f64,
    ) {
        let (q, v) = ([x, z, s], [u, w]);
        let all = |system: &NumericSystem| {
            let products = [Product::Jacobian, Product::ParameterJacobian, Product::PotentialEnergy, Product::Energy];
            let products = products.into_iter().map(|product| system.product(product, 0.3, &q, &v).expect("it is derived"));
            let outputs = ["speed", "lift"].map(|output| system.output(output, 0.3, &q, &v).expect("it is declared"));
            let rhs = system.rhs(0.3, &[x, z, s, u, w]);
            products.chain(outputs).chain([rhs]).flatten().collect::<Vec<f64>>()
        };
        let [solved, written] = BEADS.each_ref().map(all);
        prop_assert_eq!(solved.len(), written.len());
        for (a, b) in solved.iter().zip(&written) {
            prop_assert!((a - b).abs() < 1e-12 * (1.0 + b.abs()), "{a} {b}: {solved:?} {written:?}");
        }
    }
}

/// A pendulum on a spring in series with a stiffening spring.
const SERIES: &str = "
    param soft = 20, hard = 50, stiff = 100, m = 1.5; coord x; state s;
    solve joint: 0 = soft * joint + hard * joint^3 - stiff * (x - joint);
    solve flow: 0 = flow + abs(flow) * flow - dot(x) - s, start: dot(x) + s;
    kinetic = kinetic_energy(m, dot(x));
    potential = spring_energy(soft, joint) + 1/4 * hard * joint^4 + spring_energy(stiff, x - joint);
    force x = -flow;
    dot(s) = -flow;
    output meets = joint;
    emit { jacobian }
";

#[test]
fn derivatives_are_those_that_differences_show() {
    let system = system(SERIES);
    for at in [[0.3, 0.2, -0.4], [-1.2, 0.5, 2.0], [2.0, -1.0, 0.0]] {
        let [x, s, v] = at;
        let jacobian = system.product(Product::Jacobian, 0.0, &[x, s], &[v]).expect("it is derived");
        for column in 0..3 {
            let step = 1e-5;
            let moved = |by: f64| {
                let mut at = at;
                at[column] += by;
                system.acceleration(0.0, &at[..2], &at[2..])[0]
            };
            let slope = (8.0 * (moved(step) - moved(-step)) - (moved(2.0 * step) - moved(-2.0 * step)))
                / (12.0 * step);
            assert!(
                (jacobian[column] - slope).abs() < 1e-7 * (1.0 + slope.abs()),
                "{column} {jacobian:?} {slope}"
            );
        }
        // The force is the same in both springs, and equals the slope of the potential.
        let joint = system.output("meets", 0.0, &[x, s], &[v]).expect("it is declared")[0];
        let (first, second) = (20.0 * joint + 50.0 * joint.powi(3), 100.0 * (x - joint));
        assert!((first - second).abs() < 1e-13 * (1.0 + first.abs()), "{first} {second}");
        let flow = -(1.5 * system.acceleration(0.0, &[x, s], &[v])[0] + first);
        assert!((flow + flow.abs() * flow - v - s).abs() < 1e-13 * (1.0 + first.abs()), "{flow}");
    }
}

/// Returns values of the unknown `y` of an equation, as values of an output.
fn solution(equation: &str, parameters: &[(&str, f64)]) -> f64 {
    let names = parameters.iter().map(|(name, _)| format!("param {name};")).collect::<String>();
    let text = format!("{names} coord x; kinetic = 1/2 * dot(x)^2; solve y: {equation}; output found = y;");
    let mut system = system(&text);
    parameters.iter().for_each(|(name, value)| assert!(system.set(name, *value)));
    system.output("found", 0.0, &[0.0], &[0.0]).expect("it is declared")[0]
}

#[test]
fn known_solutions_are_found_to_their_last_digits() {
    // By mpmath with 30 digits: Kepler's equation, then the law of Colebrook and White for 1/√f.
    for (e, mean, expected) in [
        (0.1, 0.5, 0.552_479_986_906_570_4),
        (0.9, 0.1, 0.630_843_527_563_153_5),
        (0.5, 1.0, 1.498_701_133_517_848_4),
        (0.9, 2.0, 2.522_365_434_000_245),
    ] {
        let found = solution("0 = y - e * sin(y) - mean, start: mean", &[("e", e), ("mean", mean)]);
        assert!((found - expected).abs() <= 4e-16 * (1.0 + expected), "{found} {expected}");
    }
    for (rough, reynolds, expected) in [
        (1e-4, 1e5, 7.349_392_486_953_611),
        (0.0, 4e3, 5.005_821_773_674_966),
        (5e-2, 1e8, 3.738_457_408_165_473_3),
    ] {
        let equation = "0 = y + 2 * ln(rough / 3.7 + 2.51 * y / reynolds) / ln(10), start: 6";
        let found = solution(equation, &[("rough", rough), ("reynolds", reynolds)]);
        assert!((found - expected).abs() < 4e-15, "{found} {expected}");
    }
}

#[test]
fn missing_solutions_are_nan() {
    let a = &[("a", 1.0)];
    assert!(solution("0 = y^2 + a", a).is_nan());
    assert!(solution("0 = y^2 + a, start: 2, iterations: 1000", a).is_nan());
    // The slope vanishes at the start.
    assert!(solution("0 = y^2 - a", a).is_nan());
    assert_eq!(solution("0 = y^2 - a, start: 2", a), 1.0);
    assert_eq!(solution("0 = y^2 - a, start: -a", a), -1.0);
    // One iteration too few, and as many as needed.
    assert!(solution("0 = y^3 - 8 * a, start: 3, iterations: 4", a).is_nan());
    assert_eq!(solution("0 = y^3 - 8 * a, start: 3, iterations: 7", a), 2.0);
    assert!(solution("0 = a * y - 1", &[("a", f64::NAN)]).is_nan());
    assert!(solution("0 = a * y - 1", &[("a", 0.0)]).is_nan());
}

/// Returns the unknown of an equation as a function of x, derived once.
fn along(equation: &str, functions: &str) -> impl Fn(f64) -> f64 {
    let text =
        format!("{functions} coord x; kinetic = 1/2 * dot(x)^2; solve y: {equation}; output found = y;");
    let system = system(&text);
    move |x| system.output("found", 0.0, &[x], &[0.0]).expect("it is declared")[0]
}

#[test]
fn apparent_solutions_are_nan() {
    let root = along("0 = sqrt(y^2 + 1) - y + x", "");
    let distance = along("0 = hypot(y - 1, 2) - sqrt(5) + y - x", "");
    let is_near = |found: f64, y: f64| (found - y).abs() < 1e-14 * (1.0 + y.abs()).powi(3);
    let mut solved = 0;
    for i in 0..10_000 {
        let x = 20.0 * (f64::from(i) / 10_000.0) - 10.0;
        let found = root(x);
        assert!(found.is_nan() || x < 0.0 && is_near(found, (x * x - 1.0) / (2.0 * x)), "{x} {found}");
        solved += usize::from(!found.is_nan());
        let (found, c) = (distance(x), 5.0_f64.sqrt() + x);
        let expected = (c * c - 5.0) / (2.0 * (c - 1.0));
        assert!(found.is_nan() || c > 1.0 && is_near(found, expected), "{x} {found} {expected}");
        solved += usize::from(!found.is_nan());
    }
    assert!(solved > 10_000, "{solved}");
}

#[test]
fn tables_are_solved_beside_their_knots() {
    for interpolation in ["linear", "natural"] {
        let points = "[(-2, -9), (-1, -2), (0, 0), (1, 3), (2, 5)]";
        let table = format!("table f(u) = {points}, interpolation: {interpolation}, outside: extend;");
        let solution = along("0 = f(y) - x", &table);
        for i in 0..2000 {
            let x = 1e-3_f64.powi(i % 7) * (f64::from(i) / 1000.0 - 1.0);
            assert!(solution(x).is_finite(), "{interpolation} {x}");
        }
    }
}

#[test]
fn equations_that_are_never_zero_are_mistakes() {
    let never_zero = ["y^2 + 1", "-1 - 3 * y^4 - x^2", "exp(y) + abs(x)", "sqrt(y) + cosh(x * y)"];
    for equation in never_zero {
        let text = format!("coord x; kinetic = 1/2 * dot(x)^2; solve y: 0 = {equation}; force x = y;");
        let report = parse(&text).expect_err("there is no solution").to_string();
        assert!(report.contains("has no solution for `y`"), "{equation}: {report}");
    }
}

#[test]
fn unknowns_may_be_made_of_unknowns_and_of_functions() {
    let text = "
        function push(u); table bend(x) = [(-3, -9), (0, 0), (3, 9)], interpolation: natural, outside: extend;
        coord x; kinetic = 1/2 * dot(x)^2;
        solve a: 0 = 2 * a + bend(a) - x;
        solve b: 0 = push(b) - a + if b < 0 { 3 * b } else { b };
        force x = b;
        output both = (a, b);
        emit { jacobian }
    ";
    let mut system = system(text);
    assert!(system.define("push", |u| u[0] + u[0].powi(3)));
    assert!(system.define("push_derivative", |u| 1.0 + 3.0 * u[0] * u[0]));
    for (x, b) in [(2.0_f64, 0.2_f64), (-1.5, -0.1)] {
        let both = system.output("both", 0.0, &[x], &[0.0]).expect("it is declared");
        // The table is the line 3 x.
        assert!((both[0] - x / 5.0).abs() < 1e-15 && (both[1] - b).abs() < 0.1, "{both:?}");
        let b = both[1];
        let (factor, slope) = (if b < 0.0 { 3.0 } else { 1.0 }, 1.0 + 3.0 * b * b);
        assert!((b + b.powi(3) - both[0] + factor * b).abs() < 1e-15, "{both:?}");
        let jacobian = system.product(Product::Jacobian, 0.0, &[x], &[0.0]).expect("it is derived");
        assert!((jacobian[0] - 1.0 / (5.0 * (slope + factor))).abs() < 1e-15, "{jacobian:?}");
    }
}

#[test]
fn reductions_take_unknowns_with_them() {
    let text = "
        param k = 3; coord x, z;
        solve y: 0 = (2 + z) * y + y^3 - sin(x) - k * z^2;
        kinetic = kinetic_energy(1, dot(x)) + kinetic_energy(1, dot(z));
        potential = 1/2 * k * y^2 + z^2;
        output is = y;
        reduce Frozen { freeze z = 1/2; }
        reduce Small { small x; freeze z = 0; }
    ";
    let derived = parse(text).expect("correct").derive(StrategyChoice::Cheapest).expect("regular");
    let whole = NumericSystem::new(&derived);
    let [frozen, small] = [0, 1].map(|part| NumericSystem::of_part(&derived.reduced[part]));
    let expected = whole.acceleration(0.0, &[0.7, 0.5], &[0.0, 0.0])[0];
    assert!((frozen.acceleration(0.0, &[0.7], &[0.0])[0] - expected).abs() < 1e-15);
    assert_eq!(frozen.output("is", 0.0, &[0.7], &[0.0]), whole.output("is", 0.0, &[0.7, 0.5], &[0.0, 0.0]));
    // y = x/2 + …, so that V = 3/8 x² + ….
    assert!((small.acceleration(0.0, &[0.2], &[0.0])[0] + 0.75 * 0.2).abs() < 1e-15);
}

#[test]
fn a_printed_equation_keeps_its_meaning() {
    for equation in [
        "0 = y^2 - x",
        "m: 0 = y - x^3/(4 [m^2]), start: 2, iterations: 7 + 1",
        "m: 0 = y^2 - 2 * x^2, start: x",
    ] {
        let text = format!("coord x; solve y: {equation}; kinetic = 1/2 * dot(x)^2; output out = y;");
        let declaration = read(&text);
        let again = printed_and_read(&declaration);
        assert_eq!(emitted(again), emitted(declaration), "{equation}");
    }
}
