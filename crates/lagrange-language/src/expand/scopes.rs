//! Scopes of names: nested variables of loops with their values, and placed parts.
//!
//! A placed part is a fresh scope: its surroundings are only accessible through its arguments.

use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

use proc_macro2::Span;

use super::messages;
use crate::syntax::ast::{AstId, Name};
use lagrange_expr::collections::{HashMap, HashSet};
use lagrange_expr::number::Number;

/// Names that are defined everywhere.
pub(super) const BUILT_IN: [&str; 3] = ["t", "pi", "ground"];

/// The loops and the placed part around a place; none by default.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Default, Debug)]
pub(super) struct ScopeId(Option<usize>);

/// A placed part.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub(super) struct PlacedId(usize);

/// All scopes of a declaration.
#[derive(Default)]
pub(super) struct Scopes {
    scopes: Vec<Scope>,
    placed: Vec<PlacedPart>,
    /// Placed parts by the part around them, their name and their indices.
    by_name: HashMap<(Option<PlacedId>, String), BTreeMap<Vec<i64>, PlacedId>>,
    /// Names of placements and of items in parts, which have other meanings elsewhere.
    scoped: HashSet<String>,
    /// Names of parts that are placed anywhere.
    interiors: HashSet<String>,
    /// The number of meanings so far of each name that is local to loops, under its name outside.
    local_counts: HashMap<String, i64>,
    /// Names that are declared outside of parts; local names must differ from them.
    declared: BTreeSet<String>,
}

struct Scope {
    outer: ScopeId,
    /// The innermost part around the scope.
    part: Option<PlacedId>,
    /// The variable of a loop; `None` inside a part and after a local name. Parameters of
    /// functions, which shadow other names, have no value.
    variable: Option<(String, Option<i64>)>,
    /// Names that are only known here.
    locals: BTreeMap<String, LocalName>,
}

/// A name that is declared anew in each iteration of a loop.
pub(super) struct LocalName {
    /// Name in the expanded declaration.
    pub(super) text: String,
    pub(super) span: Span,
}

/// Names of a part, wherever it is placed.
#[derive(Debug)]
pub(super) struct Interior {
    pub(super) name: Name,
    /// Names of its arguments.
    pub(super) arguments: BTreeSet<String>,
    /// Names that its statements declare.
    pub(super) declared: BTreeSet<String>,
    /// Names of the parts that it places.
    pub(super) placed: BTreeSet<String>,
    /// Functions of the user's crate, which keep their names.
    pub(super) external: BTreeSet<String>,
}

/// A placed part.
pub(super) struct PlacedPart {
    pub(super) interior: Rc<Interior>,
    /// Prefix of the names of its members: `leg_0_`.
    pub(super) prefix: String,
    /// The prefix as written: `leg[0].`.
    pub(super) written: String,
    /// Values of its arguments.
    pub(super) bindings: HashMap<String, ArgumentValue>,
    pub(super) outer: Option<PlacedId>,
}

/// The value of an argument.
#[derive(Clone)]
pub(super) struct ArgumentValue {
    pub(super) value: AstId,
    /// Scope of its names.
    pub(super) scope: ScopeId,
    /// Its number, if it is known at compile time.
    pub(super) number: Option<Number>,
}

/// The meaning of a name in a scope.
#[derive(Debug)]
pub(super) enum Meaning {
    /// A variable of a loop.
    Value(i64),
    /// A parameter of a function.
    Hidden,
    /// An argument of the part: an expression of another scope.
    Argument(AstId, ScopeId),
    /// A placed part, or an array of them.
    Placed,
    /// Anything else, under its name in the expanded declaration.
    Declared(String),
    /// Undefined in this part.
    Outside,
}

impl Interior {
    /// True if a name is defined in the part.
    pub(super) fn knows(&self, name: &str) -> bool {
        let sets = [&self.arguments, &self.declared, &self.placed, &self.external];
        sets.into_iter().any(|names| names.contains(name)) || BUILT_IN.contains(&name)
    }

    /// Returns the names that are defined in the part, except functions from outside.
    pub(super) fn names(&self) -> impl Iterator<Item = &str> {
        [&self.arguments, &self.declared, &self.placed].into_iter().flatten().map(String::as_str)
    }
}

impl Scopes {
    /// Creates an empty set of scopes, in a declaration of these names.
    pub(super) fn among(names: &BTreeSet<String>) -> Scopes {
        Scopes { declared: names.clone(), ..Scopes::default() }
    }

    /// Adds a scope in which a name has a value.
    pub(super) fn within(&mut self, outer: ScopeId, name: &str, value: i64) -> ScopeId {
        self.add(outer, self.part_of(outer), Some((name.to_owned(), Some(value))))
    }

    /// Adds a scope in which a name is shadowed.
    pub(super) fn hiding(&mut self, outer: ScopeId, name: &str) -> ScopeId {
        self.add(outer, self.part_of(outer), Some((name.to_owned(), None)))
    }

    /// Adds a scope for names that are only known from here on.
    pub(super) fn inside(&mut self, outer: ScopeId) -> ScopeId {
        self.add(outer, self.part_of(outer), None)
    }

    /// Places a part; returns the scope of its statements.
    pub(super) fn place(&mut self, name: &str, indices: Vec<i64>, part: PlacedPart) -> (PlacedId, ScopeId) {
        let id = PlacedId(self.placed.len());
        self.scoped.insert(name.to_owned());
        if self.interiors.insert(part.interior.name.text.clone()) {
            let Interior { arguments, declared, placed, .. } = &*part.interior;
            for name in [arguments, declared, placed].into_iter().flatten() {
                self.scoped.insert(name.clone());
            }
        }
        let key = (part.outer, name.to_owned());
        match self.by_name.get_mut(&key) {
            Some(elements) => drop(elements.insert(indices, id)),
            None => drop(self.by_name.insert(key, BTreeMap::from([(indices, id)]))),
        }
        self.placed.push(part);
        (id, self.add(ScopeId::default(), Some(id), None))
    }

    /// Declares a name that is only known in this iteration of a loop, or between these braces.
    pub(super) fn localise(&mut self, scope: ScopeId, name: &Name) {
        let base = self.prefixed(scope, &name.text);
        let mut count = self.local_counts.get(&base).copied().unwrap_or(0);
        while self.is_declared(scope, &base, (&name.text, count)) {
            count += 1;
        }
        let Some(inside) = scope.0.and_then(|index| self.scopes.get_mut(index)) else { return };
        self.scoped.insert(name.text.clone());
        let text = messages::element(&base, &[count]);
        self.local_counts.insert(base, count + 1);
        inside.locals.insert(name.text.clone(), LocalName { text, span: name.span });
    }

    /// True if a numbered name is declared around a place, or outside of parts.
    fn is_declared(&self, scope: ScopeId, base: &str, (own, number): (&str, i64)) -> bool {
        let member = messages::element(own, &[number]);
        self.declared.contains(&messages::element(base, &[number]))
            || self.around(scope).is_some_and(|part| part.interior.declared.contains(&member))
    }

    /// Returns the meaning of a name that is local to a loop around a place.
    pub(super) fn local(&self, scope: ScopeId, name: &str) -> Option<&LocalName> {
        self.outwards(scope).find_map(|scope| scope.locals.get(name))
    }

    /// True if a name is local to a loop in the part around a place, or outside of parts.
    pub(super) fn is_local(&self, scope: ScopeId, name: &str) -> bool {
        let part = self.around(scope).map_or("", |part| part.prefix.as_str());
        self.local_counts.contains(&format!("{part}{name}"))
    }

    fn add(
        &mut self,
        outer: ScopeId,
        part: Option<PlacedId>,
        variable: Option<(String, Option<i64>)>,
    ) -> ScopeId {
        self.scopes.push(Scope { outer, part, variable, locals: BTreeMap::new() });
        ScopeId(Some(self.scopes.len() - 1))
    }

    /// Sets the value of an argument.
    pub(super) fn bind(&mut self, part: PlacedId, name: &str, binding: ArgumentValue) {
        if let Some(part) = self.placed.get_mut(part.0) {
            part.bindings.insert(name.to_owned(), binding);
        }
    }

    /// Returns the innermost part around a scope.
    pub(super) fn part_of(&self, scope: ScopeId) -> Option<PlacedId> {
        self.scopes.get(scope.0?)?.part
    }

    /// Returns a placed part.
    pub(super) fn placed(&self, id: PlacedId) -> &PlacedPart {
        &self.placed[id.0]
    }

    /// Returns the part that is placed around a scope.
    pub(super) fn around(&self, scope: ScopeId) -> Option<&PlacedPart> {
        self.part_of(scope).map(|id| self.placed(id))
    }

    /// Returns a part and the parts around it, from the inside outwards.
    pub(super) fn chain(&self, part: Option<PlacedId>) -> impl Iterator<Item = &PlacedPart> {
        std::iter::successors(part.map(|id| self.placed(id)), |part| part.outer.map(|id| self.placed(id)))
    }

    /// Returns the placed parts with one name, by their indices.
    pub(super) fn elements(
        &self,
        outer: Option<PlacedId>,
        name: &str,
    ) -> Option<&BTreeMap<Vec<i64>, PlacedId>> {
        self.by_name.get(&(outer, name.to_owned()))
    }

    /// True if a name has another meaning in a part or a loop than outside, or belongs to a placed
    /// part.
    pub(super) fn is_scoped(&self, name: &str) -> bool {
        self.scoped.contains(name)
    }

    /// True if a loop is around a place, within the same part.
    pub(super) fn is_in_loop(&self, scope: ScopeId) -> bool {
        scope.0.and_then(|index| self.scopes.get(index)).is_some_and(|scope| scope.variable.is_some())
    }

    /// Returns the name in the expanded declaration of an item declared in a scope.
    pub(super) fn prefixed(&self, scope: ScopeId, name: &str) -> String {
        match (self.local(scope, name), self.around(scope)) {
            (Some(local), _) => local.text.clone(),
            (None, Some(part)) => format!("{}{name}", part.prefix),
            (None, None) => name.to_owned(),
        }
    }

    /// Returns the value of a name: `Some(None)` if it is shadowed, `None` if it is declared
    /// outside of loops.
    pub(super) fn find(&self, scope: ScopeId, name: &str) -> Option<Option<i64>> {
        let mut variables = self.outwards(scope).filter_map(|scope| scope.variable.as_ref());
        variables.find(|(variable, _)| variable == name).map(|(_, value)| *value)
    }

    /// Returns the numeric value of an argument, if it is known at compile time.
    pub(super) fn number(&self, scope: ScopeId, argument: &str) -> Option<&Number> {
        self.around(scope)?.bindings.get(&argument.to_owned())?.number.as_ref()
    }

    /// Returns the meaning of a name.
    pub(super) fn meaning(&self, scope: ScopeId, name: &str) -> Meaning {
        for around in self.outwards(scope) {
            match &around.variable {
                Some((variable, Some(value))) if variable == name => return Meaning::Value(*value),
                Some((variable, None)) if variable == name => return Meaning::Hidden,
                _ => {}
            }
            if let Some(local) = around.locals.get(name) {
                return Meaning::Declared(local.text.clone());
            }
        }
        self.member(self.part_of(scope), name)
    }

    /// Returns the meaning of a name in a part, or outside of all parts.
    pub(super) fn member(&self, part: Option<PlacedId>, name: &str) -> Meaning {
        let Some(part) = part else {
            return match self.elements(None, name) {
                Some(_) => Meaning::Placed,
                None => Meaning::Declared(name.to_owned()),
            };
        };
        let part = self.placed(part);
        if let Some(binding) = part.bindings.get(&name.to_owned()) {
            return Meaning::Argument(binding.value, binding.scope);
        }
        match &*part.interior {
            interior if interior.placed.contains(name) => Meaning::Placed,
            interior if interior.declared.contains(name) => {
                Meaning::Declared(format!("{}{name}", part.prefix))
            }
            _ if BUILT_IN.contains(&name) => Meaning::Declared(name.to_owned()),
            _ => Meaning::Outside,
        }
    }

    /// Returns `, for i = 2, j = 1` or `, in leg[0], for i = 2`; empty outside of loops and parts.
    pub(super) fn place_of(&self, scope: ScopeId) -> String {
        let variables = self.outwards(scope).filter_map(|scope| scope.variable.as_ref());
        let values = variables.filter_map(|(name, value)| Some(format!("{name} = {}", (*value)?)));
        let mut values = values.collect::<Vec<_>>();
        values.reverse();
        let part = self.around(scope).map(|part| format!(", in `{}`", part.written.trim_end_matches('.')));
        let values = if values.is_empty() { String::new() } else { format!(", for {}", values.join(", ")) };
        part.unwrap_or_default() + &values
    }

    /// True if a name belongs to a variable somewhere.
    pub(super) fn is_variable(&self, name: &str) -> bool {
        let is_valued = |(variable, value): &(String, Option<i64>)| variable == name && value.is_some();
        self.scopes.iter().any(|scope| scope.variable.as_ref().is_some_and(is_valued))
    }

    fn outwards(&self, scope: ScopeId) -> impl Iterator<Item = &Scope> {
        let get = |id: ScopeId| id.0.and_then(|index| self.scopes.get(index));
        std::iter::successors(get(scope), move |scope| get(scope.outer))
    }
}
