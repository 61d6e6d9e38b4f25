use super::{Expansion, Series};
use crate::calculus::{AccelerationTerms, Rates};
use lagrange_expr::elementary::ROWS;
use lagrange_expr::expr::evaluate;
use lagrange_expr::expr::{ExprId, Function, Graph, Relation};
use lagrange_expr::functions::apply;
use lagrange_expr::number::Number;
use lagrange_expr::symbol::Role;

/// Returns coordinates x, y and their velocities.
fn symbols(g: &mut Graph) -> [ExprId; 4] {
    let roles = [Role::Coordinate(0), Role::Coordinate(1), Role::Velocity(0), Role::Velocity(1)];
    roles.map(|role| {
        g.symbol(if matches!(role, Role::Coordinate(0) | Role::Velocity(0)) { "x" } else { "y" }, role)
    })
}

fn ratio(g: &mut Graph, numerator: i64, denominator: i64) -> ExprId {
    g.number(Number::ratio(numerator, denominator).expect("a number"))
}

/// Expands with x and its velocity near zero.
fn near_zero(g: &mut Graph, root: ExprId) -> Option<Series> {
    let ([x, _, v, _], zero) = (symbols(g), g.number(0));
    let mut expansion = Expansion::default();
    expansion.vary(g, x, zero);
    expansion.vary(g, v, zero);
    expansion.of(g, root, 2)
}

fn value(g: &Graph, root: ExprId, at: [f64; 4]) -> f64 {
    evaluate(g, &[root], |role| match role {
        Role::Coordinate(i) => at[i as usize],
        Role::Velocity(i) => at[2 + i as usize],
        _ => f64::NAN,
    })[0]
}

#[test]
fn every_function_is_met_to_third_order() {
    for row in &ROWS {
        let mut g = Graph::new();
        let [x, y, ..] = symbols(&mut g);
        let f = apply(&mut g, row.function, &[x, y][..row.arity]);
        let mut expansion = Expansion::default();
        for (symbol, tenths) in [(x, 6), (y, 4)] {
            let point = ratio(&mut g, tenths, 10);
            expansion.vary(&mut g, symbol, point);
        }
        let series = expansion.of(&mut g, f, 2).expect("smooth there");
        let error = |h: f64| {
            let at = [0.6 + h, 0.4 - 2.0 * h, 0.0, 0.0];
            (value(&g, series.closed, at) - value(&g, f, at)).abs()
        };
        // Third derivatives are of order ten to a hundred here; errors in second ones would appear
        // at 1e-6.
        assert!(error(0.0) < 1e-15 && error(1e-3) < 1e-7, "{}: {} {}", row.name, error(0.0), error(1e-3));
    }
}

#[test]
fn kinks_and_poles_at_the_point_have_no_expansion() {
    let mut g = Graph::new();
    let ([x, y, ..], one) = (symbols(&mut g), g.number(1));
    let (opposite, shifted, square) = (g.negate(x), g.add(x, one), g.square(x));
    let call = |g: &mut Graph, function, arguments: &[ExprId]| apply(g, function, arguments);
    let (zero, product) = (g.number(0), g.multiply(x, y));
    let rough = [
        call(&mut g, Function::Abs, &[x]),
        call(&mut g, Function::Sign, &[product]),
        call(&mut g, Function::Max, &[x, opposite]),
        call(&mut g, Function::Ln, &[x]),
        call(&mut g, Function::Acos, &[shifted]),
        call(&mut g, Function::Hypot, &[x, opposite]),
        call(&mut g, Function::Atan2, &[x, product]),
        g.power(square, Number::ratio(1, 2).expect("a number")),
        g.reciprocal(x),
        g.choose(Relation::Less, x, zero, square, zero),
    ];
    for root in rough {
        assert!(near_zero(&mut g, root).is_none(), "{:?}", g.node(root));
    }
    let smooth = [
        call(&mut g, Function::Abs, &[shifted]),
        call(&mut g, Function::Max, &[x, one]),
        call(&mut g, Function::Atan2, &[x, shifted]),
        call(&mut g, Function::Hypot, &[x, y]),
        g.power(x, Number::ratio(5, 2).expect("a number")),
    ];
    for root in smooth {
        assert!(near_zero(&mut g, root).is_some(), "{:?}", g.node(root));
    }
}

#[test]
fn a_factor_that_vanishes_at_a_kink_smooths_it() {
    let mut g = Graph::new();
    let ([x, y, v, _], zero) = (symbols(&mut g), g.number(0));
    let magnitude = apply(&mut g, Function::Abs, &[v]);
    let squares = [g.square(x), g.square(v)];
    let sum = g.total(squares);
    let norm = g.power(sum, Number::ratio(1, 2).expect("a number"));
    let larger = apply(&mut g, Function::Max, &[x, v]);
    let steeper = g.scale(Number::TWO, squares[0]);
    let known = [
        (magnitude, 0),
        (norm, 0),
        (larger, 0),
        (g.multiply(magnitude, v), 1),
        (g.multiply(norm, v), 1),
        (g.multiply(norm, y), 0),
        (g.product([(magnitude, Number::ONE), (norm, Number::ONE), (v, Number::ONE)]), 2),
        (g.power(norm, Number::from(3)), 2),
        (g.choose(Relation::Less, x, zero, squares[0], steeper), 1),
        (g.choose(Relation::Less, x, zero, v, zero), 0),
    ];
    for (root, order) in known {
        let mut expansion = Expansion::default();
        expansion.vary(&mut g, x, zero);
        expansion.vary(&mut g, v, zero);
        let found = expansion.of(&mut g, root, 0).expect("continuous");
        assert_eq!(found.order, order, "{:?}", g.node(root));
        assert!(g.is_zero(found.closed), "{:?}", g.node(root));
    }
}

#[test]
fn unchosen_branches_may_be_undefined() {
    let mut g = Graph::new();
    let ([x, ..], one) = (symbols(&mut g), g.number(1));
    let pole = g.reciprocal(x);
    let guarded = g.choose(Relation::Less, x, one, x, pole);
    assert_eq!(near_zero(&mut g, guarded).expect("the other branch").closed, x);
    let mut held = Expansion::default();
    held.hold(x, one);
    assert_eq!(held.of(&mut g, guarded, 2).map(|series| series.closed), Some(one));
}

#[test]
fn squares_of_first_degree_stay_squares() {
    let mut g = Graph::new();
    let [x, _, x_dot, y_dot] = symbols(&mut g);
    let (sine, cosine) = (apply(&mut g, Function::Sin, &[x]), apply(&mut g, Function::Cos, &[x]));
    let (across, up) = (g.multiply(cosine, x_dot), g.multiply(sine, x_dot));
    let across = g.add(y_dot, across);
    let (kept, left_out) = (g.square(across), g.square(up));
    let expected = g.add(y_dot, x_dot);
    let expected = g.square(expected);
    assert_eq!(near_zero(&mut g, kept).expect("smooth").closed, expected);
    let left = near_zero(&mut g, left_out).expect("smooth").closed;
    assert!(g.is_zero(left), "of fourth degree");
}

#[test]
fn expanding_commutes_with_the_rate_of_change() {
    let mut g = Graph::new();
    let [x, y, x_dot, _] = symbols(&mut g);
    let sum = g.add(x, y);
    let (sine, growth) = (apply(&mut g, Function::Sin, &[sum]), apply(&mut g, Function::Exp, &[x]));
    let swing = g.multiply(sine, growth);
    let whole = g.multiply(swing, x_dot);
    for root in [swing, whole] {
        let mut rates = Rates::new(AccelerationTerms::Dropped);
        let rate = rates.of(&mut g, root);
        let rate = near_zero(&mut g, rate).expect("smooth").closed;
        let series = near_zero(&mut g, root).expect("smooth").closed;
        let series_rate = rates.of(&mut g, series);
        let at = [0.3, 0.8, -0.2, 1.7];
        let difference = value(&g, rate, at) - value(&g, series_rate, at);
        assert!(difference.abs() < 1e-14, "{difference}");
        assert!(value(&g, rate, at).abs() > 1e-2);
    }
}
