//! Names of elements: the array of each, and its name where arrays are written out.

use std::collections::{BTreeMap, BTreeSet};

use proc_macro2::Span;

use super::complaints::Complaints;
use super::counting::Counting;
use super::defaults::{count, positions};
use super::messages;
use super::scopes::{ScopeId, Scopes};
use super::unrolling::{Instance, Unrolled};
use crate::syntax::ast::{ArrayElement, AstId, DeclaredArray, Expressions, Name, StatementKind};
use lagrange_expr::collections::HashSet;
use lagrange_expr::collections::{HashMap, OrderedMap};
use lagrange_expr::diagnostics::Origin;
use lagrange_expr::limits::MAX_ELEMENTS;

/// All elements of a declaration.
#[derive(Default)]
pub(super) struct ElementNames {
    arrays: OrderedMap<String, Array>,
    /// Names of which only what is made of them is declared, with what follows them in the first of
    /// these.
    owners: HashMap<String, String>,
    /// Names without indices.
    plain: HashMap<String, Plain>,
    /// Names of elements, with the place of the declaration and their spelling.
    texts: HashMap<String, (Span, String)>,
    /// Members of parts that are no arrays.
    members: Vec<DeclaredArray>,
}

/// A name without indices.
#[derive(Clone)]
struct Plain {
    span: Span,
    /// Number of the statement that declares it.
    statement: usize,
    written: String,
}

/// ElementNames of one array.
struct Array {
    name: Name,
    /// Its name as it is written, with the part that it is a member of.
    written: String,
    member_of: Option<[String; 2]>,
    /// Numbers of elements, if they are declared together.
    sizes: Option<Vec<i64>>,
    /// The number of indices.
    rank: usize,
    /// Places of elements, by their indices, with what they are called.
    elements: BTreeMap<Vec<i64>, (Span, String)>,
}

impl Array {
    /// The numbers of elements in each direction, if none is missing.
    fn extents(&self) -> Option<Vec<usize>> {
        let end =
            |direction: usize| self.elements.keys().map(|indices| indices[direction] + 1).max().unwrap_or(0);
        let extents = (0..self.rank).map(|direction| usize::try_from(end(direction)));
        let extents = extents.collect::<Result<Vec<_>, _>>().ok()?;
        let count = extents.iter().fold(1, |count: usize, extent| count.saturating_mul(*extent));
        (count == self.elements.len()).then_some(extents)
    }

    fn element(&self, indices: &[i64], name: &str) -> ArrayElement {
        ArrayElement { name: name.to_owned(), written: messages::written(&self.written, indices) }
    }
}

/// True if a statement declares whole arrays rather than elements.
pub(super) fn declares_arrays(kind: &StatementKind) -> bool {
    matches!(
        kind,
        StatementKind::Parameters(_)
            | StatementKind::Inputs(_)
            | StatementKind::Constants(_)
            | StatementKind::Coordinates(_)
            | StatementKind::States(_)
            | StatementKind::Quaternion(_)
    )
}

impl ElementNames {
    /// Everything that statements declare.
    pub(super) fn of(
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

    /// True if a name is that of an array.
    pub(super) fn is_array(&self, name: &str) -> bool {
        self.arrays.get(&name.to_owned()).is_some()
    }

    /// Returns the name of an element.
    pub(super) fn text(&self, name: &str, indices: &[i64]) -> Option<&str> {
        let array = self.array(name)?;
        let suffix = self.owners.get(&name.to_owned()).map_or("", String::as_str);
        array.elements.get(indices).and_then(|(_, text)| text.strip_suffix(suffix))
    }

    /// True if elements have this name, including names that only own others, such as quaternions.
    pub(super) fn is_indexed(&self, name: &str) -> bool {
        self.array(name).is_some()
    }

    fn array(&self, name: &str) -> Option<&Array> {
        let owned = self.owners.get(&name.to_owned()).map(|suffix| format!("{name}{suffix}"));
        self.arrays.get(&owned.unwrap_or_else(|| name.to_owned()))
    }

    /// True if something is declared under a name, where names of declarations without arrays and
    /// parts are known.
    pub(super) fn is_declared(&self, text: &str, names: &BTreeSet<String>) -> bool {
        names.contains(text) || self.plain.contains(&text.to_owned())
    }

    /// Returns the spelling of an element with this name.
    pub(super) fn as_written(&self, text: &str) -> Option<&str> {
        self.texts.get(&text.to_owned()).map(|(_, written)| written.as_str())
    }

    /// An example of how an array is used.
    pub(super) fn example(&self, name: &str) -> String {
        let first = self.array(name).and_then(|array| array.elements.keys().next());
        let written = self.array(name).map_or(name, |array| array.written.as_str());
        messages::written(written, first.map_or(&[0], |first| first))
    }

    /// Why an element does not exist, in the words of the array; `None` if there is no such array.
    pub(super) fn objection(&self, name: &str, indices: &[i64]) -> Option<(String, String)> {
        let array = self.array(name)?;
        let name = array.written.as_str();
        if array.rank != indices.len() {
            return Some((
                messages::index_count(name, array.rank, indices.len()),
                messages::written_help(self.example(&array.name.text)),
            ));
        }
        let ends = array.elements.keys().next().zip(array.elements.keys().next_back());
        let (first, last) = ends?;
        let (first, last) = (messages::written(name, first), messages::written(name, last));
        let is_negative = indices.iter().any(|index| *index < 0);
        let message = match is_negative {
            true => messages::negative_index(messages::written(name, indices)),
            false => messages::no_element(messages::written(name, indices)),
        };
        let help = match &array.sizes {
            Some(_) => messages::elements_are(name, &first, &last),
            None => messages::elements_lie_between(name, &first, &last),
        };
        Some((message, help))
    }

    /// The arrays in the order of their declarations.
    pub(super) fn arrays(&self) -> Vec<DeclaredArray> {
        let arrays = self.arrays.iter().map(|(_, array)| DeclaredArray {
            name: array.name.clone(),
            sizes: array.extents(),
            elements: array
                .elements
                .iter()
                .map(|(indices, (_, name))| array.element(indices, name))
                .collect(),
            member_of: array.member_of.clone(),
        });
        arrays.chain(self.members.iter().cloned()).collect()
    }
}

struct Collector<'a, 'c> {
    elements: ElementNames,
    counting: Counting<'a>,
    complaints: &'a mut Complaints<'c>,
    /// Names without indices in loops of which that was said.
    repeated: HashSet<String>,
    /// ElementNames of arrays that are declared as a whole so far.
    count: u64,
}

/// A name that is declared.
struct DeclaredName<'a> {
    /// The name in the text, with its indices.
    name: &'a Name,
    /// Rest of the intended name.
    suffix: &'a str,
    scope: ScopeId,
    /// Number of the statement, as that of its place in memory.
    statement: usize,
}

impl Collector<'_, '_> {
    /// Counts the elements of whole arrays; false from the first one on that is too large, which is
    /// reported.
    fn has_room(&mut self, instance: &Instance<'_>) -> bool {
        let Instance { statement, scope } = *instance;
        if !declares_arrays(&statement.kind) || self.counting.scopes.is_in_loop(scope) {
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
        let Instance { statement, scope } = *instance;
        let kind = &statement.kind;
        if matches!(kind, StatementKind::External(_)) && self.counting.scopes.around(scope).is_some() {
            // It keeps its name.
            return;
        }
        let is_whole = declares_arrays(kind);
        for (name, suffix) in kind.written_names() {
            let declared = DeclaredName {
                name,
                suffix: &suffix,
                scope,
                statement: std::ptr::from_ref(statement).addr(),
            };
            match (&name.indices[..], is_whole) {
                ([], _) => self.plain(&declared),
                (_, true) => self.array(&declared),
                (_, false) => self.element(&declared),
            }
        }
    }

    fn plain(&mut self, declared: &DeclaredName<'_>) {
        let DeclaredName { name, suffix, scope, statement } = *declared;
        let own = format!("{}{suffix}", name.text);
        let text = self.counting.scopes.prefixed(scope, &own);
        let written = self.written(scope, &own);
        let plain = Plain { span: name.span, statement, written };
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
        self.member(&own, &text, declared);
        if let Some(array) = self.elements.arrays.get(&text) {
            let before = array.name.span;
            return self.clash(name, before, messages::array_and_name(&text));
        }
        if let Some((before, _)) = self.elements.texts.get(&text).cloned() {
            self.clash(name, before, messages::same_text(&text));
        }
    }

    /// `theta[n]` of a statement that declares all elements.
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

    /// `p[i + 1]` of a statement that declares one element.
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

    /// Adds an element; says whether there was none of its name.
    fn add(&mut self, declared: &DeclaredName<'_>, sizes: Option<&[i64]>, indices: Vec<i64>) -> bool {
        let DeclaredName { name, suffix, scope, .. } = *declared;
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
            let new = Array { name: of_array, written, member_of, sizes, rank, elements };
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

    /// A name with the part that it is a member of, as it is written.
    fn written(&self, scope: ScopeId, own: &str) -> String {
        let part = self.counting.scopes.around(scope);
        part.map_or_else(|| own.to_owned(), |part| format!("{}{own}", part.written))
    }

    /// Remembers how a member of a part is written.
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

    fn clash(&mut self, name: &Name, before: Span, message: String) {
        let error = match name.indices.first() {
            Some(index) => self.complaints.once(*index, name.span.into(), message),
            None => Some(self.complaints.report.error(name.span, message)),
        };
        let Some(error) = error else { return };
        error.related(Origin::from(before), messages::FIRST_DECLARED).help(messages::OTHER_NAME_HELP);
    }
}

/// The indices behind a name as integers; what is wrong about them is reported.
pub(super) fn indices_of(
    name: &Name,
    scope: ScopeId,
    counting: Counting<'_>,
    complaints: &mut Complaints<'_>,
) -> Option<Vec<i64>> {
    let indices = name.indices.iter().map(|index| (*index, scope)).collect::<Vec<_>>();
    counted_indices(&indices, counting, complaints)
}

/// Indices as integers, each in its scope; what is wrong about them is reported.
pub(super) fn counted_indices(
    indices: &[(AstId, ScopeId)],
    counting: Counting<'_>,
    complaints: &mut Complaints<'_>,
) -> Option<Vec<i64>> {
    let counted = indices
        .iter()
        .map(|(index, scope)| counting.integer(*index, *scope).map_err(|fault| (fault, *scope)));
    match counted.collect::<Result<Vec<_>, _>>() {
        Ok(indices) => Some(indices),
        Err((fault, scope)) => {
            complaints.fault(counting.expressions, &fault, (counting.scopes, scope));
            None
        }
    }
}
