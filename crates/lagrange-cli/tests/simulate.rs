//! Motions on the command line: files, values with units, and all possible errors.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

const SWING: &str = "tests/data/swing.lag";

fn simulate(arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_lagrange"));
    command.arg("simulate").args(arguments).output().expect("the command starts")
}

fn text(bytes: &[u8]) -> &str {
    std::str::from_utf8(bytes).expect("UTF-8")
}

/// Returns the rows of a motion computed without errors.
fn rows(arguments: &[&str]) -> (String, Vec<Vec<f64>>) {
    let result = simulate(arguments);
    assert_eq!((result.status.code(), text(&result.stderr)), (Some(0), ""), "{arguments:?}");
    table(text(&result.stdout))
}

fn table(csv: &str) -> (String, Vec<Vec<f64>>) {
    let (head, rows) = csv.split_once('\n').expect("a line of names");
    let numbers = |row: &str| row.split(',').map(|cell| cell.parse().expect("a number")).collect();
    (head.to_owned(), rows.lines().map(numbers).collect())
}

/// Runs an endless simulation for three seconds, and returns what it writes, or `None` without the
/// programs for that. With `is_terminal`, it writes to one.
fn endless(is_terminal: bool) -> Option<String> {
    let lagrange = env!("CARGO_BIN_EXE_lagrange");
    let line = format!("timeout 3 {lagrange} simulate {SWING} --until 1e9 --every 1e9");
    let (program, arguments) = match is_terminal {
        true => ("script", ["-qec", &line, "/dev/null"].to_vec()),
        false => ("sh", ["-c", &line].to_vec()),
    };
    let Ok(output) = Command::new(program).args(arguments).output() else {
        eprintln!("skipped: there is no `{program}`");
        return None;
    };
    Some([text(&output.stdout), text(&output.stderr)].concat())
}

#[test]
fn progress_is_shown_on_terminals_only() {
    if let Some(written) = endless(true) {
        assert!(written.contains("\r  0.0 %"), "{written:?}");
    }
    assert_eq!(endless(false).as_deref(), Some(""));
}

fn temporary(name: &str) -> PathBuf {
    Path::new(env!("CARGO_TARGET_TMPDIR")).join(name)
}

/// Writes a declaration to a file for temporary files.
fn declaration(name: &str, text: &str) -> String {
    let path = temporary(name);
    fs::write(&path, text).expect("written");
    path.to_str().expect("UTF-8").to_owned()
}

/// A ball that falls from h with g hits the floor after √(2h/g). The intervals after it begin with
/// 2 e √(2h/g), and shrink by the coefficient of restitution e.
#[test]
fn a_ball_bounces_at_the_times_of_geometric_series() {
    let path = declaration(
        "ball.lag",
        "param g = 9.81, e = 0.6; coord h = 2; kinetic = 1/2 * dot(h)^2; potential = g * h;
        event floor = h, falling => impact(e);",
    );
    let file = temporary("bounces.csv");
    let file = file.to_str().expect("UTF-8");
    let (_, states) =
        rows(&[&path, "--until", "4", "--every", "4", "--tolerance", "1e-12", "--events", file]);
    assert_eq!(states.last(), Some(&vec![4.0, 0.0, 0.0]), "it lies on the floor");
    let events = fs::read_to_string(file).expect("written");
    let times = events.lines().skip(1).filter_map(|line| line.split(',').find_map(|cell| cell.parse().ok()));
    let times = times.collect::<Vec<f64>>();
    let (fall, e) = ((4.0_f64 / 9.81).sqrt(), 0.6_f64);
    let expected = |n: i32| fall * (1.0 + 2.0 * (e - e.powi(n + 1)) / (1.0 - e));
    assert!(times.len() > 20, "{events}");
    for (n, time) in times.iter().enumerate() {
        assert!((time - expected(n as i32)).abs() < 1e-8, "{n}: {time} {}", expected(n as i32));
    }
    let stepped = rows(&[&path, "--until", "4", "--method", "stepped", "--step", "1 ms", "--every", "4"]);
    let [_, height, rate] = stepped.1[1][..] else { panic!("{stepped:?}") };
    assert!(height.abs() < 1e-9 && rate.abs() < 1e-9, "{stepped:?}");
}

/// A block with the speed v and dry friction μ m g comes to rest after v/(μ g) and v²/(2 μ g).
#[test]
fn a_block_slides_to_rest() {
    let path = declaration(
        "block.lag",
        "param mu = 0.3, g = 9.81; coord x = 0; start dot(x) = 2; kinetic = 1/2 * dot(x)^2;
        friction rub = dot(x), mu * g; output grip = rub;",
    );
    let way = 4.0 / (2.0 * 0.3 * 9.81);
    for (method, error) in
        [(&["--tolerance", "1e-12"][..], 1e-11), (&["--method", "stepped", "--step", "1ms"], 2e-3)]
    {
        let arguments = [&[&path, "--until", "2", "--every", "0.5"][..], method].concat();
        let (head, rows) = rows(&arguments);
        assert_eq!(head, "t,x,x_dot,grip");
        assert!((rows[4][1] - way).abs() < error && rows[4][2].abs() < 1e-12, "{rows:?}");
        assert!((rows[1][3] + 0.3 * 9.81).abs() < 1e-12 && rows[4][3].abs() < 1e-9, "{rows:?}");
    }
}

/// θ = 2 arcsin(k sn(K(k) − √(g/l) t, k)) with k = sin(θ₀/2), by 200 000 integration steps of order
/// four.
#[test]
fn a_pendulum_swings_from_its_declared_start() {
    let (head, rows) =
        rows(&[SWING, "--until", "1", "--every", "0.5", "--set", "l=2", "--tolerance", "1e-12"]);
    assert_eq!(head, "t in s,theta in rad,theta_dot in rad/s,height in m");
    assert_eq!(rows.len(), 3);
    assert_eq!(rows[0][..3], [0.0, 0.5, 0.0]);
    assert!((rows[2][1] + 0.28719127873525785).abs() < 1e-10, "{rows:?}");
    assert!((rows[2][3] + 2.0 * rows[2][1].cos()).abs() < 1e-15, "outputs are columns");
}

#[test]
fn values_have_units() {
    let plain = rows(&[SWING, "--until", "1", "--set", "l=0.5", "--start", "theta=0.25"]);
    let units = rows(&[SWING, "--until", "1000ms", "--set", "l=50 cm", "--start", "theta=250mrad"]);
    assert_eq!(plain, units);
}

/// Plain numbers are in the declared unit, as in the declaration.
#[test]
fn plain_numbers_are_in_the_declared_unit() {
    let file = declaration(
        "centimetres.lag",
        "part Spring(x) { param k: N/cm = 1; potential = 1/2 * k * x^2; }
         param m: g = 500, rest[2]: cm = 0;
         coord x: mm nominal 1 = 20;
         state warmth: % = 50;
         s: Spring { x: x; };
         kinetic = 1/2 * m * dot(x)^2;
         force x = 40 [N/m] * (rest[0] + rest[1]);
         dot(warmth) = -0.1 [1/s] * warmth;
         output length: cm = x;",
    );
    let last = |settings: &[&str]| {
        let (_, rows) = rows(&[&[&*file, "--until", "0.1", "--every", "0.1"], settings].concat());
        rows[1].clone()
    };
    for [plain, unit] in [
        ["m=250", "m=0.25 kg"],
        ["rest[1]=3", "rest[1]=30 mm"],
        ["s.k=2", "s.k=200 [N/m]"],
        ["x=5", "x=0.5cm"],
        ["x=5*2", "x=1cm"],
        ["warmth=40", "warmth=0.4 [1]"],
        ["x_dot=3", "x_dot=300 [cm/s]"],
    ] {
        let option = if plain.starts_with(['x', 'w']) { "--start" } else { "--set" };
        assert_eq!(last(&[option, plain]), last(&[option, unit]), "{plain}");
        assert_ne!(last(&[option, plain]), last(&[]), "{plain}");
    }
    // Columns are in the units that they name.
    assert_eq!(rows(&[&file, "--until", "0"]).1[0][1..3], [0.02, 0.5]);
}

#[test]
fn methods_agree_and_energy_is_conserved() {
    let run =
        |method: &[&str]| rows(&[&[SWING, "--until", "2", "--every", "2", "--energy"], method].concat()).1;
    let reference = run(&["--tolerance", "1e-13"]);
    let others: [&[&str]; 4] = [
        &["--method", "radau", "--tolerance", "1e-11"],
        &["--method", "taylor", "--tolerance", "1e-12"],
        &["--method", "rk4", "--step", "1 ms"],
        &["--method", "gauss", "--step", "0.01"],
    ];
    for method in others {
        let found = run(method);
        assert!((found[1][1] - reference[1][1]).abs() < 1e-9, "{method:?}");
        assert!((found[1][4] - found[0][4]).abs() < 1e-9, "{method:?}");
    }
}

#[test]
fn files_have_the_format_of_their_extension() {
    let path = |extension: &str| temporary(&format!("swing.{extension}"));
    let starts = [("csv", &b"t in s,"[..]), ("parquet", b"PAR1"), ("svg", b"<svg"), ("png", b"\x89PNG")];
    for (extension, start) in starts {
        let path = path(extension);
        let result = simulate(&[SWING, "--until", "1", "-o", path.to_str().expect("UTF-8")]);
        assert_eq!((result.status.code(), text(&result.stdout)), (Some(0), ""), "{extension}");
        assert!(fs::read(&path).expect("written").starts_with(start), "{extension}");
    }
    let direct = simulate(&[SWING, "--until", "1"]);
    assert_eq!(direct.stdout, fs::read(path("csv")).expect("written"));
}

#[test]
fn events_are_listed_in_a_file() {
    let path = temporary("events.csv");
    rows(&[SWING, "--until", "2", "--events", path.to_str().expect("UTF-8")]);
    let events = fs::read_to_string(path).expect("written");
    let lines = events.lines().collect::<Vec<_>>();
    assert_eq!(lines[0], "t,event,theta,theta_dot");
    // A quarter and three quarters of the period, 4 K(sin(θ₀/2))/√(g/l).
    let times = lines[1..].iter().map(|line| line.split(',').next().expect("a time").parse::<f64>());
    let times = times.collect::<Result<Vec<_>, _>>().expect("numbers");
    let quarter = 2.0378679151581687_f64 / 4.0;
    assert_eq!(times.len(), 2);
    assert!((times[0] - quarter).abs() < 1e-9 && (times[1] - 3.0 * quarter).abs() < 1e-9, "{times:?}");
}

#[test]
fn options_that_make_no_sense_are_named() {
    let cases: [(&[&str], &str); 19] = [
        (&[], "the end is missing"),
        (&["--until", "soon"], "--until soon: unknown name `soon`"),
        (&["--until", "1 kg"], "--until 1 kg: "),
        (&["--until", "1", "--set", "q=1"], "no `q`; known are `m`, `l`, `g`"),
        (&["--until", "1", "--set", "m=two"], "--set m=two: unknown name `two`"),
        (&["--until", "1", "--set", "m=2 s"], "kg"),
        (&["--until", "1", "--set", "m"], "has no value"),
        (&["--until", "1", "--set", "m=1/0"], "--set m=1/0: "),
        (&["--until", "1", "--start", "phi=1"], "no `phi`; known are `theta`, `theta_dot`"),
        (&["--until", "1", "--method", "euler"], "`gauss`, `stepped`, `maruyama`, `stochastic`"),
        (&["--until", "1", "--method", "rk4"], "write `--step 0.01`"),
        (&["--until", "1", "--method", "stepped"], "write `--step 0.01`"),
        (&["--until", "1", "--method", "taylor", "--step", "0.01"], "the method `taylor` has no `--step`"),
        (&["--until", "1", "--step", "0.1"], "has no `--step`"),
        (&["--until", "1", "--tolerance=-1"], "tolerances must be"),
        (&["--until", "1", "--every", "0"], "interval"),
        (&["--until", "1e400"], "--until 1e400: the value is too large for `f64`"),
        (&["--until", "1", "--seed", "3"], "`--seed` chooses the noise"),
        (&["--until", "1", "-o", "swing.pdf"], "csv, parquet, svg, png"),
    ];
    for (arguments, message) in cases {
        let result = simulate(&[&[SWING], arguments].concat());
        assert_eq!((result.status.code(), text(&result.stdout)), (Some(2), ""), "{arguments:?}");
        assert!(text(&result.stderr).contains(message), "{arguments:?}: {}", text(&result.stderr));
    }
}

#[test]
fn missing_starts_and_parameters_are_named() {
    let path = declaration(
        "bare.lag",
        "param k; coord x, y; kinetic = 1/2 * (dot(x)^2 + dot(y)^2); potential = k * x;",
    );
    let refused = |arguments: &[&str]| {
        let result = simulate(&[&[path.as_str(), "--until", "1"], arguments].concat());
        assert_eq!(result.status.code(), Some(2));
        text(&result.stderr).to_owned()
    };
    assert!(refused(&["--start", "x=0"]).contains("`k` has no value"));
    assert!(refused(&["--set", "k=2", "--start", "x=0"]).contains("the start of `y` is missing"));
    let (_, rows) = rows(&[&path, "--until", "1", "--set", "k=2", "--start", "x=0", "--start", "y=1"]);
    assert!((rows.last().expect("an end")[1] + 1.0).abs() < 1e-12, "x = −k t²/2");
}

/// x = 1 − t up to 1, and 1 − t + (t − 1)²/2 up to 2.
#[test]
fn delayed_signals_follow_the_method_of_steps() {
    let path = declaration("late.lag", "state x = 1; let past = delay(x, 1); dot(x) = -past;");
    for method in [&["--method", "radau"][..], &["--method", "rk4", "--step", "0.1"], &[]] {
        let (names, rows) = rows(&[&[path.as_str(), "--until", "2", "--every", "0.5"], method].concat());
        assert_eq!(names, "t,x,past");
        let expected = [[1.0, 1.0], [0.5, 1.0], [0.0, 1.0], [-0.375, 0.5], [-0.5, 0.0]];
        for (row, expected) in rows.iter().zip(expected) {
            let [x, past] = expected;
            assert!((row[1] - x).abs() < 1e-9 && (row[2] - past).abs() < 1e-9, "{row:?}, not {expected:?}");
        }
        assert_eq!(rows.len(), 5);
    }
}

#[test]
fn systems_without_series_are_refused_with_the_reason() {
    for (name, system, reason) in [
        ("late_series.lag", "state x = 1; dot(x) = -delay(x, 1);", "delayed signals, whose past a run keeps"),
        (
            "noisy.lag",
            "coord x = 1; noise w, density: 1; kinetic = 1/2 * dot(x)^2; force x = w;",
            "noise, which",
        ),
    ] {
        let path = declaration(name, system);
        let result = simulate(&[&path, "--until", "2", "--method", "taylor"]);
        assert_eq!((result.status.code(), text(&result.stdout)), (Some(2), ""), "{name}");
        let wanted = format!("error: `taylor` cannot be combined with {reason}");
        assert!(text(&result.stderr).starts_with(&wanted), "{}", text(&result.stderr));
    }
}

/// A run that never starts writes nothing.
#[test]
fn delays_and_parameters_out_of_range_are_mistakes_of_usage() {
    let system = "param lag = 1, k > 0 = 1; state x = 1; let past = delay(x, lag); dot(x) = -k * past;";
    let path = declaration("bad_lag.lag", system);
    for (value, message) in [
        ("lag=-1", "the delay of `past` is -1.0, but it must be positive and finite"),
        ("k=-1", "the parameter `k` is -1.0, but it must be greater than 0.0"),
    ] {
        let result = simulate(&[&path, "--until", "2", "--set", value]);
        assert_eq!((result.status.code(), text(&result.stdout)), (Some(2), ""), "{value}");
        assert!(text(&result.stderr).contains(message), "{}", text(&result.stderr));
    }
}

#[test]
fn delayed_signals_have_no_values_to_set() {
    let path =
        declaration("set_late.lag", "param k = 1; state x = 1; let past = delay(x, 1); dot(x) = -k * past;");
    let result = simulate(&[&path, "--until", "2", "--set", "past=5"]);
    assert_eq!(result.status.code(), Some(2));
    let message = "there is no `past`; known are `k`";
    assert!(text(&result.stderr).contains(message), "{}", text(&result.stderr));
}

#[test]
fn ranges_end_motions_with_the_name_and_the_value() {
    let path = declaration("range.lag", "coord x in ..=1; start dot(x) = 1; kinetic = 1/2 * dot(x)^2;");
    let result = simulate(&[&path, "--until", "5"]);
    assert_eq!(result.status.code(), Some(3));
    assert!(text(&result.stderr).contains("the coordinate `x` is"), "{}", text(&result.stderr));
    let result = simulate(&[&path, "--until", "5", "--start", "x=2"]);
    let message = "the coordinate `x` is 2.0, but it must be at most 1.0";
    assert!(text(&result.stderr).contains(message), "{}", text(&result.stderr));
}

#[test]
fn a_motion_that_fails_is_written_up_to_its_last_good_state() {
    let path = declaration(
        "root.lag",
        "coord x = 1; start dot(x) = -1; kinetic = 1/2 * dot(x)^2; force x = -sqrt(x);",
    );
    let file = temporary("root.csv");
    let result = simulate(&[&path, "--until", "5", "-o", file.to_str().expect("UTF-8")]);
    assert_eq!((result.status.code(), text(&result.stdout)), (Some(3), ""));
    assert!(text(&result.stderr).contains("x_ddot"), "{}", text(&result.stderr));
    let (_, rows) = table(&fs::read_to_string(file).expect("written"));
    let last = rows.last().expect("a state");
    assert!(last[0] > 0.5 && last[0] < 1.0 && last[1].abs() < 1e-6, "{last:?}");
}

#[test]
fn systems_that_need_a_compiler_are_refused_by_name() {
    let path = declaration(
        "rows.lag",
        "coord x[33]; kinetic = 1/2 * sum(i in 0..33, dot(x[i])^2);
        for i in 0..33 { friction rub[i] = dot(x[i]), 0.3; }",
    );
    let result = simulate(&[&path, "--until", "1"]);
    assert_eq!(result.status.code(), Some(1));
    let message = "33 velocities and 33 forces of contacts and friction, more than the 32 and 48";
    assert!(text(&result.stderr).contains(message), "{}", text(&result.stderr));
    let mistake = simulate(&[&declaration("mistake.lag", "coord x; kinetic = dot(y)^2;"), "--until", "1"]);
    assert_eq!(mistake.status.code(), Some(1));
    assert!(text(&mistake.stderr).contains("mistake.lag:1:"), "{}", text(&mistake.stderr));
}

/// Splits a command line into words; quotes may enclose spaces.
fn words(line: &str) -> Vec<String> {
    let parts = line.split('\'').enumerate();
    let words = parts.flat_map(|(place, part)| -> Vec<String> {
        if place % 2 == 1 {
            vec![part.to_owned()]
        } else {
            part.split_whitespace().map(str::to_owned).collect()
        }
    });
    words.collect()
}

/// True for equal texts, except for the last digits of numbers, which differ between platforms.
fn are_alike(one: &str, other: &str) -> bool {
    let cells = |text: &str| text.split([',', '\n']).map(str::to_owned).collect::<Vec<_>>();
    let (one, other) = (cells(one), cells(other));
    let is_alike = |(a, b): (&String, &String)| match (a.parse::<f64>(), b.parse::<f64>()) {
        (Ok(a), Ok(b)) => (a - b).abs() < 1e-9,
        _ => a == b,
    };
    one.len() == other.len() && one.iter().zip(&other).all(is_alike)
}

#[test]
fn documented_commands_print_what_the_page_shows() {
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/command_line.md");
    let page = fs::read_to_string(page).expect("a page");
    let declaration = fs::read_to_string(SWING).expect("a declaration");
    assert!(page.contains(&format!("```text\n{declaration}```")), "the page shows the file");
    let mut found = 0;
    for block in page.split("```console\n").skip(1) {
        let (block, _) = block.split_once("```").expect("the end of the block");
        for command in block.split("$ lagrange ").skip(1) {
            let (line, expected) = command.split_once('\n').expect("a line");
            let mut lagrange = Command::new(env!("CARGO_BIN_EXE_lagrange"));
            let result = lagrange.args(words(line)).current_dir("tests/data").output().expect("runs");
            let printed = format!("{}{}", text(&result.stdout), text(&result.stderr));
            assert!(are_alike(&printed, expected), "{line}: {printed} instead of {expected}");
            found += 1;
        }
    }
    assert_eq!(found, 7);
}
