//! Diagnostics for errors in units. In reasons `#` is replaced by the dimension of something, and
//! `%` by that of a force or moment.

use lagrange_expr::diagnostics::messages;

messages! {
    pub(super):

    /// Message for a unit that is not coherent but has no number to convert.
    nothing_to_convert(name) =
        "there is no number here for this unit to scale: values of `{name}` are in SI units";
    in_brackets(quantity) = "a unit of several factors needs square brackets: `{quantity}`";
    write_coherent(name, unit) = "write `{name}: {unit}`";

    /// Message for a value computed from names before a unit that is not coherent.
    made_of_names(unit) = "values computed from names are in SI units, not in `{unit}`";
    made_of_names_help(name, unit, coherent) =
        "write `{name}: {coherent}`, and the unit after the numbers that are in it: `2 [{unit}]`";
    ADDED = "the other term is #";
    COMPARED = "the other side is #";
    CHOSEN = "the other branch is #";
    OF_ONE_VECTOR = "another component is #";
    EXPONENT = "an exponent is #";
    BASE = "the base of a variable power is #";
    KINETIC = "`kinetic` adds energies (J)";
    POTENTIAL = "`potential` adds energies (J)";
    LAGRANGIAN = "the Lagrangian is an energy (J)";
    GIBBS = "a Gibbs function is in J/s^2";
    DISSIPATION = "`dissipation` adds powers (W)";
    STABILISE = "the rate of stabilisation is in 1/s";
    PERIOD = "the period of a clock is in s";
    LAG = "a delay is a time in s";
    POINT = "the components of a point are lengths (m)";
    FORCE = "the components of a force are in N";
    FORCE_ALONG = "the load along this velocity must be %";
    TORQUE = "the load on this angle must be %";
    RESTITUTION = "a coefficient of restitution is #";
    ASSIGNED = "the assigned quantity is #";
    STARTS = "the quantity that starts at this value is #";
    HISTORIES = "the quantity with this history is #";
    RANGES = "the quantity with this range is #";
    WIDTH = "the slip velocity is #";
    argument_of(function) = "this argument of `{function}` is #";
    plain_argument_of(function) = "`{function}` is a function of plain numbers and angles";
    declared(name, unit) = "`{name}` is declared in {unit}";
    stands_for(name) = "`{name}` is #";
    force_on(name) = "the force on `{name}` is %";
    rate_of(name) = "the rate of `{name}` is #";
    density_of(name) = "the density of the noise `{name}`, its square times a time, is #";
    limit(name) = "the force of `{name}` is %";
    labelled(what) = "{what} is #";
    MOMENT = "a moment (N*m)";
    ANOTHER = "something else";
    SQUARE_MISSING = "a square is missing";

    /// Describes the missing or superfluous factor, by its noun or otherwise by its unit.
    factor_missing(noun) = "a factor of {noun} is missing";
    factor_too_much(noun) = "a factor of {noun} is one too many";
    factor_in_unit(unit) = "a factor in {unit} is missing";
    write_square(factor) = "`{factor}^2` would fit";
    write_unit(number, unit) = "the unit of a number follows it: write `{number} [{unit}]`";

    /// Message for the unit in `1/2 [kg]`.
    unit_below(number, unit) =
        "this unit belongs to the {number} below the fraction line: it divides by `{number} [{unit}]`";
    unit_of(name, unit) = "`{name}` is in {unit}";
    plain_number(name) = "`{name}` is a plain number";
    REASON_IS_HERE = "it follows from this";
    COMPARE_HELP = "compare the units of both sides";

    /// Note for an inferred dimension.
    inferred(name, dimension, said) = "`{name}` is {dimension}, since {said}";
    many_radians(number) = "this is the sine, cosine or tangent of {number} radians";
    many_radians_help(number) = "write `{number} deg` for degrees, or `{number} rad` if radians are meant";
}

/// Returns the message for a contradiction.
pub(super) fn contradiction(found: Option<&str>, said: &str, factor: &str) -> String {
    match found {
        Some(found) => format!("this is {found}, but {said}: {factor}"),
        None => format!("the units do not match, since {said}: {factor}"),
    }
}

pub(super) fn unit_below_help((above, below): (&str, &str), unit: &str) -> String {
    format!("write the unit after the number above it: `{above} [{unit}]/{below}`")
}

/// Returns advice that lists the units of names.
pub(super) fn units_are(units: &[String]) -> String {
    format!("compare the units of its parts: {}", units.join(", "))
}
