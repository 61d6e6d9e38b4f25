//! The elementary functions, one row each.
//!
//! A row holds everything that other modules need about a function. To add a function, add a
//! variant to [`Function`], a row here, and a row to the list `lagrange_math::functions`, which
//! defines the methods of numbers. Derivatives are those of Abramowitz and Stegun, *Handbook of
//! Mathematical Functions*, chapter 4; piecewise functions are differentiated branch by branch.

mod domain;

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
        function: Function::Sin,
        name: "sin",
        arity: 1,
        parity: Parity::Odd,
        domain: Domain::Everywhere,
        at_zero: Some(0),
        is_nonnegative: false,
        latex: r"\sin\left(#1\right)",
        rust: "sin",
        value: |x| x[0].sin(),
        partials: &[Call(Function::Cos, &[X])],
    },
    Row {
        function: Function::Cos,
        name: "cos",
        arity: 1,
        parity: Parity::Even,
        domain: Domain::Everywhere,
        at_zero: Some(1),
        is_nonnegative: false,
        latex: r"\cos\left(#1\right)",
        rust: "cos",
        value: |x| x[0].cos(),
        partials: &[Negate(&Call(Function::Sin, &[X]))],
    },
    Row {
        function: Function::Tan,
        name: "tan",
        arity: 1,
        parity: Parity::Odd,
        domain: Domain::AwayFrom("odd multiples of π/2"),
        at_zero: Some(0),
        is_nonnegative: false,
        latex: r"\tan\left(#1\right)",
        rust: "tan",
        value: |x| x[0].tan(),
        partials: &[Linear(1, 1, &Square(&Value))],
    },
    Row {
        function: Function::Asin,
        name: "asin",
        arity: 1,
        parity: Parity::Odd,
        domain: Domain::WithinOne,
        at_zero: Some(0),
        is_nonnegative: false,
        latex: r"\arcsin\left(#1\right)",
        rust: "asin",
        value: |x| x[0].asin(),
        partials: &[ReciprocalRoot(&Linear(1, -1, &Square(&X)))],
    },
    Row {
        function: Function::Acos,
        name: "acos",
        arity: 1,
        parity: Parity::Neither,
        domain: Domain::WithinOne,
        at_zero: None,
        is_nonnegative: false,
        latex: r"\arccos\left(#1\right)",
        rust: "acos",
        value: |x| x[0].acos(),
        partials: &[Negate(&ReciprocalRoot(&Linear(1, -1, &Square(&X))))],
    },
    Row {
        function: Function::Atan,
        name: "atan",
        arity: 1,
        parity: Parity::Odd,
        domain: Domain::Everywhere,
        at_zero: Some(0),
        is_nonnegative: false,
        latex: r"\arctan\left(#1\right)",
        rust: "atan",
        value: |x| x[0].atan(),
        partials: &[Reciprocal(&Linear(1, 1, &Square(&X)))],
    },
    Row {
        function: Function::Atan2,
        name: "atan2",
        arity: 2,
        parity: Parity::Neither,
        domain: Domain::AwayFrom("the origin"),
        at_zero: None,
        is_nonnegative: false,
        latex: r"\operatorname{atan2}\left(#1, #2\right)",
        rust: "atan2",
        value: |x| x[0].atan2(x[1]),
        partials: &[Divide(&Y, &SQUARED_RADIUS), Negate(&Divide(&X, &SQUARED_RADIUS))],
    },
    Row {
        function: Function::Sinh,
        name: "sinh",
        arity: 1,
        parity: Parity::Odd,
        domain: Domain::Everywhere,
        at_zero: Some(0),
        is_nonnegative: false,
        latex: r"\sinh\left(#1\right)",
        rust: "sinh",
        value: |x| x[0].sinh(),
        partials: &[Call(Function::Cosh, &[X])],
    },
    Row {
        function: Function::Cosh,
        name: "cosh",
        arity: 1,
        parity: Parity::Even,
        domain: Domain::Everywhere,
        at_zero: Some(1),
        is_nonnegative: true,
        latex: r"\cosh\left(#1\right)",
        rust: "cosh",
        value: |x| x[0].cosh(),
        partials: &[Call(Function::Sinh, &[X])],
    },
    Row {
        function: Function::Tanh,
        name: "tanh",
        arity: 1,
        parity: Parity::Odd,
        domain: Domain::Everywhere,
        at_zero: Some(0),
        is_nonnegative: false,
        latex: r"\tanh\left(#1\right)",
        rust: "tanh",
        value: |x| x[0].tanh(),
        partials: &[Linear(1, -1, &Square(&Value))],
    },
    Row {
        function: Function::Exp,
        name: "exp",
        arity: 1,
        parity: Parity::Neither,
        domain: Domain::Everywhere,
        at_zero: Some(1),
        is_nonnegative: true,
        latex: r"\exp\left(#1\right)",
        rust: "exp",
        value: |x| x[0].exp(),
        partials: &[Value],
    },
    Row {
        function: Function::Ln,
        name: "ln",
        arity: 1,
        parity: Parity::Neither,
        domain: Domain::AboveZero,
        at_zero: None,
        is_nonnegative: false,
        latex: r"\ln\left(#1\right)",
        rust: "ln",
        value: |x| x[0].ln(),
        partials: &[Reciprocal(&X)],
    },
    Row {
        function: Function::Sqrt,
        name: "sqrt",
        arity: 1,
        parity: Parity::Neither,
        domain: Domain::FromZero,
        at_zero: Some(0),
        is_nonnegative: true,
        latex: r"\sqrt{#1}",
        rust: "sqrt",
        value: |x| x[0].sqrt(),
        partials: &[Half(&ReciprocalRoot(&X))],
    },
    Row {
        function: Function::Abs,
        name: "abs",
        arity: 1,
        parity: Parity::Even,
        domain: Domain::Everywhere,
        at_zero: Some(0),
        is_nonnegative: true,
        latex: r"\left|#1\right|",
        rust: "abs",
        value: |x| x[0].abs(),
        partials: &[Call(Function::MagnitudeSlope, &[X])],
    },
    Row {
        function: Function::Sign,
        name: "sign",
        arity: 1,
        parity: Parity::Odd,
        domain: Domain::Everywhere,
        at_zero: Some(0),
        is_nonnegative: false,
        latex: r"\operatorname{sign}\left(#1\right)",
        rust: "sign",
        value: |x| sign(x[0]),
        partials: &[Constant(0)],
    },
    Row {
        function: Function::Min,
        name: "min",
        arity: 2,
        parity: Parity::Neither,
        domain: Domain::Everywhere,
        at_zero: None,
        is_nonnegative: false,
        latex: r"\min\left(#1, #2\right)",
        rust: "min",
        // The comparisons are arranged so that NaN in either argument propagates.
        value: |x| if x[0] < x[1] || x[0].is_nan() { x[0] } else { x[1] },
        partials: &[Less(&X, &Y), NotLess(&X, &Y)],
    },
    Row {
        function: Function::Max,
        name: "max",
        arity: 2,
        parity: Parity::Neither,
        domain: Domain::Everywhere,
        at_zero: None,
        is_nonnegative: false,
        latex: r"\max\left(#1, #2\right)",
        rust: "max",
        value: |x| if x[0] > x[1] || x[0].is_nan() { x[0] } else { x[1] },
        partials: &[Less(&Y, &X), NotLess(&Y, &X)],
    },
    Row {
        function: Function::Power,
        name: "pow",
        arity: 2,
        parity: Parity::Neither,
        domain: Domain::BaseAboveZero,
        at_zero: None,
        is_nonnegative: false,
        latex: r"{#1}^{#2}",
        rust: "powf",
        // Unlike `powf` of the platform, for which 1^NaN and NaN^0 are one.
        value: |x| if x[0].is_nan() || x[1].is_nan() { f64::NAN } else { x[0].powf(x[1]) },
        partials: &[
            Multiply(&Y, &Call(Function::Power, &[X, Linear(-1, 1, &Y)])),
            Multiply(&Value, &Call(Function::Ln, &[X])),
        ],
    },
    Row {
        function: Function::Hypot,
        name: "hypot",
        arity: 2,
        parity: Parity::Neither,
        domain: Domain::Everywhere,
        at_zero: None,
        is_nonnegative: true,
        latex: r"\sqrt{\left(#1\right)^{2} + \left(#2\right)^{2}}",
        rust: "hypot",
        value: |x| x[0].hypot(x[1]),
        partials: &[Divide(&X, &Value), Divide(&Y, &Value)],
    },
    // Written as the sign, which has the same value; only products distinguish them.
    Row {
        function: Function::MagnitudeSlope,
        name: "sign",
        arity: 1,
        parity: Parity::Odd,
        domain: Domain::Everywhere,
        at_zero: Some(0),
        is_nonnegative: false,
        latex: r"\operatorname{sign}\left(#1\right)",
        rust: "sign",
        value: |x| sign(x[0]),
        partials: &[Constant(0)],
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
