//! Function calls of the language: elementary functions, rates, vector operations, energies.

use super::expression::Evaluator;
use super::inertia;
use super::messages;
use super::operand::{Operand, cross, half_square, inner, norm};
use crate::calculus::evaluate;
use crate::diagnostics::nearest;
use crate::expr::{Dependencies, ExprId};
use crate::functions;
use crate::syntax::ast::{AstId, Name};

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
            self.report_no_function(name);
            return None;
        };
        if arguments.len() != arity {
            let message = messages::wrong_argument_count(&name.text, arity, arguments.len());
            self.report
                .error(self.origin(call), message)
                .help(messages::write_call(&usage(&name.text, arity)));
            return None;
        }
        match name.text.as_str() {
            "dot" => self.rate(&self.value(arguments[0])?, arguments[0]),
            "ddot" => {
                let first = self.rate(&self.value(arguments[0])?, arguments[0])?;
                self.rate(&first, arguments[0])
            }
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

    fn report_no_function(&mut self, name: &Name) {
        if let Some(entry) = self.scope.resolve(&name.text) {
            let message = messages::not_a_function(&name.text, entry.kind.describe());
            self.report.error(name.span, message).help(messages::PRODUCT_HELP);
            return;
        }
        let help = match nearest(&name.text, function_names()) {
            Some(nearest) => messages::did_you_mean(nearest),
            None => messages::FUNCTIONS_ARE_LISTED.to_owned(),
        };
        self.report.error(name.span, messages::unknown_function(&name.text)).help(help);
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
            self.report.error(self.origin(arguments[1]), message);
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
