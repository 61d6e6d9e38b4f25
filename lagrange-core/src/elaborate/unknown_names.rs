//! Diagnostics for undefined names: each is reported once, with the number of other places.

use super::evaluator::Evaluator;
use super::messages;
use super::scope::NameKind;
use super::unresolved::{Late, Places, place};
use lagrange_expr::diagnostics::Origin;
use lagrange_language::syntax::ast::StatementKind;
use lagrange_language::syntax::foreign;

/// True if a name is written like a Rust constant, in several capital letters.
fn is_constant_of_rust(name: &str) -> bool {
    let is_capital = |c: char| c.is_ascii_uppercase() || c.is_ascii_digit() || c == '_';
    name.len() > 2 && name.chars().all(is_capital)
}

/// True if an undefined name has already been reported; this place is then only counted.
pub(super) fn is_known_unresolved(evaluator: &mut Evaluator<'_>, name: &str, origin: Origin) -> bool {
    let places = evaluator.unresolved.names.get_mut(&name.to_owned());
    places.map(|places| places.all.insert(place(origin))).is_some()
}

/// Reports an undefined name.
pub(super) fn report_unknown(
    evaluator: &mut Evaluator<'_>,
    name: &str,
    origin: Origin,
    help: impl Into<String>,
) {
    evaluator.report.error(origin, messages::names::unknown_name(name)).help(help);
    remember(evaluator, name, origin);
}

fn remember(evaluator: &mut Evaluator<'_>, name: &str, origin: Origin) {
    let mistake = evaluator.report.diagnostics().len() - 1;
    evaluator.unresolved.names.insert(name.to_owned(), Places::new(mistake, origin));
}

/// True if an unknown name is declared further down, which is reported here, or may have been
/// declared in an unreadable part. Late names of one statement are reported together.
pub(super) fn is_declared_elsewhere(evaluator: &mut Evaluator<'_>, name: &str, origin: Origin) -> bool {
    let all = evaluator.declaration;
    let places = evaluator.unresolved.declared.get_or_insert_with(|| all.places());
    let Some(&(statement, declaration)) = places.get(&name.to_owned()) else {
        return evaluator.declaration.lacks_names
            || evaluator.declaration.unreadable_words.contains(&name.to_owned());
    };
    let (late, user) = (&mut evaluator.unresolved.late, evaluator.unresolved.statement);
    let reported = late.iter().find(|late| late.user == user || late.declaration == statement).copied();
    let mistake = match reported {
        Some(late) => {
            if let Some(mistake) = evaluator.report.diagnostic_mut(late.mistake) {
                mistake.related(declaration.into(), messages::names::also_declared_here(name));
            }
            late.mistake
        }
        None => {
            let is_solved = |number: usize| {
                matches!(evaluator.declaration.statements[number].kind, StatementKind::Solve(_))
            };
            let help = match is_solved(user) && is_solved(statement) {
                true => messages::solve::TOGETHER,
                false => messages::names::ORDER_HELP,
            };
            let error = evaluator.report.error(origin, messages::names::used_too_early(name)).help(help);
            error.related(declaration.into(), messages::names::DECLARED_HERE);
            evaluator.report.diagnostics().len() - 1
        }
    };
    late.push(Late { user, declaration: statement, mistake });
    let places = Places { is_named: reported.is_none(), ..Places::new(mistake, origin) };
    evaluator.unresolved.names.insert(name.to_owned(), places);
    true
}

/// Returns true in statements that accept accelerations.
pub(super) fn may_use_accelerations(evaluator: &Evaluator<'_>) -> bool {
    use StatementKind::{Event, Function, Gibbs, Let, LetTuple, Output};
    let statement = evaluator.declaration.statements.get(evaluator.unresolved.statement);
    statement.is_some_and(|statement| {
        matches!(statement.kind, Event(_) | Function(_) | Gibbs { .. } | Let(..) | LetTuple(..) | Output(..))
    })
}

/// Returns advice for an undefined name: its spelling here, or how to declare it.
pub(super) fn help_for_unknown(evaluator: &Evaluator<'_>, name: &str) -> String {
    let moves = |name: &str| {
        let entry = evaluator.scope.find(name);
        entry.is_some_and(|entry| matches!(entry.kind, NameKind::Coordinate | NameKind::Abbreviation))
    };
    match foreign::rate(name, moves) {
        Some(rate) if rate.order == 1 || may_use_accelerations(evaluator) => {
            return messages::names::write_call(rate.written());
        }
        // A single letter next to a name may be a typo.
        Some(rate) if name.len() - rate.of.len() > 1 => {
            return messages::ONLY_OUTPUTS_HOLD_ACCELERATIONS.to_owned();
        }
        _ => {}
    }
    if let Some(meant) = foreign::letter(name).filter(|meant| evaluator.scope.find(meant).is_some()) {
        return messages::names::write_call(&meant);
    }
    if let Some(meant) = foreign::name(name) {
        return messages::names::write_call(meant);
    }
    if foreign::is_library(name) {
        return messages::names::PLAIN_NAMES_HELP.to_owned();
    }
    if foreign::is_word_for_rate(name)
        && let [single] = &evaluator.declaration.coordinates()[..]
    {
        return messages::names::rate_of_single(&single.text);
    }
    if evaluator.scope.find(&format!("{name}_qw")).is_some() {
        return messages::names::components_of_orientation(name);
    }
    match evaluator.scope.nearest(name, NameKind::has_value) {
        Some(nearest) => messages::names::did_you_mean(nearest),
        None if is_constant_of_rust(name) => messages::names::RUST_CONSTANT_HELP.to_owned(),
        None => messages::names::DECLARE_FIRST.to_owned(),
    }
}

/// Adds the number of other places to the reports of undefined names.
pub(super) fn count_unresolved(evaluator: &mut Evaluator<'_>) {
    let is_elsewhere = |places: &Places| places.is_named && places.all.len() > 1;
    for (_, places) in evaluator.unresolved.names.iter().filter(|(_, places)| is_elsewhere(places)) {
        if let Some(mistake) = evaluator.report.diagnostic_mut(places.mistake) {
            mistake.message.push_str(&messages::names::and_elsewhere(places.all.len() - 1));
        }
    }
}
