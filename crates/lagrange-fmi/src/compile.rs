//! Compilation of the sources for the platform of this machine.

use std::path::Path;
use std::process::Command;
use std::{env, fs, process};

use crate::error::ExportError;
use crate::version::Version;

/// A compiled library.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Binary {
    /// Path in the archive, such as `binaries/linux64/swing.so`.
    pub path: String,
    /// Content of the library.
    pub bytes: Vec<u8>,
}

/// Compiles sources in a temporary folder.
pub(crate) fn compiled(
    (name, version): (&str, Version),
    compiler: &str,
    sources: &[(&'static str, String)],
) -> Result<Binary, ExportError> {
    let (folder, extension) = version.platform().ok_or(ExportError::Platform(version))?;
    let library = format!("{name}.{extension}");
    let place = env::temp_dir().join(format!("lagrange_fmi_{name}_{}_{}", version.number(), process::id()));
    fs::create_dir_all(&place)?;
    let bytes = library_of(&place, &library, compiler, sources);
    fs::remove_dir_all(&place)?;
    Ok(Binary { path: format!("binaries/{folder}/{library}"), bytes: bytes? })
}

fn library_of(
    place: &Path,
    library: &str,
    compiler: &str,
    sources: &[(&'static str, String)],
) -> Result<Vec<u8>, ExportError> {
    for (file, text) in sources {
        fs::write(place.join(file), text)?;
    }
    let mut words = compiler.split_whitespace();
    let mut command = Command::new(words.next().unwrap_or("cc"));
    // Without contraction, results equal those of other machines.
    command.args(words).args(["-std=c99", "-O2", "-ffp-contract=off", "-shared", "-fvisibility=hidden"]);
    if cfg!(unix) {
        command.arg("-fPIC");
    }
    let files = sources.iter().map(|(file, _)| *file).filter(|file| file.ends_with(".c"));
    command.args(files).args(["-o", library, "-lm"]).current_dir(place);
    let output = command.output().map_err(|error| ExportError::NoCompiler(compiler.to_owned(), error))?;
    match output.status.success() {
        true => Ok(fs::read(place.join(library))?),
        false => {
            let words = String::from_utf8_lossy(&output.stderr).trim().to_owned();
            Err(ExportError::Compiler(compiler.to_owned(), words))
        }
    }
}
