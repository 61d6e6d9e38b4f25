use std::fs;
use std::path::{Path, PathBuf};

use lagrange_expr::limits::MAX_FILE_BYTES;

use super::read;

/// A folder that is empty at the start of a test, and removed at its end.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Folder {
        let path = std::env::temp_dir().join(format!("lagrange-core-{}-{name}", std::process::id()));
        fs::create_dir_all(&path).expect("a folder");
        Folder(path)
    }

    fn write(&self, name: &str, bytes: &[u8]) {
        fs::write(self.0.join(name), bytes).expect("written");
    }

    fn read(&self, name: &str) -> Result<String, String> {
        read(&self.0, name).map(|file| file.text)
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        drop(fs::remove_dir_all(&self.0));
    }
}

#[test]
fn files_are_read_from_the_folder() {
    let folder = Folder::new("plain");
    folder.write("road.csv", b"0, 1\n");
    folder.write("empty.csv", b"");
    folder.write("latin.csv", b"0, 1\nx, \xe4\n");
    assert_eq!(folder.read("road.csv"), Ok("0, 1\n".to_owned()));
    assert_eq!(folder.read("empty.csv"), Ok(String::new()));
    assert!(folder.read("latin.csv").is_err_and(|reason| reason.contains("line 2")));
    let file =
        read(Path::new("elsewhere"), folder.0.join("road.csv").to_str().expect("UTF-8")).expect("a file");
    assert!(file.path.ends_with("road.csv") && file.text == "0, 1\n");
    assert!(folder.read("none.csv").is_err_and(|reason| reason.contains("No such file")));
    assert!(folder.read("").is_err_and(|reason| reason == "it is a folder"));
    assert!(folder.read("a\0b").is_err());
}

#[test]
fn files_larger_than_a_table_are_refused() {
    let folder = Folder::new("large");
    let file = fs::File::create(folder.0.join("huge.csv")).expect("a file");
    // The file is sparse.
    file.set_len(1 << 40).expect("a length");
    assert!(folder.read("huge.csv").is_err_and(|reason| reason.contains("larger than 16777216 bytes")));
    file.set_len(MAX_FILE_BYTES).expect("a length");
    assert!(folder.read("huge.csv").is_err_and(|reason| reason.contains("NUL")));
}

/// Waiting for a writer, or for the end of a device, would block the build.
#[cfg(unix)]
#[test]
fn special_files_do_not_block() {
    use std::os::unix::fs::symlink;
    use std::os::unix::net::UnixListener;

    let folder = Folder::new("devices");
    let made = std::process::Command::new("mkfifo").arg(folder.0.join("pipe")).status();
    assert!(made.expect("mkfifo is there").success());
    symlink(folder.0.join("pipe"), folder.0.join("to_pipe")).expect("a link");
    symlink("loop", folder.0.join("loop")).expect("a link");
    symlink("/dev/zero", folder.0.join("zeros")).expect("a link");
    let _listener = UnixListener::bind(folder.0.join("socket")).expect("a socket");
    for name in ["pipe", "to_pipe", "zeros", "socket", "/dev/zero", "/dev/stdin", "/dev/tty", "/dev/urandom"]
    {
        if folder.0.join(name).exists() && !folder.0.join(name).is_file() {
            assert!(folder.read(name).is_err_and(|reason| reason.contains("not a regular file")), "{name}");
        }
    }
    assert!(folder.read("loop").is_err());
    // Kernel files, some of which block forever.
    for name in ["/proc/kmsg", "/proc/self/mem", "/proc/self/pagemap"] {
        assert!(folder.read(name).is_ok_and(|text| text.is_empty()) || folder.read(name).is_err(), "{name}");
    }
}

#[cfg(unix)]
#[test]
fn links_and_permissions_are_those_of_the_file_system() {
    use std::os::unix::fs::{PermissionsExt, symlink};

    let folder = Folder::new("links");
    folder.write("road.csv", b"0, 1");
    symlink("road.csv", folder.0.join("link.csv")).expect("a link");
    assert_eq!(folder.read("link.csv"), Ok("0, 1".to_owned()));
    let forbidden = fs::Permissions::from_mode(0o000);
    fs::set_permissions(folder.0.join("road.csv"), forbidden).expect("permissions");
    // The administrator can read everything.
    let reason = folder.read("link.csv").err();
    assert!(reason.is_none_or(|reason| reason.contains("Permission denied")));
}

#[cfg(target_os = "linux")]
#[test]
fn folders_whose_names_are_no_text_are_refused() {
    use std::ffi::OsStr;
    use std::os::unix::ffi::OsStrExt;

    let folder = Folder::new("bytes");
    let inner = folder.0.join(OsStr::from_bytes(b"f\xff"));
    fs::create_dir_all(&inner).expect("a folder");
    fs::write(inner.join("road.csv"), "0, 1").expect("written");
    assert!(read(&inner, "road.csv").is_err_and(|reason| reason.contains("not in UTF-8")));
}
