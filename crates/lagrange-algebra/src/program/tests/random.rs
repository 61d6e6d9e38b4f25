//! Programs compute the values of their expressions, for random expressions.

use proptest::prelude::{
    ProptestConfig, Strategy, any, prop, prop_assert, prop_assert_eq, prop_assume, proptest,
};

use super::{letters, lowered};
use crate::program::{Op, Preparation, Variability, optimise, passes, run, schedule, verify};
use lagrange_expr::accuracy::Accuracy;
use lagrange_expr::elementary::ROWS;
use lagrange_expr::expr::evaluate;
use lagrange_expr::expr::{ExprId, Function, Graph, Node, Relation};
use lagrange_expr::functions::apply;
use lagrange_expr::number::Number;
use lagrange_expr::symbol::Role;

/// The next construction step, with indices of earlier expressions.
pub(crate) type Step = (u8, u8, u8, i8);

pub(crate) fn steps() -> impl Strategy<Value = Vec<Step>> {
    prop::collection::vec(any::<Step>(), 1..40)
}

pub(crate) fn build(graph: &mut Graph, leaves: &[ExprId], steps: &[Step]) -> Vec<ExprId> {
    let mut made = leaves.to_vec();
    for &(kind, i, j, n) in steps {
        // Mostly recent expressions are selected, so that the result becomes deep.
        let pick = |k: u8| made[made.len() - 1 - usize::from(k) % made.len().min(8)];
        let (a, b) = (pick(i), pick(j));
        let n = i64::from(n % 5);
        let new = match kind % 8 {
            0 => graph.sum(Number::from(n), [(a, Number::ONE), (b, Number::MINUS_ONE)]),
            1 => graph.sum(Number::ZERO, [(a, Number::from(n)), (b, Number::from(n))]),
            2 | 3 => graph.multiply(a, b),
            4 => graph.divide(a, b),
            5 => graph.power(a, Number::ratio(n, 2).expect("no zero")),
            6 => graph.choose(Relation::LessEqual, a, b, leaves[0], b),
            _ => {
                let row = &ROWS[usize::from(j) % ROWS.len()];
                apply(graph, row.function, &[a, b][..row.arity])
            }
        };
        made.push(new);
    }
    made.split_off(made.len() - 3)
}

pub(crate) fn at(role: Role, shift: f64) -> f64 {
    let value = match role {
        Role::Parameter(i) => 0.6 + 0.3 * f64::from(i),
        Role::Coordinate(i) => 1.1 - 0.45 * f64::from(i),
        _ => f64::NAN,
    };
    value * (1.0 + shift)
}

/// True if two results agree within the conditioning of the formula: `shifted` is the expected
/// result for slightly different symbols.
fn agree(value: f64, expected: f64, shifted: f64) -> bool {
    let tolerance = 1e-9 * (1.0 + expected.abs()) + 1e3 * (shifted - expected).abs();
    value == expected || (value - expected).abs() <= tolerance || !tolerance.is_finite()
}

/// True if a condition compares values that are equal up to rounding, or infinite because of it, or
/// a jumping function is evaluated there. Either branch is then correct.
fn decides_by_rounding(graph: &Graph, outputs: &[ExprId]) -> bool {
    let at = |ids: &[ExprId]| evaluate(graph, ids, |role| at(role, 0.0));
    graph.reachable(outputs).into_iter().any(|id| match graph.node(id) {
        Node::Choose { left, right, .. } => {
            let sides = at(&[*left, *right]);
            let difference = (sides[0] - sides[1]).abs();
            !difference.is_finite() || difference <= 1e-9 * (1.0 + sides[0].abs())
        }
        Node::Call(Function::Sign | Function::MagnitudeSlope | Function::Atan2, arguments) => {
            at(&arguments[..1])[0].abs() <= 1e-9
        }
        _ => false,
    })
}

/// True if two results are the same number, or both NaN.
pub(crate) fn same_bits((a, b): (&f64, &f64)) -> bool {
    a.to_bits() == b.to_bits() || a.is_nan() && b.is_nan()
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 64, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn lowering_and_every_pass_keep_the_values(steps in steps()) {
        let (mut graph, parameters, coordinates) = letters();
        let outputs = build(&mut graph, &[parameters.as_slice(), &coordinates].concat(), &steps);
        prop_assume!(!decides_by_rounding(&graph, &outputs));
        let expected = evaluate(&graph, &outputs, |role| at(role, 0.0));
        let shifted = evaluate(&graph, &outputs, |role| at(role, 1e-12));
        let lowered = lowered(&graph, &outputs);
        let values = run(&lowered, |role| at(role, 0.0));
        for ((value, expected), shifted) in values.iter().zip(&expected).zip(&shifted) {
            prop_assert!(agree(*value, *expected, *shifted), "{value} for {expected}: {lowered:?}");
        }
        for accuracy in Accuracy::ALL {
            let mut program = lowered.clone();
            for pass in passes(accuracy) {
                program = (pass.run)(&program);
                let after = run(&program, |role| at(role, 0.0));
                prop_assert_eq!(verify(&program), Ok(()), "after {}", pass.name);
                // Fused operations and fast sines round differently.
                let exact = cfg!(not(target_feature = "fma")) && accuracy != Accuracy::Fast;
                let same = match exact {
                    true => values.iter().zip(&after).all(same_bits),
                    false => after.iter().zip(&expected).zip(&shifted).all(|((a, b), c)| agree(*a, *b, *c)),
                };
                prop_assert!(same, "after {}: {program:?}", pass.name);
            }
        }
    }

    /// Parameters are 0 to 3; prepared values follow them.
    #[test]
    fn prepared_values_have_the_same_bits_and_leave_the_program(steps in steps()) {
        let (mut graph, parameters, coordinates) = letters();
        let outputs = build(&mut graph, &[parameters.as_slice(), &coordinates].concat(), &steps);
        let program = lowered(&graph, &outputs);
        let mut preparation = Preparation::new(4);
        // A second preparation must find the existing values.
        let [prepared, again] = [(); 2].map(|()| preparation.prepare(&program));
        prop_assert_eq!(&prepared, &again);
        let values = preparation.finish();
        prop_assert_eq!((verify(&prepared), verify(&values)), (Ok(()), Ok(())));
        let values = run(&values, |role| at(role, 0.0));
        let after = run(&prepared, |role| match role {
            Role::Parameter(index @ 4..) => values[index as usize - 4],
            role => at(role, 0.0),
        });
        let before = run(&program, |role| at(role, 0.0));
        prop_assert!(before.iter().zip(&after).all(same_bits), "{program:?} or {prepared:?}");
        let kinds = Variability::of_values(&prepared);
        let is_known = |op: &Op| matches!(op, Op::Input(_) | Op::Constant(_) | Op::Float(_) | Op::Negate(_));
        let is_left = |(id, op): (_, &Op)| kinds[id] == Variability::Constant && !is_known(op);
        prop_assert!(!prepared.values().any(is_left), "{prepared:?}");
    }

    /// `verify` detects operands that are defined after their use.
    #[test]
    fn any_order_of_values_computes_the_same_bits(steps in steps()) {
        let (mut graph, parameters, coordinates) = letters();
        let outputs = build(&mut graph, &[parameters.as_slice(), &coordinates].concat(), &steps);
        for program in [lowered(&graph, &outputs), optimise(&lowered(&graph, &outputs), Accuracy::Standard)] {
            let ordered = schedule(&program);
            prop_assert_eq!(verify(&ordered), Ok(()));
            prop_assert_eq!(ordered.len(), program.len());
            prop_assert_eq!(&schedule(&program), &ordered);
            let [before, after] = [&program, &ordered].map(|program| run(program, |role| at(role, 0.0)));
            prop_assert!(before.iter().zip(&after).all(same_bits), "{program:?} or {ordered:?}");
        }
    }
}
