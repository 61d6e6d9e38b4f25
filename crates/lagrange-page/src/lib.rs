//! Pages in which declared systems move by themselves.
//!
//! A page is one HTML file with the equations of motion as JavaScript, and their integration. It
//! has sliders of parameters, inputs and starts, and plots of states, outputs and energy. It shows
//! the drawing if the programs hold one.
//!
//! ```
//! use std::sync::Arc;
//! use lagrange_core::derive::StrategyChoice;
//! use lagrange_core::pipeline::{NumericSystem, Programs, parse};
//! use lagrange_page::page;
//!
//! let swing = "struct Swing; param l: m > 0 = 2, g: m/s^2 = 9.81; coord theta: rad = 0.5;
//!     kinetic = 1/2 * (1 [kg]) * (l * dot(theta))^2; potential = -(1 [kg]) * g * l * cos(theta);";
//! let programs = Programs::new(&parse(swing)?.derive(StrategyChoice::Cheapest)?);
//! let html = page(&NumericSystem::of(Arc::new(programs)), &[0.5, 0.0])?;
//! assert!(html.contains("<title>Swing</title>") && html.contains("function system_rhs(t, y, p, out)"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
#![forbid(unsafe_code)]

mod error;
mod items;
mod model;
mod scene;

use lagrange_c::Script;
use lagrange_core::pipeline::{NumericSystem, Programs};
use lagrange_draw::PAGE_STYLE;

pub use error::PageError;

use model::{model, title};
use scene::{Shown, shown};

const STYLE: &str = include_str!("page.css");
/// The integration of motions: `startsMotion(model, functions, tolerance)`.
const MOTION: &str = include_str!("motion.js");
const PAGE: &str = include_str!("page.js");

/// True for the functions that a page calls.
fn is_used(name: &str) -> bool {
    const CALLED: [&str; 10] = [
        "rhs",
        "position_rates",
        "position_residuals",
        "constraint_velocity",
        "correction",
        "energy",
        "outputs",
        "events",
        "switches",
        "drawing",
    ];
    CALLED.contains(&name)
        || ["after_event_", "after_clock_", "clock_"].iter().any(|start| name.starts_with(start))
}

/// Returns the page of a system whose parameters and inputs have the values that it starts with,
/// and whose state starts from `start`.
///
/// # Errors
/// If the system holds what only compiled Rust can run, or a number of its drawing is not finite.
pub fn page(system: &NumericSystem, start: &[f64]) -> Result<String, PageError> {
    let programs = system.programs();
    let start = normalised(programs, start);
    let script = Script::new(programs, is_used)?;
    let Shown { elements, scene, viewer, style, keys } = shown(system, &start)?;
    let mut model = model(system, &start);
    model["scene"] = scene;
    let names = script.functions.iter().map(|name| format!("{name}: system_{name}"));
    Ok(format!(
        include_str!("page.html"),
        title = title(&programs.name),
        style = [PAGE_STYLE, STYLE, style].concat(),
        figure = elements,
        keys = keys,
        // A text cannot end the script.
        model = model.to_string().replace('<', "\\u003c"),
        functions = format!("{}return {{ {} }};\n", script.text, names.collect::<Vec<_>>().join(", ")),
        script = [MOTION, &viewer, PAGE].concat(),
    ))
}

/// Brings the quaternions of a state to length one.
fn normalised(programs: &Programs, start: &[f64]) -> Vec<f64> {
    let mut start = start.to_vec();
    for &first in &programs.variables.quaternions {
        let Some(parts) = start.get_mut(first..first + 4) else { continue };
        let length = parts.iter().map(|part| part * part).sum::<f64>().sqrt();
        parts.iter_mut().for_each(|part| *part /= length);
    }
    start
}
