//! Products with a choice between an expression and zero.
//!
//! The derivative of `if x > 0 { x^(3/2) } else { 0 }` is an indicator, one where x > 0 and zero
//! elsewhere, times that of x^(3/2). Zero times NaN is not zero. Factors that may be undefined are
//! therefore moved into the nonzero branch.

use crate::expr::weighted::Weighted;
use crate::expr::{ExprId, Graph, Node};
use crate::number::Number;

impl Graph {
    /// Moves factors that may be undefined into the branch of a choice whose other branch is zero,
    /// if there is one.
    pub(in crate::expr) fn move_into_branch(&mut self, factors: &mut Vec<Weighted>) {
        let is_choice = |(base, exponent): &Weighted| exponent.is_one() && self.is_choice_with_zero(*base);
        let Some(at) = factors.iter().position(is_choice) else { return };
        let may_be_undefined = |(base, power): &Weighted| self.is_undefined_power(*base, power);
        if !factors[..at].iter().chain(&factors[at + 1..]).any(may_be_undefined) {
            return;
        }
        let (choice, _) = factors.swap_remove(at);
        let Node::Choose { relation, left, right, then, otherwise } = *self.node(choice) else { return };
        let (mut moved, kept) =
            factors.drain(..).partition::<Vec<_>, _>(|(base, power)| self.is_undefined_power(*base, power));
        *factors = kept;
        let is_first = self.is_zero(otherwise);
        moved.push((if is_first { then } else { otherwise }, Number::ONE));
        let branch = self.product(moved);
        let branches = if is_first { (branch, otherwise) } else { (then, branch) };
        factors.push((self.choose(relation, left, right, branches.0, branches.1), Number::ONE));
    }

    fn is_choice_with_zero(&self, id: ExprId) -> bool {
        match self.node(id) {
            Node::Choose { then, otherwise, .. } => self.is_zero(*then) || self.is_zero(*otherwise),
            _ => false,
        }
    }

    /// True if a power of this base may be undefined.
    fn is_undefined_power(&self, base: ExprId, power: &Number) -> bool {
        self.is_partial(base) || !power.is_integer() && !self.is_nonnegative(base)
    }
}
