//! Many motions of a declared system: from ranges as they are written to the ends of motions.

use lagrange_dynamic::{DeclaredSystem, EnsembleEnds, EnsembleSettings};
use lagrange_runtime::ensemble::Random;

use crate::arguments::Many;
use crate::motions::{Failure, end, method, named_value, set, start_from, start_values};

/// Number of motions if it is not specified.
const MOTIONS: u64 = 100;

/// A quantity that differs between motions, uniformly in a range.
struct Varied<'a> {
    name: &'a str,
    low: f64,
    high: f64,
    /// Its place in the state; none if it is a parameter or an input.
    place: Option<usize>,
}

/// Understands settings, sets the parameters of the system and computes the ends of motions.
/// Entries of the start that vary are further columns, `x at start`.
///
/// # Errors
/// The first setting that makes no sense.
pub(crate) fn ends(many: &Many, system: &mut DeclaredSystem) -> Result<EnsembleEnds, Failure> {
    let varied = many.vary.iter().map(|(name, range)| varied(name, range, system));
    let varied = varied.collect::<Result<Vec<_>, Failure>>()?;
    for Varied { name, low, .. } in varied.iter().filter(|varied| varied.place.is_none()) {
        system.set(name, *low).map_err(|_| unknown(name, system))?;
    }
    set(&many.settings.values, system)?;
    let settings = settings(many, &varied, system)?;
    let mut ends = system.ensemble(&settings).map_err(|error| Failure::Usage(error.to_string()))?;
    for Varied { name, place, .. } in varied {
        let Some(place) = place else { continue };
        ends.names.push(format!("{name} at start"));
        ends.columns.push(settings.starts.iter().map(|start| start[place]).collect());
    }
    Ok(ends)
}

fn unknown(name: &str, system: &DeclaredSystem) -> Failure {
    let known = system.variables().fields.iter().cloned().chain(system.state_names());
    let known = known.map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ");
    Failure::Usage(format!("--vary: there is no `{name}`; known are {known}"))
}

/// Reads `LOW..HIGH`.
fn varied<'a>(name: &'a str, range: &str, system: &DeclaredSystem) -> Result<Varied<'a>, Failure> {
    let wrong = |why: &str| Failure::Usage(format!("--vary {name}={range}: {why}"));
    let sides = range.split_once("..").ok_or_else(|| wrong("a range is missing: write `0..1`"))?;
    let [low, high] = [sides.0, sides.1].map(|text| named_value("vary", (name, text), system));
    let (low, high) = (low?, high?);
    if low >= high || !(high - low).is_finite() {
        return Err(wrong("the first number must be below the second"));
    }
    let place = system.state_names().iter().position(|known| known == name);
    Ok(Varied { name, low, high, place })
}

fn settings(
    many: &Many,
    varied: &[Varied<'_>],
    system: &DeclaredSystem,
) -> Result<EnsembleSettings, Failure> {
    let mut values = start_values("start", &many.settings.values, system)?;
    let entries = varied.iter().filter(|varied| varied.place.is_some());
    values.extend(entries.map(|entry| (entry.name.to_owned(), entry.low)));
    let near = start_from("start", &values, system)?;
    let motions = number("motions", many.motions.as_deref())?.unwrap_or(MOTIONS);
    let threads = number("threads", many.threads.as_deref())?;
    if motions == 0 || threads == Some(0) {
        return Err(Failure::Usage("the numbers of motions and threads must be positive".to_owned()));
    }
    let seed = number("seed", many.seed.as_deref())?.unwrap_or(0);
    let (starts, varied) = drawn(&near, varied, seed, motions as usize);
    let (until, method) = (end(&many.settings)?, method(&many.settings)?);
    let threads = threads.map(|threads| threads as usize);
    Ok(EnsembleSettings { starts, varied, from: 0.0, until, method, threads })
}

/// The starts of motions, and parameters by name with a value for each motion.
type Drawn = (Vec<Vec<f64>>, Vec<(String, Vec<f64>)>);

/// Draws the values of each motion in the order in which they are written.
fn drawn(near: &[f64], varied: &[Varied<'_>], seed: u64, motions: usize) -> Drawn {
    let mut starts = vec![near.to_vec(); motions];
    let mut columns = vec![Vec::new(); varied.len()];
    for (motion, start) in starts.iter_mut().enumerate() {
        let mut random = Random::start(seed, motion);
        for (Varied { low, high, place, .. }, column) in varied.iter().zip(&mut columns) {
            let value = random.uniform(*low..*high);
            match place {
                Some(place) => start[*place] = value,
                None => column.push(value),
            }
        }
    }
    let fields = varied.iter().zip(columns).filter(|(varied, _)| varied.place.is_none());
    (starts, fields.map(|(varied, column)| (varied.name.to_owned(), column)).collect())
}

/// Reads a whole number, if it is written.
fn number(option: &str, text: Option<&str>) -> Result<Option<u64>, Failure> {
    let wrong = |text: &str| Failure::Usage(format!("--{option} {text}: expected a whole number"));
    text.map(|text| text.trim().parse().map_err(|_| wrong(text))).transpose()
}

/// Returns the ends as CSV: times, states, outputs, and parameters if one varies.
pub(crate) fn csv(ends: &EnsembleEnds, system: &DeclaredSystem) -> String {
    let quantity = |name: &str| name.strip_suffix(" at start").unwrap_or(name).to_owned();
    let titled = |name: &String| match system.variables().unit(&quantity(name)) {
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
