//! Operations and functions against values of many digits, which `tools/double.py` writes.

use std::collections::BTreeMap;

use lagrange_double::Double;
use lagrange_runtime::Number;

fn number(field: &str) -> f64 {
    f64::from_bits(u64::from_str_radix(field, 16).expect("bits"))
}

fn evaluate(function: &str, x: Double, y: Double) -> Double {
    match function {
        "sin" => x.sin(),
        "cos" => x.cos(),
        "tan" => x.tan(),
        "asin" => x.asin(),
        "acos" => x.acos(),
        "atan" => x.atan(),
        "sinh" => x.sinh(),
        "cosh" => x.cosh(),
        "tanh" => x.tanh(),
        "exp" => x.exp(),
        "ln" => x.ln(),
        "sqrt" => x.sqrt(),
        "atan2" => x.atan2(y),
        "hypot" => x.hypot(y),
        "powf" => x.powf(y),
        "add" => x + y,
        "sub" => x - y,
        "mul" => x * y,
        "div" => x / y,
        _ => unreachable!("{function} is not listed"),
    }
}

/// Returns the error of a result in units of 2⁻¹⁰⁶ of the value, a sum of three doubles.
fn error(found: Double, value: &[f64]) -> f64 {
    let (upper, lower) = found.parts();
    if value[0] == 0.0 {
        return if upper == 0.0 { 0.0 } else { f64::INFINITY };
    }
    // Differences of neighbouring doubles are exact.
    let difference = ((upper - value[0]) + (lower - value[1])) - value[2];
    (difference / value[0]).abs() * 2_f64.powi(106)
}

#[test]
fn results_keep_their_bounds() {
    let mut largest = BTreeMap::new();
    for line in include_str!("functions.csv").lines().skip(1) {
        let fields: Vec<_> = line.split(',').collect();
        let words: Vec<_> = fields[1..].iter().map(|field| number(field)).collect();
        let found =
            evaluate(fields[0], Double::from_sum(words[0], words[1]), Double::from_sum(words[2], words[3]));
        let error = error(found, &words[4..]);
        let bound = match fields[0] {
            "add" | "sub" => 3.0001,
            "mul" => 5.0,
            "div" => 15.0001,
            "sqrt" => 3.125,
            _ => 1.0,
        };
        assert!(error <= bound, "{line}: {found:?}, {error}");
        let entry = largest.entry(fields[0]).or_insert(0.0_f64);
        *entry = entry.max(error);
    }
    assert_eq!(largest.len(), 19);
    println!("{largest:#?}");
}
