//! Conditions that every program satisfies. Tests check them after every pass.

use std::fmt;

use super::ir::{Op, Program, ValueId};
use lagrange_expr::collections::HashSet;
use lagrange_expr::elementary::row;

/// The fault in an invalid program.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Fault {
    /// An operand that is not computed before its use.
    UseBeforeDefinition(ValueId),
    /// An output that is not computed.
    MissingOutput(ValueId),
    /// A function with the wrong number of arguments.
    Arity(ValueId),
    /// A part extracted from something other than a pair, or a pair used as a number; the same for
    /// batches.
    Pair(ValueId),
    /// A part extracted from beyond the end of a batch.
    Place(ValueId),
    /// An operation that an earlier value has already done.
    Duplicate(ValueId),
    /// A value that contributes to no output.
    Dead(ValueId),
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Fault::UseBeforeDefinition(id) => write!(f, "{id:?} uses a value that comes later"),
            Fault::MissingOutput(id) => write!(f, "output {id:?} does not exist"),
            Fault::Arity(id) => write!(f, "{id:?} calls with the wrong number of arguments"),
            Fault::Pair(id) => write!(f, "{id:?} takes a number for a pair or a pair for a number"),
            Fault::Place(id) => write!(f, "{id:?} takes what is not in the batch"),
            Fault::Duplicate(id) => write!(f, "{id:?} repeats an earlier operation"),
            Fault::Dead(id) => write!(f, "{id:?} is never used"),
        }
    }
}

impl std::error::Error for Fault {}

/// Checks a program.
///
/// # Errors
/// The first fault found; order and outputs are checked before everything else.
pub fn verify(program: &Program) -> Result<(), Fault> {
    verify_order(program)?;
    verify_operands(program)?;
    verify_distinctness(program)?;
    verify_usefulness(program)
}

fn verify_order(program: &Program) -> Result<(), Fault> {
    for (id, op) in program.values() {
        let mut earlier = true;
        op.for_each_operand(|operand| earlier &= operand < id);
        if !earlier {
            return Err(Fault::UseBeforeDefinition(id));
        }
    }
    match program.outputs().iter().find(|output| output.index() >= program.len()) {
        Some(&output) => Err(Fault::MissingOutput(output)),
        None => Ok(()),
    }
}

fn verify_operands(program: &Program) -> Result<(), Fault> {
    let kind_of = |id| ValueKind::of_result(program.op(id));
    for (id, op) in program.values() {
        let has_arity = match op {
            Op::Call(function, arguments) => arguments.len() == row(*function).arity,
            Op::Opaque(function, arguments) => arguments.len() == function.arity(),
            _ => true,
        };
        if !has_arity {
            return Err(Fault::Arity(id));
        }
        let wanted = ValueKind::of_operands(op);
        let mut right = true;
        op.for_each_operand(|operand| right &= kind_of(operand) == wanted);
        if !right {
            return Err(Fault::Pair(id));
        }
        if let Op::SinIn(batch, place) | Op::CosIn(batch, place) = op
            && let Op::SinCosEach(angles) = program.op(*batch)
            && *place as usize >= angles.len()
        {
            return Err(Fault::Place(id));
        }
    }
    match program.outputs().iter().find(|output| kind_of(**output) != ValueKind::Number) {
        Some(&output) => Err(Fault::Pair(output)),
        None => Ok(()),
    }
}

/// Kind of a value.
#[derive(Clone, Copy, PartialEq, Eq)]
enum ValueKind {
    Number,
    Pair,
    Batch,
}

impl ValueKind {
    fn of_result(op: &Op) -> ValueKind {
        match op {
            Op::SinCos(_) => ValueKind::Pair,
            Op::SinCosEach(_) => ValueKind::Batch,
            _ => ValueKind::Number,
        }
    }

    fn of_operands(op: &Op) -> ValueKind {
        match op {
            Op::SinOf(_) | Op::CosOf(_) => ValueKind::Pair,
            Op::SinIn(..) | Op::CosIn(..) => ValueKind::Batch,
            _ => ValueKind::Number,
        }
    }
}

fn verify_distinctness(program: &Program) -> Result<(), Fault> {
    let mut seen: HashSet<Op> = HashSet::default();
    for (id, op) in program.values() {
        let known = match op {
            Op::SinCosEach(angles) => (1..angles.len()).any(|i| angles[..i].contains(&angles[i])),
            _ => op.commuted().is_some_and(|commuted| seen.contains(&commuted)),
        };
        if known || !seen.insert(op.clone()) {
            return Err(Fault::Duplicate(id));
        }
    }
    Ok(())
}

fn verify_usefulness(program: &Program) -> Result<(), Fault> {
    let uses = program.uses();
    let mut taken: HashSet<(ValueId, u32)> = HashSet::default();
    for (_, op) in program.values() {
        if let Op::SinIn(batch, place) | Op::CosIn(batch, place) = op {
            taken.insert((*batch, *place));
        }
    }
    let is_dead = |(id, op): &(ValueId, &Op)| match op {
        Op::SinCosEach(angles) => (0..angles.len()).any(|place| !taken.contains(&(*id, place as u32))),
        _ => uses[*id] == 0,
    };
    match program.values().find(is_dead) {
        Some((id, _)) => Err(Fault::Dead(id)),
        None => Ok(()),
    }
}
