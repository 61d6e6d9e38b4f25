//! Statements as they are meant once.

use super::copier::Copier;
use super::defaults::{element_of, fits, positions};
use super::messages;
use super::paths::{Path, Target};
use super::scopes::ScopeId;
use super::unrolling::{Instance, report_nothing_left};
use super::wholes::WholeArray;
use crate::syntax::ast::{
    ArrayShape, Assignment, AstId, Definition, FrictionNames, Mobilizer, MobilizerKind, Mode, Name,
    Quaternion, Reduction, ReductionItem, ReductionKind, SceneStatement, Statement, StatementKind,
};
use lagrange_expr::collections::HashMap;
use lagrange_expr::diagnostics::Origin;

/// Returns the statements that one instance stands for: one, but for quaternions, noises and modes
/// that are declared together, and none if it is wrong.
pub(super) fn written_out(copier: &mut Copier<'_>, instance: &Instance<'_>) -> Vec<Statement> {
    let Instance { statement, scope, lines } = instance;
    let (statement, scope) = (*statement, *scope);
    let with = |kind| Statement { kind, origin: statement.origin, docs: statement.docs.clone() };
    if let Some(kinds) = given_to_elements(copier, instance) {
        return kinds.into_iter().map(with).collect();
    }
    let kind = match &statement.kind {
        StatementKind::Parameters(list) => StatementKind::Parameters(definitions(copier, list, scope)),
        StatementKind::Inputs(list) => StatementKind::Inputs(definitions(copier, list, scope)),
        StatementKind::Noises(list) => {
            let elements = definitions(copier, list, scope).into_iter();
            return elements.map(|element| with(StatementKind::Noises(vec![element]))).collect();
        }
        StatementKind::Constants(list) => StatementKind::Constants(definitions(copier, list, scope)),
        StatementKind::Coordinates(list) => StatementKind::Coordinates(definitions(copier, list, scope)),
        StatementKind::States(kind, list) => StatementKind::States(*kind, definitions(copier, list, scope)),
        StatementKind::Quaternion(quaternion) => {
            let elements = elements(copier, &quaternion.name, scope).into_iter();
            let named = |name| StatementKind::Quaternion(Box::new(Quaternion::named(name)));
            return elements.map(|(_, name)| with(named(name))).collect();
        }
        StatementKind::Mode(mode) => {
            let prefixed = |value: &Name| element(value, copier.scopes.prefixed(scope, &value.text));
            let values = mode.values.iter().map(prefixed).collect::<Vec<_>>();
            let elements = elements(copier, &mode.name, scope).into_iter();
            let of_values = |name| StatementKind::Mode(Mode { name, values: values.clone() });
            return elements.map(|(_, name)| with(of_values(name))).collect();
        }
        StatementKind::Reduce(reduction) => {
            let items = reduction.items.iter().zip(lines).flat_map(|(item, scopes)| {
                let items = scopes.iter().flat_map(|scope| reduced(copier, item, *scope));
                items.collect::<Vec<_>>()
            });
            let items = items.collect::<Vec<_>>();
            if items.is_empty() && !reduction.items.is_empty() {
                report_nothing_left(&mut copier.complaints, statement.origin);
            }
            StatementKind::Reduce(Reduction { items, ..reduction.clone() })
        }
        kind => match single(copier, (kind, statement.origin), (scope, lines)) {
            Some(kind) => kind,
            None => return Vec::new(),
        },
    };
    vec![with(kind)]
}

/// Returns a rate or a force on a whole array, for each of its elements.
fn given_to_elements(copier: &mut Copier<'_>, instance: &Instance<'_>) -> Option<Vec<StatementKind>> {
    let kind = &instance.statement.kind;
    let (StatementKind::StateRate(name, value) | StatementKind::ForceOn(name, value)) = kind else {
        return None;
    };
    let array = copier.whole_array(name, instance.scope)?;
    let value = copier.copied(*value, instance.scope);
    let of_element = |(name, value)| match kind {
        StatementKind::StateRate(..) => StatementKind::StateRate(name, value),
        _ => StatementKind::ForceOn(name, value),
    };
    Some(given_to(copier, name, &array, value).into_iter().map(of_element).collect())
}

/// Returns the elements of a whole array, each with its part of a value.
fn given_to(copier: &mut Copier<'_>, name: &Name, array: &WholeArray, value: AstId) -> Vec<(Name, AstId)> {
    let shape = ArrayShape::of_sizes(&array.sizes);
    let part = |(indices, text): &(Vec<i64>, String)| {
        (element(name, text.clone()), copier.part_given(value, indices, shape))
    };
    array.elements.iter().map(part).collect()
}

/// Returns a change to a coordinate, or one to each element of an array of them.
fn reduced(copier: &mut Copier<'_>, item: &ReductionItem, scope: ScopeId) -> Vec<ReductionItem> {
    let value = item.value.map(|value| copier.copied(value, scope));
    if let Some(array) = copier.whole_array(&item.coordinate, scope) {
        let with = |coordinate, value| reduction_item(coordinate, value, item.kind);
        return match value {
            Some(value) => {
                let given = given_to(copier, &item.coordinate, &array, value).into_iter();
                given.map(|(coordinate, value)| with(coordinate, Some(value))).collect()
            }
            None => {
                let texts = array.elements.into_iter();
                texts.map(|(_, text)| with(element(&item.coordinate, text), None)).collect()
            }
        };
    }
    let coordinate = mentioned(copier, &item.coordinate, scope).into_iter();
    coordinate.map(|coordinate| reduction_item(coordinate, value, item.kind)).collect()
}

fn reduction_item(coordinate: Name, value: Option<AstId>, kind: ReductionKind) -> ReductionItem {
    ReductionItem { coordinate, value, kind, enclosures: Vec::new() }
}

/// Returns a statement without indices.
fn single(
    copier: &mut Copier<'_>,
    (kind, origin): (&StatementKind, Origin),
    (scope, lines): (ScopeId, &[Vec<ScopeId>]),
) -> Option<StatementKind> {
    let mut kind = kind.clone();
    if let StatementKind::External(function) = &kind
        && copier.scopes.around(scope).is_some()
    {
        return copier.is_first_of(function).then_some(kind);
    }
    for name in kind.names_mut() {
        *name = mentioned(copier, name, scope)?;
    }
    match &mut kind {
        StatementKind::Scene(SceneStatement::Mobilizer(joint)) => rename_parts(joint),
        StatementKind::Scene(SceneStatement::Contact(contact)) => {
            contact.frictions = FrictionNames::of(&contact.name);
        }
        _ => {}
    }
    let mut inner = scope;
    let own = match &kind {
        StatementKind::Function(function) => &function.parameters[..],
        StatementKind::Scene(SceneStatement::Surface(surface)) => &surface.coordinates,
        _ => &[],
    };
    for name in own {
        inner = copier.scopes.hiding(inner, &name.text);
    }
    // Each in the loops around it.
    let assignments = kind.assignments_mut().map(std::mem::take);
    let mut copies: HashMap<AstId, AstId> = HashMap::default();
    for id in kind.expressions_mut() {
        *id = *copies.get_or_insert_with(*id, || copier.copied(*id, inner));
    }
    if let Some(written) = assignments
        && let Some(assignments) = kind.assignments_mut()
    {
        // What has no braces has no lines.
        let own = vec![vec![scope]; if lines.is_empty() { written.len() } else { 0 }];
        let scopes = lines.iter().chain(&own);
        *assignments = written.iter().zip(scopes).flat_map(|(one, at)| assigned(copier, one, at)).collect();
        if assignments.is_empty() && !written.is_empty() {
            report_nothing_left(&mut copier.complaints, origin);
        }
    }
    Some(kind)
}

/// Returns an assignment in each iteration of the loops around it.
fn assigned(copier: &mut Copier<'_>, assignment: &Assignment, scopes: &[ScopeId]) -> Vec<Assignment> {
    let mut all = Vec::new();
    for &scope in scopes {
        let value = copier.copied(assignment.value, scope);
        let target = copier.copied(assignment.target, scope);
        all.extend(copier.assigned(Assignment::new(target, value)));
    }
    all
}

/// Gives the parts of a joint that are made of names those of the names that it has now.
fn rename_parts(joint: &mut Mobilizer) {
    if joint.kind == MobilizerKind::Free {
        *joint = Mobilizer::free(joint.outboard.clone());
    } else if let Some(quaternion) = &mut joint.quaternion {
        *quaternion = Quaternion::named(quaternion.name.clone());
    }
}

/// Returns the meaning of a name outside expressions.
fn mentioned(copier: &mut Copier<'_>, name: &Name, scope: ScopeId) -> Option<Name> {
    let mut path = Path::of_name(name, scope);
    loop {
        let (message, help) = match path.target(copier.counting()) {
            Ok(Target::Declared(segment)) if !segment.indices.is_empty() => {
                let of = Name { span: segment.span, ..name.clone() };
                return Some(element(&of, copier.element(&segment, scope)?));
            }
            Ok(Target::Declared(segment)) => match copier.objection(&segment.text, segment.text == name.text)
            {
                Some(objection) => objection,
                None => {
                    let of = Name { span: segment.span, ..name.clone() };
                    return Some(element(&of, segment.text));
                }
            },
            Ok(Target::Expression(value, outer)) => match Path::of(copier.expressions, value, outer) {
                Some(outside) => {
                    path = outside;
                    continue;
                }
                None => (messages::needs_name(&name.text), messages::NEEDS_NAME_HELP.to_owned()),
            },
            Ok(Target::Part(part)) => copier.part_as_value(part),
            // A variable or something without members, of which nobody knows as a name.
            Ok(
                Target::Value(_)
                | Target::Hidden
                | Target::HiddenEntry(_)
                | Target::Entry(..)
                | Target::Beyond,
            ) => match name.members.is_empty() {
                true => return Some(name.clone()),
                false => (messages::no_part(&name.text), messages::no_part_help(&name.text)),
            },
            Err(fault) => {
                copier.complaints.path(&fault, copier.expressions, None, (&copier.scopes, scope));
                return None;
            }
        };
        copier.complaints.report.error(name.span, message).help(help);
        return None;
    }
}

/// Returns the elements that a name declares, with their indices; itself if it declares no array.
fn elements(copier: &mut Copier<'_>, name: &Name, scope: ScopeId) -> Vec<(Vec<i64>, Name)> {
    let base = copier.scopes.prefixed(scope, &name.text);
    if name.indices.is_empty() {
        return vec![(Vec::new(), element(name, base))];
    }
    let sizes = copier.sizes(name, scope);
    let positions = sizes.as_deref().map(positions).unwrap_or_default();
    let named = |position: Vec<i64>| {
        let text = messages::element(&base, &position);
        (position, element(name, text))
    };
    positions.into_iter().map(named).collect()
}

/// Returns the name of an element, with the unit of the array.
fn element(of: &Name, text: String) -> Name {
    Name { unit: of.unit.clone(), ..Name::new(text, of.span) }
}

fn definitions(copier: &mut Copier<'_>, list: &[Definition], scope: ScopeId) -> Vec<Definition> {
    let mut written = Vec::new();
    for Definition { name, mut range, nominal, value } in list.iter().cloned() {
        range.limits_mut().for_each(|limit| limit.value = copier.copied(limit.value, scope));
        let nominal = nominal.map(|nominal| copier.copied(nominal, scope));
        let sizes = copier.sizes(&name, scope).unwrap_or_default();
        let value = value.filter(|value| fits(copier.expressions, *value, &sizes, &mut copier.complaints));
        let mut copies: HashMap<AstId, AstId> = HashMap::default();
        for (position, name) in elements(copier, &name, scope) {
            let value = value.and_then(|value| element_of(copier.expressions, value, &position));
            let value = value.map(|id| *copies.get_or_insert_with(id, || copier.copied(id, scope)));
            written.push(Definition { name, range, nominal, value });
        }
    }
    written
}
