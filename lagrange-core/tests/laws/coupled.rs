//! Coupled algebraic unknowns give the same results as their closed-form solutions, where these
//! exist.

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

/// Returns a crank of length 1 that drives a rocker of length 3 through a coupler of length 4. The
/// base has the length 3.5, the coupler carries a mass, and a spring holds the rocker.
fn four_bar(unknowns: &str) -> String {
    format!(
        "param a = 1, b = 4, c = 3, d = 7/2, m = 2, k = 5, g = 9.81; coord phi;
        {unknowns}
        let (px, py) = (a * cos(phi) + 2 * cos(coupler), a * sin(phi) + 2 * sin(coupler));
        kinetic = kinetic_energy(m, dot((px, py))) + 1/2 * dot(phi)^2 + 1/4 * dot(rocker)^2;
        potential = m * g * py + 1/2 * k * (rocker - 1)^2;
        output angles = (coupler, rocker);
        output rates = (dot(coupler), ddot(rocker));
        emit {{ jacobian, parameter_jacobian }}"
    )
}

const CLOSED: &str = "
    solve (coupler, rocker):
        0 = a * cos(phi) + b * cos(coupler) - d - c * cos(rocker),
        0 = a * sin(phi) + b * sin(coupler) - c * sin(rocker),
        start: (0.7, 1.5);
";
/// The loop closure in closed form, from the triangle over the diagonal between the end of the
/// crank and the pivot of the rocker.
const WRITTEN: &str = "
    let (ex, ey) = (d - a * cos(phi), -a * sin(phi));
    let diagonal = sqrt(ex^2 + ey^2);
    let towards = atan2(ey, ex);
    let coupler = towards + acos((b^2 + diagonal^2 - c^2) / (2 * b * diagonal));
    let rocker = towards + pi - acos((c^2 + diagonal^2 - b^2) / (2 * c * diagonal));
";

/// Both linkages, each derived once.
static LINKAGES: LazyLock<[NumericSystem; 2]> =
    LazyLock::new(|| [CLOSED, WRITTEN].map(|unknowns| system(&four_bar(unknowns))));

proptest! {
    #[test]
    fn a_loop_closes_as_its_triangles_do(phi in -7.0..7.0_f64, rate in -2.0..2.0_f64) {
        let (q, v) = ([phi], [rate]);
        let all = |system: &NumericSystem| {
            let products = [Product::Jacobian, Product::ParameterJacobian, Product::Energy];
            let products = products.into_iter().map(|product| system.product(product, 0.3, &q, &v).expect("it is derived"));
            let outputs = ["angles", "rates"].map(|output| system.output(output, 0.3, &q, &v).expect("it is declared"));
            products.chain(outputs).chain([system.rhs(0.3, &[phi, rate])]).flatten().collect::<Vec<f64>>()
        };
        let [solved, written] = LINKAGES.each_ref().map(all);
        prop_assert_eq!(solved.len(), written.len());
        for (a, b) in solved.iter().zip(&written) {
            prop_assert!((a - b).abs() < 1e-12 * (1.0 + b.abs()), "{a} {b}: {solved:?} {written:?}");
        }
    }
}

/// Returns the outputs `found` of a system at x = 0 with these parameters.
fn found(text: &str, parameters: &[(&str, f64)]) -> Vec<f64> {
    let mut system = system(&format!("coord x; kinetic = 1/2 * dot(x)^2; {text}"));
    parameters.iter().for_each(|(name, value)| assert!(system.set(name, *value)));
    system.output("found", 0.0, &[0.0], &[0.0]).expect("it is declared")
}

/// Compares with the numbers of SciPy for the same equations:
///
/// ```text
/// def diodes(x, u, i=1e-14, v=0.02585):
///     a, b = x
///     through = i * (exp((a - b) / v) - 1)
///     return [(u - a) / 1000 - a / 2000 - through, through - b / 500 - i * (exp(b / v) - 1)]
/// fsolve(diodes, [0.72, 0.1], args=(1,), xtol=1e-15); fsolve(diodes, [1.3, 0.65], args=(5,), xtol=1e-15)
///
/// def bodies(x, p, g=0.8):
///     a, b, c = x
///     out = lambda x: 2e-9 * (x**4 - 293.15**4)
///     return [p - g * (a - b) - out(a), g * (a - b) - g * (b - c) - out(b), g * (b - c) - out(c)]
/// [fsolve(bodies, [300, 300, 300], args=(p,), xtol=1e-15) for p in (10, 200)]
/// ```
fn check(found: &[f64], expected: &[f64]) {
    for (found, expected) in found.iter().zip(expected) {
        assert!((found - expected).abs() < 1e-12 * expected.abs(), "{found} {expected}");
    }
    assert_eq!(found.len(), expected.len());
}

#[test]
fn two_nodes_between_diodes_have_the_voltages_that_scipy_finds() {
    let circuit = |start: &str| {
        format!(
            "param source = 1, leak = 1e-14, volt = 0.02585;
            solve (a, b):
                0 = (source - a) / 1000 - a / 2000 - leak * (exp((a - b) / volt) - 1),
                0 = leak * (exp((a - b) / volt) - 1) - b / 500 - leak * (exp(b / volt) - 1),
                {start} iterations: 200;
            output found = (a, b);"
        )
    };
    let start = "start: (source, source / 2),";
    check(&found(&circuit(start), &[]), &[0.620_432_774_150_416_6, 0.034_675_419_373_065_355]);
    for start in [start, "", "start: (0.2, 3),"] {
        let [a, b] = found(&circuit(start), &[("source", 5.0)])[..] else { panic!("two values") };
        check(&[a, b], &[1.350_434_373_459_249, 0.667_517_155_934_029_6]);
    }
}

#[test]
fn heated_bodies_in_a_row_have_the_temperatures_that_scipy_finds() {
    let row = "
        param power = 10, g = 0.8, s = 2e-9, around = 293.15;
        let out(y) = s * (y^4 - around^4);
        const n = 3;
        solve (hot, warm, cool):
            0 = power - g * (hot - warm) - out(hot),
            0 = g * (hot - warm) - g * (warm - cool) - out(warm),
            0 = g * (warm - cool) - out(cool),
            start: (around, around, around);
        output found = (hot, warm, cool);";
    check(&found(row, &[]), &[313.825_057_353_236_6, 307.110_983_271_425_3, 304.173_337_379_172_84]);
    let hotter = [513.661_156_133_290_5, 419.237_401_418_806_1, 383.579_702_982_482_05];
    check(&found(row, &[("power", 200.0)]), &hotter);
}

/// Eight points in a row between stiffening springs. The coordinate x stretches the row.
const ROW: &str = "
    const n = 8;
    param k = 2, h = 3; coord x;
    let spring(s) = k * s + h * s^3;
    solve (y[0], y[1], y[2], y[3], y[4], y[5], y[6], y[7]):
        0 = spring(y[0]) - spring(y[1] - y[0]),
        0 = spring(y[1] - y[0]) - spring(y[2] - y[1]),
        0 = spring(y[2] - y[1]) - spring(y[3] - y[2]) + 1/2 * sin(x),
        0 = spring(y[3] - y[2]) - spring(y[4] - y[3]),
        0 = spring(y[4] - y[3]) - spring(y[5] - y[4]),
        0 = spring(y[5] - y[4]) - spring(y[6] - y[5]),
        0 = spring(y[6] - y[5]) - spring(y[7] - y[6]),
        0 = spring(y[7] - y[6]) - spring(x - y[7]);
    kinetic = kinetic_energy(1, dot(x));
    force x = -spring(x - y[7]);
    output middle = y[3];
    output speed = dot(y[3]);
    emit { jacobian }
";

#[test]
fn eight_unknowns_have_the_derivatives_that_differences_show() {
    let system = system(ROW);
    let step = 1e-4;
    for x in [0.0, 0.3, -2.0, 5.0] {
        let difference = |value: &dyn Fn(f64) -> f64| {
            let wide = value(x + 2.0 * step) - value(x - 2.0 * step);
            (8.0 * (value(x + step) - value(x - step)) - wide) / (12.0 * step)
        };
        let slope = difference(&|x| system.acceleration(0.0, &[x], &[0.0])[0]);
        let jacobian = system.product(Product::Jacobian, 0.0, &[x], &[0.0]).expect("it is derived");
        assert!((jacobian[0] - slope).abs() < 1e-9 * (1.0 + slope.abs()), "{jacobian:?} {slope}");
        let middle = |x: f64| system.output("middle", 0.0, &[x], &[0.0]).expect("it is declared")[0];
        let speed = system.output("speed", 0.0, &[x], &[2.0]).expect("it is declared")[0];
        assert!((speed - 2.0 * difference(&middle)).abs() < 1e-9, "{speed}");
    }
    // Without the load in the middle all nine springs would be equal.
    let third = std::f64::consts::PI;
    let force = -system.acceleration(0.0, &[third], &[0.0])[0];
    let s = third / 9.0;
    assert!((force - (2.0 * s + 3.0 * s.powi(3))).abs() < 1e-13, "{force}");
}

#[test]
fn equations_without_common_solution_give_nan() {
    let of = |equations: &str| {
        found(&format!("param p = 1; solve (y, z): {equations}; output found = (y, z);"), &[])
    };
    for equations in [
        // A line outside the circle, a line that touches it, and one circle inside another.
        "0 = y^2 + z^2 - 1, 0 = y + z - 3 * p, start: (1, 1/2)",
        "0 = y^2 + z^2 - 2, 0 = y + z - 2 * p, start: (2, 1/2)",
        "0 = y^2 + z^2 - 1, 0 = y^2 + z^2 - y / 4 - 3 * p, start: (1, 1/2)",
        // Both approach zero only far away.
        "0 = sqrt(y^2 + p) - y, 0 = z + y - p, start: (1, 1)",
        "0 = (y - 1000)^2 + 1e-12 * p, 0 = z - y, start: (1, 1), iterations: 1000",
        // The Jacobian is singular at the start, and everywhere along the way.
        "0 = y * z, 0 = y + z, start: (0, 0)",
        "0 = y^2 - p, 0 = z^2 - p, start: (0, 0)",
        // Roots and logarithms outside their domains.
        "0 = sqrt(y - 3 * p) + z, 0 = z + y, start: (1, 1)",
        "0 = y + z^3 - p, 0 = y - 2 * z - 3 * p, start: (100, 50), iterations: 2",
    ] {
        let values = of(equations);
        assert!(values.iter().all(|value| value.is_nan()), "{equations} {values:?}");
    }
    // The same equations where they have solutions.
    for (equations, expected) in [
        ("0 = y^2 + z^2 - 1, 0 = y + z - p, start: (1, 1/2)", [1.0, 0.0]),
        ("0 = y * z - p + 1, 0 = y + 2 * z - 2 * p, start: (0, 3)", [0.0, 1.0]),
        ("0 = y + z^3 - p, 0 = y - 2 * z - p, start: (100, 50)", [1.0, 0.0]),
        ("0 = abs(y) * y + z, 0 = y - z", [0.0, 0.0]),
        ("0 = max(y, 2 * y) + z - 3 * p, 0 = y - z", [1.0, 1.0]),
        ("0 = max(y, 2 * y) + z, 0 = y - z, start: (1, -1)", [0.0, 0.0]),
        ("0 = 1e-9 * (y - p), 0 = 1e12 * (z - y)", [1.0, 1.0]),
        ("0 = 1e9 * y - p, 0 = 1e-9 * z + y - 2 * p, start: (1, 0)", [1e-9, 1.999_999_999e9]),
    ] {
        for (found, expected) in of(equations).into_iter().zip(expected) {
            assert!((found - expected).abs() < 1e-15 * (1.0 + expected), "{equations}: {found} {expected}");
        }
    }
}

#[test]
fn printed_equations_keep_their_meaning() {
    for equations in [
        "(y, z): 0 = y^2 - x * z, 0 = z - cos(y)",
        "(y: m, z): 0 = y - x^3/(4 [m^2]), 0 = z - y / (2 [m]), start: (2, 1/2), iterations: 7 + 1",
        "(y: mm, z: m): 0 = y + z - x, 0 = y - z^2 / (1 [m]), start: (1, x)",
    ] {
        let text = format!(
            "coord x: m; solve {equations}; kinetic = 1/2 * dot(x)^2; output out = y; output other = z;"
        );
        let declaration = read(&text);
        let again = printed_and_read(&declaration);
        assert_eq!(emitted(again), emitted(declaration), "{equations}");
    }
}

#[test]
fn an_unknown_that_only_serves_another_is_no_mistake() {
    for (used, unused) in [("y", 0), ("z", 0), ("y + z", 0), ("1", 2)] {
        let text = format!(
            "coord x; solve (y, z): 0 = y - x + z^3, 0 = z + y^3; kinetic = 1/2 * dot(x)^2; force x = {used};"
        );
        let system = parse(&text).expect("no mistake");
        assert_eq!(system.report.diagnostics().len(), unused, "{used}");
    }
}
