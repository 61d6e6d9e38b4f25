use super::{Precision, Surroundings, Target, prelude, statements};
use crate::program::{Labels, lower, optimise};
use lagrange_expr::accuracy::Accuracy;
use lagrange_expr::elementary::ROWS;
use lagrange_expr::expr::{Function, Graph, Relation};
use lagrange_expr::functions::apply;
use lagrange_expr::number::Number;
use lagrange_expr::opaque::Opaque;
use lagrange_expr::symbol::Role;

/// Vectors of positions, velocities and parameters, with the names of a graph.
struct Vectors<'a>(&'a Graph);

impl Surroundings for Vectors<'_> {
    fn place(&self, role: Role) -> String {
        match role {
            Role::Coordinate(index) => format!("q[{index}]"),
            Role::Velocity(index) => format!("v[{index}]"),
            Role::Parameter(_) => "p[0]".to_owned(),
            _ => "p[1]".to_owned(),
        }
    }

    fn name(&self, role: Role) -> Option<String> {
        let symbols = self.0.symbols();
        symbols.find(role).map(|symbol| symbols.get(symbol).identifier())
    }

    fn call(&self, function: &Opaque, arguments: &[&str]) -> String {
        format!("{}({})", function.rust_name(), arguments.join(", "))
    }
}

/// Writes a one-sided spring with dry friction, on a rotating disc.
fn body(target: Target, accuracy: Accuracy) -> String {
    let mut graph = Graph::new();
    let g = &mut graph;
    let [k, gap] = ["k", "gap"].map(|name| {
        if name == "k" { g.symbol(name, Role::Parameter(0)) } else { g.symbol(name, Role::Input(0)) }
    });
    let (x, v) = (g.symbol("θ", Role::Coordinate(0)), g.symbol("θ", Role::Velocity(0)));
    let depth = g.subtract(gap, x);
    let (push, zero) = (g.multiply(k, depth), g.number(0));
    let normal = g.choose(Relation::Less, x, gap, push, zero);
    let [sine, cosine] = [Function::Sin, Function::Cos].map(|f| apply(g, f, &[x]));
    let slip = apply(g, Function::Tanh, &[v]);
    let lever = g.scale(Number::ratio(-1, 10).expect("no zero"), sine);
    let (turned, rubbed) = (g.multiply(lever, cosine), g.multiply(slip, normal));
    let high = g.power(v, Number::from(77));
    let sum = g.add(turned, rubbed);
    let force = g.add(sum, high);
    let mut labels = Labels::default();
    labels.insert(normal, "normal");
    let program = optimise(&lower(g, &[force, lever], &labels), accuracy);
    statements(&program, target, &Vectors(g), "a").expect("moderate numbers")
}

#[test]
fn values_are_statements_with_what_the_declaration_calls_them() {
    insta::assert_snapshot!("spring", body(Target::C(Precision::Double), Accuracy::Standard));
}

#[test]
fn a_script_has_the_same_statements() {
    insta::assert_snapshot!("script", body(Target::JavaScript, Accuracy::Standard));
}

#[test]
fn constants_have_the_kind_of_the_numbers() {
    let single = body(Target::C(Precision::Single), Accuracy::Fast);
    assert!(single.contains("(-0.1f)") && single.contains("LAGRANGE_SIN_COS"), "{single}");
    assert!(prelude(Precision::Single).starts_with("typedef float REAL;\n#define LAGRANGE_SINGLE 1\n"));
}

#[test]
fn numbers_out_of_range_are_reported_once() {
    let mut graph = Graph::new();
    let x = graph.symbol("x", Role::Coordinate(0));
    let large = Number::parse_decimal("1e60").expect("a literal");
    let scaled = graph.scale(large, x);
    let program = lower(&graph, &[scaled], &Labels::default());
    let write = |precision| statements(&program, Target::C(precision), &Vectors(&graph), "a");
    assert_eq!(
        write(Precision::Double).as_deref(),
        Ok("    const REAL x0 = q[0]; // x\n    const REAL x1 = 1e60 * x0;\n    a[0] = x1;\n")
    );
    assert_eq!(write(Precision::Single).expect_err("too large").constants, ["about 1e60"]);
}

#[test]
fn the_prelude_has_every_function() {
    let prelude = prelude(Precision::Double);
    for row in &ROWS {
        let definition =
            format!("#define {}", Target::C(Precision::Double).call(row.rust, "").replace(')', ""));
        assert!(prelude.contains(&definition), "{definition}");
    }
}
