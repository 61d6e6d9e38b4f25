//! Base parameters: the combinations that forces determine.

use std::fmt::{Display, Formatter, Result as Written};
use std::vec::Vec;

use crate::linalg::independent::IndependentColumns;
use crate::linalg::singular_values::length;

/// A smaller remainder of a column of length one is rounding.
const DEPENDENT: f64 = 1e-9;
/// Share of a column below which an amount of another is rounding.
const NEGLIGIBLE: f64 = 1e-9;
/// Part of the largest column, or of the largest contribution to forces, below which one is
/// rounding.
const WITHOUT_EFFECT: f64 = 1e-13;

/// A combination of parameters that forces determine: the first parameter plus multiples of others.
#[derive(Clone, PartialEq, Debug)]
pub struct BaseParameter {
    /// Names with factors, the first one with the factor one.
    pub terms: Vec<(&'static str, f64)>,
    /// Indices of the parameters among all.
    pub(super) places: Vec<usize>,
}

impl BaseParameter {
    /// Returns the value for parameters in the order of
    /// [`REGRESSOR_PARAMETERS`](crate::system::RegressorSystem::REGRESSOR_PARAMETERS).
    ///
    /// # Panics
    /// If there are fewer.
    #[must_use]
    pub fn value(&self, parameters: &[f64]) -> f64 {
        self.terms.iter().zip(&self.places).map(|((_, factor), &place)| factor * parameters[place]).sum()
    }
}

/// Returns six digits of a number, which are enough to recognise it. Equal ones look alike, though
/// rounding tells them apart.
pub(super) fn six_digits(number: f64) -> f64 {
    let exact = std::format!("{number:.11e}").parse::<f64>().unwrap_or(number);
    std::format!("{exact:.5e}").parse::<f64>().unwrap_or(exact)
}

impl Display for BaseParameter {
    fn fmt(&self, f: &mut Formatter<'_>) -> Written {
        for (index, (name, factor)) in self.terms.iter().enumerate() {
            let magnitude = factor.abs();
            match (index, *factor < 0.0) {
                (0, false) => {}
                (0, true) => f.write_str("-")?,
                (_, false) => f.write_str(" + ")?,
                (_, true) => f.write_str(" - ")?,
            }
            let rounded = six_digits(magnitude);
            if rounded != 1.0 {
                write!(f, "{rounded} ")?;
            }
            f.write_str(name)?;
        }
        Ok(())
    }
}

/// Combinations of parameters that forces determine.
#[derive(Clone, Debug)]
pub struct BaseParameters {
    parameters: Vec<BaseParameter>,
    without_effect: Vec<&'static str>,
}

impl BaseParameters {
    /// Finds the combinations from the columns of regressors.
    ///
    /// A column has no effect if it is rounding. Columns have different units, so that their
    /// lengths alone do not tell: contributions to forces, columns times parameters, have the same.
    /// A parameter that is zero contributes nothing, and its column is compared by length.
    pub(super) fn of(names: &[&'static str], known: &[f64], columns: &[Vec<f64>]) -> BaseParameters {
        let lengths = columns.iter().map(|column| length(column)).collect::<Vec<_>>();
        let contributions = lengths.iter().zip(known).map(|(length, known)| length * known.abs());
        let contributions = contributions.collect::<Vec<_>>();
        let counts = |sizes: &[f64], place: usize| {
            sizes[place] > WITHOUT_EFFECT * sizes.iter().fold(0.0, |most: f64, size| most.max(*size))
        };
        let is_felt = |place: &usize| counts(&lengths, *place) || counts(&contributions, *place);
        let (mut kept, unfelt): (Vec<_>, Vec<_>) = (0..columns.len()).partition(is_felt);
        kept.sort_by_key(|&place| names[place].ends_with(".mass"));
        let unit = |&place: &usize| columns[place].iter().map(|entry| entry / lengths[place]).collect();
        let factors = IndependentColumns::of(kept.iter().map(unit).collect(), DEPENDENT);
        let alone = |&column: &usize| {
            let place = kept[column];
            BaseParameter { terms: std::vec![(names[place], 1.0)], places: std::vec![place] }
        };
        let mut parameters = factors.independent().iter().map(alone).collect::<Vec<_>>();
        for (column, amounts) in factors.dependent() {
            let place = kept[column];
            for (parameter, amount) in parameters.iter_mut().zip(amounts) {
                if amount.abs() > NEGLIGIBLE {
                    let factor = amount * lengths[place] / lengths[parameter.places[0]];
                    parameter.terms.push((names[place], factor));
                    parameter.places.push(place);
                }
            }
        }
        let without_effect = unfelt.into_iter().map(|place| names[place]).collect();
        BaseParameters { parameters, without_effect }
    }

    /// Returns the combinations that forces determine.
    #[must_use]
    pub fn parameters(&self) -> &[BaseParameter] {
        &self.parameters
    }

    /// Returns the names of parameters without effect on forces.
    #[must_use]
    pub fn without_effect(&self) -> &[&'static str] {
        &self.without_effect
    }
}

impl Display for BaseParameters {
    fn fmt(&self, f: &mut Formatter<'_>) -> Written {
        for parameter in &self.parameters {
            writeln!(f, "{parameter}")?;
        }
        match self.without_effect.is_empty() {
            true => Ok(()),
            false => writeln!(f, "without effect: {}", self.without_effect.join(", ")),
        }
    }
}
