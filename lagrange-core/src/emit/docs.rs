//! The documentation of an emitted system: its equations and what was found out about it.

use super::{latex, text};
use crate::expr::{ExprId, Graph};
use crate::mechanics::{Conserved, Equations, Model, Road, Structure};
use crate::number::Number;
use crate::program::{Labels, OperationCounts, lower, optimise};
use crate::simplify::present;

/// Monomials up to which an entry is multiplied out for reading.
const READING_BUDGET: usize = 120;
/// Entries made of more expressions than this are printed as they were derived.
const LARGEST_PRESENTED: usize = 300;
/// Systems with more coordinates are too large for their equations to be read.
const MOST_COORDINATES: usize = 8;
/// Systems whose equations are made of more expressions are too large for that, too.
const LARGEST_SYSTEM: usize = 200;
/// Equations longer than this, in characters, are left out.
const LONGEST_EQUATIONS: usize = 6000;

/// M q̈ = f as text, one line for each coordinate after the definitions of abbreviations that keep them
/// short; `None` if even that would be too long to read.
fn equations_text(model: &mut Model, equations: &Equations) -> Option<Vec<String>> {
    let (mass, forcing) = (equations.mass_matrix.as_ref()?, equations.forcing.as_ref()?);
    let all = mass.iter().flatten().chain(forcing).copied().collect::<Vec<_>>();
    if model.coordinates.len() > MOST_COORDINATES || model.graph.reachable(&all).len() > LARGEST_SYSTEM {
        return None;
    }
    let sides = sides(model, equations)?;
    let lines = lines(text::definitions(&model.graph, &sides, LONGEST_EQUATIONS));
    (lines.iter().map(String::len).sum::<usize>() <= LONGEST_EQUATIONS).then_some(lines)
}

/// M q̈ = f in LaTeX, one line for each coordinate after the definitions of abbreviations that keep them
/// short. Empty if the mass matrix or the forcing is not wanted.
pub fn equations_latex(model: &mut Model, equations: &Equations) -> String {
    let sides = sides(model, equations).unwrap_or_default();
    lines(latex::definitions(&model.graph, &sides, LONGEST_EQUATIONS)).join("\n")
}

/// The left and the right side of each row of M q̈ = f.
fn sides(model: &mut Model, equations: &Equations) -> Option<Vec<ExprId>> {
    let (mass, forcing) = (equations.mass_matrix.as_ref()?, equations.forcing.as_ref()?);
    let mut sides = Vec::new();
    for (row, &right) in mass.iter().zip(forcing) {
        sides.push(left_side(model, row));
        sides.push(readable(&mut model.graph, right));
    }
    Some(sides)
}

/// Equations between names and what they abbreviate, then between left and right sides.
fn lines((abbreviations, sides): (Vec<(String, String)>, Vec<String>)) -> Vec<String> {
    let abbreviations = abbreviations.into_iter().map(|(name, value)| format!("{name} = {value}"));
    abbreviations.chain(sides.chunks(2).map(|side| side.join(" = "))).collect()
}

/// Σ Mᵢⱼ q̈ⱼ
fn left_side(model: &mut Model, row: &[ExprId]) -> ExprId {
    let mut terms = Vec::new();
    for (entry, coordinate) in row.iter().zip(&model.coordinates) {
        let entry = readable(&mut model.graph, *entry);
        terms.push((model.graph.multiply(entry, coordinate.acceleration), Number::ONE));
    }
    model.graph.sum(Number::ZERO, terms)
}

/// An equal expression in the form a textbook would print, if that can be found quickly.
fn readable(graph: &mut Graph, expression: ExprId) -> ExprId {
    if graph.reachable(&[expression]).len() > LARGEST_PRESENTED {
        return expression;
    }
    present(graph, expression, READING_BUDGET)
}

/// What the documentation of the emitted struct says of its equations and of what was found out about the
/// system, in lines of Markdown.
pub fn documentation(model: &mut Model, equations: &Equations) -> Vec<String> {
    let program = optimise(&lower(&model.graph, &equations.accelerations, &Labels::default()));
    system_docs(model, equations, OperationCounts::of(&program))
}

/// The same for accelerations whose operations have been counted.
pub(super) fn system_docs(model: &mut Model, equations: &Equations, counts: OperationCounts) -> Vec<String> {
    let mut lines = vec![String::new(), "# Equations of motion".to_owned(), String::new()];
    match equations_text(model, equations) {
        Some(equations) => {
            lines.push("```text".to_owned());
            lines.extend(equations);
            lines.push("```".to_owned());
        }
        None => lines.push("M q̈ = f with too many terms to be read here.".to_owned()),
    }
    lines.extend([String::new(), "# State and structure".to_owned(), String::new()]);
    lines.push(format!("- State: `[{}]`.", state_order(model)));
    lines.extend(structure_lines(model, &equations.structure));
    lines.push(format!("- One evaluation of `acceleration`: {counts}; {}.", road_text(equations)));
    lines
}

fn state_order(model: &Model) -> String {
    let names = model.coordinates.iter().map(|coordinate| coordinate.name.clone());
    let rates = model.coordinates.iter().map(|coordinate| format!("{}_dot", coordinate.name));
    names.chain(rates).collect::<Vec<_>>().join(", ")
}

fn structure_lines(model: &Model, structure: &Structure) -> Vec<String> {
    let name = |i: usize| format!("`{}`", model.coordinates[i].name);
    let join = |indices: &[usize]| indices.iter().map(|&i| name(i)).collect::<Vec<_>>().join(", ");
    let mut lines = vec![format!("- Mass matrix: {}.", mass_text(structure, join))];
    if !structure.cyclic.is_empty() {
        lines.push(format!("- Cyclic coordinates: {}.", join(&structure.cyclic)));
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

fn road_text(equations: &Equations) -> &'static str {
    match (equations.road, equations.costs) {
        (Road::Dense, [_, Some(_)]) => "the mass matrix is factorised, which costs no more than recursion",
        (Road::Dense, _) => "the mass matrix is factorised",
        (Road::Recursive, [Some(_), _]) => {
            "coordinates are eliminated recursively, which costs less than factorising the mass matrix"
        }
        (Road::Recursive, _) => "coordinates are eliminated recursively",
    }
}
