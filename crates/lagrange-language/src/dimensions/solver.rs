//! Equations between dimensions, solved one after the other, with the reasons for them.

use super::exponents::{Exponents, Unknown};
use crate::syntax::ast::AstId;
use lagrange_expr::diagnostics::Origin;
use lagrange_expr::number::Number;
use lagrange_expr::units::Dimension;

/// Reason why two dimensions are equal.
#[derive(Clone, Debug)]
pub(super) struct Grounds {
    /// Description of the right side, where `#` represents its dimension: `` `potential` adds
    /// energies (J) ``.
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
    /// The expression to which errors are attributed; `None` for the declaration of a name.
    pub(super) expression: Option<AstId>,
    pub(super) reason: Grounds,
}

/// An equation that contradicts earlier ones.
#[derive(Clone, Debug)]
pub(super) struct Contradiction {
    pub(super) equation: DimensionEquation,
    /// Factor missing from the expression.
    pub(super) missing: Dimension,
}

/// A name with an inferred dimension.
#[derive(Clone, Debug)]
struct SolvedUnknown {
    /// Dimension in terms of unknowns, some of which may have been solved later.
    form: Exponents,
    /// Index of the equation that determines it.
    equation: usize,
}

/// Everything known about dimensions so far.
#[derive(Default)]
pub(super) struct Solver {
    names: Vec<String>,
    solved: Vec<Option<SolvedUnknown>>,
    /// Equations that provided information.
    pub(super) equations: Vec<DimensionEquation>,
    pub(super) contradictions: Vec<Contradiction>,
}

impl Solver {
    /// Creates an unknown dimension for another name.
    pub(super) fn unknown(&mut self, name: &str) -> Unknown {
        self.names.push(name.to_owned());
        self.solved.push(None);
        Unknown(self.names.len() - 1)
    }

    pub(super) fn name(&self, unknown: Unknown) -> &str {
        &self.names[unknown.0]
    }

    /// Returns the index of the equation that determines an unknown.
    pub(super) fn equation_of(&self, unknown: Unknown) -> Option<usize> {
        self.solved[unknown.0].as_ref().map(|solved| solved.equation)
    }

    /// Returns a form without unknowns that have been solved.
    pub(super) fn resolved(&self, form: &Exponents) -> Exponents {
        let mut form = form.clone();
        // The last ones come first: the unknowns in a solution were unsolved at that time.
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

    /// Returns the dimension of a form, if it is known.
    pub(super) fn dimension(&self, form: &Exponents) -> Option<Dimension> {
        let resolved = self.resolved(form);
        resolved.unknowns.is_empty().then_some(resolved.known)
    }

    /// Adds an equation. An equation that contradicts earlier ones provides no information and is
    /// recorded.
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
