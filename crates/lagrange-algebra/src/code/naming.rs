//! Names of variables.

use proc_macro2::{Ident, Span};

use super::names::Names;
use crate::program::{Op, Program, ValueId, ValueTable, Variability};
use lagrange_expr::elementary::row;
use lagrange_expr::number::Number;
use lagrange_expr::opaque::Opaque;
use lagrange_expr::symbol::{Role, Symbols};

/// Maximum length of names composed of other names.
const LONGEST_NAME: usize = 28;
/// Maximum length of names that spell out a product or a sum.
const LONGEST_JOINED_NAME: usize = 20;

/// Names of the variables of one body.
pub(super) struct VariableNames<'a> {
    program: &'a Program,
    names: &'a mut Names,
    variability: ValueTable<Variability>,
    /// Values in variables that are merely numbered.
    is_numbered: ValueTable<bool>,
    /// The variables of values.
    variables: ValueTable<Option<Ident>>,
}

impl<'a> VariableNames<'a> {
    pub(super) fn new(program: &'a Program, names: &'a mut Names) -> VariableNames<'a> {
        VariableNames {
            program,
            names,
            variability: Variability::of_values(program),
            is_numbered: ValueTable::filled(program.len(), false),
            variables: ValueTable::filled(program.len(), None),
        }
    }

    /// Returns the variable of a symbol.
    pub(super) fn role(&mut self, symbols: &Symbols, role: Role) -> Ident {
        self.names.role(symbols, role)
    }

    /// Returns the name of a function of the user's crate, which no variable can have.
    pub(super) fn callee(&self, function: &Opaque) -> Ident {
        self.names.callee(function)
    }

    /// Records the variable of a value.
    pub(super) fn keep(&mut self, id: ValueId, name: &Ident) {
        self.variables[id] = Some(name.clone());
    }

    /// Chooses a variable for a value: its label, or a descriptive name.
    pub(super) fn choose(&mut self, id: ValueId) -> Ident {
        if let Some(hint) = self.program.hint(id) {
            return self.names.fresh(hint);
        }
        let stem = match self.derived_name(id) {
            Some((_, Some(name))) if name.len() <= LONGEST_NAME => {
                let mut of_numbered = false;
                self.program.op(id).for_each_operand(|operand| of_numbered |= self.is_numbered[operand]);
                self.is_numbered[id] = of_numbered;
                return self.names.fresh(&name);
            }
            Some((stem, _)) => stem,
            None => stem(self.variability[id]),
        };
        self.is_numbered[id] = true;
        self.names.numbered(stem)
    }

    /// Returns the stem of a name for a square, a reciprocal or a function, and the name if that of
    /// the operand is known.
    fn derived_name(&self, id: ValueId) -> Option<(&'static str, Option<String>)> {
        match self.program.op(id) {
            Op::Multiply(a, b) if a == b => Some(match self.square_root(*a) {
                Some(root) => ("pow4", Some(format!("{root}_pow4"))),
                None => match self.known_name(*a) {
                    // The square of a name that is already a square would be hard to read.
                    Some(base) if base.ends_with("_sq") => return None,
                    base => ("sq", base.map(|base| format!("{base}_sq"))),
                },
            }),
            Op::Divide(a, b) if *self.program.op(*a) == Op::Constant(Number::ONE) => {
                Some(("inv", self.known_name(*b).map(|base| format!("inv_{base}"))))
            }
            Op::Call(function, arguments) if arguments.len() == 1 => {
                let (function, argument) = (row(*function).rust, self.known_name(arguments[0]));
                Some((function, argument.map(|argument| format!("{function}_{argument}"))))
            }
            Op::Opaque(function, arguments) => {
                let (function, argument) = (function.rust_name(), self.known_name(*arguments.first()?));
                Some(("value", argument.map(|argument| format!("{function}_{argument}"))))
            }
            Op::Multiply(a, b) => self.joined_name(*a, "_", *b).map(|name| ("", Some(name))),
            Op::Add(a, b) => self.joined_name(*a, "_plus_", *b).map(|name| ("", Some(name))),
            Op::Subtract(a, b) => self.joined_name(*a, "_minus_", *b).map(|name| ("", Some(name))),
            Op::Constant(number) if *number == Number::TWO => Some(("two", Some("two".to_owned()))),
            Op::Constant(number) if number + number == Number::ONE => Some(("half", Some("half".to_owned()))),
            _ => None,
        }
    }

    /// Joins the names of two operands with descriptive names, if the result is short.
    fn joined_name(&self, a: ValueId, word: &str, b: ValueId) -> Option<String> {
        let is_sum = |id| matches!(self.program.op(id), Op::Add(..) | Op::Subtract(..));
        if [a, b].into_iter().any(|id| is_sum(id) && self.program.hint(id).is_none()) {
            return None;
        }
        let (a, b) = (self.telling_name(a)?, self.telling_name(b)?);
        let name = format!("{a}{word}{b}");
        (name.len() <= LONGEST_JOINED_NAME).then_some(name)
    }

    /// Returns the name of a variable, unless it is merely numbered.
    fn telling_name(&self, id: ValueId) -> Option<String> {
        match self.program.op(id) {
            Op::Constant(_) | Op::Float(_) => None,
            Op::Multiply(a, b) if a != b && self.name_of(id).is_none() => self.joined_name(*a, "_", *b),
            _ => self.known_name(id).filter(|_| !self.is_numbered[id]),
        }
    }

    /// Returns the name of the base of an unlabelled square.
    fn square_root(&self, id: ValueId) -> Option<String> {
        match self.program.op(id) {
            Op::Multiply(a, b) if a == b && self.program.hint(id).is_none() => self.name_of(*a),
            _ => None,
        }
    }

    /// Returns the variable of a value, or the name of a function call that is written in place.
    /// The size of expressions in place is bounded, and so is the depth of this recursion.
    fn known_name(&self, id: ValueId) -> Option<String> {
        self.name_of(id).or_else(|| match self.program.op(id) {
            Op::Call(..) | Op::Opaque(..) => self.derived_name(id)?.1,
            _ => None,
        })
    }

    /// Returns the variable of an angle, or a name composed from its operands if a sum or product
    /// is written in place.
    pub(super) fn name_of_angle(&self, id: ValueId) -> Option<String> {
        self.name_of(id).or_else(|| match self.program.op(id) {
            Op::Add(..) | Op::Subtract(..) | Op::Multiply(..) => self.derived_name(id)?.1,
            _ => None,
        })
    }

    /// Returns the variable of a value, if it has one.
    pub(super) fn name_of(&self, id: ValueId) -> Option<String> {
        self.variables[id].as_ref().map(ToString::to_string)
    }

    /// Returns a variable for the sine or the cosine in a pair.
    pub(super) fn name_part(
        &mut self,
        function: &str,
        part: Option<ValueId>,
        argument: Option<&str>,
    ) -> Ident {
        let Some(part) = part else { return Ident::new("_", Span::mixed_site()) };
        match (self.program.hint(part), argument) {
            (Some(hint), _) => self.names.fresh(hint),
            (None, Some(name)) if name.len() + 4 <= LONGEST_NAME => {
                self.names.fresh(&format!("{function}_{name}"))
            }
            _ => self.names.numbered(function),
        }
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
