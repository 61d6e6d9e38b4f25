//! The place and time of a measurement.

use std::fs;
use std::process::Command;

use super::run::output;

/// Returns processor, compiler, target and date in a sentence.
pub(super) fn description() -> Result<String, String> {
    let version = output(Command::new("rustc").arg("-vV"))?;
    let field = |name: &str| {
        let value = version.lines().find_map(|line| line.strip_prefix(name));
        value.unwrap_or_default().trim().to_owned()
    };
    let (release, host) = (field("release:"), field("host:"));
    let date = output(Command::new("date").arg("+%Y-%m-%d"))?;
    Ok(format!("Measured on {} with rustc {release} for {host}, {}.\n", processor(), date.trim()))
}

/// Returns the present load in a sentence; nothing where Linux does not report it.
pub(super) fn load() -> String {
    let told = fs::read_to_string("/proc/loadavg").unwrap_or_default();
    let processes = told.split(' ').next().filter(|number| !number.is_empty());
    processes.map_or_else(String::new, |number| format!("Other programs had {number} runnable processes.\n"))
}

/// Returns the model and number of processors, as reported by Linux.
fn processor() -> String {
    let told = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let values = |name: &str| {
        let values = told.lines().filter_map(|line| line.split_once(':'));
        let values = values.filter(|(field, _)| field.trim() == name);
        values.map(|(_, value)| value.trim().to_owned()).collect::<Vec<_>>()
    };
    let models = values("model name");
    match (models.first(), values("cpu family").first(), values("model").first()) {
        (Some(name), Some(family), Some(model)) => {
            format!("{} cores of {name} (family {family}, model {model})", models.len())
        }
        _ => "an unknown processor".to_owned(),
    }
}
