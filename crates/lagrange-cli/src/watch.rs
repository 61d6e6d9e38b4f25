//! Commands that are rerun whenever their files change.

use std::fs;
use std::path::PathBuf;
use std::thread::sleep;
use std::time::{Duration, SystemTime};

use lagrange_dynamic::Source;

use crate::arguments::Command;
use crate::console::report;
use crate::source;

/// Polling interval for the files.
const INTERVAL: Duration = Duration::from_millis(200);

/// Last modification time and size of each file; `None` if it cannot be read.
type Stamps = Vec<Option<(SystemTime, u64)>>;

/// Runs a command now, and again after each change of its files and of included ones, until the
/// process is terminated. Errors are printed as usual.
pub(crate) fn watch(command: &Command) -> ! {
    loop {
        let files = files(command);
        // Recorded before the command reads the files, so that changes in the meantime are
        // detected.
        let before = stamps(&files);
        command.run();
        let names = files.iter().map(|file| file.display().to_string()).collect::<Vec<_>>();
        report(&format!("watching {}; Ctrl-C ends\n", names.join(", ")));
        wait_for_change(&files, &before);
    }
}

/// Returns the files read by a command, and the files that they include.
fn files(command: &Command) -> Vec<PathBuf> {
    let mut files = command.inputs.iter().map(|path| Source::file(path).to_owned()).collect::<Vec<_>>();
    for source in command.inputs.iter().filter_map(|path| source::read(path).ok()) {
        files.extend(source.included());
    }
    files
}

fn stamps(files: &[PathBuf]) -> Stamps {
    let stamp = |file: &PathBuf| {
        let metadata = fs::metadata(file).ok()?;
        Some((metadata.modified().ok()?, metadata.len()))
    };
    files.iter().map(stamp).collect()
}

/// Waits until files change and then stay unchanged, since editors write in several steps.
fn wait_for_change(files: &[PathBuf], before: &Stamps) {
    let mut last = before.clone();
    loop {
        sleep(INTERVAL);
        let now = stamps(files);
        if now == last && now != *before {
            return;
        }
        last = now;
    }
}
