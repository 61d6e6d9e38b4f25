//! Kinds of values, which determine the order of their coefficients in each step.

use std::fmt;

use crate::program::{Op, Program, ValueId, ValueTable};
use lagrange_expr::expr::Function;
use lagrange_expr::opaque::Opaque;
use lagrange_expr::symbol::Role;

/// The behaviour of a value while a motion is expanded.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(super) enum Kind {
    /// Constant near the moment of the expansion.
    Fixed,
    /// Determined by time, positions and velocities: step k gives the coefficient of order k + 1.
    Moving,
    /// Depends on accelerations, multipliers or rates of velocities: step k gives the coefficient
    /// of order k.
    Accelerated,
    /// Without a series.
    Unknown,
}

/// A value without a Taylor series.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum NoSeries {
    /// A function without a formula.
    Function(String),
    /// A value that is not linear in accelerations.
    Acceleration,
}

impl fmt::Display for NoSeries {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            NoSeries::Function(name) => write!(f, "`{name}` has no formula"),
            NoSeries::Acceleration => write!(f, "a term is not linear in accelerations"),
        }
    }
}

impl std::error::Error for NoSeries {}

/// Returns the kind of every value of a program.
pub(super) fn kinds(program: &Program) -> ValueTable<Kind> {
    let mut kinds = ValueTable::with_capacity(program.len());
    for (_, op) in program.values() {
        let kind = kind(op, &kinds);
        kinds.push(kind);
    }
    kinds
}

fn kind(op: &Op, kinds: &ValueTable<Kind>) -> Kind {
    let mut strongest = Kind::Fixed;
    op.for_each_operand(|operand| strongest = strongest.max(kinds[operand]));
    match op {
        Op::Input(role) => of_role(*role),
        // A jump is never in the interior of a step.
        Op::Call(Function::Sign, _) => Kind::Fixed,
        Op::Select { then, otherwise, .. } => kinds[*then].max(kinds[*otherwise]),
        Op::Multiply(a, b) if kinds[*a].min(kinds[*b]) == Kind::Accelerated => Kind::Unknown,
        Op::Divide(_, b) if kinds[*b] == Kind::Accelerated => Kind::Unknown,
        Op::Opaque(function, _) if is_fixed(function) => Kind::Fixed,
        Op::Opaque(function, _) if !has_series(function) && strongest > Kind::Fixed => Kind::Unknown,
        Op::Power(..) | Op::Call(..) | Op::Opaque(..) if strongest == Kind::Accelerated => Kind::Unknown,
        _ => strongest,
    }
}

/// True for functions known by more than their values: tables and solutions of equations.
pub(super) fn has_series(function: &Opaque) -> bool {
    function.table().is_some() || function.is_solution()
}

/// True for tables that are constant on each of their pieces.
fn is_fixed(function: &Opaque) -> bool {
    function.table().is_some()
        && (0..function.arity()).all(|argument| function.derivative(argument).vanishes())
}

fn of_role(role: Role) -> Kind {
    match role {
        Role::Parameter(_) | Role::Input(_) | Role::Discrete(_) | Role::Side(_) => Kind::Fixed,
        Role::Time | Role::Coordinate(_) | Role::State(_) | Role::Velocity(_) => Kind::Moving,
        Role::Acceleration(_) | Role::Multiplier(_) | Role::Placeholder(_) => Kind::Accelerated,
        Role::Noise(_) | Role::Reaction(_) | Role::Operand(_) => Kind::Unknown,
    }
}

/// Returns the reason why a value has no series, found at the first operand without a series.
pub(super) fn reason(program: &Program, kinds: &ValueTable<Kind>, value: ValueId) -> NoSeries {
    let mut cause = value;
    loop {
        let mut deeper = None;
        program.op(cause).for_each_operand(|operand| {
            if kinds[operand] == Kind::Unknown {
                deeper = deeper.or(Some(operand));
            }
        });
        let Some(operand) = deeper else { break };
        cause = operand;
    }
    match program.op(cause) {
        Op::Opaque(function, _) if !has_series(function) => {
            NoSeries::Function(function.function().name.clone())
        }
        _ => NoSeries::Acceleration,
    }
}
