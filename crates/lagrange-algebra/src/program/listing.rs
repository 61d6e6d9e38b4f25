//! A program as text for tests and tools, one value on each line.

use std::fmt::{Display, Formatter, Result};

use super::ir::{Op, Program, ValueId};
use lagrange_expr::elementary::row;
use lagrange_expr::expr::Relation;
use lagrange_expr::symbol::{Role, Symbols};

/// A program with the names of its symbols; displays as lines such as `v7 = v3 * v5 # forcing_0`.
#[derive(Clone, Copy, Debug)]
pub struct Listing<'a> {
    program: &'a Program,
    symbols: &'a Symbols,
}

/// Returns the text of a program whose inputs have their names from `symbols`.
pub fn listing<'a>(program: &'a Program, symbols: &'a Symbols) -> Listing<'a> {
    Listing { program, symbols }
}

impl Display for Listing<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        for (id, op) in self.program.values() {
            let line = format!("{} = {}", name(id), self.operation(op));
            match self.program.hint(id) {
                Some(hint) => writeln!(f, "{line:<40} # {hint}")?,
                None => writeln!(f, "{line}")?,
            }
        }
        let outputs = self.program.outputs().iter().map(|&output| name(output)).collect::<Vec<_>>();
        writeln!(f, "return {}", outputs.join(", "))
    }
}

fn name(id: ValueId) -> String {
    format!("v{}", id.index())
}

impl Listing<'_> {
    fn operation(&self, op: &Op) -> String {
        let mut operands = Vec::new();
        op.for_each_operand(|operand| operands.push(name(operand)));
        match (op, operands.as_slice()) {
            (Op::Input(role), _) => self.symbol(*role),
            (Op::Constant(value), _) => value.to_string(),
            (Op::Float(value), _) => value.value().to_string(),
            (Op::Add(..), [a, b]) => format!("{a} + {b}"),
            (Op::Subtract(..), [a, b]) => format!("{a} - {b}"),
            (Op::Multiply(..), [a, b]) => format!("{a} * {b}"),
            (Op::Divide(..), [a, b]) => format!("{a} / {b}"),
            (Op::Negate(_), [a]) => format!("-{a}"),
            (Op::MultiplyAdd(..), [a, b, c]) => format!("{a} * {b} + {c}"),
            (Op::MultiplySubtract(..), [a, b, c]) => format!("{a} * {b} - {c}"),
            (Op::SubtractProduct(..), [a, b, c]) => format!("{c} - {a} * {b}"),
            (Op::Power(_, exponent), [a]) => format!("{a} ^ {exponent}"),
            (Op::SinCos(_), [a]) => format!("sin_cos({a})"),
            (Op::SinOf(_), [pair]) => format!("{pair}.sin"),
            (Op::CosOf(_), [pair]) => format!("{pair}.cos"),
            (Op::SinCosEach(_), angles) => format!("sin_cos_each({})", angles.join(", ")),
            (Op::SinIn(_, place), [batch]) => format!("{batch}.{place}.sin"),
            (Op::CosIn(_, place), [batch]) => format!("{batch}.{place}.cos"),
            (Op::Select { relation, .. }, [left, right, then, otherwise]) => {
                let relation = Relation::symbol(*relation);
                format!("if {left} {relation} {right} {{ {then} }} else {{ {otherwise} }}")
            }
            (Op::Call(function, _), arguments) => {
                format!("{}({})", row(*function).name, arguments.join(", "))
            }
            (Op::Opaque(function, _), arguments) => format!("{}({})", function.text(), arguments.join(", ")),
            (op, _) => format!("{op:?}"),
        }
    }

    fn symbol(&self, role: Role) -> String {
        self.symbols.find(role).map_or_else(|| "?".to_owned(), |id| self.symbols.get(id).text())
    }
}
