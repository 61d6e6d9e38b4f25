//! Taylor series of a motion: programs for the coefficients of one order after the other.
//!
//! A motion q̇ = r(t, q, v), v̇ = a is expanded about a moment: with xₖ the coefficient of order k,
//! qₖ₊₁ = rₖ/(k+1) and vₖ₊₁ = aₖ/(k+1). Every value of a straight-line program is itself a series,
//! whose coefficients follow from those of its operands:
//!
//! | value | coefficient of order m |
//! |---|---|
//! | c x, x + y | c xₘ, xₘ + yₘ |
//! | x y | Σ xⱼ yₘ₋ⱼ |
//! | z = x/y | (xₘ − Σ_{j≥1} yⱼ zₘ₋ⱼ)/y₀ |
//! | y = √x | (xₘ − Σ_{0<j<m} yⱼ yₘ₋ⱼ)/(2 y₀) |
//! | f(x) | f′(x) ẋ of order m − 1, divided by m |
//! | y = xᵃ | a ẋ y/x of order m − 1, divided by m; zero if x₀ is |
//!
//! The row of f holds for every elementary function, since its rate is also a program. It also
//! holds for solutions of equations and for tables, as long as their arguments stay within their
//! initial [pieces](TableArgument). A root, a power or a length that starts from zero has no series
//! there. It is kept at zero, which is only valid for a short time. The sine of an angle costs the
//! product cos θ · θ̇, which the system often needs for a velocity anyway.
//!
//! Source: Griewank and Walther, *Evaluating Derivatives*, 2nd ed., §13; Jorba and Zou, "A software
//! package for the numerical integration of ODEs by means of high-order Taylor methods", *Experimental
//! Mathematics* 14 (2005) 99–117.
//!
//! # Accelerations
//!
//! Accelerations may be functions of t, q and v, and are then expanded as such. Alternatively they
//! are the zeros of a residual R that is linear in them, such as inverse dynamics. Rates ẇ of
//! velocities w remain symbols in R, since ẇₖ = (k+1) wₖ₊₁ costs nothing. In each order, R is
//! computed with aₖ = 0. The matrix ∂R/∂a of order zero then gives aₖ, and values that depend on aₖ
//! are corrected accordingly.
//!
//! The multipliers λ of constraints are unknowns of the same kind. R contains the forces −Aᵀλ and
//! is followed by the rates ċ̇ of the constraints. Unknowns that the matrix does not couple, such
//! as those of separate bodies, are solved apart.
//!
//! # A pendulum in numbers
//!
//! θ̈ = −10 sin θ from θ₀ with sin θ₀ = 3/5, cos θ₀ = 4/5, at θ̇₀ = 1. With s = sin θ, c = cos θ
//! and ω = θ̇:
//!
//! | k | θₖ₊₁ = ωₖ/(k+1) | (c ω)ₖ | sₖ₊₁ | (s ω)ₖ | cₖ₊₁ | ωₖ₊₁ = −10 sₖ/(k+1) |
//! |---|---|---|---|---|---|---|
//! | 0 | 1 | 4/5 | 4/5 | 3/5 | −3/5 | −6 |
//! | 1 | −3 | 4/5·(−6) − 3/5·1 = −27/5 | −27/10 | 3/5·(−6) + 4/5·1 = −14/5 | 7/5 | −4 |
//!
//! # Orders
//!
//! Step k computes the coefficient of order k + 1 of values that velocities and positions
//! determine. For values with accelerations or rates of velocities, it computes that of order k. A
//! product then needs Σ_{1≤j≤k} xⱼ yₘ₋ⱼ of coefficients from earlier steps, and otherwise only
//! those of order zero and the newest. These sums have the same form for all products and are
//! computed together, in [groups](Groups). Multiples of the same values share a sum unless the
//! system is small.

mod alignment;
mod coefficients;
mod functions;
mod groups;
mod kinds;
mod linear;
mod recurrence;
mod schedule;
mod slots;

use crate::program::{Program, ValueId};
use coefficients::{Coefficients, Constants};
use lagrange_expr::opaque::Opaque;
use lagrange_expr::symbol::Role;
use schedule::Schedule;

pub use functions::{function_rates, without_long_powers};
pub use groups::Groups;
pub use kinds::NoSeries;
pub use slots::Slot;

/// A motion to be expanded.
#[derive(Debug)]
pub struct Motion<'a> {
    /// Program that computes all values below, lowered, before any pass.
    pub program: &'a Program,
    /// Entries of the state.
    pub state: &'a [Entry],
    /// Values of elementary functions with their rates.
    pub rates: &'a [(ValueId, ValueId)],
    /// Placeholders for the rates of values, with these values.
    pub unexpanded: &'a [(Role, ValueId)],
    /// Residuals R, one for each acceleration, then one for each multiplier; empty if accelerations
    /// are functions of the state.
    pub residuals: &'a [ValueId],
}

impl Motion<'_> {
    /// Returns the number of accelerations that only the residuals determine; multipliers come
    /// after them.
    fn unknown_accelerations(&self) -> u32 {
        self.state.iter().map(|entry| u32::from(matches!(entry.rate, Rate::Acceleration(_)))).sum()
    }
}

/// An entry of a state.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Entry {
    /// The entry itself, an input of the program.
    pub value: ValueId,
    /// Its rate.
    pub rate: Rate,
}

/// The rate of an entry of a state.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Rate {
    /// A function of the state.
    Value(ValueId),
    /// The acceleration of this index, which makes the residuals zero.
    Acceleration(u32),
}

/// An argument of a table, which selects polynomials.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct TableArgument {
    /// The table.
    pub table: Opaque,
    /// Place among the arguments of the table.
    pub axis: usize,
    /// Kept value with its coefficients.
    pub kept: usize,
    /// Initial value that it starts from.
    pub initial: usize,
}

/// The programs that expand a motion, over [placeholders](lagrange_expr::symbol::Role::Placeholder)
/// with the meaning of `slots`.
///
/// Values are *kept* from one step to the next, in the order of the outputs of `expansion` and
/// `correction`: the entries of the state first.
#[derive(Debug)]
pub struct SeriesPrograms {
    /// The values that [`Slot::Initial`] refers to, from the inputs of the motion's program, then
    /// the matrix ∂R/∂(a, λ), row by row.
    pub initial: Program,
    /// One coefficient of each kept value, as if accelerations were zero; then the residuals.
    pub expansion: Program,
    /// One coefficient of each kept value; `None` if accelerations are functions of the state.
    pub correction: Option<Program>,
    /// Factors of the products that [`Slot::Sum`] refers to, as places of kept values.
    pub sums: Vec<[usize; 2]>,
    /// Kept values that [`Slot::Carried`] refers to, with the initial value that replaces them in
    /// the first step.
    pub carried: Vec<(usize, usize)>,
    /// Meaning of the placeholders, by number.
    pub slots: Vec<Slot>,
    /// Arguments of tables.
    pub arguments: Vec<TableArgument>,
    /// Number of initial values, without the matrix.
    pub initials: usize,
    /// Number of kept values.
    pub kept: usize,
    /// Unknowns in sets that the matrix couples. Each set has equations of its own: those of the
    /// same indices.
    pub blocks: Vec<Vec<usize>>,
}

/// Maximum number of sums of a step whose time depends on chains of operations rather than on their
/// number.
const MAX_WAITING: usize = 8;

/// Derives the programs.
///
/// # Errors
/// If a value that the motion depends on has no series.
pub fn expand(motion: &Motion<'_>) -> Result<SeriesPrograms, NoSeries> {
    let schedule = Schedule::new(motion)?;
    let programs = |constants| Coefficients::new(motion, &schedule, constants).programs();
    let fewest = programs(Constants::BeforeSums);
    if fewest.sums.len() > MAX_WAITING {
        return Ok(fewest);
    }
    let shortest = programs(Constants::InSums);
    Ok(if shortest.sums.len() > fewest.sums.len() { fewest } else { shortest })
}

#[cfg(test)]
mod tests;
