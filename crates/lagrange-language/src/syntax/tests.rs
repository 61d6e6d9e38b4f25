mod bodies;
mod expressions;
mod facts;
mod functions;
mod habits;
mod header;
mod limits;
mod mistakes;
mod print;
mod statements;
mod systems;
mod units;

use super::ast::{
    Action, Assignment, AstId, BinaryOperator, Block, Declaration, Definition, EmitItem, Expression,
    Expressions, Friction, Name, Reduction, ReductionItem, StatementKind,
};
use super::parse_text;
use lagrange_expr::diagnostics::Report;

/// Reads a declaration without errors.
fn read(text: &str) -> Declaration {
    let mut report = Report::default();
    let declaration = parse_text(text, &mut report);
    assert!(report.diagnostics().is_empty(), "{text}\n{report}");
    declaration.expect("a report without errors comes with a declaration")
}

/// Returns the readable part of a text, and the report.
fn read_wrong(text: &str) -> (Option<Declaration>, String) {
    let mut report = Report::default();
    let declaration = parse_text(text, &mut report);
    assert!(report.has_errors(), "{text}");
    (declaration, report.to_string())
}

/// Returns the first lines of all errors, without help.
fn errors(text: &str) -> Vec<String> {
    let mut report = Report::default();
    parse_text(text, &mut report);
    let lines = report.to_string().lines().map(str::to_owned).collect::<Vec<_>>();
    lines.into_iter().filter(|line| !line.starts_with(' ')).collect()
}

/// Formats an expression as nested lists, operators first.
fn shown(expressions: &Expressions, id: AstId) -> String {
    let show = |id: AstId| shown(expressions, id);
    let list = |head: &str, parts: &[AstId]| {
        let parts = parts.iter().map(|&part| format!(" {}", show(part))).collect::<String>();
        format!("({head}{parts})")
    };
    match expressions.get(id) {
        Expression::Number(number) => number.to_string(),
        Expression::Name(name) => name.clone(),
        Expression::Tuple(parts) => list("vector", parts),
        Expression::Negate(inner) => list("-", &[*inner]),
        Expression::Binary(operator, _, left, right) => list(sign(*operator), &[*left, *right]),
        Expression::Call(function, arguments) => list(&function.text, arguments),
        Expression::Component(vector, name) => list(&format!(".{}", name.text), &[*vector]),
        Expression::If { condition, then, otherwise } => {
            let condition_list = list(condition.relation.sign(), &[condition.left, condition.right]);
            format!("(if {condition_list} {} {})", show(*then), show(*otherwise))
        }
        Expression::Array(_) | Expression::Quantity(..) | Expression::Entry { .. } => {
            super::print::expression(expressions, id)
        }
        Expression::Invalid => "?".to_owned(),
    }
}

fn sign(operator: BinaryOperator) -> &'static str {
    match operator {
        BinaryOperator::Add => "+",
        BinaryOperator::Subtract => "-",
        BinaryOperator::Multiply => "*",
        BinaryOperator::Divide => "/",
        BinaryOperator::Power => "^",
        BinaryOperator::Remainder => "%",
    }
}

/// Formats a statement as nested lists, its kind first.
fn statement(declaration: &Declaration, kind: &StatementKind) -> String {
    let show = |&id: &AstId| shown(&declaration.expressions, id);
    let assigned = |assignments: &[Assignment]| {
        let assign = |a: &Assignment| format!("({} {})", show(&a.target), show(&a.value));
        assignments.iter().map(assign).collect::<Vec<_>>().join(" ")
    };
    let names = |names: &[Name]| names.iter().map(|name| name.text.as_str()).collect::<Vec<_>>().join(" ");
    let definitions = |definitions: &[Definition]| {
        let define = |definition: &Definition| match &definition.value {
            Some(value) => format!("({} {})", definition.name.text, show(value)),
            None => definition.name.text.clone(),
        };
        definitions.iter().map(define).collect::<Vec<_>>().join(" ")
    };
    let assignments = |list: &[Assignment]| {
        list.iter().map(|a| format!(" ({} {})", show(&a.target), show(&a.value))).collect::<String>()
    };
    match kind {
        StatementKind::Parameters(list) => format!("param {}", definitions(list)),
        StatementKind::Inputs(list) => format!("input {}", definitions(list)),
        StatementKind::Noises(list) => format!("noise {}", definitions(list)),
        StatementKind::Constants(list) => format!("const {}", definitions(list)),
        StatementKind::Coordinates(list) => format!("coord {}", definitions(list)),
        StatementKind::States(kind, list) => format!("{} {}", kind.keyword(), definitions(list)),
        StatementKind::Mode(mode) => format!("mode {} {}", mode.name.text, names(&mode.values)),
        StatementKind::Start(list) => format!("start{}", assignments(list)),
        StatementKind::History(list) => format!("history{}", assignments(list)),
        StatementKind::Ranges(entries) => {
            let shown = entries.iter().map(|entry| {
                format!(
                    " ({})",
                    entry.values().chain([entry.target]).map(|id| show(&id)).collect::<Vec<_>>().join(" ")
                )
            });
            format!("range{}", shown.collect::<String>())
        }
        StatementKind::RateEquation(difference) => format!("0 = {}", show(difference)),
        StatementKind::StateRate(name, value) => format!("dot({}) {}", name.text, show(value)),
        StatementKind::Quaternion(quaternion) => format!("quaternion {}", quaternion.name.text),
        StatementKind::Velocity(name, value) => format!("velocity {} {}", name.text, show(value)),
        StatementKind::Let(name, value) => format!("let {} {}", name.text, show(value)),
        StatementKind::Delay { name, signal, lag } => {
            format!("let {} (delay {} {})", name.text, show(signal), show(lag))
        }
        StatementKind::Function(function) => {
            format!("let {} ({}) {}", function.name.text, names(&function.parameters), show(&function.value))
        }
        StatementKind::LetTuple(list, value) => format!("let ({}) {}", names(list), show(value)),
        StatementKind::Kinetic(value) => format!("kinetic {}", show(value)),
        StatementKind::Potential(value) => format!("potential {}", show(value)),
        StatementKind::Lagrangian(value) => format!("lagrangian {}", show(value)),
        StatementKind::Gibbs { function, stated } => format!("gibbs {} for {}", show(function), show(stated)),
        StatementKind::Dissipation(value) => format!("dissipation {}", show(value)),
        StatementKind::ForceOn(name, value) => format!("force {} {}", name.text, show(value)),
        StatementKind::ForceAt { force, point } => format!("force {} at {}", show(force), show(point)),
        StatementKind::ForceAlong { force, velocity } => {
            format!("force {} along {}", show(force), show(velocity))
        }
        StatementKind::Torque { moment, angle } => format!("torque {} on {}", show(moment), show(angle)),
        StatementKind::Constraint(name, value) => format!("constraint {} {}", name.text, show(value)),
        StatementKind::Stabilise(rate) => format!("stabilise {}", show(rate)),
        StatementKind::Every(clock) => {
            format!("every {} {}", show(&clock.period), assigned(&clock.assignments))
        }
        StatementKind::Event(event) => {
            let action = match &event.action {
                Action::Stop => "stop".to_owned(),
                Action::Record => "record".to_owned(),
                Action::Impact(restitution) => format!("impact {}", show(restitution)),
                Action::Assign(assignments) => assigned(assignments),
            };
            format!("event {} {} {:?} {action}", event.name.text, show(&event.value), event.direction)
        }
        StatementKind::Friction(Friction { name, slip, kinetic, fixed, width, .. }) => {
            let mut text = format!("friction {} {} {}", name.text, show(slip), show(kinetic));
            text.extend(fixed.map(|fixed| format!(" static {}", show(&fixed))));
            text.extend(width.map(|width| format!(" smooth {}", show(&width))));
            text
        }
        StatementKind::Output(name, value) => format!("output {} {}", name.text, show(value)),
        StatementKind::Emit(items) => {
            let item = |item: &EmitItem| match item.wanted {
                true => format!(" {}", item.product.text),
                false => format!(" -{}", item.product.text),
            };
            format!("emit{}", items.iter().map(item).collect::<String>())
        }
        StatementKind::Reduce(Reduction { name, items }) => {
            let item = |item: &ReductionItem| {
                let value = item.value.map_or(String::new(), |value| format!(" {}", show(&value)));
                format!(" ({:?} {}{value})", item.kind, item.coordinate.text)
            };
            format!("reduce {}{}", name.text, items.iter().map(item).collect::<String>())
        }
        StatementKind::External(_) | StatementKind::Table(_) | StatementKind::Solve(_) => {
            functions::callable(declaration, kind)
        }
        StatementKind::Block(Block::Repeat(repetition)) => {
            let body = repetition.body.iter().map(|inner| statement(declaration, &inner.kind));
            format!("for {} ({})", repetition.variable.text, body.collect::<Vec<_>>().join(" "))
        }
        StatementKind::Block(Block::Select(selection)) => format!("if {}", selection.branches.len()),
        StatementKind::Block(Block::Part(part)) => {
            format!("part {} {}", part.name.text, part.arguments.len())
        }
        StatementKind::Block(Block::Place(placement)) => {
            format!("place {} {}", placement.name.text, placement.part.text)
        }
        StatementKind::Block(Block::Include(path)) => format!("include {}", path.text),
        StatementKind::Scene(scene) => bodies::scene(declaration, scene),
    }
}

/// Formats all statements of a declaration, one string each.
fn statements(declaration: &Declaration) -> Vec<String> {
    declaration.statements.iter().map(|one| statement(declaration, &one.kind)).collect()
}
