//! Values computed with 300 bits and stored, and lines for a sweep; see `tools/elementary.py`.

use crate::rows::{ROWS, Row};

/// Arguments, the value rounded to a double, and its remainder in units in the last place.
struct Stored {
    at: [f64; 2],
    value: f64,
    missing: f64,
}

fn stored(row: &Row) -> Vec<Stored> {
    let of_row = |line: &&str| line.split(' ').next() == Some(row.name);
    let read = include_str!("reference.txt").lines().filter(of_row).map(|line| {
        let numbers =
            line.split(' ').skip(1).map(|bits| u64::from_str_radix(bits, 16).expect("bits of a double"));
        match numbers.map(f64::from_bits).collect::<Vec<_>>()[..] {
            [x, value, missing] if !row.of_two => Stored { at: [x, 0.0], value, missing },
            [x, y, value, missing] if row.of_two => Stored { at: [x, y], value, missing },
            _ => panic!("{line}"),
        }
    });
    read.collect()
}

fn unit_in_last_place(x: f64) -> f64 {
    let magnitude = x.abs().clamp(f64::MIN_POSITIVE, f64::MAX / 2.0);
    f64::from_bits(magnitude.to_bits() + 1) - f64::from_bits(magnitude.to_bits())
}

/// Asserts the bounds on errors in units in the last place, and prints the largest error.
#[track_caller]
fn assert_bounded(row: &Row, fused: bool) {
    let mut largest = (0.0, [0.0; 2]);
    for Stored { at, value, missing } in stored(row) {
        let found = row.value(fused, at);
        let error = ((found - value) / unit_in_last_place(value) - missing).abs();
        let is_normal = value.abs() >= f64::MIN_POSITIVE || value == 0.0;
        assert!(error <= row.bounds[usize::from(!is_normal)], "{} off by {error} at {at:?}", row.name);
        if is_normal && error > largest.0 {
            largest = (error, at);
        }
    }
    println!("{} {fused}: {largest:?}", row.name);
    assert!(largest.0 > 0.3, "{}: {largest:?}", row.name);
}

#[test]
fn functions_are_within_their_bounds() {
    for row in &ROWS {
        assert!(stored(row).len() > 300);
        assert_bounded(row, false);
        assert_bounded(row, true);
    }
}

/// Prints arguments and values by their bits, for `tools/elementary.py sweep`.
#[test]
#[ignore = "takes a reader with more digits"]
fn sweep() {
    let random = &mut crate::promises::Random(9);
    for row in &ROWS {
        let of_row = stored(row);
        for count in 0..60_000 {
            // Between two arguments of the reference, so that all scales and boundaries occur.
            let mut draw = || &of_row[random.bits() as usize % of_row.len()].at;
            let (first, second) = (draw(), draw());
            let part = random.fraction().powi(1 + count % 5);
            let at = [0, 1].map(|i| first[i] + part * (second[i] - first[i]));
            let mut numbers = at[..1 + usize::from(row.of_two)].to_vec();
            numbers.push(row.value(count % 2 == 0, at));
            let bits: Vec<_> = numbers.iter().map(|number| format!("{:016x}", number.to_bits())).collect();
            println!("{} {}", row.name, bits.join(" "));
        }
    }
}
