//! Runs with default settings where neighbouring times are far apart: as accurate as times allow,
//! or refused with an error.

use lagrange::Simulate;
use lagrange::event::Direction;
use lagrange::integrate::{RungeKutta4, Verner98};

lagrange::system! {
    #[derive(Clone, Debug)]
    struct Bounce<S>;

    coord y;
    kinetic = 1/2 * dot(y)^2;
    potential = 9.81 * y;
    event floor = y, falling => { dot(y) = -dot(y); }
}

lagrange::system! {
    #[derive(Clone, Debug)]
    struct Closing<S>;

    param e = 1;
    coord y;
    kinetic = kinetic_energy(1, dot(y));
    potential = 9.81 * y;
    event floor = y, falling => impact(e);
}

lagrange::system! {
    #[derive(Clone, Debug)]
    struct Valley<S>;

    coord y;
    kinetic = 1/2 * dot(y)^2;
    potential = 9.81 * abs(y);
}

lagrange::system! {
    #[derive(Clone, Debug)]
    struct Free<S>;

    coord y;
    kinetic = 1/2 * dot(y)^2;
    potential = 9.81 * y;
}

/// Checks a run of three seconds, in which bodies fall by one metre, from each power of ten on. Its
/// errors correspond to a few roundings of time, or it is refused. Nothing is refused up to
/// `finest`, and everything from `coarsest` on.
macro_rules! check_runs {
    ($($system:ident<$scalar:ty>, $method:expr, $finest:expr, $coarsest:expr;)*) => {
        $(
            for power in 0..=$coarsest + 1 {
                let start = (10.0 as $scalar).powi(power);
                let system = $system::<$scalar>::default();
                let run = system.simulate([1.0, 0.0]).from(start).until(start + 3.0).method($method).run();
                let what = format!("{} {} from 1e{power}", stringify!($system), stringify!($scalar));
                match run {
                    Ok(run) => {
                        let [y, v] = run.last();
                        let energy = y.abs() + v * v / (2.0 * 9.81);
                        let tolerance = 1e-3 + 100.0 * <$scalar>::EPSILON * start;
                        assert!((energy - 1.0).abs() <= tolerance, "{what}: {:?}, energy {energy}", run.last());
                        assert!(power < $coarsest || run.end_time() == start, "{what} is not refused");
                    }
                    Err(error) => {
                        assert!(power > $finest, "{what}: {error}");
                        let (words, last) = (error.to_string(), error.trajectory.last());
                        assert!(words.contains("measure time from near"), "{what}: {words}");
                        assert!(last[0].is_finite() && error.time() < start + 3.0, "{what}: {last:?}");
                    }
                }
            }
        )*
    };
}

#[test]
fn runs_are_refused_where_times_are_too_far_apart_for_their_events() {
    let (long, short) = (Verner98::tolerance(1e-8), Verner98::tolerance(1e-5));
    check_runs! {
        Bounce<f64>, long, 13, 15;
        Closing<f64>, long, 13, 15;
        Valley<f64>, long, 12, 15;
        Bounce<f64>, RungeKutta4 { step: 0.125 }, 12, 15;
        Valley<f64>, RungeKutta4 { step: 0.125 }, 12, 15;
        Bounce<f32>, short, 3, 6;
        Closing<f32>, short, 3, 6;
        Valley<f32>, short, 3, 6;
    }
}

/// A jump is located between two adjacent times, however far apart they are.
#[test]
fn jumps_are_located_between_two_times() {
    for start in [0.0, 1e10, 1e13] {
        let free = Free::<f64>::default();
        let run = free.simulate([1.0, 0.0]).from(start).until(start + 2.0);
        let run = run.event("jump", Direction::Falling, |_, _, y| if y[0] > 0.0 { 1.0 } else { -1.0 }).run();
        let run = run.unwrap_or_else(|error| panic!("from {start}: {error}"));
        let time = run.events()[0].time - start;
        assert!((time - (2.0_f64 / 9.81).sqrt()).abs() < 1e-9 + 4.0 * f64::EPSILON * start, "{time}");
    }
}
