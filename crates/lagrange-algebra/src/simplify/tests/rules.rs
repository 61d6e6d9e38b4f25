use proptest::prelude::{ProptestConfig, prop, prop_assert, proptest};

use crate::simplify::{RULES, Rule, RuleArguments, collect};
use lagrange_expr::expr::evaluate;
use lagrange_expr::expr::{ExprId, Function, Graph, Node};
use lagrange_expr::functions::apply;
use lagrange_expr::number::Number;
use lagrange_expr::symbol::Role;

fn coordinates(g: &mut Graph) -> [ExprId; 3] {
    [("q", 0), ("r", 1), ("s", 2)].map(|(name, index)| g.symbol(name, Role::Coordinate(index)))
}

fn value(role: Role) -> f64 {
    match role {
        Role::Parameter(index) => 0.75 + f64::from(index) * 0.375,
        Role::Coordinate(index) => (f64::from(index) * 0.83).sin(),
        _ => 0.5,
    }
}

/// Returns the two terms of a rule, times `cofactor`.
fn sides(g: &mut Graph, rule: &Rule, cofactor: ExprId, x: ExprId, y: ExprId) -> [ExprId; 2] {
    let y = if rule.arguments == RuleArguments::Same { x } else { y };
    let side = |g: &mut Graph, [f, h]: [Function; 2]| {
        let (fx, hy) = (apply(g, f, &[x]), apply(g, h, &[y]));
        let pair = g.multiply(fx, hy);
        g.multiply(cofactor, pair)
    };
    let (left, right) = (side(g, rule.left), side(g, rule.right));
    [left, if rule.subtracts { g.negate(right) } else { right }]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 64, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn every_rule_keeps_the_value_and_leaves_one_term(point in prop::array::uniform3(-3.0..3.0_f64)) {
        for rule in &RULES {
            let mut g = Graph::new();
            let [x, y, z] = coordinates(&mut g);
            let m = g.symbol("m", Role::Parameter(0));
            let cofactor = g.multiply(m, z);
            let shifted = g.add(x, y);
            for (x, y) in [(x, y), (y, x), (shifted, x)] {
                let [a, b] = sides(&mut g, rule, cofactor, x, y);
                let sum = g.add(a, b);
                let single = rule.apply(&mut g, a, b).unwrap_or_else(|| panic!("{} matches", rule.name));
                let (_, core) = g.split_coefficient(single);
                prop_assert!(!matches!(g.node(core), Node::Sum { .. }), "{}: {}", rule.name, rule.measure);
                let values = evaluate(&g, &[sum, single], |role| match role {
                    Role::Coordinate(index) => point[index as usize],
                    _ => 1.25,
                });
                let scale = 1.0 + (2.0 * point[0].abs().max((point[0] + point[1]).abs())).exp();
                prop_assert!((values[0] - values[1]).abs() < 1e-13 * scale, "{}: {values:?}", rule.algebra);
            }
        }
    }
}

#[test]
fn no_rule_joins_terms_with_different_cofactors() {
    for rule in &RULES {
        let mut g = Graph::new();
        let [x, y, z] = coordinates(&mut g);
        let two = g.scale(Number::TWO, z);
        let [a, _] = sides(&mut g, rule, z, x, y);
        let [_, b] = sides(&mut g, rule, two, x, y);
        assert_eq!(rule.apply(&mut g, a, b), None, "{}", rule.name);
    }
}

/// Returns `M`, `l`, `sin q`, `cos q`.
fn pendulum(g: &mut Graph) -> [ExprId; 4] {
    let [q, ..] = coordinates(g);
    let (m, l) = (g.symbol("M", Role::Parameter(0)), g.symbol("l", Role::Parameter(1)));
    [m, l, apply(g, Function::Sin, &[q]), apply(g, Function::Cos, &[q])]
}

fn one(id: ExprId) -> (ExprId, Number) {
    (id, Number::ONE)
}

#[test]
fn squares_meet_through_nested_products() {
    let mut g = Graph::new();
    let [m, l, sin, cos] = pendulum(&mut g);
    let nested = [cos, sin].map(|f| {
        let arm = g.multiply(l, f);
        g.product([(m, Number::ONE), (arm, Number::TWO)])
    });
    let expected = g.product([(m, Number::ONE), (l, Number::TWO)]);
    let total = collect(&mut g, vec![one(nested[0]), one(nested[1])]);
    let values = evaluate(&g, &[total, expected], value);
    assert!((values[0] - values[1]).abs() < 1e-15);
    assert!(!g.reachable(&[total]).contains(&sin) && !g.reachable(&[total]).contains(&cos));
}

#[test]
fn squares_meet_beside_a_shared_cofactor() {
    let mut g = Graph::new();
    let [m, l, sin, cos] = pendulum(&mut g);
    let inertia = g.product([(m, Number::ONE), (l, Number::TWO)]);
    let [a, b] = [cos, sin].map(|f| g.product([(f, Number::TWO), (inertia, Number::ONE)]));
    let three = Number::from(3);
    let total = collect(&mut g, vec![(a, three.clone()), one(l), (b, three.clone())]);
    let expected = g.sum(Number::ZERO, [(inertia, three), (l, Number::ONE)]);
    assert_eq!(total, expected, "the cofactor stays the node it was");
}

#[test]
fn factors_spread_over_two_products_are_removed() {
    let mut g = Graph::new();
    let [m, l, sin, cos] = pendulum(&mut g);
    let [a, b] = [cos, sin].map(|f| {
        let (left, right) = (g.multiply(m, f), g.multiply(l, f));
        g.multiply(left, right)
    });
    assert_eq!(collect(&mut g, vec![one(a), one(b)]), g.multiply(m, l));
}

#[test]
fn joined_terms_are_joined_again() {
    let mut g = Graph::new();
    let [q, r, _] = coordinates(&mut g);
    let squares = [q, r].map(|x| {
        [Function::Sin, Function::Cos].map(|f| {
            let call = apply(&mut g, f, &[x]);
            g.square(call)
        })
    });
    let [[sq, cq], [sr, cr]] = squares;
    let terms = [(sq, sr), (cq, sr), (sq, cr), (cq, cr)].map(|(a, b)| one(g.multiply(a, b)));
    let total = collect(&mut g, terms.to_vec());
    assert!(g.is_one(total));
}

#[test]
fn removing_a_square_never_divides() {
    let mut g = Graph::new();
    let [m, l, sin, cos] = pendulum(&mut g);
    let nested = [sin, cos].map(|f| {
        let arm = g.multiply(l, f);
        let weighted = g.multiply(m, arm);
        g.multiply(arm, weighted)
    });
    let total = collect(&mut g, nested.map(one).to_vec());
    assert_eq!(evaluate(&g, &[total], |role| if role == Role::Coordinate(0) { 0.0 } else { 2.0 }), [8.0]);
    assert!(!g.reachable(&[total]).contains(&sin) && !g.reachable(&[total]).contains(&cos));
}

#[test]
fn products_cancel_however_they_are_nested() {
    let mut g = Graph::new();
    let [q, r, s] = coordinates(&mut g);
    let (sin, cos) = (apply(&mut g, Function::Sin, &[q]), apply(&mut g, Function::Cos, &[q]));
    let (r_sin, r_cos) = (g.multiply(r, sin), g.multiply(r, cos));
    let (first, second) = (g.multiply(sin, r_cos), g.multiply(cos, r_sin));
    assert_ne!(first, second, "nesting tells them apart");
    let minus = Number::MINUS_ONE;
    assert_eq!(collect(&mut g, vec![one(first), one(s), (second, minus)]), s);
    assert_eq!(collect(&mut g, vec![one(first), one(second)]), g.scale(Number::TWO, first));
}

#[test]
fn what_squares_leave_behind_can_cancel() {
    let mut g = Graph::new();
    let [q, r, s] = coordinates(&mut g);
    let (sin, cos) = (apply(&mut g, Function::Sin, &[q]), apply(&mut g, Function::Cos, &[q]));
    let rs = g.multiply(r, s);
    let (sin2, cos2) = (g.square(sin), g.square(cos));
    let terms = [g.multiply(rs, sin2), g.multiply(rs, cos2)].map(one);
    let zero = collect(&mut g, vec![terms[0].clone(), terms[1].clone(), (rs, Number::MINUS_ONE)]);
    assert!(g.is_zero(zero));
}

#[test]
fn hyperbolic_squares_meet_when_subtracted() {
    let mut g = Graph::new();
    let [m, _, sin, _] = pendulum(&mut g);
    let [c, s] = [Function::Cosh, Function::Sinh].map(|f| {
        let call = apply(&mut g, f, &[sin]);
        g.product([(call, Number::TWO), (m, Number::ONE)])
    });
    assert_eq!(collect(&mut g, vec![(s, Number::MINUS_ONE), one(c)]), m);
    let sum = g.add(s, c);
    assert_eq!(collect(&mut g, vec![one(s), one(c)]), sum);
}

#[test]
fn what_does_not_match_is_the_plain_sum() {
    let mut g = Graph::new();
    let [m, l, sin, cos] = pendulum(&mut g);
    let (s, c) = (g.square(sin), g.square(cos));
    let unequal = g.sum(Number::ZERO, [(s, Number::ONE), (c, Number::TWO)]);
    assert_eq!(collect(&mut g, vec![one(s), (c, Number::TWO)]), unequal);
    let (ms, lc) = (g.multiply(m, s), g.multiply(l, c));
    let different = g.add(ms, lc);
    assert_eq!(collect(&mut g, vec![one(ms), one(lc)]), different);
    let empty = collect(&mut g, Vec::new());
    assert!(g.is_zero(empty));
}

#[test]
fn twenty_thousand_terms_are_collected_in_one_pass() {
    let mut g = Graph::new();
    let [_, _, sin, cos] = pendulum(&mut g);
    let masses = (0..10_000).map(|i| g.symbol(&format!("m{i}"), Role::Parameter(i))).collect::<Vec<_>>();
    let mut terms = Vec::new();
    for &f in &[sin, cos] {
        terms.extend(masses.iter().map(|&m| one(g.product([(m, Number::ONE), (f, Number::TWO)]))));
    }
    let expected = g.total(masses);
    assert_eq!(collect(&mut g, terms), expected);
}
