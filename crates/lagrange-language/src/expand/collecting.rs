//! Collection of the elements that statements declare.

use std::collections::BTreeMap;

use proc_macro2::Span;

use super::complaints::Complaints;
use super::counting::Counting;
use super::defaults::{count, positions};
use super::elements::{Array, ElementNames, Plain};
use super::indices::indices_of;
use super::messages;
use super::scopes::{ScopeId, Scopes};
use super::unrolling::{Instance, Unrolled};
use crate::syntax::ast::{ArrayElement, DeclaredArray, Expressions, Name, StatementKind};
use lagrange_expr::collections::HashSet;
use lagrange_expr::diagnostics::Origin;
use lagrange_expr::limits::MAX_ELEMENTS;

/// Collects everything that statements declare.
pub(super) fn declared_elements(
    unrolled: &Unrolled<'_>,
    expressions: &Expressions,
    scopes: &Scopes,
    complaints: &mut Complaints<'_>,
) -> ElementNames {
    let counting = Counting { expressions, scopes, constants: &unrolled.constants };
    let elements = ElementNames::default();
    let repeated = HashSet::default();
    let mut collector = Collector { elements, counting, complaints, repeated, count: 0 };
    if unrolled.instances.iter().all(|instance| collector.has_room(instance)) {
        unrolled.instances.iter().for_each(|instance| collector.instance(instance));
    }
    collector.elements
}

struct Collector<'a, 'c> {
    elements: ElementNames,
    counting: Counting<'a>,
    complaints: &'a mut Complaints<'c>,
    /// Names without indices in loops that have been reported.
    repeated: HashSet<String>,
    /// Number of elements of whole arrays declared so far.
    count: u64,
}

/// A declared name.
struct DeclaredName<'a> {
    /// The name in the text, with its indices.
    name: &'a Name,
    /// Rest of the intended name.
    suffix: &'a str,
    scope: ScopeId,
    /// Identifier of the statement: its address in memory.
    statement: usize,
    kind: &'a StatementKind,
}

impl Collector<'_, '_> {
    /// Counts the elements of whole arrays; false once there are too many, which is reported.
    fn has_room(&mut self, instance: &Instance<'_>) -> bool {
        let Instance { statement, scope, .. } = *instance;
        if !statement.kind.declares_arrays() || self.counting.scopes.is_in_loop(scope) {
            return true;
        }
        for (name, _) in statement.kind.written_names() {
            let sizes = if name.indices.is_empty() { None } else { self.indices(name, scope) };
            self.count = self.count.saturating_add(sizes.and_then(|sizes| count(&sizes)).unwrap_or(0));
            if self.count > MAX_ELEMENTS {
                let error =
                    self.complaints.report.error(name.span, messages::too_many_elements(MAX_ELEMENTS));
                error.help(messages::SIZE_HELP);
                return false;
            }
        }
        true
    }

    fn instance(&mut self, instance: &Instance<'_>) {
        let Instance { statement, scope, .. } = *instance;
        let kind = &statement.kind;
        if matches!(kind, StatementKind::External(_)) && self.counting.scopes.around(scope).is_some() {
            // It keeps its name.
            return;
        }
        let is_whole = kind.declares_arrays();
        for (name, suffix) in kind.written_names() {
            let declared = DeclaredName {
                name,
                suffix: &suffix,
                scope,
                statement: std::ptr::from_ref(statement).addr(),
                kind,
            };
            match (&name.indices[..], is_whole) {
                ([], _) => self.plain(&declared),
                (_, true) => self.array(&declared),
                (_, false) => self.element(&declared),
            }
        }
    }

    fn plain(&mut self, declared: &DeclaredName<'_>) {
        let DeclaredName { name, suffix, scope, statement, kind } = *declared;
        let own = format!("{}{suffix}", name.text);
        let text = self.counting.scopes.prefixed(scope, &own);
        let written = self.written(scope, &own);
        let is_let = matches!(kind, StatementKind::Let(..) | StatementKind::LetTuple(..));
        let plain = Plain { span: name.span, statement, written, is_let };
        if let Some(other) = self.elements.plain.insert(text.clone(), plain.clone()) {
            // Two statements with the same name are reported where names are resolved.
            if other.written != plain.written {
                return self.clash(name, other.span, messages::same_text(&text));
            }
            if other.statement == statement && self.repeated.insert(text.clone()) {
                let error = self.complaints.report.error(name.span, messages::declared_again(&own));
                error.help(messages::declared_again_help(&own));
            }
            return;
        }
        match self.counting.scopes.local(scope, &own) {
            Some(_) => self.local(&own, &text, declared),
            None => self.member(&own, &text, declared),
        }
        if let Some(array) = self.elements.arrays.get(&text) {
            let before = array.name.span;
            return self.clash(name, before, messages::array_and_name(&text));
        }
        if let Some((before, _)) = self.elements.texts.get(&text).cloned() {
            self.clash(name, before, messages::same_text(&text));
        }
    }

    /// Collects `theta[n]` of a statement that declares all elements.
    fn array(&mut self, declared: &DeclaredName<'_>) {
        let DeclaredName { name, scope, .. } = *declared;
        if self.counting.scopes.is_in_loop(scope) {
            if let Some(error) =
                self.complaints.once(name.indices[0], name.span.into(), messages::array_in_loop(&name.text))
            {
                error.help(messages::ARRAY_IN_LOOP_HELP);
            }
            return;
        }
        let Some(sizes) = self.indices(name, scope) else { return };
        if count(&sizes).is_none() {
            return self.no_size(name, &sizes);
        }
        for position in positions(&sizes) {
            if !self.add(declared, Some(&sizes), position) {
                return;
            }
        }
    }

    /// Collects `p[i + 1]` of a statement that declares one element.
    fn element(&mut self, declared: &DeclaredName<'_>) {
        let DeclaredName { name, scope, .. } = *declared;
        let Some(indices) = self.indices(name, scope) else { return };
        let negative = name.indices.iter().zip(&indices).find(|(_, index)| **index < 0);
        if let Some((place, _)) = negative {
            let origin = self.counting.expressions.origin(*place);
            let place_in_loop = self.counting.scopes.place_of(scope);
            let message = format!(
                "{}{place_in_loop}",
                messages::negative_index(messages::written(&name.text, &indices))
            );
            if let Some(error) = self.complaints.once(*place, origin, message) {
                error.help(messages::FROM_ZERO_HELP);
            }
            return;
        }
        self.add(declared, None, indices);
    }

    fn no_size(&mut self, name: &Name, sizes: &[i64]) {
        let Some((place, size)) = name.indices.iter().zip(sizes).find(|(_, size)| **size <= 0) else {
            return;
        };
        let origin = self.counting.expressions.origin(*place);
        if let Some(error) = self.complaints.once(*place, origin, messages::no_size(&name.text, *size)) {
            error.help(messages::SIZE_HELP);
        }
    }

    fn indices(&mut self, name: &Name, scope: ScopeId) -> Option<Vec<i64>> {
        indices_of(name, scope, self.counting, self.complaints)
    }

    /// Adds an element; true if its name is new.
    fn add(&mut self, declared: &DeclaredName<'_>, sizes: Option<&[i64]>, indices: Vec<i64>) -> bool {
        let DeclaredName { name, suffix, scope, kind, .. } = *declared;
        let scopes = self.counting.scopes;
        let (own, base) = (format!("{}{suffix}", name.text), scopes.prefixed(scope, &name.text));
        let (array, text) =
            (format!("{base}{suffix}"), format!("{}{suffix}", messages::element(&base, &indices)));
        let written = self.written(scope, &own);
        if !suffix.is_empty() && !self.elements.is_array(&base) {
            self.elements.owners.get_or_insert_with(base, || suffix.to_owned());
        }
        let of_array = Name::new(array.as_str(), name.span);
        if let Some(before) = self.elements.plain.get(&array).map(|plain| plain.span) {
            self.clash(name, before, messages::array_and_name(&array));
            return false;
        }
        if !self.elements.arrays.contains(&array) {
            let sizes = sizes.map(<[i64]>::to_vec);
            let (rank, elements) = (indices.len(), BTreeMap::new());
            let member_of = scopes.around(scope).map(|part| [part.interior.name.text.clone(), own]);
            let written = written.clone();
            let (has_values, is_callable) = (kind.declares_values(), kind.declares_callables());
            let new =
                Array { name: of_array, written, member_of, sizes, rank, has_values, is_callable, elements };
            self.elements.arrays.insert(array.clone(), new);
        }
        let Some(known) = self.elements.arrays.get_mut(&array) else { return false };
        let (rank, before) = (known.rank, known.name.span);
        let clash = match known.elements.get(&indices) {
            Some((first, _)) => {
                Some((*first, messages::element_twice(messages::written(&written, &indices))))
            }
            None if rank != indices.len() => {
                Some((before, messages::index_count(&written, rank, indices.len())))
            }
            None if sizes.is_none() && known.sizes.is_some() => {
                Some((before, messages::declared_as_whole(&written)))
            }
            None => None,
        };
        let as_written = messages::written(&written, &indices);
        if clash.is_none() {
            known.elements.insert(indices, (name.span, text.clone()));
        }
        let other = self.elements.texts.insert(text.clone(), (name.span, as_written)).map(|(span, _)| span);
        let plain = self.elements.plain.get(&text).map(|plain| plain.span);
        let clash = clash.or_else(|| Some((other.or(plain)?, messages::same_text(&text))));
        if let Some((before, message)) = clash {
            self.clash(name, before, message);
            return false;
        }
        true
    }

    /// Returns a name with the part that it is a member of, as it is written.
    fn written(&self, scope: ScopeId, own: &str) -> String {
        let part = self.counting.scopes.around(scope);
        part.map_or_else(|| own.to_owned(), |part| format!("{}{own}", part.written))
    }

    /// Records the spelling of a member of a part.
    fn member(&mut self, own: &str, text: &str, declared: &DeclaredName<'_>) {
        let DeclaredName { name, scope, .. } = *declared;
        let Some(part) = self.counting.scopes.around(scope) else { return };
        let written = self.written(scope, own);
        self.elements.members.push(DeclaredArray {
            name: Name::new(text, name.span),
            sizes: Some(Vec::new()),
            elements: vec![ArrayElement { name: text.to_owned(), written }],
            member_of: Some([part.interior.name.text.clone(), own.to_owned()]),
        });
    }

    /// Records a name that is local to a loop, with its meaning in this iteration.
    fn local(&mut self, own: &str, text: &str, declared: &DeclaredName<'_>) {
        let DeclaredName { name, scope, statement, .. } = *declared;
        let new = || DeclaredArray {
            name: Name::new(own, name.span),
            sizes: None,
            elements: Vec::new(),
            member_of: None,
        };
        let written = self.written(scope, own);
        let local = self.elements.locals.get_or_insert_with((statement, own.to_owned()), new);
        local.elements.push(ArrayElement { name: text.to_owned(), written });
    }

    fn clash(&mut self, name: &Name, before: Span, message: String) {
        let error = match name.indices.first() {
            Some(index) => self.complaints.once(*index, name.span.into(), message),
            None => Some(self.complaints.report.error(name.span, message)),
        };
        let Some(error) = error else { return };
        error.related(Origin::from(before), messages::FIRST_DECLARED).help(messages::OTHER_NAME_HELP);
    }
}
