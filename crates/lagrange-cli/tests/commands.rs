//! The command as users run it: exit codes, output, and messages about wrong files.

use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::{env, fs};

use serde_json::Value;

fn data(file: &str) -> String {
    format!("tests/data/{file}")
}

fn run(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_lagrange")).args(arguments).output().expect("the command starts")
}

/// Runs a command on text from the standard input.
fn run_on(text: &str, arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_lagrange"));
    let pipes = command.args(arguments).stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = pipes.spawn().expect("the command starts");
    // A command that refuses its options ends before it reads.
    if let Err(error) = child.stdin.take().expect("a pipe").write_all(text.as_bytes()) {
        assert_eq!(error.kind(), ErrorKind::BrokenPipe, "{error}");
    }
    child.wait_with_output().expect("the command ends")
}

fn output(output: &Output) -> String {
    String::from_utf8(output.stdout.clone()).expect("UTF-8")
}

fn errors(output: &Output) -> String {
    String::from_utf8(output.stderr.clone()).expect("UTF-8")
}

/// Returns the text that a command writes without errors or warnings.
fn written(arguments: &[&str]) -> String {
    let result = run(arguments);
    assert_eq!((result.status.code(), errors(&result).as_str()), (Some(0), ""), "{arguments:?}");
    output(&result)
}

/// Returns a path in a folder for temporary files.
fn temporary(name: &str) -> PathBuf {
    Path::new(env!("CARGO_TARGET_TMPDIR")).join(name)
}

#[test]
fn mistakes_are_shown_where_they_are() {
    let result = run(&["check", &data("mistakes.lag")]);
    assert_eq!((result.status.code(), output(&result).as_str()), (Some(1), ""));
    let (listing, path) = (errors(&result), data("mistakes.stderr"));
    if env::var_os("UPDATE_GOLDEN").is_some() {
        fs::write(&path, &listing).expect("written");
    }
    assert_eq!(listing, fs::read_to_string(path).expect("a listing"), "UPDATE_GOLDEN=1 rewrites it");
}

#[test]
fn mistakes_are_data_on_request() {
    let path = data("mistakes.lag");
    let result = run(&["check", "--json", &path, &data("pendulum.lag")]);
    assert_eq!((result.status.code(), errors(&result).as_str()), (Some(1), ""));
    let mistakes = serde_json::from_str::<Vec<Value>>(&output(&result)).expect("JSON");
    let text = fs::read_to_string(&path).expect("a declaration");
    let is_this = |mistake: &&Value| mistake["message"].as_str().is_some_and(|text| text.contains("thetta"));
    let error = mistakes.iter().find(is_this).expect("an error");
    assert_eq!((&error["file"], &error["line"], &error["column"]), (&path.into(), &4.into(), &30.into()));
    let bytes = [0, 1].map(|end| error["bytes"][end].as_u64().expect("a number") as usize);
    assert_eq!(&text[bytes[0]..bytes[1]], "thetta");
    assert!(error["help"].as_str().is_some_and(|help| help.contains("theta")), "{error}");
}

#[test]
fn declarations_without_mistakes_pass_in_silence() {
    assert_eq!(written(&["check", &data("pendulum.lag")]), "");
    assert_eq!(written(&["check", "--json", &data("pendulum.lag")]), "[]\n");
}

#[test]
fn equations_are_written_as_text_and_as_latex() {
    let pendulum = "param m = 1, l = 2, g = 9.81; coord theta;
        kinetic = 1/2 * m * (l * dot(theta))^2; potential = -m * g * l * cos(theta);";
    let text = run_on(pendulum, &["equations", "-"]);
    assert!(output(&text).contains("m*l^2*ddot(theta) = -m*l*g*sin(theta)"), "{}", output(&text));
    let latex = output(&run_on(pendulum, &["equations", "--latex", "-"]));
    assert!(latex.contains(r"\ddot{\theta}") && latex.contains(r"\sin"), "{latex}");
}

#[test]
fn tables_are_files_beside_the_declaration() {
    let equations = written(&["equations", &data("pendulum.lag")]);
    assert!(equations.contains("breeze("), "{equations}");
    let result = run_on(&fs::read_to_string(data("pendulum.lag")).expect("a declaration"), &["check", "-"]);
    assert_eq!(result.status.code(), Some(1), "the standard input is beside no table");
    assert!(
        errors(&result).contains("breeze.csv") && errors(&result).contains("<stdin>:5:"),
        "{}",
        errors(&result)
    );
}

#[test]
fn code_is_that_of_the_macro() {
    let rust = written(&["rust", &data("pendulum.lag")]);
    let file = syn::parse_file(&rust).expect("Rust");
    assert!(!file.items.is_empty() && rust.contains("struct Pendulum"), "{rust}");
    let path = temporary("pendulum.rs");
    let path = path.to_str().expect("UTF-8");
    assert_eq!(written(&["rust", &data("pendulum.lag"), "-o", path]), "");
    assert_eq!(fs::read_to_string(path).expect("written"), rust);
}

#[test]
fn a_compiler_of_c_takes_the_kernel() {
    for arguments in [&["kernel", &data("kernel.lag")][..], &["kernel", "--single", &data("kernel.lag")]] {
        let path = temporary(&format!("kernel_{}.c", arguments.len()));
        fs::write(&path, written(arguments)).expect("written");
        compile(&path);
    }
}

fn compile(path: &Path) {
    let options = ["-std=c99", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Werror", "-fsyntax-only"];
    let result = Command::new("cc").args(options).arg(path).output().expect("a compiler of C");
    assert!(result.status.success(), "{}", errors(&result));
}

#[test]
fn modules_of_c_are_two_files_in_a_folder_or_of_a_name() {
    let folder = temporary("module");
    fs::create_dir_all(&folder).expect("a folder");
    let path = |name: &str| folder.join(name).to_str().expect("UTF-8").to_owned();
    assert_eq!(written(&["c", &data("pendulum.lag"), "-o", &path("")]), "");
    compile(&folder.join("pendulum.c"));
    assert_eq!(written(&["c", &data("pendulum.lag"), "-o", &path("clock")]), "");
    compile(&folder.join("clock.c"));
    let [header, renamed] = ["pendulum.h", "clock.h"].map(|name| fs::read(path(name)).expect("written"));
    assert_eq!(header, renamed, "functions are named for the struct");
    let ball = "coord h; kinetic = 1/2 * dot(h)^2; event floor = h, falling => impact(0.5);";
    let refused = run_on(ball, &["c", "-", "-o", &path("ball")]);
    assert_eq!(refused.status.code(), Some(1));
    assert_eq!(
        errors(&refused),
        "error: <stdin>: rigid contacts and friction run in Rust, on the command line and in Python only (compliant contacts, with a `stiffness`, run here, too): `floor`\n"
    );
    assert!(!folder.join("ball.h").exists() && !folder.join("ball.c").exists());
}

#[test]
fn units_of_fmi_are_archives_in_a_folder_or_of_a_name() {
    let folder = temporary("unit");
    fs::create_dir_all(&folder).expect("a folder");
    let path = |name: &str| folder.join(name).to_str().expect("UTF-8").to_owned();
    let read = |name: &str| String::from_utf8_lossy(&fs::read(path(name)).expect("written")).into_owned();
    assert_eq!(written(&["fmu", &data("swing.lag"), "-o", &path(""), "--sources"]), "");
    let sources = read("swing.fmu");
    assert!(
        sources.starts_with("PK") && sources.contains("name=\"theta\"") && !sources.contains("binaries/")
    );
    assert!(sources.contains("<Real unit=\"rad\" start=\"0.5\"/>"));
    let changed = ["--set", "l=50 cm", "--start", "theta=180deg"];
    let (swing, output) = (data("swing.lag"), path("clock.fmu"));
    let command = [&["fmu", &swing, "-o", &output][..], &changed].concat();
    assert_eq!(written(&command), "");
    let compiled = read("clock.fmu");
    assert!(compiled.contains("binaries/") && compiled.contains("<Real unit=\"m\" start=\"0.5\"/>"));
    assert!(compiled.contains(&format!("<Real unit=\"rad\" start=\"{:?}\"/>", std::f64::consts::PI)));
    assert_eq!(written(&["fmu", &swing, "--fmi", "3", "-o", &path("three.fmu"), "--sources"]), "");
    let three = read("three.fmu");
    assert!(three.contains("fmiVersion=\"3.0\"") && three.contains("sources/buildDescription.xml"));
    for (declaration, options, code, message) in [
        ("coord h = 1; kinetic = dot(h)^2;", &["--fmi", "1"][..], 2, "write `--fmi 2` or `--fmi 3`"),
        ("coord h = 1; kinetic = dot(h)^2; event floor = h, falling => impact(1/2);", &[], 1, "`floor`"),
        ("coord h = 1; param m; kinetic = m * dot(h)^2;", &[], 2, "`m` has no value: write `--set m=1`"),
        ("coord h; kinetic = dot(h)^2;", &[], 2, "the start of `h` is missing"),
        ("coord h = 1; kinetic = dot(h)^2;", &["--set", "k=2"], 2, "`k`"),
    ] {
        let output = path("refused.fmu");
        let refused = run_on(declaration, &[&["fmu", "-", "-o", &output], options].concat());
        assert_eq!(refused.status.code(), Some(code), "{declaration}");
        assert!(errors(&refused).contains(message), "{}", errors(&refused));
    }
    assert!(!folder.join("refused.fmu").exists());
}

#[test]
fn robots_are_imported() {
    let robots = "../lagrange-import/tests/data";
    let result = run(&["urdf", &format!("{robots}/every_joint.urdf")]);
    assert_eq!(result.status.code(), Some(0));
    let expected = fs::read_to_string(format!("{robots}/every_joint.rs")).expect("a declaration");
    assert_eq!(output(&result), expected);
    assert!(errors(&result).contains("every_joint.urdf:"), "warnings have lines: {}", errors(&result));
    let walker = format!("{robots}/walker.urdf");
    let standing = ["urdf", &walker, "--free", "--inputs", "--limits", "--friction", "--contacts"];
    let expected = fs::read_to_string(format!("{robots}/walker_standing.rs")).expect("a declaration");
    assert_eq!(output(&run(&standing)), expected);
    let checked = run_on(&output(&run(&standing)), &["check", "-"]);
    assert_eq!(checked.status.code(), Some(0), "{}", errors(&checked));
    let corners = output(&run(&["urdf", &walker, "--free", "--corners", "trunk"]));
    assert_eq!(corners.matches("contact trunk_corner[").count(), 8, "{corners}");
    let broken = run_on("<robot name='r'><link/></robot>", &["urdf", "-"]);
    assert_eq!((broken.status.code(), output(&broken).as_str()), (Some(1), ""));
    assert!(errors(&broken).contains("<stdin>:1:17"), "{}", errors(&broken));
}

#[test]
fn files_that_cannot_be_read_or_written_are_named() {
    let missing = run(&["check", "no_such_file.lag", &data("mistakes.lag")]);
    assert_eq!(missing.status.code(), Some(1));
    assert!(errors(&missing).starts_with("error: no_such_file.lag: "), "{}", errors(&missing));
    assert!(errors(&missing).contains("thetta"), "the other file is checked");
    for (path, reason) in [("tests", "it is a folder"), ("/dev/null", "it is not a regular file")] {
        let result = run(&["check", path]);
        assert!(errors(&result).contains(reason) && result.status.code() == Some(1), "{}", errors(&result));
    }
    let unwritable = run(&["statements", &data("pendulum.lag"), "-o", "no_such_folder/file"]);
    assert_eq!(unwritable.status.code(), Some(1));
    assert!(errors(&unwritable).starts_with("error: no_such_folder/file: "), "{}", errors(&unwritable));
}

/// `head` closes its input after it has read enough.
#[test]
fn readers_may_leave() {
    let swing = data("swing.lag");
    let cases: [(&[&str], i32); 5] = [
        (&["--help"], 0),
        (&["solve"], 2),
        (&["check", "-"], 1),
        (&["equations", "-"], 1),
        (&["simulate", &swing, "--until", "1"], 0),
    ];
    for (arguments, code) in cases {
        // The readers have left before the command starts.
        let [output, error] = [(); 2].map(|()| io::pipe().expect("a pipe").1);
        let mut command = Command::new(env!("CARGO_BIN_EXE_lagrange"));
        let pipes = command.args(arguments).stdin(Stdio::null()).stdout(output).stderr(error);
        assert_eq!(pipes.status().expect("the command starts").code(), Some(code), "{arguments:?}");
    }
}

#[test]
fn commands_without_meaning_name_what_is_wrong() {
    let cases: [(&[&str], &str); 10] = [
        (&[], "a command is missing"),
        (&["solve"], "unknown command `solve`"),
        (&["check"], "the name of a file is missing"),
        (&["rust", "a", "b"], "one file at a time"),
        (&["rust", "a", "--latex"], "invalid option '--latex'"),
        (&["c", "a", "--single"], "invalid option '--single'"),
        (&["kernel", "a", "--name", "b"], "invalid option '--name'"),
        (&["rust", "a", "-o"], "missing argument"),
        (&["rust", "a", "--limits"], "invalid option '--limits'"),
        (&["--verbose"], "invalid option '--verbose'"),
    ];
    for (arguments, message) in cases {
        let result = run(arguments);
        assert_eq!(result.status.code(), Some(2), "{arguments:?}");
        assert!(errors(&result).contains(message), "{arguments:?}: {}", errors(&result));
    }
    assert!(written(&["--help"]).contains("Exit codes"));
    assert!(written(&["rust", "--help"]).contains("Exit codes"));
    assert!(written(&["--version"]).starts_with("lagrange "));
}

#[test]
fn a_declaration_may_stand_in_its_macro() {
    let text = fs::read_to_string(data("mistakes.lag")).expect("a declaration");
    let listing = |text: &str| errors(&run_on(text, &["check", "-"]));
    let wrapped = listing(&format!("\n::lagrange::system! {{\n{text}}}\n"));
    // Two lines lower.
    let place = |listing: &str| {
        let place = listing.lines().find_map(|line| line.trim().strip_prefix("--> <stdin>:"));
        place.map(str::to_owned).expect("a place")
    };
    let line = |place: &str| place.split(':').next().and_then(|line| line.parse::<u32>().ok());
    let (alone, moved) = (place(&listing(&text)), place(&wrapped));
    assert_eq!(line(&moved), line(&alone).map(|line| line + 2), "{wrapped}");
}

#[test]
fn declarations_are_found_in_files_of_rust() {
    let swing = "/// Swings.\n    pub struct Swing;\n    coord a = 0.1; kinetic = dot(a)^2; potential = a^2;";
    let spring = "struct Spring; coord x = 1; kinetic = dot(x)^2; potential = k * x^2;";
    let one = format!(
        "//! A program.\nuse lagrange::Simulate;\n\nlagrange::system! {{\n    {swing}\n}}\nfn main() {{}}\n"
    );
    let two = format!("{one}mod other {{ use lagrange::system; system! {{ {spring} }} }}\n");
    let folder = temporary("rust");
    fs::create_dir_all(&folder).expect("a folder");
    let [one, two] = [("one.rs", one), ("two.rs", two)].map(|(name, text)| {
        let path = folder.join(name);
        fs::write(&path, text).expect("written");
        path.to_str().expect("UTF-8").to_owned()
    });
    assert!(written(&["statements", &one]).contains("coord a"));
    assert_eq!(written(&["statements", &one]), written(&["statements", &format!("{two}#Swing")]));
    let refused = |path: &str| {
        let result = run(&["check", path]);
        assert_eq!(result.status.code(), Some(1), "{path}");
        errors(&result)
    };
    assert!(refused(&two).contains("write one of `#Swing`, `#Spring` behind the name of the file"));
    assert!(refused(&format!("{two}#Top")).contains("no `#Top` among `#Swing`, `#Spring`"));
    assert!(refused(&format!("{}#Top", data("swing.lag"))).contains("there is no `system!`, so no `#Top`"));
    // Errors keep their location in the file.
    assert!(
        refused(&format!("{two}#Spring")).contains("two.rs:10:"),
        "{}",
        refused(&format!("{two}#Spring"))
    );
    let piped = run_on(&fs::read_to_string(&one).expect("read"), &["statements", "-"]);
    assert_eq!(output(&piped), written(&["statements", &one]));
}

/// Returns the errors of commands that each refuse a declaration.
fn refusals(text: &str, commands: &[&[&str]]) -> Vec<String> {
    let refused = |command: &&[&str]| {
        let result = run_on(text, command);
        assert_ne!(result.status.code(), Some(0), "{command:?}: {}", output(&result));
        errors(&result)
    };
    commands.iter().map(refused).collect()
}

#[test]
fn delays_are_refused_by_all_that_knows_no_past() {
    let folder = temporary("late");
    let file = folder.to_str().expect("UTF-8");
    let text = "struct Late; coord x = 1; kinetic = 1/2 * dot(x)^2; force x = -delay(x, 0.1);";
    let linear = refusals(text, &[&["linearise", "-"]]);
    assert!(linear[0].contains("a linear model has no delays"), "{linear:?}");
    let trade = refusals(text, &[&["trade", "-", "--until", "1"]]);
    assert!(trade[0].contains("delayed signals need a past"), "{trade:?}");
    let exports = [&["c", "-", "-o", file][..], &["fmu", "-", "-o", file], &["page", "-", "-o", file]];
    for error in refusals(text, &exports) {
        assert!(error.contains("delayed signals need a past"), "{error}");
    }
    let kernel = refusals(text, &[&["kernel", "-"]]);
    assert!(kernel[0].contains("delayed signals, whose past a run keeps"), "{kernel:?}");
}

#[test]
fn contacts_of_boxes_are_stepped_and_refused_once_by_all_exports() {
    let folder = temporary("stack");
    let file = folder.to_str().expect("UTF-8");
    let text = "struct Stack; gravity = (0, 0, -9.81); body floor { mass: 9; shape: cuboid(2, 2, 1); }
        weld ground to floor; body block { mass: 1; shape: cuboid(0.2, 0.2, 0.2); } free block;
        contact touch = block on floor { friction: 0.5; }";
    let values =
        ["block_x=0", "block_y=0", "block_z=0.7", "block_qw=1", "block_qx=0", "block_qy=0", "block_qz=0"];
    let start = values.iter().flat_map(|value| ["--start", value]).collect::<Vec<_>>();
    let [fmu, page] = ["fmu", "page"].map(|command| [&[command, "-", "-o", file][..], &start].concat());
    for error in refusals(text, &[&["c", "-", "-o", file], &fmu, &page]) {
        assert!(error.starts_with("error: ") && error.matches("error").count() == 1, "{error}");
        assert!(error.contains("rigid contacts and friction run in Rust"), "{error}");
        assert!(error.ends_with(": `touch`\n"), "{error}");
    }
    let run = |method: &[&'static str]| {
        let simulate = ["simulate", "-", "--until", "1", "--every", "1"];
        run_on(text, &[&simulate[..], &start, method].concat())
    };
    let landed = output(&run(&["--method", "stepped", "--step", "2 ms"]));
    let last = landed.lines().last().and_then(|row| row.split(',').nth(3)).expect("a height");
    assert!((last.parse::<f64>().expect("a number") - 0.6).abs() < 1e-6, "{landed}");
    assert!(errors(&run(&[])).contains("`touch[0]` of faces and edges needs the method `Stepped`"));
    assert_eq!(output(&run_on(text, &["check", "-"])), "");
}

#[test]
fn noise_is_refused_by_all_that_integrates_none() {
    let folder = temporary("noisy");
    let file = folder.to_str().expect("UTF-8");
    let text = "struct Noisy; coord x = 1; noise w, density: 1; kinetic = 1/2 * dot(x)^2; force x = w - x;";
    let runs = [
        &["simulate", "-", "--until", "1"][..],
        &["ensemble", "-", "--until", "1", "--motions", "2"],
        &["trade", "-", "--until", "1"],
    ];
    for error in refusals(text, &runs) {
        assert!(error.contains("stochastic"), "{error}");
    }
    let exports = [&["c", "-", "-o", file][..], &["fmu", "-", "-o", file], &["page", "-", "-o", file]];
    for error in refusals(text, &exports) {
        let said = "white noise runs in compiled Rust and by `lagrange simulate` only: `w`";
        assert!(error.contains(said), "{error}");
    }
    let kernel = refusals(text, &[&["kernel", "-"]]);
    assert!(kernel[0].contains("cannot be combined with noise"), "{kernel:?}");
    let plain = run_on("noise w[2], density: [1, 2]; state a; dot(a) = w[0] - w[1];", &["statements", "-"]);
    assert!(
        output(&plain).contains("noise w_0, density: 1;\nnoise w_1, density: 2;\n"),
        "{}",
        output(&plain)
    );
    // The linear model is that without noise.
    let model = run_on(text, &["linearise", "-"]);
    assert_eq!(model.status.code(), Some(0), "{}", errors(&model));
}
