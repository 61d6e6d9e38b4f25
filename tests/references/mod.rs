//! Reference trajectories of 30 digits, computed by `tools/references.py` and
//! `tools/mechanisms.py`, and of 20 digits by `tools/control.py` and `tools/spatial_mechanisms.py`.

use std::str::FromStr;

const TABLES: [&str; 4] = [
    include_str!("states.csv"),
    include_str!("mechanisms.csv"),
    include_str!("control.csv"),
    include_str!("spatial_mechanisms.csv"),
];

/// The meaning of a declaration's decimals in a reference.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[allow(dead_code, reason = "each target that includes this module needs some of it")]
pub(crate) enum Numbers {
    /// Exact decimals.
    Decimal,
    /// The nearest numbers of 53 bits.
    Binary,
}

/// Returns the state of a case at a time in the table; `time` is the nearest number.
///
/// # Panics
/// Panics if the table has no such state, or one of another length.
#[allow(dead_code, reason = "each target that includes this module needs some of it")]
pub(crate) fn state<const N: usize>(case: &str, numbers: Numbers, time: f64) -> [f64; N] {
    let values = entries(case, numbers, time);
    values.try_into().unwrap_or_else(|found| panic!("{case} at {time}: {found:?} in the references"))
}

/// Returns the entries of such a state, as numbers that keep more of their digits.
///
/// # Panics
/// Panics if one cannot be read.
pub(crate) fn entries<T: FromStr>(case: &str, numbers: Numbers, time: f64) -> Vec<T> {
    let numbers = match numbers {
        Numbers::Decimal => "decimal",
        Numbers::Binary => "binary",
    };
    let values = TABLES.into_iter().flat_map(|table| table.lines().skip(1)).filter_map(|line| {
        let mut columns = line.split(',');
        let here = columns.next() == Some(case)
            && columns.next() == Some(numbers)
            && columns.next().and_then(|text| text.parse().ok()) == Some(time);
        here.then(|| columns.nth(1).and_then(|text| text.parse().ok()).expect("a value in every row"))
    });
    values.collect()
}
