//! Operation counts of small formulas.

use super::{counts, letters};
use lagrange_expr::expr::{ExprId, Function, Graph};
use lagrange_expr::functions::apply;
use lagrange_expr::number::Number;

fn ratio(numerator: i64, denominator: i64) -> Number {
    Number::ratio(numerator, denominator).expect("no zero")
}

fn power(graph: &mut Graph, base: ExprId, numerator: i64, denominator: i64) -> ExprId {
    graph.power(base, ratio(numerator, denominator))
}

#[test]
fn kinetic_energy_of_a_point() {
    let (mut g, [m, ..], [x, y]) = letters();
    let (x2, y2) = (g.square(x), g.square(y));
    let v2 = g.add(x2, y2);
    let product = g.multiply(m, v2);
    let energy = g.scale(ratio(1, 2), product);
    assert_eq!(counts(&g, &[energy]), "1 addition, 4 multiplications");
}

#[test]
fn a_denominator_of_several_products_is_inverted_once() {
    let (mut g, [a, b, c, d], [x, _]) = letters();
    let ab = g.multiply(a, b);
    let quotients = [c, d, x].map(|numerator| g.divide(numerator, ab));
    assert_eq!(counts(&g, &quotients), "4 multiplications, 1 division");
    let single = g.divide(c, ab);
    assert_eq!(counts(&g, &[single]), "1 multiplication, 1 division");
}

#[test]
fn nested_fractions_divide_once() {
    let (mut g, [a, b, c, d], _) = letters();
    let (ab, cd) = (g.divide(a, b), g.divide(c, d));
    let quotient = g.divide(ab, cd);
    assert_eq!(counts(&g, &[quotient]), "2 multiplications, 1 division");
}

#[test]
fn powers_share_squares() {
    let (mut g, _, [x, _]) = letters();
    let fifth = power(&mut g, x, 5, 1);
    assert_eq!(counts(&g, &[fifth]), "3 multiplications");
    let fourth = power(&mut g, x, 4, 1);
    assert_eq!(counts(&g, &[fourth, fifth]), "3 multiplications");
    let hundredth = power(&mut g, x, 100, 1);
    assert_eq!(counts(&g, &[hundredth]), "1 function");
    let inverse_square = power(&mut g, x, -2, 1);
    assert_eq!(counts(&g, &[inverse_square]), "1 multiplication, 1 division");
}

#[test]
fn half_integer_powers_share_one_root() {
    let (mut g, _, [x, _]) = letters();
    let cubed = power(&mut g, x, -3, 2);
    assert_eq!(counts(&g, &[cubed]), "1 multiplication, 1 division, 1 square root");
    let (root, inverse) = (power(&mut g, x, 1, 2), power(&mut g, x, -1, 2));
    assert_eq!(counts(&g, &[root, inverse, cubed]), "2 multiplications, 1 division, 1 square root");
    let third = power(&mut g, x, 1, 3);
    assert_eq!(counts(&g, &[third]), "1 function");
}

#[test]
fn signs_cost_nothing() {
    let (mut g, [a, b, c, d], _) = letters();
    let (ab, cd) = (g.multiply(a, b), g.multiply(c, d));
    let difference = g.subtract(ab, cd);
    let opposite = g.negate(difference);
    assert_eq!(counts(&g, &[opposite]), "1 addition, 2 multiplications");
    let minus_product = g.negate(ab);
    assert_eq!(counts(&g, &[minus_product]), "1 multiplication");
}

#[test]
fn equal_coefficients_multiply_once() {
    let (mut g, [a, b, c, d], _) = letters();
    let terms = [(a, 3), (b, -3), (c, 2), (d, 1)].map(|(term, factor)| (term, Number::from(factor)));
    let sum = g.sum(Number::ONE, terms);
    assert_eq!(counts(&g, &[sum]), "4 additions, 2 multiplications");
}

#[test]
fn sines_and_cosines_pair() {
    let (mut g, _, [x, y]) = letters();
    let (sin_x, cos_x) = (apply(&mut g, Function::Sin, &[x]), apply(&mut g, Function::Cos, &[x]));
    let sin_y = apply(&mut g, Function::Sin, &[y]);
    assert_eq!(counts(&g, &[sin_x, cos_x, sin_y]), "1 function, 1 sin_cos");
}

#[test]
fn known_numbers_are_folded() {
    let (mut g, _, [x, _]) = letters();
    let (two, pi) = (g.number(2), g.pi());
    let root = power(&mut g, two, 1, 2);
    let product = g.product([(root, Number::ONE), (pi, Number::ONE), (x, Number::ONE)]);
    let doubled = g.scale(Number::TWO, product);
    assert_eq!(counts(&g, &[doubled]), "1 multiplication");
    assert_eq!(counts(&g, &[pi]), "no operations");
}
