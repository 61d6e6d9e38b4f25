//! The only constructor of programs: it numbers values, folds constants, and omits unused values.
//!
//! Operations on constants become constants: exact rational ones where the result is rational. A
//! division by a rational number becomes a multiplication. Beyond that, it only uses identities
//! that never add an operation. They hold to the last bit, including infinities and NaN but not
//! signs of zero. `0 * x` is therefore kept.

use super::interpret::integer_power;
use super::ir::{Float, Op, Program, Value, ValueId, ValueTable};
use lagrange_expr::collections::OrderedMap;
use lagrange_expr::elementary::row;
use lagrange_expr::expr::Function;
use lagrange_expr::number::Number;

/// A program under construction.
///
/// Pushing an existing operation returns its value, so common subexpressions need no separate pass.
/// Operations on constants return constants.
#[derive(Clone, Default, Debug)]
pub struct Builder {
    values: OrderedMap<Op, Option<Box<str>>>,
}

impl Builder {
    /// Creates a builder of an empty program.
    pub fn new() -> Builder {
        Builder::default()
    }

    /// Pushes an operation and returns its value; operations on constants are folded.
    pub fn push(&mut self, op: Op) -> ValueId {
        match fold(self, op) {
            Ok(known) => known,
            Err(op) => self.number_value(op),
        }
    }

    fn number_value(&mut self, op: Op) -> ValueId {
        if let Some(index) = op.commuted().and_then(|commuted| self.values.index_of(&commuted)) {
            return ValueId::new(index);
        }
        ValueId::new(self.values.index_or_insert_with(op, || None))
    }

    /// Returns the operation behind a value.
    pub fn op(&self, id: ValueId) -> &Op {
        self.values.key_at(id.index())
    }

    /// Pushes an exact number.
    pub fn constant(&mut self, value: Number) -> ValueId {
        self.push(Op::Constant(value))
    }

    /// Returns `a + b`.
    pub fn add(&mut self, a: ValueId, b: ValueId) -> ValueId {
        self.push(Op::Add(a, b))
    }

    /// Returns `a - b`.
    pub fn subtract(&mut self, a: ValueId, b: ValueId) -> ValueId {
        self.push(Op::Subtract(a, b))
    }

    /// Returns `a * b`.
    pub fn multiply(&mut self, a: ValueId, b: ValueId) -> ValueId {
        self.push(Op::Multiply(a, b))
    }

    /// Returns `a / b`.
    pub fn divide(&mut self, a: ValueId, b: ValueId) -> ValueId {
        self.push(Op::Divide(a, b))
    }

    /// Returns `-a`.
    pub fn negate(&mut self, a: ValueId) -> ValueId {
        self.push(Op::Negate(a))
    }

    /// Pushes a call of an elementary function.
    pub fn call(&mut self, function: Function, arguments: &[ValueId]) -> ValueId {
        self.push(Op::Call(function, arguments.into()))
    }

    /// Returns the name that a value has.
    pub fn name(&self, id: ValueId) -> Option<&str> {
        self.values.value_at(id.index()).as_deref()
    }

    /// Proposes a name for a value; the first proposal is used.
    pub fn propose_name(&mut self, id: ValueId, name: &str) {
        let op = self.op(id).clone();
        if let Some(hint @ None) = self.values.get_mut(&op) {
            *hint = Some(name.into());
        }
    }

    /// Finishes the program that computes `outputs`, without the values that do not contribute to
    /// them.
    pub fn finish(self, outputs: &[ValueId]) -> Program {
        let mut needed = ValueTable::filled(self.values.len(), false);
        outputs.iter().for_each(|&output| needed[output] = true);
        for (index, (op, _)) in self.values.iter().enumerate().rev() {
            if needed[ValueId::new(index)] {
                op.for_each_operand(|operand| needed[operand] = true);
            }
        }
        let mut values = ValueTable::with_capacity(self.values.len());
        // Unneeded values have a meaningless entry, which is never read.
        let mut renumbered = ValueTable::with_capacity(self.values.len());
        for (index, (op, hint)) in self.values.iter().enumerate() {
            let id = ValueId::new(index);
            let new = match needed[id] {
                true => {
                    let op = op.map_operands(|operand| renumbered[operand]);
                    values.push(Value { op, hint: hint.clone() })
                }
                false => id,
            };
            renumbered.push(new);
        }
        let outputs = outputs.iter().map(|&output| renumbered[output]).collect();
        Program::from_parts(values, outputs)
    }
}

/// Returns the value that an operation folds to, or the operation to be numbered.
fn fold(builder: &mut Builder, op: Op) -> Result<ValueId, Op> {
    match op {
        Op::Input(_) | Op::Constant(_) | Op::Float(_) => Err(op),
        Op::Negate(a) => fold_negation(builder, a),
        _ => match constant_result(builder, &op) {
            Some(constant) => Ok(builder.push(constant)),
            None => fold_identity(builder, op),
        },
    }
}

fn fold_negation(builder: &mut Builder, a: ValueId) -> Result<ValueId, Op> {
    match builder.op(a).clone() {
        Op::Constant(value) => Ok(builder.constant(-&value)),
        Op::Float(value) => Ok(builder.push(Op::Float(value.negated()))),
        Op::Negate(inner) => Ok(inner),
        _ => Err(Op::Negate(a)),
    }
}

fn fold_identity(builder: &mut Builder, op: Op) -> Result<ValueId, Op> {
    match op {
        Op::Add(a, b) if is_zero(builder, a) => Ok(b),
        Op::Add(a, b) if is_zero(builder, b) => Ok(a),
        Op::Add(a, b) => match (opposite(builder, a), opposite(builder, b)) {
            (_, Some(b)) => Ok(builder.subtract(a, b)),
            (Some(a), None) => Ok(builder.subtract(b, a)),
            (None, None) => Err(op),
        },
        Op::Subtract(a, b) if is_zero(builder, b) => Ok(a),
        Op::Subtract(a, b) if is_zero(builder, a) => Ok(builder.negate(b)),
        Op::Subtract(a, b) => match opposite(builder, b) {
            Some(b) => Ok(builder.add(a, b)),
            None => Err(op),
        },
        Op::Multiply(a, b) => fold_product(builder, a, b),
        Op::Divide(a, b) => fold_quotient(builder, a, b),
        _ => Err(op),
    }
}

fn fold_product(builder: &mut Builder, a: ValueId, b: ValueId) -> Result<ValueId, Op> {
    for (factor, x) in [(a, b), (b, a)] {
        match number(builder, factor) {
            Some(factor) if *factor == Number::ONE => return Ok(x),
            Some(factor) if *factor == Number::MINUS_ONE => return Ok(builder.negate(x)),
            _ => {}
        }
    }
    match (builder.op(a), builder.op(b)) {
        (&Op::Negate(a), &Op::Negate(b)) => Ok(builder.multiply(a, b)),
        _ => Err(Op::Multiply(a, b)),
    }
}

fn fold_quotient(builder: &mut Builder, a: ValueId, b: ValueId) -> Result<ValueId, Op> {
    // The reciprocal adds a rounding, but a division costs several multiplications.
    match number(builder, b).and_then(Number::reciprocal) {
        Some(inverse) => {
            let inverse = builder.constant(inverse);
            Ok(builder.multiply(inverse, a))
        }
        None => Err(Op::Divide(a, b)),
    }
}

fn number(builder: &Builder, id: ValueId) -> Option<&Number> {
    match builder.op(id) {
        Op::Constant(value) => Some(value),
        _ => None,
    }
}

fn is_zero(builder: &Builder, id: ValueId) -> bool {
    number(builder, id).is_some_and(Number::is_zero)
}

/// Returns the opposite of a value with a minus sign.
fn opposite(builder: &mut Builder, id: ValueId) -> Option<ValueId> {
    match builder.op(id) {
        &Op::Negate(inner) => Some(inner),
        Op::Constant(value) if value.is_negative() => Some(builder.negate(id)),
        Op::Float(value) if value.value() < 0.0 => Some(builder.negate(id)),
        _ => None,
    }
}

/// Returns the result of an operation all of whose operands are constants.
fn constant_result(builder: &Builder, op: &Op) -> Option<Op> {
    let mut operands = Vec::new();
    op.for_each_operand(|operand| operands.push(builder.op(operand)));
    if let Some(numbers) = operands.iter().map(|op| exact(op)).collect::<Option<Vec<_>>>()
        && let Some(value) = exact_result(op, &numbers)
    {
        return Some(Op::Constant(value));
    }
    let values = operands.iter().map(|op| approximate(op)).collect::<Option<Vec<_>>>()?;
    let value = approximate_result(op, &values)?;
    let wide = operands.iter().map(|op| wide(op)).collect::<Option<Vec<_>>>();
    let remainder = wide.map_or(0.0, |operands| wide_remainder(op, &operands, value));
    Some(Op::Float(Float::with_remainder(value, remainder)))
}

/// Returns the exact value of a constant with its remainder; `None` if it is not finite.
fn wide(op: &Op) -> Option<Number> {
    match op {
        Op::Constant(value) => Some(value.clone()),
        Op::Float(value) => Some(&Number::from_f64(value.value())? + &Number::from_f64(value.remainder())?),
        _ => None,
    }
}

/// Returns what the approximate result of an operation lacks; zero for functions other than roots.
fn wide_remainder(op: &Op, operands: &[Number], approximate: f64) -> f64 {
    let operands = operands.iter().collect::<Vec<_>>();
    match (op, exact_result(op, &operands)) {
        (_, Some(value)) => remainder(&value, approximate),
        // A step of Newton's method: √x ≈ r + (x − r²) / (2 r).
        (Op::Call(Function::Sqrt, _), None) if approximate > 0.0 => {
            let square = Number::from_f64(approximate).map(|root| &root * &root);
            square.map_or(0.0, |square| (operands[0] - &square).to_f64() / (approximate + approximate))
        }
        _ => 0.0,
    }
}

/// Returns what an approximation of a number lacks; zero if it is not finite.
pub fn remainder(value: &Number, approximation: f64) -> f64 {
    Number::from_f64(approximation).map_or(0.0, |approximation| (value - &approximation).to_f64())
}

fn exact(op: &Op) -> Option<&Number> {
    match op {
        Op::Constant(value) => Some(value),
        _ => None,
    }
}

fn approximate(op: &Op) -> Option<f64> {
    match op {
        Op::Constant(value) => Some(value.to_f64()),
        Op::Float(value) => Some(value.value()),
        _ => None,
    }
}

fn exact_result(op: &Op, operands: &[&Number]) -> Option<Number> {
    match (op, operands) {
        (Op::Add(..), [a, b]) => Some(*a + *b),
        (Op::Subtract(..), [a, b]) => Some(*a - *b),
        (Op::Multiply(..), [a, b]) => Some(*a * *b),
        (Op::Divide(..), [a, b]) => b.reciprocal().map(|inverse| *a * &inverse),
        (Op::Power(_, exponent), [a]) => a.power(*exponent),
        (Op::Call(Function::Sqrt, _), [a]) => a.exact_sqrt(),
        (Op::Call(Function::Abs, _), [a]) => Some(a.abs()),
        _ => None,
    }
}

fn approximate_result(op: &Op, operands: &[f64]) -> Option<f64> {
    match (op, operands) {
        (Op::Add(..), [a, b]) => Some(a + b),
        (Op::Subtract(..), [a, b]) => Some(a - b),
        (Op::Multiply(..), [a, b]) => Some(a * b),
        (Op::Divide(..), [a, b]) => Some(a / b),
        (Op::Power(_, exponent), [a]) => Some(integer_power(*a, *exponent)),
        (Op::Call(function, _), arguments) => Some((row(*function).value)(arguments)),
        _ => None,
    }
}
