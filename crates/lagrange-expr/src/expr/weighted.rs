//! Operands of sums and products with their weights.

use super::ExprId;
use crate::number::Number;

/// Nested operands longer than this are never opened: looking into them would cost more than it
/// finds.
pub(super) const LONGEST_OPENED: usize = 8;

/// An operand and its coefficient or exponent.
pub(super) type Weighted = (ExprId, Number);
