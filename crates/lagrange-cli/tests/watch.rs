//! Commands that run again when files change: the declaration, and what it includes.

use std::fs::{self, File};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

/// Longest wait for a run.
const PATIENCE: Duration = Duration::from_secs(60);

/// A watching command, which ends with the test.
struct Watching {
    child: Child,
    log: PathBuf,
}

impl Drop for Watching {
    fn drop(&mut self) {
        self.child.kill().expect("it still runs");
        self.child.wait().expect("it ends");
    }
}

impl Watching {
    fn start(folder: &Path, arguments: &[&str]) -> Watching {
        let log = folder.join("log");
        let errors = File::create(&log).expect("a file");
        let mut command = Command::new(env!("CARGO_BIN_EXE_lagrange"));
        command.arg("watch").args(arguments).current_dir(folder).stdout(Stdio::null()).stderr(errors);
        Watching { child: command.spawn().expect("the command starts"), log }
    }

    /// Waits until a number of runs have ended, and returns the output.
    fn runs(&self, count: usize) -> String {
        let start = Instant::now();
        loop {
            let log = fs::read_to_string(&self.log).expect("a log");
            if log.matches("; Ctrl-C ends\n").count() >= count {
                return log;
            }
            assert!(start.elapsed() < PATIENCE, "{count} runs are not over: {log}");
            sleep(Duration::from_millis(50));
        }
    }
}

fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("watch").join(name);
    fs::create_dir_all(&folder).expect("a folder");
    folder
}

/// Returns the position at the end of a motion.
fn end(folder: &Path) -> f64 {
    let motion = fs::read_to_string(folder.join("motion.csv")).expect("a motion");
    let last = motion.lines().last().and_then(|row| row.split(',').nth(1));
    last.and_then(|cell| cell.parse().ok()).expect("a number")
}

#[test]
fn a_motion_is_computed_again_after_each_change() {
    let folder = folder("motion");
    let write = |file: &str, text: &str| fs::write(folder.join(file), text).expect("written");
    let falling = "table drive(time) = \"drive.csv\", interpolation: linear, outside: clamp;
        coord x = 0; kinetic = 1/2 * dot(x)^2; force x = drive(t);";
    write("drive.csv", "time,drive\n0,2\n9,2\n");
    write("fall.lag", falling);
    let watching = Watching::start(&folder, &["simulate", "fall.lag", "--until", "1", "-o", "motion.csv"]);
    let log = watching.runs(1);
    assert!(log.ends_with("watching fall.lag, drive.csv; Ctrl-C ends\n"), "{log}");
    assert!((end(&folder) - 1.0).abs() < 1e-9, "half the acceleration");

    write("drive.csv", "time,drive\n0,8\n9,8\n");
    watching.runs(2);
    assert!((end(&folder) - 4.0).abs() < 1e-9, "the table is watched");

    write("fall.lag", &falling.replace("drive(t)", "drive(t) + nothing"));
    assert!(watching.runs(3).contains("unknown name `nothing`"));
    fs::remove_file(folder.join("fall.lag")).expect("removed");
    assert!(watching.runs(4).contains("error: fall.lag: "));

    write("fall.lag", &falling.replace("drive(t)", "2 * drive(t)"));
    let log = watching.runs(5);
    assert!(log.ends_with("watching fall.lag, drive.csv; Ctrl-C ends\n"), "{log}");
    assert!((end(&folder) - 8.0).abs() < 1e-9, "mistakes do not end it");
}

#[test]
fn unwatchable_inputs_are_refused() {
    let cases: [(&[&str], &str); 6] = [
        (&[], "a command is missing"),
        (&["fly", "a.lag"], "unknown command `fly`"),
        (&["simulate"], "the name of a file is missing"),
        (&["check", "-"], "the standard input cannot be watched"),
        (&["watch", "check", "a.lag"], "`watch` is written once"),
        (&["check", "a.lag", "--until", "1"], "--until"),
    ];
    for (arguments, message) in cases {
        let mut command = Command::new(env!("CARGO_BIN_EXE_lagrange"));
        let result = command.arg("watch").args(arguments).output().expect("the command starts");
        let errors = String::from_utf8(result.stderr).expect("UTF-8");
        assert_eq!(result.status.code(), Some(2), "{arguments:?}");
        assert!(errors.contains(message), "{arguments:?}: {errors}");
    }
}
