//! A file that holds a declaration, alone or in `lagrange::system! { … }`.

use std::borrow::Cow;
use std::io::{self, Read};
use std::path::{Path, PathBuf};

use lagrange_core::diagnostics::Report;
use lagrange_core::files;
use lagrange_core::limits::MAX_FILE_BYTES;
use lagrange_core::pipeline::{System, parse_with};
use lagrange_core::tables::{FileText, decoded};

/// Name of the standard input.
const STANDARD_INPUT: &str = "-";

/// A text with the place that it was read from.
pub(crate) struct Source {
    /// Name of the file in messages.
    pub(crate) name: String,
    /// Content.
    pub(crate) text: String,
    /// Folder where its tables are.
    folder: PathBuf,
}

impl Source {
    /// Reads a file, or the standard input for `-`.
    ///
    /// # Errors
    /// The name of the file and the reason why it cannot be read.
    pub(crate) fn read(path: &Path) -> Result<Source, String> {
        if path.as_os_str() == STANDARD_INPUT {
            let text = standard_input().map_err(|reason| format!("the standard input: {reason}"))?;
            return Ok(Source { name: "<stdin>".to_owned(), text, folder: PathBuf::new() });
        }
        let name = path.display().to_string();
        let folder = path.parent().map(Path::to_owned).unwrap_or_default();
        let file = path.file_name().and_then(|file| file.to_str()).unwrap_or_default();
        let file = files::read(&folder, file).map_err(|reason| format!("{name}: {reason}"))?;
        Ok(Source { name, text: file.text, folder })
    }

    /// Reads and checks the declaration.
    ///
    /// # Errors
    /// All mistakes in it and in its tables.
    pub(crate) fn system(&self) -> Result<System, Report> {
        // Code that is written holds the points of tables, so it is compiled without their files.
        let table = |path: &str| {
            let file = files::read(&self.folder, path)?;
            Ok(FileText { path: String::new(), ..file })
        };
        parse_with(&without_macro(&self.text), &table)
    }
}

/// Blanks the macro around a declaration, as files of Rust and imported robots have it. Everything
/// else keeps its place.
fn without_macro(text: &str) -> Cow<'_, str> {
    let inside = || {
        let path = text.trim_start().trim_start_matches("::").strip_prefix("lagrange::system!")?;
        path.trim_start().strip_prefix('{')?.trim_end().strip_suffix('}')
    };
    match inside() {
        Some(inside) => {
            let before = text.find('{').map_or(0, |brace| brace + 1);
            let lines = text[..before].chars().map(|c| if c == '\n' { c } else { ' ' });
            Cow::Owned(lines.collect::<String>() + inside)
        }
        None => Cow::Borrowed(text),
    }
}

fn standard_input() -> Result<String, String> {
    let mut bytes = Vec::new();
    let input = io::stdin().lock().take(MAX_FILE_BYTES + 1).read_to_end(&mut bytes);
    input.map_err(|error| error.to_string())?;
    decoded(bytes)
}
