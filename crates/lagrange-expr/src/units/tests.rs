use proc_macro2::Span;

use super::{Dimension, Scale, Unit, UnitFactor, described, meaning, names, spelled};
use crate::number::Number;

/// Values in units of the SI, as numerator and denominator, with exponents of kg, m, s, A, K, mol
/// and cd.
///
/// Sources: SI brochure (9th edition, tables 2 to 8); definition of the yard and the pound of 1959;
/// NIST Guide to the SI, appendix B.8.
const VALUES: [(&str, &str, &str, i32, [i8; 7]); 53] = [
    ("%", "1", "100", 0, [0; 7]),
    ("kg", "1", "1", 0, [1, 0, 0, 0, 0, 0, 0]),
    ("g", "1", "1000", 0, [1, 0, 0, 0, 0, 0, 0]),
    ("mg", "1", "1000000", 0, [1, 0, 0, 0, 0, 0, 0]),
    ("t", "1000", "1", 0, [1, 0, 0, 0, 0, 0, 0]),
    ("km", "1000", "1", 0, [0, 1, 0, 0, 0, 0, 0]),
    ("cm", "1", "100", 0, [0, 1, 0, 0, 0, 0, 0]),
    ("um", "1", "1000000", 0, [0, 1, 0, 0, 0, 0, 0]),
    ("ms", "1", "1000", 0, [0, 0, 1, 0, 0, 0, 0]),
    ("min", "60", "1", 0, [0, 0, 1, 0, 0, 0, 0]),
    ("h", "3600", "1", 0, [0, 0, 1, 0, 0, 0, 0]),
    ("d", "86400", "1", 0, [0, 0, 1, 0, 0, 0, 0]),
    ("mA", "1", "1000", 0, [0, 0, 0, 1, 0, 0, 0]),
    ("mol", "1", "1", 0, [0, 0, 0, 0, 0, 1, 0]),
    ("cd", "1", "1", 0, [0, 0, 0, 0, 0, 0, 1]),
    ("deg", "1", "180", 1, [0; 7]),
    ("arcmin", "1", "10800", 1, [0; 7]),
    ("arcsec", "1", "648000", 1, [0; 7]),
    ("gon", "1", "200", 1, [0; 7]),
    ("mrad", "1", "1000", 0, [0; 7]),
    ("rev", "2", "1", 1, [0; 7]),
    ("rpm", "1", "30", 1, [0, 0, -1, 0, 0, 0, 0]),
    ("kHz", "1000", "1", 0, [0, 0, -1, 0, 0, 0, 0]),
    ("kN", "1000", "1", 0, [1, 1, -2, 0, 0, 0, 0]),
    ("dyn", "1", "100000", 0, [1, 1, -2, 0, 0, 0, 0]),
    ("kgf", "9.80665", "1", 0, [1, 1, -2, 0, 0, 0, 0]),
    ("lbf", "4.4482216152605", "1", 0, [1, 1, -2, 0, 0, 0, 0]),
    ("bar", "100000", "1", 0, [1, -1, -2, 0, 0, 0, 0]),
    ("MPa", "1000000", "1", 0, [1, -1, -2, 0, 0, 0, 0]),
    ("atm", "101325", "1", 0, [1, -1, -2, 0, 0, 0, 0]),
    ("Torr", "20265", "152", 0, [1, -1, -2, 0, 0, 0, 0]),
    ("erg", "1", "10000000", 0, [1, 2, -2, 0, 0, 0, 0]),
    ("kWh", "3600000", "1", 0, [1, 2, -2, 0, 0, 0, 0]),
    ("eV", "1.602176634", "1e19", 0, [1, 2, -2, 0, 0, 0, 0]),
    ("cal", "4.184", "1", 0, [1, 2, -2, 0, 0, 0, 0]),
    ("kW", "1000", "1", 0, [1, 2, -3, 0, 0, 0, 0]),
    ("inch", "0.0254", "1", 0, [0, 1, 0, 0, 0, 0, 0]),
    ("ft", "0.3048", "1", 0, [0, 1, 0, 0, 0, 0, 0]),
    ("yd", "0.9144", "1", 0, [0, 1, 0, 0, 0, 0, 0]),
    ("mi", "1609.344", "1", 0, [0, 1, 0, 0, 0, 0, 0]),
    ("nmi", "1852", "1", 0, [0, 1, 0, 0, 0, 0, 0]),
    ("lb", "0.45359237", "1", 0, [1, 0, 0, 0, 0, 0, 0]),
    ("oz", "0.45359237", "16", 0, [1, 0, 0, 0, 0, 0, 0]),
    ("mph", "0.44704", "1", 0, [0, 1, -1, 0, 0, 0, 0]),
    ("knot", "463", "900", 0, [0, 1, -1, 0, 0, 0, 0]),
    ("L", "1", "1000", 0, [0, 3, 0, 0, 0, 0, 0]),
    ("mL", "1", "1000000", 0, [0, 3, 0, 0, 0, 0, 0]),
    ("ha", "10000", "1", 0, [0, 2, 0, 0, 0, 0, 0]),
    ("V", "1", "1", 0, [1, 2, -3, -1, 0, 0, 0]),
    ("kohm", "1000", "1", 0, [1, 2, -3, -2, 0, 0, 0]),
    ("uF", "1", "1000000", 0, [-1, -2, 4, 2, 0, 0, 0]),
    ("mT", "1", "1000", 0, [1, 0, -2, -1, 0, 0, 0]),
    ("Ah", "3600", "1", 0, [0, 0, 1, 1, 0, 0, 0]),
];

fn decimal(text: &str) -> Number {
    Number::parse_decimal(text).expect("a decimal")
}

fn over(numerator: &Number, denominator: &Number) -> Number {
    numerator * &denominator.reciprocal().expect("not zero")
}

#[test]
fn units_have_their_exact_values() {
    for (name, numerator, denominator, pi, exponents) in VALUES {
        let meaning = meaning(name).unwrap_or_else(|| panic!("`{name}` is a unit"));
        let number = over(&decimal(numerator), &decimal(denominator));
        assert_eq!(meaning.scale, Scale { number, pi }, "{name}");
        assert_eq!(meaning.dimension, Dimension::of(exponents), "{name}");
    }
}

/// A scale with its own zero cannot occur in a product.
#[test]
fn offsets_are_not_in_products() {
    let of = |powers: &[(&str, i8)]| Unit::coherent_of(powers, Span::call_site().into());
    let celsius = of(&[("degC", 1)]).expect("a unit");
    assert_eq!((celsius.offset.to_f64(), celsius.is_coherent()), (273.15, false));
    assert_eq!(celsius.coherent().to_string(), "K");
    for powers in [&[("degC", 2)][..], &[("degC", -1)], &[("W", 1), ("degC", -1)], &[("degC", 1), ("s", 1)]] {
        assert!(of(powers).is_none(), "{powers:?}");
    }
    assert!(meaning("mdegC").is_none());
}

/// Units defined by other units.
#[test]
fn units_fit_their_definitions() {
    let scale = |name: &str| meaning(name).expect("a unit").scale.number;
    assert_eq!(scale("lbf"), &scale("lb") * &scale("gee"));
    assert_eq!(scale("psi"), over(&scale("lbf"), &(&scale("inch") * &scale("inch"))));
    assert_eq!(scale("ft"), &scale("inch") * &Number::from(12));
    assert_eq!(scale("mi"), &scale("ft") * &Number::from(5280));
    assert_eq!(scale("hp"), &(&scale("lbf") * &scale("ft")) * &Number::from(550));
    assert_eq!(scale("PS"), &scale("kgf") * &Number::from(75));
    assert_eq!(scale("mph"), over(&scale("mi"), &scale("h")));
    assert_eq!(scale("knot"), over(&scale("nmi"), &scale("h")));
}

#[test]
fn no_name_means_two_units() {
    let mut all = names();
    all.sort();
    let count = all.len();
    all.dedup();
    assert_eq!(all.len(), count);
    assert!(all.iter().all(|name| meaning(name).is_some()));
    // Whole names take precedence over names with prefixes.
    assert_eq!(meaning("min").map(|minute| minute.scale.number), Some(Number::from(60)));
    assert_eq!(meaning("Pa").map(|pascal| pascal.scale), Some(Scale::ONE));
    for word in ["", "k", "mkg", "kkg", "kmin", "krpm", "x", "kmm"] {
        assert!(meaning(word).is_none(), "{word}");
    }
}

fn unit(factors: &[(&str, i64, i64)]) -> Unit {
    let factor = |&(name, above, below): &(&str, i64, i64)| UnitFactor {
        name: name.to_owned(),
        exponent: Number::ratio(above, below).expect("not zero"),
    };
    Unit::of(factors.iter().map(factor).collect(), Span::call_site().into()).expect("an exact unit")
}

#[test]
fn units_scale_to_coherent_ones() {
    let speed = unit(&[("km", 1, 1), ("h", -1, 1)]);
    assert_eq!(speed.scale, Scale { number: Number::ratio(5, 18).expect("not zero"), pi: 0 });
    let texts = [
        (speed, "km/h", "m/s"),
        (unit(&[("mm", 1, 1)]), "mm", "m"),
        (unit(&[("kN", 1, 1), ("mm", 1, 1)]), "kN*mm", "kN*mm"),
        (unit(&[("kN", 1, 1), ("cm", 1, 1)]), "kN*cm", "N*m"),
        (unit(&[("rpm", 2, 1)]), "rpm^2", "rad^2/s^2"),
        (unit(&[("L", 1, 1), ("min", -1, 1)]), "L/min", "m^3/s"),
        (unit(&[("N", 1, 1), ("m", 1, 1), ("rad", -1, 1)]), "N*m/rad", "N*m/rad"),
        (unit(&[("m", 1, 2)]), "m^(1/2)", "m^(1/2)"),
        (unit(&[]), "1", "1"),
    ];
    for (unit, text, coherent) in texts {
        assert_eq!(unit.to_string(), text);
        assert_eq!(unit.coherent().to_string(), coherent);
        assert_eq!(unit.coherent().dimension, unit.dimension);
        assert!(unit.coherent().is_coherent());
    }
    let root = UnitFactor { name: "km".to_owned(), exponent: Number::HALF };
    assert!(Unit::of(vec![root], Span::call_site().into()).is_none());
}

#[test]
fn dimensions_are_spelled_as_people_write_them() {
    let spellings = [
        ([0; 7], "1", "a plain number"),
        ([1, 1, -2, 0, 0, 0, 0], "N", "a force (N)"),
        ([1, 2, -2, 0, 0, 0, 0], "J", "an energy or a moment (J)"),
        ([1, 0, -2, 0, 0, 0, 0], "N/m", "a stiffness (N/m)"),
        ([1, 2, 0, 0, 0, 0, 0], "kg*m^2", "a moment of inertia (kg*m^2)"),
        ([1, -1, -2, 0, 0, 0, 0], "Pa", "a pressure (Pa)"),
        ([0, 1, -2, 0, 0, 0, 0], "m/s^2", "an acceleration (m/s^2)"),
        ([1, 0, -1, 0, 0, 0, 0], "kg/s", "a quantity in kg/s"),
        ([0, 0, -1, 0, 0, 0, 0], "1/s", "a rate (1/s)"),
        ([1, 2, -3, -1, 0, 0, 0], "V", "a voltage (V)"),
        ([1, 3, -2, 0, 0, 0, 0], "J*m", "a quantity in J*m"),
    ];
    for (exponents, unit, words) in spellings {
        assert_eq!(spelled(&Dimension::of(exponents)), unit);
        assert_eq!(described(&Dimension::of(exponents)), words);
    }
}
