//! What every program satisfies. Tests run this after every pass.

use std::fmt;

use super::ir::{Op, Program, ValueId};
use crate::collections::HashMap;
use crate::functions::row;

/// A program that is none.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Fault {
    /// An operand that is not computed before its use.
    UseBeforeDefinition(ValueId),
    /// An output that is not computed.
    MissingOutput(ValueId),
    /// A function with the wrong number of arguments.
    Arity(ValueId),
    /// A part taken of something that is no pair, or a pair used as a number.
    Pair(ValueId),
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
    let is_pair = |id| matches!(program.op(id), Op::SinCos(_));
    for (id, op) in program.values() {
        if let Op::Call(function, arguments) = op
            && arguments.len() != row(*function).arity
        {
            return Err(Fault::Arity(id));
        }
        let takes_pair = matches!(op, Op::SinOf(_) | Op::CosOf(_));
        let mut right = true;
        op.for_each_operand(|operand| right &= is_pair(operand) == takes_pair);
        if !right {
            return Err(Fault::Pair(id));
        }
    }
    match program.outputs().iter().find(|output| is_pair(**output)) {
        Some(&output) => Err(Fault::Pair(output)),
        None => Ok(()),
    }
}

fn verify_distinctness(program: &Program) -> Result<(), Fault> {
    let mut seen: HashMap<Op, ()> = HashMap::default();
    for (id, op) in program.values() {
        let known = op.commuted().is_some_and(|commuted| seen.contains(&commuted));
        if known || seen.insert(op.clone(), ()).is_some() {
            return Err(Fault::Duplicate(id));
        }
    }
    Ok(())
}

fn verify_usefulness(program: &Program) -> Result<(), Fault> {
    let uses = program.uses();
    match program.values().find(|(id, _)| uses[*id] == 0) {
        Some((id, _)) => Err(Fault::Dead(id)),
        None => Ok(()),
    }
}
