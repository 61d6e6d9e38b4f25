//! The target languages of statements, and their differences.

use crate::code::literal::Constant;

/// The numbers that C computes with.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Precision {
    /// `double`
    Double,
    /// `float`
    Single,
}

/// The language of statements.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Target {
    /// The common subset of C99, OpenCL C 1.2 and CUDA C++.
    C(Precision),
    /// ECMAScript 2015, whose numbers are `f64`.
    JavaScript,
}

impl Target {
    /// Declares an array of numbers that is filled later.
    pub fn array(self, name: &str, length: usize) -> String {
        match self {
            Target::C(_) => format!("REAL {name}[{length}];"),
            Target::JavaScript => format!("const {name} = [];"),
        }
    }

    /// Begins a loop over the indices `i` below a number.
    pub fn repeat(self, count: usize) -> String {
        let kind = if self == Target::JavaScript { "let" } else { "int" };
        format!("for ({kind} i = 0; i < {count}; i++)")
    }

    /// Writes NaN.
    pub fn nan(self) -> &'static str {
        if self == Target::JavaScript { "NaN" } else { "NAN" }
    }

    /// Calls a function of `lagrange::Scalar`.
    pub fn call(self, rust: &str, arguments: &str) -> String {
        let name = match (self, rust) {
            (Target::C(_), _) => format!("LAGRANGE_{}", rust.to_uppercase()),
            // In JavaScript, some powers of NaN are numbers.
            (Target::JavaScript, "powf") => "powf".to_owned(),
            (Target::JavaScript, "ln") => "Math.log".to_owned(),
            (Target::JavaScript, name) => format!("Math.{name}"),
        };
        format!("{name}({arguments})")
    }

    /// Returns the shortest literal of a constant; `None` if it is out of the range of the numbers.
    pub(super) fn constant(self, constant: Constant<'_>) -> Option<String> {
        match self {
            Target::C(Precision::Single) => constant.single().map(|text| format!("{text}f")),
            _ => constant.double(),
        }
    }

    pub(super) fn define(self, variable: &str, expression: &str) -> String {
        match self {
            Target::C(_) => format!("const REAL {variable} = {expression};"),
            Target::JavaScript => format!("const {variable} = {expression};"),
        }
    }

    pub(super) fn sine_and_cosine(self, angle: &str, [sine, cosine]: [&str; 2]) -> String {
        match self {
            Target::C(_) => {
                format!("    REAL {sine}, {cosine};\n    LAGRANGE_SIN_COS({angle}, {sine}, {cosine});\n")
            }
            Target::JavaScript => {
                format!("    const {sine} = Math.sin({angle}), {cosine} = Math.cos({angle});\n")
            }
        }
    }

    pub(super) fn multiply_add(self, [a, b, c]: [&str; 3]) -> String {
        match self {
            Target::C(_) => format!("LAGRANGE_MULTIPLY_ADD({a}, {b}, {c})"),
            Target::JavaScript => format!("{a} * {b} + {c}"),
        }
    }

    pub(super) fn power(self, base: &str, exponent: i32) -> String {
        let name = if self == Target::JavaScript { "powi" } else { "lagrange_powi" };
        format!("{name}({base}, {exponent})")
    }
}
