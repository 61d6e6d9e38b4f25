//! Files of pictures.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::{env, fs};

use lagrange::draw::{DrawError, Drawing, Film, Picture};

use crate::scenes::{COLLECTION, CORNER, CROWDED, LADDER, SLOPE, ladder};

fn path(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name)
}

/// Returns one picture of every scene.
fn gallery() -> Vec<(&'static str, Picture)> {
    let states: Vec<(f64, [f64; 2])> =
        (0..=20).map(|k| 1.3 - 0.04 * f64::from(k)).map(|s| (1.3 - s, [s, -1.0])).collect();
    let ladder = ladder().pictures(states).expect("draws").pop().expect("is not empty");
    let slope = Drawing::of(&SLOPE).title("Cuboid and cylinder").velocities().centers().frames();
    let free =
        |name| Drawing::of(&SLOPE).size(320.0, 320.0).title(name).free_body(name).picture(0.0, &[0.0, 0.0]);
    vec![
        ("ladder", ladder),
        (
            "centers",
            Drawing::of(&LADDER)
                .velocities()
                .accelerations()
                .centers()
                .picture(0.0, &[0.9, -1.0])
                .expect("draws"),
        ),
        ("slope", slope.picture(0.0, &[0.0, 1.0]).expect("draws")),
        ("free", Picture::beside(&[free("cylinder").expect("draws"), free("cuboid").expect("draws")])),
        ("forces", Drawing::of(&SLOPE).forces().picture(0.0, &[0.0, 1.0]).expect("draws")),
        ("collection", Drawing::of(&COLLECTION).size(720.0, 560.0).picture(0.0, &[0.3, 0.0]).expect("draws")),
        ("crowded", Drawing::of(&CROWDED).picture(0.0, &[0.3, 0.0]).expect("draws")),
        (
            "small",
            Drawing::of(&LADDER)
                .title("The right foot slips")
                .size(120.0, 90.0)
                .picture(0.0, &[0.9, -1.0])
                .expect("draws"),
        ),
        ("corner", Drawing::of(&CORNER).picture(0.0, &[0.9, 0.0]).expect("draws")),
    ]
}

#[test]
fn pictures_are_saved_by_extension() {
    for (name, picture) in gallery() {
        picture.save(path(&format!("{name}.svg"))).expect("saves");
        picture.save(path(&format!("{name}.png"))).expect("saves");
        assert_eq!(fs::read_to_string(path(&format!("{name}.svg"))).expect("reads"), picture.svg());
        let bytes = fs::read(path(&format!("{name}.png"))).expect("reads");
        assert_eq!(bytes[..8], *b"\x89PNG\r\n\x1a\n");
    }
}

#[test]
fn unwritable_files_are_reported_with_their_path() {
    let picture = Drawing::of(&LADDER).picture(0.0, &[0.9, -1.0]).expect("draws");
    let refused = picture.save("ladder.jpeg").expect_err("is no format that is known").to_string();
    assert_eq!(refused, "`ladder.jpeg` does not end in the name of a format, which is one of svg, png");
    for name in ["none/ladder.svg", "none/ladder.png"] {
        let error = picture.save(path(name)).expect_err("has no folder");
        assert!(matches!(error, DrawError::Io { .. }), "{error:?}");
        let message = error.to_string();
        assert!(message.starts_with("cannot write `") && message.contains(&*path(name).to_string_lossy()));
    }
}

const CHILD: &str = "LAGRANGE_TEST_FOLDER";

/// Files are limited to a kilobyte, as on a full disk.
#[cfg(unix)]
#[test]
fn older_files_survive_a_full_disk() {
    if let Some(folder) = env::var_os(CHILD) {
        save_everything(folder.as_ref(), true);
        return;
    }
    let folder = path("full");
    drop(fs::remove_dir_all(&folder));
    fs::create_dir_all(&folder).expect("can be made");
    let files = || {
        let entries = fs::read_dir(&folder).expect("is there").map(|entry| entry.expect("is there").path());
        let mut files: Vec<_> = entries.map(|path| (fs::read(&path).expect("can be read"), path)).collect();
        files.sort();
        files
    };
    save_everything(&folder, false);
    let before = files();
    assert_eq!(before.len(), 5);
    let mut shell = Command::new("sh");
    shell.args(["-c", "trap '' XFSZ; ulimit -f 2; exec \"$@\"", "sh"]);
    shell.arg(env::current_exe().expect("is known"));
    // Its output could go to a limited file.
    shell
        .args(["--exact", "files::older_files_survive_a_full_disk"])
        .stdout(Stdio::null())
        .stderr(Stdio::null());
    assert!(shell.env(CHILD, &folder).status().expect("starts").success());
    assert!(files() == before);
}

/// Saves a picture and a film in every format.
fn save_everything(folder: &Path, is_full: bool) {
    let states = [(0.0, [0.9, -1.0]), (0.1, [0.8, -1.0])];
    let drawing = Drawing::of(&LADDER);
    let pictures = drawing.pictures(states).expect("draws");
    let film = Film::new(pictures.clone(), states.map(|(t, _)| t).into()).expect("is one");
    let mut saved =
        Vec::from(["svg", "png"].map(|end| pictures[0].save(folder.join(format!("picture.{end}")))));
    saved.extend(["svg", "gif", "html"].map(|end| film.save(folder.join(format!("film.{end}")))));
    assert!(saved.iter().all(|saved| saved.is_ok() != is_full), "{saved:?}");
}

#[test]
fn equal_scenes_give_equal_pictures() {
    for ((_, a), (_, b)) in gallery().into_iter().zip(gallery()) {
        assert_eq!(a.svg(), b.svg());
        let bytes = |picture: &Picture, name: &str| {
            picture.save(path(name)).expect("saves");
            fs::read(path(name)).expect("reads")
        };
        assert!(bytes(&a, "once.png") == bytes(&b, "again.png"), "the same bytes");
    }
}
