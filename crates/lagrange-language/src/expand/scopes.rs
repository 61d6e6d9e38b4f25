//! Variables of loops and their values, loop within loop.

/// The loops around a place; none by default.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub(super) struct ScopeId(Option<usize>);

impl ScopeId {
    /// True if no loop is around.
    pub(super) fn is_outermost(self) -> bool {
        self.0.is_none()
    }
}

/// All scopes of a declaration.
#[derive(Default)]
pub(super) struct Scopes(Vec<LoopScope>);

struct LoopScope {
    outer: ScopeId,
    name: String,
    /// `None` of a parameter of a function, which hides other names.
    value: Option<i64>,
}

impl Scopes {
    /// A scope in which a name has a value.
    pub(super) fn within(&mut self, outer: ScopeId, name: &str, value: i64) -> ScopeId {
        self.add(outer, name, Some(value))
    }

    /// A scope in which a name means nothing that is known here.
    pub(super) fn hiding(&mut self, outer: ScopeId, name: &str) -> ScopeId {
        self.add(outer, name, None)
    }

    fn add(&mut self, outer: ScopeId, name: &str, value: Option<i64>) -> ScopeId {
        self.0.push(LoopScope { outer, name: name.to_owned(), value });
        ScopeId(Some(self.0.len() - 1))
    }

    /// The value of a name; `Some(None)` of what is hidden, `None` of what is declared outside of
    /// loops.
    pub(super) fn find(&self, scope: ScopeId, name: &str) -> Option<Option<i64>> {
        self.outwards(scope).find(|scope| scope.name == name).map(|scope| scope.value)
    }

    /// `, for i = 2, j = 1`, or nothing outside of loops.
    pub(super) fn place(&self, scope: ScopeId) -> String {
        let values =
            self.outwards(scope).filter_map(|scope| Some(format!("{} = {}", scope.name, scope.value?)));
        let mut values = values.collect::<Vec<_>>();
        values.reverse();
        if values.is_empty() { String::new() } else { format!(", for {}", values.join(", ")) }
    }

    /// True if a name is that of a variable somewhere.
    pub(super) fn is_variable(&self, name: &str) -> bool {
        self.0.iter().any(|scope| scope.name == name && scope.value.is_some())
    }

    fn outwards(&self, scope: ScopeId) -> impl Iterator<Item = &LoopScope> {
        let get = |id: ScopeId| id.0.and_then(|index| self.0.get(index));
        std::iter::successors(get(scope), move |scope| get(scope.outer))
    }
}
