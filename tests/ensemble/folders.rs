//! Folders with wrong contents: parts of another declaration, damaged or misplaced parts, and locks
//! of running processes.

use std::collections::BTreeMap;
use std::ops::ControlFlow;
use std::path::Path;
use std::process::Command;
use std::{env, fs, thread, time::Duration};

use lagrange::Ensembles;
use lagrange::ensemble::{EnsembleError, Shard, verify};
use lagrange::integrate::RungeKutta4;

use crate::files::{
    CHILD, Folder, NUMBER, PARTS, PER_PART, begin, child, ensemble, expected, files, on_a_small_disk,
};
use crate::{DoublePendulum, start};

/// Saves eight falls of a ball as declared here.
macro_rules! fall {
    ($folder:expr, $($declaration:tt)*) => {{
        lagrange::system! {
            #[derive(Clone)]
            struct Ball;
            $($declaration)*
        }
        // Nothing moves at first, and nothing reaches the ground: neither starts nor rates reveal
        // the declaration.
        let ball = Ball { g: 9.81, c: 0.5, ..Ball::default() };
        let falls = ball.ensemble(8).start(|i, _| [1.0 + i as f64, 0.0]).until(0.1);
        falls.method(RungeKutta4 { step: 0.1 / 1024.0 }).motions_per_part(4).save_parquet($folder)
    }};
}

/// Types of one name in one function resemble a declaration that changed between two runs of a
/// program.
#[test]
fn a_declaration_that_was_changed_does_not_go_on() {
    let folder = Folder::new("declaration");
    let path = &folder.0;
    let saved = fall!(path,
        param g = 9.81, c = 0.5;
        coord y;
        table wind(h) = [(0, 0), (100, 1), (200, 3)], interpolation: linear, outside: extend;
        kinetic = 1/2 * dot(y)^2;
        potential = g * y;
        force y = -c * dot(y) * (1 + 0 * wind(y));
        event ground = y, falling => impact(0.8);
    );
    assert_eq!(saved.expect("saves").written, 2);
    let before = files(path);
    let changed = [
        // The drag.
        fall!(path,
            param g = 9.81, c = 0.5;
            coord y;
            table wind(h) = [(0, 0), (100, 1), (200, 3)], interpolation: linear, outside: extend;
            kinetic = 1/2 * dot(y)^2;
            potential = g * y;
            force y = -c * dot(y) * abs(dot(y)) * (1 + 0 * wind(y));
            event ground = y, falling => impact(0.8);
        ),
        // The impact.
        fall!(path,
            param g = 9.81, c = 0.5;
            coord y;
            table wind(h) = [(0, 0), (100, 1), (200, 3)], interpolation: linear, outside: extend;
            kinetic = 1/2 * dot(y)^2;
            potential = g * y;
            force y = -c * dot(y) * (1 + 0 * wind(y));
            event ground = y, falling => impact(0.1);
        ),
        // A value of the table that no ball reaches.
        fall!(path,
            param g = 9.81, c = 0.5;
            coord y;
            table wind(h) = [(0, 0), (100, 1), (200, 4)], interpolation: linear, outside: extend;
            kinetic = 1/2 * dot(y)^2;
            potential = g * y;
            force y = -c * dot(y) * (1 + 0 * wind(y));
            event ground = y, falling => impact(0.8);
        ),
    ];
    for result in changed {
        let error = result.expect_err("is another declaration").to_string();
        assert!(error.contains("equations, constants, events and tables with the fingerprint"), "{error}");
        assert!(error.ends_with("; undo the change, or save to another folder"), "{error}");
    }
    assert!(files(path) == before);
    // Different text with the same meaning.
    let saved = fall!(path,
        /// Acceleration and drag.
        param g = 9.81, c = 0.5; coord y /* up */;
        table wind(h) = [(0, 0), (100, 1), (200, 3)],
            interpolation: linear, outside: extend;
        kinetic = 1/2 * (dot(y)^2);
        potential = g * y; // of weight
        force y = -c * dot(y) * (1 + 0 * wind(y));
        event ground = y, falling => impact(0.8);
    );
    assert_eq!(saved.expect("goes on").found, 2);
}

/// Names do not identify closures, but the bits of the first steps do.
#[test]
fn closures_that_were_changed_do_not_go_on() {
    let (folder, pendulum) = (Folder::new("closures"), DoublePendulum::default());
    let observed = |factor: f64| {
        let motions = ensemble(&pendulum).shard(Shard::of(0, PARTS as u64));
        motions.observe("x", move |_, t, y| factor * t + y[0]).save_parquet(&folder.0)
    };
    observed(1.0).expect("saves");
    let error = observed(2.0).expect_err("is another").to_string();
    assert!(error.contains("in its first steps"), "{error}");
    assert_eq!(observed(1.0).expect("goes on").found, 1);
}

/// Saves two small parts in a folder.
fn small(name: &str) -> (Folder, impl Fn(&Path) -> Result<lagrange::ensemble::Saved, EnsembleError>) {
    let save = |path: &Path| {
        let pendulum = DoublePendulum::default();
        pendulum.ensemble(4).start(start).until(0.05).motions_per_part(2).save_parquet(path)
    };
    let folder = Folder::new(name);
    save(&folder.0).expect("saves");
    (folder, save)
}

#[test]
fn a_flipped_bit_of_any_byte_is_found() {
    let (folder, save) = small("flips");
    let part = folder.0.join("part-000001.parquet");
    let bytes = fs::read(&part).expect("is there");
    assert_eq!(verify(&folder.0).expect("is whole").parts, 2);
    for index in (0..bytes.len()).step_by(if cfg!(large) { 1 } else { 13 }) {
        let mut flipped = bytes.clone();
        flipped[index] ^= 1 << (index % 8);
        fs::write(&part, &flipped).expect("can be written");
        let error = verify(&folder.0).expect_err("is damaged");
        let is_said = matches!(&error, EnsembleError::Damaged { path, .. } | EnsembleError::ForeignFile(path) if *path == part);
        assert!(is_said, "byte {index}: {error}");
        // Resuming repeats a run or two of every motion.
        if index % 91 == 0 {
            assert!(save(&folder.0).is_err(), "byte {index}");
        }
    }
    for length in (0..bytes.len()).step_by(131).chain([bytes.len() - 1]) {
        fs::write(&part, &bytes[..length]).expect("can be written");
        assert!(verify(&folder.0).is_err(), "{length} bytes");
    }
    fs::write(&part, [&bytes[..], b"more"].concat()).expect("can be written");
    assert!(verify(&folder.0).is_err());
    fs::remove_file(&part).expect("is there");
    assert_eq!(save(&folder.0).expect("goes on").written, 1);
    assert!(fs::read(&part).expect("is there") == bytes);
}

#[test]
fn a_part_in_the_place_of_another_is_found() {
    let (folder, save) = small("copies");
    let [one, two] = ["part-000000.parquet", "part-000001.parquet"].map(|name| folder.0.join(name));
    fs::copy(&one, &two).expect("can be copied");
    for error in [verify(&folder.0).err(), save(&folder.0).err()] {
        let error = error.expect("is found").to_string();
        assert!(error.contains("it is part 0 of 2, under the name of another; delete it"), "{error}");
    }
    fs::remove_file(&two).expect("is there");
    assert_eq!(verify(&folder.0).map(|found| (found.parts, found.missing)).ok(), Some((1, 1)));
    fs::copy(&one, folder.0.join("part-000002.parquet")).expect("can be copied");
    assert!(verify(&folder.0).is_err() && save(&folder.0).is_err());
    let other = Folder::new("empty");
    let error = verify(&other.0).expect_err("is empty").to_string();
    assert!(error.starts_with("there are no parts in "), "{error}");
}

#[test]
fn parts_of_two_ensembles_are_not_verified() {
    let (folder, _) = small("mixed");
    let other = Folder::new("mixed_other");
    let pendulum = DoublePendulum::default();
    let motions = pendulum.ensemble(4).start(start).until(0.05).seed(1).motions_per_part(2);
    motions.save_parquet(&other.0).expect("saves");
    fs::copy(other.0.join("part-000001.parquet"), folder.0.join("part-000001.parquet"))
        .expect("can be copied");
    let error = verify(&folder.0).expect_err("is of another").to_string();
    assert!(error.contains("its settings contain `seed 1` instead of `seed 0`"), "{error}");
}

/// Memory does not grow with the number of parts.
#[test]
fn parts_beyond_any_memory_begin() {
    let (folder, pendulum) = (Folder::new("many"), DoublePendulum::default());
    let motions = pendulum.ensemble(usize::MAX).start(start).until(0.01).motions_per_part(1).threads(1);
    let error =
        motions.progress(|_| ControlFlow::<()>::Break(())).save_parquet(&folder.0).expect_err("is cancelled");
    assert!(matches!(error, EnsembleError::Cancelled { .. }), "{error}");
}

#[test]
fn foreign_files_are_passed_over() {
    let folder = Folder::new("foreign");
    let others = [".nfs0001", "README.txt", "notes.parquet", "shard-0.lock", "part-000000.parquet.md5"];
    for name in others {
        fs::write(folder.0.join(name), "mine").expect("writes");
    }
    // The unfinished part of a killed process is removed; files of other shards stay.
    fs::write(folder.0.join("part-000003.parquet.4711-0.unfinished"), "half").expect("writes");
    let saved = ensemble(&DoublePendulum::default()).save_parquet(&folder.0).expect("saves");
    assert_eq!((saved.written, saved.missing), (PARTS, 0));
    let mut there = files(&folder.0);
    for name in others {
        assert_eq!(there.remove(name).as_deref(), Some(&b"mine"[..]), "{name}");
    }
    assert!(there == *expected());
}

#[test]
fn files_that_are_called_like_parts_are_refused() {
    for name in ["part-1.parquet", "part-000000.parquet", "part-000099.parquet"] {
        let folder = Folder::new("misnamed");
        fs::write(folder.0.join(name), "mine").expect("writes");
        let error = ensemble(&DoublePendulum::default()).save_parquet(&folder.0).expect_err("is foreign");
        assert!(matches!(&error, EnsembleError::ForeignFile(path) if path.ends_with(name)), "{error}");
        assert_eq!(files(&folder.0), BTreeMap::from([(name.to_string(), b"mine".to_vec())]));
    }
    let folder = Folder::new("misnamed");
    let file = folder.0.join("file");
    fs::write(&file, "mine").expect("writes");
    let error = ensemble(&DoublePendulum::default()).save_parquet(&file).expect_err("is no folder");
    assert!(matches!(error, EnsembleError::File { .. }), "{error}");
}

/// The lock of a process whose number is invalid here, as in a container, holds while the process
/// runs.
#[cfg(target_os = "linux")]
#[test]
fn a_process_of_another_namespace_is_kept_off() {
    if let Some(folder) = env::var_os(CHILD) {
        let pendulum = DoublePendulum::default();
        let slowly = ensemble(&pendulum).progress(|_| thread::sleep(Duration::from_millis(20)));
        slowly.save_parquet(folder).expect("saves");
        return;
    }
    let namespace = || {
        let mut command = Command::new("unshare");
        command.args(["--pid", "--fork", "--kill-child", "--map-root-user"]);
        command
    };
    if !namespace().arg("true").status().is_ok_and(|status| status.success()) {
        eprintln!("not tested: there are no namespaces here");
        return;
    }
    let folder = Folder::new("namespace");
    let mut inside = namespace();
    inside.arg(env::current_exe().expect("is known"));
    let mut child = child(&mut inside, "folders::a_process_of_another_namespace_is_kept_off", &folder.0);
    while !folder.0.join("part-000001.parquet").exists() {
        assert_eq!(child.try_wait().expect("is a child"), None, "ended before anybody looked");
        thread::sleep(Duration::from_millis(1));
    }
    let error = ensemble(&DoublePendulum::default()).save_parquet(&folder.0).expect_err("has a writer");
    assert!(matches!(error, EnsembleError::Locked { .. }), "{error}");
    child.kill().expect("can be killed");
    child.wait().expect("is a child");
    // The process inside may take a moment to end.
    let pendulum = DoublePendulum::default();
    let saved = (0..1000).find_map(|_| match ensemble(&pendulum).save_parquet(&folder.0) {
        Err(EnsembleError::Locked { .. }) => {
            thread::sleep(Duration::from_millis(10));
            None
        }
        saved => Some(saved),
    });
    let saved = saved.expect("is free in the end").expect("goes on");
    assert_eq!((saved.found + saved.written, saved.missing), (PARTS, 0));
    assert_eq!(files(&folder.0), *expected());
}

#[cfg(target_os = "linux")]
#[test]
fn a_folder_that_is_whole_is_only_read() {
    if let Some(folder) = env::var_os(CHILD) {
        let (folder, pendulum) = (Path::new(&folder), DoublePendulum::default());
        let motions = || pendulum.ensemble(4).start(start).until(0.05).motions_per_part(2);
        let saved = motions().save_parquet(folder).expect("has room");
        assert_eq!(saved.written, 2);
        let mut mount = Command::new("mount");
        assert!(mount.args(["-o", "remount,ro"]).arg(folder).status().expect("starts").success());
        assert!(fs::write(folder.join("file"), "").is_err());
        let saved = motions().save_parquet(folder).expect("needs to write nothing");
        assert_eq!((saved.found, saved.missing), (2, 0));
        assert_eq!(verify(folder).expect("is whole").parts, 2);
        assert!(matches!(motions().seed(1).save_parquet(folder), Err(EnsembleError::OtherEnsemble { .. })));
        return;
    }
    on_a_small_disk(&Folder::new("read_only"), "folders::a_folder_that_is_whole_is_only_read");
}

#[test]
fn parts_of_another_ensemble_are_refused() {
    let folder = Folder::new("other");
    begin(&folder.0);
    let before = files(&folder.0);
    let pendulum = DoublePendulum::default();
    let lighter = DoublePendulum { l2: 0.9, ..DoublePendulum::default() };
    #[track_caller]
    fn assert_refused(result: Result<lagrange::ensemble::Saved, EnsembleError>, says: &str) {
        let error = result.expect_err("is another");
        assert!(
            matches!(&error, EnsembleError::OtherEnsemble { differs, .. } if differs[1].contains(says)),
            "{error}"
        );
    }
    assert_refused(ensemble(&pendulum).seed(8).save_parquet(&folder.0), "seed 8");
    assert_refused(ensemble(&pendulum).tolerance(1e-8).save_parquet(&folder.0), "1e-8");
    assert_refused(ensemble(&pendulum).motions_per_part(10).save_parquet(&folder.0), "per part 10");
    assert_refused(ensemble(&pendulum).max_steps(10).save_parquet(&folder.0), "10 steps");
    let error =
        ensemble(&pendulum).max_steps(10).save_parquet(&folder.0).expect_err("is another").to_string();
    assert!(error.contains("its settings lack `run at most 10 steps`;"), "{error}");
    let columns = |names: [&str; 2]| {
        let [one, other] = names;
        ensemble(&pendulum).observe(one, |_, t, _| t).observe(other, |_, t, _| t)
    };
    let two = Folder::new("columns");
    columns(["a", "b"]).shard(Shard::of(0, PARTS as u64)).save_parquet(&two.0).expect("saves");
    let error = columns(["b", "a"]).save_parquet(&two.0).expect_err("has another order").to_string();
    assert!(error.contains("its settings were specified in another order"), "{error}");
    let error = ensemble(&pendulum).save_parquet(&two.0).expect_err("has no columns").to_string();
    assert!(error.contains("its settings contain `run column a`, unlike those here;"), "{error}");
    assert_refused(ensemble(&lighter).save_parquet(&folder.0), "motion 0 starts at");
    let method = RungeKutta4 { step: 0.1 };
    assert_refused(ensemble(&pendulum).method(method).save_parquet(&folder.0), "RungeKutta4");
    let fewer = pendulum.ensemble(NUMBER - 1).start(start).until(0.3).seed(7);
    assert_refused(fewer.motions_per_part(PER_PART).save_parquet(&folder.0), "motions 1999");
    assert_eq!(files(&folder.0), before);
}
