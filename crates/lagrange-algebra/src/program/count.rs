//! Operation counts of programs.

use std::fmt;

use super::ir::{Op, Program};
use lagrange_expr::expr::Function;

/// The operations of a program by kind.
///
/// A subtraction counts as an addition, a fused multiply-add as one addition and one
/// multiplication. Sign changes are free on every relevant processor and are not counted.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct OperationCounts {
    /// Additions and subtractions.
    pub additions: usize,
    /// Multiplications.
    pub multiplications: usize,
    /// Divisions.
    pub divisions: usize,
    /// Square roots.
    pub square_roots: usize,
    /// Elementary functions other than those counted below, large integer powers, and functions of
    /// the user's crate.
    pub functions: usize,
    /// Sines and cosines of the same argument computed together, one for each argument of a batch.
    pub sin_cos: usize,
    /// Choices between two values.
    pub selections: usize,
}

impl OperationCounts {
    /// Counts the operations of a program.
    pub fn of(program: &Program) -> OperationCounts {
        let mut counts = OperationCounts::default();
        program.values().for_each(|(_, op)| counts.add(op));
        counts
    }

    fn add(&mut self, op: &Op) {
        match op {
            Op::Input(_) | Op::Constant(_) | Op::Float(_) | Op::Negate(_) => {}
            Op::SinOf(_) | Op::CosOf(_) | Op::SinIn(..) | Op::CosIn(..) => {}
            Op::Add(..) | Op::Subtract(..) => self.additions += 1,
            Op::Multiply(..) => self.multiplications += 1,
            Op::Divide(..) => self.divisions += 1,
            Op::MultiplyAdd(..) | Op::MultiplySubtract(..) | Op::SubtractProduct(..) => {
                self.additions += 1;
                self.multiplications += 1;
            }
            Op::Call(Function::Sqrt, _) => self.square_roots += 1,
            Op::Power(..) | Op::Call(..) | Op::Opaque(..) => self.functions += 1,
            Op::SinCos(_) => self.sin_cos += 1,
            Op::SinCosEach(angles) => self.sin_cos += angles.len(),
            Op::Select { .. } => self.selections += 1,
        }
    }

    /// Returns the number of operations.
    pub fn total(&self) -> usize {
        let OperationCounts {
            additions,
            multiplications,
            divisions,
            square_roots,
            functions,
            sin_cos,
            selections,
        } = *self;
        additions + multiplications + divisions + square_roots + functions + sin_cos + selections
    }

    /// Estimates the time in units of an addition.
    pub fn cost(&self) -> f64 {
        let weighted = self.additions
            + self.multiplications
            + 5 * (self.divisions + self.square_roots)
            + 20 * self.functions
            + 25 * self.sin_cos
            + 2 * self.selections;
        weighted as f64
    }
}

/// Formats as `14 additions, 1 multiplication, 2 sin_cos`, omitting zero counts.
impl fmt::Display for OperationCounts {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let kinds = [
            (self.additions, "addition", "additions"),
            (self.multiplications, "multiplication", "multiplications"),
            (self.divisions, "division", "divisions"),
            (self.square_roots, "square root", "square roots"),
            (self.functions, "function", "functions"),
            (self.sin_cos, "sin_cos", "sin_cos"),
            (self.selections, "selection", "selections"),
        ];
        let mut separator = "";
        for (count, one, many) in kinds.into_iter().filter(|(count, ..)| *count > 0) {
            write!(f, "{separator}{count} {}", if count == 1 { one } else { many })?;
            separator = ", ";
        }
        if separator.is_empty() { f.write_str("no operations") } else { Ok(()) }
    }
}
