//! Functions by name, with bounds on their errors.

use lagrange_math::{Elementary, angles, lengths, power, values};

pub(crate) struct Row {
    pub(crate) name: &'static str,
    /// True if it has two arguments.
    pub(crate) of_two: bool,
    /// Bounds in units in the last place, for normal and for subnormal results.
    pub(crate) bounds: [f64; 2],
    of: fn(bool, [f64; 2]) -> f64,
}

impl Row {
    /// Returns the value with fused or separate products.
    pub(crate) fn value(&self, fused: bool, at: [f64; 2]) -> f64 {
        (self.of)(fused, at)
    }
}

macro_rules! row {
    ($name:literal, $function:ident, $bound:literal) => {
        Row {
            name: $name,
            of_two: false,
            bounds: [$bound, 1.2],
            of: |fused, [x, _]| one(fused, Elementary::$function, x),
        }
    };
}

fn one(fused: bool, function: Elementary, x: f64) -> f64 {
    let [value] = if fused { values::<true, 1>(function, [x]) } else { values::<false, 1>(function, [x]) };
    value
}

pub(crate) const ROWS: [Row; 12] = [
    row!("tan", Tan, 1.0),
    row!("asin", Asin, 0.7),
    row!("acos", Acos, 0.7),
    row!("atan", Atan, 0.7),
    row!("sinh", Sinh, 0.8),
    row!("cosh", Cosh, 0.8),
    row!("tanh", Tanh, 0.8),
    row!("exp", Exp, 0.6),
    row!("ln", Ln, 1.0),
    Row {
        name: "atan2",
        of_two: true,
        bounds: [0.7, 1.2],
        of: |fused, [y, x]| {
            if fused { angles::<true, 1>([y], [x])[0] } else { angles::<false, 1>([y], [x])[0] }
        },
    },
    Row {
        name: "hypot",
        of_two: true,
        bounds: [0.6, 0.6],
        of: |fused, [x, y]| {
            if fused { lengths::<true, 1>([x], [y])[0] } else { lengths::<false, 1>([x], [y])[0] }
        },
    },
    Row { name: "powf", of_two: true, bounds: [1.0, 1.2], of: |_, [x, y]| power(x, y) },
];

/// The functions of one number.
pub(crate) const OF_ONE: [Elementary; 9] = [
    Elementary::Tan,
    Elementary::Asin,
    Elementary::Acos,
    Elementary::Atan,
    Elementary::Sinh,
    Elementary::Cosh,
    Elementary::Tanh,
    Elementary::Exp,
    Elementary::Ln,
];
