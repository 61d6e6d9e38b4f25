//! `cargo xtask urdf robot.urdf`: the declaration of a robot to standard output, mistakes with file
//! and line to standard error.

use std::fs;

use lagrange_import::urdf::{Import, Options, import};
use lagrange_import::{Mistake, listing};

pub(crate) const USAGE: &str =
    "cargo xtask urdf robot.urdf [--name NAME] [--free] [--inputs] [--trust-inertia]";

/// Writes the declaration of the robot in a file.
pub(crate) fn urdf(arguments: &[&str]) -> Result<(), String> {
    let (path, options) = read_arguments(arguments)?;
    let bytes = fs::read(&path).map_err(|error| format!("{path}: {error}"))?;
    let text = String::from_utf8(bytes).map_err(|error| format!("{path}: {error}"))?;
    let report = |mistakes: &[Mistake]| eprint!("{}", listing(&path, mistakes));
    match import(&text, &options) {
        Ok(Import { declaration, warnings, .. }) => {
            report(&warnings);
            print!("{declaration}");
            Ok(())
        }
        Err(mistakes) => {
            report(&mistakes);
            let count = mistakes.iter().filter(|mistake| mistake.is_error).count();
            Err(format!(
                "{path}: nothing is imported because of {count} {}",
                if count == 1 { "mistake" } else { "mistakes" }
            ))
        }
    }
}

fn read_arguments(arguments: &[&str]) -> Result<(String, Options), String> {
    let (mut path, mut options) = (None, Options::default());
    let mut arguments = arguments.iter();
    while let Some(&argument) = arguments.next() {
        match argument {
            "--free" => options.is_free = true,
            "--inputs" => options.has_inputs = true,
            "--trust-inertia" => options.trusts_inertia = true,
            "--name" => {
                let name = arguments.next().ok_or("`--name` needs a name after it")?;
                options.name = Some((*name).to_owned());
            }
            _ if argument.starts_with("--") => {
                return Err(format!("unknown option `{argument}`\nusage: {USAGE}"));
            }
            _ if path.is_some() => return Err(format!("one file at a time\nusage: {USAGE}")),
            _ => path = Some(argument.to_owned()),
        }
    }
    Ok((path.ok_or_else(|| format!("usage: {USAGE}"))?, options))
}
