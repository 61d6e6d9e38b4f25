//! The expressions within statements and within each other.

use crate::tree::{Expr, Statement};

impl Expr {
    /// Returns the direct parts of an expression.
    pub(crate) fn parts_mut(&mut self) -> Vec<&mut Expr> {
        match self {
            Expr::Number(..)
            | Expr::Pi
            | Expr::Time
            | Expr::Name(_)
            | Expr::Element(..)
            | Expr::Variable
            | Expr::Center(_)
            | Expr::Spin(_) => Vec::new(),
            Expr::Binary(_, a, b)
            | Expr::Inner(a, b)
            | Expr::KineticEnergy(a, b)
            | Expr::SpringEnergy(a, b) => vec![a, b],
            Expr::Negative(a)
            | Expr::Power(a, ..)
            | Expr::Rate(a)
            | Expr::Sum(_, a)
            | Expr::Component(a, _)
            | Expr::Norm(a) => vec![a],
            Expr::Call(_, of)
            | Expr::Apply(_, of)
            | Expr::Vector(of)
            | Expr::Point(_, of)
            | Expr::Direction(_, of) => of.iter_mut().collect(),
            Expr::Choose { operands, .. } => operands.iter_mut().collect(),
            Expr::EveryNth(_, operands) => operands.iter_mut().collect(),
        }
    }
}

impl Statement {
    /// Returns the expressions of energies, loads, constraints, equations and outputs.
    pub(crate) fn expressions_mut(&mut self) -> Vec<&mut Expr> {
        match self {
            Statement::Let(_, value)
            | Statement::LetElement(_, _, value)
            | Statement::LetFunction(_, _, value)
            | Statement::Energy(_, value)
            | Statement::Force(_, value)
            | Statement::Output(_, value)
            | Statement::StateRate { rate: value, .. }
            | Statement::Solve { residual: value, .. }
            | Statement::Constraint { zero: value, .. } => vec![value],
            Statement::ForceAlong(a, b) | Statement::ForceAt(a, b) | Statement::Torque(a, b) => vec![a, b],
            Statement::TorqueOn(a, _) => vec![a],
            Statement::Gravity(vector) => vector.iter_mut().collect(),
            Statement::Loop(_, statements) => {
                statements.iter_mut().flat_map(Statement::expressions_mut).collect()
            }
            _ => Vec::new(),
        }
    }
}
