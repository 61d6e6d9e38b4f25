//! Motions in lanes compared with single runs.

use core::mem::discriminant;
use std::string::ToString;
use std::vec::Vec;

mod bits;
mod domains;
mod samples;

use super::refill::{EndsOf, MotionStart, Queue, refilled};
use crate::ensemble::progress::Counter;
use crate::ensemble::{Ends, Ensemble, Ensembles, Moments};
use crate::integrate::{
    BlanesMoan4, GaussLegendre4, LanesMethod, Method, RungeKutta4, StormerVerlet, Taylor, Verner98,
};
use crate::scalar::{Lanes, Number, Scalar};
use crate::simulate::Grid;
use crate::system::{
    Equations, LanesSystem, LanesVisitor, MechanicalSystem, OdeSystem, SeparableSystem, SideBySide,
    StepFailure, TaylorSystem, Unnamed,
};

/// Declares a system of one or two degrees of freedom whose formulas are generic over the number
/// type.
macro_rules! system {
    ($name:ident { $($parameter:ident = $value:expr),* }, $freedoms:literal, $names:expr, $rhs:expr $(, $series:ident)?) => {
        #[derive(Clone, Copy, Debug)]
        struct $name<S> {
            $($parameter: S),*
        }

        impl<S: Number> Default for $name<S> {
            fn default() -> Self {
                $name { $($parameter: S::from_f64($value)),* }
            }
        }

        impl<S: Number> Equations<S> for $name<S> {
            type State = [S; 2 * $freedoms];
            type Series = ();

            #[inline(always)]
            fn rhs(&self, t: S, y: &[S; 2 * $freedoms]) -> [S; 2 * $freedoms] {
                $rhs(self, t, y)
            }

            $(#[inline(always)]
            fn expand<const FUSED: bool>(&self, t: S, y: &Self::State, (): &mut (), coefficients: &mut [Self::State]) {
                $series(self, t, y, coefficients);
            })?
        }

        impl<S: Scalar> OdeSystem for $name<S> {
            type Scalar = S;
            type State = [S; 2 * $freedoms];

            fn rhs(&self, t: S, y: &[S; 2 * $freedoms]) -> [S; 2 * $freedoms] {
                Equations::rhs(self, t, y)
            }

            fn with_lanes<V: LanesVisitor<Self>>(visitor: V) -> Result<V::Output, V> {
                Ok(visitor.visit())
            }
        }

        impl<S: Scalar> MechanicalSystem for $name<S> {
            type Coordinates = [S; $freedoms];
            type Velocities = [S; $freedoms];
            type Columns<C> = Unnamed<C>;
            const COORDINATES: &'static [&'static str] = &$names;

            fn acceleration(&self, t: S, q: &[S; $freedoms], v: &[S; $freedoms]) -> [S; $freedoms] {
                let rates = Equations::rhs(self, t, &core::array::from_fn(|i| if i < $freedoms { q[i] } else { v[i - $freedoms] }));
                core::array::from_fn(|i| rates[$freedoms + i])
            }

            fn position_rates(&self, _t: S, _q: &[S; $freedoms], v: &[S; $freedoms]) -> [S; $freedoms] {
                *v
            }
        }

        impl<T: Scalar> LanesSystem for $name<T> {
            type Lanes<S: Number> = $name<S>;

            fn lanes<S: Number>(&self, splat: impl Fn(T) -> S) -> $name<S> {
                $name { $($parameter: splat(self.$parameter)),* }
            }

            fn set_lane<S: SideBySide<Element = T>>(&self, lanes: &mut $name<S>, lane: usize) {
                $(lanes.$parameter.set_lane(lane, self.$parameter);)*
            }
        }
    };
}

system!(DoublePendulum { ratio = 0.5, gravity = 9.81 }, 2, ["a", "b"], double_pendulum);
system!(Root { end = 1.0 }, 1, ["x"], root);
system!(Spring { stiffness = 1.0 }, 1, ["x"], spring, series_of_spring);

system!(Pulse { time = 1.0 }, 1, ["x"], pulse);
system!(Servo { damping = 1.0 }, 1, ["x"], servo);

impl<S: Scalar> SeparableSystem for Spring<S> {}

impl<S: Scalar> TaylorSystem for Spring<S> {
    type Series = ();
    const IN_LANES: bool = true;

    fn series() {}

    fn expand<const FUSED: bool>(&self, t: S, y: &[S; 2], series: &mut (), coefficients: &mut [[S; 2]]) {
        Equations::expand::<FUSED>(self, t, y, series, coefficients);
    }
}

/// Returns accelerations of two masses on rods of unit length; `ratio` is the second mass as a
/// fraction of both.
#[inline(always)]
fn double_pendulum<S: Number>(system: &DoublePendulum<S>, _t: S, [a, b, v, w]: &[S; 4]) -> [S; 4] {
    let (sine, cosine) = (*a - *b).sin_cos();
    let (of_first, of_second) = (system.gravity * a.sin(), system.gravity * b.sin());
    let part = system.ratio;
    let determinant = (S::ONE - part) + part * sine * sine;
    let first = -(part * sine * *w * *w) - of_first;
    let second = sine * *v * *v - of_second;
    [*v, *w, (first - part * cosine * second) / determinant, (second - cosine * first) / determinant]
}

/// Returns ẍ = √(end − t), which is undefined after the end.
#[inline(always)]
fn root<S: Number>(system: &Root<S>, t: S, [_, v]: &[S; 2]) -> [S; 2] {
    [*v, (system.end - t).sqrt()]
}

/// Returns ẍ = −k x.
#[inline(always)]
fn spring<S: Number>(system: &Spring<S>, _t: S, [x, v]: &[S; 2]) -> [S; 2] {
    [*v, -(system.stiffness * *x)]
}

/// Computes coefficients of the motion of a spring: of order k + 1, they are the rates at those of
/// order k, divided by k + 1.
#[inline(always)]
fn series_of_spring<S: Number>(system: &Spring<S>, t: S, y: &[S; 2], coefficients: &mut [[S; 2]]) {
    let mut last = *y;
    for (k, coefficients) in coefficients.iter_mut().enumerate() {
        last = spring(system, t, &last).map(|rate| rate / S::from_f64((k + 1) as f64));
        *coefficients = last;
    }
}

/// Returns ẍ = exp(−400 (t − time)²), which lasts for about a tenth of a second.
#[inline(always)]
fn pulse<S: Number>(system: &Pulse<S>, t: S, [_, v]: &[S; 2]) -> [S; 2] {
    let past = S::from_f64(20.0) * (t - system.time);
    [*v, (-(past * past)).exp()]
}

/// Returns ẍ = sin t − x − c ẋ.
#[inline(always)]
fn servo<S: Number>(system: &Servo<S>, t: S, [x, v]: &[S; 2]) -> [S; 2] {
    [*v, t.sin() - *x - system.damping * *v]
}

/// Returns starts and parameters of double pendulums.
fn starts(number: usize) -> Vec<MotionStart<DoublePendulum<f64>>> {
    let start = |index: usize| {
        let system = DoublePendulum { ratio: 0.3 + 0.4 * index as f64 / number as f64, gravity: 9.81 };
        MotionStart {
            system: Some(system),
            state: [2.0 - 0.02 * index as f64, 1.0, 0.0, 0.01 * index as f64],
        }
    };
    (0..number).map(start).collect()
}

/// Computes motions in lanes of the type S.
fn arrivals<M, S, const SAMPLED: bool>(
    starts: &[MotionStart<M>],
    method: impl LanesMethod<M::Scalar>,
    end: M::Scalar,
    grid: Option<Grid<M::Scalar>>,
) -> EndsOf<M>
where
    M: MechanicalSystem + LanesSystem + Default,
    S: SideBySide<Element = <M as OdeSystem>::Scalar>,
{
    let (counter, motions) = (Counter::new(None, starts.len()), (0..starts.len()).collect::<Vec<_>>());
    let (system, motions, counter) = (&M::default(), &motions[..], &counter);
    let (from, max_steps) = (M::Scalar::ZERO, None);
    let queue = Queue::<M, SAMPLED> { system, starts, motions, from, end, grid, max_steps, counter };
    refilled::<M, _, S, SAMPLED>(&queue, &method)
}

/// Returns the largest difference between ends in lanes and ends of single runs.
fn largest_difference<K>(method: K, end: f64) -> f64
where
    K: Method<DoublePendulum<f64>> + LanesMethod<f64> + Sync,
{
    let starts = starts(8);
    let found = arrivals::<_, Lanes<f64, 8>, false>(&starts, method, end, None);
    let mut largest = 0.0_f64;
    for (start, found) in starts.iter().zip(found) {
        let system = start.system.expect("has one");
        let run = crate::run::integrate(&system, 0.0, start.state, end, &method, |_, _| {});
        let state = found.expect("ends").state;
        for (one, other) in state.iter().zip(run.expect("runs")) {
            largest = largest.max((one - other).abs());
        }
    }
    largest
}

#[test]
fn ends_are_those_of_runs_to_within_the_tolerance() {
    for (tolerance, most) in [(1e-6, 2e-4), (1e-9, 2e-7), (1e-12, 2e-10)] {
        let difference = largest_difference(Verner98::tolerance(tolerance), 2.0);
        assert!(difference < most, "{tolerance}: {difference}");
        let back = largest_difference(Verner98::tolerance(tolerance), -2.0);
        assert!(back < most, "{tolerance}: {back}");
    }
    let difference = largest_difference(RungeKutta4 { step: 0.01 }, 2.0);
    assert!(difference < 1e-12, "{difference}");
}

type Pendulums<'a> = Ensemble<'a, DoublePendulum<f64>, Verner98<f64>>;

/// Returns an ensemble of double pendulums that differ in start and parameter.
fn pendulums(system: &DoublePendulum<f64>, number: usize) -> Pendulums<'_> {
    let motions =
        system.ensemble(number).start(|_, random| [random.uniform(-2.0..2.0), 1.0, 0.0, random.normal()]);
    motions.parameters(|index, system| system.ratio = 0.2 + 4e-3 * index as f64).until(0.3).tolerance(1e-6)
}

fn all_bits<M: MechanicalSystem<Scalar = f64>>(ends: &Ends<M>) -> Vec<u64> {
    ends.table().columns().chain([ends.times()]).flatten().map(|value| value.to_bits()).collect()
}

#[test]
fn sums_depend_neither_on_threads_nor_on_the_way() {
    let system = DoublePendulum::default();
    let moments = |threads| {
        let ensemble = pendulums(&system, 140).observe("ratio", |system, _, _| system.ratio).threads(threads);
        assert!(ensemble.is_in_lanes());
        let reduced = ensemble.reduce((Moments::new(), 0_u64), |(moments, steps), motion| {
            let trajectory = motion.trajectory();
            assert_eq!(trajectory.last(), trajectory.state(1).expect("two samples"));
            assert_eq!(trajectory.first()[1], 1.0);
            let ratio = trajectory.column("ratio").expect("was observed");
            assert_eq!(ratio, [motion.system().ratio; 2]);
            moments.add(trajectory.last()[0]);
            *steps += trajectory.work().steps;
        });
        std::format!("{:?}", reduced.expect("runs").into_value())
    };
    let one = moments(1);
    assert_eq!(moments(3), one);
}

#[test]
fn columns_are_those_of_runs() {
    let system = DoublePendulum::default();
    let ensemble = || {
        let ensemble = pendulums(&system, 20).observe("twice", |_, t, y| 2.0 * t * y[0]);
        ensemble.observe("ratio", |system, _, _| system.ratio)
    };
    let (lanes, alone) = (ensemble().run().expect("runs"), ensemble().one_by_one().run().expect("runs"));
    assert_eq!(lanes.names(), alone.names());
    assert_eq!(lanes.column("ratio"), alone.column("ratio"));
    for (found, expected) in lanes.table().columns().zip(alone.table().columns()) {
        assert!(found.iter().zip(expected).all(|(found, expected)| (found - expected).abs() < 1e-4));
    }
    assert_ne!(all_bits(&lanes), all_bits(&alone));
    let twice = lanes.column("twice").expect("was observed");
    assert_eq!(twice[3], 2.0 * 0.3 * lanes.state(3).expect("ended")[0]);
}

/// Asserts that motions fail in lanes as they do in single runs.
fn assert_same_failures<M, K>(ensemble: impl Fn() -> Ensemble<'static, M, K>, expected: &[usize])
where
    M: MechanicalSystem<Scalar = f64, State = [f64; 2]> + Send + Sync + 'static,
    K: Method<M> + Clone + Sync,
{
    assert!(ensemble().is_in_lanes());
    let (lanes, alone) = (ensemble().run().expect("runs"), ensemble().one_by_one().run().expect("runs"));
    let which: Vec<_> = lanes.failures().iter().map(|failure| failure.index).collect();
    assert_eq!(which, expected);
    for (found, expected) in lanes.failures().iter().zip(alone.failures()) {
        assert_eq!(found.to_string(), expected.to_string());
        assert_eq!(discriminant(&found.cause), discriminant(&expected.cause));
        assert_eq!(found.time, expected.time);
        assert_eq!(found.state.map(f64::to_bits), expected.state.map(f64::to_bits));
    }
    for index in 0..lanes.len() {
        let states = (lanes.state(index), alone.state(index));
        let (Some(found), Some(expected)) = states else {
            assert!(which.contains(&index) && states == (None, None));
            continue;
        };
        let difference = (found[0] - expected[0]).abs().max((found[1] - expected[1]).abs());
        assert!(difference < 1e-7, "{index}: {difference}");
    }
}

#[test]
fn motions_fail_as_they_do_alone_and_others_continue() {
    const ROOT: Root<f64> = Root { end: 1.0 };
    let roots = || {
        let motions = ROOT.ensemble(12).start(|index, _| [if index == 4 { f64::NAN } else { 0.0 }, 0.5]);
        motions.parameters(|index, root| root.end = if index % 9 == 2 { 0.7 } else { 2.5 }).until(2.0)
    };
    assert_same_failures(roots, &[2, 4, 11]);
    assert_same_failures(|| roots().method(RungeKutta4 { step: 0.01 }), &[2, 4, 11]);
    const SPRING: Spring<f64> = Spring { stiffness: 1.0 };
    let springs = |stiffness: f64| {
        let motions = SPRING.ensemble(9).start(|index, _| [1e-3 * index as f64, 1.0]);
        motions.parameters(move |index, spring| spring.stiffness = if index == 7 { stiffness } else { 2.0 })
    };
    assert_same_failures(move || springs(400.0).until(4.0).max_steps(40), &[7]);
    assert_same_failures(move || springs(1e6).until(4.0).method(RungeKutta4 { step: 0.02 }), &[7]);
    assert_same_failures(move || springs(1e6).until(4.0).method(StormerVerlet { step: 0.02 }), &[7]);
    assert_same_failures(move || springs(1e6).until(-4.0).method(BlanesMoan4 { step: 0.02 }), &[7]);
    assert_same_failures(move || springs(1e6).until(4.0).method(Taylor::tolerance(1e-9)).max_steps(90), &[7]);
    assert_same_failures(move || springs(3.0).until(-1.0).method(Taylor::tolerance(1e-9)), &[]);
    assert_same_failures(move || springs(3.0).until(0.0), &[]);
    assert_same_failures(move || springs(3.0).until(-1.0).longest_step(0.1), &[]);
}

/// A step that is too long is recognised by its start, since it ends at an unrelated state.
#[test]
fn steps_that_are_too_long_are_refused_as_they_are_alone() {
    let system = DoublePendulum::default();
    let ensemble = || {
        let motions = system.ensemble(60).start(|index, _| [0.05 * index as f64, 2.0, 0.0, 0.0]).until(1.0);
        motions.method(RungeKutta4 { step: 1.0 })
    };
    let refused = |ends: Ends<DoublePendulum<f64>>| {
        ends.failures().iter().map(|failure| failure.index).collect::<Vec<_>>()
    };
    let alone = refused(ensemble().one_by_one().run().expect("runs"));
    assert!((10..50).contains(&alone.len()), "{alone:?}");
    assert!(ensemble().is_in_lanes());
    assert_eq!(refused(ensemble().run().expect("runs")), alone);
}

#[test]
fn stiff_motions_are_refused_as_they_are_alone() {
    const SERVO: Servo<f64> = Servo { damping: 1.0 };
    let servos = || {
        let motions = SERVO.ensemble(9).start(|_, _| [0.0, 1.0]).parameters(|index, servo| {
            servo.damping = if index == 5 { 1e5 } else { 1.0 };
        });
        motions.until(10.0).tolerance(1e-6)
    };
    assert_same_failures(servos, &[5]);
    let ends = servos().run().expect("runs");
    assert!(matches!(ends.failures()[0].cause, StepFailure::Stiff { .. }), "{:?}", ends.failures());
}

/// Lanes whose step is lost in the rounding of time are given up before their first step.
#[test]
fn steps_lost_in_the_rounding_of_time_are_refused_as_they_are_alone() {
    const SPRING: Spring<f64> = Spring { stiffness: 1.0 };
    let springs = |start: f64, end: f64| {
        SPRING.ensemble(3).start(|index, _| [1e-3 * index as f64, 1.0]).from(start).until(end)
    };
    for (start, end, step) in [(0.0, 1.0, 1e-300), (0.0, -1.0, 1e-17), (1e15, 1e15 + 2.0, 0.01)] {
        assert_same_failures(move || springs(start, end).method(RungeKutta4 { step }), &[0, 1, 2]);
        assert_same_failures(move || springs(start, end).method(StormerVerlet { step }), &[0, 1, 2]);
        assert_same_failures(move || springs(start, end).method(BlanesMoan4 { step }), &[0, 1, 2]);
        let ends = springs(start, end).method(RungeKutta4 { step }).run().expect("runs");
        assert!(matches!(ends.failures()[0].cause, StepFailure::StepLost { .. }), "{:?}", ends.failures());
    }
    assert_same_failures(move || springs(1e9, 1e9 + 1.0).method(StormerVerlet { step: 0.01 }), &[]);
    assert_same_failures(move || springs(1e9, 1e9 + 1.0), &[]);
    assert_same_failures(move || springs(1e9, 1e9 + 1.0).method(Taylor::tolerance(1e-9)), &[]);
}

#[test]
fn single_precision_goes_in_lanes_too() {
    let system = DoublePendulum::<f32>::default();
    let ensemble = || system.ensemble(20).start(|index, _| [0.1 * index as f32, 1.0, 0.0, 0.0]).until(1.0);
    assert!(ensemble().is_in_lanes());
    let (lanes, alone) = (ensemble().run().expect("runs"), ensemble().one_by_one().run().expect("runs"));
    for index in 0..20 {
        let (found, expected) = (lanes.state(index).expect("ended"), alone.state(index).expect("ended"));
        assert!(found.iter().zip(expected).all(|(found, expected)| (found - expected).abs() < 1e-4));
    }
}

#[test]
fn what_is_asked_for_decides_on_the_way() {
    let system = DoublePendulum::default();
    let ensemble = || pendulums(&system, 3);
    assert!(ensemble().is_in_lanes() && ensemble().max_steps(100).longest_step(0.1).is_in_lanes());
    assert!(ensemble().method(RungeKutta4 { step: 0.1 }).is_in_lanes());
    assert!(!ensemble().one_by_one().is_in_lanes());
    assert!(ensemble().every(0.1).is_in_lanes());
    assert!(!ensemble().restart_at([0.5]).is_in_lanes());
    assert!(!ensemble().method(GaussLegendre4 { step: 0.1 }.plain()).is_in_lanes());
    let alone = ensemble().one_by_one().run().expect("runs");
    let motion = ensemble().motion(2).expect("is there").expect("runs");
    assert_eq!(alone.state(2), Some(motion.last()));
}

#[test]
fn settings_without_sense_are_errors() {
    let system = DoublePendulum::default();
    let messages = [
        pendulums(&system, 3).tolerance(-1.0).run().map(|_| ()),
        pendulums(&system, 3).observe("a", |_, t, _| t).run().map(|_| ()),
        pendulums(&system, 3).method(RungeKutta4 { step: 0.0 }).run().map(|_| ()),
        pendulums(&system, 3).method(RungeKutta4 { step: 0.1 }).longest_step(0.1).run().map(|_| ()),
    ];
    let messages = messages.map(|result| result.expect_err("no sense").to_string());
    let expected = [
        "tolerances must be finite and not negative, and not both zero",
        "two columns are called `a`",
        "the step size must be positive and finite",
        "this method has a fixed step size: reduce it instead",
    ];
    assert_eq!(messages, expected);
}
