//! Parts of statements that declare names, reduced types or products.

use super::{AstId, Name};

/// The kind of a state.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum StateKind {
    /// `state`: the rate is declared.
    FirstOrder,
    /// `discrete`: only events change it.
    Discrete,
}

impl StateKind {
    /// Returns the keyword of such states.
    pub fn keyword(self) -> &'static str {
        match self {
            StateKind::FirstOrder => "state",
            StateKind::Discrete => "discrete",
        }
    }
}

/// A discrete state with named values, counted from zero. It starts with the first one.
#[derive(Clone, Debug)]
pub struct Mode {
    /// Its name.
    pub name: Name,
    /// The names of its values.
    pub values: Vec<Name>,
}

impl Mode {
    /// Returns its own name and those of its values.
    pub(super) fn names(&self) -> Vec<&Name> {
        [&self.name].into_iter().chain(&self.values).collect()
    }

    /// Returns the names for modification.
    pub(super) fn names_mut(&mut self) -> Vec<&mut Name> {
        [&mut self.name].into_iter().chain(&mut self.values).collect()
    }
}

/// One `name = value` of a `param`, `input`, `const`, `coord` or `state` statement.
#[derive(Clone, Debug)]
pub struct Definition {
    /// The declared name.
    pub name: Name,
    /// The values that a parameter, a coordinate or a state may have.
    pub range: AllowedRange,
    /// The magnitude that counts as one, of a coordinate or a state.
    pub nominal: Option<AstId>,
    /// The value after `=`, if there is one.
    pub value: Option<AstId>,
}

/// A range of numbers, unlimited without bounds.
#[derive(Clone, Copy, Default, Debug)]
pub struct AllowedRange {
    /// The lower bound.
    pub lower: Option<Limit>,
    /// The upper bound.
    pub upper: Option<Limit>,
}

/// A bound of a range.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Limit {
    /// Its value.
    pub value: AstId,
    /// True if the range contains it.
    pub is_included: bool,
}

impl Definition {
    /// Creates a definition with only a name.
    pub fn of(name: Name) -> Definition {
        Definition { name, range: AllowedRange::default(), nominal: None, value: None }
    }

    pub(super) fn expressions_mut(&mut self) -> impl Iterator<Item = &mut AstId> {
        let limits = self.range.limits_mut().map(|limit| &mut limit.value);
        limits.chain(&mut self.nominal).chain(&mut self.value)
    }

    /// True if it has a range or a nominal value.
    pub fn is_limited(&self) -> bool {
        self.nominal.is_some() || self.range.limits().next().is_some()
    }
}

/// One `x in 0..=1 nominal 0.1` of a `range` statement.
#[derive(Clone, Debug)]
pub struct LimitedEntry {
    /// Quantity: it should be `x` or `dot(x)` of a coordinate.
    pub target: AstId,
    /// Its values.
    pub range: AllowedRange,
    /// The magnitude that counts as one.
    pub nominal: Option<AstId>,
}

impl LimitedEntry {
    /// Returns the bounds and the nominal value.
    pub fn values(&self) -> impl Iterator<Item = AstId> {
        self.range.limits().map(|limit| limit.value).chain(self.nominal)
    }

    pub(super) fn expressions_mut(&mut self) -> impl Iterator<Item = &mut AstId> {
        let limits = self.range.limits_mut().map(|limit| &mut limit.value);
        limits.chain(&mut self.nominal).chain([&mut self.target])
    }
}

impl AllowedRange {
    /// Returns its bounds.
    pub fn limits(&self) -> impl Iterator<Item = Limit> {
        self.lower.into_iter().chain(self.upper)
    }

    /// Returns its bounds for modification.
    pub fn limits_mut(&mut self) -> impl Iterator<Item = &mut Limit> {
        self.lower.iter_mut().chain(&mut self.upper)
    }
}

/// One entry of `emit { … }`: a product to add, or, preceded by `no`, to omit.
#[derive(Clone, Debug)]
pub struct EmitItem {
    /// The product.
    pub product: Name,
    /// True if the product is requested, false after `no`.
    pub wanted: bool,
}
