//! Dimensions in declarations: numbers in coherent units, and the dimension of each name.
//!
//! Numbers at run time are in coherent SI units. A number in another unit is scaled exactly, before
//! any other processing: `param l: mm = 500` has the default 1/2. A declaration without units
//! passes unchanged. A declaration with only units of angles and plain numbers is scaled but not
//! checked.
//!
//! In any other declaration every name has one dimension, whether declared or not. Statements
//! determine dimensions: energies are added, terms of a sum have the same dimension, and arguments
//! of sines are plain numbers. These are equations between products of powers of dimensions. They
//! are linear in exponents, and are solved one after the other by elimination. An equation that
//! contradicts earlier ones is an error in its expression, reported with the chain of contradicting
//! equations. Source: Kennedy, *Dimension types*, ESOP 1994.

mod calls;
mod checker;
mod defaults;
mod exponents;
mod expressions;
mod kinds;
mod labels;
mod measure;
mod messages;
mod quantities;
mod report;
mod solver;
mod statements;
use crate::syntax::ast::{Declaration, acceleration_name};
use checker::Checker;
use defaults::name_state;
use lagrange_expr::diagnostics::Report;
use lagrange_expr::units::{Dimension, NamedUnit, NamedUnits, component_name, momentum_name, spelled};
use measure::Measure;

pub use defaults::{Measured, in_coherent_units};

/// Checks dimensions of a declaration in plain statements. Returns the declared or inferred units
/// of names.
pub fn check_dimensions(declaration: &Declaration, measured: Measured, report: &mut Report) -> NamedUnits {
    let mut named = measured.named;
    if declaration.has_units {
        name_state(declaration, &mut named);
    }
    if !declaration.has_dimensions {
        return named;
    }
    let mut checker = Checker::new(&declaration.expressions);
    statements::check(&mut checker, declaration, &measured.labels);
    report::report(&checker, measured.last_written, report);
    name_what_was_found(&checker, declaration, &mut named);
    named
}

fn name_what_was_found(checker: &Checker<'_>, declaration: &Declaration, named: &mut NamedUnits) {
    let of = |name: &str| checker.scope.get(&name.to_owned()).and_then(|value| common(checker, value));
    declaration.fields().for_each(|name| add(named, &name.text, of(&name.text)));
    declaration.outputs().for_each(|name| name_output(checker, &name.text, named));
    let second = Dimension::of(kinds::TIME);
    let action = Dimension::of(kinds::ENERGY).times(&second);
    for position in declaration.coordinates() {
        let dimension = of(&position.text);
        add(
            named,
            &momentum_name(&position.text),
            dimension.as_ref().map(|dimension| action.over(dimension)),
        );
        add(named, &position.text, dimension);
    }
    for velocity in declaration.velocities() {
        let rate = velocity.coordinate.and_then(|coordinate| of(&coordinate.text));
        let rate = rate.map(|dimension| dimension.over(&second)).or_else(|| of(&velocity.name.text));
        let acceleration = rate.as_ref().map(|rate| rate.over(&second));
        add(named, &acceleration_name(&velocity.name.text), acceleration);
        add(named, &velocity.name.text, rate);
    }
}

/// Records the unit of an output, or those of its components if they differ.
fn name_output(checker: &Checker<'_>, name: &str, named: &mut NamedUnits) {
    let Some(value) = checker.scope.get(&statements::output_key(name)) else { return };
    if let Some(dimension) = common(checker, value) {
        return add(named, name, Some(dimension));
    }
    for (index, form) in value.components.iter().enumerate() {
        let dimension = form.as_ref().and_then(|form| checker.solver.dimension(form));
        add(named, &component_name(name, index), dimension);
    }
}

/// Records the coherent unit of a known dimension.
fn add(named: &mut NamedUnits, name: &str, dimension: Option<Dimension>) {
    if let Some(dimension) = dimension {
        named.insert(name, NamedUnit::of(spelled(&dimension)));
    }
}

/// Returns the common dimension of all components except zeros, which have any dimension.
fn common(checker: &Checker<'_>, value: &Measure) -> Option<Dimension> {
    let mut known = value.components.iter().flatten().map(|form| checker.solver.dimension(form));
    let first = known.next()??;
    known.all(|other| other.as_ref() == Some(&first)).then_some(first)
}
