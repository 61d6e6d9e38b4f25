//! The drift of energy and angular momentum over many steps, beside Brouwer's law.
//!
//! An orbit conserves both, so any drift is due to the method. Rounding cannot be avoided. If it
//! has no bias, the error of a conserved quantity is a random walk. It grows with the square root
//! of the number of steps. Look for methods that follow this law, and for those whose drift grows
//! in proportion to the steps.
//!
//! Source: Brouwer, *On the accumulation of errors in numerical integration*, The Astronomical
//! Journal 46 (1937), 149–153.
//!
//!     cargo run --release --features plot --example energy_drift -- docs
//!
//! takes 10⁸ steps, and writes `drift.md` and a diagram to a directory. Without an argument, it
//! takes a few thousand steps.

use std::error::Error;
use std::f64::consts::TAU;
use std::path::Path;
use std::time::Instant;

use lagrange::Number;
use lagrange::integrate::{
    BlanesMoan4, GaussLegendre6, Method, RungeKutta4, Stepper, StormerVerlet, Taylor, Verner98,
};
use lagrange::scalar::Scalar;
use lagrange::system::OdeSystem;

lagrange::system! {
    /// A planet in the plane. Its orbit has the semi-major axis 1 and the period 2π.
    #[derive(Clone, Debug)]
    pub struct Planet<S>;

    param m: kg = 1, mu: m^3/s^2 = 1;
    coord x: m, y: m;
    kinetic = 1/2 * m * (dot(x)^2 + dot(y)^2);
    potential = -m * mu / hypot(x, y);
    emit { taylor, momentum_rates }
}

const ECCENTRICITY: f64 = 0.2;
/// Samples for each power of ten of the number of steps.
const SAMPLES: f64 = 32.0;
/// Largest mean error of a step, in rounding errors.
const MAX_BIAS: f64 = 0.005;
/// Steps between new starts, and a time beyond them.
const STEPS_AT_ONCE: u64 = 20_000;
const FAR: f64 = 5e4;
/// Steps of the page, and of a short run.
const STEPS: u64 = 100_000_000;
const FEW_STEPS: u64 = 3_000;

/// The largest errors so far, after a number of steps.
#[derive(Clone, Copy)]
struct Sample {
    steps: u64,
    energy: f64,
    momentum: f64,
}

/// Errors of a method, relative to the initial values.
struct Drift {
    method: String,
    /// Half of the distance between 1 and the next number.
    rounding: f64,
    /// Steps in a period.
    density: f64,
    samples: Vec<Sample>,
    nanoseconds: f64,
}

impl Drift {
    /// Returns the sample after the largest number of steps that does not exceed a limit.
    fn after(&self, steps: u64) -> Option<&Sample> {
        self.samples.iter().rev().find(|sample| sample.steps <= steps)
    }

    fn end(&self) -> Sample {
        *self.samples.last().expect("a step was taken")
    }
}

/// Returns the expected size of a sum of rounding errors without bias, one for each step.
fn brouwer(rounding: f64, steps: u64) -> f64 {
    rounding * (steps as f64).sqrt()
}

fn main() -> Result<(), Box<dyn Error>> {
    let directory = std::env::args().nth(1);
    let steps = if directory.is_some() { STEPS } else { FEW_STEPS };
    let drifts = drifts(steps)?;
    let table = table(&drifts, steps);
    println!("{table}");
    check(&drifts, steps);
    if let Some(directory) = directory {
        draw(&drifts, &Path::new(&directory).join("drift.svg"))?;
        std::fs::write(Path::new(&directory).join("drift.md"), page(&table))?;
    }
    Ok(())
}

/// Measures all methods. Equal steps are a five-hundredth of a period.
fn drifts(steps: u64) -> Result<Vec<Drift>, Box<dyn Error>> {
    let step = TAU / 500.0;
    let single = step as f32;
    let (wide, narrow): (Planet<f64>, Planet<f32>) = (Planet::default(), Planet::default());
    Ok(vec![
        drift("", &wide, &StormerVerlet { step }, steps)?,
        drift(", f32", &narrow, &StormerVerlet { step: single }, steps)?,
        drift("", &wide, &BlanesMoan4 { step }, steps)?,
        drift(", f32", &narrow, &BlanesMoan4 { step: single }, steps)?,
        drift("", &wide, &GaussLegendre6 { step }, steps)?,
        drift("", &wide, &RungeKutta4 { step }, steps)?,
        drift(", 1e-12", &wide, &Verner98::tolerance(1e-12), steps)?,
        drift(", 1e-15", &wide, &Verner98::tolerance(1e-15), steps)?,
        drift(", 1e-12", &wide, &Taylor::tolerance(1e-12), steps)?,
        drift(", 1e-16", &wide, &Taylor::tolerance(1e-16), steps)?,
    ])
}

/// Takes steps from the pericentre. Time starts again after a number of steps, so that it remains
/// exact enough in `f32`.
fn drift<M, N>(note: &str, planet: &M, method: &N, most: u64) -> Result<Drift, Box<dyn Error>>
where
    M: OdeSystem<State = [<M as OdeSystem>::Scalar; 4], Scalar: Into<f64>>,
    N: Method<M>,
{
    let number = M::Scalar::from_f64;
    let speed = ((1.0 + ECCENTRICITY) / (1.0 - ECCENTRICITY)).sqrt();
    let mut state = [1.0 - ECCENTRICITY, 0.0, 0.0, speed].map(number);
    let [energy, momentum] = conserved(state);
    let mut largest = Sample { steps: 0, energy: 0.0, momentum: 0.0 };
    let (mut samples, mut periods, mut steps) = (Vec::new(), 0.0, 0);
    let begin = Instant::now();
    while steps < most {
        let mut stepper =
            method.start(planet, number(0.0), &state, number(FAR)).map_err(|error| error.to_string())?;
        for _ in 0..STEPS_AT_ONCE.min(most - steps) {
            stepper.step(planet, number(FAR)).map_err(|error| error.to_string())?;
            steps += 1;
            if steps == most || steps >= next_sample(largest.steps) {
                let [now, turned] = conserved(*stepper.state());
                let [energy, momentum] = [now / energy - 1.0, turned / momentum - 1.0].map(f64::abs);
                largest = Sample {
                    steps,
                    energy: largest.energy.max(energy),
                    momentum: largest.momentum.max(momentum),
                };
                samples.push(largest);
            }
        }
        state = *stepper.state();
        periods += stepper.time().into() / TAU;
    }
    Ok(Drift {
        method: format!("{}{note}", method.name()),
        rounding: M::Scalar::epsilon().into() / 2.0,
        density: most as f64 / periods,
        samples,
        nanoseconds: 1e9 * begin.elapsed().as_secs_f64() / most as f64,
    })
}

/// Returns the number of steps at which the next sample is due.
fn next_sample(steps: u64) -> u64 {
    let grown = (steps as f64 * 10.0_f64.powf(1.0 / SAMPLES)) as u64;
    grown.max(steps + 1)
}

/// Returns energy and angular momentum in double precision.
fn conserved<S: Into<f64>>(state: [S; 4]) -> [f64; 2] {
    let planet = Planet::<f64>::default();
    let [x, y, vx, vy] = state.map(Into::into);
    [planet.energy(0.0, &[x, y], &[vx, vy]), x * vy - y * vx]
}

/// Returns a table of the errors after a hundred, ten thousand, … steps.
fn table(drifts: &[Drift], steps: u64) -> String {
    let columns: Vec<u64> =
        (1..=5).map(|power| 100_u64.pow(power)).filter(|&column| column <= steps).collect();
    let heads: String = columns.iter().map(|&column| format!(" {:.0e} |", column as f64)).collect();
    let head = |name: &str| {
        let rule = "---|".repeat(columns.len() + 3);
        format!("| {name} | ns per step | steps in a period |{heads}\n|{rule}\n")
    };
    let row = |drift: &Drift, error: fn(&Sample) -> f64| {
        let cell = |&column: &u64| match drift.after(column) {
            Some(sample) => format!(" {:.1e} |", error(sample)),
            None => " – |".to_string(),
        };
        let cells: String = columns.iter().map(cell).collect();
        format!("| {} | {:.0} | {:.0} |{cells}\n", drift.method, drift.nanoseconds, drift.density)
    };
    let law = |number: &str, rounding: f64| {
        let cells = columns.iter().map(|&column| format!(" {:.1e} |", brouwer(rounding, column)));
        format!("| Brouwer's law{number} | – | – |{}\n", cells.collect::<String>())
    };
    let laws = law("", f64::EPSILON / 2.0) + &law(", f32", f64::from(f32::EPSILON) / 2.0);
    let rows = |error: fn(&Sample) -> f64| drifts.iter().map(|drift| row(drift, error)).collect::<String>();
    let (energy, momentum) = (rows(|sample| sample.energy), rows(|sample| sample.momentum));
    format!("{}{energy}{laws}\n{}{momentum}{laws}", head("energy"), head("angular momentum"))
}

/// Compares errors with the law. Gauss methods and series at their limit have only rounding errors,
/// with a small bias. Splitting preserves the angular momentum. A bias shows after many steps only.
fn check(drifts: &[Drift], steps: u64) {
    for drift in drifts {
        let (end, most) =
            (drift.end(), 8.0 * brouwer(drift.rounding, steps) + MAX_BIAS * drift.rounding * steps as f64);
        let is_of_rounding = ["Gauss–Legendre 6", "Taylor series, 1e-16"].contains(&&*drift.method);
        let is_splitting = ["Störmer", "Blanes"].iter().any(|name| drift.method.starts_with(name));
        assert!(!is_of_rounding || end.energy < most, "{}: {:.1e} of {most:.1e}", drift.method, end.energy);
        let follows = !is_of_rounding && !is_splitting || end.momentum < most;
        assert!(follows, "{}: {:.1e} of {most:.1e}", drift.method, end.momentum);
    }
}

fn page(table: &str) -> String {
    format!(
        "# Drift over many steps\n\n\
         Written by `cargo run --release --features plot --example energy_drift -- docs`.\n\n\
         A planet moves on an orbit of eccentricity {ECCENTRICITY}. It conserves energy and angular momentum. The\n\
         tables show the largest relative errors up to a number of steps, of 32 samples for each power of ten.\n\
         Rounding without bias adds up to a random walk, whose size is a rounding error times √N after N steps. This is *Brouwer's\n\
         law* (1937).\n\n{table}\n\
         ![Drift of energy and angular momentum over 10⁸ steps](drift.svg)\n\n\
         - **Symplectic methods** have no drift of their own. Their error of the energy oscillates, by the square of\n  \
         the step for `StormerVerlet`, and below rounding for `GaussLegendre6`. Since states are summed with\n  \
         compensation, rounding in `f64` stays below the law. For `GaussLegendre6`, it grows in proportion\n  \
         after a million steps, and reaches the law at 1e8.\n\
         - **`Taylor`** at its tightest tolerance follows the law over a million steps, each of them as long\n  \
         as fifty of the others. Beyond, a bias of about a thousandth of a rounding error adds up. At 1e-12,\n  \
         the remainders of its series do.\n\
         - **`Verner98` and `RungeKutta4`** drift in proportion to the number of steps. In `Verner98`, the\n  \
         rounding of its coefficients remains.\n\n\
         ## Where next\n\n[The price of a digit](trade.md) over short times; [choosing](choosing.md) a method.\n"
    )
}

#[cfg(feature = "plot")]
fn draw(drifts: &[Drift], path: &Path) -> Result<(), Box<dyn Error>> {
    use lagrange::plot::{Curve, Figure, Panel, Scale};

    // Zero cannot be shown on a logarithmic axis.
    let curve = |drift: &Drift, error: fn(&Sample) -> f64| Curve {
        name: drift.method.as_str().into(),
        points: drift.samples.iter().map(|it| (it.steps as f64, error(it))).filter(|it| it.1 > 0.0).collect(),
    };
    let panel = |quantity: &str, error: fn(&Sample) -> f64| {
        let steps = drifts.iter().flat_map(|drift| &drift.samples).map(|sample| sample.steps);
        let law = |steps: u64| (steps as f64, brouwer(f64::EPSILON / 2.0, steps));
        let law =
            Curve { name: "Brouwer's law".into(), points: [1, steps.max().unwrap_or(1)].map(law).into() };
        Panel {
            x: "steps".into(),
            y: quantity.into(),
            x_scale: Scale::Logarithmic,
            y_scale: Scale::Logarithmic,
            has_room: true,
            curves: drifts.iter().map(|drift| curve(drift, error)).chain([law]).collect(),
            ..Panel::default()
        }
    };
    let panels = vec![
        panel("error of the energy", |sample| sample.energy),
        panel("error of the momentum", |sample| sample.momentum),
    ];
    Ok(Figure { panels, columns: 1, size: (860, 420) }.save(path)?)
}

#[cfg(not(feature = "plot"))]
fn draw(_drifts: &[Drift], _path: &Path) -> Result<(), Box<dyn Error>> {
    Err("the diagram needs `--features plot`".into())
}
