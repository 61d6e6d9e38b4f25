//! Execution of the commands.

use std::ffi::OsStr;
use std::io::Write;
use std::path::{Path, PathBuf};

use lagrange_c::{Module, Refusal};
use lagrange_core::derive::StrategyChoice;
use lagrange_core::diagnostics::Report;
use lagrange_core::model::Product;
use lagrange_core::pipeline::{Derived, Programs, System};
use lagrange_dynamic::{DeclaredSystem, MethodChoice, Source};
use lagrange_files::save_bytes;
use lagrange_fmi::{ExportError, MockupUnit, Start, Version};
use lagrange_import::listing;
use lagrange_import::urdf::{Import, Options, import};
use lagrange_page::{PageError, page};
use proc_macro2::TokenStream;
use quote::quote;
use serde_json::Value;

use crate::analyses::Linearised;
use crate::arguments::{Action, Command, EnsembleOptions, Point, Settings, Text, TradeOptions, Values};
use crate::console::{answer, report};
use crate::ensembles;
use crate::mistakes;
use crate::motions::{Failure, Motion, method, set, start};
use crate::source;
use crate::trades;

/// Number of operations above which compilers need minutes for the derivatives in units.
const MAX_DERIVATIVES: usize = 20_000;

/// The result of a command, whose errors have been printed.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Ended {
    /// Without errors.
    Well,
    /// With errors in files.
    WithMistakes,
    /// With options that are invalid for the file.
    Misused,
    /// With a motion that failed before its end.
    Early,
}

/// The failure of a command, whose errors have been printed.
struct Printed;

type Outcome<T> = Result<T, Printed>;

impl Command {
    /// Runs the command. Errors are printed.
    pub(crate) fn run(&self) -> Ended {
        let text = match &self.action {
            Action::Check { is_json } => return ended(self.check(*is_json)),
            Action::Simulate(settings) => return self.simulate(settings),
            Action::Film(settings) => return self.film(settings),
            Action::Ensemble(options) => return self.ensemble(options),
            Action::Trade(options) => return self.trade(options),
            Action::Linearise(point) => return self.linearise(point),
            Action::Module => return ended(self.source().and_then(|source| self.module(&source)).is_ok()),
            Action::Page(values) => return self.page(values),
            Action::Unit { values, is_source, version } => return self.unit(values, *is_source, *version),
            Action::Urdf(options) => self.source().and_then(|source| robot(&source, options)),
            Action::Write(text) => self.source().and_then(|source| written(&source, *text)),
        };
        ended(text.and_then(|text| write(self.output.as_deref(), &text)).is_ok())
    }

    /// Computes a motion and writes it.
    fn simulate(&self, settings: &Settings) -> Ended {
        let product = product(settings);
        let Ok(mut system) = self.source().and_then(|source| self.declared(&source, product)) else {
            return Ended::WithMistakes;
        };
        let motion = Motion::new(settings, self.output.as_deref(), &mut system);
        motion.and_then(|motion| system.visit(motion)).map_or_else(failed, |()| Ended::Well)
    }

    /// Computes a motion and writes its film.
    fn film(&self, settings: &Settings) -> Ended {
        let product = product(settings);
        let drawn = self.source().and_then(|source| Ok((self.drawn(&source, product)?, source.name)));
        let Ok((mut system, name)) = drawn else { return Ended::WithMistakes };
        if system.programs().drawing.is_none() {
            print_error(&format!("{name}: a film needs bodies, and the declaration has none"));
            return Ended::WithMistakes;
        }
        let motion = Motion::filmed(settings, self.output.as_deref(), &mut system);
        motion.and_then(|motion| system.visit(motion)).map_or_else(failed, |()| Ended::Well)
    }

    /// Computes many motions and writes their final states.
    fn ensemble(&self, options: &EnsembleOptions) -> Ended {
        let product = product(&options.settings);
        let Ok(mut system) = self.source().and_then(|source| self.declared(&source, product)) else {
            return Ended::WithMistakes;
        };
        let ends = match ensembles::ends(options, self.output.as_deref(), &mut system) {
            Ok(ends) => ends,
            Err(failure) => return failed(failure),
        };
        if write(self.output.as_deref(), ensembles::csv(&ends, &system)).is_err() {
            return Ended::WithMistakes;
        }
        for motion in &ends.failures {
            print_error(&motion.message);
        }
        if ends.failures.is_empty() { Ended::Well } else { Ended::Early }
    }

    /// Compares methods and writes the recommended one.
    fn trade(&self, options: &TradeOptions) -> Ended {
        let with_series = Some(Product::Taylor);
        let Ok(mut system) = self.source().and_then(|source| self.declared(&source, with_series)) else {
            return Ended::WithMistakes;
        };
        let text = trades::text(options, self.output.as_deref(), &mut system);
        text.map_or_else(failed, |text| ended(write(None, &text).is_ok()))
    }

    /// Computes a linear model and writes it.
    fn linearise(&self, point: &Point) -> Ended {
        let system = self.source().and_then(|source| {
            self.declared(&source, None)?;
            let derived = source.linearised().map_err(|report| print_plainly(&source, &report))?;
            self.dynamic(&source, Programs::new(&derived))
        });
        let Ok(mut system) = system else { return Ended::WithMistakes };
        match Linearised::new(point, &mut system) {
            Ok(linearised) => ended(write(self.output.as_deref(), linearised.text(point.is_json)).is_ok()),
            Err(failure) => failed(failure),
        }
    }

    /// Writes a unit of the Functional Mock-up Interface.
    fn unit(&self, values: &Values, is_source: bool, version: Version) -> Ended {
        let system = self.source().and_then(|source| {
            let derived = with_derivatives(&source)?;
            let mut programs = Programs::new(&derived);
            programs.linearised.take_if(|program| program.len() > MAX_DERIVATIVES);
            Ok((self.dynamic(&source, programs)?, source.name))
        });
        let Ok((mut system, name)) = system else { return Ended::WithMistakes };
        let start = match set(values, &mut system).and_then(|()| start("start", values, &system)) {
            Ok(state) => started(&system, state, values),
            Err(failure) => return failed(failure),
        };
        let refused = |error: ExportError| print_error(&format!("{name}: {error}"));
        let packed = MockupUnit::new(system.programs(), &start, version).and_then(|unit| {
            let compiler = std::env::var("CC").unwrap_or_else(|_| "cc".to_owned());
            let binary = (!is_source).then(|| unit.compile(&compiler)).transpose()?;
            Ok((unit.archive(binary.as_ref())?, unit.name))
        });
        let written = packed.map_err(refused).and_then(|(bytes, name)| {
            let path = self.output.as_deref().unwrap_or(Path::new("."));
            let path = if path.is_dir() { path.join(format!("{name}.fmu")) } else { path.to_owned() };
            write(Some(&path), &bytes)
        });
        ended(written.is_ok())
    }

    /// Writes a page with a live simulation.
    fn page(&self, values: &Values) -> Ended {
        let Ok((mut system, name)) =
            self.source().and_then(|source| Ok((self.drawn(&source, None)?, source.name)))
        else {
            return Ended::WithMistakes;
        };
        let start = match set(values, &mut system).and_then(|()| start("start", values, &system)) {
            Ok(state) => state,
            Err(failure) => return failed(failure),
        };
        let refused = |error: PageError| print_error(&format!("{name}: {error}"));
        let html = page(system.numeric(), &start).map_err(refused);
        ended(html.and_then(|html| write(self.output.as_deref(), &html)).is_ok())
    }

    /// Writes the header and the source file of a module.
    fn module(&self, source: &Source) -> Outcome<()> {
        let refused = |refusal: Refusal| print_error(&format!("{}: {refusal}", source.name));
        let programs = Programs::new(&with_jacobian(source)?);
        let folder = self.output.as_deref().unwrap_or(Path::new(".")).to_owned();
        let stem = match folder.is_dir() {
            true => folder.join(Module::new(&programs, None).map_err(refused)?.name),
            false => folder,
        };
        let module = Module::new(&programs, stem.file_name().and_then(OsStr::to_str)).map_err(refused)?;
        let file = |extension: &str| {
            let mut path = stem.clone().into_os_string();
            path.push(extension);
            PathBuf::from(path)
        };
        write(Some(&file(".h")), &module.header)?;
        write(Some(&file(".c")), &module.source)
    }

    /// Reads the only file.
    fn source(&self) -> Outcome<Source> {
        let path = self.inputs.first().ok_or(Printed)?;
        source::read(path).map_err(|message| print_error(&message))
    }

    /// Returns a runnable system, with a product if one is given; prints warnings and errors.
    fn declared(&self, source: &Source, product: Option<Product>) -> Outcome<DeclaredSystem> {
        let derived = derived(source, |system| with(system, product).derive(StrategyChoice::Cheapest))?;
        self.dynamic(source, Programs::new(&derived))
    }

    /// Returns a runnable system, with its drawing if it can be drawn, and with a product if one is
    /// given; prints warnings and errors.
    fn drawn(&self, source: &Source, product: Option<Product>) -> Outcome<DeclaredSystem> {
        let system = source.system_with("drawing").or_else(|_| source.system());
        let derived =
            reported(source, system, |system| with(system, product).derive(StrategyChoice::Cheapest))?;
        self.dynamic(source, Programs::new(&derived))
    }

    /// Returns a runnable system, compiled if there is a backend; prints errors.
    fn dynamic(&self, source: &Source, programs: Programs) -> Outcome<DeclaredSystem> {
        let system = DeclaredSystem::new(programs);
        let system = system.map_err(|refusal| print_error(&format!("{}: {refusal}", source.name)))?;
        Ok(match &self.backend {
            Some(backend) => system.compiled_by(backend.clone()),
            None => system,
        })
    }

    fn check(&self, is_json: bool) -> bool {
        let (mut has_errors, mut all) = (false, Vec::new());
        for path in &self.inputs {
            let Ok(source) = source::read(path).map_err(|message| print_error(&message)) else {
                has_errors = true;
                continue;
            };
            let report = checked(&source);
            has_errors |= report.has_errors();
            match is_json {
                true => all.extend(mistakes::as_json(&source, &report)),
                false => mistakes::print(&source, &report),
            }
        }
        let json = is_json.then(|| format!("{:#}\n", Value::Array(all)));
        let is_written = json.is_none_or(|json| write(self.output.as_deref(), &json).is_ok());
        is_written && !has_errors
    }
}

/// Returns the product that the method of a motion needs, if it needs one.
fn product(settings: &Settings) -> Option<Product> {
    // Invalid settings are reported with the motion.
    method(settings).ok().and_then(MethodChoice::product)
}

fn with(system: System, product: Option<Product>) -> System {
    match product {
        Some(product) => system.with(product),
        None => system,
    }
}

/// Prints the reason for a missing motion or linear model.
fn failed(failure: Failure) -> Ended {
    let (message, end) = match failure {
        Failure::Usage(message) => (message, Ended::Misused),
        Failure::File(message) => (message, Ended::WithMistakes),
        Failure::Ended(message) => (message, Ended::Early),
    };
    print_error(&message);
    end
}

/// Returns the initial values of a unit.
fn started(system: &DeclaredSystem, state: Vec<f64>, values: &Values) -> Start {
    let is_given = |name: &String| values.start.iter().any(|(given, _)| given == name);
    let are_given = system.state_names().iter().map(is_given).collect();
    Start { fields: system.numeric().fields().to_vec(), state, are_given }
}

fn ended(is_well: bool) -> Ended {
    if is_well { Ended::Well } else { Ended::WithMistakes }
}

/// Returns a system with the derivatives of its rates, if they are small enough; prints warnings
/// and errors.
fn with_jacobian(source: &Source) -> Outcome<Derived> {
    derived(source, |system| {
        let choice = StrategyChoice::Cheapest;
        system.clone().with(Product::Jacobian).derive(choice).or_else(|_| system.derive(choice))
    })
}

/// Returns a system with the derivatives of rates and outputs with respect to state and inputs, if
/// they are small enough; prints warnings and errors.
fn with_derivatives(source: &Source) -> Outcome<Derived> {
    derived(source, |system| {
        let choice = StrategyChoice::Cheapest;
        let has_clocks = !system.model.clocks.is_empty();
        let linear = (!has_clocks).then(|| system.clone().with(Product::SystemMatrix).derive(choice));
        linear.and_then(Result::ok).map_or_else(|| system.derive(choice), Ok)
    })
}

/// Derives a system; prints warnings and errors.
fn derived(source: &Source, derive: impl FnOnce(System) -> Result<Derived, Report>) -> Outcome<Derived> {
    reported(source, source.system(), derive)
}

/// Derives a parsed system; prints warnings and errors.
fn reported(
    source: &Source,
    system: Result<System, Report>,
    derive: impl FnOnce(System) -> Result<Derived, Report>,
) -> Outcome<Derived> {
    let derived = system.and_then(derive).map_err(|report| {
        mistakes::print(source, &report);
        Printed
    })?;
    mistakes::print(source, &derived.report);
    Ok(derived)
}

/// Returns the full report on a declaration, including its code generation.
fn checked(source: &Source) -> Report {
    let derived = match source.system().and_then(|system| system.derive(StrategyChoice::Cheapest)) {
        Ok(derived) => derived,
        Err(report) => return report,
    };
    let warnings = derived.report.clone();
    derived.emit(&quote!(::lagrange)).err().unwrap_or(warnings)
}

/// Returns a text derived from a declaration; prints warnings and errors.
fn written(source: &Source, text: Text) -> Outcome<String> {
    let refused = |report: Report| {
        mistakes::print(source, &report);
        Printed
    };
    let system = source.system().map_err(refused)?;
    if let Text::Statements = text {
        mistakes::print(source, &system.report);
        return Ok(system.statements());
    }
    let mut derived = system.derive(StrategyChoice::Cheapest).map_err(refused)?;
    mistakes::print(source, &derived.report);
    match text {
        Text::Statements | Text::Equations => Ok(derived.documentation().join("\n") + "\n"),
        Text::Latex => Ok(derived.equations_latex() + "\n"),
        Text::Kernel(precision) => derived.kernel(precision).map_err(refused),
        Text::Rust => rust(derived.emit(&quote!(::lagrange)).map_err(refused)?),
    }
}

/// Formats emitted items.
fn rust(items: TokenStream) -> Outcome<String> {
    let file = syn::parse2(items).map_err(|error| print_error(&format!("emitted code: {error}")))?;
    Ok(prettyplease::unparse(&file))
}

/// Returns the declaration of a robot; prints warnings and errors.
fn robot(source: &Source, options: &Options) -> Outcome<String> {
    match import(&source.text, options) {
        Ok(Import { declaration, warnings, .. }) => {
            report(&listing(&source.name, &warnings));
            Ok(declaration)
        }
        Err(mistakes) => {
            report(&listing(&source.name, &mistakes));
            Err(Printed)
        }
    }
}

fn write(output: Option<&Path>, text: impl AsRef<[u8]>) -> Outcome<()> {
    let result = match output {
        Some(path) => save_bytes(path, text).map_err(|error| format!("{}: {error}", path.display())),
        None => answer(|output| output.write_all(text.as_ref())),
    };
    result.map_err(|message| print_error(&message))
}

/// Prints errors without positions, which are not in the file.
fn print_plainly(source: &Source, report: &Report) -> Printed {
    for mistake in report.diagnostics() {
        let help = mistake.help.as_ref().map_or(String::new(), |help| format!(" (help: {help})"));
        print_error(&format!("{}: {}{help}", source.name, mistake.message));
    }
    Printed
}

fn print_error(message: &str) -> Printed {
    report(&format!("error: {message}\n"));
    Printed
}
