//! The price of every digit: methods × numbers × accuracy levels on nine systems with known
//! trajectories.
//!
//!     cargo run --release --features trade --example trade
//!
//! rewrites `docs/trade.md` and the tables and diagrams in `docs/trade/`. If a directory is given,
//! it writes there instead. Look for the fastest method for each accuracy, and for upward bends in
//! the curves, where rounding begins.

#![allow(clippy::needless_update, reason = "for some systems, a case states all fields")]

#[path = "../tests/references/mod.rs"]
mod references;

use std::error::Error;
use std::f64::consts::TAU;
use std::fs;
use std::path::{Path, PathBuf};
use std::time::{SystemTime, UNIX_EPOCH};

use lagrange::trade::{MeasuredRun, Measurement, Report, Trade};
use lagrange::{Double, Number, Portable};
use references::{Numbers, entries};

/// A declaration at each level of accuracy.
macro_rules! levels {
    ($module:ident [$($product:ident),*] { $($body:tt)* } $({ $($reduced:tt)* })?) => {
        mod $module {
            lagrange::system! { pub(crate) struct Standard<S>; $($body)* emit { taylor $(, $product)* } $($($reduced)*)? }
            lagrange::system! { #[accuracy(fast)] pub(crate) struct Fast<S>; $($body)* }
            lagrange::system! { #[accuracy(strict)] pub(crate) struct Strict<S>; $($body)* }
        }
    };
}

levels! { double_pendulum [jacobian, lanes, momentum_rates] {
    param m: kg = 1.0, l: m = 1.0, g: m/s^2 = 9.81;
    coord theta1: rad, theta2: rad;
    let (x1, y1) = (l * sin(theta1), -l * cos(theta1));
    let (x2, y2) = (x1 + l * sin(theta2), y1 - l * cos(theta2));
    kinetic = 1/2 * m * (dot(x1)^2 + dot(y1)^2) + 1/2 * m * (dot(x2)^2 + dot(y2)^2);
    potential = m * g * y1 + m * g * y2;
} }

levels! { planet [jacobian, lanes] {
    param m: kg = 1.0, k: N*m^2 = 1.0;
    coord x: m, y: m;
    kinetic = 1/2 * m * (dot(x)^2 + dot(y)^2);
    potential = -k / hypot(x, y);
} }

levels! { heavy_top [jacobian, lanes, momentum_rates] {
    param i1: kg*m^2 = 1.0, i3: kg*m^2 = 0.5, mgl: N*m = 1.0;
    coord phi: rad, theta: rad, psi: rad;
    let axial = dot(psi) + dot(phi) * cos(theta);
    kinetic = 1/2 * i1 * (dot(theta)^2 + dot(phi)^2 * sin(theta)^2) + 1/2 * i3 * axial^2;
    potential = mgl * cos(theta);
} }

levels! { elastic_pendulum [jacobian, lanes, momentum_rates] {
    param m: kg = 1.0, l: m = 1.0, k: N/m = 1e6, c: N*s/m = 0.0, g: m/s^2 = 9.81;
    coord r: m, theta: rad;
    kinetic = 1/2 * m * (dot(r)^2 + r^2 * dot(theta)^2);
    potential = 1/2 * k * (r - l)^2 - m * g * r * cos(theta);
    dissipation = 1/2 * c * dot(r)^2;
} {
    reduce Rigid { freeze r = l; }
} }

levels! { free_body [jacobian] {
    quaternion r;
    kinetic = 1/2 * (r_wx^2 + 2 * r_wy^2 + 3 * r_wz^2);
} }

levels! { rods [jacobian, momentum_rates] {
    param m: kg = 1.0, l: m = 1.0, g: m/s^2 = 9.81;
    coord x1: m, y1: m, x2: m, y2: m;
    kinetic = 1/2 * m * (dot(x1)^2 + dot(y1)^2 + dot(x2)^2 + dot(y2)^2);
    potential = m * g * (y1 + y2);
    constraint upper = x1^2 + y1^2 - l^2;
    constraint lower = (x2 - x1)^2 + (y2 - y1)^2 - l^2;
} }

levels! { bouncing [jacobian] {
    param g = 9.81, e = 0.8;
    coord theta;
    kinetic = 1/2 * dot(theta)^2;
    potential = -g * cos(theta);
    event wall = theta, falling => { dot(theta) = -e * dot(theta); }
} }

/// A system whose motion is known.
struct Case {
    /// The kind of system, for the choice of a method.
    kind: &'static str,
    motion: &'static str,
    report: Report,
}

/// Compares all variants of a module from a start to an end: `with` names further groups of
/// methods, and `reduced` adds a reduced type.
macro_rules! case {
    (
        $kind:literal, $title:literal, $motion:literal, $reference:literal,
        $module:ident { $($field:ident: $value:expr),* }, $start:expr, $end:expr,
        with [$($group:ident),*] $(, sizes $sizes:expr)? $(, reduced $reduced:expr)?
    ) => {{
        macro_rules! system {
            ($level:ident) => { $module::$level { $($field: Number::from_f64($value),)* ..Default::default() } };
        }
        let (standard, fast): ($module::Standard<f64>, $module::Fast<f64>) = (system!(Standard), system!(Fast));
        let strict: $module::Strict<f64> = system!(Strict);
        let (short, portable): ($module::Standard<f32>, $module::Standard<Portable>) = (system!(Standard), system!(Standard));
        let wide: $module::Standard<Double> = system!(Standard);
        eprintln!("{}", $title);
        let trade = Trade::new($title, &standard, $start, $end).taylor("standard", &standard);
        $( let trade = trade.$group("standard", &standard); )*
        $( let rod = $module::Rigid::from(&standard); let trade = $reduced(trade, &rod); )?
        $( let trade = trade.sizes(&$sizes); )?
        let exact = entries::<Double>($reference, Numbers::Binary, $end);
        let report = trade
            .explicit("fast", &fast)
            .explicit("strict", &strict)
            .explicit("standard", &short)
            .explicit("standard", &portable)
            .taylor("standard", &wide)
            .reference(&exact)
            .run();
        Case { kind: $kind, motion: $motion, report }
    }};
}

/// Adds the elastic pendulum with a rod in place of the spring.
fn on_a_rod<'a>(trade: Trade<'a>, rod: &'a elastic_pendulum::Rigid<f64>) -> Trade<'a> {
    let angle = |y: &[f64]| [y[1], y[3]];
    let expand = |y: &[f64; 2]| {
        let state: [f64; 4] = rod.expand(elastic_pendulum::RigidState::from(*y)).into();
        state.to_vec()
    };
    trade.reduced("on a rod", rod, angle, expand)
}

fn cases() -> Vec<Case> {
    vec![
        case!(
            "smooth, chaotic", "Double pendulum",
            "m = l = 1, g = 9.81, released at θ = (2, 1.5), 10 s. Chaotic.",
            "double_pendulum", double_pendulum {}, [2.0, 1.5, 0.0, 0.0], 10.0,
            with [canonical, lanes, taylor_lanes]
        ),
        case!(
            "smooth, for a long time", "Kepler",
            "e = 0.6, a = μ = 1, Cartesian coordinates, 100 periods from the pericentre. Separable.",
            "planet", planet {}, [0.4, 0.0, 0.0, 2.0], 100.0 * TAU,
            with [separable, lanes, taylor_lanes]
        ),
        case!(
            "smooth, regular", "Heavy top",
            "I₁ = 1, I₃ = 0.5, m g l = 1, let go at θ = 0.5 with a spin of 10 rad/s, 10 s.",
            "heavy_top", heavy_top {}, [0.0, 0.5, 0.0, 0.0, 0.0, 10.0], 10.0,
            with [canonical, lanes, taylor_lanes]
        ),
        case!(
            "a body in space", "Free body",
            "A quaternion, I = (1, 2, 3), spinning about the unstable axis at 5 rad/s, 10 s.",
            "free_body", free_body {}, [1.0, 0.0, 0.0, 0.0, 0.01, 5.0, 0.01], 10.0,
            with []
        ),
        case!(
            "constrained",
            "Rods",
            "A double pendulum in Cartesian coordinates with two constraints, released from the horizontal,\n10 s. Chaotic.",
            "rods",
            rods {},
            [1.0, 0.0, 2.0, 0.0, 0.0, 0.0, 0.0, 0.0],
            10.0,
            with[canonical]
        ),
        case!(
            "with impacts", "Bouncing pendulum",
            "l = 1, g = 9.81, thrown back by a vertical wall with e = 0.8, released at θ = 2, 10 s.",
            "bouncing", bouncing {}, [2.0, 0.0], 10.0,
            with []
        ),
        case!(
            "stiff, not damped", "Elastic pendulum",
            "m = l = 1, g = 9.81, k = 10⁶, released at θ = 1 with the spring stretched by the load, 10 s.",
            "elastic_pendulum", elastic_pendulum {}, [1.0000053, 1.0, 0.0, 0.0], 10.0,
            with [canonical, lanes, taylor_lanes], reduced on_a_rod
        ),
        case!(
            "stiff, damped", "Damped pendulum",
            "The same with k = 10⁸ and a damper of c = 2 · 10⁴ beside the spring, released at θ = 1, r = 1,\n1 s.",
            "damped_pendulum", elastic_pendulum { k: 1e8, c: 2e4 }, [1.0, 1.0, 0.0, 0.0], 1.0,
            with [canonical], reduced on_a_rod
        ),
        case!(
            "units of extreme size", "Electron",
            "A classical electron about a proton in SI units: a mass of 1e-30, lengths of 1e-11, ten periods.\nErrors \
             are in units of 2.1e-11 m and 4.4e6 m/s.",
            "electron", planet { m: 9.1093837e-31, k: 2.3070776e-28 }, [2.1e-11, 0.0, 0.0, 4.4e6], 1.5e-15,
            with [separable, lanes, taylor_lanes], sizes [2.1e-11, 2.1e-11, 4.4e6, 4.4e6]
        ),
    ]
}

/// Errors in the columns of the first table.
const WANTED: [f64; 6] = [1e-2, 1e-6, 1e-10, 1e-12, 1e-14, 1e-20];

/// Returns the table of the fastest configuration for each kind of system and error.
fn which_to_take(cases: &[Case]) -> String {
    let columns = WANTED.map(|error| format!(" {error:.0e} |")).concat();
    let mut text = format!("| system |{columns}\n|---|{}\n", "---|".repeat(WANTED.len()));
    for Case { kind, report, .. } in cases {
        let link = report.file_name().replace('_', "-");
        text += &format!("| [{kind}](#{link}) |");
        text.extend(WANTED.map(|error| format!(" {} |", cell(report.fastest(error)))));
        let in_lanes = WANTED.map(|error| report.fastest_in_lanes(error));
        if in_lanes.iter().any(Option::is_some) {
            text += &format!("\n| {kind}, many in [lanes](ensembles.md) |");
            text.extend(in_lanes.map(|choice| format!(" {} |", cell(choice))));
        }
        text += "\n";
    }
    text
}

/// Returns a configuration in a few words, with its time.
fn cell(choice: Option<(&MeasuredRun, Measurement)>) -> String {
    let Some((row, Measurement { seconds, .. })) = choice else { return "–".to_string() };
    let numbers = if row.scalar == "f64" { String::new() } else { format!(", `{}`", row.scalar) };
    let variant = if row.variant == "standard" { String::new() } else { format!(", {}", row.variant) };
    format!("{}{numbers}{variant}: {} µs", row.method, microseconds(seconds))
}

/// Returns microseconds with two digits at least.
fn microseconds(seconds: f64) -> String {
    let time = 1e6 * seconds;
    if time < 10.0 { format!("{time:.1}") } else { format!("{time:.0}") }
}

fn main() -> Result<(), Box<dyn Error>> {
    let docs = std::env::args()
        .nth(1)
        .map_or_else(|| Path::new(env!("CARGO_MANIFEST_DIR")).join("docs"), PathBuf::from);
    let cases = cases();
    let mut text = format!(
        "# What every digit costs\n\nWritten by `cargo run --release --features trade --example trade` on {}, {},\n{} \
         Errors are the largest of any component at the end,\nagainst references of 30 digits (`tools/references.py`). \
         They do not depend on the load. Times do:\neach is the shortest of several runs on one core. The load may \
         decide near ties, and interrupt long\nruns, whose times are then too long.\n\n",
        today()?,
        machine(),
        load()
    );
    text += &format!(
        "## Which to take\n\nThe fastest configuration for each kind of system and error. A number type is `f64` and a \
         level of\naccuracy `standard` unless it is named. \"–\" means that no run in the time\nallowed reached the error.\n\n{}\n\
         [Choosing](choosing.md) explains the methods. The sections below have the line to write for each\nerror. For \
         a system of your own, `lagrange::trade` and [`lagrange trade`](command_line.md#choice-of-a-method)\nmeasure \
         it and print that line.\n",
        which_to_take(&cases)
    );
    for Case { motion, report, .. } in &cases {
        report.save(docs.join("trade"))?;
        let (title, file) = (report.title(), report.file_name());
        text += &format!("\n## {title}\n\n{motion}\n\n{}", report.recommendation());
        text +=
            &format!("\n![{title}: time against error](trade/{file}.svg)\n\n[All runs](trade/{file}.csv)\n");
        // The table is part of the page.
        fs::remove_file(docs.join("trade").join(format!("{file}.md")))?;
    }
    text += "\n## Where next\n\n[Choosing](choosing.md) from these tables; [drift](drift.md) over many steps; [comparison with other\ncrates](peers.md).\n";
    fs::write(docs.join("trade.md"), &text)?;
    println!("{text}");
    Ok(())
}

/// Returns the name of the processor, if the operating system reports it.
fn machine() -> String {
    let information = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let name = information.lines().find_map(|line| line.strip_prefix("model name")?.split_once(':'));
    name.map_or_else(|| std::env::consts::ARCH.to_string(), |(_, name)| name.trim().to_string())
}

/// Returns a sentence about the load of the machine, if the operating system reports it.
fn load() -> String {
    let information = fs::read_to_string("/proc/loadavg").unwrap_or_default();
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let load = information.split(' ').nth(2).map(|load| format!("with a load of {load} on {cores} cores."));
    load.unwrap_or_else(|| format!("on {cores} cores."))
}

/// Returns the Gregorian date by counting from 1 March 0000 in cycles of 400 years.
fn today() -> Result<String, Box<dyn Error>> {
    let days = SystemTime::now().duration_since(UNIX_EPOCH)?.as_secs() / 86_400 + 719_468;
    let (cycle, day) = (days / 146_097, days % 146_097);
    let year = (day - day / 1_460 + day / 36_524 - day / 146_096) / 365;
    let day = day - (365 * year + year / 4 - year / 100);
    let month = (5 * day + 2) / 153;
    let (day, month) = (day - (153 * month + 2) / 5 + 1, if month < 10 { month + 3 } else { month - 9 });
    let year = 400 * cycle + year + u64::from(month <= 2);
    Ok(format!("{year}-{month:02}-{day:02}"))
}
