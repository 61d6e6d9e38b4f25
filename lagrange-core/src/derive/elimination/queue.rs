//! Unknowns still to be eliminated from a quadratic form, in the order of elimination.
//!
//! The choice of the next one depends on the number of unknowns that it shares terms with. An
//! elimination changes this number only for its neighbours. Only these are re-evaluated, so the
//! cost of an elimination does not grow with the length of the queue.

use std::collections::{BTreeMap, BTreeSet};

use crate::derive::quadratic_form::QuadraticForm;
use lagrange_expr::collections::HashMap;
use lagrange_expr::expr::ExprId;

/// Unknowns in the order of their places, with their degrees in a form.
#[derive(Default)]
pub(in crate::derive) struct Queue {
    places: HashMap<ExprId, usize>,
    by_place: BTreeMap<usize, ExprId>,
    /// Degree and place of each unknown with a square.
    by_degree: BTreeSet<(usize, usize)>,
    degrees: HashMap<ExprId, usize>,
    /// Places of the unknowns without squares.
    squareless: BTreeSet<usize>,
    /// Unknowns whose terms have changed since the last call of `take_touched`.
    touched: BTreeSet<ExprId>,
}

impl Queue {
    /// Creates a queue with the unknowns in this order.
    pub(in crate::derive) fn new(form: &QuadraticForm, unknowns: &[ExprId]) -> Queue {
        let mut queue = Queue::default();
        unknowns.iter().for_each(|&id| queue.push(form, id));
        queue
    }

    /// Adds an unknown at the end.
    pub(in crate::derive) fn push(&mut self, form: &QuadraticForm, id: ExprId) {
        let place = self.by_place.last_key_value().map_or(0, |(last, _)| last + 1);
        self.places.insert(id, place);
        self.by_place.insert(place, id);
        self.refresh(form, id);
    }

    pub(in crate::derive) fn contains(&self, id: ExprId) -> bool {
        self.places.contains(&id)
    }

    /// Returns the queued unknowns in the order of their places.
    pub(in crate::derive) fn ids(&self) -> impl Iterator<Item = ExprId> {
        self.by_place.values().copied()
    }

    pub(in crate::derive) fn is_empty(&self) -> bool {
        self.by_place.is_empty()
    }

    /// Returns the place of an unknown, counted from zero. A variable that is not queued comes
    /// last.
    pub(in crate::derive) fn place(&self, id: ExprId) -> usize {
        self.places.get(&id).copied().unwrap_or(usize::MAX)
    }

    pub(in crate::derive) fn remove(&mut self, id: ExprId) {
        self.forget(id);
        self.touched.remove(&id);
        if let Some(place) = self.places.remove(&id) {
            self.by_place.remove(&place);
        }
    }

    /// Returns the unknown that shares terms with the fewest others; the first one in case of a
    /// tie. Only unknowns with a square are considered.
    pub(in crate::derive) fn least_coupled(&self) -> Option<ExprId> {
        let (_, place) = self.by_degree.first()?;
        self.by_place.get(place).copied()
    }

    /// Returns the first unknown without a square.
    pub(in crate::derive) fn first_squareless(&self) -> Option<ExprId> {
        self.by_place.get(self.squareless.first()?).copied()
    }

    /// Returns the first unknown that shares a term with this variable and satisfies `accepts`.
    pub(in crate::derive) fn first_near(
        &self,
        form: &QuadraticForm,
        id: ExprId,
        accepts: impl Fn(ExprId) -> bool,
    ) -> Option<ExprId> {
        let near = form.near(id).filter(|&other| self.contains(other) && accepts(other));
        near.min_by_key(|&other| self.place(other))
    }

    /// Updates the degree of an unknown; variables that are not queued are ignored.
    pub(in crate::derive) fn refresh(&mut self, form: &QuadraticForm, id: ExprId) {
        let Some(&place) = self.places.get(&id) else { return };
        self.forget(id);
        if form.has_square(id) {
            let degree = form.degree(id);
            self.degrees.insert(id, degree);
            self.by_degree.insert((degree, place));
        } else {
            self.squareless.insert(place);
        }
        self.touched.insert(id);
    }

    /// Takes the unknowns that have been updated since the last call.
    pub(in crate::derive) fn take_touched(&mut self) -> BTreeSet<ExprId> {
        std::mem::take(&mut self.touched)
    }

    fn forget(&mut self, id: ExprId) {
        let place = self.place(id);
        if let Some(degree) = self.degrees.remove(&id) {
            self.by_degree.remove(&(degree, place));
        }
        self.squareless.remove(&place);
    }
}

/// Unknowns that are eliminated next, and partners that may be eliminated with them.
#[derive(Default)]
pub(in crate::derive) struct Waiting {
    pub(in crate::derive) unknowns: Queue,
    pub(in crate::derive) partners: Queue,
}

impl Waiting {
    /// Updates both queues after changes of a form.
    pub(in crate::derive) fn follow(&mut self, form: &mut QuadraticForm) {
        for id in form.take_changed() {
            self.unknowns.refresh(form, id);
            self.partners.refresh(form, id);
        }
    }
}
