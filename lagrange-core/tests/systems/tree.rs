//! Declarations as trees. The reference evaluates them, and the language reads them as text.

use lagrange_core::expr::Function;

/// Index of an element in a loop: `base`, which is 0 or its variable `i`, and `offset`, modulo
/// `ring`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Index {
    pub(crate) is_variable: bool,
    pub(crate) offset: i64,
    pub(crate) ring: Option<i64>,
}

impl Index {
    pub(crate) const VARIABLE: Index = Index { is_variable: true, offset: 0, ring: None };

    /// Returns the index for a value of the variable.
    pub(crate) fn at(self, variable: i64) -> i64 {
        let index = self.offset + if self.is_variable { variable } else { 0 };
        self.ring.map_or(index, |ring| index.rem_euclid(ring))
    }
}

/// Operator of two operands.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Operator {
    Add,
    Subtract,
    Multiply,
    Divide,
}

/// An expression.
#[derive(Clone, Debug)]
pub(crate) enum Expr {
    /// Decimal, with its unit and the power of ten of that.
    Number(String, Option<Unit>),
    Pi,
    Time,
    Name(String),
    Element(String, Index),
    /// The variable of a loop as a number.
    Variable,
    Binary(Operator, Box<Expr>, Box<Expr>),
    Negative(Box<Expr>),
    /// A base to a rational power.
    Power(Box<Expr>, i64, i64),
    Call(Function, Vec<Expr>),
    /// A function or a table of the declaration, applied to arguments.
    Apply(String, Vec<Expr>),
    Rate(Box<Expr>),
    /// The third operand where the first is less than the second, or also where they are equal.
    /// Otherwise the fourth.
    Choose {
        or_equal: bool,
        operands: Box<[Expr; 4]>,
    },
    /// The first where the variable of a loop is a multiple of a number, else the second.
    EveryNth(i64, Box<[Expr; 2]>),
    /// Σ for i from 0 to a number.
    Sum(i64, Box<Expr>),
    Vector(Vec<Expr>),
    Component(Box<Expr>, usize),
    Norm(Box<Expr>),
    Inner(Box<Expr>, Box<Expr>),
    KineticEnergy(Box<Expr>, Box<Expr>),
    SpringEnergy(Box<Expr>, Box<Expr>),
    /// A point of a body, in body-fixed axes.
    Point(String, Vec<Expr>),
    /// A direction in the axes of a body.
    Direction(String, Vec<Expr>),
    /// The centre of mass of a body.
    Center(String),
    /// The angular velocity of a body in space, in the world.
    Spin(String),
}

/// A unit as text, with its power of ten relative to the coherent one.
#[derive(Clone, Debug)]
pub(crate) struct Unit {
    pub(crate) text: String,
    pub(crate) power: i32,
}

impl Unit {
    /// Returns a decimal in the coherent unit.
    pub(crate) fn coherent(unit: Option<&Unit>, decimal: &str) -> String {
        let Some(unit) = unit else { return decimal.to_owned() };
        let (digits, exponent) = decimal.split_once('e').unwrap_or((decimal, "0"));
        let exponent = exponent.parse::<i32>().expect("a whole number");
        format!("{digits}e{}", exponent + unit.power)
    }
}

/// Values of a parameter, an input or a constant.
#[derive(Clone, Debug)]
pub(crate) enum Values {
    One(String),
    Each(Vec<String>),
    All(i64, String),
}

/// Interpolation, and behaviour beyond the ends.
#[derive(Clone, Debug)]
pub(crate) struct Table {
    pub(crate) points: Vec<(String, String)>,
    pub(crate) interpolation: &'static str,
    pub(crate) outside: &'static str,
}

/// The end of a spring, a damper or a pin.
pub(crate) type Place = Expr;

/// A joint in space.
#[derive(Clone, Debug)]
pub(crate) struct Joint {
    pub(crate) kind: &'static str,
    /// Names of its coordinates, or of its orientation.
    pub(crate) names: Vec<String>,
    pub(crate) from: Option<String>,
    pub(crate) to: String,
    pub(crate) at: Option<Vec<Expr>>,
    pub(crate) turned: Option<Vec<Expr>>,
    pub(crate) axis: Option<Vec<Expr>>,
    pub(crate) pitch: Option<Expr>,
    pub(crate) damping: Option<Expr>,
}

/// The pose of a body in the plane, or of one without a joint.
#[derive(Clone, Debug)]
pub(crate) struct Pose {
    /// True if the position is that of the centre of mass, not of the origin.
    pub(crate) is_center: bool,
    pub(crate) place: Vec<Expr>,
    /// Three angles about successive axes, or the angle in the plane.
    pub(crate) angles: Vec<Expr>,
    pub(crate) sequence: String,
}

/// A rigid body.
#[derive(Clone, Debug)]
pub(crate) struct Body {
    pub(crate) name: String,
    pub(crate) mass: Expr,
    pub(crate) centroid: Option<Vec<Expr>>,
    /// xx, yy, zz and perhaps xy, xz, yz; in the plane one moment.
    pub(crate) inertia: Vec<Expr>,
    pub(crate) pose: Option<Pose>,
}

/// A statement.
#[derive(Clone, Debug)]
pub(crate) enum Statement {
    /// `param`, `input` or `const`.
    Values {
        word: &'static str,
        name: String,
        unit: Option<Unit>,
        values: Values,
    },
    Coordinate {
        name: String,
        unit: Option<Unit>,
        count: Option<i64>,
    },
    State {
        name: String,
        unit: Option<Unit>,
        count: Option<i64>,
    },
    /// The rate of a state, or of an element of an array.
    StateRate {
        name: String,
        index: Option<Index>,
        rate: Expr,
    },
    Quaternion(String),
    Let(String, Expr),
    LetElement(String, Index, Expr),
    LetFunction(String, Vec<String>, Expr),
    Table(String, Table),
    Solve {
        name: String,
        unit: Option<Unit>,
        residual: Expr,
        start: Option<Expr>,
    },
    /// `kinetic`, `potential`, `lagrangian` or `dissipation`.
    Energy(&'static str, Expr),
    /// A Gibbs function, and the part of the Lagrangian with the same equations.
    Gibbs(Expr, Expr),
    Force(String, Expr),
    ForceAlong(Expr, Expr),
    ForceAt(Expr, Expr),
    /// A moment on an angle.
    Torque(Expr, Expr),
    /// A moment on a body in space.
    TorqueOn(Expr, String),
    Constraint {
        name: String,
        holds_rates: bool,
        zero: Expr,
    },
    Output(String, Expr),
    Loop(i64, Vec<Statement>),
    Gravity(Vec<Expr>),
    Body(Body),
    Joint(Joint),
    Free(String),
    Spring {
        from: Place,
        to: Place,
        stiffness: Expr,
        rest: Option<Expr>,
    },
    Damper {
        from: Place,
        to: Place,
        damping: Expr,
    },
    Pin {
        name: String,
        from: Place,
        to: Place,
    },
}

impl Statement {
    /// True if a statement contributes to no energy and no constraint.
    pub(crate) fn is_load_or_output(&self) -> bool {
        matches!(
            self,
            Statement::Energy("dissipation", _)
                | Statement::Force(..)
                | Statement::ForceAlong(..)
                | Statement::ForceAt(..)
                | Statement::Torque(..)
                | Statement::TorqueOn(..)
                | Statement::Damper { .. }
                | Statement::StateRate { .. }
                | Statement::Output(..)
        )
    }
}

/// A declaration with its level of accuracy.
#[derive(Clone, Debug)]
pub(crate) struct Declaration {
    pub(crate) level: &'static str,
    pub(crate) statements: Vec<Statement>,
}

pub(crate) fn number(text: &str) -> Expr {
    Expr::Number(text.to_owned(), None)
}

pub(crate) fn name(text: &str) -> Expr {
    Expr::Name(text.to_owned())
}

pub(crate) fn rate(of: Expr) -> Expr {
    Expr::Rate(Box::new(of))
}

pub(crate) fn call(function: Function, argument: Expr) -> Expr {
    Expr::Call(function, vec![argument])
}

/// Builds `a` operator `b`.
pub(crate) fn binary(operator: Operator, a: Expr, b: Expr) -> Expr {
    Expr::Binary(operator, Box::new(a), Box::new(b))
}

pub(crate) fn add(a: Expr, b: Expr) -> Expr {
    binary(Operator::Add, a, b)
}

pub(crate) fn subtract(a: Expr, b: Expr) -> Expr {
    binary(Operator::Subtract, a, b)
}

pub(crate) fn multiply(a: Expr, b: Expr) -> Expr {
    binary(Operator::Multiply, a, b)
}

pub(crate) fn divide(a: Expr, b: Expr) -> Expr {
    binary(Operator::Divide, a, b)
}

/// Builds a to an integer power.
pub(crate) fn power(a: Expr, exponent: i64) -> Expr {
    Expr::Power(Box::new(a), exponent, 1)
}
