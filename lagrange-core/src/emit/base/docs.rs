//! Documentation of an emitted system: its equations and its detected properties.

use proc_macro2::TokenStream;
use quote::quote;

use super::shape::doc;
use crate::derive::{Conserved, DiffusionKind, Equations, Strategy, Structure};
use crate::model::Model;
use lagrange_algebra::calculus::residuals as residuals_of;
use lagrange_algebra::formula::{latex, text};
use lagrange_algebra::program::{Labels, OperationCounts, lower, optimise};
use lagrange_algebra::simplify::present_all;
use lagrange_expr::accuracy::Accuracy;
use lagrange_expr::collections::HashMap;
use lagrange_expr::expr::{ExprId, Graph};
use lagrange_expr::number::Number;

/// Maximum number of monomials for which an entry is expanded.
const READING_BUDGET: usize = 120;
/// Maximum number of expressions in an entry that is simplified for printing.
const LARGEST_PRESENTED: usize = 300;
/// Maximum number of coordinates for which equations are readable.
const MAX_COORDINATES: usize = 6;
/// Maximum number of expressions in readable equations.
const LARGEST_SYSTEM: usize = 200;
/// Maximum number of abbreviations; beyond it the code is more readable.
const MAX_ABBREVIATIONS: usize = 12;
/// Maximum length of lines in characters.
const LONGEST_LINE: usize = 100;
/// Maximum length of printed equations in characters.
const LONGEST_EQUATIONS: usize = 4000;

const FAST: [&str; 2] = [
    "- Accuracy: `fast`. Sines and cosines are computed several at a time;",
    "  in `f64` each is within 0.9 units in the last place.",
];
const STRICT: &str = "- Accuracy: `strict`. Of equal ways the one that cancels least.";
const SEPARABLE: &str = "- Separable: explicit symplectic methods take it.";
const LEAPFROG: &str = "- Leapfrog methods take it and keep it on the constraints.";
const STATEMENTS: &str = "Those about rigid bodies stand for plain ones:";
const REDUNDANT: &str = "- Constraints follow from others: of the multipliers the smallest ones are taken.";
const NO_SQUARES: &str = "the kinetic energy is no sum of squares";
const TOO_LONG: &str =
    "M q̈ = f, too long to be written out; `mass_matrix` and `forcing` compute the two sides.";

/// Returns M q̈ = f as text, one line for each coordinate. Definitions of abbreviations that keep
/// the lines short come first. `None` if even that would be too long to read.
fn equations_text(model: &mut Model, equations: &Equations) -> Option<Vec<String>> {
    if model.speeds.len() > MAX_COORDINATES {
        return None;
    }
    let right = right_sides(model, equations);
    let mut all = equations.mass_matrix.iter().flatten().chain(&right).copied().collect::<Vec<_>>();
    all.extend(model.states().map(|state| state.rate));
    if model.graph.reachable(&all).len() > LARGEST_SYSTEM {
        return None;
    }
    let right = readable(&mut model.graph, &right);
    // The right sides are longer: if they are unreadable, the left ones need not be tried.
    readable_lines(text::definitions(&model.graph, &right, LONGEST_EQUATIONS))?;
    let sides = sides(model, equations, &right);
    let definitions = text::definitions(&model.graph, &sides, LONGEST_EQUATIONS);
    let mut lines = readable_lines(with_rates(model, definitions, text::rate))?;
    lines.extend(equations_of_unknowns(model, &all, text::text));
    Some(lines.iter().flat_map(|line| wrapped(line)).collect())
}

/// Returns M q̈ = f in LaTeX, one line for each coordinate. Definitions of abbreviations that keep
/// the lines short come first. The result is empty if M is large and was not requested.
pub fn equations_latex(model: &mut Model, equations: &Equations) -> String {
    if equations.mass_matrix.is_empty() {
        return String::new();
    }
    let right = right_sides(model, equations);
    let right = readable(&mut model.graph, &right);
    let sides = sides(model, equations, &right);
    let definitions = latex::definitions(&model.graph, &sides, LONGEST_EQUATIONS);
    let mut lines = lines(with_rates(model, definitions, latex::rate));
    lines.extend(equations_of_unknowns(model, &sides, latex::latex));
    lines.join("\n")
}

/// Returns the equation of each algebraic unknown in these expressions.
fn equations_of_unknowns(
    model: &mut Model,
    expressions: &[ExprId],
    write: fn(&Graph, ExprId) -> String,
) -> Vec<String> {
    let graph = &mut model.graph;
    let calls = graph.reachable(expressions).into_iter();
    let mut residuals: Vec<ExprId> = Vec::new();
    for residual in calls.flat_map(|call| residuals_of(graph, call)) {
        // Unknowns that are solved jointly have the same equations.
        if !residuals.contains(&residual) {
            residuals.push(residual);
        }
    }
    residuals.into_iter().map(|residual| format!("0 = {}", write(graph, residual))).collect()
}

/// Computes f + Aᵀλ + Dᵀr, with the names of constraints, contacts and friction for their forces.
fn right_sides(model: &mut Model, equations: &Equations) -> Vec<ExprId> {
    let reactions = model.reactions.iter().map(|reaction| reaction.symbol);
    let symbols = model.multipliers().into_iter().chain(reactions).collect::<Vec<_>>();
    let graph = &mut model.graph;
    let mut sides = equations.forcing.clone();
    let rows = equations.constraints.jacobian.iter().chain(&equations.reactions.rows);
    for (row, symbol) in rows.zip(symbols) {
        for (side, &slope) in sides.iter_mut().zip(row) {
            let force = graph.multiply(slope, symbol);
            *side = graph.add(*side, force);
        }
    }
    sides
}

/// Returns both sides of each row of M q̈ = f + Aᵀλ, then of each constraint, then each state and
/// its rate.
fn sides(model: &mut Model, equations: &Equations, right: &[ExprId]) -> Vec<ExprId> {
    let mass = readable(&mut model.graph, &equations.mass_matrix.concat());
    let rows = mass.chunks(right.len().max(1)).zip(right);
    let mut sides = rows.flat_map(|(row, &right)| [left_side(model, row), right]).collect::<Vec<_>>();
    let constraints = model.constraints.iter().map(|constraint| constraint.value).collect::<Vec<_>>();
    let zero = model.graph.number(0);
    sides.extend(readable(&mut model.graph, &constraints).into_iter().flat_map(|value| [value, zero]));
    let (states, rates): (Vec<_>, Vec<_>) = model.states().map(|state| (state.position, state.rate)).unzip();
    let rates = readable(&mut model.graph, &rates);
    sides.extend(states.into_iter().zip(rates).flat_map(|(state, rate)| [state, rate]));
    sides
}

/// Writes ȧ on the left of the equation of each state a; these equations come last.
fn with_rates(model: &Model, (names, mut sides): Definitions, rate: fn(&str) -> String) -> Definitions {
    let first = sides.len() - 2 * model.states().count();
    for (left, state) in sides[first..].iter_mut().step_by(2).zip(model.states()) {
        *left = rate(&state.name);
    }
    (names, sides)
}

/// Names with their definitions, and left and right sides.
type Definitions = (Vec<(String, String)>, Vec<String>);

/// Returns the lines, unless there are too many characters or abbreviations.
fn readable_lines(definitions: Definitions) -> Option<Vec<String>> {
    let abbreviations = definitions.0.len();
    let lines = lines(definitions);
    let length = lines.iter().map(String::len).sum::<usize>();
    (length <= LONGEST_EQUATIONS && abbreviations <= MAX_ABBREVIATIONS).then_some(lines)
}

/// Returns the definitions of names, followed by the equations of left and right sides.
fn lines((abbreviations, sides): Definitions) -> Vec<String> {
    let abbreviations = abbreviations.into_iter().map(|(name, value)| format!("{name} = {value}"));
    abbreviations.chain(sides.chunks(2).map(|side| side.join(" = "))).collect()
}

/// Splits a long equation into several lines, before the operators between its terms.
fn wrapped(line: &str) -> Vec<String> {
    let mut lines = Vec::new();
    let mut current = String::new();
    for term in terms(line) {
        if !current.is_empty() && current.chars().count() + term.chars().count() > LONGEST_LINE {
            lines.push(std::mem::replace(&mut current, format!("    {}", term.trim_start())));
        } else {
            current.push_str(term);
        }
    }
    lines.push(current);
    lines
}

/// Splits an equation at blanks outside parentheses; each piece begins with its operator.
fn terms(line: &str) -> Vec<&str> {
    let (mut depth, mut start, mut pieces) = (0_usize, 0, Vec::new());
    for (index, character) in line.char_indices() {
        match character {
            '(' | '{' => depth += 1,
            ')' | '}' => depth = depth.saturating_sub(1),
            ' ' if depth == 0 && [" + ", " - ", " = "].iter().any(|op| line[index..].starts_with(op)) => {
                pieces.push(&line[start..index]);
                start = index;
            }
            _ => {}
        }
    }
    pieces.push(&line[start..]);
    pieces
}

/// Computes Σ Mᵢⱼ q̈ⱼ.
fn left_side(model: &mut Model, row: &[ExprId]) -> ExprId {
    let mut terms = Vec::new();
    for (&entry, speed) in row.iter().zip(&model.speeds) {
        terms.push((model.graph.multiply(entry, speed.acceleration), Number::ONE));
    }
    model.graph.sum(Number::ZERO, terms)
}

/// Rewrites expressions in textbook form, if this can be found quickly.
fn readable(graph: &mut Graph, expressions: &[ExprId]) -> Vec<ExprId> {
    let is_small = |&&id: &&ExprId| graph.reachable(&[id]).len() <= LARGEST_PRESENTED;
    let small = expressions.iter().filter(is_small).copied().collect::<Vec<_>>();
    let presented = present_all(graph, &small, READING_BUDGET);
    let presented = small.into_iter().zip(presented).collect::<HashMap<_, _>>();
    expressions.iter().map(|id| presented.get(id).copied().unwrap_or(*id)).collect()
}

/// Writes the documentation of the emitted struct about its equations and the properties of the
/// system, in lines of Markdown.
pub fn documentation(model: &mut Model, equations: &Equations) -> Vec<String> {
    let program = lower(&model.graph, &equations.accelerations, &Labels::default());
    let program = optimise(&program, model.accuracy);
    system_docs(model, equations, OperationCounts::of(&program))
}

/// Documentation for accelerations whose operations have been counted.
pub(in crate::emit) fn system_docs(
    model: &mut Model,
    equations: &Equations,
    counts: OperationCounts,
) -> Vec<String> {
    let mut lines = vec!["# Equations of motion".to_owned(), String::new()];
    match equations_text(model, equations) {
        Some(equations) => {
            lines.push("```text".to_owned());
            lines.extend(equations);
            lines.push("```".to_owned());
        }
        None => lines.push(TOO_LONG.to_owned()),
    }
    lines.extend([String::new(), "# State and structure".to_owned(), String::new()]);
    lines.push(format!("- State: `[{}]`.", state_order(model)));
    if !model.speeds.is_empty() {
        lines.extend(structure_lines(model, &equations.structure));
        if equations.is_separable(model) {
            lines.push(if model.constraints.is_empty() { SEPARABLE } else { LEAPFROG }.to_owned());
        }
        lines.push(format!("- Forward dynamics: {}.", strategy_text(equations)));
    }
    if !model.constraints.is_empty() {
        lines.push(multiplier_order(model));
    }
    if !model.reactions.is_empty() {
        lines.push(reaction_order(model));
    }
    if !model.noises.is_empty() {
        lines.push(noise_line(model, equations.diffusion.kind));
    }
    if equations.constraints.is_redundant {
        lines.push(REDUNDANT.to_owned());
    }
    match model.accuracy {
        Accuracy::Fast => lines.extend(FAST.map(str::to_owned)),
        Accuracy::Strict => lines.push(STRICT.to_owned()),
        Accuracy::Standard => {}
    }
    let when = if model.reactions.is_empty() { "" } else { " while no contact or friction acts" };
    lines.push(format!("- Cost of `acceleration`{when}: {}.", counts_text(counts)));
    lines
}

/// Describes the noises and their interpretation.
fn noise_line(model: &Model, kind: DiffusionKind) -> String {
    let names = model.noises.iter().map(|noise| format!("`{}`", noise.name)).collect::<Vec<_>>().join(", ");
    let kind = match kind {
        DiffusionKind::Additive => "additive",
        DiffusionKind::Unambiguous => "depending on components that no noise drives",
        DiffusionKind::Multiplicative => "multiplicative, in the sense of Stratonovich",
    };
    format!("- Noise: {names}, {kind}. Only `diffusion` contains it.")
}

/// Documents the plain statements that replace those about rigid bodies.
pub(in crate::emit) fn statements(text: &str) -> Vec<String> {
    let head = ["", "# Statements", "", STATEMENTS, "", "```text"].map(str::to_owned);
    head.into_iter().chain(text.lines().map(str::to_owned)).chain(["```".to_owned()]).collect()
}

fn multiplier_order(model: &Model) -> String {
    let names = model.constraints.iter().map(|constraint| constraint.name.as_str()).collect::<Vec<_>>();
    format!("- Multipliers, which the equations name like their constraints: `[{}]`.", names.join(", "))
}

fn reaction_order(model: &Model) -> String {
    let names = model.reactions.iter().map(|reaction| reaction.name.as_str()).collect::<Vec<_>>();
    format!("- Forces of contacts and friction, zero where they do not act: `[{}]`.", names.join(", "))
}

fn state_order(model: &Model) -> String {
    let positions = model.coordinates.iter().map(|coordinate| coordinate.name.as_str());
    let velocities = model.speeds.iter().map(|speed| speed.name.as_str());
    positions.chain(velocities).collect::<Vec<_>>().join(", ")
}

fn structure_lines(model: &Model, structure: &Structure) -> Vec<String> {
    let name = |i: usize| format!("`{}`", model.coordinates[i].name);
    let freedom = |i: usize| format!("`{}`", model.name_of_freedom(i));
    let freedoms = |indices: &[usize]| indices.iter().map(|&i| freedom(i)).collect::<Vec<_>>().join(", ");
    let mut lines = vec![format!("- Mass matrix: {}.", mass_text(structure, freedoms))];
    if !structure.cyclic.is_empty() {
        let cyclic = structure.cyclic.iter().map(|&i| name(i)).collect::<Vec<_>>();
        lines.push(format!("- Cyclic coordinates: {}.", cyclic.join(", ")));
    }
    let conserved = structure.conserved.iter().map(|quantity| match quantity {
        Conserved::Momentum(i) => format!("the momentum of {}", name(*i)),
        Conserved::Energy => "the energy function".to_owned(),
    });
    let conserved = conserved.collect::<Vec<_>>();
    if !conserved.is_empty() {
        lines.push(format!("- Conserved: {}.", conserved.join(", ")));
    }
    lines
}

fn mass_text(structure: &Structure, join: impl Fn(&[usize]) -> String) -> String {
    let mass = &structure.mass;
    let shape = if mass.is_diagonal() {
        "diagonal".to_owned()
    } else if mass.blocks.len() > 1 {
        let blocks = mass.blocks.iter().map(|block| format!("{{{}}}", join(block)));
        format!("blocks {}", blocks.collect::<Vec<_>>().join(", "))
    } else {
        "full".to_owned()
    };
    let dependence = match (mass.is_constant, mass.depends_on_velocities) {
        (true, _) => "constant",
        (_, true) => "depends on velocities",
        _ => "depends on the configuration",
    };
    format!("{shape}, {dependence}")
}

/// Adds the operation counts to the documentation of a method.
pub(in crate::emit) fn with_counts(docs: TokenStream, counts: OperationCounts) -> TokenStream {
    if counts == OperationCounts::default() {
        return docs;
    }
    let (blank, cost) = (doc(""), doc(&format!("Takes {}.", counts_text(counts))));
    quote!(#docs #blank #cost)
}

/// Formats operation counts as Markdown.
pub(in crate::emit) fn counts_text(counts: OperationCounts) -> String {
    counts.to_string().replace("sin_cos", "`sin_cos`")
}

/// Describes the strategy of forward dynamics and its reason: the counted cost of each strategy
/// that was tried.
fn strategy_text(equations: &Equations) -> String {
    if equations.structure.mass.is_diagonal() && equations.constraints.jacobian.is_empty() {
        return "each equation divided by its entry of the mass matrix".to_owned();
    }
    let costs = Strategy::ALL.into_iter().zip(equations.costs);
    let costs = costs.filter_map(|(strategy, cost)| Some((strategy, cost?))).collect::<Vec<_>>();
    let taken = match equations.strategy {
        Strategy::MassMatrix => "the mass matrix is factorised",
        Strategy::ArticulatedBody => "eliminated body by body",
        Strategy::SumOfSquares => "eliminated body by body, the kinetic energy kept a sum of squares",
    };
    let others = costs.iter().filter(|(strategy, _)| *strategy != equations.strategy);
    let others = others.map(|(strategy, cost)| format!("{} {cost}", strategy_name(*strategy)));
    let no_squares = (!equations.is_sum_of_squares).then(|| NO_SQUARES.to_owned());
    let others = others.chain(no_squares).collect::<Vec<_>>().join(", ");
    match costs.iter().find(|(strategy, _)| *strategy == equations.strategy) {
        Some((_, cost)) if costs.len() > 1 => format!("{taken} (counted cost {cost}; {others})"),
        _ if !others.is_empty() => format!("{taken} ({others})"),
        _ => taken.to_owned(),
    }
}

fn strategy_name(strategy: Strategy) -> &'static str {
    match strategy {
        Strategy::MassMatrix => "factorised mass matrix",
        Strategy::ArticulatedBody => "recursion",
        Strategy::SumOfSquares => "sum of squares",
    }
}
