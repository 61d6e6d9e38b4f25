//! The price of every digit: methods × numbers × accuracy levels on four systems with known
//! trajectories.
//!
//!     cargo run --release --features trade --example trade
//!
//! rewrites `docs/trade.md` and the tables and diagrams in `docs/trade/`. If a directory is given,
//! it writes there instead. Look for the fastest method for each accuracy, and for upward bends in
//! the curves, where rounding begins.

#[path = "../tests/references/mod.rs"]
mod references;

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};
use std::time::{SystemTime, UNIX_EPOCH};

use lagrange::trade::{Report, Trade};
use references::{Numbers, state};

/// A declaration at each level of accuracy, and in single precision.
macro_rules! variants {
    ($module:ident { $($body:tt)* } $({ $($reduced:tt)* })?) => {
        mod $module {
            lagrange::system! { pub(crate) struct Standard; $($body)* emit { jacobian, momentum_rates } $($($reduced)*)? }
            lagrange::system! { #[accuracy(fast)] pub(crate) struct Fast; $($body)* emit { jacobian } }
            lagrange::system! { #[accuracy(strict)] pub(crate) struct Strict; $($body)* emit { jacobian } }
            lagrange::system! { #[scalar(f32)] pub(crate) struct Short; $($body)* emit { jacobian } }
        }
    };
}

variants! { double_pendulum {
    param m: kg = 1.0, l: m = 1.0, g: m/s^2 = 9.81;
    coord theta1: rad, theta2: rad;
    let (x1, y1) = (l * sin(theta1), -l * cos(theta1));
    let (x2, y2) = (x1 + l * sin(theta2), y1 - l * cos(theta2));
    kinetic = 1/2 * m * (dot(x1)^2 + dot(y1)^2) + 1/2 * m * (dot(x2)^2 + dot(y2)^2);
    potential = m * g * y1 + m * g * y2;
} }

variants! { kepler {
    const m: kg = 1;
    param mu: m^3/s^2 = 1.0;
    coord r: m, phi: rad;
    kinetic = 1/2 * m * (dot(r)^2 + r^2 * dot(phi)^2);
    potential = -mu * m / r;
} }

variants! { heavy_top {
    param i1: kg*m^2 = 1.0, i3: kg*m^2 = 0.5, mgl: N*m = 1.0;
    coord phi: rad, theta: rad, psi: rad;
    let axial = dot(psi) + dot(phi) * cos(theta);
    kinetic = 1/2 * i1 * (dot(theta)^2 + dot(phi)^2 * sin(theta)^2) + 1/2 * i3 * axial^2;
    potential = mgl * cos(theta);
} }

variants! { elastic_pendulum {
    param m: kg = 1.0, l: m = 1.0, k: N/m = 1000000.0, g: m/s^2 = 9.81;
    coord r: m, theta: rad;
    kinetic = 1/2 * m * (dot(r)^2 + r^2 * dot(theta)^2);
    potential = 1/2 * k * (r - l)^2 - m * g * r * cos(theta);
} {
    reduce Rigid { freeze r = l; }
} }

/// Compares all variants of a module from a start to an end.
macro_rules! trade {
    ($title:literal, $module:ident, $start:expr, $end:expr $(, $more:expr)?) => {{
        let (standard, fast) = ($module::Standard::default(), $module::Fast::default());
        let (strict, short) = ($module::Strict::default(), $module::Short::default());
        eprintln!("{}", $title);
        let trade = Trade::new($title, &standard, $start, $end);
        $( let trade = $more(trade); )?
        trade
            .canonical("standard", &standard)
            .variant("fast", &fast)
            .variant("strict", &strict)
            .variant("standard", &short)
            .reference(&state::<{ $start.len() }>(stringify!($module), Numbers::Binary, $end))
            .run()
    }};
}

/// Adds the elastic pendulum with a rod in place of the spring.
fn on_a_rod<'a>(trade: Trade<'a>, rod: &'a elastic_pendulum::Rigid) -> Trade<'a> {
    let angle = |y: &[f64]| [y[1], y[3]];
    let expand = |y: &[f64; 2]| {
        let state: [f64; 4] = rod.expand(elastic_pendulum::RigidState::from(*y)).into();
        state.to_vec()
    };
    trade.reduced("on a rod", rod, angle, expand)
}

fn reports() -> Vec<(Report, &'static str)> {
    const TOP: [f64; 6] = [0.0, 0.5, 0.0, 0.0, 0.0, 10.0];
    let rod = elastic_pendulum::Rigid::from(&elastic_pendulum::Standard::default());
    const HUNDRED_PERIODS: f64 = 100.0 * std::f64::consts::TAU;
    vec![
        (
            trade!("Double pendulum", double_pendulum, [2.0, 1.5, 0.0, 0.0], 10.0),
            "m = l = 1, g = 9.81, released at θ = (2, 1.5), 10 s. Chaotic.",
        ),
        (
            trade!("Kepler", kepler, [0.4, 0.0, 0.0, 5.0], HUNDRED_PERIODS),
            "e = 0.6, a = μ = 1, polar coordinates, 100 periods from the pericentre.",
        ),
        (
            trade!("Heavy top", heavy_top, TOP, 10.0),
            "I₁ = 1, I₃ = 0.5, m g l = 1, let go at θ = 0.5 with a spin of 10 rad/s, 10 s.",
        ),
        (
            trade!("Elastic pendulum", elastic_pendulum, [1.0000053, 1.0, 0.0, 0.0], 10.0, |trade| on_a_rod(
                trade, &rod
            )),
            "m = l = 1, g = 9.81, k = 10⁶, released at θ = 1 with the spring stretched by the load, 10 s. Stiff, not damped.",
        ),
    ]
}

fn main() -> Result<(), Box<dyn Error>> {
    let docs = std::env::args()
        .nth(1)
        .map_or_else(|| Path::new(env!("CARGO_MANIFEST_DIR")).join("docs"), PathBuf::from);
    let mut text = format!(
        "# What every digit costs\n\nWritten by `cargo run --release --features trade --example trade` on {}, {}. Errors are the \
         largest of any component at the end, against references of 30 digits (`tools/references.py`). Times are the \
         shortest of several runs on one core.\n",
        today()?,
        machine()
    );
    for (report, motion) in reports() {
        report.save(docs.join("trade"))?;
        let (title, file) = (report.title(), report.file_name());
        text += &format!("\n## {title}\n\n{motion}\n\n{}", report.recommendation());
        text +=
            &format!("\n![{title}: time against error](trade/{file}.svg)\n\n[All runs](trade/{file}.csv)\n");
        // The table is part of the page.
        fs::remove_file(docs.join("trade").join(format!("{file}.md")))?;
    }
    text += "\n## Where next\n\n[Choosing](choosing.md) from these tables; [comparison with other crates](peers.md).\n";
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
