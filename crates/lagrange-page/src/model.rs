//! Names, units, ranges and initial values as data for the page.

use std::f64::consts::PI;

use lagrange_core::model::Product;
use lagrange_core::pipeline::{NumericSystem, Programs, Reaction};
use lagrange_core::syntax::ast::Direction;
use lagrange_plot::notation::{self, Columns};
use serde_json::{Value, json};

/// Returns all data of a system for the page, apart from its functions and its scene.
pub(crate) fn model(system: &NumericSystem, start: &[f64]) -> Value {
    let programs = system.programs();
    let (layout, variables) = (&programs.layout, &programs.variables);
    let is_measured = variables.units.iter().any(|(_, unit)| !["", "1"].contains(&unit.as_str()));
    json!({
        "positions": layout.positions,
        "velocities": layout.velocities,
        "firstOrder": variables.first_order_states,
        "quaternions": variables.quaternions,
        "fields": layout.fields(),
        "constraints": layout.multipliers,
        "constraintVelocity": Product::ConstraintVelocity.name(),
        "isStabilised": variables.is_stabilised,
        "energyUnit": if is_measured { "J" } else { "" },
        "states": states(programs, start),
        "quantities": quantities(programs, system.fields()),
        "outputs": outputs(programs),
        "events": events(programs),
        "switches": variables.switches,
        "clocks": programs.clocks.len(),
    })
}

/// Returns a name with its label and unit.
fn named(programs: &Programs, labels: &Columns, name: &str) -> Value {
    let unit = notation::unit(programs.variables.unit(name).unwrap_or_default());
    json!({ "name": name, "label": labels.label(name).html(), "unit": unit })
}

/// Adds a value and a range.
fn ranged(named: Value, value: f64, [low, high]: [f64; 2]) -> Value {
    let mut ranged = named;
    (ranged["value"], ranged["low"], ranged["high"]) = (json!(value), json!(low), json!(high));
    ranged
}

fn states(programs: &Programs, start: &[f64]) -> Vec<Value> {
    let names = programs.variables.state_names();
    let labels = Columns::new(names.iter().map(|name| &**name));
    let (positions, quaternions) = (programs.layout.positions, &programs.variables.quaternions);
    let state = |(index, (name, value)): (usize, (&String, &f64))| {
        let is_angle = index < positions && programs.variables.unit(name) == Some("rad");
        let range = match () {
            // The components of a quaternion cannot be set individually.
            () if quaternions.iter().any(|first| (*first..first + 4).contains(&index)) => [*value; 2],
            () if is_angle => [value.min(-PI), value.max(PI)],
            () => around(*value, if index < positions { 1.0 } else { 5.0 }),
        };
        let mut state = ranged(named(programs, &labels, name), *value, range);
        state["index"] = json!(index);
        state
    };
    names.iter().zip(start).enumerate().map(state).collect()
}

/// Returns a range symmetric about zero that extends at least to a distance.
fn around(value: f64, least: f64) -> [f64; 2] {
    let reach = least.max(2.0 * value.abs());
    [-reach, reach]
}

/// Returns parameters, then inputs.
fn quantities(programs: &Programs, values: &[f64]) -> Vec<Value> {
    let names = &programs.variables.fields;
    let labels = Columns::new(names.iter().map(|name| &**name));
    let quantity = |(index, (name, value)): (usize, (&String, &f64))| {
        let is_input = index >= programs.layout.parameters;
        let range = match () {
            () if is_input => around(*value, 10.0),
            () => range(*value, bounds(programs, index)),
        };
        let mut quantity = ranged(named(programs, &labels, name), *value, range);
        (quantity["index"], quantity["isInput"]) = (json!(index), json!(is_input));
        quantity
    };
    names.iter().zip(values).enumerate().map(quantity).collect()
}

type Bounds = [Option<(f64, bool)>; 2];

fn bounds(programs: &Programs, parameter: usize) -> Bounds {
    let range = programs.ranges.iter().find(|range| range.parameter == parameter);
    range.map(|range| range.bounds).unwrap_or_default()
}

/// Returns the range of a slider within the declared bounds. It extends from zero to twice the
/// value, or symmetrically for values that are not positive. Excluded bounds are approached to
/// within a hundredth.
fn range(value: f64, [low, high]: Bounds) -> [f64; 2] {
    let size = if value == 0.0 { 1.0 } else { value.abs() };
    let [free_low, free_high] = if value > 0.0 { [0.0, 2.0 * value] } else { [-2.0 * size, 2.0 * size] };
    let within = |bound: Option<(f64, bool)>, free: f64| match bound {
        Some((bound, is_allowed)) => {
            let nearest = if is_allowed { bound } else { bound + 0.01 * (value - bound) };
            Some(nearest).filter(|_| (bound - value).abs() < 10.0 * size).unwrap_or(free)
        }
        None => free,
    };
    let (low, high) = (within(low, free_low), within(high, free_high));
    [low.min(value), high.max(value)]
}

fn outputs(programs: &Programs) -> Vec<Value> {
    let names = programs.variables.outputs.concat();
    let labels = Columns::new(names.iter().map(|name| &**name));
    names.iter().map(|name| named(programs, &labels, name)).collect()
}

fn events(programs: &Programs) -> Vec<Value> {
    let event = |(event, reaction): (&lagrange_core::emit::EventOfSystem, &Reaction)| {
        let direction = match event.direction {
            Direction::Rising => 1,
            Direction::Falling => -1,
            Direction::Crossing => 0,
        };
        let action = match reaction {
            Reaction::Record => "record",
            Reaction::Stop => "stop",
            Reaction::Replace(_) => "replace",
            // Contacts have already been rejected.
            Reaction::Impact => "impact",
        };
        json!({ "name": event.name, "direction": direction, "action": action })
    };
    programs.variables.events.iter().zip(&programs.reactions).map(event).collect()
}

#[cfg(test)]
mod tests {
    use super::range;

    #[test]
    fn sliders_stay_within_bounds() {
        assert_eq!(range(2.0, [None, None]), [0.0, 4.0]);
        assert_eq!(range(2.0, [Some((0.0, false)), Some((3.0, true))]), [0.02, 3.0]);
        assert_eq!(range(-0.5, [None, Some((0.0, true))]), [-1.0, 0.0]);
        assert_eq!(range(0.0, [Some((0.0, true)), None]), [0.0, 2.0]);
        assert_eq!(range(9.81, [None, Some((1e9, true))]), [0.0, 19.62]);
    }
}
