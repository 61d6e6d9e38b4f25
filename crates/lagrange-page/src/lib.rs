//! Pages with live simulations of declared systems.
//!
//! A page is one HTML file with the equations of motion as JavaScript, and their integration. It
//! has sliders for parameters, inputs and initial values, and plots of states, outputs and energy.
//! It shows the drawing if the programs have one.
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
mod model;
mod scene;

use lagrange_c::Script;
use lagrange_core::pipeline::{NumericSystem, Programs};
use lagrange_draw::{PAGE_SCHEME, page_style};
use lagrange_dynamic::title;

pub use error::PageError;

use model::model;
use scene::{Shown, shown};

const STYLE: &str = include_str!("page.css");
/// The integration of motions: `startsMotion(model, functions, tolerance)`.
const MOTION: &str = include_str!("motion.js");
const PAGE: &str = include_str!("page.js");

/// True for the functions called by a page.
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

/// Returns the page of a system with the current values of its parameters and inputs, and the
/// initial state `start`.
///
/// # Errors
/// If the system has parts that only compiled Rust can run, or an initial value is not finite.
pub fn page(system: &NumericSystem, start: &[f64]) -> Result<String, PageError> {
    let programs = system.programs();
    let start = normalised(programs, start);
    check(system, &start)?;
    let script = Script::new(programs, is_used)?;
    let Shown { elements, scene, viewer, style, keys } = shown(system, &start)?;
    let mut model = model(system, &start);
    model["scene"] = scene;
    let names = script.functions.iter().map(|name| format!("{name}: system_{name}"));
    Ok(format!(
        include_str!("page.html"),
        title = title(&programs.name),
        style = [&*page_style(), STYLE, style].concat(),
        figure = elements,
        keys = keys,
        // A text cannot end the script.
        model = model.to_string().replace('<', "\\u003c"),
        functions = format!("{}return {{ {} }};\n", script.text, names.collect::<Vec<_>>().join(", ")),
        script = [PAGE_SCHEME, MOTION, &viewer, PAGE].concat(),
    ))
}

/// Checks that all numbers are finite; others would become zeros on the page.
fn check(system: &NumericSystem, start: &[f64]) -> Result<(), PageError> {
    let variables = &system.programs().variables;
    let names = variables.fields.iter().cloned().chain(variables.state_names());
    let mut values = names.zip(system.fields().iter().chain(start));
    match values.find(|(_, value)| !value.is_finite()) {
        Some((name, _)) => Err(PageError::NotFinite(name)),
        None => Ok(()),
    }
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

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use lagrange_core::derive::StrategyChoice;
    use lagrange_core::pipeline::{NumericSystem, Programs, parse};

    use super::{PageError, page};

    #[test]
    fn numbers_that_are_none_are_refused_by_name() {
        let text = "param m; body b { mass: m; inertia: (1, 2, 3); } free b;";
        let derived = parse(text).and_then(|system| system.derive(StrategyChoice::Cheapest));
        let programs = Programs::new(&derived.unwrap_or_else(|report| panic!("{report}")));
        let mut system = NumericSystem::of(Arc::new(programs));
        let refused = |system: &NumericSystem, start: [f64; 13]| match page(system, &start) {
            Err(PageError::NotFinite(name)) => name,
            other => panic!("{other:?}"),
        };
        let mut start = [0.0; 13];
        assert_eq!(refused(&system, start), "m");
        assert!(system.set("m", 1.0));
        assert_eq!(refused(&system, start), "b_qw");
        start[3] = 1.0;
        assert!(page(&system, &start).is_ok());
        start[12] = f64::INFINITY;
        assert_eq!(refused(&system, start), "b_wz");
    }
}
