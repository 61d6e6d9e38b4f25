//! `cargo xtask package`: every published package as uploaded to the registry.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

/// Folders of the repository excluded from every package.
const OUTSIDE: [&str; 6] = [".cargo/", ".ci/", "docs/", "fuzz/", "target/", "tools/"];
/// Files required in every package.
const INSIDE: [&str; 3] = ["LICENSE-APACHE", "LICENSE-MIT", "README.md"];
/// Folder name by which a local index of cargo is recognised as this workspace's.
const OWN: &str = concat!("lagrange-core-", env!("CARGO_PKG_VERSION"));

/// Folder in which packages are compiled.
pub(crate) const FOLDER: &str = "target/published";

/// Deletes cargo's cached sources of earlier packages. Cargo identifies packages by version, and
/// would otherwise compile older sources.
pub(crate) fn forget(root: &Path) {
    // Missing folders are ignored; failed deletions show up when packages are compiled.
    drop(fs::remove_dir_all(root.join(FOLDER)));
    let home = env::var_os("CARGO_HOME").map(PathBuf::from);
    let home = home.or_else(|| Some(PathBuf::from(env::var_os("HOME")?).join(".cargo"))).unwrap_or_default();
    let sources = fs::read_dir(home.join("registry/src")).into_iter().flatten().flatten();
    let local = sources.filter(|entry| entry.file_name().to_string_lossy().starts_with('-'));
    let own = local.filter(|entry| entry.path().join(OWN).is_dir());
    own.for_each(|entry| drop(fs::remove_dir_all(entry.path())));
}

/// Checks the content of the packages in cargo's local index.
pub(crate) fn check(root: &Path) -> Result<(), String> {
    let packages = packages(root)?;
    let mut mistakes = packages.iter().flat_map(|(name, files)| mistakes(name, files)).collect::<Vec<_>>();
    let is_missing = |name: &String| !packages.iter().any(|(known, _)| known == name);
    let missing = published(root)?.into_iter().filter(is_missing);
    mistakes.extend(missing.map(|name| format!("{name} is not packaged")));
    if !mistakes.is_empty() {
        return Err(mistakes.join("\n"));
    }
    println!("{} packages hold what they need", packages.len());
    let manifest = fs::read_to_string(root.join("Cargo.toml")).map_err(|error| error.to_string())?;
    if manifest.contains("\nrepository = \"\"\n") {
        println!("before they are published, `repository` in Cargo.toml needs an address");
    }
    Ok(())
}

/// Returns the expected names of all packages, the published members with their versions.
fn published(root: &Path) -> Result<Vec<String>, String> {
    let cargo = env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let arguments = ["tree", "--workspace", "--depth", "0", "--prefix", "none", "--format", "{p}"];
    let members = output(Command::new(cargo).args(arguments).current_dir(root))?;
    let mut published = Vec::new();
    // Each line is a name, a version with a `v`, and a folder in brackets.
    for line in members.lines().filter(|line| !line.is_empty()) {
        let member = line.split_once(" v").and_then(|(name, rest)| {
            let (version, rest) = rest.split_once(" (")?;
            Some((format!("{name}-{version}"), rest.rsplit(" (").next()?.trim_end_matches(')')))
        });
        let (name, folder) = member.ok_or_else(|| format!("no member of the workspace: {line}"))?;
        let manifest = Path::new(folder).join("Cargo.toml");
        let text = fs::read_to_string(&manifest);
        let text = text.map_err(|error| format!("{}: {error}", manifest.display()))?;
        if !text.lines().any(|line| line == "publish = false") {
            published.push(name);
        }
    }
    Ok(published)
}

/// Returns the names of all packages with the files in them.
fn packages(root: &Path) -> Result<Vec<(String, Vec<String>)>, String> {
    let folder = root.join(FOLDER).join("package/tmp-registry");
    let entries = fs::read_dir(&folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    let paths = entries.filter_map(|entry| Some(entry.ok()?.path()));
    let mut archives =
        paths.filter(|path| path.extension().is_some_and(|end| end == "crate")).collect::<Vec<_>>();
    archives.sort();
    let name = |path: &PathBuf| path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    archives.iter().map(|path| Ok((name(path), files(path)?))).collect()
}

/// Lists the files in an archive, without their common folder.
fn files(archive: &Path) -> Result<Vec<String>, String> {
    let listed = output(Command::new("tar").arg("-tzf").arg(archive))?;
    Ok(listed.lines().filter_map(|line| Some(line.split_once('/')?.1.to_owned())).collect())
}

/// Returns the standard output of a command.
pub(crate) fn output(command: &mut Command) -> Result<String, String> {
    let program = command.get_program().to_string_lossy().into_owned();
    let output = command.output().map_err(|error| format!("{program} cannot be started: {error}"))?;
    if !output.status.success() {
        return Err(String::from_utf8_lossy(&output.stderr).trim().to_owned());
    }
    Ok(String::from_utf8_lossy(&output.stdout).into_owned())
}

/// Returns the errors in the files of a package.
fn mistakes(name: &str, files: &[String]) -> Vec<String> {
    let missing = INSIDE.iter().filter(|file| !files.iter().any(|known| known == **file));
    let missing = missing.map(|file| format!("{name} has no {file}"));
    let is_foreign = |file: &&String| OUTSIDE.iter().any(|folder| file.starts_with(folder));
    let foreign = files.iter().filter(is_foreign).map(|file| format!("{name} holds {file}"));
    missing.chain(foreign).collect()
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::{mistakes, published};
    use crate::name::current;

    #[test]
    fn published_members_are_those_that_packages_are_expected_of() {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("a folder of the workspace");
        let published = published(root).expect("cargo lists members");
        let is_among = |name: &str| published.contains(&format!("{name}-{}", env!("CARGO_PKG_VERSION")));
        let name = current(root).expect("a name");
        assert!([&name, "lagrange-core", "lagrange-macro", "lagrange-cli"].into_iter().all(is_among));
        assert!(!["xtask", "lagrange-tests", "lagrange-benches"].into_iter().any(is_among), "{published:?}");
    }

    #[test]
    fn packages_hold_licences_and_nothing_of_the_repository() {
        let files = |names: &[&str]| names.iter().map(|name| (*name).to_owned()).collect::<Vec<_>>();
        let whole = ["LICENSE-APACHE", "LICENSE-MIT", "README.md", "src/docs/mod.rs"];
        assert!(mistakes("a", &files(&whole)).is_empty());
        let wrong =
            mistakes("a", &files(&["LICENSE-MIT", "README.md", "docs/gallery/a.svg", ".cargo/config.toml"]));
        assert_eq!(
            wrong,
            ["a has no LICENSE-APACHE", "a holds docs/gallery/a.svg", "a holds .cargo/config.toml"]
        );
    }
}
