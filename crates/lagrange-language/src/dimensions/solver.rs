//! Equations between dimensions, solved one after the other, with why they hold.

use super::exponents::{Exponents, Unknown};
use crate::syntax::ast::AstId;
use lagrange_expr::diagnostics::Origin;
use lagrange_expr::number::Number;
use lagrange_expr::units::Dimension;

/// Why two dimensions are equal.
#[derive(Clone, Debug)]
pub(super) struct Grounds {
    /// Description of the right side, in words in which `#` stands for its dimension: ``
    /// `potential` adds energies (J) ``.
    pub(super) words: String,
    /// Place of the description.
    pub(super) place: Origin,
}

/// Two dimensions that are equal.
#[derive(Clone, Debug)]
pub(super) struct DimensionEquation {
    /// The dimension of the expression.
    pub(super) found: Exponents,
    /// The dimension that it should have.
    pub(super) expected: Exponents,
    /// The expression, to which mistakes are attributed; `None` where a name is declared.
    pub(super) expression: Option<AstId>,
    pub(super) reason: Grounds,
}

/// An equation that contradicts those before it.
#[derive(Clone, Debug)]
pub(super) struct Contradiction {
    pub(super) equation: DimensionEquation,
    /// Factor missing from the expression.
    pub(super) missing: Dimension,
}

/// A name of which one dimension is to be found.
#[derive(Clone, Debug)]
struct SolvedUnknown {
    /// Dimension in terms of unknowns, some of which may be solved by now.
    form: Exponents,
    /// Number of the equation that says so.
    equation: usize,
}

/// All that is known of dimensions so far.
#[derive(Default)]
pub(super) struct Solver {
    names: Vec<String>,
    solved: Vec<Option<SolvedUnknown>>,
    /// Equations that said something.
    pub(super) equations: Vec<DimensionEquation>,
    pub(super) contradictions: Vec<Contradiction>,
}

impl Solver {
    /// The dimension of another name.
    pub(super) fn unknown(&mut self, name: &str) -> Unknown {
        self.names.push(name.to_owned());
        self.solved.push(None);
        Unknown(self.names.len() - 1)
    }

    pub(super) fn name(&self, unknown: Unknown) -> &str {
        &self.names[unknown.0]
    }

    /// The number of the equation that says what an unknown is.
    pub(super) fn equation_of(&self, unknown: Unknown) -> Option<usize> {
        self.solved[unknown.0].as_ref().map(|solved| solved.equation)
    }

    /// A form in which no unknown is left that has been solved.
    pub(super) fn resolved(&self, form: &Exponents) -> Exponents {
        let mut form = form.clone();
        // The last ones first: what an unknown is made of was not solved when it was.
        while let Some((unknown, solved)) = self.first_solved(&form) {
            let exponent = form.unknowns.remove(&unknown).unwrap_or(Number::ZERO);
            form = form.times_power(&solved, &exponent);
        }
        form
    }

    fn first_solved(&self, form: &Exponents) -> Option<(Unknown, Exponents)> {
        let mut solved = form.unknowns.keys().filter_map(|unknown| {
            let solved = self.solved[unknown.0].as_ref()?;
            Some((*unknown, solved.equation, &solved.form))
        });
        let first = solved.next()?;
        let (unknown, _, form) = solved.fold(first, |a, b| if b.1 < a.1 { b } else { a });
        Some((unknown, form.clone()))
    }

    /// The dimension of a form, if it is known.
    pub(super) fn dimension(&self, form: &Exponents) -> Option<Dimension> {
        let resolved = self.resolved(form);
        resolved.unknowns.is_empty().then_some(resolved.known)
    }

    /// Adds an equation. One that contradicts those before it says nothing and is remembered.
    pub(super) fn equate(&mut self, equation: DimensionEquation) {
        let missing = self.resolved(&equation.expected.over(&equation.found));
        let Some((unknown, exponent)) = missing.unknowns.last_key_value() else {
            if !missing.known.is_none() {
                self.contradictions.push(Contradiction { equation, missing: missing.known });
            }
            return;
        };
        let (unknown, exponent) = (*unknown, exponent.clone());
        let Some(inverse) = exponent.reciprocal() else { return };
        let mut rest = missing;
        rest.unknowns.remove(&unknown);
        let form = rest.power(&-&inverse);
        self.solved[unknown.0] = Some(SolvedUnknown { form, equation: self.equations.len() });
        self.equations.push(equation);
    }
}
