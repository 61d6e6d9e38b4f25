//! Motions of declared systems: from textual settings to files.

use std::io::Write;
use std::path::Path;

use lagrange_core::model::Product;
use lagrange_dynamic::{
    DeclaredFilm, DeclaredSystem, DynamicSystem, MethodChoice, MethodError, RunSettings, StartError, Visitor,
};
use lagrange_files::save_bytes;
use lagrange_runtime::simulate::Trajectory;

use crate::arguments::{Settings, Values};
use crate::console::answer;
use crate::meter::Meter;
use crate::values::value;

/// Formats of files, by extension.
const FORMATS: [&str; 4] = ["csv", "parquet", "svg", "png"];
/// Formats of films in the plane and in space.
const FILMS: [[&str; 3]; 2] = [["html", "gif", "svg"], ["html", "gif", "glb"]];
/// Seconds between the pictures of a film.
const PICTURE: f64 = 0.04;

/// The reason why a motion or a linear model is missing or incomplete.
#[derive(Debug)]
pub(crate) enum Failure {
    /// The settings are invalid.
    Usage(String),
    /// The motion failed after writing its results so far, or there is no linear model.
    Ended(String),
    /// A file cannot be written.
    File(String),
}

/// A motion with validated settings.
pub(crate) struct Motion<'a> {
    run: RunSettings,
    output: Option<&'a Path>,
    events: Option<&'a Path>,
    /// System to be filmed, if a film is requested.
    filmed: Option<DeclaredSystem>,
    /// True to draw forces in the film.
    has_forces: bool,
}

impl<'a> Motion<'a> {
    /// Reads settings, and sets the parameters of the system.
    ///
    /// # Errors
    /// If a setting is invalid, with the first one.
    pub(crate) fn new(
        settings: &'a Settings,
        output: Option<&'a Path>,
        system: &mut DeclaredSystem,
    ) -> Result<Self, Failure> {
        check_format(output, &FORMATS)?;
        Motion::of(settings, output, system)
    }

    /// Reads settings of a film, and sets the parameters of the system, which includes its drawing.
    ///
    /// # Errors
    /// If a setting is invalid, with the first one.
    pub(crate) fn filmed(
        settings: &'a Settings,
        output: Option<&'a Path>,
        system: &mut DeclaredSystem,
    ) -> Result<Self, Failure> {
        let is_in_space = system.programs().drawing.as_ref().is_some_and(|drawing| drawing.is_in_space);
        check_format(output, &FILMS[usize::from(is_in_space)])?;
        let mut motion = Motion::of(settings, output, system)?;
        motion.run.every.get_or_insert(PICTURE);
        Ok(Motion { filmed: Some(system.clone()), ..motion })
    }

    fn of(
        settings: &'a Settings,
        output: Option<&'a Path>,
        system: &mut DeclaredSystem,
    ) -> Result<Self, Failure> {
        set(&settings.values, system)?;
        let until = end(settings.until.as_deref())?;
        if settings.has_energy && system.programs().product(Product::Energy).is_none() {
            return Err(Failure::Usage("--energy: the declaration excludes the energy".to_owned()));
        }
        let method = method(settings)?;
        if settings.seed.is_some() && !method.has_seed() {
            return Err(Failure::Usage(
                "`--seed` chooses the noise of the methods `maruyama` and `stochastic`".to_owned(),
            ));
        }
        let run = RunSettings {
            start: start("start", &settings.values, system)?,
            from: 0.0,
            until,
            every: settings.every.as_deref().map(|text| time("every", text)).transpose()?,
            method,
            has_energy: settings.has_energy,
        };
        let (events, has_forces) = (settings.events.as_deref(), settings.has_forces);
        Ok(Motion { run, output, events, filmed: None, has_forces })
    }
}

/// Returns the end time.
///
/// # Errors
/// If it is missing or invalid.
pub(crate) fn end(until: Option<&str>) -> Result<f64, Failure> {
    let missing = || Failure::Usage("the end is missing: write `--until 10`".to_owned());
    time("until", until.ok_or_else(missing)?)
}

/// Parses a whole number, if it is given.
///
/// # Errors
/// If the text is not a whole number.
pub(crate) fn number(option: &str, text: Option<&str>) -> Result<Option<u64>, Failure> {
    let wrong = |text: &str| Failure::Usage(format!("--{option} {text}: expected a whole number"));
    text.map(|text| text.trim().parse().map_err(|_| wrong(text))).transpose()
}

/// Returns the method with its settings.
///
/// # Errors
/// If the method is unknown, or does not have one of the settings.
pub(crate) fn method(settings: &Settings) -> Result<MethodChoice, Failure> {
    let tolerance = settings.tolerance.as_deref().map(|text| {
        let bad = |error| Failure::Usage(format!("--tolerance {text}: {error}"));
        value("--tolerance", text, None).map_err(bad)
    });
    let step = settings.step.as_deref().map(|text| time("step", text));
    let choice = MethodChoice::new(settings.method.as_deref(), tolerance.transpose()?, step.transpose()?);
    let seed = number("seed", settings.seed.as_deref())?.unwrap_or(0);
    choice.map(|method| method.with_seed(seed)).map_err(|error| {
        Failure::Usage(match error {
            MethodError::Useless { method, setting } => format!("the method `{method}` has no `--{setting}`"),
            MethodError::WithoutStep(method) => {
                format!("the method `{method}` needs a step: write `--step 0.01`")
            }
            error => error.to_string(),
        })
    })
}

/// Sets parameters and inputs.
///
/// # Errors
/// If a value is invalid or missing, with the first one.
pub(crate) fn set(values: &Values, system: &mut DeclaredSystem) -> Result<(), Failure> {
    for (name, text) in &values.fields {
        let value = named_value("set", (name, text), system)?;
        system.set(name, value).map_err(|error| Failure::Usage(format!("--set: {error}")))?;
    }
    match system.missing() {
        Some(name) => Err(Failure::Usage(format!("`{name}` has no value: write `--set {name}=1`"))),
        None => Ok(()),
    }
}

/// Returns the initial state, with entries set by the option of this name.
///
/// # Errors
/// If a value is invalid or missing, with the first one.
pub(crate) fn start(option: &str, values: &Values, system: &DeclaredSystem) -> Result<Vec<f64>, Failure> {
    let values = start_values(option, values, system)?;
    system.start_with(&values).map_err(|error| no_start(option, error))
}

/// Returns the entries set by the option of this name.
///
/// # Errors
/// If a value is invalid, with the first one.
pub(crate) fn start_values(
    option: &str,
    values: &Values,
    system: &DeclaredSystem,
) -> Result<Vec<(String, f64)>, Failure> {
    let named =
        |(name, text): &(String, String)| Ok((name.clone(), named_value(option, (name, text), system)?));
    values.start.iter().map(named).collect()
}

/// Returns the failure of a command whose option of this name leaves it without an initial state.
pub(crate) fn no_start(option: &str, error: StartError) -> Failure {
    match error {
        StartError::Missing(name) => Failure::Usage(format!(
            "the start of `{name}` is missing: write `--{option} {name}=0`, or declare it"
        )),
        error => Failure::Usage(format!("--{option}: {error}")),
    }
}

/// Returns the value of a variable of the system in coherent units. Plain numbers are in the
/// declared unit.
///
/// # Errors
/// If it is invalid.
pub(crate) fn named_value(
    option: &str,
    (name, text): (&str, &str),
    system: &DeclaredSystem,
) -> Result<f64, Failure> {
    let unit = system.variables().declared_unit(name);
    value(name, text, unit).map_err(|error| Failure::Usage(format!("--{option} {name}={text}: {error}")))
}

/// Parses a time, in seconds by default.
///
/// # Errors
/// If it is invalid.
pub(crate) fn time(option: &str, text: &str) -> Result<f64, Failure> {
    value(&format!("--{option}"), text, Some("s"))
        .map_err(|error| Failure::Usage(format!("--{option} {text}: {error}")))
}

/// Checks that a file has one of these formats as its extension.
///
/// # Errors
/// If it does not.
pub(crate) fn check_format(output: Option<&Path>, formats: &[&str]) -> Result<(), Failure> {
    let Some(path) = output else { return Ok(()) };
    match extension(path) {
        Some(format) if formats.contains(&format) => Ok(()),
        _ => {
            let (path, formats) = (path.display(), formats.join(", "));
            Err(Failure::Usage(format!("{path}: the extension must be one of {formats}")))
        }
    }
}

fn extension(path: &Path) -> Option<&str> {
    path.extension()?.to_str()
}

impl Visitor for Motion<'_> {
    type Output = Result<(), Failure>;

    /// Computes and writes the motion.
    fn visit<const CAPACITY: usize>(self, system: &DynamicSystem<CAPACITY>) -> Result<(), Failure> {
        let meter = Meter::new();
        let found = self.run.run_watched(system, &|part| {
            meter.show(part);
            false
        });
        drop(meter);
        match found {
            Ok(motion) => self.write(&motion).map_err(Failure::File),
            Err(failure) if failure.cause.is_refusal() => Err(Failure::Usage(failure.cause.to_string())),
            Err(failure) => {
                self.write(&failure.trajectory).map_err(Failure::File)?;
                Err(Failure::Ended(failure.to_string()))
            }
        }
    }
}

impl Motion<'_> {
    fn write<const CAPACITY: usize>(
        &self,
        motion: &Trajectory<DynamicSystem<CAPACITY>>,
    ) -> Result<(), String> {
        match (self.output, self.output.and_then(extension)) {
            _ if self.filmed.is_some() => self.film(motion)?,
            (None, _) => answer(|output| motion.write_csv(output))?,
            (Some(path), Some("csv")) => motion.save_csv(path).map_err(|error| error.to_string())?,
            (Some(path), Some("parquet")) => motion.save_parquet(path).map_err(|error| error.to_string())?,
            (Some(path), _) => motion.plot_states(path).map_err(|error| error.to_string())?,
        }
        match self.events {
            Some(path) => {
                save_bytes(path, events(motion)).map_err(|error| format!("{}: {error}", path.display()))
            }
            None => Ok(()),
        }
    }
}

impl Motion<'_> {
    /// Writes the film of a motion.
    fn film<const CAPACITY: usize>(
        &self,
        motion: &Trajectory<DynamicSystem<CAPACITY>>,
    ) -> Result<(), String> {
        let Some(system) = &self.filmed else { return Ok(()) };
        let states = motion.iter().map(|(_, state)| state).collect::<Vec<_>>();
        let states = states.iter().map(AsRef::as_ref);
        let film = DeclaredFilm::new(system, motion.times(), states, self.has_forces);
        let film = film.and_then(|film| match motion.column("energy") {
            Some(energy) => film.with_column("energy", energy),
            None => Ok(film),
        });
        let film = film.map_err(|error| error.to_string())?;
        match self.output {
            Some(path) => film.save(path).map_err(|error| error.to_string()),
            None => answer(|output| output.write_all(film.html().as_bytes())),
        }
    }
}

/// Returns the events of a motion as CSV: time, name and state.
fn events<const CAPACITY: usize>(motion: &Trajectory<DynamicSystem<CAPACITY>>) -> String {
    let state = &motion.names()[..motion.first().as_ref().len()];
    let mut text = format!("t,event,{}\n", state.join(","));
    for event in motion.events() {
        let state = event.state.as_ref().iter().map(|value| format!(",{value:?}")).collect::<String>();
        text += &format!("{:?},{}{state}\n", event.time, event.name);
    }
    text
}
