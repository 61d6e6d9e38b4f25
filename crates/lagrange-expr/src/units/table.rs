//! Names of units.

use super::{Dimension, Scale};
use crate::number::Number;

/// The meaning of a unit name.
#[derive(Clone, Debug)]
pub struct UnitMeaning {
    /// Dimension.
    pub dimension: Dimension,
    /// Its factor to the coherent unit.
    pub scale: Scale,
    /// The value of its zero in the coherent unit; not zero for scales of temperature.
    pub offset: Number,
    /// The coherent unit of its dimension, as a product of powers.
    pub coherent: Vec<(&'static str, i8)>,
}

/// A coherent unit with a name.
struct Coherent {
    names: &'static [&'static str],
    /// Exponents of kg, m, s, A, K, mol and cd.
    exponents: [i8; 7],
    takes_prefixes: bool,
}

/// Another unit: a quotient of decimals, times a power of π, of a coherent one.
struct Scaled {
    names: &'static [&'static str],
    numerator: &'static str,
    denominator: &'static str,
    pi: i32,
    offset: &'static str,
    coherent: &'static [(&'static str, i8)],
    takes_prefixes: bool,
}

const fn coherent(names: &'static [&'static str], exponents: [i8; 7]) -> Coherent {
    Coherent { names, exponents, takes_prefixes: true }
}

/// SI base units and derived units with names; messages use the first name.
const COHERENT: [Coherent; 26] = [
    Coherent { names: &["kg"], exponents: [1, 0, 0, 0, 0, 0, 0], takes_prefixes: false },
    coherent(&["m"], [0, 1, 0, 0, 0, 0, 0]),
    coherent(&["s"], [0, 0, 1, 0, 0, 0, 0]),
    coherent(&["A"], [0, 0, 0, 1, 0, 0, 0]),
    coherent(&["K"], [0, 0, 0, 0, 1, 0, 0]),
    coherent(&["mol"], [0, 0, 0, 0, 0, 1, 0]),
    coherent(&["cd"], [0, 0, 0, 0, 0, 0, 1]),
    coherent(&["rad"], [0; 7]),
    coherent(&["sr"], [0; 7]),
    coherent(&["Hz"], [0, 0, -1, 0, 0, 0, 0]),
    coherent(&["N"], [1, 1, -2, 0, 0, 0, 0]),
    coherent(&["Pa"], [1, -1, -2, 0, 0, 0, 0]),
    coherent(&["J"], [1, 2, -2, 0, 0, 0, 0]),
    coherent(&["W"], [1, 2, -3, 0, 0, 0, 0]),
    coherent(&["C"], [0, 0, 1, 1, 0, 0, 0]),
    coherent(&["V"], [1, 2, -3, -1, 0, 0, 0]),
    coherent(&["F"], [-1, -2, 4, 2, 0, 0, 0]),
    coherent(&["ohm", "\u{3a9}", "\u{2126}"], [1, 2, -3, -2, 0, 0, 0]),
    coherent(&["S"], [-1, -2, 3, 2, 0, 0, 0]),
    coherent(&["Wb"], [1, 2, -2, -1, 0, 0, 0]),
    coherent(&["T"], [1, 0, -2, -1, 0, 0, 0]),
    coherent(&["H"], [1, 2, -2, -2, 0, 0, 0]),
    coherent(&["lm"], [0, 0, 0, 0, 0, 0, 1]),
    coherent(&["lx"], [0, -2, 0, 0, 0, 0, 1]),
    coherent(&["Gy", "Sv"], [0, 2, -2, 0, 0, 0, 0]),
    coherent(&["kat"], [0, 0, -1, 0, 0, 1, 0]),
];

const fn scaled(
    names: &'static [&'static str],
    (numerator, denominator, pi): (&'static str, &'static str, i32),
    coherent: &'static [(&'static str, i8)],
) -> Scaled {
    Scaled { names, numerator, denominator, pi, offset: "0", coherent, takes_prefixes: false }
}

const fn prefixed(
    names: &'static [&'static str],
    factor: (&'static str, &'static str, i32),
    coherent: &'static [(&'static str, i8)],
) -> Scaled {
    Scaled { takes_prefixes: true, ..scaled(names, factor, coherent) }
}

/// Units other than the coherent ones, all of them exact.
const SCALED: [Scaled; 43] = [
    scaled(&["%", "percent"], ("1", "100", 0), &[]),
    prefixed(&["g"], ("0.001", "1", 0), &[("kg", 1)]),
    prefixed(&["t"], ("1000", "1", 0), &[("kg", 1)]),
    scaled(&["lb"], ("0.45359237", "1", 0), &[("kg", 1)]),
    scaled(&["oz"], ("0.45359237", "16", 0), &[("kg", 1)]),
    scaled(&["inch"], ("0.0254", "1", 0), &[("m", 1)]),
    scaled(&["ft"], ("0.3048", "1", 0), &[("m", 1)]),
    scaled(&["yd"], ("0.9144", "1", 0), &[("m", 1)]),
    scaled(&["mi"], ("1609.344", "1", 0), &[("m", 1)]),
    scaled(&["nmi"], ("1852", "1", 0), &[("m", 1)]),
    scaled(&["au"], ("149597870700", "1", 0), &[("m", 1)]),
    prefixed(&["L", "l"], ("0.001", "1", 0), &[("m", 3)]),
    scaled(&["ha"], ("10000", "1", 0), &[("m", 2)]),
    scaled(&["min"], ("60", "1", 0), &[("s", 1)]),
    scaled(&["h"], ("3600", "1", 0), &[("s", 1)]),
    scaled(&["d"], ("86400", "1", 0), &[("s", 1)]),
    scaled(&["deg"], ("1", "180", 1), &[("rad", 1)]),
    scaled(&["arcmin"], ("1", "10800", 1), &[("rad", 1)]),
    scaled(&["arcsec"], ("1", "648000", 1), &[("rad", 1)]),
    scaled(&["gon"], ("1", "200", 1), &[("rad", 1)]),
    scaled(&["rev"], ("2", "1", 1), &[("rad", 1)]),
    scaled(&["rpm"], ("1", "30", 1), &[("rad", 1), ("s", -1)]),
    scaled(&["mph"], ("0.44704", "1", 0), &[("m", 1), ("s", -1)]),
    scaled(&["knot"], ("1852", "3600", 0), &[("m", 1), ("s", -1)]),
    scaled(&["gee"], ("9.80665", "1", 0), &[("m", 1), ("s", -2)]),
    prefixed(&["dyn"], ("1e-5", "1", 0), &[("N", 1)]),
    scaled(&["kgf", "kp"], ("9.80665", "1", 0), &[("N", 1)]),
    scaled(&["lbf"], ("4.4482216152605", "1", 0), &[("N", 1)]),
    prefixed(&["bar"], ("100000", "1", 0), &[("Pa", 1)]),
    scaled(&["atm"], ("101325", "1", 0), &[("Pa", 1)]),
    scaled(&["Torr"], ("101325", "760", 0), &[("Pa", 1)]),
    scaled(&["psi"], ("4.4482216152605", "0.00064516", 0), &[("Pa", 1)]),
    prefixed(&["erg"], ("1e-7", "1", 0), &[("J", 1)]),
    prefixed(&["eV"], ("1.602176634e-19", "1", 0), &[("J", 1)]),
    prefixed(&["Wh"], ("3600", "1", 0), &[("J", 1)]),
    prefixed(&["cal"], ("4.184", "1", 0), &[("J", 1)]),
    scaled(&["PS"], ("735.49875", "1", 0), &[("W", 1)]),
    // 550 foot-pounds per second.
    scaled(&["hp"], ("745.69987158227022", "1", 0), &[("W", 1)]),
    prefixed(&["Ah"], ("3600", "1", 0), &[("C", 1)]),
    prefixed(&["P"], ("0.1", "1", 0), &[("Pa", 1), ("s", 1)]),
    prefixed(&["St"], ("0.0001", "1", 0), &[("m", 2), ("s", -1)]),
    prefixed(&["G"], ("0.0001", "1", 0), &[("T", 1)]),
    Scaled { offset: "273.15", ..scaled(&["degC"], ("1", "1", 0), &[("K", 1)]) },
];

/// SI prefixes with their powers of ten.
const PREFIXES: [(&str, i32); 26] = [
    ("Q", 30),
    ("R", 27),
    ("Y", 24),
    ("Z", 21),
    ("E", 18),
    ("P", 15),
    ("T", 12),
    ("G", 9),
    ("M", 6),
    ("k", 3),
    ("h", 2),
    ("da", 1),
    ("d", -1),
    ("c", -2),
    ("m", -3),
    ("u", -6),
    // The micro sign and the Greek letter.
    ("\u{b5}", -6),
    ("\u{3bc}", -6),
    ("n", -9),
    ("p", -12),
    ("f", -15),
    ("a", -18),
    ("z", -21),
    ("y", -24),
    ("r", -27),
    ("q", -30),
];

/// Common prefixes, for suggestions.
const USUAL_PREFIXES: [&str; 8] = ["k", "M", "G", "c", "d", "m", "u", "n"];

/// Common words for units, with their spelling here.
const MEANT: [(&[&str], &str); 27] = [
    (&["Nm", "newtonmeter", "newtonmetre"], "N*m"),
    (&["kNm"], "kN*m"),
    (&["Ns"], "N*s"),
    (&["Nms"], "N*m*s"),
    (&["Pas"], "Pa*s"),
    (&["kmh", "kph"], "km/h"),
    (&["mps"], "m/s"),
    (&["kgm2"], "kg*m^2"),
    (&["meter", "meters", "metre", "metres"], "m"),
    (&["second", "seconds", "sec", "secs"], "s"),
    (&["minute", "minutes"], "min"),
    (&["hour", "hours", "hr"], "h"),
    (&["day", "days"], "d"),
    (&["kilogram", "kilograms", "kilogramme", "Kg", "KG"], "kg"),
    (&["gram", "grams", "gramme"], "g"),
    (&["ton", "tons", "tonne", "tonnes"], "t"),
    (&["newton", "newtons"], "N"),
    (&["joule", "joules"], "J"),
    (&["watt", "watts"], "W"),
    (&["degree", "degrees", "grad"], "deg"),
    (&["radian", "radians"], "rad"),
    (&["volt", "volts"], "V"),
    (&["ampere", "amperes", "amp", "amps"], "A"),
    (&["hertz"], "Hz"),
    (&["kelvin"], "K"),
    (&["celsius", "Celsius"], "degC"),
    (&["Ohm", "ohms"], "ohm"),
];

/// Returns the meaning of a name that is a unit.
pub fn meaning(name: &str) -> Option<UnitMeaning> {
    let exact = named(name).map(|(meaning, _)| meaning);
    exact.or_else(|| PREFIXES.into_iter().find_map(|(prefix, power)| with_prefix(name, prefix, power)))
}

fn with_prefix(name: &str, prefix: &str, power: i32) -> Option<UnitMeaning> {
    let (mut meaning, takes_prefixes) = named(name.strip_prefix(prefix)?)?;
    let factor = Number::from(10).power(power)?;
    meaning.scale.number = &meaning.scale.number * &factor;
    takes_prefixes.then_some(meaning)
}

/// Returns the meaning of a name without a prefix, and true if it accepts one.
fn named(name: &str) -> Option<(UnitMeaning, bool)> {
    if let Some(row) = COHERENT.iter().find(|row| row.names.contains(&name)) {
        let (dimension, coherent) = (Dimension::of(row.exponents), vec![(row.names[0], 1)]);
        return Some((
            UnitMeaning { dimension, scale: Scale::ONE, offset: Number::ZERO, coherent },
            row.takes_prefixes,
        ));
    }
    let row = SCALED.iter().find(|row| row.names.contains(&name))?;
    let mut dimension = Dimension::NONE;
    for (name, exponent) in row.coherent {
        let of_factor = &named(name)?.0.dimension;
        dimension = dimension.times(&of_factor.power(&Number::from(i64::from(*exponent))));
    }
    let denominator = Number::parse_decimal(row.denominator)?.reciprocal()?;
    let number = &Number::parse_decimal(row.numerator)? * &denominator;
    let (scale, offset) = (Scale { number, pi: row.pi }, Number::parse_decimal(row.offset)?);
    Some((UnitMeaning { dimension, scale, offset, coherent: row.coherent.to_vec() }, row.takes_prefixes))
}

/// Returns the unit that was probably intended by a word.
pub fn meant(word: &str) -> Option<&'static str> {
    MEANT.iter().find(|(words, _)| words.contains(&word)).map(|(_, unit)| *unit)
}

/// Returns the names of units that may be intended, including those with common prefixes.
pub fn names() -> Vec<String> {
    let coherent = COHERENT.iter().flat_map(|row| row.names.iter().map(|name| (*name, row.takes_prefixes)));
    let scaled = SCALED.iter().flat_map(|row| row.names.iter().map(|name| (*name, row.takes_prefixes)));
    let all = coherent.chain(scaled).collect::<Vec<_>>();
    let plain = all.iter().map(|(name, _)| (*name).to_owned());
    let prefixable = all.iter().filter(|(_, takes_prefixes)| *takes_prefixes);
    let prefixed =
        prefixable.flat_map(|(name, _)| USUAL_PREFIXES.iter().map(move |prefix| format!("{prefix}{name}")));
    plain.chain(prefixed.filter(|name| named(name).is_none())).collect()
}
