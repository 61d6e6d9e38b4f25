//! Expressions on one side of a switch keep their domain, for every elementary function and every
//! switching expression.
//!
//! On its own side an expression has the declared values, bit by bit except for rounding, including
//! NaN. Slightly beyond the surface it is finite and continuous, so that a step may probe there.

use lagrange_core::derive::{StrategyChoice, Switch, one_sided};
use lagrange_core::elementary::ROWS;
use lagrange_core::expr::evaluate;
use lagrange_core::expr::{ExprId, Graph};
use lagrange_core::pipeline::parse;
use lagrange_core::symbol::Role;

/// Nonnegative expressions of x that switch.
const SWITCHED: [&str; 12] = [
    "abs(x)",
    "k*abs(x - 1/2)/3",
    "1/4 + abs(x)",
    "max(0, x)",
    "max(0, -k*x)",
    "min(abs(x), 1/2)",
    "abs(sign(x))",
    "(if x > 0 { x } else { -x })",
    "(if x > 0 { x } else { x^2/(1 + x^2) })",
    "max(-1, min(1, k*x))",
    "max(1/4, x)",
    "max(p, -k*x)",
];
const EXPONENTS: [&str; 9] = ["1/3", "1/2", "1.7", "3/2", "2", "3", "p", "(p + 1)", "(p - 1)"];
const NEGATIVE_EXPONENTS: [&str; 4] = ["(-1/2)", "(-1.7)", "(-p)", "(1 - p)"];
/// Distances beyond a surface.
const DISTANCES: [f64; 5] = [1e-15, 1e-13, 1e-6, 0.01, 0.3];

/// An acceleration as declared, and restricted to sides.
struct Sided {
    graph: Graph,
    declared: ExprId,
    sided: ExprId,
    switches: Vec<Switch>,
}

impl Sided {
    fn new(force: &str) -> Sided {
        Sided::among("", force)
    }

    /// Returns a force beside declarations of functions.
    fn among(functions: &str, force: &str) -> Sided {
        let text =
            format!("{functions} param k = 2, p = 3/2; coord x; kinetic = 1/2*dot(x)^2; force x = {force};");
        let system = parse(&text).unwrap_or_else(|report| panic!("{force}: {report}"));
        let mut derived = system.derive(StrategyChoice::Cheapest).expect("it has inertia");
        let (declared, switches) = (derived.equations.accelerations[0], derived.equations.switches);
        let image = one_sided(&mut derived.model.graph, &switches, &[declared]);
        let sided = *image.get(&declared).expect("a root has an image");
        Sided { graph: derived.model.graph, declared, sided, switches }
    }

    fn at(&self, root: ExprId, x: f64, sides: &[f64]) -> f64 {
        evaluate(&self.graph, &[root], |role| match role {
            Role::Coordinate(_) => x,
            Role::Parameter(0) => 2.0,
            Role::Parameter(_) => 1.5,
            Role::Side(index) => sides[index as usize],
            _ => 0.0,
        })[0]
    }

    fn declared(&self, x: f64) -> f64 {
        self.at(self.declared, x, &[])
    }

    fn sides(&self, x: f64) -> Vec<f64> {
        let value = |switch: &Switch| self.at(switch.value, x, &[]);
        self.switches.iter().map(value).map(|value| if value < 0.0 { -1.0 } else { 1.0 }).collect()
    }

    /// Returns neighbouring numbers between which sides change, as far as multiples of a quarter
    /// and of a third surround them.
    fn surfaces(&self) -> Vec<[f64; 2]> {
        let places = (-13..=13).map(|n| f64::from(n) / 4.0 + 0.01).collect::<Vec<_>>();
        let mut surfaces = Vec::new();
        for pair in places.windows(2) {
            let [mut from, mut to] = [pair[0], pair[1]];
            let (before, after) = (self.sides(from), self.sides(to));
            if before == after {
                continue;
            }
            loop {
                let middle = 0.5 * (from + to);
                if middle == from || middle == to || to - from < 1e-17 {
                    break;
                }
                if self.sides(middle) == before { from = middle } else { to = middle }
            }
            surfaces.push([from, to]);
        }
        surfaces
    }
}

/// Returns accelerations that contain the function of a switching expression, or stand beside it.
fn forms(function: impl Fn(&str) -> String) -> Vec<String> {
    let mut forms = SWITCHED.iter().map(|inner| function(inner)).collect::<Vec<_>>();
    forms.extend(SWITCHED.iter().map(|inner| format!("x*{}", function(inner))));
    let [plus, minus] = ["x", "(-x)"].map(&function);
    forms.push(format!("if x > 0 {{ {plus} }} else {{ 0 }}"));
    forms.push(format!("if x >= 0 {{ {plus} }} else {{ -{minus} }}"));
    forms.push(format!("if x > 0 {{ if x > 1 {{ {plus} }} else {{ 2*{plus} }} }} else {{ {minus} }}"));
    let bound = function("1/10");
    forms.push(format!("if x > 1/10 {{ {plus} }} else {{ {bound} }}"));
    forms.push(format!("if 10*x < -1 {{ {minus} }} else {{ {bound} }}"));
    forms.push(format!("max({}, 1/3)", function("max(0, x)")));
    forms
}

fn all_forms() -> Vec<String> {
    let mut all = Vec::new();
    for row in &ROWS {
        match row.arity {
            1 => all.extend(forms(|inner| format!("{}({inner})", row.name))),
            _ if row.name == "pow" => {}
            _ => {
                all.extend(forms(|inner| format!("{}({inner}, 3/4)", row.name)));
                all.extend(forms(|inner| format!("{}(3/4, {inner})", row.name)));
            }
        }
    }
    EXPONENTS.iter().for_each(|exponent| all.extend(forms(|inner| format!("({inner})^{exponent}"))));
    // Among poles, a factor beside them removes only those of magnitudes.
    let is_pole_of_magnitude = |form: &String| !form.starts_with("x*(min") && !form.starts_with("x*((if");
    for exponent in NEGATIVE_EXPONENTS {
        all.extend(forms(|inner| format!("({inner})^{exponent}")).into_iter().filter(is_pole_of_magnitude));
    }
    all
}

#[test]
fn sides_have_the_values_of_the_declaration() {
    for form in all_forms() {
        let sided = Sided::new(&form);
        for x in (-40..=40).map(|n| f64::from(n) / 16.0 + 0.003) {
            let (expected, found) = (sided.declared(x), sided.at(sided.sided, x, &sided.sides(x)));
            let is_same = expected == found || expected.is_nan() && found.is_nan();
            let is_same = is_same || (expected - found).abs() <= 1e-14 * expected.abs().max(1.0);
            assert!(is_same, "{form} at {x}: {found}, not {expected}");
        }
    }
}

#[test]
fn a_little_beyond_surfaces_sides_are_finite_and_continuous() {
    let mut looked_at = 0;
    for form in all_forms() {
        let sided = Sided::new(&form);
        for [from, to] in sided.surfaces() {
            for (here, direction) in [(from, 1.0), (to, -1.0)] {
                let sides = sided.sides(here);
                let own = |distance: f64| sided.declared(here - direction * distance);
                let is_passed = DISTANCES.iter().all(|&d| own(d).is_finite() && own(-d).is_finite());
                // No step leads across a pole.
                let is_passed = is_passed && own(1e-15).abs().max(own(-1e-15).abs()) < 1e5;
                let is_continuous = (own(1e-13) - own(1e-15)).abs() < 1e-4;
                if !is_passed {
                    continue;
                }
                for distance in DISTANCES {
                    let found = sided.at(sided.sided, here + direction * distance, &sides);
                    assert!(found.is_finite(), "{form} at {here}, {distance} beyond: {found}");
                    let jump = (found - own(1e-15)).abs();
                    assert!(!is_continuous || distance > 1e-12 || jump < 1e-4, "{form} at {here}: {found}");
                    looked_at += 1;
                }
            }
        }
    }
    assert!(looked_at > 3000, "{looked_at}");
}

#[test]
fn singular_powers_have_no_value_beyond_their_surface() {
    for form in [
        "abs(x)^(-1/2)",
        "-sign(x)*abs(x)^(-3/2)",
        "x*abs(x)^(-3/2)",
        "abs(x)^(1 - k)*abs(x)^(-1/2)",
        "abs(x)^(-p)",
        "x*abs(x)^(-p)",
        "x*(k*abs(x))^(p - 3)",
    ] {
        let sided = Sided::new(form);
        for x in [1e-9, -1e-9] {
            assert!(sided.at(sided.sided, x, &sided.sides(-x)).is_nan(), "{form}");
        }
    }
    for form in ["-x/sqrt(abs(x))", "-x/sqrt(k*abs(x)/2)", "-2*x/(4*abs(x))^(1/2)"] {
        let removable = Sided::new(form);
        assert_eq!(removable.at(removable.sided, -0.25, &[1.0]), -0.5, "{form}");
        assert_eq!(removable.at(removable.sided, 0.0, &[1.0]), 0.0, "{form}");
    }
    // |x|^(1/2) in every case, with p = 3/2 and k = 2.
    for (form, scale) in [
        ("x*abs(x)^(p - 2)", 1.0),
        ("x/abs(x)^(2 - p)", 1.0),
        ("x*abs(x)^p/x^2", 1.0),
        ("x^3*abs(x)^(p - 4)", 1.0),
        ("x*(k*abs(x)/8)^(p - 2)", 2.0),
        ("(4*x - 1)*abs(1/4 - x)^(p - 2)/4", 1.0),
        ("sign(x)*abs(x)*abs(x)^(p - 2)", 1.0),
    ] {
        let removable = Sided::new(form);
        let surface = if form.contains("1/4") { 0.25 } else { 0.0 };
        let at = |distance: f64, side: f64| removable.at(removable.sided, surface + distance, &[side]);
        let right = |distance: f64| removable.declared(surface + distance);
        for side in [1.0, -1.0] {
            assert!((at(0.25 * side, side) - right(0.25 * side)).abs() < 1e-15, "{form}");
            assert!((at(0.25 * side, side).abs() - 0.5 * scale).abs() < 1e-15, "{form}");
            assert!((at(-0.25 * side, side) - at(0.25 * side, side)).abs() < 1e-15, "{form} beyond");
            assert_eq!(at(0.0, side), 0.0, "{form}");
        }
    }
}

#[test]
fn arguments_of_tables_that_end_keep_their_domain() {
    const TABLES: &str = "table f(d) = [(0, 0), (1/2, 1), (4, 9)], interpolation: linear, outside: error;
        table g(d, e) = [(0, 0, 1), (0, 4, 2), (4, 0, 3), (4, 4, 5)], interpolation: linear, outside: error;";
    for (force, surface) in [
        ("f(abs(x)) + g(1, 1)", 0.0),
        ("f(4 - abs(x)) + g(1, 1)", 0.0),
        ("g(abs(x), 1) + f(1)", 0.0),
        ("g(2, max(0, x)) + f(1)", 0.0),
        ("f(min(4, 15/4 + x)) + g(1, 1)", 0.25),
        ("if x > 0 { f(x^2 + x) } else { g(1, 1)*x }", 0.0),
        ("if x > 1/4 { f(x - 1/4) } else { g(1/4 - x, 1) }", 0.25),
    ] {
        let sided = Sided::among(TABLES, force);
        for side in [-1.0, 1.0] {
            let at = surface + side * 1e-12;
            let near = sided.declared(at);
            for distance in [1e-9, 1e-6, 1e-3] {
                let found = sided.at(sided.sided, surface - side * distance, &sided.sides(at));
                let is_near = (found - near).abs() < 10.0 * distance;
                assert!(is_near, "{force}, {distance} beyond {side}: {found}, not {near}");
            }
        }
        // On its own side an expression is undefined outside its domain.
        assert!(sided.at(sided.sided, 9.0, &sided.sides(9.0)).is_nan() || force.contains("min"), "{force}");
    }
}

#[test]
fn nothing_is_kept_where_no_function_restricts_its_argument() {
    for form in ["x*abs(x)", "sin(abs(x))", "if x > 0 { x^3 } else { x }", "max(0, x)^2 + exp(-abs(x))"] {
        let sided = Sided::new(form);
        let text = lagrange_core::formula::text::text(&sided.graph, sided.sided);
        assert!(!text.contains("abs") && !text.contains("|"), "{form}: {text}");
    }
}

#[test]
fn slopes_of_branches_are_zero_where_other_branches_apply() {
    for (potential, right) in
        [("x^(5/2)", 0.0), ("2*x^(5/2)/k + x^2", 0.0), ("k*ln(x)*x", 0.0), ("asin(x + 1)", 0.0)]
    {
        let text = format!(
            "param k = 2; coord x; kinetic = 1/2*dot(x)^2; potential = if x > 0 {{ {potential} }} else {{ 0 }};"
        );
        let derived =
            parse(&text).and_then(|system| system.derive(StrategyChoice::Cheapest)).expect("it is right");
        let found =
            evaluate(&derived.model.graph, &[derived.equations.accelerations[0]], |role| match role {
                Role::Parameter(_) => 2.0,
                _ => -3.5,
            });
        assert_eq!(found[0].abs(), right, "{potential}");
    }
}
