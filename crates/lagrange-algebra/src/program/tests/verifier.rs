//! The verifier detects planted faults.

use crate::program::ir::Value;
use crate::program::{Fault, Op, Program, ValueId, ValueTable, verify};
use lagrange_expr::expr::Function;
use lagrange_expr::symbol::Role;

const INPUT: Op = Op::Input(Role::Time);

/// Returns a program that no builder would create.
fn planted(ops: impl IntoIterator<Item = Op>, outputs: &[usize]) -> Program {
    let mut values = ValueTable::with_capacity(0);
    for op in ops {
        values.push(Value { op, hint: None });
    }
    Program::from_parts(values, outputs.iter().copied().map(ValueId::new).collect())
}

fn fault(ops: impl IntoIterator<Item = Op>, outputs: &[usize]) -> Option<Fault> {
    verify(&planted(ops, outputs)).err()
}

fn batch(angles: &[usize]) -> Op {
    Op::SinCosEach(angles.iter().copied().map(ValueId::new).collect())
}

#[test]
fn a_sound_program_passes() {
    let v = ValueId::new;
    assert_eq!(fault([INPUT, Op::SinCos(v(0)), Op::SinOf(v(1))], &[2]), None);
    assert_eq!(fault([INPUT, batch(&[0]), Op::CosIn(v(1), 0)], &[2]), None);
}

#[test]
fn faults_are_found() {
    let v = ValueId::new;
    let call = Op::Call(Function::Atan2, Box::new([v(0)]));
    let other = Op::Input(Role::Coordinate(0));
    let (ab, ba) = (Op::Add(v(0), v(1)), Op::Add(v(1), v(0)));
    assert_eq!(fault([Op::Negate(v(1)), INPUT], &[0]), Some(Fault::UseBeforeDefinition(v(0))));
    assert_eq!(fault([Op::Negate(v(0))], &[0]), Some(Fault::UseBeforeDefinition(v(0))));
    assert_eq!(fault([INPUT], &[1]), Some(Fault::MissingOutput(v(1))));
    assert_eq!(fault([INPUT, call], &[1]), Some(Fault::Arity(v(1))));
    assert_eq!(fault([INPUT, Op::SinOf(v(0))], &[1]), Some(Fault::Pair(v(1))));
    assert_eq!(fault([INPUT, Op::SinCos(v(0))], &[1]), Some(Fault::Pair(v(1))));
    assert_eq!(fault([INPUT, Op::SinCos(v(0)), Op::Negate(v(1))], &[2]), Some(Fault::Pair(v(2))));
    assert_eq!(fault([INPUT, Op::SinCos(v(0)), Op::SinIn(v(1), 0)], &[2]), Some(Fault::Pair(v(2))));
    assert_eq!(fault([INPUT, batch(&[0]), Op::SinOf(v(1))], &[2]), Some(Fault::Pair(v(2))));
    assert_eq!(fault([INPUT, batch(&[0]), Op::SinIn(v(1), 1)], &[2]), Some(Fault::Place(v(2))));
    assert_eq!(fault([INPUT, batch(&[0, 0]), Op::SinIn(v(1), 0)], &[2]), Some(Fault::Duplicate(v(1))));
    assert_eq!(
        fault([INPUT, other.clone(), batch(&[0, 1]), Op::SinIn(v(2), 1)], &[3]),
        Some(Fault::Dead(v(2)))
    );
    assert_eq!(fault([INPUT, INPUT], &[0, 1]), Some(Fault::Duplicate(v(1))));
    assert_eq!(fault([INPUT, other, ab, ba], &[2, 3]), Some(Fault::Duplicate(v(3))));
    assert_eq!(fault([INPUT, Op::Negate(v(0))], &[0]), Some(Fault::Dead(v(1))));
}
