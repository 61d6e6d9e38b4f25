//! An older file exists until the new one is complete.

use std::env;
use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::thread;

use super::{UNFINISHED, csv_cell, save, save_bytes};

/// An empty folder, deleted at the end.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Folder {
        let path = env::temp_dir().join(format!("lagrange_files_{name}_{}", std::process::id()));
        drop(fs::remove_dir_all(&path));
        fs::create_dir_all(&path).expect("can be made");
        Folder(path)
    }

    fn names(&self) -> Vec<String> {
        let entries = fs::read_dir(&self.0).expect("is there").map(|entry| entry.expect("can be read"));
        let mut names: Vec<_> =
            entries.map(|entry| entry.file_name().to_string_lossy().into_owned()).collect();
        names.sort();
        names
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        drop(fs::remove_dir_all(&self.0));
    }
}

fn fails(mut file: &File) -> io::Result<()> {
    file.write_all(b"half")?;
    Err(io::Error::from(io::ErrorKind::StorageFull))
}

#[test]
fn an_older_file_survives_a_writer_that_fails() {
    let folder = Folder::new("older");
    let path = folder.0.join("run.csv");
    for before in [None, Some("good")] {
        if let Some(before) = before {
            save_bytes(&path, before).expect("writes");
        }
        let error = save(&path, |error| error, fails).expect_err("fails");
        assert_eq!(error.kind(), io::ErrorKind::StorageFull);
        assert_eq!(fs::read_to_string(&path).ok().as_deref(), before);
        assert_eq!(folder.names().len(), usize::from(before.is_some()));
    }
    save_bytes(&path, "better").expect("writes");
    assert_eq!(fs::read_to_string(&path).expect("is there"), "better");
}

#[test]
fn an_older_file_survives_a_panic() {
    let folder = Folder::new("panic");
    let path = folder.0.join("run.csv");
    save_bytes(&path, "good").expect("writes");
    let place = path.clone();
    let panics =
        move || save(&place, |error: io::Error| error, |_| -> io::Result<()> { panic!("is broken") });
    assert!(thread::spawn(panics).join().is_err());
    assert_eq!(fs::read_to_string(&path).expect("is there"), "good");
    assert_eq!(folder.names(), ["run.csv"]);
}

#[test]
fn cells_are_text_and_no_formulas() {
    for text in ["", "x", "theta[2] in rad", "'x", "x=1", "x-y"] {
        assert_eq!(csv_cell(text), text);
    }
    for text in ["=1+1", "+x", "-x", "@SUM(A1)", "\tx"] {
        assert_eq!(csv_cell(text), format!("'{text}"));
    }
    assert_eq!(csv_cell("=a,\"b\""), "\"'=a,\"\"b\"\"\"");
    assert_eq!(csv_cell("\r=x"), "\"'\r=x\"");
}

/// One of the writers succeeds last, and the file is complete.
#[test]
fn writers_at_the_same_time_do_not_mix() {
    let folder = Folder::new("writers");
    let path = folder.0.join("run.csv");
    let contents: Vec<String> = (0..8).map(|k| k.to_string().repeat(100_000 + k)).collect();
    thread::scope(|scope| {
        for content in &contents {
            let path = &path;
            scope.spawn(move || save_bytes(path, content).expect("writes"));
        }
    });
    assert!(contents.contains(&fs::read_to_string(&path).expect("is there")));
    assert_eq!(folder.names(), ["run.csv"]);
}

#[test]
fn names_may_be_as_long_as_names_can_be() {
    let folder = Folder::new("long");
    for name in ["x".repeat(255), "ẍ".repeat(85)] {
        save_bytes(&folder.0.join(&name), "long").expect("writes");
        assert!(folder.names().contains(&name));
    }
}

#[test]
fn a_path_that_cannot_be_is_an_error() {
    let folder = Folder::new("missing");
    for path in [folder.0.join("no/such/folder"), folder.0.clone(), PathBuf::new(), PathBuf::from("/")] {
        assert!(save_bytes(&path, "nothing").is_err(), "{}", path.display());
    }
    assert_eq!(folder.names(), [""; 0]);
    assert!(!Path::new(UNFINISHED).exists());
}

#[cfg(unix)]
mod on_unix {
    use std::os::unix::fs::{PermissionsExt, symlink};
    use std::process::{Command, Stdio};

    use super::{Folder, env, fs, save_bytes};
    use std::path::Path;

    #[test]
    fn permissions_and_links_stay() {
        let folder = Folder::new("permissions");
        let [file, link] = ["file", "link"].map(|name| folder.0.join(name));
        save_bytes(&file, "old").expect("writes");
        fs::set_permissions(&file, fs::Permissions::from_mode(0o640)).expect("may be set");
        symlink("file", &link).expect("can be made");
        save_bytes(&link, "new").expect("writes");
        assert_eq!(fs::read_to_string(&file).expect("is there"), "new");
        assert_eq!(fs::metadata(&file).expect("is there").permissions().mode() & 0o777, 0o640);
        assert!(fs::symlink_metadata(&link).expect("is there").is_symlink());
    }

    #[test]
    fn a_device_stays_a_device() {
        save_bytes(Path::new("/dev/null"), "nothing").expect("writes");
        assert!(!fs::metadata("/dev/null").expect("is there").is_file());
        assert!(save_bytes(Path::new("/dev/full"), "something").is_err() || !Path::new("/dev/full").exists());
    }

    const CHILD: &str = "LAGRANGE_FILES_TEST_FOLDER";

    /// Limits files to a kilobyte, as on a full disk.
    #[test]
    fn an_older_file_survives_a_full_disk() {
        if let Some(folder) = env::var_os(CHILD) {
            let error = save_bytes(&Path::new(&folder).join("run.csv"), [0; 4096]).expect_err("has no room");
            assert!(error.to_string().contains("too large"), "{error}");
            return;
        }
        let folder = Folder::new("full");
        save_bytes(&folder.0.join("run.csv"), [1; 4096]).expect("writes");
        let mut command = Command::new("sh");
        command.args(["-c", "trap '' XFSZ; ulimit -f 2; exec \"$@\"", "sh"]);
        command.arg(env::current_exe().expect("is known"));
        command.args(["--exact", "tests::on_unix::an_older_file_survives_a_full_disk"]);
        // Its output could go to a file with a limited size.
        command.stdout(Stdio::null()).stderr(Stdio::null());
        assert!(command.env(CHILD, &folder.0).status().expect("starts").success());
        assert_eq!(fs::read(folder.0.join("run.csv")).expect("is there"), [1; 4096]);
        assert_eq!(folder.names(), ["run.csv"]);
    }
}
