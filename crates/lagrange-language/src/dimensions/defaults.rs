//! Conversion of numbers from the units of their names to coherent units.

use super::labels::{Label, label};
use super::messages;
use super::quantities::{is_name, is_of_numbers, with_unit};
use crate::syntax::ast::{
    AstId, Declaration, Definition, Expressions, Name, StatementKind, TableDefinition, TableSource,
    acceleration_name,
};
use crate::syntax::print;
use lagrange_expr::collections::HashSet;
use lagrange_expr::diagnostics::{Origin, Report};
use lagrange_expr::number::Number;
use lagrange_expr::units::{NamedUnit, NamedUnits, Scale, Unit, UnitFactor};

/// Known units before bodies are translated.
#[derive(Default)]
pub struct Measured {
    pub(super) named: NamedUnits,
    pub(super) labels: Vec<Label>,
    /// The last expression written by the user.
    pub(super) last_written: Option<AstId>,
}

/// Writes the units of names and labels after their numbers.
pub fn in_coherent_units(declaration: &mut Declaration, report: &mut Report) -> Measured {
    if !declaration.has_units {
        return Measured::default();
    }
    let mut statements = std::mem::take(&mut declaration.statements);
    let expressions = &mut declaration.expressions;
    let mut writer =
        UnitWriter { expressions, report, measured: Measured::default(), said: HashSet::default() };
    statements.iter_mut().for_each(|statement| writer.statement(&mut statement.kind));
    let mut measured = writer.measured;
    declaration.statements = statements;
    measured.last_written = declaration.expressions.iter().last().map(|(id, _)| id);
    measured
}

/// Sets the units of state entries and their rates from the written units of coordinates, so that
/// angles stay in `rad`.
pub(super) fn name_state(declaration: &Declaration, named: &mut NamedUnits) {
    let mut add = |name: &str, unit: &Unit| {
        named.insert(name, NamedUnit::of(unit.coherent().to_string()));
    };
    for position in declaration.coordinates() {
        position.unit.iter().for_each(|unit| add(&position.text, unit));
    }
    for velocity in declaration.velocities() {
        let rate = match velocity.coordinate {
            Some(coordinate) => coordinate.unit.as_ref().and_then(|unit| per_second(unit)),
            None => Unit::coherent_of(&[("rad", 1), ("s", -1)], Origin::from(velocity.name.span)),
        };
        if let Some(rate) = rate {
            add(&velocity.name.text, &rate);
            per_second(&rate).iter().for_each(|unit| add(&acceleration_name(&velocity.name.text), unit));
        }
    }
}

fn per_second(unit: &Unit) -> Option<Unit> {
    let mut factors = unit.coherent().factors;
    match factors.iter_mut().find(|factor| factor.name == "s") {
        Some(seconds) => seconds.exponent = &seconds.exponent - &Number::ONE,
        None => factors.push(UnitFactor { name: "s".to_owned(), exponent: Number::MINUS_ONE }),
    }
    Unit::of(factors, unit.origin)
}

struct UnitWriter<'a> {
    expressions: &'a mut Expressions,
    report: &'a mut Report,
    measured: Measured,
    /// Places of units that have been reported to scale nothing, once for all elements of an array.
    said: HashSet<String>,
}

impl UnitWriter<'_> {
    fn statement(&mut self, kind: &mut StatementKind) {
        match kind {
            StatementKind::Scene(scene) => self.measured.labels.extend(label(scene, self.expressions)),
            StatementKind::External(function) => {
                function.parameters.iter().chain([&function.name]).for_each(|name| self.coherent(name));
            }
            StatementKind::Table(table) => self.table(table),
            StatementKind::Output(name, value) => self.output(name, value),
            StatementKind::Parameters(list)
            | StatementKind::Coordinates(list)
            | StatementKind::States(_, list) => {
                list.iter_mut().for_each(|definition| self.limited(definition));
            }
            kind => {
                for (name, value) in kind.declarations_mut() {
                    match value {
                        Some(value) => *value = self.definition(name, *value),
                        None => self.value(name),
                    }
                }
            }
        }
    }

    /// Checks a name whose value comes from elsewhere.
    fn value(&mut self, name: &Name) {
        self.coherent(name);
        self.name(name, None);
    }

    fn name(&mut self, name: &Name, default: Option<String>) {
        if let Some(unit) = &name.unit {
            let declared = (!unit.is_coherent()).then(|| unit.to_string());
            let named = NamedUnit { unit: unit.coherent().to_string(), declared, default };
            self.measured.named.insert(&name.text, named);
        }
    }

    /// Reports a unit that is not coherent although it has no number.
    fn coherent(&mut self, name: &Name) {
        let Some(unit) = name.unit.as_ref().filter(|unit| !unit.is_coherent()) else { return };
        if self.is_said(unit.origin) {
            return;
        }
        let error = self.report.error(unit.origin, messages::nothing_to_convert(&name.text));
        error.help(messages::write_coherent(&name.text, unit.coherent().to_string()));
    }

    fn is_said(&mut self, origin: Origin) -> bool {
        !self.said.insert(format!("{:?}", origin.start))
    }

    /// Returns the value of a definition in coherent units.
    fn definition(&mut self, name: &Name, value: AstId) -> AstId {
        let Some(unit) = &name.unit else { return value };
        let is_scaled = !unit.is_coherent() && is_of_numbers(self.expressions, value);
        let default = is_scaled.then(|| format!("{} {unit}", print::expression(self.expressions, value)));
        self.name(name, default);
        self.number(name, value)
    }

    /// Converts an output, whose run-time values are in the unit after its name.
    fn output(&mut self, name: &Name, value: &mut AstId) {
        if let Some(unit) = &name.unit {
            self.measured.named.insert(&name.text, NamedUnit::of(unit.to_string()));
        }
        if is_of_numbers(self.expressions, *value) {
            *value = self.number(name, *value);
        }
    }

    /// Converts a definition, whose bounds and nominal value are also in its unit.
    fn limited(&mut self, definition: &mut Definition) {
        let is_limited = definition.is_limited();
        let Definition { name, range, nominal, value } = definition;
        let limits = range.limits_mut().map(|limit| &mut limit.value);
        limits.chain(nominal).for_each(|limit| *limit = self.number(name, *limit));
        match value {
            Some(value) => *value = self.definition(name, *value),
            None if is_limited => self.name(name, None),
            None => self.value(name),
        }
    }

    /// Returns a number in the unit of a name, followed by this unit.
    fn number(&mut self, name: &Name, value: AstId) -> AstId {
        let Some(unit) = name.unit.as_ref() else { return value };
        let is_plain = unit.is_coherent() && unit.dimension.is_none();
        if is_of_numbers(self.expressions, value) {
            return if is_plain { value } else { with_unit(self.expressions, value, unit) };
        }
        let has_names = self.expressions.parts(value).into_iter().any(|id| is_name(self.expressions, id));
        if has_names && !unit.is_coherent() && !self.is_said(unit.origin) {
            let (origin, text) = (self.expressions.origin(value), unit.to_string());
            let error = self.report.error(origin, messages::made_of_names(&text));
            error.help(messages::made_of_names_help(&name.text, &text, unit.coherent().to_string()));
        }
        value
    }

    /// Converts the points of a table, which are in the units of its arguments and its value.
    fn table(&mut self, table: &mut TableDefinition) {
        let columns = table.parameters.iter().chain([&table.name]).cloned().collect::<Vec<_>>();
        for (column, number) in table.source.numbers_mut() {
            if let Some(name) = columns.get(column) {
                *number = self.number(name, *number);
            }
        }
        let TableSource::File { contents: Some(contents), .. } = &mut table.source else { return };
        for (_, point) in &mut contents.points {
            for (component, name) in point.iter_mut().zip(&columns) {
                if let Some(unit) = &name.unit {
                    *component = in_coherent_unit(*component, unit);
                }
            }
        }
    }
}

/// Converts a number from a file like a literal: exactly, then rounded.
fn in_coherent_unit(value: f64, unit: &Unit) -> f64 {
    if unit.is_coherent() || !value.is_finite() {
        return value;
    }
    let Scale { number, pi } = &unit.scale;
    let Some(magnitude) = Number::parse_decimal(&format!("{:e}", value.abs())) else {
        return value * unit.scale.to_f64() + unit.offset.to_f64();
    };
    let exact = if value.is_sign_negative() { -&magnitude } else { magnitude };
    let converted = &(&exact * number) + &unit.offset;
    match converted.is_zero() && unit.offset.is_zero() {
        // Zeros keep their signs.
        true => value,
        false => Scale { number: converted, pi: *pi }.to_f64(),
    }
}
