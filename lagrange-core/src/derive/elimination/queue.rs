//! Unknowns that wait to be eliminated from a quadratic form, in the order in which they go.
//!
//! The next one depends on the number of others with which it shares terms, and an elimination
//! changes that for its neighbours only. Only these are evaluated again, so the cost of an
//! elimination does not grow with the number of those that wait.

use std::collections::{BTreeMap, BTreeSet};

use crate::derive::quadratic_form::QuadraticForm;
use lagrange_expr::collections::HashMap;
use lagrange_expr::expr::ExprId;

/// Unknowns in the order of their places, with what a form says of them.
#[derive(Default)]
pub(in crate::derive) struct Queue {
    places: HashMap<ExprId, usize>,
    by_place: BTreeMap<usize, ExprId>,
    /// Degree and place of those that have squares.
    by_degree: BTreeSet<(usize, usize)>,
    degrees: HashMap<ExprId, usize>,
    /// Places of the others.
    squareless: BTreeSet<usize>,
    /// Unknowns whose terms have changed since this was last asked for.
    touched: BTreeSet<ExprId>,
}

impl Queue {
    /// The unknowns in this order.
    pub(in crate::derive) fn new(form: &QuadraticForm, unknowns: &[ExprId]) -> Queue {
        let mut queue = Queue::default();
        unknowns.iter().for_each(|&id| queue.push(form, id));
        queue
    }

    /// Adds an unknown in the last place.
    pub(in crate::derive) fn push(&mut self, form: &QuadraticForm, id: ExprId) {
        let place = self.by_place.last_key_value().map_or(0, |(last, _)| last + 1);
        self.places.insert(id, place);
        self.by_place.insert(place, id);
        self.refresh(form, id);
    }

    pub(in crate::derive) fn contains(&self, id: ExprId) -> bool {
        self.places.contains(&id)
    }

    /// Unknowns that wait, in the order of places.
    pub(in crate::derive) fn ids(&self) -> impl Iterator<Item = ExprId> {
        self.by_place.values().copied()
    }

    pub(in crate::derive) fn is_empty(&self) -> bool {
        self.by_place.is_empty()
    }

    /// The first place is zero; what does not wait comes last.
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

    /// First unknown with a square that shares terms with the fewest others.
    pub(in crate::derive) fn least_coupled(&self) -> Option<ExprId> {
        let (_, place) = self.by_degree.first()?;
        self.by_place.get(place).copied()
    }

    /// The first unknown without a square.
    pub(in crate::derive) fn first_squareless(&self) -> Option<ExprId> {
        self.by_place.get(self.squareless.first()?).copied()
    }

    /// The first unknown that shares a term with this variable and that `accepts`.
    pub(in crate::derive) fn first_near(
        &self,
        form: &QuadraticForm,
        id: ExprId,
        accepts: impl Fn(ExprId) -> bool,
    ) -> Option<ExprId> {
        let near = form.near(id).filter(|&other| self.contains(other) && accepts(other));
        near.min_by_key(|&other| self.place(other))
    }

    /// Looks at an unknown again; variables that do not wait are no business of the queue.
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

    /// The unknowns that have been looked at since this was last called.
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

/// Unknowns that are eliminated next, and others that may go with them.
#[derive(Default)]
pub(in crate::derive) struct Waiting {
    pub(in crate::derive) unknowns: Queue,
    pub(in crate::derive) partners: Queue,
}

impl Waiting {
    /// Follows what has happened to a form.
    pub(in crate::derive) fn follow(&mut self, form: &mut QuadraticForm) {
        for id in form.take_changed() {
            self.unknowns.refresh(form, id);
            self.partners.refresh(form, id);
        }
    }
}
