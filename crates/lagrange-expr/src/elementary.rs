//! The elementary functions, one row each.
//!
//! A row holds everything that other modules need about a function. To add a function, add a
//! variant to [`Function`], a row here, and a row to the list `lagrange_math::functions`, which
//! defines the methods of numbers. Derivatives are those of Abramowitz and Stegun, *Handbook of
//! Mathematical Functions*, chapter 4; piecewise functions are differentiated branch by branch.

mod domain;

use Function::{
    Abs, Acos, Asin, Atan, Atan2, Cos, Cosh, Exp, Hypot, Ln, MagnitudeSlope, Max, Min, Power, Sign, Sin,
    Sinh, Sqrt, Tan, Tanh,
};
use Partial::{
    Add, Argument, Call, Constant, Divide, Half, Less, Linear, Multiply, Negate, NotLess, Reciprocal,
    ReciprocalRoot, Square, Value,
};

pub use domain::Domain;

/// An elementary function; its row holds all its properties.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
#[expect(missing_docs, reason = "the names are those of the functions")]
pub enum Function {
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Atan,
    Atan2,
    Sinh,
    Cosh,
    Tanh,
    Exp,
    Ln,
    Sqrt,
    Abs,
    Sign,
    Min,
    Max,
    Power,
    Hypot,
    /// The slope of `abs`: the sign, but with the square one, so that second derivatives of f(|x|)
    /// are correct at 0.
    MagnitudeSlope,
}

/// The behaviour of a function of one argument when the argument changes sign.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Parity {
    /// f(−x) = f(x)
    Even,
    /// f(−x) = −f(x)
    Odd,
    /// Neither of the two, or more than one argument.
    Neither,
}

/// The properties of one function.
#[derive(Debug)]
pub struct Row {
    /// The function.
    pub function: Function,
    /// Its name in the language.
    pub name: &'static str,
    /// The number of arguments.
    pub arity: usize,
    /// Behaviour under a change of sign.
    pub parity: Parity,
    /// Domain.
    pub domain: Domain,
    /// The exact value at zero, if that is a rational number.
    pub at_zero: Option<i64>,
    /// True if no value is below zero.
    pub is_nonnegative: bool,
    /// LaTeX in which `#1` and `#2` stand for the arguments.
    pub latex: &'static str,
    /// The function of `lagrange::Scalar` that computes it.
    pub rust: &'static str,
    /// The value in double precision.
    pub value: fn(&[f64]) -> f64,
    /// Partial derivatives with respect to each argument.
    pub partials: &'static [Partial],
}

impl Row {
    /// Creates the row of a function that is defined everywhere. It has no parity, no rational
    /// value at zero and may be negative. In Rust it has the same name. There is a partial
    /// derivative for each argument.
    const fn new(
        function: Function,
        name: &'static str,
        latex: &'static str,
        value: fn(&[f64]) -> f64,
        partials: &'static [Partial],
    ) -> Self {
        Row {
            function,
            name,
            arity: partials.len(),
            parity: Parity::Neither,
            domain: Domain::Everywhere,
            at_zero: None,
            is_nonnegative: false,
            latex,
            rust: name,
            value,
            partials,
        }
    }

    /// True if it is defined everywhere.
    pub fn is_total(&self) -> bool {
        self.domain == Domain::Everywhere
    }
}

/// A partial derivative, as a formula in the arguments and the value of the function.
#[derive(Debug)]
#[expect(missing_docs, reason = "the names are those of the operations")]
pub enum Partial {
    /// The argument with this index.
    Argument(usize),
    /// The value of the function itself.
    Value,
    Constant(i64),
    Call(Function, &'static [Partial]),
    Negate(&'static Partial),
    Half(&'static Partial),
    Square(&'static Partial),
    Reciprocal(&'static Partial),
    ReciprocalRoot(&'static Partial),
    Add(&'static Partial, &'static Partial),
    Multiply(&'static Partial, &'static Partial),
    Divide(&'static Partial, &'static Partial),
    /// a + b x
    Linear(i64, i64, &'static Partial),
    /// 1 where a < b, 0 elsewhere
    Less(&'static Partial, &'static Partial),
    /// 0 where a < b, 1 elsewhere
    NotLess(&'static Partial, &'static Partial),
}

const X: Partial = Argument(0);
const Y: Partial = Argument(1);
const SQUARED_RADIUS: Partial = Add(&Square(&X), &Square(&Y));

/// Every function, in the order of [`Function`].
pub const ROWS: [Row; 20] = [
    Row {
        parity: Parity::Odd,
        at_zero: Some(0),
        ..Row::new(Sin, "sin", r"\sin\left(#1\right)", |x| x[0].sin(), &[Call(Cos, &[X])])
    },
    Row {
        parity: Parity::Even,
        at_zero: Some(1),
        ..Row::new(Cos, "cos", r"\cos\left(#1\right)", |x| x[0].cos(), &[Negate(&Call(Sin, &[X]))])
    },
    Row {
        parity: Parity::Odd,
        domain: Domain::AwayFrom("odd multiples of π/2"),
        at_zero: Some(0),
        ..Row::new(Tan, "tan", r"\tan\left(#1\right)", |x| x[0].tan(), &[Linear(1, 1, &Square(&Value))])
    },
    Row {
        parity: Parity::Odd,
        domain: Domain::WithinOne,
        at_zero: Some(0),
        ..Row::new(
            Asin,
            "asin",
            r"\arcsin\left(#1\right)",
            |x| x[0].asin(),
            &[ReciprocalRoot(&Linear(1, -1, &Square(&X)))],
        )
    },
    Row {
        domain: Domain::WithinOne,
        ..Row::new(
            Acos,
            "acos",
            r"\arccos\left(#1\right)",
            |x| x[0].acos(),
            &[Negate(&ReciprocalRoot(&Linear(1, -1, &Square(&X))))],
        )
    },
    Row {
        parity: Parity::Odd,
        at_zero: Some(0),
        ..Row::new(
            Atan,
            "atan",
            r"\arctan\left(#1\right)",
            |x| x[0].atan(),
            &[Reciprocal(&Linear(1, 1, &Square(&X)))],
        )
    },
    Row {
        domain: Domain::AwayFrom("the origin"),
        ..Row::new(
            Atan2,
            "atan2",
            r"\operatorname{atan2}\left(#1, #2\right)",
            |x| x[0].atan2(x[1]),
            &[Divide(&Y, &SQUARED_RADIUS), Negate(&Divide(&X, &SQUARED_RADIUS))],
        )
    },
    Row {
        parity: Parity::Odd,
        at_zero: Some(0),
        ..Row::new(Sinh, "sinh", r"\sinh\left(#1\right)", |x| x[0].sinh(), &[Call(Cosh, &[X])])
    },
    Row {
        parity: Parity::Even,
        at_zero: Some(1),
        is_nonnegative: true,
        ..Row::new(Cosh, "cosh", r"\cosh\left(#1\right)", |x| x[0].cosh(), &[Call(Sinh, &[X])])
    },
    Row {
        parity: Parity::Odd,
        at_zero: Some(0),
        ..Row::new(Tanh, "tanh", r"\tanh\left(#1\right)", |x| x[0].tanh(), &[Linear(1, -1, &Square(&Value))])
    },
    Row {
        at_zero: Some(1),
        is_nonnegative: true,
        ..Row::new(Exp, "exp", r"\exp\left(#1\right)", |x| x[0].exp(), &[Value])
    },
    Row {
        domain: Domain::AboveZero,
        ..Row::new(Ln, "ln", r"\ln\left(#1\right)", |x| x[0].ln(), &[Reciprocal(&X)])
    },
    Row {
        domain: Domain::FromZero,
        at_zero: Some(0),
        is_nonnegative: true,
        ..Row::new(Sqrt, "sqrt", r"\sqrt{#1}", |x| x[0].sqrt(), &[Half(&ReciprocalRoot(&X))])
    },
    Row {
        parity: Parity::Even,
        at_zero: Some(0),
        is_nonnegative: true,
        ..Row::new(Abs, "abs", r"\left|#1\right|", |x| x[0].abs(), &[Call(MagnitudeSlope, &[X])])
    },
    Row {
        parity: Parity::Odd,
        at_zero: Some(0),
        ..Row::new(Sign, "sign", r"\operatorname{sign}\left(#1\right)", |x| sign(x[0]), &[Constant(0)])
    },
    // The comparisons are arranged so that NaN in either argument propagates.
    Row::new(
        Min,
        "min",
        r"\min\left(#1, #2\right)",
        |x| if x[0] < x[1] || x[0].is_nan() { x[0] } else { x[1] },
        &[Less(&X, &Y), NotLess(&X, &Y)],
    ),
    Row::new(
        Max,
        "max",
        r"\max\left(#1, #2\right)",
        |x| if x[0] > x[1] || x[0].is_nan() { x[0] } else { x[1] },
        &[Less(&Y, &X), NotLess(&Y, &X)],
    ),
    // Unlike `powf` of the platform, for which 1^NaN and NaN^0 are one.
    Row {
        domain: Domain::BaseAboveZero,
        rust: "powf",
        ..Row::new(
            Power,
            "pow",
            r"{#1}^{#2}",
            |x| if x[0].is_nan() || x[1].is_nan() { f64::NAN } else { x[0].powf(x[1]) },
            &[Multiply(&Y, &Call(Power, &[X, Linear(-1, 1, &Y)])), Multiply(&Value, &Call(Ln, &[X]))],
        )
    },
    Row {
        is_nonnegative: true,
        ..Row::new(
            Hypot,
            "hypot",
            r"\sqrt{\left(#1\right)^{2} + \left(#2\right)^{2}}",
            |x| x[0].hypot(x[1]),
            &[Divide(&X, &Value), Divide(&Y, &Value)],
        )
    },
    // Written as the sign, which has the same value; only products distinguish them.
    Row {
        parity: Parity::Odd,
        at_zero: Some(0),
        ..Row::new(
            MagnitudeSlope,
            "sign",
            r"\operatorname{sign}\left(#1\right)",
            |x| sign(x[0]),
            &[Constant(0)],
        )
    },
];

/// Returns ±1; zero and NaN are their own signs.
fn sign(x: f64) -> f64 {
    if x > 0.0 {
        1.0
    } else if x < 0.0 {
        -1.0
    } else {
        x
    }
}

/// Returns the row of `function`.
pub fn row(function: Function) -> &'static Row {
    &ROWS[function as usize]
}

/// Returns the function of that name in the language.
pub fn by_name(name: &str) -> Option<&'static Row> {
    ROWS.iter().find(|row| row.name == name)
}

/// Returns `a * b + c`, rounded once if emitted code rounds once.
pub fn multiply_add(a: f64, b: f64, c: f64) -> f64 {
    if cfg!(target_feature = "fma") { a.mul_add(b, c) } else { a * b + c }
}
