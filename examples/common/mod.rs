//! Shared code of the examples.

/// Prints computed values next to their references.
///
/// # Panics
/// If a value differs from its reference by more than `tolerance` times the larger of 1 and the
/// reference.
#[track_caller]
pub(crate) fn compare(title: &str, tolerance: f64, rows: &[(&str, f64, f64)]) {
    println!("{title}\n{:>16} {:>24} {:>24} {:>10}", "", "computed", "reference", "error");
    for &(name, computed, reference) in rows {
        let error = (computed - reference).abs();
        println!("{name:>16} {computed:>24.16} {reference:>24.16} {error:>10.1e}");
        assert!(error <= tolerance * reference.abs().max(1.0), "{name} differs by more than {tolerance:e}");
    }
    println!();
}
