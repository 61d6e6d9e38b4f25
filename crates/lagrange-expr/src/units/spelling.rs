//! Dimensions and units as words and symbols.

use super::Dimension;
use crate::number::Number;

/// Coherent units for the spelling of quantities, in addition to base units.
const DERIVED: [(&str, [i8; 7]); 9] = [
    ("N", [1, 1, -2, 0, 0, 0, 0]),
    ("J", [1, 2, -2, 0, 0, 0, 0]),
    ("W", [1, 2, -3, 0, 0, 0, 0]),
    ("Pa", [1, -1, -2, 0, 0, 0, 0]),
    ("C", [0, 0, 1, 1, 0, 0, 0]),
    ("V", [1, 2, -3, -1, 0, 0, 0]),
    ("ohm", [1, 2, -3, -2, 0, 0, 0]),
    ("T", [1, 0, -2, -1, 0, 0, 0]),
    ("H", [1, 2, -2, -2, 0, 0, 0]),
];

/// Nouns for quantities by dimension.
const NOUNS: [(&str, [i8; 7]); 24] = [
    ("a plain number", [0; 7]),
    ("a mass", [1, 0, 0, 0, 0, 0, 0]),
    ("a length", [0, 1, 0, 0, 0, 0, 0]),
    ("a time", [0, 0, 1, 0, 0, 0, 0]),
    ("a current", [0, 0, 0, 1, 0, 0, 0]),
    ("a temperature", [0, 0, 0, 0, 1, 0, 0]),
    ("an area", [0, 2, 0, 0, 0, 0, 0]),
    ("a volume", [0, 3, 0, 0, 0, 0, 0]),
    ("a velocity", [0, 1, -1, 0, 0, 0, 0]),
    ("an acceleration", [0, 1, -2, 0, 0, 0, 0]),
    ("a rate", [0, 0, -1, 0, 0, 0, 0]),
    ("an angular acceleration", [0, 0, -2, 0, 0, 0, 0]),
    ("a force", [1, 1, -2, 0, 0, 0, 0]),
    ("an energy or a moment", [1, 2, -2, 0, 0, 0, 0]),
    ("a power", [1, 2, -3, 0, 0, 0, 0]),
    ("a pressure", [1, -1, -2, 0, 0, 0, 0]),
    ("a momentum", [1, 1, -1, 0, 0, 0, 0]),
    ("an angular momentum", [1, 2, -1, 0, 0, 0, 0]),
    ("a moment of inertia", [1, 2, 0, 0, 0, 0, 0]),
    ("a stiffness", [1, 0, -2, 0, 0, 0, 0]),
    ("a density", [1, -3, 0, 0, 0, 0, 0]),
    ("a charge", [0, 0, 1, 1, 0, 0, 0]),
    ("a voltage", [1, 2, -3, -1, 0, 0, 0]),
    ("a resistance", [1, 2, -3, -2, 0, 0, 0]),
];

/// Spells the coherent unit of a dimension: `N`, `J` and other short names if they are shorter than
/// base units.
pub fn spelled(dimension: &Dimension) -> String {
    let base = powers(dimension);
    let length = |powers: &[(&str, Number)]| -> f64 {
        powers.iter().map(|(_, exponent)| exponent.abs().to_f64().max(1.0)).sum()
    };
    let mut best = base;
    for (name, exponents) in DERIVED {
        for exponent in [1_i64, -1] {
            let exponent = Number::from(exponent);
            let rest = dimension.over(&Dimension::of(exponents).power(&exponent));
            // Masses must be used up and not introduced: an acceleration is not in N/kg.
            let is_out_of_place = !rest.exponents()[0].is_zero() || dimension.exponents()[0].is_zero();
            if is_out_of_place && name != "C" {
                continue;
            }
            let mut candidate = vec![(name, exponent)];
            candidate.extend(powers(&rest));
            if length(&candidate) < length(&best) {
                best = candidate;
            }
        }
    }
    product(&best)
}

fn powers(dimension: &Dimension) -> Vec<(&'static str, Number)> {
    let powers = super::BASE_UNITS.into_iter().zip(dimension.exponents());
    powers
        .filter(|(_, exponent)| !exponent.is_zero())
        .map(|(name, exponent)| (name, exponent.clone()))
        .collect()
}

/// Describes a dimension: `a force (N)`, or `a quantity in kg*m^3` without a word for it.
pub fn described(dimension: &Dimension) -> String {
    let noun = NOUNS.iter().find(|(_, exponents)| Dimension::of(*exponents) == *dimension);
    match noun {
        Some((noun, _)) if dimension.is_none() => (*noun).to_owned(),
        Some((noun, _)) => format!("{noun} ({})", spelled(dimension)),
        None => format!("a quantity in {}", spelled(dimension)),
    }
}

/// Returns the word for a dimension without its article, such as `length`; `None` for plain numbers
/// and if there is no word.
pub fn noun(dimension: &Dimension) -> Option<&'static str> {
    let (noun, _) = NOUNS.iter().find(|(_, exponents)| Dimension::of(*exponents) == *dimension)?;
    let (_, word) = noun.split_once(' ')?;
    (!dimension.is_none()).then(|| word.split(" or ").next().unwrap_or(word))
}

/// Writes a product of powers: `kg*m^2/s`, `1/(m*s)`, `m^(1/2)`.
pub(super) fn product(powers: &[(&str, Number)]) -> String {
    let factor = |(name, exponent): &(&str, Number)| match exponent.abs() {
        exponent if exponent.is_one() => (*name).to_owned(),
        exponent if exponent.is_integer() => format!("{name}^{exponent}"),
        exponent => format!("{name}^({exponent})"),
    };
    let side = |is_below: bool| {
        let powers = powers.iter().filter(|(_, exponent)| exponent.is_negative() == is_below);
        powers.map(factor).collect::<Vec<_>>()
    };
    let (above, below) = (side(false), side(true));
    let above = if above.is_empty() { "1".to_owned() } else { above.join("*") };
    match below.len() {
        0 => above,
        1 => format!("{above}/{}", below[0]),
        _ => format!("{above}/({})", below.join("*")),
    }
}
