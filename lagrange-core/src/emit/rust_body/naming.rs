//! What variables are called.

use proc_macro2::{Ident, Span};

use super::writer::{Writer, Written};
use crate::functions::row;
use crate::number::Number;
use crate::program::{Op, ValueId, Variability};

/// Names made of other names are no longer than this.
const LONGEST_NAME: usize = 28;

impl Writer<'_> {
    /// A variable for a value: its label, or a name that says what it is.
    pub(super) fn choose_name(&mut self, id: ValueId) -> Ident {
        if let Some(hint) = self.program.hint(id) {
            return self.names.fresh(hint);
        }
        let one = Op::Constant(Number::ONE);
        match self.program.op(id) {
            Op::Multiply(a, b) if a == b => match self.name_of(*a) {
                Some(base) => self.names.fresh(&name_of_square(&base)),
                None => self.names.numbered("sq"),
            },
            Op::Divide(a, b) if *self.program.op(*a) == one => {
                let base = self.name_of(*b);
                self.derived_name("inv", base.as_deref(), |base| format!("inv_{base}"))
            }
            Op::Call(function, arguments) if arguments.len() == 1 => {
                let (function, argument) = (row(*function).rust, self.name_of(arguments[0]));
                self.derived_name(function, argument.as_deref(), |argument| format!("{function}_{argument}"))
            }
            Op::Constant(number) if *number == Number::TWO => self.names.fresh("two"),
            Op::Constant(number) if number + number == Number::ONE => self.names.fresh("half"),
            _ => self.names.numbered(stem(self.variability[id])),
        }
    }

    /// A name made from that of an operand, or a numbered one if the operand has none worth repeating.
    fn derived_name(&mut self, stem: &str, base: Option<&str>, make: impl Fn(&str) -> String) -> Ident {
        match base.map(make) {
            Some(name) if name.len() <= LONGEST_NAME => self.names.fresh(&name),
            _ => self.names.numbered(stem),
        }
    }

    /// The variable that a value is in, if it is in one.
    pub(super) fn name_of(&self, id: ValueId) -> Option<String> {
        match &self.written[id] {
            Written::Variable(name) => Some(name.to_string()),
            _ => None,
        }
    }

    /// A variable for the sine or the cosine in a pair.
    pub(super) fn name_part(
        &mut self,
        function: &str,
        part: Option<ValueId>,
        argument: Option<&str>,
    ) -> Ident {
        let Some(part) = part else { return Ident::new("_", Span::mixed_site()) };
        match self.program.hint(part) {
            Some(hint) => self.names.fresh(hint),
            None => self.derived_name(function, argument, |argument| format!("{function}_{argument}")),
        }
    }
}

fn name_of_square(base: &str) -> String {
    match base.strip_suffix("_sq") {
        Some(root) => format!("{root}_pow4"),
        None => format!("{base}_sq"),
    }
}

fn stem(variability: Variability) -> &'static str {
    match variability {
        Variability::Constant => "const",
        Variability::Input => "input",
        Variability::Position => "pos",
        Variability::Velocity => "vel",
        Variability::Acceleration => "acc",
    }
}
