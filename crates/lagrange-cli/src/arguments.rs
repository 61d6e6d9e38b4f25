//! Parsing of the command line into a command.

use std::ffi::OsString;
use std::path::PathBuf;
use std::sync::Arc;

use lagrange_core::code::Precision;
use lagrange_core::pipeline::Backend;
use lagrange_fmi::Version;
use lagrange_import::urdf::Options;
use lexopt::{Arg, Error, Parser, ValueExt};

/// Name of the standard input.
pub(crate) const STANDARD_INPUT: &str = "-";
/// Keyword before a command to be rerun on changes.
const WATCH: &str = "watch";

/// The request on a command line.
#[derive(Debug)]
pub(crate) enum Request {
    /// Prints all commands and options.
    Help,
    /// Prints the version.
    Version,
    /// Runs a command.
    Command(Box<Command>),
    /// Runs a command, and again whenever its files change.
    Watch(Box<Command>),
}

/// A command with its files.
#[derive(Debug)]
pub(crate) struct Command {
    /// The action.
    pub(crate) action: Action,
    /// Files to read: exactly one, except for checks.
    pub(crate) inputs: Vec<PathBuf>,
    /// File to write; the standard output by default.
    pub(crate) output: Option<PathBuf>,
    /// Compiler of the programs of motions, which are interpreted without one.
    pub(crate) backend: Option<Arc<dyn Backend>>,
}

/// An action on files.
#[derive(Clone, Debug)]
pub(crate) enum Action {
    /// Lists errors.
    Check {
        /// True for JSON.
        is_json: bool,
    },
    /// Writes a text derived from a declaration.
    Write(Text),
    /// Writes a C module.
    Module,
    /// Writes a unit of the Functional Mock-up Interface.
    Unit {
        /// Initial values.
        values: Values,
        /// True if no compiled library is included.
        is_source: bool,
        /// Version of the standard.
        version: Version,
    },
    /// Writes a page with a live simulation, from these initial values.
    Page(Values),
    /// Computes a motion.
    Simulate(Settings),
    /// Computes a motion and films it.
    Film(Settings),
    /// Computes many motions.
    Ensemble(EnsembleOptions),
    /// Compares methods.
    Trade(TradeOptions),
    /// Computes a linear model.
    Linearise(Point),
    /// Imports a robot.
    Urdf(Options),
}

/// Initial values, as written.
#[derive(Clone, Default, Debug)]
pub(crate) struct Values {
    /// Parameters and inputs, by name.
    pub(crate) fields: Vec<(String, String)>,
    /// Entries of the state, by name.
    pub(crate) start: Vec<(String, String)>,
}

impl Values {
    /// Reads the value of an option; returns false for unknown names.
    fn read(&mut self, option: &str, parser: &mut Parser) -> Result<bool, Error> {
        match option {
            "set" => self.fields.push(assignment(option, parser)?),
            "start" => self.start.push(assignment(option, parser)?),
            _ => return Ok(false),
        }
        Ok(true)
    }
}

/// Operating point of a linear model, as written.
#[derive(Clone, Default, Debug)]
pub(crate) struct Point {
    /// Values at the operating point.
    pub(crate) values: Values,
    /// Time.
    pub(crate) time: Option<String>,
    /// True to search for a nearby equilibrium.
    pub(crate) is_equilibrium: bool,
    /// Coordinates and states kept fixed by the search.
    pub(crate) hold: Vec<String>,
    /// Inputs adjusted by the search.
    pub(crate) trim: Vec<String>,
    /// True for JSON.
    pub(crate) is_json: bool,
}

impl Point {
    /// Reads the value of an option; returns false for unknown names.
    fn read(&mut self, option: &str, parser: &mut Parser) -> Result<bool, Error> {
        match option {
            "at" => self.values.start.push(assignment(option, parser)?),
            "set" => return self.values.read(option, parser),
            "time" => self.time = Some(parser.value()?.string()?),
            "hold" => self.hold.push(parser.value()?.string()?),
            "trim" => self.trim.push(parser.value()?.string()?),
            _ => return Ok(false),
        }
        Ok(true)
    }
}

/// Settings of a motion, as written.
#[derive(Clone, Default, Debug)]
pub(crate) struct Settings {
    /// Final time.
    pub(crate) until: Option<String>,
    /// Interval between samples.
    pub(crate) every: Option<String>,
    /// Initial values.
    pub(crate) values: Values,
    /// Name of the method.
    pub(crate) method: Option<String>,
    /// Error tolerance.
    pub(crate) tolerance: Option<String>,
    /// Length of steps.
    pub(crate) step: Option<String>,
    /// Seed of noise and of random values.
    pub(crate) seed: Option<String>,
    /// True to add a column with the energy.
    pub(crate) has_energy: bool,
    /// True to draw forces.
    pub(crate) has_forces: bool,
    /// File for the events.
    pub(crate) events: Option<PathBuf>,
}

impl Settings {
    /// Reads the value of an option; returns false for unknown names.
    fn read(&mut self, option: &str, parser: &mut Parser) -> Result<bool, Error> {
        match option {
            "until" => self.until = Some(parser.value()?.string()?),
            "every" => self.every = Some(parser.value()?.string()?),
            "method" => self.method = Some(parser.value()?.string()?),
            "tolerance" => self.tolerance = Some(parser.value()?.string()?),
            "step" => self.step = Some(parser.value()?.string()?),
            "seed" => self.seed = Some(parser.value()?.string()?),
            "events" => self.events = Some(PathBuf::from(parser.value()?)),
            _ => return self.values.read(option, parser),
        }
        Ok(true)
    }
}

/// Settings of many motions, as written.
#[derive(Clone, Default, Debug)]
pub(crate) struct EnsembleOptions {
    /// Common settings.
    pub(crate) settings: Settings,
    /// Quantities that differ between motions, with their ranges; without one, in the declared
    /// range.
    pub(crate) vary: Vec<(String, Option<String>)>,
    /// Number of motions.
    pub(crate) motions: Option<String>,
    /// Number of threads.
    pub(crate) threads: Option<String>,
}

impl EnsembleOptions {
    /// Reads the value of an option; returns false for unknown names.
    fn read(&mut self, option: &str, parser: &mut Parser) -> Result<bool, Error> {
        match option {
            "vary" => {
                let text = parser.value()?.string()?;
                let (name, range) = sides(&text).map_or((text, None), |(name, range)| (name, Some(range)));
                self.vary.push((name, range));
            }
            "motions" => self.motions = Some(parser.value()?.string()?),
            "threads" => self.threads = Some(parser.value()?.string()?),
            "every" | "events" => return Ok(false),
            _ => return self.settings.read(option, parser),
        }
        Ok(true)
    }
}

/// Settings of a comparison of methods, as written.
#[derive(Clone, Default, Debug)]
pub(crate) struct TradeOptions {
    /// Final time of the motion.
    pub(crate) until: Option<String>,
    /// Initial values.
    pub(crate) values: Values,
    /// Error goal.
    pub(crate) error: Option<String>,
    /// Duration of a run after which no finer setting is tried.
    pub(crate) longest: Option<String>,
}

impl TradeOptions {
    /// Reads the value of an option; returns false for unknown names.
    fn read(&mut self, option: &str, parser: &mut Parser) -> Result<bool, Error> {
        match option {
            "until" => self.until = Some(parser.value()?.string()?),
            "error" => self.error = Some(parser.value()?.string()?),
            "longest" => self.longest = Some(parser.value()?.string()?),
            _ => return self.values.read(option, parser),
        }
        Ok(true)
    }
}

/// Reads a version of the Functional Mock-up Interface.
fn fmi_version(parser: &mut Parser) -> Result<Version, Error> {
    match &*parser.value()?.string()? {
        "2" | "2.0" => Ok(Version::Two),
        "3" | "3.0" => Ok(Version::Three),
        other => Err(format!("`--fmi {other}` is not supported: write `--fmi 2` or `--fmi 3`").into()),
    }
}

/// Reads a name and its value.
fn assignment(option: &str, parser: &mut Parser) -> Result<(String, String), Error> {
    let text = parser.value()?.string()?;
    let missing = || format!("`--{option} {text}` has no value: write `--{option} {text}=1`").into();
    sides(&text).ok_or_else(missing)
}

/// Returns the sides of an equals sign.
fn sides(text: &str) -> Option<(String, String)> {
    let (name, value) = text.split_once('=')?;
    Some((name.trim().to_owned(), value.trim().to_owned()))
}

/// A text derived from a declaration.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Text {
    /// Equations, structure and cost.
    Equations,
    /// Equations in LaTeX.
    Latex,
    /// Plain statements.
    Statements,
    /// Emitted code.
    Rust,
    /// Kernel in C.
    Kernel(Precision),
}

impl Action {
    fn named(name: &str) -> Option<Action> {
        Some(match name {
            "check" => Action::Check { is_json: false },
            "equations" => Action::Write(Text::Equations),
            "statements" => Action::Write(Text::Statements),
            "rust" => Action::Write(Text::Rust),
            "c" => Action::Module,
            "fmu" => Action::Unit { values: Values::default(), is_source: false, version: Version::Two },
            "kernel" => Action::Write(Text::Kernel(Precision::Double)),
            "page" => Action::Page(Values::default()),
            "simulate" => Action::Simulate(Settings::default()),
            "film" => Action::Film(Settings::default()),
            "ensemble" => Action::Ensemble(EnsembleOptions::default()),
            "trade" => Action::Trade(TradeOptions::default()),
            "linearise" => Action::Linearise(Point::default()),
            "urdf" => Action::Urdf(Options::default()),
            _ => return None,
        })
    }

    /// Sets a flag; returns false if the action does not have it.
    fn set(&mut self, flag: &str) -> bool {
        match (self, flag) {
            (Action::Check { is_json }, "json") => *is_json = true,
            (Action::Write(text @ Text::Equations), "latex") => *text = Text::Latex,
            (Action::Write(Text::Kernel(precision)), "single") => *precision = Precision::Single,
            (Action::Unit { is_source, .. }, "sources") => *is_source = true,
            (Action::Simulate(settings) | Action::Film(settings), "energy") => settings.has_energy = true,
            (Action::Film(settings), "forces") => settings.has_forces = true,
            (Action::Linearise(point), "equilibrium") => point.is_equilibrium = true,
            (Action::Linearise(point), "json") => point.is_json = true,
            (Action::Urdf(options), "free") => options.is_free = true,
            (Action::Urdf(options), "inputs") => options.has_inputs = true,
            (Action::Urdf(options), "limits") => options.has_limits = true,
            (Action::Urdf(options), "friction") => options.has_friction = true,
            (Action::Urdf(options), "contacts") => options.has_contacts = true,
            (Action::Urdf(options), "trust-inertia") => options.trusts_inertia = true,
            _ => return false,
        }
        true
    }
}

impl Action {
    /// Reads the value of an option; returns false if the action does not have it.
    fn read(&mut self, option: &str, parser: &mut Parser) -> Result<bool, Error> {
        match (self, option) {
            (Action::Unit { version, .. }, "fmi") => *version = fmi_version(parser)?,
            (Action::Unit { values, .. } | Action::Page(values), _) => return values.read(option, parser),
            (Action::Simulate(settings) | Action::Film(settings), _) => return settings.read(option, parser),
            (Action::Ensemble(options), _) => return options.read(option, parser),
            (Action::Trade(options), _) => return options.read(option, parser),
            (Action::Linearise(point), _) => return point.read(option, parser),
            (Action::Urdf(options), "name") => options.name = Some(parser.value()?.string()?),
            (Action::Urdf(options), "corners") => options.corners.push(parser.value()?.string()?),
            _ => return Ok(false),
        }
        Ok(true)
    }
}

/// Reads the arguments after the name of the program.
///
/// # Errors
/// If there is no valid command, an option does not belong to it, or the number of files is wrong.
pub(crate) fn read_arguments(
    mut parser: Parser,
    backend: Option<&Arc<dyn Backend>>,
) -> Result<Request, Error> {
    let mut action = match parser.next()? {
        Some(Arg::Value(name)) if name == WATCH => return watch(parser, backend),
        Some(Arg::Value(name)) => action(name)?,
        Some(Arg::Short('h') | Arg::Long("help")) => return Ok(Request::Help),
        Some(Arg::Short('V') | Arg::Long("version")) => return Ok(Request::Version),
        Some(argument) => return Err(argument.unexpected()),
        None => return Err("a command is missing".into()),
    };
    let (mut inputs, mut output) = (Vec::new(), None);
    while let Some(argument) = parser.next()? {
        match argument {
            Arg::Short('h') | Arg::Long("help") => return Ok(Request::Help),
            Arg::Short('o') | Arg::Long("output") => output = Some(PathBuf::from(parser.value()?)),
            Arg::Value(file) => inputs.push(PathBuf::from(file)),
            Arg::Long(flag) if action.set(flag) => {}
            Arg::Long(option) => {
                let option = option.to_owned();
                if !action.read(&option, &mut parser)? {
                    return Err(Arg::Long(&option).unexpected());
                }
            }
            other => return Err(other.unexpected()),
        }
    }
    match (&action, inputs.len()) {
        (_, 0) => Err("the name of a file is missing; `-` is the standard input".into()),
        (Action::Check { .. }, _) | (_, 1) => {
            Ok(Request::Command(Box::new(Command { action, inputs, output, backend: backend.cloned() })))
        }
        _ => Err("this command takes one file at a time".into()),
    }
}

/// Reads the command after `watch`.
fn watch(parser: Parser, backend: Option<&Arc<dyn Backend>>) -> Result<Request, Error> {
    match read_arguments(parser, backend)? {
        Request::Command(command)
            if command.inputs.iter().any(|input| input.as_os_str() == STANDARD_INPUT) =>
        {
            Err("the standard input cannot be watched: name a file".into())
        }
        Request::Command(command) => Ok(Request::Watch(command)),
        Request::Watch(_) => Err("`watch` is written once".into()),
        other => Ok(other),
    }
}

fn action(name: OsString) -> Result<Action, Error> {
    let name = name.string()?;
    Action::named(&name).ok_or_else(|| format!("unknown command `{name}`").into())
}
