//! Files for the tests.

use std::fs;
use std::path::{Path, PathBuf};

use lagrange_import::urdf::{Import, Options, import};

pub(crate) fn path(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data").join(name)
}

pub(crate) fn read(name: &str) -> String {
    fs::read_to_string(path(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
}

pub(crate) fn imported(name: &str, options: &Options) -> Import {
    import(&read(name), options).unwrap_or_else(|mistakes| panic!("{name}: {mistakes:#?}"))
}
