//! Stiff motions by `Radau5`: a row for each, with its error, seconds and evaluations.
//!
//! `tools/stiff_peers.py` alternates it with other tools.

use std::time::Instant;

use lagrange::integrate::{Method, Radau5, Stepper};
use lagrange::system::OdeSystem;

lagrange::system! {
    /// A point mass on a spring with a damper.
    struct ElasticPendulum;

    const k = 1e8, c = 2e4, g = 9.81;
    coord r, theta;
    kinetic = 1/2 * (dot(r)^2 + r^2 * dot(theta)^2);
    potential = 1/2 * k * (r - 1)^2 - g * r * cos(theta);
    dissipation = 1/2 * c * dot(r)^2;
    emit { jacobian }
}

lagrange::system! {
    /// Van der Pol's oscillator.
    struct VanDerPol;

    const epsilon = 1e-6;
    coord x;
    kinetic = 1/2 * dot(x)^2;
    potential = 1/2 * x^2 / epsilon;
    force x = (1 - x^2) * dot(x) / epsilon;
    emit { jacobian }
}

lagrange::system! {
    /// A ball that meets the ground with Hunt and Crossley's force.
    struct Bounce;

    const k = 1e8, c = 0.2, g = 9.81;
    coord x;
    kinetic = 1/2 * dot(x)^2;
    potential = g * x;
    force x = k * max(-x, 0)^(3/2) * (1 - 3/2 * c * dot(x));
    emit { jacobian }
}

lagrange::system! {
    /// A block pulled by a spring over ground with LuGre friction.
    struct StickSlip;

    const stiffness = 1e5, pull = 0.1;
    coord x;
    state z;
    let rate = dot(x) - stiffness * abs(dot(x)) / (1 + 1/2 * exp(-(dot(x) / 1e-3)^2)) * z;
    dot(z) = rate;
    kinetic = 1/2 * dot(x)^2;
    force x = 2 * (pull * t - x) - (stiffness * z + sqrt(stiffness) * rate + 2/5 * dot(x));
    emit { jacobian }
}

/// A motion with its final state.
struct Case<Y, const N: usize> {
    name: &'static str,
    start: Y,
    end: f64,
    sizes: [f64; N],
    reference: [f64; N],
}

const REPEATS: usize = 20;

/// Returns the shortest time of a run, and its result.
fn shortest<T>(run: impl Fn() -> T) -> (T, f64) {
    let timed = || {
        let began = Instant::now();
        (run(), began.elapsed().as_secs_f64())
    };
    (1..REPEATS).fold(timed(), |best, _| {
        let next = timed();
        if next.1 < best.1 { next } else { best }
    })
}

fn compare<M, const N: usize>(system: &M, case: &Case<M::State, N>, compared: impl Fn(&M::State) -> [f64; N])
where
    M: OdeSystem<Scalar = f64>,
{
    let Case { name, start, end, sizes, reference } = case;
    let smallest = sizes.iter().fold(1.0_f64, |least, size| least.min(*size));
    for (label, tolerance) in [("1e-4", 1e-4), ("1e-6", 1e-6), ("1e-9", 1e-9)] {
        let method = Radau5 { absolute: smallest * tolerance, ..Radau5::tolerance(tolerance) };
        let ((y, work), seconds) = shortest(|| {
            let mut stepper = method.start(system, 0.0, start, *end).expect("starts");
            while stepper.time() < *end {
                stepper.step(system, *end).expect("goes on");
            }
            (*stepper.state(), stepper.work())
        });
        let errors = compared(&y).into_iter().zip(reference).zip(sizes);
        let error = errors.fold(0.0_f64, |most, ((found, expected), size)| {
            most.max((found - expected).abs() / (size + expected.abs()))
        });
        let [f, j, lu] = [work.evaluations, work.jacobians, work.factorisations];
        println!("Radau5,{name},{label},{error:e},{seconds:e},{f},{j},{lu}");
    }
}

fn main() {
    let reference = [
        1.000_000_120_643_636_4,
        0.692_166_962_627_622_7,
        -3.986_440_483_025_633e-7,
        2.122_266_750_750_246_6,
    ];
    let case =
        Case { name: "elastic_pendulum", start: [1.0, 1.0, 0.0, 0.0], end: 4.0, sizes: [1.0; 4], reference };
    compare(&ElasticPendulum, &case, |y| *y);
    let reference = [1.706_167_732_170_483, -0.892_809_701_024_797_5];
    let case = Case { name: "van_der_pol", start: [2.0, 0.0], end: 2.0, sizes: [1.0; 2], reference };
    compare(&VanDerPol, &case, |y| *y);
    let reference = [0.149_254_668_919_120_8, -0.833_435_002_173_662_5];
    let case = Case { name: "bounce", start: [0.5, 0.0], end: 0.6, sizes: [1e-3, 1.0], reference };
    compare(&Bounce::default(), &case, |y| *y);
    let reference = [0.727_403_587_676_318_6, 1.453_842_909_323_096e-5, 6.710_689_831_740_682e-5];
    let case = Case { name: "stick_slip", start: [0.0; 3], end: 20.0, sizes: [1.0, 1e-5, 1e-2], reference };
    compare(&StickSlip::default(), &case, |[x, z, v]| [2.0 - x, *z, *v]);
}
