//! Folders of parts: finished parts survive everything, and nothing is mixed.

use std::collections::BTreeMap;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::sync::OnceLock;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;
use std::{env, fs, io, thread};

use lagrange::Ensembles;
use lagrange::ensemble::{Ensemble, EnsembleError, Shard};
use lagrange::integrate::Verner98;

use crate::{DoublePendulum, start};

pub(crate) const NUMBER: usize = 2000;
pub(crate) const PER_PART: usize = 64;
/// The last part is not full.
pub(crate) const PARTS: usize = 32;

/// An empty folder, deleted at the end.
pub(crate) struct Folder(pub(crate) PathBuf);

impl Folder {
    pub(crate) fn new(name: &str) -> Self {
        let path = env::temp_dir().join(format!("lagrange_ensemble_{name}_{}", std::process::id()));
        drop(fs::remove_dir_all(&path));
        fs::create_dir_all(&path).expect("can be made");
        Folder(path)
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        drop(fs::remove_dir_all(&self.0));
    }
}

fn masses(i: usize, pendulum: &mut DoublePendulum) {
    pendulum.m2 = 0.5 + 1e-3 * i as f64;
}

pub(crate) fn ensemble(pendulum: &DoublePendulum) -> Ensemble<'_, DoublePendulum, Verner98<f64>> {
    motions(pendulum, masses)
}

/// Returns motions with parameters, one of which fails.
pub(crate) fn motions<'a>(
    pendulum: &'a DoublePendulum,
    change: impl Fn(usize, &mut DoublePendulum) + Send + Sync + 'a,
) -> Ensemble<'a, DoublePendulum, Verner98<f64>> {
    let motions =
        pendulum.ensemble(NUMBER).start(|i, random| if i == 5 { [f64::NAN; 4] } else { start(i, random) });
    motions.parameters(change).until(0.3).seed(7).motions_per_part(PER_PART).threads(2)
}

/// Returns the files of a folder with their contents.
pub(crate) fn files(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let entries = fs::read_dir(folder).expect("is there").map(|entry| entry.expect("can be read").path());
    let name = |path: &Path| path.file_name().expect("has a name").to_string_lossy().into_owned();
    entries.map(|path| (name(&path), fs::read(&path).expect("can be read"))).collect()
}

/// Returns the final contents of all parts.
pub(crate) fn expected() -> &'static BTreeMap<String, Vec<u8>> {
    static EXPECTED: OnceLock<BTreeMap<String, Vec<u8>>> = OnceLock::new();
    EXPECTED.get_or_init(|| {
        let folder = Folder::new("whole");
        let saved = ensemble(&DoublePendulum::default()).threads(1).save_parquet(&folder.0).expect("saves");
        assert_eq!((saved.written, saved.found, saved.missing, saved.failed), (PARTS, 0, 0, 1));
        files(&folder.0)
    })
}

/// Saves until two or three parts exist.
pub(crate) fn begin(folder: &Path) {
    let pendulum = DoublePendulum::default();
    let is_enough = || files(folder).keys().filter(|name| name.ends_with(".parquet")).count() > 1;
    let ensemble = ensemble(&pendulum).progress(|_| match is_enough() {
        true => ControlFlow::Break(()),
        false => ControlFlow::Continue(()),
    });
    let error = ensemble.save_parquet(folder).expect_err("is cancelled");
    assert!(matches!(error, EnsembleError::Cancelled { .. }), "{error}");
    let parts = files(folder).len();
    assert!((2..PARTS).contains(&parts), "{parts}");
}

#[test]
fn parts_are_the_same_bytes_from_any_number_of_threads_and_shards() {
    let folder = Folder::new("shards");
    assert_eq!(expected().keys().next_back().map(String::as_str), Some("part-000031.parquet"));
    for index in [2, 0, 1] {
        let pendulum = DoublePendulum::default();
        let saved = ensemble(&pendulum).shard(Shard::of(index, 3)).save_parquet(&folder.0).expect("saves");
        assert_eq!((saved.found, saved.missing), (0, PARTS - files(&folder.0).len()));
    }
    assert_eq!(files(&folder.0), *expected());
}

#[test]
fn parts_with_samples_are_the_same_bytes_and_go_on() {
    let (whole, pieces) = (Folder::new("samples_whole"), Folder::new("samples"));
    let pendulum = DoublePendulum::default();
    let samples = || ensemble(&pendulum).every(0.1);
    let saved = samples().threads(1).save_parquet(&whole.0).expect("saves");
    assert_eq!((saved.written, saved.found, saved.missing, saved.failed), (PARTS, 0, 0, 1));
    samples().shard(Shard::of(1, 2)).save_parquet(&pieces.0).expect("saves");
    fs::remove_file(pieces.0.join("part-000017.parquet")).expect("is there");
    let saved = samples().save_parquet(&pieces.0).expect("goes on");
    assert_eq!((saved.found, saved.written, saved.missing), (PARTS / 2 - 1, PARTS / 2 + 1, 0));
    assert!(files(&pieces.0) == files(&whole.0));
    let error = ensemble(&pendulum).save_parquet(&pieces.0).expect_err("keeps ends");
    assert!(
        matches!(&error, EnsembleError::OtherEnsemble { differs, .. } if differs[0].contains("every 0.1")),
        "{error}"
    );
}

#[test]
fn a_cancelled_ensemble_goes_on() {
    let folder = Folder::new("cancelled");
    begin(&folder.0);
    let found = files(&folder.0).len();
    let saved = ensemble(&DoublePendulum::default()).save_parquet(&folder.0).expect("saves");
    assert_eq!((saved.found, saved.written), (found, PARTS - found));
    assert_eq!(files(&folder.0), *expected());
    let again = ensemble(&DoublePendulum::default()).save_parquet(&folder.0).expect("has nothing to do");
    assert_eq!((again.found, again.written, again.missing), (PARTS, 0, 0));
}

pub(crate) const CHILD: &str = "LAGRANGE_TEST_FOLDER";

/// Runs this test again as a process of its own, which receives the folder.
pub(crate) fn child(command: &mut Command, test: &str, folder: &Path) -> Child {
    // Its output could go to a limited file.
    command.stdout(Stdio::null()).stderr(Stdio::null());
    command.args(["--exact", test]).env(CHILD, folder).spawn().expect("starts")
}

#[test]
fn a_killed_ensemble_goes_on() {
    if let Some(folder) = env::var_os(CHILD) {
        // Slow enough to be killed.
        let pendulum = DoublePendulum::default();
        let slowly = ensemble(&pendulum);
        slowly.progress(|_| thread::sleep(Duration::from_millis(20))).save_parquet(folder).expect("saves");
        return;
    }
    let folder = Folder::new("killed");
    let this = env::current_exe().expect("is known");
    let mut child = child(&mut Command::new(this), "files::a_killed_ensemble_goes_on", &folder.0);
    while !folder.0.join("part-000002.parquet").exists() {
        assert_eq!(child.try_wait().expect("is a child"), None, "ended before it could be killed");
        thread::sleep(Duration::from_millis(1));
    }
    let error = ensemble(&DoublePendulum::default()).save_parquet(&folder.0).expect_err("has a writer");
    assert!(matches!(error, EnsembleError::Locked { .. }), "{error}");
    child.kill().expect("can be killed");
    assert!(!child.wait().expect("is a child").success());
    let left = files(&folder.0);
    assert!(left.contains_key("shard-0-of-1.lock"));
    assert!(left.len() < PARTS, "all was done before it was killed");
    if !Path::new("/proc/self").exists() {
        fs::remove_file(folder.0.join("shard-0-of-1.lock")).expect("is there");
    }
    // A different number of shards also continues from its parts.
    let pendulum = DoublePendulum::default();
    for index in 0..2 {
        let saved = ensemble(&pendulum).shard(Shard::of(index, 2)).save_parquet(&folder.0).expect("goes on");
        assert!(index == 1 || saved.found >= 3, "{saved:?}");
        assert_eq!(saved.found + saved.written, PARTS / 2);
    }
    assert_eq!(files(&folder.0), *expected());
}

/// Files are limited to a kilobyte, as on a full disk.
#[cfg(unix)]
#[test]
fn a_full_disk_is_an_error_that_loses_nothing() {
    if let Some(folder) = env::var_os(CHILD) {
        let error = ensemble(&DoublePendulum::default()).save_parquet(folder).expect_err("has no room");
        assert!(matches!(error, EnsembleError::File { .. }), "{error}");
        assert!(error.to_string().contains(".parquet`: "), "{error}");
        return;
    }
    let folder = Folder::new("full");
    begin(&folder.0);
    let before = files(&folder.0);
    let mut shell = Command::new("sh");
    shell.args(["-c", "trap '' XFSZ; ulimit -f 2; exec \"$0\" \"$@\""]);
    shell.arg(env::current_exe().expect("is known"));
    let mut child = child(&mut shell, "files::a_full_disk_is_an_error_that_loses_nothing", &folder.0);
    assert!(child.wait().expect("is a child").success());
    assert_eq!(files(&folder.0), before);
    ensemble(&DoublePendulum::default()).save_parquet(&folder.0).expect("has room");
    assert_eq!(files(&folder.0), *expected());
}

/// A disk of a hundred kilobytes in its own namespace, which ends with the process.
#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_that_grows_is_gone_on_with() {
    if let Some(folder) = env::var_os(CHILD) {
        let (folder, pendulum) = (PathBuf::from(folder), DoublePendulum::default());
        let error = ensemble(&pendulum).save_parquet(&folder).expect_err("has no room");
        let is_full = |source: &io::Error| source.kind() == io::ErrorKind::StorageFull;
        assert!(matches!(&error, EnsembleError::File { source, .. } if is_full(source)), "{error:?}");
        let before = files(&folder);
        assert!((2..PARTS).contains(&before.len()) && before.keys().all(|name| name.ends_with(".parquet")));
        let mut mount = Command::new("mount");
        assert!(mount.args(["-o", "remount,size=10m"]).arg(&folder).status().expect("starts").success());
        let saved = ensemble(&pendulum).save_parquet(&folder).expect("has room");
        assert_eq!((saved.found, saved.written), (before.len(), PARTS - before.len()));
        assert!(files(&folder) == *expected());
        return;
    }
    on_a_small_disk(&Folder::new("disk"), "files::a_full_disk_that_grows_is_gone_on_with");
}

/// Runs a test again as a process whose folder is a separate disk of 100 kilobytes, if one can be
/// mounted.
#[cfg(target_os = "linux")]
pub(crate) fn on_a_small_disk(folder: &Folder, test: &str) {
    let namespace = |script: &str| {
        let mut command = Command::new("unshare");
        command.args(["--mount", "--map-root-user", "sh", "-c"]);
        command
            .arg(format!("mount -t tmpfs -o size=100k tmpfs '{}' && {script}", folder.0.display()))
            .arg("sh");
        command
    };
    if !namespace("true").status().is_ok_and(|status| status.success()) {
        eprintln!("not tested: nothing can be mounted here");
        return;
    }
    let mut inside = namespace("exec \"$@\"");
    inside.arg(env::current_exe().expect("is known"));
    assert!(child(&mut inside, test, &folder.0).wait().expect("is a child").success());
}

#[test]
fn a_panic_keeps_the_parts_before_it() {
    let (folder, pendulum) = (Folder::new("panic"), DoublePendulum::default());
    let is_wrong = AtomicBool::new(true);
    let ensemble = || {
        let change = |i: usize, p: &mut DoublePendulum| {
            assert!(
                i < 400 || i == NUMBER / 2 || i == NUMBER - 1 || !is_wrong.load(Ordering::Relaxed),
                "too heavy"
            );
            masses(i, p);
        };
        motions(&pendulum, change)
    };
    let error = ensemble().save_parquet(&folder.0).expect_err("panics").to_string();
    assert_eq!(error, "motion 400 panicked: too heavy");
    assert_eq!(files(&folder.0).len(), 400 / PER_PART);
    is_wrong.store(false, Ordering::Relaxed);
    let saved = ensemble().save_parquet(&folder.0).expect("goes on");
    assert_eq!((saved.found, saved.missing), (400 / PER_PART, 0));
    assert_eq!(files(&folder.0), *expected());
}

#[test]
fn a_second_writer_is_kept_off() {
    let folder = Folder::new("writers");
    let (first, second) = (DoublePendulum::default(), DoublePendulum::default());
    let was_refused = AtomicBool::new(false);
    let ensemble_with_other = ensemble(&first).threads(1).progress(|_| {
        for shard in [Shard::WHOLE, Shard::of(1, 2)] {
            let error = ensemble(&second).shard(shard).save_parquet(&folder.0).expect_err("is kept off");
            assert!(matches!(error, EnsembleError::Locked { .. }), "{error}");
        }
        was_refused.store(true, Ordering::Relaxed);
        ControlFlow::<()>::Break(())
    });
    let error = ensemble_with_other.save_parquet(&folder.0).expect_err("is cancelled");
    assert!(matches!(error, EnsembleError::Cancelled { .. }), "{error}");
    assert!(was_refused.into_inner());
    assert_eq!(files(&folder.0).len(), 0, "locks are gone");
}

#[test]
fn a_lock_from_another_machine_is_explained() {
    let folder = Folder::new("lock");
    let lock = folder.0.join("shard-0-of-1.lock");
    fs::write(&lock, "process 4711 on elsewhere\n").expect("writes");
    let error = ensemble(&DoublePendulum::default()).save_parquet(&folder.0).expect_err("is locked");
    let text = error.to_string();
    assert!(text.contains("process 4711 on elsewhere") && text.contains("delete the file"), "{text}");
    assert!(lock.exists());
}

#[test]
fn a_column_that_is_called_like_another_is_an_error() {
    let folder = Folder::new("column");
    let pendulum = DoublePendulum::default();
    for name in ["index", "cause"] {
        let ensemble = pendulum.ensemble(3).start(start).until(0.1).observe(name, |_, t, _| t);
        let error = ensemble.save_parquet(&folder.0).expect_err("has two").to_string();
        assert!(error.contains(&format!("a column is called `{name}`")), "{error}");
    }
    assert_eq!(files(&folder.0).len(), 0);
}
