//! Operands of sums and products with their weights.

use super::ExprId;
use crate::number::Number;

/// Maximum length of nested operands that are expanded: for longer ones, the search would not pay
/// off.
pub(super) const LONGEST_OPENED: usize = 8;

/// An operand and its coefficient or exponent.
pub(super) type Weighted = (ExprId, Number);
