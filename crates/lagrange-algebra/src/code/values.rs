//! Writing of values: in place, or as a variable.

use proc_macro2::{Literal, Span, TokenStream};
use quote::{ToTokens, quote_spanned};

use super::body::{FunctionBody, Scalar, Unrepresentable};
use super::fragment::Fragment;
use super::literal::Constant;
use super::pairs::{batch, pair, part};
use super::parts::assemble;
use super::solved::solved;
use super::writer::{BodyWriter, Written};
use crate::program::{Op, Program, ValueId, ValueTable};
use lagrange_expr::elementary::row;
use lagrange_expr::expr::Relation;
use lagrange_expr::symbol::Role;

/// Functions that select without branching, by the relations `<` and `<=`.
pub(super) const SELECTIONS: [&str; 2] = ["if_less", "if_less_equal"];

/// The function for reciprocals that remain in the written order.
pub(super) const RECIPROCAL: &str = "reciprocal";

/// Writes the statements, and an expression for each output.
pub(super) fn write(mut writer: BodyWriter<'_>, used: Vec<Role>) -> Result<FunctionBody, Unrepresentable> {
    let program = writer.program;
    let is_branch = branches(program);
    let mut unrepresentable = Vec::new();
    for (id, op) in program.values() {
        let written = match op {
            Op::Constant(number) => constant(&mut writer, id, Constant::Exact(number), &mut unrepresentable),
            Op::Float(value) => constant(&mut writer, id, Constant::Rounded(*value), &mut unrepresentable),
            _ => value(&mut writer, id, op, is_branch[id]),
        };
        writer.push(id, written);
    }
    let outputs = program.outputs().iter().map(|&output| writer.take(output).tokens).collect();
    if unrepresentable.is_empty() {
        let statements = assemble(program, &writer.statements);
        Ok(FunctionBody { statements, outputs, used, functions: writer.functions })
    } else {
        Err(Unrepresentable { constants: unrepresentable })
    }
}

/// Writes a value that is not a constant; a branch is used only once, in a selection.
fn value(writer: &mut BodyWriter<'_>, id: ValueId, op: &Op, is_branch: bool) -> Written {
    match op {
        Op::Input(role) => Written::Variable(writer.names.role(writer.symbols, *role)),
        Op::SinCos(argument) => pair(writer, id, *argument),
        Op::SinCosEach(arguments) => batch(writer, id, arguments),
        Op::SinOf(pair) => part(writer, *pair, 0, 0),
        Op::CosOf(pair) => part(writer, *pair, 0, 1),
        Op::SinIn(batch, place) => part(writer, *batch, *place, 0),
        Op::CosIn(batch, place) => part(writer, *batch, *place, 1),
        Op::Opaque(function, _) if function.unknowns().len() > 1 => solved(writer, id, function),
        Op::Select { relation, left, right, then, otherwise } if writer.may_branch() => {
            let [left, right] = [*left, *right].map(|operand| writer.take_variable(operand));
            let [then, otherwise] = [*then, *otherwise].map(|operand| writer.take(operand));
            let chosen = selection(writer, *relation, [left, right], [then, otherwise]);
            match is_branch && writer.program.hint(id).is_none() {
                true => Written::Expression(Fragment::block(chosen)),
                false => Written::Variable(writer.bind(id, &chosen)),
            }
        }
        Op::Divide(..) if writer.is_reciprocal[id] => {
            let divisor = writer.operands(op).split_off(1);
            let reciprocal = writer.call(RECIPROCAL, divisor);
            Written::Variable(writer.bind(id, &reciprocal.tokens))
        }
        _ => {
            let expression = expression(writer, op);
            if writer.uses[id] > 1 || writer.program.hint(id).is_some() {
                Written::Variable(writer.bind(id, &expression.tokens))
            } else {
                Written::Expression(expression)
            }
        }
    }
}

/// Writes an arithmetic operation or a call.
fn expression(writer: &mut BodyWriter<'_>, op: &Op) -> Fragment {
    let mut operands = writer.operands(op);
    let mut next = || operands.remove(0);
    match op {
        Op::Add(..) => Fragment::sum(next(), next()),
        Op::Subtract(..) => Fragment::difference(next(), next()),
        Op::Multiply(..) => Fragment::product(next(), next()),
        Op::Divide(..) => Fragment::quotient(next(), next()),
        Op::Negate(_) => next().negated(),
        Op::MultiplyAdd(..) => writer.call("multiply_add", operands),
        Op::MultiplySubtract(..) => {
            let arguments = vec![next(), next(), next().negated()];
            writer.call("multiply_add", arguments)
        }
        Op::SubtractProduct(..) => {
            let arguments = vec![next().negated(), next(), next()];
            writer.call("multiply_add", arguments)
        }
        Op::Power(_, exponent) => {
            let literal = Literal::u32_unsuffixed(exponent.unsigned_abs());
            let magnitude = Fragment::atom(literal.into_token_stream(), 4);
            operands.push(if *exponent < 0 { magnitude.negated() } else { magnitude });
            writer.call("powi", operands)
        }
        Op::Call(function, _) => writer.call(row(*function).rust, operands),
        Op::Select { relation, .. } => {
            let (function, is_swapped) = selection_without_branch(*relation);
            if is_swapped {
                operands.swap(0, 1);
            }
            writer.call(function, operands)
        }
        Op::Opaque(function, _) => writer.call_opaque(function, operands),
        _ => unreachable!("{op:?} is not written as an expression"),
    }
}

fn constant(
    writer: &mut BodyWriter<'_>,
    id: ValueId,
    constant: Constant<'_>,
    unrepresentable: &mut Vec<String>,
) -> Written {
    let text = match writer.scalar {
        Scalar::F32 | Scalar::SideBySide { is_single: true, .. } => constant.single(),
        Scalar::F64 | Scalar::Generic(_) | Scalar::SideBySide { .. } => constant.double(),
    };
    let Some(text) = text else {
        let words = constant.describe();
        if !unrepresentable.contains(&words) {
            unrepresentable.push(words);
        }
        return Written::Expression(Fragment::number("0.0"));
    };
    let number = Fragment::number(&text);
    if matches!(writer.scalar, Scalar::F64 | Scalar::F32) {
        return Written::Expression(number);
    }
    let remainder = constant.remainder().filter(|_| writer.scalar.may_be_wide());
    let converted = match (text.as_str(), remainder) {
        ("0.0", _) => writer.associated("ZERO"),
        ("1.0", None) => writer.associated("ONE"),
        (_, None) => Fragment::call(&writer.associated("from_f64"), vec![number]).free(),
        (_, Some(remainder)) => {
            let parts = vec![number, Fragment::number(&remainder)];
            Fragment::call(&writer.associated("from_sum"), parts).free()
        }
    };
    if writer.uses[id] > 1 {
        Written::Variable(writer.bind(id, &converted.tokens))
    } else {
        Written::Expression(converted)
    }
}

/// Writes a selection. If an operand is NaN, both comparisons fail, and neither branch may be
/// chosen.
fn selection(
    writer: &BodyWriter<'_>,
    relation: Relation,
    sides: [Fragment; 2],
    values: [Fragment; 2],
) -> TokenStream {
    let [left, right] = sides.map(|side| side.tokens);
    let [then, otherwise] = values.map(|value| value.tokens);
    let nan = writer.associated("NAN").tokens;
    let (holds, fails) = match relation {
        Relation::Less => (quote_spanned!(Span::mixed_site()=> <), quote_spanned!(Span::mixed_site()=> >=)),
        Relation::LessEqual => {
            (quote_spanned!(Span::mixed_site()=> <=), quote_spanned!(Span::mixed_site()=> >))
        }
        Relation::Greater => {
            (quote_spanned!(Span::mixed_site()=> >), quote_spanned!(Span::mixed_site()=> <=))
        }
        Relation::GreaterEqual => {
            (quote_spanned!(Span::mixed_site()=> >=), quote_spanned!(Span::mixed_site()=> <))
        }
    };
    quote_spanned! {Span::mixed_site()=>
        if #left #holds #right { #then } else if #left #fails #right { #otherwise } else { #nan }
    }
}

/// Returns the function that selects without branching, and true if the sides of the relation must
/// be exchanged.
fn selection_without_branch(relation: Relation) -> (&'static str, bool) {
    let [less, less_equal] = SELECTIONS;
    match relation {
        Relation::Less => (less, false),
        Relation::LessEqual => (less_equal, false),
        Relation::Greater => (less, true),
        Relation::GreaterEqual => (less_equal, true),
    }
}

/// Finds values that are used once, as a branch of a selection. They are only computed if they are
/// selected.
fn branches(program: &Program) -> ValueTable<bool> {
    let uses = program.uses();
    let mut is_branch = ValueTable::filled(program.len(), false);
    for (_, op) in program.values() {
        if let Op::Select { then, otherwise, .. } = op {
            [*then, *otherwise].into_iter().for_each(|branch| is_branch[branch] = uses[branch] == 1);
        }
    }
    is_branch
}
