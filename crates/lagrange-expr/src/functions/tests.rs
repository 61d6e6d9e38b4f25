use super::{apply, row, sine_of_pi_times};
use crate::elementary::ROWS;
use crate::expr::evaluate;
use crate::expr::{Function, Graph, Node};
use crate::number::Number;
use crate::symbol::Role;

#[test]
fn rows_stand_in_the_order_of_the_functions() {
    for (index, row) in ROWS.iter().enumerate() {
        assert_eq!(row.function as usize, index, "{}", row.name);
    }
}

#[test]
fn signs_come_out_of_odd_functions_and_vanish_in_even_ones() {
    let mut g = Graph::new();
    let x = g.symbol("x", Role::Coordinate(0));
    let opposite = g.negate(x);
    for row in ROWS.iter().filter(|row| row.arity == 1) {
        let (plus, minus) = (apply(&mut g, row.function, &[x]), apply(&mut g, row.function, &[opposite]));
        let expected = match row.parity {
            super::Parity::Even => plus,
            super::Parity::Odd => g.negate(plus),
            super::Parity::Neither => continue,
        };
        assert_eq!(minus, expected, "{}", row.name);
    }
}

#[test]
fn right_angles_come_out_behind_signs() {
    let mut g = Graph::new();
    let x = g.symbol("x", Role::Coordinate(0));
    let (pi, sine) = (g.pi(), apply(&mut g, Function::Sin, &[x]));
    let turned = g.add(x, pi);
    let opposite = g.negate(turned);
    assert_eq!(apply(&mut g, Function::Sin, &[opposite]), sine);
}

#[test]
fn right_angles_come_out_of_sines_and_cosines() {
    let mut g = Graph::new();
    let x = g.symbol("x", Role::Coordinate(0));
    let pi = g.pi();
    for quarters in -7..8 {
        let turn = g.scale(Number::ratio(quarters, 2).expect("a ratio"), pi);
        let turned = g.add(x, turn);
        for function in [Function::Sin, Function::Cos] {
            let value = apply(&mut g, function, &[turned]);
            let (_, call) = g.split_coefficient(value);
            assert!(matches!(g.node(call), Node::Call(_, arguments) if **arguments == [x]));
            let known = evaluate(&g, &[value, turned], |_| 0.7);
            let expected = if function == Function::Sin { known[1].sin() } else { known[1].cos() };
            assert!((known[0] - expected).abs() < 1e-14);
        }
    }
}

#[test]
fn known_values_agree_with_the_numeric_ones() {
    for row in &ROWS {
        if let Some(value) = row.at_zero {
            assert_eq!((row.value)(&[0.0]), value as f64, "{}", row.name);
        }
    }
    for sixths in -20..20 {
        let x = Number::ratio(sixths, 6).expect("no zero");
        let numeric = (std::f64::consts::PI * x.to_f64()).sin();
        if let Some(exact) = sine_of_pi_times(&x) {
            assert!((exact.to_f64() - numeric).abs() < 1e-14, "sin(π·{x})");
        }
    }
}

#[test]
fn not_a_number_comes_through_every_function() {
    for row in &ROWS {
        for position in 0..row.arity {
            for other in [0.0, 0.5, 1.0] {
                let mut arguments = [other; 2];
                arguments[position] = f64::NAN;
                assert!((row.value)(&arguments[..row.arity]).is_nan(), "{}", row.name);
            }
        }
    }
}

#[test]
fn conditions_of_piecewise_functions_meet_at_equal_arguments() {
    assert_eq!((row(Function::Min).value)(&[2.0, 1.0]), 1.0);
    assert_eq!((row(Function::Max).value)(&[2.0, 1.0]), 2.0);
}
