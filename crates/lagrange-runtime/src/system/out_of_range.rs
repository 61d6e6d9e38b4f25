//! Parameters, entries of the state and quantities of contacts outside of their ranges.

use core::fmt::{Debug, Display, Formatter, Result as Written};
use core::ops::{Bound, RangeBounds};

/// The kind of a quantity with a range.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum RangedKind {
    /// A parameter of the system.
    Parameter,
    /// A coordinate or a component of a quaternion.
    Coordinate,
    /// A generalised velocity.
    Velocity,
    /// A first-order or a discrete state.
    State,
    /// A quantity of a contact that depends on parameters, such as its stiffness.
    OfContact,
}

impl Display for RangedKind {
    fn fmt(&self, f: &mut Formatter<'_>) -> Written {
        f.write_str(match self {
            RangedKind::Parameter => "parameter",
            RangedKind::Coordinate => "coordinate",
            RangedKind::Velocity => "velocity",
            RangedKind::State => "state",
            RangedKind::OfContact => "quantity",
        })
    }
}

/// A parameter, an entry of the state, or a quantity of a contact, with a value outside of its
/// range, or NaN.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct OutOfRange<S> {
    /// Its kind.
    pub kind: RangedKind,
    /// Its name; `m[2]` for an element of an array. Words with the name of the contact for a
    /// quantity of a contact.
    pub name: &'static str,
    /// Its value.
    pub value: S,
    /// The bounds of the range.
    pub range: (Bound<S>, Bound<S>),
    /// Unit of the value and the bounds; empty if it is unknown.
    pub unit: &'static str,
}

impl<S: PartialOrd + Copy> OutOfRange<S> {
    /// Checks the value of a quantity of this kind and name.
    ///
    /// # Errors
    ///
    /// If the range does not contain it; no range contains NaN.
    pub fn check(
        kind: RangedKind,
        name: &'static str,
        value: S,
        range: (Bound<S>, Bound<S>),
        unit: &'static str,
    ) -> Result<(), Self> {
        if range.contains(&value) { Ok(()) } else { Err(OutOfRange { kind, name, value, range, unit }) }
    }
}

impl<S: Debug> Display for OutOfRange<S> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Written {
        let OutOfRange { kind, name, value, range, unit } = self;
        let space = if unit.is_empty() { "" } else { " " };
        match kind {
            RangedKind::OfContact => write!(f, "the {name}")?,
            _ => write!(f, "the {kind} `{name}`")?,
        }
        write!(f, " is {value:?}{space}{unit}, but it must be ")?;
        match range {
            (Bound::Included(lower), Bound::Included(upper)) => write!(f, "from {lower:?} to {upper:?}")?,
            (lower, upper) => {
                let both = !matches!((lower, upper), (Bound::Unbounded, _) | (_, Bound::Unbounded));
                bound(lower, ["at least", "greater than"], f)?;
                f.write_str(if both { " and " } else { "" })?;
                bound(upper, ["at most", "less than"], f)?;
            }
        }
        write!(f, "{space}{unit}")
    }
}

/// Writes a bound after the phrase for an inclusive or for an exclusive bound.
fn bound<S: Debug>(
    bound: &Bound<S>,
    [contained, not_contained]: [&str; 2],
    f: &mut Formatter<'_>,
) -> Written {
    match bound {
        Bound::Included(value) => write!(f, "{contained} {value:?}"),
        Bound::Excluded(value) => write!(f, "{not_contained} {value:?}"),
        Bound::Unbounded => Ok(()),
    }
}

impl<S: Debug> core::error::Error for OutOfRange<S> {}

#[cfg(test)]
mod tests {
    use std::format;
    use std::string::{String, ToString};

    use super::*;

    /// Returns the message for NaN, which no range contains.
    fn message(lower: Bound<f64>, upper: Bound<f64>, unit: &'static str) -> String {
        OutOfRange::check(RangedKind::Parameter, "m", f64::NAN, (lower, upper), unit)
            .expect_err("NaN")
            .to_string()
    }

    #[test]
    fn every_kind_of_range_is_put_in_words() {
        use Bound::{Excluded, Included, Unbounded};
        let start = "the parameter `m` is NaN kg, but it must be";
        assert_eq!(message(Excluded(0.0), Unbounded, "kg"), format!("{start} greater than 0.0 kg"));
        assert_eq!(
            message(Included(1.0), Excluded(2.0), "kg"),
            format!("{start} at least 1.0 and less than 2.0 kg")
        );
        assert_eq!(message(Unbounded, Included(-1.0), "kg"), format!("{start} at most -1.0 kg"));
        let plain = "the parameter `m` is NaN, but it must be from 0.0 to 1.0";
        assert_eq!(message(Included(0.0), Included(1.0), ""), plain);
    }

    #[test]
    fn bounds_belong_to_ranges_as_declared() {
        use Bound::{Excluded, Included, Unbounded};
        let is_inside = |value, lower, upper| {
            OutOfRange::check(RangedKind::Parameter, "m", value, (lower, upper), "").is_ok()
        };
        assert!(is_inside(0.0, Included(0.0), Unbounded) && !is_inside(0.0, Excluded(0.0), Unbounded));
        assert!(is_inside(-0.0, Included(0.0), Unbounded));
        assert!(is_inside(1.0, Unbounded, Included(1.0)) && !is_inside(1.0, Unbounded, Excluded(1.0)));
        assert!(is_inside(f64::INFINITY, Excluded(0.0), Unbounded));
    }
}
