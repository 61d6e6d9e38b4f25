use super::{ExprId, Function, Graph, Relation};
use crate::number::Number;
use crate::symbol::Role;

fn letters() -> (Graph, [ExprId; 4]) {
    let mut graph = Graph::new();
    let letters = ["a", "b", "c", "d"];
    let ids = std::array::from_fn(|i| graph.symbol(letters[i], Role::Parameter(i as u32)));
    (graph, ids)
}

#[test]
fn equal_terms_are_collected() {
    let (mut g, [a, b, ..]) = letters();
    let twice = g.add(a, a);
    assert_eq!(twice, g.scale(Number::TWO, a));
    let sum = g.add(a, b);
    assert_eq!(sum, g.add(b, a));
    assert_eq!(g.subtract(sum, b), a);
    assert!({
        let zero = g.subtract(a, a);
        g.is_zero(zero)
    });
}

#[test]
fn opposite_and_scaled_sums_share_a_node() {
    let (mut g, [a, b, ..]) = letters();
    let difference = g.subtract(a, b);
    let opposite = g.subtract(b, a);
    assert_eq!(g.split_coefficient(opposite), (Number::MINUS_ONE, difference));
    let scaled = g.sum(Number::ZERO, [(a, Number::from(3)), (b, Number::from(-3))]);
    assert_eq!(g.split_coefficient(scaled), (Number::from(3), difference));
}

#[test]
fn nested_sums_open_only_to_cancel() {
    let (mut g, [a, b, c, d]) = letters();
    let ab = g.add(a, b);
    let abc = g.add(ab, c);
    assert_eq!(g.subtract(abc, ab), c);
    let abd = g.add(ab, d);
    let cd = g.subtract(c, d);
    assert_eq!(g.subtract(abc, abd), cd);
    let a_and_ab = g.add(a, ab);
    assert!(g.reachable(&[a_and_ab]).contains(&ab), "nothing cancels: {ab:?} stays shared");
    let one = g.number(1);
    let shifted = g.add(a, one);
    assert_eq!(g.subtract(shifted, one), a);
}

#[test]
fn equal_bases_are_collected_where_the_domain_allows() {
    let (mut g, [a, b, ..]) = letters();
    let half = Number::ratio(1, 2).expect("no zero");
    let product = g.multiply(a, b);
    assert_eq!(product, g.multiply(b, a));
    assert_eq!(g.divide(product, a), b);
    let square = g.square(a);
    assert_eq!(square, g.multiply(a, a));
    let root = g.power(a, half.clone());
    let root_squared = g.multiply(root, root);
    assert_ne!(root_squared, a, "the root of a negative number is not a number");
    let magnitude = g.power(square, half.clone());
    assert_ne!(magnitude, a);
    assert_eq!(g.multiply(magnitude, magnitude), square, "a square is not negative");
}

#[test]
fn numbers_are_folded_exactly() {
    let (mut g, [a, ..]) = letters();
    let half = Number::ratio(1, 2).expect("no zero");
    let four = g.number(4);
    let root = g.power(four, half.clone());
    assert_eq!(g.as_number(root), Some(&Number::TWO));
    let two = g.number(2);
    let surd = g.power(two, half);
    assert_eq!(g.as_number(surd), None);
    assert_eq!(g.multiply(surd, surd), two);
    let zero = g.number(0);
    assert_eq!(g.multiply(zero, a), zero);
    let pole = g.reciprocal(zero);
    assert_eq!(g.as_number(pole), None, "a division by zero is kept, not hidden");
}

#[test]
fn conditions_between_numbers_are_decided() {
    let (mut g, [a, b, ..]) = letters();
    let (one, two) = (g.number(1), g.number(2));
    assert_eq!(g.choose(Relation::Greater, two, one, a, b), a);
    assert_eq!(g.choose(Relation::LessEqual, two, one, a, b), b);
    assert_eq!(g.choose(Relation::Less, a, b, one, one), one);
    let swapped = g.choose(Relation::Greater, b, a, one, two);
    assert_eq!(g.choose(Relation::Less, a, b, one, two), swapped);
}

#[test]
fn long_products_are_nested() {
    let mut g = Graph::new();
    let factors = (0..100_000).map(|i| g.symbol(&format!("x{i}"), Role::Parameter(i))).collect::<Vec<_>>();
    let product = g.product(factors.iter().map(|&x| (x, Number::ONE)));
    let widest = g.reachable(&[product]).into_iter().map(|id| {
        let mut children = 0;
        g.node(id).for_each_child(|_| children += 1);
        children
    });
    assert_eq!(widest.max(), Some(16));
}

#[test]
fn numbers_fold_where_powers_meet() {
    let (mut g, [a, ..]) = letters();
    let [three, nine] = [3, 9].map(|n| g.number(n));
    let [half, three_halves] = [1, 3].map(|n| Number::ratio(n, 2).expect("no zero"));
    let root = g.power(three, half.clone());
    assert_eq!(g.power(root, Number::from(4)), nine, "(√3)⁴");
    let cube = g.power(three, three_halves);
    assert_eq!(g.multiply(cube, root), nine, "3^(3/2)·√3");
    let product = g.product([root, a, root].map(|factor| (factor, Number::ONE)));
    assert_eq!(product, g.scale(Number::from(3), a), "√3·a·√3");
    let twice = g.scale(Number::TWO, a);
    let root = g.power(twice, half);
    assert_eq!(g.square(root), twice, "(√(2a))²");
}

#[test]
fn sizes_are_compared_without_counting_shared_parts_twice() {
    let (mut g, [a, b, ..]) = letters();
    let mut power = g.add(a, b);
    for _ in 0..60 {
        let next = g.multiply(power, a);
        power = g.add(next, power);
    }
    let size = g.reachable(&[power]).len();
    assert!(g.is_larger_than(power, size - 1));
    assert!(!g.is_larger_than(power, size));
    assert!(g.is_larger_than(a, 0) && !g.is_larger_than(a, 1));
}

#[test]
fn even_powers_of_magnitudes_are_powers() {
    let (mut g, [a, b, c, _]) = letters();
    let half = Number::ratio(1, 2).expect("no zero");
    let [magnitude, other] = [a, b].map(|x| g.call(Function::Abs, &[x]));
    let square = g.square(a);
    assert_eq!(g.square(magnitude), square);
    assert_eq!(g.multiply(magnitude, magnitude), square);
    assert_eq!(g.power(square, half.clone()), magnitude);
    let fourth = g.power(a, Number::from(4));
    assert_eq!(g.power(fourth, half.clone()), square);
    assert_eq!(g.power(magnitude, Number::from(-4)), g.reciprocal(fourth));
    let cube = g.power(magnitude, Number::from(3));
    assert_ne!(cube, g.power(a, Number::from(3)), "odd powers are magnitudes");
    let hypotenuse = g.call(Function::Hypot, &[a, b]);
    let squares = [square, g.square(b)];
    assert_eq!(g.square(hypotenuse), g.total(squares));
    // |a b| |a| = a² |b|, also if the product is nested and has a coefficient.
    let nested = {
        let bc = g.multiply(b, c);
        let product = g.multiply(a, bc);
        g.scale(Number::from(3), product)
    };
    let nested = g.magnitude(nested);
    let found = g.product([(nested, Number::ONE), (magnitude, Number::ONE), (other, Number::ONE)]);
    let rest = g.call(Function::Abs, &[c]);
    let expected = g.product([(a, Number::TWO), (b, Number::TWO), (rest, Number::ONE)]);
    assert_eq!(found, g.scale(Number::from(3), expected));
    // This also holds within another product, and for sums whose coefficients are multiples of each
    // other.
    let inner = g.multiply(magnitude, other);
    let (outer, square_of_b) = (g.multiply(inner, c), g.square(b));
    assert_eq!(
        g.multiply(outer, other),
        g.product([(magnitude, Number::ONE), (square_of_b, Number::ONE), (c, Number::ONE)])
    );
    let [left, right] = [(2, -4), (-3, 6)].map(|(m, n)| {
        let sum = g.sum(Number::ZERO, [(a, Number::from(m)), (b, Number::from(n))]);
        g.magnitude(sum)
    });
    let sum = g.sum(Number::ZERO, [(a, Number::ONE), (b, Number::from(-2))]);
    let expected = g.square(sum);
    assert_eq!(g.multiply(left, right), g.scale(Number::from(6), expected));
    let doubled = g.scale(Number::TWO, square);
    let two = g.number(2);
    let root = g.power(two, half.clone());
    assert_eq!(g.power(doubled, half), g.multiply(root, magnitude));
}

#[test]
fn magnitudes_hold_no_numbers_coefficients_or_products() {
    let (mut g, letters) = letters();
    let minus_two = g.number(-2);
    let two = g.number(2);
    assert_eq!(g.magnitude(minus_two), two);
    // Nested more deeply than products are flattened elsewhere.
    let mut nested = letters[0];
    let mut expected = vec![(g.call(Function::Abs, &[nested]), Number::ONE)];
    for k in 1..12_i64 {
        let factor = g.sum(Number::from(k), [(letters[1], Number::ratio(7, 2).expect("no zero"))]);
        nested = g.multiply(nested, factor);
        expected.push((g.call(Function::Abs, &[factor]), Number::ONE));
    }
    let expected = g.product(expected);
    assert_eq!(g.magnitude(nested), expected);
}

#[test]
fn powers_of_a_base_are_collected_whatever_their_order() {
    let (mut g, [a, ..]) = letters();
    let quarters = |n: i64| Number::ratio(n, 4).expect("no zero");
    // 1/4 + 3/4 = 1 would drop the condition a ≥ 0; with an additional 7/2, the sum keeps it.
    let kept = g.product([(a, quarters(1)), (a, quarters(3)), (a, quarters(14))]);
    assert_eq!(kept, g.power(a, quarters(18)));
    let [left, right] = [[1, 1, 2], [2, 1, 1]].map(|order| {
        order.into_iter().fold(g.number(1), |product, n| {
            let power = g.power(a, quarters(n));
            g.multiply(product, power)
        })
    });
    assert_eq!(left, right);
    assert_eq!(left, g.product([(a, quarters(2)), (a, quarters(2))]));
}

#[test]
fn slopes_of_a_magnitude_have_the_square_one() {
    let (mut g, [a, b, c, d]) = letters();
    let [slope, other] = [a, b].map(|x| g.call(Function::MagnitudeSlope, &[x]));
    let one = g.number(1);
    assert_eq!(g.square(slope), one);
    let [left, right] = [c, d].map(|x| g.multiply(slope, x));
    assert_eq!(g.multiply(left, right), g.multiply(c, d));
    assert_eq!(g.square(left), g.square(c));
    // This also holds for sums whose terms all contain it.
    let nested = g.multiply(left, b);
    let sum = g.add(nested, right);
    let expected = {
        let product = g.multiply(c, b);
        g.add(product, d)
    };
    assert_eq!(g.multiply(slope, sum), expected);
    let three = g.product([(slope, Number::ONE), (left, Number::ONE), (right, Number::ONE)]);
    assert_eq!(three, g.product([(slope, Number::ONE), (c, Number::ONE), (d, Number::ONE)]));
    assert_ne!(g.multiply(slope, other), one);
    let sign = g.call(Function::Sign, &[a]);
    assert_ne!(g.square(sign), one, "a sign that was written is zero at zero");
}

/// |a| − a is s (a − |a|), and that has the factor again: it is taken out of nothing.
#[test]
fn differences_of_a_number_and_its_magnitude_have_an_end() {
    let (mut g, [a, b, ..]) = letters();
    let magnitude = g.call(Function::Abs, &[a]);
    let slope = g.call(Function::MagnitudeSlope, &[a]);
    let (difference, sum) = (g.subtract(magnitude, a), g.add(magnitude, a));
    let negative = g.subtract(a, magnitude);
    let (square, other) = (g.square(difference), g.square(negative));
    assert_eq!(square, other);
    let product = g.multiply(difference, sum);
    let values = |symbol| if symbol == Role::Parameter(0) { -3.0 } else { 2.0 };
    let found = crate::expr::evaluate(&g, &[square, product], values);
    assert_eq!(found, [36.0, 0.0]);
    // With a term that has only the slope, the extraction ends: s b + a = s (b + |a|).
    let term = g.multiply(slope, b);
    let mixed = g.add(term, a);
    let expected = g.add(b, magnitude);
    assert_eq!(g.multiply(slope, mixed), expected);
}

/// A root is real from zero upwards, odd roots included.
#[test]
fn roots_of_odd_powers_keep_their_domain() {
    let (mut g, [a, ..]) = letters();
    let [third, fifth] = [3, 5].map(|n| Number::ratio(1, n).expect("no zero"));
    let cube = g.power(a, Number::from(3));
    assert_ne!(g.power(cube, third.clone()), a);
    assert_eq!(g.power(cube, fifth), g.power(a, Number::ratio(3, 5).expect("no zero")));
    let two_thirds = g.power(a, Number::ratio(2, 3).expect("no zero"));
    assert_ne!(g.power(two_thirds, Number::ratio(3, 2).expect("no zero")), a);
    let magnitude = g.call(Function::Abs, &[a]);
    let cube = g.power(magnitude, Number::from(3));
    assert_eq!(g.power(cube, third), magnitude, "a magnitude is not negative");
}
