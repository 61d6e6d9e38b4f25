//! Whole arrays as vectors and matrices of their elements; entries of vectors and matrices.

use super::copier::{Copier, Task};
use super::counting::Counting;
use super::indices::{PlacedIndex, counted_indices};
use super::messages;
use super::paths::{Path, ScopedIndex, Segment, Target};
use super::scopes::ScopeId;
use crate::syntax::ast::{ArrayShape, Assignment, AstId, Expression, Name};
use lagrange_expr::diagnostics::Origin;
use lagrange_expr::limits::MAX_WRITTEN_OUT;
use lagrange_expr::number::Number;

/// All elements of an array of values.
pub(super) struct WholeArray {
    pub(super) sizes: Vec<usize>,
    /// Indices and names in the expanded declaration.
    pub(super) elements: Vec<(Vec<i64>, String)>,
}

impl Copier<'_> {
    /// Returns the array denoted by a name without indices, if it is one.
    pub(super) fn whole_array(&mut self, name: &Name, scope: ScopeId) -> Option<WholeArray> {
        let Ok(Target::Declared(segment)) = Path::of_name(name, scope).target(self.counting()) else {
            return None;
        };
        let sizes = self.elements.sizes_of_values(&segment.text).filter(|_| segment.indices.is_empty())?;
        let is_whole = !sizes.is_empty() && ArrayShape::of_sizes(&sizes).is_some();
        is_whole.then(|| WholeArray { sizes, elements: self.elements.all_of(&segment.text) })
    }

    /// Returns an assignment, or one for each component of a vector or matrix of targets.
    pub(super) fn assigned(&mut self, assignment: Assignment) -> Vec<Assignment> {
        let Assignment { target, value, .. } = assignment;
        let (rate, whole) = match self.expressions.get(target) {
            Expression::Call(function, arguments) if arguments.len() == 1 => {
                (Some(function.clone()), arguments[0])
            }
            _ => (None, target),
        };
        let (shape, leaves) = self.leaves(whole);
        if leaves.is_empty() {
            return vec![assignment];
        }
        let origin = self.expressions.origin(target);
        let mut assigned = Vec::new();
        for (indices, leaf) in leaves {
            let target = match &rate {
                Some(function) => {
                    self.expressions.add(Expression::Call(function.clone(), vec![leaf]), origin)
                }
                None => leaf,
            };
            let value = self.part_given(value, &indices, shape);
            assigned.push(Assignment::new(target, value));
        }
        assigned
    }

    /// Returns the part of a value for an element of an array.
    pub(super) fn part_given(&mut self, value: AstId, indices: &[i64], shape: Option<ArrayShape>) -> AstId {
        let origin = self.expressions.origin(value);
        let indices = indices.iter().map(|index| (*index, origin)).collect::<Vec<_>>();
        self.entry(value, &indices, shape, origin)
    }

    /// Returns the shape of a written-out vector or matrix, and its entries with their indices.
    fn leaves(&self, whole: AstId) -> (Option<ArrayShape>, Vec<(Vec<i64>, AstId)>) {
        let Expression::Tuple(rows) = self.expressions.get(whole) else { return (None, Vec::new()) };
        let (mut shapes, mut leaves) = (Vec::new(), Vec::new());
        for (number, row) in (0..).zip(rows) {
            let (shape, inner) = self.leaves(*row);
            shapes.push(shape.unwrap_or(ArrayShape::Scalar));
            match inner.is_empty() {
                true => leaves.push((vec![number], *row)),
                false => leaves.extend(
                    inner
                        .into_iter()
                        .map(|(indices, leaf)| ([number].into_iter().chain(indices).collect(), leaf)),
                ),
            }
        }
        (ArrayShape::stacked(&shapes), leaves)
    }

    /// Schedules the copy of the entry of a value at indices; an invalid index is reported.
    pub(super) fn behind(
        &mut self,
        of: AstId,
        indices: &[ScopedIndex],
        (scope, origin): (ScopeId, Origin),
        tasks: &mut Vec<Task>,
    ) -> Option<AstId> {
        let Some(indices) = self.counted(indices, scope) else {
            return Some(self.expressions.add(Expression::Invalid, origin));
        };
        tasks.push(Task::Entry(indices, origin));
        tasks.push(Task::Copy(of, scope));
        None
    }

    /// Returns an entry of a value; for a written-out vector, its component.
    pub(super) fn entry(
        &mut self,
        of: AstId,
        indices: &[PlacedIndex],
        shape: Option<ArrayShape>,
        origin: Origin,
    ) -> AstId {
        let [(first, _), rest @ ..] = indices else { return of };
        let first_place = usize::try_from(*first).ok();
        if let (None, Expression::Tuple(components)) = (shape, self.expressions.get(of))
            && let Some(component) = first_place.and_then(|place| components.get(place).copied())
        {
            return self.entry(component, rest, None, origin);
        }
        let indices = indices
            .iter()
            .map(|(index, place)| self.expressions.add(Expression::Number(Number::from(*index)), *place));
        let indices = indices.collect();
        self.expressions.add(Expression::Entry { of, indices, shape }, origin)
    }

    /// Returns a whole array, a row of a grid, or an entry of a vector element. `None` for
    /// everything else, and `Some(None)` after a reported error.
    pub(super) fn part_of_whole(
        &mut self,
        segment: &Segment,
        (scope, origin): (ScopeId, Origin),
    ) -> Option<Option<AstId>> {
        let given = segment.indices.len();
        let rank = match self.elements.rank_of_values(&segment.text) {
            Some(rank) if rank == given => return None,
            Some(rank) => rank,
            None if given > 0 && self.elements.is_let(&segment.text) => 0,
            None => return None,
        };
        if given > rank {
            return Some(self.entry_of_element(segment, rank, (scope, origin)));
        }
        let sizes = self.elements.sizes_of_values(&segment.text)?;
        let indices = self.counted(&segment.indices, scope);
        let indices = indices.map(|indices| indices.iter().map(|(index, _)| *index).collect::<Vec<_>>());
        Some(indices.and_then(|indices| self.whole(segment, &indices, &sizes, (scope, origin))))
    }

    /// Returns the entry of an element at further indices.
    fn entry_of_element(
        &mut self,
        segment: &Segment,
        rank: usize,
        (scope, origin): (ScopeId, Origin),
    ) -> Option<AstId> {
        let (own, further) = segment.indices.split_at(rank);
        let of_array = Segment { indices: own.to_vec(), text: segment.text.clone(), ..*segment };
        let name = match rank {
            0 => segment.text.clone(),
            _ => self.element(&of_array, scope)?,
        };
        let further = self.counted(further, scope)?;
        let element = self.expressions.add(Expression::Name(name), origin);
        Some(self.entry(element, &further, None, origin))
    }

    /// Returns the elements at the first indices as a vector or a matrix.
    fn whole(
        &mut self,
        segment: &Segment,
        first: &[i64],
        sizes: &[usize],
        (scope, origin): (ScopeId, Origin),
    ) -> Option<AstId> {
        let missing = first
            .iter()
            .zip(sizes)
            .any(|(index, size)| usize::try_from(*index).ok().is_none_or(|index| index >= *size));
        if missing {
            let message = messages::no_element(messages::written(&segment.text, first));
            let message = format!("{message}{}", self.scopes.place_of(scope));
            let (first, _) = *segment.indices.first()?;
            let origin = self.expressions.origin(first);
            if let Some(error) = self.complaints.once(first, origin, message) {
                error.help(messages::written_help(self.elements.example(&segment.text)));
            }
            return None;
        }
        let rest = &sizes[first.len()..];
        if ArrayShape::of_sizes(rest).is_none() {
            let error = self.complaints.report.error(origin, messages::NO_WHOLE);
            error.help(messages::written_help(self.elements.example(&segment.text)));
            return None;
        }
        self.terms = self.terms.saturating_add(rest.iter().product::<usize>() as u64);
        if self.terms > MAX_WRITTEN_OUT {
            return Some(self.too_long(origin));
        }
        self.elements_behind(&segment.text, &mut first.to_vec(), rest, origin)
    }

    /// Returns the elements at indices, nested to the number of sizes: at most two.
    fn elements_behind(
        &mut self,
        name: &str,
        indices: &mut Vec<i64>,
        sizes: &[usize],
        origin: Origin,
    ) -> Option<AstId> {
        let [size, rest @ ..] = sizes else {
            let text = self.elements.text_of_value(name, indices)?.to_owned();
            return Some(self.expressions.add(Expression::Name(text), origin));
        };
        let mut components = Vec::new();
        for index in 0..*size {
            indices.push(i64::try_from(index).ok()?);
            components.push(self.elements_behind(name, indices, rest, origin)?);
            indices.pop();
        }
        Some(self.expressions.add(Expression::Tuple(components), origin))
    }

    /// Returns indices as integers; invalid or negative ones are reported.
    fn counted(&mut self, indices: &[ScopedIndex], scope: ScopeId) -> Option<Vec<PlacedIndex>> {
        let counting =
            Counting { expressions: self.expressions, scopes: &self.scopes, constants: self.constants };
        let counted = counted_indices(indices, counting, &mut self.complaints)?;
        let Some(((place, _), index)) = indices.iter().zip(&counted).find(|(_, index)| **index < 0) else {
            let places = indices.iter().map(|(index, _)| self.expressions.origin(*index));
            return Some(counted.into_iter().zip(places).collect());
        };
        let message = format!("{}{}", messages::below_zero(index), self.scopes.place_of(scope));
        if let Some(error) = self.complaints.once(*place, self.expressions.origin(*place), message) {
            error.help(messages::FROM_ZERO_HELP);
        }
        None
    }
}
