//! Names of rates.

use core::fmt::{Display, Formatter, Result};

/// A name with a suffix. For an element of an array, the suffix precedes the square brackets:
/// `theta_dot[2]`.
pub(crate) struct WithSuffix<'a> {
    stem: &'a str,
    suffix: &'static str,
    /// Square brackets and their content.
    brackets: &'a str,
}

impl<'a> WithSuffix<'a> {
    /// Creates the name of the velocity that is the rate of a coordinate.
    pub(crate) fn velocity(coordinate: &'a str) -> WithSuffix<'a> {
        WithSuffix::new(coordinate, "_dot")
    }

    /// Creates the name of the second rate of a coordinate.
    pub(crate) fn acceleration(coordinate: &'a str) -> WithSuffix<'a> {
        WithSuffix::new(coordinate, "_ddot")
    }

    /// Creates the name of the acceleration that is the rate of a velocity with this name.
    pub(crate) fn rate_of(velocity: &'a str) -> WithSuffix<'a> {
        let plain = WithSuffix::new(velocity, "_dot");
        match plain.stem.strip_suffix("_dot") {
            Some(stem) => WithSuffix { stem, suffix: "_ddot", ..plain },
            None => plain,
        }
    }

    fn new(name: &'a str, suffix: &'static str) -> WithSuffix<'a> {
        let (stem, brackets) = split_indices(name);
        WithSuffix { stem, suffix, brackets }
    }
}

/// Splits the square brackets at the end from the name of an element: `leg[0].foot` and `[2]`.
pub(crate) fn split_indices(name: &str) -> (&str, &str) {
    let member = name.rfind('.').unwrap_or(0);
    name.split_at(name[member..].find('[').map_or(name.len(), |bracket| member + bracket))
}

impl Display for WithSuffix<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        write!(f, "{}{}{}", self.stem, self.suffix, self.brackets)
    }
}

#[cfg(all(test, feature = "std"))]
mod tests {
    use std::string::ToString;

    use super::WithSuffix;

    #[test]
    fn suffixes_stand_before_square_brackets() {
        assert_eq!(WithSuffix::velocity("theta").to_string(), "theta_dot");
        assert_eq!(WithSuffix::velocity("u[1][2]").to_string(), "u_dot[1][2]");
        assert_eq!(WithSuffix::velocity("leg[1].knee").to_string(), "leg[1].knee_dot");
        assert_eq!(WithSuffix::velocity("leg[1].toe[0]").to_string(), "leg[1].toe_dot[0]");
        assert_eq!(WithSuffix::acceleration("theta[0]").to_string(), "theta_ddot[0]");
        assert_eq!(WithSuffix::rate_of("theta_dot[0]").to_string(), "theta_ddot[0]");
        assert_eq!(WithSuffix::rate_of("w").to_string(), "w_dot");
    }
}
