//! `cargo xtask package`: every published package as the registry would get it.

use std::path::{Path, PathBuf};
use std::process::Command;

/// Folders of the repository that no package holds.
const OUTSIDE: [&str; 6] = [".cargo/", ".ci/", "docs/", "fuzz/", "target/", "tools/"];
/// Files that every package holds.
const INSIDE: [&str; 3] = ["LICENSE-APACHE", "LICENSE-MIT", "README.md"];

/// Checks what the packages hold, which cargo has put into its local index.
pub(crate) fn check(root: &Path) -> Result<(), String> {
    let packages = packages(root)?;
    let mistakes = packages.iter().flat_map(|(name, files)| mistakes(name, files)).collect::<Vec<_>>();
    if !mistakes.is_empty() {
        return Err(mistakes.join("\n"));
    }
    println!("{} packages hold what they need", packages.len());
    let manifest = std::fs::read_to_string(root.join("Cargo.toml")).map_err(|error| error.to_string())?;
    if manifest.contains("\nrepository = \"\"\n") {
        println!("before they are published, `repository` in Cargo.toml needs an address");
    }
    Ok(())
}

/// Returns the names of all packages with the files in them.
fn packages(root: &Path) -> Result<Vec<(String, Vec<String>)>, String> {
    let target = std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| root.join("target"), PathBuf::from);
    let folder = target.join("package/tmp-registry");
    let entries = std::fs::read_dir(&folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    let paths = entries.filter_map(|entry| Some(entry.ok()?.path()));
    let mut archives =
        paths.filter(|path| path.extension().is_some_and(|end| end == "crate")).collect::<Vec<_>>();
    archives.sort();
    let name = |path: &PathBuf| path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    archives.iter().map(|path| Ok((name(path), files(path)?))).collect()
}

/// Lists the files in an archive, without the folder that holds them all.
fn files(archive: &Path) -> Result<Vec<String>, String> {
    let output = Command::new("tar").arg("-tzf").arg(archive).output();
    let output = output.map_err(|error| format!("tar cannot be started: {error}"))?;
    if !output.status.success() {
        return Err(String::from_utf8_lossy(&output.stderr).trim().to_owned());
    }
    let listed = String::from_utf8_lossy(&output.stdout).into_owned();
    Ok(listed.lines().filter_map(|line| Some(line.split_once('/')?.1.to_owned())).collect())
}

/// Returns what is wrong with the files of a package.
fn mistakes(name: &str, files: &[String]) -> Vec<String> {
    let missing = INSIDE.iter().filter(|file| !files.iter().any(|known| known == **file));
    let missing = missing.map(|file| format!("{name} has no {file}"));
    let is_foreign = |file: &&String| OUTSIDE.iter().any(|folder| file.starts_with(folder));
    let foreign = files.iter().filter(is_foreign).map(|file| format!("{name} holds {file}"));
    missing.chain(foreign).collect()
}

#[cfg(test)]
mod tests {
    use super::mistakes;

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
