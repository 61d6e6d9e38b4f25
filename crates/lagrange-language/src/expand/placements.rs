//! Placements of parts: their names, their arguments, and the scope of their statements.

use std::collections::{BTreeMap, BTreeSet};

use super::complaints::Complaints;
use super::counting::Counting;
use super::defaults::element_of;
use super::messages;
use super::parts::{Part, Parts};
use super::scopes::{ArgumentValue, PlacedId, PlacedPart, ScopeId, Scopes};
use crate::syntax::ast::{
    ArrayExpression, AstId, Expression, Expressions, Name, PartDefinition, PlacedInstance, Placement,
    Statement,
};
use lagrange_expr::collections::{HashMap, HashSet, OrderedMap};
use lagrange_expr::diagnostics::{Origin, nearest};
use lagrange_expr::limits::{MAX_PARTS_NESTED, MAX_PLACED};
use lagrange_expr::number::Number;

/// Places parts.
pub(super) struct Placer<'d> {
    pub(super) parts: Parts<'d>,
    /// Placements with checked arguments, by their addresses.
    checked: HashSet<usize>,
    /// Placements with a reported error.
    reported: HashSet<usize>,
    /// True after the report that there are too many.
    is_full: bool,
    /// Placed parts, in order.
    pub(super) placed: Vec<PlacedInstance>,
    /// For each array of parts, its smallest indices, and the place and name of its first element.
    arrays: OrderedMap<String, (Vec<i64>, Origin, String)>,
}

/// The surroundings of a placement.
pub(super) struct Site<'a, 'c> {
    pub(super) expressions: &'a Expressions,
    pub(super) constants: &'a HashMap<String, Number>,
    pub(super) scopes: &'a mut Scopes,
    pub(super) complaints: &'a mut Complaints<'c>,
}

impl Site<'_, '_> {
    fn counting(&self) -> Counting<'_> {
        Counting { expressions: self.expressions, scopes: self.scopes, constants: self.constants }
    }
}

/// An element of an array of parts: its index, its position counted from zero, and the number of
/// elements.
pub(super) type Turn = Option<(i64, [i64; 2])>;

impl<'d> Placer<'d> {
    pub(super) fn new(parts: Parts<'d>) -> Placer<'d> {
        let (checked, reported) = (HashSet::default(), HashSet::default());
        let arrays = OrderedMap::default();
        Placer { parts, checked, reported, is_full: false, placed: Vec::new(), arrays }
    }

    /// Places a part once. Returns it with the scope of its statements, unless there is an error,
    /// which is reported.
    pub(super) fn place(
        &mut self,
        (statement, placement): (&Statement, &Placement),
        turn: Turn,
        scope: ScopeId,
        site: &mut Site<'_, '_>,
    ) -> Option<(&'d PartDefinition, ScopeId)> {
        let address = std::ptr::from_ref(placement).addr();
        let is_new = self.checked.insert(address);
        let part = &self.part(placement, is_new, site)?.clone();
        if is_new && !check_arguments(placement, part, site) {
            self.reported.insert(address);
        }
        if self.reported.contains(&address) || !is_possible(placement, part, scope, site) {
            return None;
        }
        if !self.has_room(1, statement, site.complaints) {
            return None;
        }
        let indices = indices(placement, turn, scope, site)?;
        if is_taken(&placement.name, &indices, scope, site) {
            return None;
        }
        let placed = self.remember((placement, part), &indices, scope, site);
        let (id, inside) = site.scopes.place(&placement.name.text, indices, placed);
        let definition = part.definition;
        for argument in &definition.arguments {
            let given = placement.arguments.iter().find(|(name, _)| name.text == argument.name.text);
            let binding = match (given, argument.default) {
                (Some((_, value)), _) => binding(*value, turn, scope, site),
                (None, Some(value)) => binding(value, None, inside, site),
                (None, None) => continue,
            };
            site.scopes.bind(id, &argument.name.text, binding);
        }
        Some((definition, inside))
    }

    /// Records the name of a placed part, whose arguments are still unknown.
    fn remember(
        &mut self,
        (placement, part): (&Placement, &Part<'_>),
        indices: &[i64],
        scope: ScopeId,
        site: &Site<'_, '_>,
    ) -> PlacedPart {
        let name = &placement.name;
        let prefix = site.scopes.prefixed(scope, &messages::element(&name.text, indices)) + "_";
        let around = site.scopes.around(scope).map_or("", |part| part.written.as_str());
        let written = format!("{around}{}", messages::written(&name.text, indices));
        let origin = Origin::from(name.span).to(placement.part.span.into());
        let first = || (indices.to_vec(), origin, written.clone());
        let (least, ..) = self.arrays.get_or_insert_with(format!("{around}{}", name.text), first);
        least.iter_mut().zip(indices).for_each(|(least, index)| *least = (*least).min(*index));
        self.placed.push(PlacedInstance {
            part: part.definition.name.text.clone(),
            definition: part.definition.origin,
            name: written.clone(),
            origin,
        });
        let (interior, outer) = (part.interior.clone(), site.scopes.part_of(scope));
        PlacedPart { interior, prefix, written: written + ".", bindings: HashMap::default(), outer }
    }

    /// True if this many parts can be placed. If not, it is reported once.
    pub(super) fn has_room(
        &mut self,
        count: usize,
        statement: &Statement,
        complaints: &mut Complaints<'_>,
    ) -> bool {
        let has_room = self.placed.len().saturating_add(count) <= MAX_PLACED;
        if !has_room && !std::mem::replace(&mut self.is_full, true) {
            let message = messages::too_many_parts(MAX_PLACED);
            complaints.report.error(statement.origin, message).help(messages::TOO_LONG_HELP);
        }
        has_room
    }

    fn part(&self, placement: &Placement, is_new: bool, site: &mut Site<'_, '_>) -> Option<&Part<'d>> {
        let name = &placement.part;
        let part = self.parts.find(&name.text);
        if part.is_none() && is_new && !site.complaints.may_be_unread(&name.text) {
            let help = match self.parts.nearest(&name.text) {
                Some(nearest) => messages::did_you_mean(nearest),
                None => messages::declare_the_part(&name.text),
            };
            site.complaints.report.error(name.span, messages::unknown_part(&name.text)).help(help);
        }
        part
    }

    /// Returns the names of parts that nothing places, except those that need not be placed.
    pub(super) fn unplaced(&self) -> Vec<Name> {
        let placed = self.placed.iter().map(|instance| instance.part.as_str()).collect::<BTreeSet<_>>();
        let unplaced = self.parts.iter().map(|part| part.definition).filter(|definition| {
            let is_meant = definition.name.text.starts_with('_') || definition.is_included;
            !is_meant && !placed.contains(definition.name.text.as_str())
        });
        unplaced.map(|definition| definition.name.clone()).collect()
    }

    /// Reports arrays of parts without a first element.
    pub(super) fn report_gaps(&self, complaints: &mut Complaints<'_>) {
        for (array, (least, origin, given)) in self.arrays.iter() {
            if least.iter().any(|index| *index > 0) {
                let first = messages::written(array, &vec![0; least.len()]);
                let error = complaints.report.error(*origin, messages::lacks_first(first, given));
                error.help(messages::ONE_ELEMENT_HELP);
            }
        }
    }
}

/// Checks the arguments of a placement.
fn check_arguments(placement: &Placement, part: &Part<'_>, site: &mut Site<'_, '_>) -> bool {
    let definition = part.definition;
    let known = definition.arguments.iter().map(|argument| argument.name.text.as_str()).collect::<Vec<_>>();
    let before = site.complaints.report.diagnostics().len();
    for (given, _) in &placement.arguments {
        // The argument may be one that could not be read.
        if known.contains(&given.text.as_str()) || site.complaints.is_partial() {
            continue;
        }
        let help = match nearest(&given.text, known.iter().copied()) {
            Some(nearest) => messages::did_you_mean(nearest),
            None => messages::arguments_are(&definition.name.text, &known),
        };
        let message = messages::unknown_argument(&given.text, &definition.name.text);
        let error = site.complaints.report.error(given.span, message);
        error.related(definition.name.span.into(), messages::FIRST_DECLARED).help(help);
    }
    // A misspelt argument is reported only once.
    if site.complaints.report.diagnostics().len() > before || site.complaints.is_partial() {
        return site.complaints.report.diagnostics().len() == before;
    }
    let is_given = |name: &str| placement.arguments.iter().any(|(given, _)| given.text == name);
    for argument in &definition.arguments {
        if argument.default.is_none() && !is_given(&argument.name.text) {
            let message = messages::missing_argument(&argument.name.text, &definition.name.text);
            let error = site.complaints.report.error(placement.part.span, message);
            let declared = Origin::from(argument.name.span);
            error.related(declared, messages::FIRST_DECLARED).help(messages::give(&argument.name.text));
        }
    }
    site.complaints.report.diagnostics().len() == before
}

/// True unless a part would contain itself, or parts are nested too deeply.
fn is_possible(placement: &Placement, part: &Part<'_>, scope: ScopeId, site: &mut Site<'_, '_>) -> bool {
    let name = &part.definition.name.text;
    let around = || site.scopes.chain(site.scopes.part_of(scope));
    let message = match around().any(|outer| outer.interior.name.text == *name) {
        true => messages::recursion(name),
        false if around().count() >= MAX_PARTS_NESTED => messages::too_deep(MAX_PARTS_NESTED),
        false => return true,
    };
    if site.complaints.once_of(std::ptr::from_ref(placement).addr()) {
        site.complaints.report.error(placement.part.span, message).help(messages::RECURSION_HELP);
    }
    false
}

/// True if a name with these indices belongs to something else, which is reported.
fn is_taken(name: &Name, indices: &[i64], scope: ScopeId, site: &mut Site<'_, '_>) -> bool {
    let outer = site.scopes.part_of(scope);
    let is_twin = |others: &BTreeMap<Vec<i64>, PlacedId>| {
        let is_other_rank = others.keys().next().is_some_and(|other| other.len() != indices.len());
        is_other_rank || others.contains_key(indices)
    };
    let message = if site.scopes.elements(outer, &name.text).is_some_and(is_twin) {
        messages::placed_twice(messages::written(&name.text, indices))
    } else if outer.is_none() && site.complaints.names.contains(&name.text)
        || site.scopes.is_local(scope, &name.text)
    {
        messages::part_and_name(&name.text)
    } else {
        return false;
    };
    if site.complaints.once_of(std::ptr::from_ref(name).addr()) {
        site.complaints.report.error(name.span, message).help(messages::OTHER_NAME_HELP);
    }
    true
}

fn indices(placement: &Placement, turn: Turn, scope: ScopeId, site: &mut Site<'_, '_>) -> Option<Vec<i64>> {
    let written = placement.name.indices.iter().map(|index| site.counting().integer(*index, scope));
    let indices = match written.collect::<Result<Vec<_>, _>>() {
        Ok(indices) => indices,
        Err(fault) => {
            site.complaints.fault(site.expressions, &fault, (&*site.scopes, scope));
            return None;
        }
    };
    let indices = indices.into_iter().chain(turn.map(|(index, _)| index)).collect::<Vec<_>>();
    if indices.iter().all(|index| *index >= 0) {
        return Some(indices);
    }
    let message = messages::negative_index(messages::written(&placement.name.text, &indices));
    if site.complaints.once_of(std::ptr::from_ref(placement).addr()) {
        site.complaints.report.error(placement.name.span, message).help(messages::FROM_ZERO_HELP);
    }
    None
}

/// Returns the value of an argument; for a list, the one at the position of the element.
fn binding(value: AstId, turn: Turn, scope: ScopeId, site: &mut Site<'_, '_>) -> ArgumentValue {
    let mut chosen = value;
    if let Expression::Array(ArrayExpression::List(values)) = site.expressions.get(value) {
        if let Some((place, message, help)) = list_fault(value, values, turn, site.expressions) {
            let origin = site.expressions.origin(place);
            if let Some(error) = site.complaints.once(value, origin, message) {
                error.help(help);
            }
        }
        chosen =
            turn.and_then(|(_, [number, _])| element_of(site.expressions, value, &[number])).unwrap_or(value);
    }
    let number = site.counting().number(chosen, scope).ok();
    ArgumentValue { value: chosen, scope, number }
}

/// Returns the error in a list of values for an array of parts: its place, the message and the
/// help.
fn list_fault(
    list: AstId,
    values: &[AstId],
    turn: Turn,
    expressions: &Expressions,
) -> Option<(AstId, String, &'static str)> {
    let Some((_, [_, count])) = turn else {
        return Some((list, messages::LIST_OUTSIDE_ARRAY.to_owned(), messages::LIST_OUTSIDE_ARRAY_HELP));
    };
    if usize::try_from(count) != Ok(values.len()) {
        return Some((list, messages::list_length(values.len(), count), messages::LIST_HELP));
    }
    let is_list =
        |value: &&AstId| matches!(expressions.get(**value), Expression::Array(ArrayExpression::List(_)));
    let inner = values.iter().find(is_list)?;
    Some((*inner, messages::LIST_IN_LIST.to_owned(), messages::LIST_HELP))
}
