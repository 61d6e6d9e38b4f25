//! Names and arguments of the functions of the language.

use lagrange_expr::elementary;
use lagrange_expr::solids::{self, Dimensions, SOLIDS, Solid};
use lagrange_language::syntax::{NAMEABLE_FUNCTIONS, STRUCTURAL_FUNCTIONS};

/// True if the language has a function of that name.
pub(super) fn is_function(name: &str) -> bool {
    arity(name).is_some() || mass_function(name).is_some()
}

pub(super) fn arity(name: &str) -> Option<usize> {
    let elementary = elementary::by_name(name).map(|row| row.arity);
    let others = || structural_functions().find(|(known, _)| *known == name).map(|(_, arity)| arity);
    elementary.or_else(others)
}

fn structural_functions() -> impl Iterator<Item = (&'static str, usize)> {
    STRUCTURAL_FUNCTIONS.into_iter().chain(NAMEABLE_FUNCTIONS)
}

/// Returns the usage of a function, with the names of its arguments in textbooks.
pub(super) fn usage(name: &str, arity: usize) -> String {
    if matches!(name, "powi" | "powf") {
        return format!("x.{name}(n)");
    }
    let arguments = match (name, arity) {
        ("atan2", _) => "y, x",
        ("norm", _) => "v",
        ("partial", _) => "e, x",
        ("delay", _) => "e, tau",
        ("transpose", _) => "A",
        ("inner" | "cross", _) => "v, w",
        ("kinetic_energy", _) => "m, v",
        ("gravitational_energy", _) => "m, g, h",
        ("spring_energy", _) => "k, x",
        (_, 1) => "x",
        _ => "a, b",
    };
    format!("{name}({arguments})")
}

pub(super) fn function_names() -> impl Iterator<Item = &'static str> {
    let elementary = elementary::ROWS.iter().map(|row| row.name);
    elementary.chain(structural_functions().map(|(name, _)| name)).chain(mass_function_names())
}

/// A function of mass geometry.
#[derive(Clone, Copy)]
pub(super) enum MassFunction {
    /// `solid(m, …)`: the moment of inertia about the centre of mass.
    Inertia(&'static Solid),
    /// `solid_center(…)`: the centre of mass in the solid's own coordinates.
    Center(&'static Solid),
    /// `slender_rod_end(m, l)` = m l²/3, about an end.
    RodEnd,
    /// `steiner(j, m, r)` = j + m r², about an axis at the distance r from the centre of mass.
    Steiner,
}

/// Returns the function with this name.
pub(super) fn mass_function(name: &str) -> Option<MassFunction> {
    match name {
        "slender_rod_end" => Some(MassFunction::RodEnd),
        "steiner" => Some(MassFunction::Steiner),
        _ => {
            let inertia = solids::by_name(name).map(MassFunction::Inertia);
            inertia.or_else(|| solids::by_center_function(name).map(MassFunction::Center))
        }
    }
}

/// Returns the names that misspelt calls may have meant.
fn mass_function_names() -> impl Iterator<Item = &'static str> {
    SOLIDS.iter().map(|solid| solid.name).chain(["slender_rod_end", "steiner"])
}

impl MassFunction {
    /// Returns the usage of the function.
    pub(super) fn usage(self) -> String {
        match self {
            MassFunction::Inertia(solid) => solid.inertia_usage(),
            MassFunction::Center(solid) => solid.center_usage(),
            MassFunction::RodEnd => "slender_rod_end(m, l)".to_owned(),
            MassFunction::Steiner => "steiner(j, m, r)".to_owned(),
        }
    }

    /// Returns the number of arguments, and true if that is a minimum.
    pub(super) fn arity(self) -> (usize, bool) {
        let of_solid = |solid: &Solid| match solid.dimensions {
            Dimensions::Scalars(names) => (names.len(), false),
            Dimensions::Corners => (solids::FEWEST_CORNERS, true),
        };
        match self {
            MassFunction::Inertia(solid) => {
                let (count, or_more) = of_solid(solid);
                (count + 1, or_more)
            }
            MassFunction::Center(solid) => of_solid(solid),
            MassFunction::RodEnd => (2, false),
            MassFunction::Steiner => (3, false),
        }
    }
}
