//! Function calls of the language: elementary functions, rates, vector operations, energies.

use super::expression::Evaluator;
use super::operand::{Operand, cross, half_square, inner, norm};
use super::scope::Kind;
use super::{inertia, messages};
use crate::calculus::evaluate;
use crate::diagnostics::nearest;
use crate::expr::{Dependencies, ExprId};
use crate::functions;
use crate::syntax::ast::{AstId, Expression, Name};
use crate::syntax::{foreign, print};

/// Functions of the language that are no elementary functions, with their number of arguments.
const STRUCTURAL: [(&str, usize); 10] = [
    ("dot", 1),
    ("ddot", 1),
    ("norm", 1),
    ("inner", 2),
    ("cross", 2),
    ("kinetic_energy", 2),
    ("gravitational_energy", 3),
    ("spring_energy", 2),
    ("powi", 2),
    ("powf", 2),
];

/// Whether the language has a function of that name.
pub(super) fn is_function(name: &str) -> bool {
    arity(name).is_some() || inertia::by_name(name).is_some()
}

fn arity(name: &str) -> Option<usize> {
    let elementary = functions::by_name(name).map(|row| row.arity);
    elementary.or_else(|| STRUCTURAL.iter().find(|(known, _)| *known == name).map(|(_, arity)| *arity))
}

/// How a function is called, with the names that its arguments have in textbooks.
fn usage(name: &str, arity: usize) -> String {
    if matches!(name, "powi" | "powf") {
        return format!("x.{name}(n)");
    }
    let arguments = match (name, arity) {
        ("atan2", _) => "y, x",
        ("norm", _) => "v",
        ("inner" | "cross", _) => "v, w",
        ("kinetic_energy", _) => "m, v",
        ("gravitational_energy", _) => "m, g, h",
        ("spring_energy", _) => "k, x",
        (_, 1) => "x",
        _ => "a, b",
    };
    format!("{name}({arguments})")
}

fn function_names() -> impl Iterator<Item = &'static str> {
    let elementary = functions::ROWS.iter().map(|row| row.name);
    elementary.chain(STRUCTURAL.iter().map(|(name, _)| *name)).chain(inertia::function_names())
}

impl Evaluator<'_> {
    pub(super) fn evaluate_call(&mut self, name: &Name, arguments: &[AstId], call: AstId) -> Option<Operand> {
        if let Some(function) = inertia::by_name(&name.text) {
            return self.evaluate_mass_function(function, name, arguments, call);
        }
        let Some(arity) = arity(&name.text) else {
            let is_read = |&id: &AstId| !matches!(self.syntax(id), Expression::Invalid);
            if arguments.iter().all(is_read) {
                self.report_no_function(name, arguments);
            }
            return None;
        };
        if arguments.len() != arity {
            let message = messages::names::wrong_argument_count(&name.text, arity, arguments.len());
            let meant = self.meant_function(&name.text, arguments);
            let help = messages::names::write_call(&meant.unwrap_or_else(|| usage(&name.text, arity)));
            self.report.error(self.origin(call), message).help(help);
            return None;
        }
        match name.text.as_str() {
            "dot" | "ddot" => self.evaluate_rate(&name.text, arguments[0], call),
            "norm" | "inner" | "cross" => self.evaluate_vector_function(&name.text, arguments),
            "kinetic_energy" | "spring_energy" => {
                let weight =
                    self.scalar(arguments[0], &format!("the first argument of `{name}`", name = name.text))?;
                let components = self.value(arguments[1])?;
                if name.text == "kinetic_energy" {
                    self.check_mass(arguments[0], weight)?;
                }
                Some(Operand::Scalar(half_square(&mut self.graph, weight, components.components())))
            }
            _ => self.evaluate_elementary(&name.text, arguments, call),
        }
    }

    /// Reports a mass or moment of inertia that is negative whatever the parameters are.
    fn check_mass(&mut self, syntax: AstId, mass: ExprId) -> Option<()> {
        let is_judged =
            self.graph.dependencies(mass) == Dependencies::NONE && !self.claimed_masses.contains(&syntax);
        if !is_judged || evaluate(&self.graph, &[mass], |_| f64::NAN)[0] >= 0.0 {
            return Some(());
        }
        let error = self.report.error(self.origin(syntax), messages::NEGATIVE_INERTIA);
        error.help(messages::NEGATIVE_INERTIA_HELP);
        None
    }

    /// `dot` or `ddot`. That of what is written without anything that moves is a mistake, not zero.
    fn evaluate_rate(&mut self, function: &str, argument: AstId, call: AstId) -> Option<Operand> {
        let value = self.value(argument)?;
        if self.declaration.expressions.is_written(call) && self.is_at_rest(argument) {
            let text = print::expression(&self.declaration.expressions, argument);
            let error = self.report.error(self.origin(call), messages::rate_of_constant(&text));
            error.help(messages::RATE_OF_CONSTANT_HELP);
            return None;
        }
        let rate = self.rate(&value, argument)?;
        if function == "dot" { Some(rate) } else { self.rate(&rate, argument) }
    }

    /// Whether an expression is made of numbers, constants and parameters, whatever it is worth.
    fn is_at_rest(&self, root: AstId) -> bool {
        let mut pending = vec![root];
        while let Some(id) = pending.pop() {
            match self.syntax(id) {
                Expression::Name(name) => {
                    let entry = self.scope.find(name).filter(|entry| !entry.is_ambiguous);
                    let kind = entry.map(|entry| entry.kind);
                    let is_at_rest = name == "pi" || matches!(kind, Some(Kind::Parameter | Kind::Constant));
                    if !is_at_rest {
                        return false;
                    }
                }
                Expression::Invalid => return false,
                _ => pending.extend(self.operands(id)),
            }
        }
        true
    }

    /// How a call is written that means something in other languages.
    fn meant_function(&self, name: &str, arguments: &[AstId]) -> Option<String> {
        let text = |&id: &AstId| print::expression(&self.declaration.expressions, id);
        foreign::function(name, &arguments.iter().map(text).collect::<Vec<_>>())
    }

    fn report_no_function(&mut self, name: &Name, arguments: &[AstId]) {
        if let Some(entry) = self.scope.resolve(&name.text) {
            let message = messages::names::not_a_function(&name.text, entry.kind.describe());
            let is_time = |&id: &AstId| matches!(self.syntax(id), Expression::Name(t) if t == "t");
            let help = match arguments {
                [argument] if is_time(argument) => messages::names::of_time(&name.text),
                _ => messages::names::PRODUCT_HELP.to_owned(),
            };
            self.report.error(name.span, message).help(help);
            return;
        }
        let help = match (self.meant_function(&name.text, arguments), nearest(&name.text, function_names())) {
            (Some(meant), _) => messages::names::write_call(&meant),
            (None, Some(nearest)) => messages::names::did_you_mean(nearest),
            (None, None) => messages::names::FUNCTIONS_ARE_LISTED.to_owned(),
        };
        self.report.error(name.span, messages::names::unknown_function(&name.text)).help(help);
    }

    fn evaluate_vector_function(&mut self, name: &str, arguments: &[AstId]) -> Option<Operand> {
        let what = format!("an argument of `{name}`");
        let vectors = arguments.iter().map(|&argument| self.vector(argument, &what)).collect::<Vec<_>>();
        let vectors = vectors.into_iter().collect::<Option<Vec<_>>>()?;
        if name == "norm" {
            return Some(Operand::Scalar(norm(&mut self.graph, &vectors[0])));
        }
        if vectors[0].len() != vectors[1].len() {
            let kinds = [0, 1].map(|i| Operand::Vector(vectors[i].clone()).kind());
            let message = messages::kinds_differ(&format!("take `{name}` of"), &kinds[0], &kinds[1]);
            self.report.error(self.origin(arguments[1]), message).help(messages::KINDS_HELP);
            return None;
        }
        Some(match name {
            "inner" => Operand::Scalar(inner(&mut self.graph, &vectors[0], &vectors[1])),
            _ => cross(&mut self.graph, &vectors[0], &vectors[1]),
        })
    }

    fn evaluate_elementary(&mut self, name: &str, arguments: &[AstId], call: AstId) -> Option<Operand> {
        let what = format!("an argument of `{name}`");
        let scalars = arguments.iter().map(|&argument| self.scalar(argument, &what)).collect::<Vec<_>>();
        let scalars = scalars.into_iter().collect::<Option<Vec<_>>>()?;
        Some(Operand::Scalar(match name {
            "gravitational_energy" => self.graph.product(scalars.into_iter().map(|s| (s, 1.into()))),
            "pow" | "powi" | "powf" => self.power(scalars[0], scalars[1], self.origin(call))?,
            _ => functions::apply(&mut self.graph, functions::by_name(name)?.function, &scalars),
        }))
    }
}
