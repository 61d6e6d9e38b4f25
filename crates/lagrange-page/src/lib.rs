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
use lagrange_core::pipeline::NumericSystem;
use lagrange_draw::{LiveScene, PAGE_STYLE};
use serde_json::Value;

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
    let script = Script::new(programs, is_used)?;
    let shown = shown(system, start)?;
    let (elements, scene, viewer) = match &shown {
        None => (String::new(), Value::Null, String::new()),
        Some(Shown { elements, scene, viewer }) => {
            (format!("<figure id=\"picture\">{elements}</figure>"), scene.clone(), viewer.clone())
        }
    };
    let mut model = model(system, start);
    let is_in_space = scene.get("space").is_some();
    model["scene"] = scene;
    let names = script.functions.iter().map(|name| format!("{name}: system_{name}"));
    let functions = format!("{}return {{ {} }};\n", script.text, names.collect::<Vec<_>>().join(", "));
    let space = if is_in_space { [LiveScene::STYLE, LiveScene::KEYS] } else { [""; 2] };
    Ok(format!(
        include_str!("page.html"),
        title = title(&programs.name),
        style = [PAGE_STYLE, STYLE, space[0]].concat(),
        figure = elements,
        keys = space[1],
        // A text cannot end the script.
        model = model.to_string().replace('<', "\\u003c"),
        functions = functions,
        script = [MOTION, &viewer, PAGE].concat(),
    ))
}
