//! Texts that contain a declaration, either alone or in the macro `lagrange::system! { … }` of a
//! Rust file.

use std::cell::RefCell;
use std::path::{Path, PathBuf};

use lagrange_core::derive::StrategyChoice;
use lagrange_core::diagnostics::Report;
use lagrange_core::files;
use lagrange_core::pipeline::{Derived, System, parse_adding, parse_with};
use lagrange_core::tables::FileText;

use crate::rust_file::with_declaration;

/// A text and its origin.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Source {
    /// Name of the file in messages.
    pub name: String,
    /// Content of the file.
    pub text: String,
    /// Folder of its tables.
    pub folder: PathBuf,
}

impl Source {
    /// Reads a file. If a Rust file contains several declarations, its path must name one:
    /// `film.rs#CartPole`.
    ///
    /// # Errors
    /// If the file cannot be read, with its name and the reason, or if the declaration is ambiguous
    /// or missing, with the existing ones.
    pub fn read(path: &Path) -> Result<Source, String> {
        let (path, declaration) = parts(path);
        let name = path.display().to_string();
        let folder = path.parent().map(Path::to_owned).unwrap_or_default();
        let file = path.file_name().and_then(|file| file.to_str()).unwrap_or_default();
        let file = files::read(&folder, file).map_err(|reason| format!("{name}: {reason}"))?;
        let text = with_declaration(&file.text, declaration).map_err(|reason| format!("{name}: {reason}"))?;
        Ok(Source { name, text, folder })
    }

    /// Returns the file of a path that may name a declaration.
    #[must_use]
    pub fn file(path: &Path) -> &Path {
        parts(path).0
    }

    /// Parses and checks the declaration.
    ///
    /// # Errors
    /// With all errors in it and in its tables.
    pub fn system(&self) -> Result<System, Report> {
        self.parsed("")
    }

    /// Parses and checks the declaration, with an additional product such as `drawing`.
    ///
    /// # Errors
    /// With all errors in it and in its tables, or the reason why it cannot have this product.
    pub fn system_with(&self, product: &str) -> Result<System, Report> {
        self.parsed(&format!("emit {{ {product} }}"))
    }

    /// Derives the equations with the derivatives of rates and outputs with respect to state and
    /// inputs.
    ///
    /// # Errors
    /// With all errors, or the reason why there are no derivatives, for example clocks.
    pub fn linearised(&self) -> Result<Derived, Report> {
        self.system_with("system_matrix")?.derive(StrategyChoice::Cheapest)
    }

    /// Returns the paths of all included files without repetition, including unreadable ones.
    pub fn included(&self) -> Vec<PathBuf> {
        let paths = RefCell::new(Vec::new());
        let table = |path: &str| {
            let full = self.folder.join(path);
            if !paths.borrow().contains(&full) {
                paths.borrow_mut().push(full);
            }
            files::read(&self.folder, path)
        };
        // Errors are reported by the command that reads the declaration.
        drop(parse_with(&without_macro(&self.text), &table));
        paths.into_inner()
    }

    /// Parses the declaration, with further statements.
    fn parsed(&self, statements: &str) -> Result<System, Report> {
        // Written code contains the points of tables, and is compiled without their files.
        let table = |path: &str| {
            let file = files::read(&self.folder, path)?;
            Ok(FileText { path: String::new(), ..file })
        };
        parse_adding((&without_macro(&self.text), statements), &table)
    }
}

/// Splits a path into the path of the file and the name of a declaration.
fn parts(path: &Path) -> (&Path, Option<&str>) {
    let split = path.to_str().and_then(|text| text.rsplit_once('#')).filter(|_| !path.exists());
    split.map_or((path, None), |(file, name)| (Path::new(file), Some(name)))
}

/// Blanks the macro around a declaration, if there is exactly one.
fn without_macro(text: &str) -> String {
    with_declaration(text, None).unwrap_or_else(|_| text.to_owned())
}
