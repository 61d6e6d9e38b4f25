use proptest::collection::vec;
use proptest::prelude::{ProptestConfig, any, prop_assert, prop_assert_eq, proptest};

use crate::calculus::partial;
use crate::simplify::{collect, multiply_out, present, proves_zero, quotient};
use lagrange_expr::expr::evaluate;
use lagrange_expr::expr::{ExprId, Function, Graph, Relation};
use lagrange_expr::functions::apply;
use lagrange_expr::number::Number;
use lagrange_expr::symbol::Role;

const BUDGET: usize = 200;

fn letters(g: &mut Graph) -> [ExprId; 6] {
    let roles = [
        Role::Parameter(0),
        Role::Parameter(1),
        Role::Coordinate(0),
        Role::Coordinate(1),
        Role::Velocity(0),
        Role::Velocity(1),
    ];
    let names = ["m", "l", "q", "r", "q", "r"];
    std::array::from_fn(|i| g.symbol(names[i], roles[i]))
}

fn value(role: Role) -> f64 {
    match role {
        Role::Parameter(index) => 0.75 + f64::from(index) * 0.375,
        Role::Coordinate(index) => 0.6 - f64::from(index) * 1.1,
        _ => -0.8,
    }
}

/// One step of a random construction: an operation and its two operands.
type Step = (u8, u8, u8);

/// Builds expressions with squares, differences, quotients, roots and conditions.
fn build(g: &mut Graph, steps: &[Step]) -> Vec<ExprId> {
    let mut pool = letters(g).to_vec();
    for &(operation, first, second) in steps {
        let pick = |choice: u8| pool[usize::from(choice) % pool.len()];
        let (a, b) = (pick(first), pick(second));
        let new = match operation % 14 {
            0 | 1 => g.add(a, b),
            2 => g.subtract(a, b),
            3 | 4 => g.multiply(a, b),
            5 => g.scale(Number::ratio(i64::from(second % 7) - 3, 2).expect("no zero"), a),
            6 => apply(g, Function::Sin, &[a]),
            7 => apply(g, Function::Cos, &[a]),
            8 => g.square(a),
            9 => {
                let positive = g.square(b);
                let denominator = g.sum(Number::TWO, [(positive, Number::ONE)]);
                g.divide(a, denominator)
            }
            10 => {
                let square = g.square(a);
                let positive = g.sum(Number::ONE, [(square, Number::ONE)]);
                apply(g, Function::Sqrt, &[positive])
            }
            11 => g.choose(Relation::Less, a, b, b, a),
            12 => apply(g, Function::Tanh, &[a]),
            _ => apply(g, if second % 2 == 0 { Function::Sinh } else { Function::Cosh }, &[a]),
        };
        pool.push(new);
    }
    pool.split_off(6)
}

fn agree(a: f64, b: f64) -> bool {
    !a.is_finite() || a.abs() > 1e6 || (a - b).abs() <= 1e-6 * (1.0 + a.abs())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 64, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn presenting_keeps_the_value_and_is_idempotent(steps in vec(any::<Step>(), 1..24)) {
        let mut g = Graph::new();
        for root in build(&mut g, &steps) {
            let readable = present(&mut g, root, BUDGET);
            let values = evaluate(&g, &[root, readable], value);
            prop_assert!(agree(values[0], values[1]), "{values:?}");
            prop_assert_eq!(present(&mut g, readable, BUDGET), readable);
        }
    }

    #[test]
    fn multiplying_out_keeps_the_value(steps in vec(any::<Step>(), 1..24)) {
        let mut g = Graph::new();
        let roots = build(&mut g, &steps);
        let expanded = multiply_out(&mut g, &roots, BUDGET);
        let (before, after) = (evaluate(&g, &roots, value), evaluate(&g, &expanded, value));
        prop_assert!(before.iter().zip(&after).all(|(a, b)| agree(*a, *b)), "{before:?} {after:?}");
    }

    #[test]
    fn quotients_keep_the_value(steps in vec(any::<Step>(), 1..24)) {
        let mut g = Graph::new();
        let roots = build(&mut g, &steps);
        for pair in roots.windows(2) {
            let shared = g.multiply(pair[0], pair[1]);
            for (numerator, denominator) in [(pair[0], pair[1]), (shared, pair[0]), (shared, shared)] {
                let plain = g.divide(numerator, denominator);
                let cancelled = quotient(&mut g, numerator, denominator);
                let values = evaluate(&g, &[plain, cancelled], value);
                prop_assert!(!values[0].is_finite() || agree(values[0], values[1]), "{values:?}");
            }
        }
    }

    #[test]
    fn only_zeros_are_proved_to_be_zero(steps in vec(any::<Step>(), 1..24)) {
        let mut g = Graph::new();
        for root in build(&mut g, &steps) {
            if proves_zero(&mut g, root, BUDGET) {
                prop_assert!(agree(evaluate(&g, &[root], value)[0], 0.0));
            }
        }
    }

    #[test]
    fn collecting_keeps_the_value(steps in vec(any::<Step>(), 1..24)) {
        let mut g = Graph::new();
        let terms = build(&mut g, &steps).into_iter().map(|id| (id, Number::ONE)).collect::<Vec<_>>();
        let plain = g.sum(Number::ZERO, terms.clone());
        let collected = collect(&mut g, terms);
        let values = evaluate(&g, &[plain, collected], value);
        prop_assert!(agree(values[0], values[1]), "{values:?}");
    }
}

#[test]
fn a_spring_keeps_its_difference_when_multiplied_out() {
    let mut g = Graph::new();
    let [stiffness, rest, q, ..] = letters(&mut g);
    let stretch = g.subtract(q, rest);
    let force = g.multiply(stiffness, stretch);
    assert_eq!(multiply_out(&mut g, &[force], BUDGET), [force]);
}

#[test]
fn what_a_coordinate_does_to_itself_cancels_when_multiplied_out() {
    let mut g = Graph::new();
    let [m, l, q, r, _, velocity] = letters(&mut g);
    let [sin, cos] = [Function::Sin, Function::Cos].map(|f| apply(&mut g, f, &[q]));
    let [far_sin, far_cos] = [Function::Sin, Function::Cos].map(|f| apply(&mut g, f, &[r]));
    let v2 = g.square(velocity);
    // cos q·(sin q + sin r)·v² − sin q·(cos q + cos r)·v²
    let sums = [g.add(sin, far_sin), g.add(cos, far_cos)];
    let products = [(cos, sums[0]), (sin, sums[1])].map(|(f, sum)| {
        let factors = [m, l, f, sum, v2].map(|factor| (factor, Number::ONE));
        g.product(factors)
    });
    let force = g.subtract(products[0], products[1]);
    let expanded = multiply_out(&mut g, &[force], BUDGET)[0];
    let values = evaluate(&g, &[force, expanded], value);
    assert!(agree(values[0], values[1]));
    let waves = [g.multiply(cos, far_sin), g.multiply(sin, far_cos)];
    let difference = g.subtract(waves[0], waves[1]);
    let (_, difference) = g.split_coefficient(difference);
    assert!(g.reachable(&[expanded]).contains(&difference), "the sine of the difference is one part");
}

#[test]
fn terms_that_differ_in_parameters_are_put_together() {
    let mut g = Graph::new();
    let [m, l, q, ..] = letters(&mut g);
    let (mq, lq) = (g.multiply(m, q), g.multiply(l, q));
    let sum = g.add(mq, lq);
    let expected = {
        let parameters = g.add(m, l);
        g.multiply(parameters, q)
    };
    assert_eq!(present(&mut g, sum, BUDGET), expected);
}

#[test]
fn arguments_are_presented_too() {
    let mut g = Graph::new();
    let [m, _, q, ..] = letters(&mut g);
    let argument = {
        let [s, c] = [Function::Sin, Function::Cos].map(|f| {
            let call = apply(&mut g, f, &[q]);
            g.product([(m, Number::ONE), (call, Number::TWO)])
        });
        g.add(s, c)
    };
    let root = apply(&mut g, Function::Ln, &[argument]);
    let expected = apply(&mut g, Function::Ln, &[m]);
    assert_eq!(present(&mut g, root, BUDGET), expected);
}

#[test]
fn what_is_short_already_stays() {
    let mut g = Graph::new();
    let [m, l, q, ..] = letters(&mut g);
    let stretch = g.subtract(q, l);
    let root = g.product([(m, Number::ONE), (stretch, Number::TWO)]);
    assert_eq!(present(&mut g, root, BUDGET), root);
}

#[test]
fn what_exceeds_the_budget_stays() {
    let mut g = Graph::new();
    let letters = (0..30).map(|i| g.symbol(&format!("x{i}"), Role::Coordinate(i))).collect::<Vec<_>>();
    let sum = g.total(letters);
    let sin = apply(&mut g, Function::Sin, &[sum]);
    let cube = g.power(sum, Number::from(5));
    let root = g.add(cube, sin);
    assert_eq!(present(&mut g, root, BUDGET), root);
    assert!(!proves_zero(&mut g, root, BUDGET));
}

#[test]
fn a_rotation_leaves_the_distance_unchanged() {
    let mut g = Graph::new();
    let [m, l, q, r, ..] = letters(&mut g);
    let sum = g.add(q, r);
    let position = |g: &mut Graph, f: Function| {
        let (near, far) = (apply(g, f, &[q]), apply(g, f, &[sum]));
        let (near, far) = (g.multiply(m, near), g.multiply(l, far));
        g.add(near, far)
    };
    let (x, y) = (position(&mut g, Function::Sin), position(&mut g, Function::Cos));
    let (x2, y2) = (g.square(x), g.square(y));
    let distance = g.add(x2, y2);
    let cos = apply(&mut g, Function::Cos, &[r]);
    let mixed = g.product([m, l, cos].map(|f| (f, Number::ONE)));
    let (m2, l2) = (g.square(m), g.square(l));
    let law_of_cosines = g.sum(Number::ZERO, [(m2, Number::ONE), (l2, Number::ONE), (mixed, Number::TWO)]);
    let difference = g.subtract(distance, law_of_cosines);
    assert!(!g.is_zero(difference) && proves_zero(&mut g, difference, BUDGET));
    let slope = partial(&mut g, distance, r);
    assert!(!proves_zero(&mut g, slope, BUDGET));
}

#[test]
fn deep_and_doubling_graphs_need_neither_stack_nor_patience() {
    let walk = || {
        let mut g = Graph::new();
        let [_, _, q, r, ..] = letters(&mut g);
        let (mut deep, mut doubled) = (q, r);
        for _ in 0..20_000 {
            deep = apply(&mut g, Function::Sin, &[deep]);
            doubled = g.multiply(doubled, deep);
        }
        let both = g.add(deep, doubled);
        assert!(!proves_zero(&mut g, both, BUDGET));
        let readable = present(&mut g, both, BUDGET);
        assert!(evaluate(&g, &[readable], value)[0].is_finite());
    };
    let small = std::thread::Builder::new().stack_size(256 * 1024);
    small.spawn(walk).expect("a thread").join().expect("no overflow");
}
