//! Many motions of a declared system: from textual ranges to final states.

use std::path::Path;

use lagrange_dynamic::{DeclaredSystem, EnsembleEnds, EnsembleSettings};
use lagrange_runtime::ensemble::Random;

use crate::arguments::{EnsembleOptions, Values};
use crate::meter::Meter;
use crate::motions::{Failure, check_format, end, method, named_value, no_start, number, set, start_values};

/// Default number of motions.
const MOTIONS: u64 = 100;
/// Maximum number of motions.
const MAX_MOTIONS: u64 = 10_000_000;
/// Suffix of the names of columns with initial values.
const AT_START: &str = " at start";

/// A quantity that is uniformly distributed over the motions in a range.
struct Varied<'a> {
    name: &'a str,
    low: f64,
    high: f64,
    /// True for an entry of the initial state, false for a parameter or an input.
    is_entry: bool,
}

/// Computes the final states of motions with these options, and sets the parameters of the system.
/// Varied entries of the initial state are additional columns, `x at start`.
///
/// # Errors
/// If an option is invalid, with the first one.
pub(crate) fn ends(
    options: &EnsembleOptions,
    output: Option<&Path>,
    system: &mut DeclaredSystem,
) -> Result<EnsembleEnds, Failure> {
    check_format(output, &["csv"])?;
    let varied = options.vary.iter().map(|(name, range)| varied(name, range.as_deref(), system));
    let varied = varied.collect::<Result<Vec<_>, Failure>>()?;
    check_names(&varied, options)?;
    for Varied { name, low, .. } in varied.iter().filter(|varied| !varied.is_entry) {
        system.set(name, *low).map_err(|_| unknown(name, system))?;
    }
    set(&options.settings.values, system)?;
    let (settings, entries) = settings(options, &varied, system)?;
    let meter = Meter::new();
    let ends = system.ensemble_watched(&settings, &|part| {
        meter.show(part);
        false
    });
    drop(meter);
    let mut ends = ends.map_err(|error| Failure::Usage(error.to_string()))?;
    for (name, values) in entries {
        ends.names.push(name + AT_START);
        ends.columns.push(values);
    }
    Ok(ends)
}

/// Checks that each quantity has its value from a single option.
fn check_names(varied: &[Varied<'_>], options: &EnsembleOptions) -> Result<(), Failure> {
    let Values { fields, start } = &options.settings.values;
    for (index, Varied { name, .. }) in varied.iter().enumerate() {
        if varied[..index].iter().any(|other| other.name == *name) {
            return Err(Failure::Usage(format!("`{name}` varies twice")));
        }
        for (option, values) in [("set", fields), ("start", start)] {
            if values.iter().any(|(other, _)| other == name) {
                return Err(Failure::Usage(format!("`{name}` varies: remove its `--{option}`")));
            }
        }
    }
    Ok(())
}

fn unknown(name: &str, system: &DeclaredSystem) -> Failure {
    let known = system.settable().map(str::to_owned).chain(system.state_names());
    let known = known.map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ");
    Failure::Usage(format!("--vary: there is no `{name}`; known are {known}"))
}

/// Returns a quantity that varies in a range, `LOW..HIGH`, or in its declared range.
fn varied<'a>(name: &'a str, range: Option<&str>, system: &DeclaredSystem) -> Result<Varied<'a>, Failure> {
    let [low, high] = match range {
        Some(range) => range_of(name, range, system)?,
        None => declared_range(name, system)?,
    };
    if low >= high || !(high - low).is_finite() {
        let of = range.map_or_else(String::new, |range| format!("={range}"));
        return Err(Failure::Usage(format!("--vary {name}{of}: the first number must be below the second")));
    }
    let is_entry = system.state_names().iter().any(|known| known == name);
    Ok(Varied { name, low, high, is_entry })
}

/// Parses `LOW..HIGH`.
fn range_of(name: &str, range: &str, system: &DeclaredSystem) -> Result<[f64; 2], Failure> {
    let missing = || Failure::Usage(format!("--vary {name}={range}: a range is missing: write `0..1`"));
    let (low, high) = range.split_once("..").ok_or_else(missing)?;
    let [low, high] = [low, high].map(|text| named_value("vary", (name, text), system));
    Ok([low?, high?])
}

fn declared_range(name: &str, system: &DeclaredSystem) -> Result<[f64; 2], Failure> {
    let is_known = system.settable().any(|known| known == name)
        || system.state_names().iter().any(|known| known == name);
    if !is_known {
        return Err(unknown(name, system));
    }
    let unbounded =
        format!("--vary {name}: it has no declared range with two bounds: write `--vary {name}=0..1`");
    system.bounds(name).ok_or(Failure::Usage(unbounded))
}

/// Columns by name, with one value for each motion.
type Columns = Vec<(String, Vec<f64>)>;

/// Initial states of motions, and a column for each varied quantity.
type Drawn = (Vec<Vec<f64>>, Vec<Vec<f64>>);

/// Returns the settings of the ensemble, and the varied entries of its initial states.
fn settings(
    options: &EnsembleOptions,
    varied: &[Varied<'_>],
    system: &DeclaredSystem,
) -> Result<(EnsembleSettings, Columns), Failure> {
    let motions = number("motions", options.motions.as_deref())?.unwrap_or(MOTIONS);
    let threads = number("threads", options.threads.as_deref())?;
    if !(1..=MAX_MOTIONS).contains(&motions) {
        return Err(Failure::Usage(format!("--motions {motions}: it must be from 1 to {MAX_MOTIONS}")));
    }
    let threads = threads.map(|threads| usize::try_from(threads).unwrap_or(usize::MAX));
    if threads == Some(0) {
        return Err(Failure::Usage("--threads 0: at least one thread is needed".to_owned()));
    }
    let seed = number("seed", options.settings.seed.as_deref())?.unwrap_or(0);
    let (starts, columns) = drawn(options, varied, (seed, motions), system)?;
    let (until, method) = (end(options.settings.until.as_deref())?, method(&options.settings)?);
    let (entries, fields) = varied.iter().zip(columns).partition::<Vec<_>, _>(|(varied, _)| varied.is_entry);
    let named = |columns: Vec<(&Varied<'_>, Vec<f64>)>| {
        columns.into_iter().map(|(varied, column)| (varied.name.to_owned(), column)).collect()
    };
    let varied = named(fields);
    Ok((EnsembleSettings { starts, varied, from: 0.0, until, method, threads }, named(entries)))
}

/// Draws the values of each motion in writing order; its initial state may depend on them. A motion
/// that starts out of a declared range fails by itself.
fn drawn(
    options: &EnsembleOptions,
    varied: &[Varied<'_>],
    (seed, motions): (u64, u64),
    system: &DeclaredSystem,
) -> Result<Drawn, Failure> {
    let given = start_values("start", &options.settings.values, system)?;
    let (mut starts, mut columns) = (Vec::new(), vec![Vec::new(); varied.len()]);
    let mut system = system.clone();
    for motion in 0..motions {
        let (mut random, mut entries) = (Random::start(seed, motion as usize), given.clone());
        for (Varied { name, low, high, is_entry }, column) in varied.iter().zip(&mut columns) {
            let value = random.uniform(*low..*high);
            column.push(value);
            if *is_entry {
                entries.push(((*name).to_owned(), value));
            } else {
                system.set(name, value).map_err(|_| unknown(name, &system))?;
            }
        }
        starts.push(system.unchecked_start(&entries).map_err(|error| no_start("start", error))?);
    }
    Ok((starts, columns))
}

/// Returns the final states as CSV: times, states, outputs, and parameters if one varies.
pub(crate) fn csv(ends: &EnsembleEnds, system: &DeclaredSystem) -> String {
    let titled = |name: &String| match system.variables().unit(name.trim_end_matches(AT_START)) {
        Some(unit) => format!(",{name} in {unit}"),
        None => format!(",{name}"),
    };
    let mut text = "t in s".to_owned() + &ends.names.iter().map(titled).collect::<String>() + "\n";
    for (motion, time) in ends.times.iter().enumerate() {
        let cells = ends.columns.iter().map(|column| format!(",{:?}", column[motion]));
        text += &format!("{time:?}{}\n", cells.collect::<String>());
    }
    text
}
