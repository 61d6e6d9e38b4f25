//! Compilation of the sources for the platform of this machine.

use std::path::Path;
use std::process::Command;
use std::{env, fs, process};

use crate::error::ExportError;

/// A compiled library.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Binary {
    /// Its path in the archive, such as `binaries/linux64/swing.so`.
    pub path: String,
    /// Its content.
    pub bytes: Vec<u8>,
}

/// Folder and extension of libraries for this machine.
fn platform() -> Option<(&'static str, &'static str)> {
    match (env::consts::OS, env::consts::ARCH) {
        ("linux", "x86_64") => Some(("linux64", "so")),
        ("linux", "x86") => Some(("linux32", "so")),
        ("macos", _) => Some(("darwin64", "dylib")),
        ("windows", "x86_64") => Some(("win64", "dll")),
        ("windows", "x86") => Some(("win32", "dll")),
        _ => None,
    }
}

/// Compiles sources in a folder of their own.
pub(crate) fn compiled(
    name: &str,
    compiler: &str,
    sources: &[(&'static str, String)],
) -> Result<Binary, ExportError> {
    let (folder, extension) = platform().ok_or(ExportError::Platform)?;
    let library = format!("{name}.{extension}");
    let place = env::temp_dir().join(format!("lagrange_fmi_{name}_{}", process::id()));
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
    // Without contraction, results are those of other machines.
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
