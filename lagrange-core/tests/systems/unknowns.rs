//! Algebraic unknowns along a motion: their values by bracketing, then by the chord method, which
//! adds one order per step.

use crate::digits::Real;
use crate::tree::Expr;
use crate::world::World;

impl World<'_> {
    /// Solves for an unknown whose residual increases everywhere, by bracketing and then by the
    /// chord method.
    pub(crate) fn solve(&mut self, name: &str, residual: &Expr) -> Option<()> {
        let variations = std::mem::take(&mut self.field.variations);
        let found = self.root(name, residual);
        self.field.variations = variations;
        let (root, slope) = found?;
        self.roots.insert(name.to_owned(), root.clone());
        let mut jet = self.field.series(&[root]);
        let inverse = self.field.quotient(&self.field.integer(-1), &slope);
        let inverse = self.field.series(&[inverse]);
        // Each chord step adds an order, and digits while the slope is a difference quotient.
        for _ in 0..8 {
            self.scope.insert(name.to_owned(), vec![jet.clone()]);
            let rest = self.scalar(residual)?;
            let step = self.field.multiply(&rest, &inverse);
            jet = self.field.add(&jet, &step);
        }
        self.scope.insert(name.to_owned(), vec![jet]);
        Some(())
    }

    fn residual(&mut self, name: &str, residual: &Expr, at: &Real) -> Option<Real> {
        let at = self.field.series(std::slice::from_ref(at));
        self.scope.insert(name.to_owned(), vec![at]);
        Some(self.scalar(residual)?.value[0].clone())
    }

    /// Returns a zero of the residual and the slope there.
    fn root(&mut self, name: &str, residual: &Expr) -> Option<(Real, Real)> {
        let tiny = self.field.arithmetic.float(1e-30);
        let mut near = match self.roots.get(name) {
            Some(root) => root.clone(),
            None => self.bisected(name, residual)?,
        };
        let mut slope = self.field.integer(1);
        for _ in 0..12 {
            let beside = self.field.arithmetic.add(&near, &tiny);
            let [here, there] =
                [self.residual(name, residual, &near)?, self.residual(name, residual, &beside)?];
            let rise = self.field.arithmetic.subtract(&there, &here);
            slope = self.field.arithmetic.divide(&rise, &tiny);
            let step = self.field.arithmetic.divide(&here, &slope);
            near = self.field.arithmetic.subtract(&near, &step);
            if self.roots.contains_key(name) {
                break;
            }
        }
        Some((near, slope))
    }

    fn bisected(&mut self, name: &str, residual: &Expr) -> Option<Real> {
        let [mut low, mut high] = [-1e4, 1e4].map(|bound| self.field.arithmetic.float(bound));
        let half = self.field.arithmetic.float(0.5);
        for _ in 0..40 {
            let sum = self.field.arithmetic.add(&low, &high);
            let middle = self.field.arithmetic.multiply(&sum, &half);
            let rest = self.residual(name, residual, &middle)?;
            if rest.is_negative() { low = middle } else { high = middle }
        }
        Some(low)
    }
}
