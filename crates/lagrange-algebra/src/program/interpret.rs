//! Interpreter of programs in double precision.
//!
//! Every operation is performed as in emitted code for `f64` on a platform with the standard
//! library, so both give the same bits.

use super::ir::{Op, Program, ValueId, ValueTable};
use lagrange_expr::collections::HashMap;
use lagrange_expr::elementary::{multiply_add, row};
use lagrange_expr::opaque::Opaque;
use lagrange_expr::symbol::Role;

/// Computes the outputs for the values of symbols that `value_of` returns.
///
/// A selection whose condition compares with NaN is NaN, and so are functions of the user's crate.
pub fn run(program: &Program, value_of: impl Fn(Role) -> f64) -> Vec<f64> {
    run_with(program, value_of, |_, _| vec![f64::NAN])
}

/// Runs a program whose functions without a formula have the values that `call` returns: a single
/// one, or those of all coupled unknowns.
pub fn run_with(
    program: &Program,
    value_of: impl Fn(Role) -> f64,
    call: impl Fn(&Opaque, &[f64]) -> Vec<f64>,
) -> Vec<f64> {
    let mut values: ValueTable<f64> = ValueTable::with_capacity(program.len());
    let mut solved: HashMap<SolutionKey, Vec<f64>> = HashMap::default();
    for (_, op) in program.values() {
        let value = match op {
            Op::Opaque(function, arguments) => {
                let numbers = arguments.iter().map(|argument| values[*argument]).collect::<Vec<_>>();
                let found = || call(function, &numbers);
                function.known_value(&numbers).unwrap_or_else(|| {
                    let all = match solution_key(op) {
                        Some(key) => solved.get_or_insert_with(key, found),
                        None => &mut found(),
                    };
                    all.get(function.place()).copied().unwrap_or(f64::NAN)
                })
            }
            _ => evaluate(program, op, &values, &value_of),
        };
        values.push(value);
    }
    program.outputs().iter().map(|&output| values[output]).collect()
}

/// Coupled unknowns, and the arguments of their equations.
pub(crate) type SolutionKey = (Vec<String>, Box<[ValueId]>);

/// Returns the key that all unknowns of several equations share for the same arguments.
pub(crate) fn solution_key(op: &Op) -> Option<SolutionKey> {
    match op {
        Op::Opaque(function, arguments) if function.unknowns().len() > 1 => {
            Some((function.unknowns().to_vec(), arguments.clone()))
        }
        _ => None,
    }
}

fn evaluate(program: &Program, op: &Op, values: &ValueTable<f64>, value_of: impl Fn(Role) -> f64) -> f64 {
    let at = |id: &ValueId| values[*id];
    match op {
        Op::Input(role) => value_of(*role),
        Op::Constant(value) => value.to_f64(),
        Op::Float(value) => value.value(),
        Op::Add(a, b) => at(a) + at(b),
        Op::Subtract(a, b) => at(a) - at(b),
        Op::Multiply(a, b) => at(a) * at(b),
        Op::Divide(a, b) => at(a) / at(b),
        Op::Negate(a) => -at(a),
        Op::MultiplyAdd(a, b, c) => multiply_add(at(a), at(b), at(c)),
        Op::MultiplySubtract(a, b, c) => multiply_add(at(a), at(b), -at(c)),
        Op::SubtractProduct(a, b, c) => multiply_add(-at(a), at(b), at(c)),
        Op::Power(a, exponent) => integer_power(at(a), *exponent),
        Op::Call(function, arguments) => {
            let arguments = arguments.iter().map(at).collect::<Vec<_>>();
            (row(*function).value)(&arguments)
        }
        // The caller supplies its value.
        Op::Opaque(..) => f64::NAN,
        // A pair is represented by its argument; the sine or cosine is computed where it is
        // extracted.
        Op::SinCos(a) => at(a),
        Op::SinOf(pair) => argument_of(program, *pair, values).sin(),
        Op::CosOf(pair) => argument_of(program, *pair, values).cos(),
        // The same applies to a batch; the results for an angle do not depend on the others.
        Op::SinCosEach(_) => f64::NAN,
        Op::SinIn(batch, place) => in_batch(program, *batch, *place, values).0,
        Op::CosIn(batch, place) => in_batch(program, *batch, *place, values).1,
        Op::Select { relation, left, right, then, otherwise } => match at(left).partial_cmp(&at(right)) {
            None => f64::NAN,
            Some(_) if relation.holds(at(left), at(right)) => at(then),
            Some(_) => at(otherwise),
        },
    }
}

fn argument_of(program: &Program, pair: ValueId, values: &ValueTable<f64>) -> f64 {
    match program.op(pair) {
        Op::SinCos(argument) => values[*argument],
        _ => f64::NAN,
    }
}

fn in_batch(program: &Program, batch: ValueId, place: u32, values: &ValueTable<f64>) -> (f64, f64) {
    let angle = match program.op(batch) {
        Op::SinCosEach(angles) => angles.get(place as usize).map(|angle| values[*angle]),
        _ => None,
    };
    let [pair] = lagrange_math::sin_cos_each([angle.unwrap_or(f64::NAN)]);
    pair
}

/// Computes a power by repeated squaring from the lowest bit of the exponent, like `Scalar::powi`.
pub(crate) fn integer_power(base: f64, exponent: i32) -> f64 {
    let mut product = 1.0;
    let mut square = base;
    let mut remaining = exponent.unsigned_abs();
    while remaining > 0 {
        if remaining % 2 == 1 {
            product *= square;
        }
        remaining /= 2;
        if remaining > 0 {
            square *= square;
        }
    }
    if exponent < 0 { 1.0 / product } else { product }
}
