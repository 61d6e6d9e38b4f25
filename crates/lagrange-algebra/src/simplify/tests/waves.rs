//! Sums of products of sines and cosines: contraction, expansion, and common factors.

use proptest::collection::vec;
use proptest::prelude::{ProptestConfig, Strategy, prop, prop_assert, prop_assert_eq, proptest};

use crate::simplify::{Angles, content, contract, count_opened, factors_to_open, open, safe_quotient};
use lagrange_expr::expr::evaluate;
use lagrange_expr::expr::{ExprId, Function, Graph, Node};
use lagrange_expr::functions::apply;
use lagrange_expr::number::Number;
use lagrange_expr::symbol::Role;

/// A term of a sum: its coefficient, its cofactor and the waves in it.
type RandomTerm = (i64, usize, Vec<RandomWave>);
/// Sine or cosine of a combination of three angles.
type RandomWave = (bool, [i64; 3]);

struct Letters {
    masses: [ExprId; 2],
    angles: [ExprId; 3],
}

fn letters(g: &mut Graph) -> Letters {
    Letters {
        masses: [("m", 0), ("n", 1)].map(|(name, index)| g.symbol(name, Role::Parameter(index))),
        angles: [("a", 0), ("b", 1), ("c", 2)].map(|(name, index)| g.symbol(name, Role::Coordinate(index))),
    }
}

fn sin(g: &mut Graph, x: ExprId) -> ExprId {
    apply(g, Function::Sin, &[x])
}

fn cos(g: &mut Graph, x: ExprId) -> ExprId {
    apply(g, Function::Cos, &[x])
}

fn contracted(g: &mut Graph, terms: &[(ExprId, i64)]) -> ExprId {
    let terms = terms.iter().map(|(id, coefficient)| (*id, Number::from(*coefficient))).collect();
    contract(g, &mut Angles::default(), terms)
}

fn count(g: &Graph, id: ExprId) -> usize {
    let (_, core) = g.split_coefficient(id);
    match g.node(core) {
        Node::Number(value) if value.is_zero() => 0,
        Node::Sum { constant, terms } => terms.len() + usize::from(!constant.is_zero()),
        _ => 1,
    }
}

fn value(point: &[f64], role: Role) -> f64 {
    match role {
        Role::Parameter(index) => 0.75 + f64::from(index),
        Role::Coordinate(index) => point[index as usize],
        _ => f64::NAN,
    }
}

fn random_terms() -> impl Strategy<Value = Vec<RandomTerm>> {
    let wave = (prop::bool::ANY, prop::array::uniform3(-2..3_i64));
    vec((-2..3_i64, 0..4_usize, vec(wave, 0..4)), 1..8)
}

/// Returns the distinct terms of a sum, as required before contraction.
fn build(g: &mut Graph, terms: &[RandomTerm]) -> Vec<(ExprId, Number)> {
    let Letters { masses: [m, n], angles } = letters(g);
    let (one, squared, product) = (g.number(1), g.square(m), g.multiply(m, n));
    let cofactors = [one, m, squared, product];
    let terms = terms.iter().map(|(coefficient, cofactor, waves)| {
        let waves = waves.iter().map(|(is_sine, multiples)| {
            let angle = angles.iter().zip(multiples).map(|(angle, k)| (*angle, Number::from(*k)));
            let angle = g.sum(Number::ZERO, angle);
            (if *is_sine { sin(g, angle) } else { cos(g, angle) }, Number::ONE)
        });
        let waves = waves.collect::<Vec<_>>();
        let wave = g.product(waves);
        (g.multiply(cofactors[*cofactor], wave), Number::from(*coefficient))
    });
    let terms = terms.collect::<Vec<_>>();
    let sum = g.sum(Number::ZERO, terms);
    terms_of(g, sum)
}

fn terms_of(g: &mut Graph, sum: ExprId) -> Vec<(ExprId, Number)> {
    match g.node(sum).clone() {
        Node::Sum { constant, terms } => {
            let mut terms = terms.into_vec();
            terms.extend((!constant.is_zero()).then(|| (g.number(1), constant)));
            terms
        }
        _ => vec![(sum, Number::ONE)],
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 256, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn contracting_keeps_the_value_and_never_adds_a_term(
        terms in random_terms(),
        point in prop::array::uniform3(-3.0..3.0_f64),
    ) {
        let mut g = Graph::new();
        let terms = build(&mut g, &terms);
        let before = g.sum(Number::ZERO, terms.clone());
        let after = contract(&mut g, &mut Angles::default(), terms);
        prop_assert!(count(&g, after) <= count(&g, before));
        let values = evaluate(&g, &[before, after], |role| value(&point, role));
        prop_assert!((values[0] - values[1]).abs() < 1e-12, "{values:?}");
    }

    #[test]
    fn contracting_again_changes_nothing(terms in random_terms()) {
        let mut g = Graph::new();
        let mut angles = Angles::default();
        let terms = build(&mut g, &terms);
        let once = contract(&mut g, &mut angles, terms);
        let terms = terms_of(&mut g, once);
        prop_assert_eq!(contract(&mut g, &mut angles, terms), once);
    }

    #[test]
    fn opening_keeps_the_value(terms in random_terms(), point in prop::array::uniform3(-3.0..3.0_f64)) {
        let mut g = Graph::new();
        let terms = build(&mut g, &terms);
        let sum = g.sum(Number::ZERO, terms);
        let Letters { masses: [m, n], .. } = letters(&mut g);
        let total = g.add(m, n);
        let squared = g.square(total);
        let factors = [sum, squared, m].map(|factor| (factor, Number::ONE));
        let product = g.product(factors);
        let opened = open(&mut g, &[(product, Number::ONE)], |_, _| true);
        let opened = opened.expect("few terms");
        prop_assert!(factors_to_open(&g, &opened).is_empty());
        prop_assert!(opened.len() <= count_opened(&g, product));
        let opened = g.sum(Number::ZERO, opened);
        let values = evaluate(&g, &[product, opened], |role| value(&point, role));
        prop_assert!((values[0] - values[1]).abs() < 1e-11 * (1.0 + values[0].abs()), "{values:?}");
    }
}

#[test]
fn angles_are_subtracted_before_their_sine_is_taken() {
    let mut g = Graph::new();
    let Letters { angles: [a, b, _], .. } = letters(&mut g);
    let [sin_a, sin_b] = [a, b].map(|x| sin(&mut g, x));
    let [cos_a, cos_b] = [a, b].map(|x| cos(&mut g, x));
    let (left, right) = (g.multiply(sin_a, cos_b), g.multiply(cos_a, sin_b));
    let difference = g.subtract(a, b);
    let expected = sin(&mut g, difference);
    assert_eq!(contracted(&mut g, &[(left, 1), (right, -1)]), expected);
}

#[test]
fn what_is_left_of_a_mass_is_a_squared_sine() {
    let mut g = Graph::new();
    let Letters { masses: [m, n], angles: [a, ..] } = letters(&mut g);
    let (cos_a, sin_a) = (cos(&mut g, a), sin(&mut g, a));
    let [cos_squared, sin_squared] = [cos_a, sin_a].map(|x| g.square(x));
    let lost = g.multiply(n, cos_squared);
    let left = g.multiply(n, sin_squared);
    let expected = g.add(m, left);
    assert_eq!(contracted(&mut g, &[(m, 1), (n, 1), (lost, -1)]), expected);
}

#[test]
fn one_less_a_cosine_is_a_squared_sine_of_half_the_angle() {
    let mut g = Graph::new();
    let Letters { angles: [a, ..], .. } = letters(&mut g);
    let (one, cos_a) = (g.number(1), cos(&mut g, a));
    let half = g.scale(Number::ratio(1, 2).expect("no zero"), a);
    let sin_half = sin(&mut g, half);
    let squared = g.square(sin_half);
    let expected = g.scale(Number::TWO, squared);
    assert_eq!(contracted(&mut g, &[(one, 1), (cos_a, -1)]), expected);
}

/// cos² a cos² b + cos² a sin² b + sin² a = 1, the length of a direction in space.
#[test]
fn directions_in_space_have_length_one() {
    let mut g = Graph::new();
    let Letters { angles: [a, b, _], .. } = letters(&mut g);
    let [cos_a, cos_b] = [a, b].map(|x| cos(&mut g, x)).map(|x| g.square(x));
    let [sin_a, sin_b] = [a, b].map(|x| sin(&mut g, x)).map(|x| g.square(x));
    let (x, y) = (g.multiply(cos_a, cos_b), g.multiply(cos_a, sin_b));
    let one = g.number(1);
    assert_eq!(contracted(&mut g, &[(x, 1), (y, 1), (sin_a, 1)]), one);
}

/// sin(a − c) − sin(b − c) cos(a − b) = sin(a − b) cos(b − c)
#[test]
fn three_links_contract_as_two_do() {
    let mut g = Graph::new();
    let Letters { angles: [a, b, c], .. } = letters(&mut g);
    let (ac, bc, ab) = (g.subtract(a, c), g.subtract(b, c), g.subtract(a, b));
    let [whole, sin_bc, sin_ab] = [ac, bc, ab].map(|x| sin(&mut g, x));
    let [cos_ab, cos_bc] = [ab, bc].map(|x| cos(&mut g, x));
    let (part, expected) = (g.multiply(sin_bc, cos_ab), g.multiply(sin_ab, cos_bc));
    assert_eq!(contracted(&mut g, &[(whole, 1), (part, -1)]), expected);
}

/// However often and in whichever nesting a difference of angles occurs, it has one sine.
#[test]
fn an_angle_is_written_in_one_way() {
    let mut g = Graph::new();
    let Letters { angles: [a, b, c], .. } = letters(&mut g);
    let ab = g.subtract(a, b);
    let nested = g.add(ab, c);
    let flat = g.sum(Number::ZERO, [(a, 1), (b, -1), (c, 1)].map(|(id, k)| (id, Number::from(k))));
    let mut angles = Angles::default();
    assert_ne!(nested, flat);
    let mut doubled = |g: &mut Graph, angle| {
        let terms = [sin(g, angle), cos(g, angle)].map(|x| g.square(x));
        let terms = terms.into_iter().zip([-1, 1]).map(|(id, k)| (id, Number::from(k)));
        contract(g, &mut angles, terms.collect())
    };
    assert_eq!(doubled(&mut g, nested), doubled(&mut g, flat));
}

#[test]
fn content_times_the_rest_is_what_there_was() {
    let mut g = Graph::new();
    let Letters { masses: [m, n], angles: [a, b, _] } = letters(&mut g);
    let sum = g.add(m, n);
    let [first, second] = [[m, sum, a], [n, sum, b]].map(|f| g.product(f.map(|x| (x, Number::ONE))));
    let forms = [first, second].map(|x| g.scale(Number::from(-3), x));
    let (common, rest) = content(&mut g, &forms);
    let expected = g.scale(Number::from(-3), sum);
    assert_eq!(common, expected);
    for (form, rest) in forms.into_iter().zip(rest) {
        let again = g.multiply(common, rest);
        let difference = g.subtract(again, form);
        let difference = evaluate(&g, &[difference], |role| value(&[0.4, -0.7, 0.0], role));
        assert!(difference[0].abs() < 1e-15);
    }
}

#[test]
fn multiples_of_a_form_are_the_same_form_without_their_content() {
    let mut g = Graph::new();
    let Letters { masses: [m, n], angles: [a, b, c] } = letters(&mut g);
    let form = [a, b].map(|x| g.multiply(m, x));
    let factor = g.multiply(n, c);
    let multiple = form.map(|x| g.multiply(factor, x)).map(|x| g.scale(Number::from(-2), x));
    let [(_, first), (_, second)] = [form, multiple].map(|form| content(&mut g, &form));
    assert_eq!(first, second);
}

#[test]
fn nothing_that_may_vanish_on_the_way_is_divided_by() {
    let mut g = Graph::new();
    let Letters { masses: [m, n], angles: [a, ..] } = letters(&mut g);
    let sine = sin(&mut g, a);
    let (numerator, denominator) = (g.multiply(n, sine), g.multiply(m, sine));
    let expected = g.divide(n, m);
    assert_eq!(safe_quotient(&mut g, numerator, denominator), Some(expected));
    assert_eq!(safe_quotient(&mut g, n, denominator), None);
}

/// Expanded, such powers would exceed the memory.
#[test]
fn powers_without_bound_stay_as_they_are() {
    let mut g = Graph::new();
    let Letters { masses: [m, _], angles: [a, b, _] } = letters(&mut g);
    for exponent in [5, 1_000_000_000, i64::from(i32::MAX), i64::MAX] {
        let (cosine, sine) = (cos(&mut g, a), sin(&mut g, b));
        let (left, right) = (g.power(cosine, exponent.into()), g.power(sine, (exponent - 1).into()));
        let product = g.product([(cosine, exponent.into()), (sine, exponent.into()), (m, Number::ONE)]);
        let terms = [(left, 1), (right, -2), (product, 3)];
        let expected = g.sum(Number::ZERO, terms.map(|(id, coefficient)| (id, Number::from(coefficient))));
        assert_eq!(contracted(&mut g, &terms), expected);
    }
    let squares = [cos(&mut g, a), sin(&mut g, a)].map(|wave| (g.square(wave), 1));
    let one = g.number(1);
    assert_eq!(contracted(&mut g, &squares), one);
}

/// Expanded, the angles have 2⁶⁰ terms.
#[test]
fn sums_that_angles_share_are_read_once() {
    let mut g = Graph::new();
    let Letters { angles: [a, b, _], .. } = letters(&mut g);
    let (mut u, mut v) = (a, b);
    for _ in 0..60 {
        let wave = sin(&mut g, u);
        let terms = |second: i64, third: i64| {
            [(u, Number::ONE), (v, Number::from(second)), (wave, Number::from(third))]
        };
        (u, v) = (g.sum(Number::ZERO, terms(2, 1)), g.sum(Number::ZERO, terms(-3, 5)));
    }
    let [left, right] =
        [(cos(&mut g, u), cos(&mut g, v)), (sin(&mut g, u), sin(&mut g, v))].map(|(x, y)| g.multiply(x, y));
    let difference = g.subtract(u, v);
    let angle = contracted(&mut g, &[(left, 1), (right, 1)]);
    let Node::Call(Function::Cos, argument) = g.node(angle).clone() else { panic!("one cosine is left") };
    let error = g.subtract(argument[0], difference);
    let [value, scale] =
        [error, difference].map(|id| evaluate(&g, &[id], |role| value(&[0.4, -0.7, 0.0], role))[0]);
    assert!(value.abs() < 1e-12 * scale.abs(), "{value} beside {scale}");
}
