//! Tables: checks and interpolation of their points.

use super::elaborator::Elaborator;
use super::expression::value_of;
use super::messages::tables as words;
use super::opaque::define;
use lagrange_expr::diagnostics::{Diagnostic, Origin};
use lagrange_expr::expr::evaluate;
use lagrange_expr::expr::{Dependencies, ExprId, Node};
use lagrange_expr::limits::MAX_POINTS;
use lagrange_expr::opaque::{Interpolation, Opaque, OpaqueFunction, Source, Table, default_name};
use lagrange_language::syntax::ast::{
    AstId, Name, Statement, StatementKind, TableDefinition, TableGrid, TableSource,
};
use lagrange_language::tables::messages as shared;
use std::cmp::Ordering;

/// Number of coefficients for each point up to which tables have the maximum number of points: that
/// of natural tables of two arguments.
const MANY_COEFFICIENTS: usize = 16;

/// A point with its place in the declaration or its line in a file.
struct Point {
    /// Arguments, then the value.
    components: Vec<f64>,
    place: Origin,
    line: Option<usize>,
}

/// Declares a table. Invalid points are reported, and the table is then declared without values.
pub(super) fn define_table(elaborator: &mut Elaborator<'_>, table: &TableDefinition) {
    let points = points(elaborator, table).filter(|points| {
        // Points of one argument are listed like a curve, those of a grid in any order.
        table.parameters.len() > 1 || ascend(elaborator, table, points)
    });
    let source = points.and_then(|points| on_grid(elaborator, table, points));
    if let Some((source, values)) = &source {
        let name = &table.name;
        if !source.is_finite() {
            let error = elaborator.evaluator.report.error(name.span, words::too_steep(&name.text));
            error.help(words::TOO_STEEP_HELP);
        } else if !source.goes_through(values) {
            let error = elaborator.evaluator.report.error(name.span, words::too_uneven(&name.text));
            error.help(words::TOO_UNEVEN_HELP);
        }
    }
    let parameters = table.parameters.iter().map(|parameter| parameter.text.clone()).collect();
    let function = source.map(|(source, _)| {
        let source = Source::Table(source);
        Opaque::value_of(OpaqueFunction { name: table.name.text.clone(), parameters, source })
    });
    define(&mut elaborator.evaluator, &table.name, function);
}

/// Returns the points as numbers, if there are neither too few nor too many.
fn points(elaborator: &mut Elaborator<'_>, table: &TableDefinition) -> Option<Vec<Point>> {
    let points = match &table.source {
        TableSource::Points(points) => {
            let points = points.iter().map(|(point, place)| {
                let components = numbers(elaborator, point)?;
                Some(Point { components, place: *place, line: None })
            });
            points.collect::<Vec<_>>().into_iter().collect::<Option<Vec<_>>>()?
        }
        TableSource::Grid(grid) => points_of_grid(elaborator, table, grid)?,
        TableSource::File { path, contents } => {
            let Some(contents) = contents else {
                report_unread(elaborator, path);
                return None;
            };
            let points = contents.points.iter().map(|(line, components)| Point {
                components: components.clone(),
                place: path.span.into(),
                line: Some(*line),
            });
            points.collect()
        }
    };
    let report = &mut elaborator.evaluator.report;
    if points.len() < 2 {
        report
            .error(table.name.span, words::too_few(&table.name.text, points.len()))
            .help(words::TOO_FEW_HELP);
        return None;
    }
    let per_point = table.interpolation.coefficients().pow(table.parameters.len() as u32);
    let most = MAX_POINTS * MANY_COEFFICIENTS / per_point.max(MANY_COEFFICIENTS);
    if points.len() > most {
        let message = shared::too_many(&table.name.text, points.len(), most);
        report.error(table.name.span, message).help(shared::TOO_MANY_HELP);
        return None;
    }
    Some(points)
}

/// Returns the points of a grid, row by row.
fn points_of_grid(
    elaborator: &mut Elaborator<'_>,
    table: &TableDefinition,
    TableGrid { axes, rows }: &TableGrid,
) -> Option<Vec<Point>> {
    let along = axes.each_ref().map(|axis| numbers(elaborator, axis));
    let values = rows.iter().map(|row| numbers(elaborator, row)).collect::<Vec<_>>();
    let [Some(along_rows), Some(along_columns)] = along else { return None };
    for ((knots, syntax), name) in [&along_rows, &along_columns].into_iter().zip(axes).zip(&table.parameters)
    {
        if let Some(i) = knots.windows(2).position(|pair| pair[0] >= pair[1]) {
            let message = shared::not_ascending(&name.text, knots[i], knots[i + 1]);
            return elaborator.evaluator.refuse(syntax[i + 1], message, shared::AXIS_ASCENDS_HELP);
        }
    }
    let mut points = Vec::new();
    for ((x, values), syntax) in along_rows.iter().zip(values).zip(rows) {
        let row = along_columns.iter().zip(values?).zip(syntax);
        points.extend(row.map(|((y, value), syntax)| Point {
            components: vec![*x, *y, value],
            place: elaborator.evaluator.origin(*syntax),
            line: None,
        }));
    }
    Some(points)
}

/// Returns constant numbers; every other expression is reported.
fn numbers(elaborator: &mut Elaborator<'_>, syntax: &[AstId]) -> Option<Vec<f64>> {
    let numbers = syntax.iter().map(|&syntax| number(elaborator, syntax)).collect::<Vec<_>>();
    numbers.into_iter().collect()
}

/// Reports that a file was not read, unless the reason has been reported.
fn report_unread(elaborator: &mut Elaborator<'_>, path: &Name) {
    let report = &mut elaborator.evaluator.report;
    if !report.has_errors() {
        report.error(path.span, words::UNREAD).help(words::UNREAD_HELP);
    }
}

/// Returns a constant number.
fn number(elaborator: &mut Elaborator<'_>, syntax: AstId) -> Option<f64> {
    value_of(&mut elaborator.evaluator, syntax)?;
    let value = elaborator.evaluator.scalar(syntax, "a number of a table")?;
    let dependencies = elaborator.evaluator.graph.dependencies(value);
    if dependencies != Dependencies::NONE {
        let (place, _) = elaborator.evaluator.blame(syntax, dependencies);
        elaborator.evaluator.report.error(place, words::NOT_CONSTANT).help(words::NOT_CONSTANT_HELP);
        return None;
    }
    let number = evaluate(&elaborator.evaluator.graph, &[value], |_| f64::NAN)[0];
    if !number.is_finite() {
        return elaborator.evaluator.refuse(syntax, words::NOT_FINITE, words::NOT_FINITE_HELP);
    }
    Some(number)
}

/// True if the arguments of the points ascend; otherwise it is reported.
fn ascend(elaborator: &mut Elaborator<'_>, table: &TableDefinition, points: &[Point]) -> bool {
    for pair in points.windows(2) {
        let [before, after] = [pair[0].components[0], pair[1].components[0]];
        if before >= after {
            let message = shared::not_ascending(&table.parameters[0].text, before, after);
            report_point(elaborator, &pair[1], &message).help(words::NOT_ASCENDING_HELP);
            return false;
        }
    }
    true
}

/// Returns a table with its values in the order of its axes, from the points of a grid in any
/// order.
fn on_grid(
    elaborator: &mut Elaborator<'_>,
    table: &TableDefinition,
    mut points: Vec<Point>,
) -> Option<(Table, Vec<f64>)> {
    let count = table.parameters.len();
    let axes = axes(elaborator, table, &points)?;
    points.sort_by(|a, b| {
        let pairs = a.components.iter().zip(&b.components).take(count);
        pairs.fold(Ordering::Equal, |order, (a, b)| order.then(a.total_cmp(b)))
    });
    each_once(elaborator, table, (&axes, &points))?;
    let values = points.iter().map(|point| point.components[count]).collect::<Vec<_>>();
    Some((Table::new(axes, &values, table.interpolation, table.outside), values))
}

/// Returns the values of each argument in ascending order; at least two are needed.
fn axes(elaborator: &mut Elaborator<'_>, table: &TableDefinition, points: &[Point]) -> Option<Vec<Vec<f64>>> {
    let axis = |argument: usize| {
        let mut knots = points.iter().map(|point| point.components[argument]).collect::<Vec<_>>();
        knots.sort_by(f64::total_cmp);
        knots.dedup();
        knots
    };
    let axes = (0..table.parameters.len()).map(axis).collect::<Vec<_>>();
    let flat = axes.iter().zip(&table.parameters).find(|(knots, _)| knots.len() < 2);
    if let Some((_, name)) = flat {
        let report = &mut elaborator.evaluator.report;
        let message = words::flat_grid(&table.name.text, &name.text);
        report.error(table.name.span, message).help(words::TOO_FEW_HELP);
        return None;
    }
    Some(axes)
}

/// Checks that ordered points are those of a grid, each once.
fn each_once(
    elaborator: &mut Elaborator<'_>,
    table: &TableDefinition,
    (axes, points): (&[Vec<f64>], &[Point]),
) -> Option<()> {
    let arguments = |point: &Point| point.components[..axes.len()].to_vec();
    if let Some(pair) = points.windows(2).find(|pair| arguments(&pair[0]) == arguments(&pair[1])) {
        report_point(elaborator, &pair[1], words::REPEATED_POINT).help(words::GRID_HELP);
        return None;
    }
    let size = axes.iter().map(Vec::len).product::<usize>();
    let missing = (0..size.min(points.len() + 1))
        .map(|index| grid_point(axes, index))
        .zip(points.iter().map(Some).chain([None]))
        .find(|(at, point)| point.is_none_or(|point| arguments(point) != *at));
    if let Some((at, _)) = missing {
        let report = &mut elaborator.evaluator.report;
        report.error(table.name.span, words::missing_point(&table.name.text, &at)).help(words::GRID_HELP);
        return None;
    }
    Some(())
}

/// Returns the arguments of a point of a grid, those along the last axis changing fastest.
fn grid_point(axes: &[Vec<f64>], mut index: usize) -> Vec<f64> {
    let reversed = axes.iter().rev().map(|knots| {
        let knot = knots[index % knots.len()];
        index /= knots.len();
        knot
    });
    let mut point = reversed.collect::<Vec<_>>();
    point.reverse();
    point
}

fn report_point<'a>(elaborator: &'a mut Elaborator<'_>, point: &Point, message: &str) -> &'a mut Diagnostic {
    let message = point.line.map_or_else(|| message.to_owned(), |line| words::on_line(line, message));
    elaborator.evaluator.report.error(point.place, message)
}

/// Reports tables in energies and constraints with discontinuous second derivatives on which
/// accelerations depend.
pub(super) fn check_tables(elaborator: &mut Elaborator<'_>) {
    let moving = elaborator.kinetic.iter().chain(&elaborator.lagrangian).map(|term| (term, DerivedBy::Time));
    let potential = elaborator.potential.iter().map(|term| (term, DerivedBy::Position));
    let terms = moving.chain(potential);
    let terms = terms.map(|(term, derived)| (term.value, derived, Some(term.syntax), term.keyword));
    let constraints = elaborator.constraints.iter();
    let residuals = constraints.map(|(constraint, span)| (constraint.value, DerivedBy::Time, None, *span));
    let roots = terms.chain(residuals).collect::<Vec<_>>();
    let mut reported = Vec::new();
    for (root, derived, syntax, place) in roots {
        for (call, table) in rough_tables(elaborator, root, derived) {
            if reported.contains(&table) {
                continue;
            }
            let found = syntax.and_then(|syntax| elaborator.evaluator.place_of(syntax, call));
            report_rough(elaborator, &table, found.unwrap_or(place.into()));
            reported.push(table);
        }
    }
}

/// Reports functions with names that emitted code uses for the derivatives of a table.
pub(super) fn check_names_of_derivatives(elaborator: &mut Elaborator<'_>) {
    let declaration = elaborator.declaration;
    let named = names_of_functions(&declaration.statements);
    for statement in &declaration.statements {
        let StatementKind::Table(table) = &statement.kind else { continue };
        let derivatives = names_of_derivatives(table);
        for name in named.iter().filter(|name| derivatives.contains(&name.text)) {
            let message = words::name_of_derivative(&name.text, &table.name.text);
            let error = elaborator.evaluator.report.error(name.span, message);
            error.related(table.name.span.into(), super::messages::names::DECLARED_HERE);
            error.help(super::messages::OTHER_NAME_HELP);
        }
    }
}

/// Returns the names of functions that emitted code calls, if users have chosen them.
pub(super) fn names_of_functions(statements: &[Statement]) -> Vec<&Name> {
    let named = statements.iter().flat_map(|statement| match &statement.kind {
        StatementKind::External(function) => {
            let derivatives = function.derivatives.iter().flatten().map(|derivative| &derivative.name);
            derivatives.chain([&function.name]).collect::<Vec<_>>()
        }
        StatementKind::Table(table) => vec![&table.name],
        _ => Vec::new(),
    });
    named.collect()
}

/// Returns the names of all derivatives that do not vanish.
fn names_of_derivatives(table: &TableDefinition) -> Vec<String> {
    let parameters = table.parameters.iter().map(|name| name.text.clone()).collect::<Vec<_>>();
    let orders = 0..table.interpolation.coefficients() as u8;
    let all = parameters.iter().fold(vec![vec![]], |all, _| {
        let extended =
            all.iter().flat_map(|of: &Vec<u8>| orders.clone().map(|order| [&of[..], &[order]].concat()));
        extended.collect()
    });
    let derivatives = all.iter().filter(|orders| orders.iter().any(|order| *order > 0));
    derivatives.map(|orders| default_name(&table.name.text, &parameters, orders)).collect()
}

/// The variables with respect to which accelerations differentiate a term.
#[derive(Clone, Copy)]
enum DerivedBy {
    /// Only positions: expressions that only change with time are factors.
    Position,
    /// Also time.
    Time,
}

impl DerivedBy {
    fn concerns(self, argument: Dependencies) -> bool {
        match self {
            DerivedBy::Position => argument.intersects(Dependencies::COORDINATE),
            DerivedBy::Time => argument.may_change(),
        }
    }
}

/// Returns the differentiated calls of tables without continuous second derivatives, with the
/// tables.
fn rough_tables(elaborator: &Elaborator<'_>, root: ExprId, derived: DerivedBy) -> Vec<(ExprId, Opaque)> {
    let graph = &elaborator.evaluator.graph;
    let mut rough = Vec::new();
    for id in graph.reachable(&[root]) {
        let Node::Opaque(function, _) = graph.node(id) else { continue };
        if !derived.concerns(graph.dependencies(id)) {
            continue;
        }
        // Tables in the equations of an unknown also affect its smoothness.
        let equations = graph.equations_of(function).map(|unknowns| graph.reachable(&unknowns.residuals));
        for part in equations.unwrap_or_default().into_iter().chain([id]) {
            let Node::Opaque(function, _) = graph.node(part) else { continue };
            let is_rough = function.table().is_some_and(|table| !table.is_twice_differentiable());
            if is_rough && graph.dependencies(part).may_change() {
                rough.push((id, Opaque::value_of(function.function().clone())));
            }
        }
    }
    rough
}

fn report_rough(elaborator: &mut Elaborator<'_>, function: &Opaque, place: Origin) {
    let name = &function.function().name;
    let (message, help) = match function.table().map(|table| table.interpolation) {
        Some(Interpolation::Natural) => (words::bent_ends(name), words::BENT_ENDS_HELP),
        _ => (words::rough(name), words::ROUGH_HELP),
    };
    let declared = elaborator.evaluator.callables.get(name).map(|callable| callable.span);
    let error = elaborator.evaluator.report.error(place, message).help(help);
    if let Some(span) = declared {
        error.related(span.into(), super::messages::names::DECLARED_HERE);
    }
}
