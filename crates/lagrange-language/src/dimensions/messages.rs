//! Diagnostics for mistakes in units. In reasons `#` stands for the dimension that something has, `%` for that of a force or moment.

/// Message for a unit that is not coherent where there is no number in it.
pub(super) fn nothing_to_convert(name: &str) -> String {
    format!("there is no number here for this unit to scale: values of `{name}` are in SI units")
}

pub(super) fn in_brackets(quantity: &str) -> String {
    format!("a unit of several factors needs square brackets: `{quantity}`")
}

pub(super) fn write_coherent(name: &str, unit: &str) -> String {
    format!("write `{name}: {unit}`")
}

/// Message for a value made of names behind a unit that is not coherent.
pub(super) fn made_of_names(unit: &str) -> String {
    format!("values computed from names are in SI units, not in `{unit}`")
}

pub(super) fn made_of_names_help(name: &str, unit: &str, coherent: &str) -> String {
    format!("write `{name}: {coherent}`, and the unit after the numbers that are in it: `2 [{unit}]`")
}

pub(super) const ADDED: &str = "the other term is #";
pub(super) const COMPARED: &str = "the other side is #";
pub(super) const CHOSEN: &str = "the other branch is #";
pub(super) const OF_ONE_VECTOR: &str = "another component is #";
pub(super) const EXPONENT: &str = "an exponent is #";
pub(super) const BASE: &str = "the base of a variable power is #";
pub(super) const KINETIC: &str = "`kinetic` adds energies (J)";
pub(super) const POTENTIAL: &str = "`potential` adds energies (J)";
pub(super) const LAGRANGIAN: &str = "the Lagrangian is an energy (J)";
pub(super) const GIBBS: &str = "a Gibbs function is in J/s^2";
pub(super) const DISSIPATION: &str = "`dissipation` adds powers (W)";
pub(super) const STABILISE: &str = "the rate of stabilisation is in 1/s";
pub(super) const POINT: &str = "the components of a point are lengths (m)";
pub(super) const FORCE: &str = "the components of a force are in N";
pub(super) const FORCE_ALONG: &str = "the load along this velocity must be %";
pub(super) const TORQUE: &str = "the load on this angle must be %";
pub(super) const RESTITUTION: &str = "a coefficient of restitution is #";
pub(super) const ASSIGNED: &str = "the assigned quantity is #";
pub(super) const WIDTH: &str = "the slip velocity is #";

pub(super) fn argument_of(function: &str) -> String {
    format!("this argument of `{function}` is #")
}

pub(super) fn plain_argument_of(function: &str) -> String {
    format!("`{function}` is a function of plain numbers and angles")
}

pub(super) fn declared(name: &str, unit: &str) -> String {
    format!("`{name}` is declared in {unit}")
}

pub(super) fn stands_for(name: &str) -> String {
    format!("`{name}` is #")
}

pub(super) fn force_on(name: &str) -> String {
    format!("the force on `{name}` is %")
}

pub(super) fn rate_of(name: &str) -> String {
    format!("the rate of `{name}` is #")
}

pub(super) fn limit(name: &str) -> String {
    format!("the force of `{name}` is %")
}

pub(super) fn labelled(what: &str) -> String {
    format!("{what} is #")
}

/// Message for a contradiction.
pub(super) fn contradiction(found: Option<&str>, said: &str, factor: &str) -> String {
    match found {
        Some(found) => format!("this is {found}, but {said}: {factor}"),
        None => format!("the units do not match, since {said}: {factor}"),
    }
}

pub(super) const MOMENT: &str = "a moment (N*m)";
pub(super) const ANOTHER: &str = "something else";
pub(super) const SQUARE_MISSING: &str = "a square is missing";

/// Describes the missing or superfluous factor, by its noun or else by its unit.
pub(super) fn factor_missing(noun: &str) -> String {
    format!("a factor of {noun} is missing")
}

pub(super) fn factor_too_much(noun: &str) -> String {
    format!("a factor of {noun} is superfluous")
}

pub(super) fn factor_in_unit(unit: &str) -> String {
    format!("a factor in {unit} is missing")
}

pub(super) fn write_square(factor: &str) -> String {
    format!("`{factor}^2` would fit")
}

pub(super) fn write_unit(number: &str, unit: &str) -> String {
    format!("the unit of a number follows it: write `{number} [{unit}]`")
}

/// Message for the unit in `1/2 [kg]`.
pub(super) fn unit_below(number: &str, unit: &str) -> String {
    format!("this unit belongs to the {number} below the fraction line: it divides by `{number} [{unit}]`")
}

pub(super) fn unit_below_help((above, below): (&str, &str), unit: &str) -> String {
    format!("write the unit after the number above it: `{above} [{unit}]/{below}`")
}

/// Advice that lists the units of names.
pub(super) fn units_are(units: &[String]) -> String {
    format!("compare the units of its parts: {}", units.join(", "))
}

pub(super) fn unit_of(name: &str, unit: &str) -> String {
    format!("`{name}` is in {unit}")
}

pub(super) fn plain_number(name: &str) -> String {
    format!("`{name}` is a plain number")
}

pub(super) const REASON_IS_HERE: &str = "it follows from this";
pub(super) const COMPARE_HELP: &str = "compare the units of both sides";

/// Note for a dimension that was found.
pub(super) fn inferred(name: &str, dimension: &str, said: &str) -> String {
    format!("`{name}` is {dimension}, since {said}")
}

pub(super) fn many_radians(number: &str) -> String {
    format!("this is the sine, cosine or tangent of {number} radians")
}

pub(super) fn many_radians_help(number: &str) -> String {
    format!("write `{number} deg` for degrees, or `{number} rad` if radians are meant")
}
