mod meaning;

use proc_macro2::{Ident, Span};
use quote::quote;

use super::{Names, Scalar, Unrepresentable, body};
use crate::program::{Labels, lower, optimise};
use lagrange_expr::accuracy::Accuracy;
use lagrange_expr::expr::{ExprId, Function, Graph, Relation};
use lagrange_expr::functions::apply;
use lagrange_expr::number::Number;
use lagrange_expr::symbol::Role;

fn generic() -> Scalar {
    Scalar::Generic(Ident::new("S", Span::call_site()))
}

fn side_by_side() -> Scalar {
    Scalar::SideBySide { number: Ident::new("S", Span::call_site()), is_single: false, is_generic: true }
}

/// Returns the body as a formatted function.
fn function(graph: &Graph, outputs: &[ExprId], labels: &Labels, scalar: &Scalar) -> String {
    let program = optimise(&lower(graph, outputs, labels), Accuracy::Standard);
    let mut names = Names::default();
    let body = body(&program, graph.symbols(), scalar, &mut names).expect("moderate numbers");
    let inputs = body.used.iter().map(|&role| names.role(graph.symbols(), role));
    let (statements, outputs) = (&body.statements, &body.outputs);
    let function = quote! {
        fn f([#(#inputs),*]: Inputs) -> Outputs {
            #statements
            [#(#outputs),*]
        }
    };
    let file = syn::parse2(function).expect("valid Rust");
    prettyplease::unparse(&file)
}

fn coordinate(graph: &mut Graph, name: &str, index: u32) -> (ExprId, ExprId) {
    let position = graph.symbol(name, Role::Coordinate(index));
    (position, graph.symbol(name, Role::Velocity(index)))
}

fn parameters<const N: usize>(graph: &mut Graph, names: [&str; N]) -> [ExprId; N] {
    std::array::from_fn(|i| graph.symbol(names[i], Role::Parameter(i as u32)))
}

fn product<const N: usize>(graph: &mut Graph, factors: [ExprId; N]) -> ExprId {
    graph.product(factors.map(|factor| (factor, Number::ONE)))
}

/// Returns energy and acceleration of a damped pendulum.
fn pendulum() -> (Graph, Vec<ExprId>, Labels) {
    let mut graph = Graph::new();
    let g = &mut graph;
    let [m, l, c, gravity] = parameters(g, ["m", "l", "c", "g"]);
    let (theta, theta_dot) = coordinate(g, "theta", 0);
    let (sin, cos) = (apply(g, Function::Sin, &[theta]), apply(g, Function::Cos, &[theta]));
    let (l2, v2) = (g.square(l), g.square(theta_dot));
    let twice_kinetic = product(g, [m, l2, v2]);
    let kinetic = g.scale(Number::ratio(1, 2).expect("no zero"), twice_kinetic);
    let lift = product(g, [m, gravity, l, cos]);
    let energy = g.subtract(kinetic, lift);
    let (damping, weight) = (g.multiply(c, theta_dot), product(g, [m, gravity, l, sin]));
    let moment = g.add(damping, weight);
    let (moment, inertia) = (g.negate(moment), g.multiply(m, l2));
    let acceleration = g.divide(moment, inertia);
    let mut labels = Labels::default();
    labels.insert(energy, "energy");
    labels.insert(inertia, "inertia");
    (graph, vec![energy, acceleration], labels)
}

/// Returns mass matrix and bias of a double pendulum in absolute angles.
fn double_pendulum() -> (Graph, Vec<ExprId>, Labels) {
    let mut graph = Graph::new();
    let g = &mut graph;
    let [m1, m2, l1, l2] = parameters(g, ["m1", "m2", "l1", "l2"]);
    let ((theta1, v1), (theta2, v2)) = (coordinate(g, "theta1", 0), coordinate(g, "theta2", 1));
    let delta = g.subtract(theta1, theta2);
    let (sin, cos) = (apply(g, Function::Sin, &[delta]), apply(g, Function::Cos, &[delta]));
    let (mass, l1_sq, l2_sq) = (g.add(m1, m2), g.square(l1), g.square(l2));
    let (v1_sq, v2_sq) = (g.square(v1), g.square(v2));
    let matrix = [product(g, [mass, l1_sq]), product(g, [m2, l1, l2, cos]), product(g, [m2, l2_sq])];
    let bias = [product(g, [m2, l1, l2, sin, v2_sq]), product(g, [m2, l1, l2, sin, v1_sq])];
    let bias = [bias[0], g.negate(bias[1])];
    let mut labels = Labels::default();
    let names = ["m_0_0", "m_0_1", "m_1_1"].iter().zip(matrix).chain(["bias_0", "bias_1"].iter().zip(bias));
    names.for_each(|(name, entry)| labels.insert(entry, *name));
    let [m00, m01, m11] = matrix;
    // Elimination of the second row.
    let factor = g.divide(m01, m11);
    let (correction, forcing) = (g.multiply(factor, m01), g.multiply(factor, bias[1]));
    let (pivot, right) = (g.subtract(m00, correction), g.subtract(bias[0], forcing));
    let first = g.divide(right, pivot);
    let coupling = g.multiply(m01, first);
    let rest = g.subtract(bias[1], coupling);
    let second = g.divide(rest, m11);
    labels.insert(delta, "delta");
    (graph, vec![first, second], labels)
}

/// Returns a one-sided spring with dry friction.
fn contact() -> (Graph, Vec<ExprId>, Labels) {
    let mut graph = Graph::new();
    let g = &mut graph;
    let [k, mu, gap] = parameters(g, ["k", "mu", "gap"]);
    let (x, v) = coordinate(g, "x", 0);
    let depth = g.subtract(gap, x);
    let (push, zero) = (g.multiply(k, depth), g.number(0));
    let normal = g.choose(Relation::Less, x, gap, push, zero);
    let ratio = g.scale(Number::from(100), v);
    let slip = apply(g, Function::Tanh, &[ratio]);
    let friction = product(g, [mu, normal, slip]);
    let force = g.subtract(normal, friction);
    let mut labels = Labels::default();
    labels.insert(normal, "normal");
    (graph, vec![force], labels)
}

/// Returns energy and acceleration of a body in the field of a fixed one.
fn orbit() -> (Graph, Vec<ExprId>, Labels) {
    let mut graph = Graph::new();
    let g = &mut graph;
    let [mu] = parameters(g, ["mu"]);
    let ((x, vx), (y, vy)) = (coordinate(g, "x", 0), coordinate(g, "y", 1));
    let [x2, y2, vx2, vy2] = [x, y, vx, vy].map(|base| g.square(base));
    let (r2, v2) = (g.add(x2, y2), g.add(vx2, vy2));
    let half = Number::ratio(1, 2).expect("no zero");
    let inverse = g.power(r2, -&half);
    let potential = g.multiply(mu, inverse);
    let energy = g.sum(Number::ZERO, [(v2, half.clone()), (potential, Number::MINUS_ONE)]);
    let cube = g.power(r2, -&(&half + &Number::ONE));
    let accelerations = [x, y].map(|position| {
        let pull = product(g, [mu, position, cube]);
        g.negate(pull)
    });
    let mut labels = Labels::default();
    labels.insert(r2, "r_sq");
    (graph, vec![energy, accelerations[0], accelerations[1]], labels)
}

#[test]
fn roots_and_reciprocals_are_named_after_what_they_are_of() {
    let (graph, outputs, labels) = orbit();
    insta::assert_snapshot!("orbit", function(&graph, &outputs, &labels, &Scalar::F64));
}

#[test]
fn parts_of_a_pair_keep_their_labels() {
    let (mut graph, _, mut labels) = pendulum();
    let theta = graph.symbol("theta", Role::Coordinate(0));
    let [sin, cos] = [Function::Sin, Function::Cos].map(|f| apply(&mut graph, f, &[theta]));
    labels.insert(sin, "s");
    let text = function(&graph, &[sin, cos], &labels, &Scalar::F64);
    assert!(text.contains("let (s, cos_theta) = sin_cos(theta);"), "{text}");
    assert_eq!(text, function(&graph, &[sin, cos], &labels, &Scalar::F64));
}

#[test]
fn a_pendulum_reads_like_written_by_hand() {
    let (graph, outputs, labels) = pendulum();
    insta::assert_snapshot!("pendulum", function(&graph, &outputs, &labels, &Scalar::F64));
}

#[test]
fn elimination_reads_like_written_by_hand() {
    let (graph, outputs, labels) = double_pendulum();
    insta::assert_snapshot!("elimination", function(&graph, &outputs, &labels, &Scalar::F64));
}

#[test]
fn a_choice_is_nan_if_its_condition_is() {
    let (graph, outputs, labels) = contact();
    insta::assert_snapshot!("contact", function(&graph, &outputs, &labels, &Scalar::F32));
}

#[test]
fn generic_code_converts_its_constants() {
    let (graph, outputs, labels) = contact();
    insta::assert_snapshot!("contact_generic", function(&graph, &outputs, &labels, &generic()));
}

#[test]
fn numbers_side_by_side_take_no_branch() {
    let (graph, outputs, labels) = contact();
    insta::assert_snapshot!("contact_side_by_side", function(&graph, &outputs, &labels, &side_by_side()));
}

#[test]
fn constants_are_those_of_the_numbers_that_stand_side_by_side() {
    let mut graph = Graph::new();
    let third = graph.number(Number::ratio(1, 3).expect("no zero"));
    let program = lower(&graph, &[third], &Labels::default());
    let number = Ident::new("S", Span::call_site());
    let written = [false, true].map(|is_single| {
        let scalar = Scalar::SideBySide { number: number.clone(), is_single, is_generic: false };
        body(&program, graph.symbols(), &scalar, &mut Names::default()).expect("a third").outputs[0]
            .to_string()
    });
    assert_eq!(written, ["S :: from_f64 (0.3333333333333333)", "S :: from_f64 (0.33333334)"]);
}

#[test]
fn numbers_out_of_range_are_reported_once() {
    let mut graph = Graph::new();
    let [a, b] = parameters(&mut graph, ["a", "b"]);
    let large = Number::parse_decimal("1e60").expect("a literal");
    let outputs = [a, b].map(|term| graph.scale(large.clone(), term));
    let program = lower(&graph, &outputs, &Labels::default());
    let write = |scalar| body(&program, graph.symbols(), &scalar, &mut Names::default());
    assert!(write(Scalar::F64).is_ok());
    assert_eq!(write(Scalar::F32).err(), Some(Unrepresentable { constants: vec!["about 1e60".to_owned()] }));
}

#[test]
fn long_formulas_are_split_and_deep_ones_need_no_stack() {
    let write = || {
        let mut graph = Graph::new();
        let [a, b] = parameters(&mut graph, ["a", "b"]);
        let root = (0..30_000).fold(a, |inner, _| {
            let sum = graph.add(inner, b);
            graph.divide(sum, a)
        });
        let program = optimise(&lower(&graph, &[root], &Labels::default()), Accuracy::Standard);
        let body = body(&program, graph.symbols(), &Scalar::F64, &mut Names::default());
        let statements = body.expect("no constants").statements.to_string();
        let lengths = statements.split(';').map(str::len).collect::<Vec<_>>();
        assert!(lengths.len() > 10_000, "{}", lengths.len());
        assert!(lengths.iter().all(|length| *length < 150), "{:?}", lengths.iter().max());
    };
    let thread = std::thread::Builder::new().stack_size(256 << 10).spawn(write);
    thread.expect("a thread can be spawned").join().expect("no overflow");
}

#[test]
fn operands_are_parenthesised_where_needed() {
    let mut graph = Graph::new();
    let g = &mut graph;
    let [a, b, c, d] = parameters(g, ["a", "b", "c", "d"]);
    let (ab, cd) = (g.add(a, b), g.subtract(c, d));
    let nested = g.subtract(ab, cd);
    let (quotient, opposite) = (g.divide(ab, cd), g.negate(ab));
    let exponential = apply(g, Function::Exp, &[opposite]);
    let scaled = g.scale(Number::ratio(-1, 2).expect("no zero"), quotient);
    let outputs = [quotient, exponential, scaled, nested];
    let expected = ["(a + b) / (c - d)", "exp(-(a + b))", "-0.5 * (a + b) / (c - d)", "a + b - c + d"];
    for (output, expected) in outputs.into_iter().zip(expected) {
        let program = lower(g, &[output], &Labels::default());
        let body = body(&program, g.symbols(), &Scalar::F64, &mut Names::default());
        let written = body.expect("moderate numbers").outputs.remove(0);
        let expected: proc_macro2::TokenStream = expected.parse().expect("Rust");
        assert_eq!(written.to_string(), expected.to_string());
    }
}
