//! Declarations as text: printed text is parsed as the same statements.
//!
//! Each statement is on a separate line, and parentheses are only written where operators need
//! them. Comments, documentation and the head of the declaration are omitted.

mod arrays;
mod callables;
mod expressions;
mod numbers;
mod parts;
mod scenes;

use super::ast::{
    Action, AllowedRange, Assignment, AstId, BinaryOperator, Block, Declaration, Definition, Direction,
    EmitItem, Event, Expression, Expressions, Friction, Name, Reduction, ReductionItem, ReductionKind,
    StatementKind,
};

/// Writes the statements of a declaration, each on a separate line.
///
/// A question mark, which has no meaning in the language, stands for unreadable parts.
pub fn statements(declaration: &Declaration) -> String {
    let mut printer = Printer { expressions: &declaration.expressions, out: String::new() };
    for statement in &declaration.statements {
        printer.statement(&statement.kind);
        printer.text("\n");
    }
    printer.out
}

/// Writes a single expression.
pub fn expression(expressions: &Expressions, id: AstId) -> String {
    let mut printer = Printer { expressions, out: String::new() };
    printer.expression(id);
    printer.out
}

/// Writes the range of a parameter: `in 0..=1` or `> 0`.
pub fn range(expressions: &Expressions, range: &AllowedRange) -> String {
    let mut printer = Printer { expressions, out: String::new() };
    printer.range(range);
    printer.out.trim_start().to_owned()
}

/// A printer that appends text.
struct Printer<'a> {
    expressions: &'a Expressions,
    out: String,
}

impl Printer<'_> {
    fn text(&mut self, text: &str) {
        self.out.push_str(text);
    }

    /// Prints items separated by commas.
    fn list<T>(&mut self, items: &[T], mut print: impl FnMut(&mut Self, &T)) {
        for (i, item) in items.iter().enumerate() {
            self.text(if i == 0 { "" } else { ", " });
            print(self, item);
        }
    }

    /// Prints a text and an expression.
    fn labelled(&mut self, label: &str, value: AstId) {
        self.text(label);
        self.expression(value);
    }

    fn statement(&mut self, kind: &StatementKind) {
        match kind {
            StatementKind::Parameters(list) => self.definitions("param ", list),
            StatementKind::Inputs(list) => self.definitions("input ", list),
            StatementKind::Noises(list) => self.noises(list),
            StatementKind::Constants(list) => self.definitions("const ", list),
            StatementKind::Coordinates(list) => self.definitions("coord ", list),
            StatementKind::States(kind, list) => self.definitions(&format!("{} ", kind.keyword()), list),
            StatementKind::Mode(mode) => {
                self.text("mode ");
                self.name(&mode.name);
                for (number, value) in mode.values.iter().enumerate() {
                    self.text(if number == 0 { " = " } else { " | " });
                    self.name(value);
                }
                self.text(";");
            }
            StatementKind::Start(assignments) => self.entries("start ", assignments),
            StatementKind::History(assignments) => self.entries("history ", assignments),
            StatementKind::Ranges(entries) => {
                self.text("range ");
                self.list(entries, |printer, entry| {
                    printer.expression(entry.target);
                    printer.limited(&entry.range, entry.nominal);
                });
                self.text(";");
            }
            StatementKind::StateRate(name, value) => {
                self.text("dot(");
                self.name(name);
                self.between(") = ", *value, ";");
            }
            StatementKind::RateEquation(difference) => match self.expressions.get(*difference) {
                Expression::Binary(BinaryOperator::Subtract, _, left, right) => {
                    self.expression(*left);
                    self.between(" = ", *right, ";");
                }
                _ => self.between("0 = ", *difference, ";"),
            },
            StatementKind::Quaternion(quaternion) => {
                self.text("quaternion ");
                self.name(&quaternion.name);
                self.text(";");
            }
            StatementKind::Velocity(name, value) => self.named("velocity ", name, *value),
            StatementKind::Let(name, value) => self.named("let ", name, *value),
            StatementKind::LetTuple(names, value) => {
                self.text("let (");
                self.list(names, Self::name);
                self.between(") = ", *value, ";");
            }
            StatementKind::Function(function) => {
                self.text("let ");
                self.signature(&function.name, &function.parameters);
                self.between(" = ", function.value, ";");
            }
            StatementKind::External(function) => self.external(function),
            StatementKind::Table(table) => self.table(table),
            StatementKind::Solve(unknowns) => self.unknowns(unknowns),
            StatementKind::Kinetic(value) => self.between("kinetic = ", *value, ";"),
            StatementKind::Potential(value) => self.between("potential = ", *value, ";"),
            StatementKind::Lagrangian(value) => self.between("lagrangian = ", *value, ";"),
            StatementKind::Gibbs { function, stated } => {
                self.labelled("gibbs = ", *function);
                self.between(", for: ", *stated, ";");
            }
            StatementKind::Dissipation(value) => self.between("dissipation = ", *value, ";"),
            StatementKind::ForceOn(name, value) => self.named("force ", name, *value),
            StatementKind::ForceAt { force, point } => {
                self.labelled("force ", *force);
                self.between(" at ", *point, ";");
            }
            StatementKind::ForceAlong { force, velocity } => {
                self.labelled("force ", *force);
                self.between(" along ", *velocity, ";");
            }
            StatementKind::Torque { moment, angle } => {
                self.labelled("torque ", *moment);
                self.between(" on ", *angle, ";");
            }
            StatementKind::Constraint(name, value) => self.named("constraint ", name, *value),
            StatementKind::Stabilise(value) => self.between("stabilise = ", *value, ";"),
            StatementKind::Event(event) => self.event(event),
            StatementKind::Every(clock) => {
                self.labelled("every ", clock.period);
                self.text(" => ");
                self.assignments(&clock.assignments);
            }
            StatementKind::Friction(friction) => self.friction(friction),
            StatementKind::Delay { name, signal, lag } => self.delay(name, *signal, *lag),
            StatementKind::Output(name, value) => self.named("output ", name, *value),
            StatementKind::Emit(items) => self.emit(items),
            StatementKind::Reduce(reduction) => self.reduction(reduction),
            StatementKind::Block(Block::Repeat(repetition)) => self.repetition(repetition),
            StatementKind::Block(Block::Select(selection)) => self.selection(selection),
            StatementKind::Block(Block::Part(part)) => self.part_definition(part),
            StatementKind::Block(Block::Place(placement)) => self.placement(placement),
            StatementKind::Block(Block::Include(path)) => self.text(&format!("include {:?};", path.text)),
            StatementKind::Scene(statement) => self.scene(statement),
        }
    }

    fn between(&mut self, before: &str, value: AstId, behind: &str) {
        self.labelled(before, value);
        self.text(behind);
    }

    /// Prints `keyword name = value;`.
    fn named(&mut self, keyword: &str, name: &Name, value: AstId) {
        self.text(keyword);
        self.name(name);
        self.between(" = ", value, ";");
    }

    /// Prints `start x = e, dot(x) = f;`.
    fn entries(&mut self, keyword: &str, assignments: &[Assignment]) {
        self.text(keyword);
        self.list(assignments, |printer, assignment| {
            printer.expression(assignment.target);
            printer.labelled(" = ", assignment.value);
        });
        self.text(";");
    }

    /// Prints `let name = delay(signal, lag);`.
    fn delay(&mut self, name: &Name, signal: AstId, lag: AstId) {
        self.text("let ");
        self.name(name);
        self.between(" = delay(", signal, ", ");
        self.between("", lag, ");");
    }

    fn definitions(&mut self, keyword: &str, definitions: &[Definition]) {
        self.text(keyword);
        self.list(definitions, |printer, definition| {
            printer.name(&definition.name);
            printer.limited(&definition.range, definition.nominal);
            printer.assigned(definition.value);
        });
        self.text(";");
    }

    /// Prints a statement for each noise, on one line.
    fn noises(&mut self, noises: &[Definition]) {
        for (i, Definition { name, value, .. }) in noises.iter().enumerate() {
            self.text(if i == 0 { "noise " } else { " noise " });
            self.name(name);
            value.iter().for_each(|density| self.labelled(", density: ", *density));
            self.text(";");
        }
    }

    /// Prints ` in 0..=1 nominal 0.1`.
    fn limited(&mut self, range: &AllowedRange, nominal: Option<AstId>) {
        self.range(range);
        nominal.iter().for_each(|nominal| self.labelled(" nominal ", *nominal));
    }

    /// Prints ` in 0..=1` or ` > 0`.
    fn range(&mut self, range: &AllowedRange) {
        match (range.lower, range.upper) {
            (None, None) => {}
            (Some(lower), None) if !lower.is_included => self.labelled(" > ", lower.value),
            (Some(lower), Some(upper)) if !lower.is_included => {
                self.labelled(" > ", lower.value);
                self.labelled(if upper.is_included { " <= " } else { " < " }, upper.value);
            }
            (lower, upper) => {
                self.text(" in ");
                lower.iter().for_each(|limit| self.expression(limit.value));
                self.text(if upper.is_some_and(|limit| limit.is_included) { "..=" } else { ".." });
                upper.iter().for_each(|limit| self.expression(limit.value));
            }
        }
    }

    fn assigned(&mut self, value: Option<AstId>) {
        if let Some(value) = value {
            self.labelled(" = ", value);
        }
    }

    fn event(&mut self, event: &Event) {
        self.text("event ");
        self.name(&event.name);
        self.labelled(" = ", event.value);
        self.text(match event.direction {
            Direction::Rising => ", rising => ",
            Direction::Falling => ", falling => ",
            Direction::Crossing => ", crossing => ",
        });
        match &event.action {
            Action::Stop => self.text("stop;"),
            Action::Record => self.text("record;"),
            Action::Impact(restitution) => self.between("impact(", *restitution, ");"),
            Action::Assign(assignments) => self.assignments(assignments),
        }
    }

    fn assignments(&mut self, assignments: &[Assignment]) {
        self.text("{");
        let lines = assignments.iter().map(|assignment| (&assignment.enclosures[..], assignment));
        self.enclosed_lines(lines, |printer, assignment| {
            printer.labelled(" ", assignment.target);
            printer.between(" = ", assignment.value, ";");
        });
        self.text(" }");
    }

    fn friction(&mut self, friction: &Friction) {
        self.text("friction ");
        self.name(&friction.name);
        self.labelled(" = ", friction.slip);
        match friction.fixed {
            None => self.labelled(", ", friction.kinetic),
            Some(fixed) => {
                self.labelled(", kinetic: ", friction.kinetic);
                self.labelled(", static: ", fixed);
            }
        }
        if let Some(width) = friction.width {
            self.labelled(", smooth: ", width);
        }
        self.text(";");
    }

    fn emit(&mut self, items: &[EmitItem]) {
        self.text("emit { ");
        self.list(items, |printer, item| {
            printer.text(if item.wanted { "" } else { "no " });
            printer.text(&item.product.text);
        });
        self.text(" }");
    }

    fn reduction(&mut self, reduction: &Reduction) {
        self.text("reduce ");
        self.text(&reduction.name.text);
        self.text(" {");
        let is_free = |item: &ReductionItem| item.enclosures.is_empty();
        let lines = reduction.items.chunk_by(|a, b| a.kind == b.kind && is_free(a) && is_free(b));
        self.enclosed_lines(lines.map(|line| (&line[0].enclosures[..], line)), |printer, line| {
            printer.text(match line[0].kind {
                ReductionKind::Frozen => " freeze ",
                ReductionKind::Small => " small ",
                ReductionKind::Ignored => " ignore ",
            });
            printer.list(line, |printer, item| {
                printer.name(&item.coordinate);
                printer.assigned(item.value);
            });
            printer.text(";");
        });
        self.text(" }");
    }
}
