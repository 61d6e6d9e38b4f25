//! Declarations in text: rates and motions by compiled Rust, by Cranelift and by the interpreter.

use std::fmt::Write;

/// Motions of these systems are in the table of motions, under these names.
const MOVING: [&str; 4] = ["DoublePendulum", "FiveMasses", "Rod", "Top"];

/// A row of `cargo bench` in `crates/lagrange-jit`.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Declared {
    system: String,
    /// Number of entries of the state.
    entries: usize,
    /// Nanoseconds for each evaluation of the rates: Rust, Cranelift, interpreter.
    rates: [f64; 3],
    /// Nanoseconds for each evaluation in a motion, with the work of the method.
    motion: [f64; 3],
    /// Milliseconds from text to programs, and from programs to the first evaluation of compiled
    /// rates.
    reading: f64,
    compiling: f64,
}

impl Declared {
    pub(super) fn read(cells: &[&str]) -> Option<Declared> {
        let [system, entries, numbers @ ..] = cells else { return None };
        // Rows of the benchmark of series have a tolerance there.
        let entries = entries.parse().ok()?;
        let numbers = numbers.iter().map(|cell| cell.parse()).collect::<Result<Vec<f64>, _>>().ok()?;
        let [a, b, c, d, e, f, reading, compiling] = numbers[..] else { return None };
        let system = system.to_string();
        Some(Declared { system, entries, rates: [a, b, c], motion: [d, e, f], reading, compiling })
    }

    /// Returns the name in tables.
    fn title(&self) -> &str {
        match self.system.as_str() {
            "DoublePendulum" => "double pendulum",
            "FiveMasses" => "five masses and springs",
            "Rod" => "point on a rod, in Cartesian coordinates",
            "Top" => "spinning top, with a quaternion",
            "Chain10" => "chain of 10",
            "Chain30" => "chain of 30",
            "Arm7" => "arm with seven joints",
            other => other,
        }
    }
}

/// Returns the times of rates.
pub(super) fn rates(rows: &[Declared]) -> String {
    let mut table = "| system | rustc, ns | Cranelift, ns | more, ns | interpreter, ns | to compile, ms |\n\
                     |---|---|---|---|---|---|\n"
        .to_owned();
    for row in rows {
        let [rustc, cranelift, interpreter] = row.rates;
        let (more, title) = (cranelift - rustc, row.title());
        let compiling = significant(row.compiling);
        let _ = writeln!(
            table,
            "| {title} | {rustc:.0} | {cranelift:.0} | {more:.0} | {interpreter:.0} | {compiling} |"
        );
    }
    table
}

/// Returns the times of motions.
pub(super) fn motions(rows: &[Declared]) -> String {
    let mut table = "| system | entries of the state | compiled Rust | Cranelift | interpreted | from text to programs |\n\
                     |---|---|---|---|---|---|\n"
        .to_owned();
    for row in rows.iter().filter(|row| MOVING.contains(&row.system.as_str())) {
        let ([rustc, cranelift, interpreter], title, entries) = (row.motion, row.title(), row.entries);
        let ratios = [cranelift, interpreter].map(|time| significant(time / rustc));
        let _ = writeln!(
            table,
            "| {title} | {entries} | {rustc:.0} | {cranelift:.0} ({} ×) | {interpreter:.0} ({} ×) | {:.1} ms |",
            ratios[0], ratios[1], row.reading
        );
    }
    table
}

/// Formats a number with two digits, or all digits before the point.
fn significant(number: f64) -> String {
    match number {
        number if number < 1.0 => format!("{number:.2}"),
        number if number < 10.0 => format!("{number:.1}"),
        _ => format!("{number:.0}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_become_both_tables() {
        let row = |system| [system, "4", "31.4", "109", "990", "51", "80", "582", "3.14", "0.412"];
        let rows = ["DoublePendulum", "Chain10"].map(|system| Declared::read(&row(system)).expect("a row"));
        assert!(rates(&rows).ends_with("| chain of 10 | 31 | 109 | 78 | 990 | 0.41 |\n"), "{}", rates(&rows));
        assert!(
            motions(&rows).ends_with("| double pendulum | 4 | 51 | 80 (1.6 ×) | 582 (11 ×) | 3.1 ms |\n")
        );
        assert_eq!(Declared::read(&row("Rod")[..9]), None);
        let series = ["Kepler", "1e-6", "1e-7", "0.1", "0.2", "0.3", "1e-8", "0.1", "0.2", "0.3"];
        assert_eq!(Declared::read(&series), None);
        assert_eq!(Declared::read(&["system", "entries", "to compile"]), None);
    }
}
