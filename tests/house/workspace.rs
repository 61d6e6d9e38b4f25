//! Crates of the workspace, read from disk once for all tests.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;

use crate::imports::Crate;
use crate::tables::LIBRARIES;

/// All crates: libraries and `xtask` by the names of their packages, examples and benchmarks by
/// their paths.
pub(crate) struct Workspace {
    pub(crate) root: PathBuf,
    pub(crate) crates: Vec<Crate>,
    /// All files of Rust, including tests.
    pub(crate) files: Vec<RustFile>,
}

/// A file of Rust with its text.
pub(crate) struct RustFile {
    pub(crate) path: String,
    pub(crate) text: String,
}

/// Folders of compiled code, and of code that golden systems emit.
const GENERATED: [&str; 2] = ["golden", "target"];

pub(crate) fn workspace() -> &'static Workspace {
    static WORKSPACE: LazyLock<Workspace> = LazyLock::new(Workspace::read);
    &WORKSPACE
}

impl Workspace {
    /// Returns packages with sources but without a table of layers, and tables without a package.
    pub(crate) fn misplaced_libraries(&self) -> Vec<String> {
        let names = self.crates.iter().map(|krate| krate.name.as_str());
        let libraries = names.filter(|name| !name.ends_with(".rs")).collect::<Vec<_>>();
        let tables = LIBRARIES.map(|library| library.name);
        let unknown = libraries.iter().filter(|name| !tables.contains(name));
        let unknown = unknown.map(|name| format!("{name} has no table of layers"));
        let missing = tables.iter().filter(|name| !libraries.contains(name));
        unknown.chain(missing.map(|name| format!("there is no crate {name}"))).collect()
    }

    fn read() -> Self {
        let root = root();
        let text_of = |path: &str| fs::read_to_string(root.join(path)).ok();
        let crates = roots(&root).into_iter().map(|(name, path)| Crate::read(&name, &path, &text_of));
        let crates = crates.collect();
        let files = rust_files(&root, "");
        Self { root, crates, files }
    }
}

/// Returns the folder of the workspace: the one with the document that shows its structure.
fn root() -> PathBuf {
    let folders = Path::new(env!("CARGO_MANIFEST_DIR")).ancestors();
    let mut roots = folders.filter(|folder| folder.join("ARCHITECTURE.md").is_file());
    roots.next().expect("the root of the workspace").to_owned()
}

/// Returns the folders of crates, below the root and below `crates`; that of the root itself is
/// empty.
pub(crate) fn folders(root: &Path) -> Vec<String> {
    let within =
        |parent: &'static str| entries(root, parent).into_iter().map(move |name| format!("{parent}{name}/"));
    let mut folders = within("").chain(within("crates/")).collect::<Vec<_>>();
    folders.insert(0, String::new());
    folders.retain(|folder| root.join(folder).join("Cargo.toml").is_file());
    folders
}

/// Returns the names of all crates and the paths of their roots.
fn roots(root: &Path) -> Vec<(String, String)> {
    let mut found = Vec::new();
    for folder in folders(root) {
        let name = if folder.is_empty() {
            "lagrange"
        } else {
            folder.trim_start_matches("crates/").trim_end_matches('/')
        };
        let sources = ["lib.rs", "main.rs"].map(|file| format!("{folder}src/{file}"));
        let source = sources.into_iter().find(|path| root.join(path).is_file());
        found.extend(source.map(|path| (name.to_owned(), path)));
        let programs = ["examples", "benches"].map(|kind| programs(root, &format!("{folder}{kind}")));
        found.extend(programs.into_iter().flatten().map(|path| (path.clone(), path)));
    }
    found
}

/// Reads the files of Rust below a folder, whose path ends with a slash unless it is the root.
fn rust_files(root: &Path, folder: &str) -> Vec<RustFile> {
    let names = entries(root, folder).into_iter();
    let names = names.filter(|name| !name.starts_with('.') && !GENERATED.contains(&name.as_str()));
    let found = names.flat_map(|name| {
        let path = format!("{folder}{name}");
        if root.join(&path).is_dir() {
            return rust_files(root, &format!("{path}/"));
        }
        let text = path.ends_with(".rs").then(|| fs::read_to_string(root.join(&path)).expect("a text"));
        text.map(|text| RustFile { path, text }).into_iter().collect()
    });
    found.collect()
}

/// Returns the roots of the programs in a folder.
fn programs(root: &Path, folder: &str) -> Vec<String> {
    let mut found = Vec::new();
    for entry in entries(root, folder) {
        let path = format!("{folder}/{entry}");
        let main = format!("{path}/main.rs");
        found.extend(entry.ends_with(".rs").then_some(path));
        found.extend(root.join(&main).is_file().then_some(main));
    }
    found
}

/// Returns the names of the entries of a folder, in order.
fn entries(root: &Path, folder: &str) -> Vec<String> {
    let entries = fs::read_dir(root.join(folder)).into_iter().flatten();
    let names = entries.map(|entry| entry.expect("an entry").file_name().to_string_lossy().into_owned());
    let mut names = names.collect::<Vec<_>>();
    names.sort();
    names
}
