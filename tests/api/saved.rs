//! Stepped motions saved as numbers and resumed elsewhere.

use lagrange::contact::{ContactSystem, Friction, Mode, Stepped, SteppedStepper};
use lagrange::integrate::{BlanesMoan4, FixedStepper, Formula, Memory, Method, RungeKutta4, Stepper};
use lagrange::integrate::{StepFailure, StormerVerlet, SymplecticEuler};
use lagrange::system::OdeSystem;

/// A thrown box in single precision, with a rod that rubs in its lid. It does not need `Clone`.
mod crates {
    lagrange::system! {
        #[scalar(f32)]
        pub struct Thrown;
        param mu = 0.4, e = 0.3;
        gravity = (0, 0, -9.81);
        body case { mass: 2; shape: cuboid(0.4, 0.3, 0.2); }
        free case;
        start case_z = 0.4, case_vx = 2, case_vy = 1, case_wy = 3;
        body rod { mass: 0.3; shape: slender_rod(0.2); }
        revolute hinge = case to rod { at: (0, 0, 0.1); axis: (0, 1, 0); }
        friction rub = dot(hinge), 0.01;
        for i in 0..4 { contact foot[i] = case.corner(i) on ground { friction: mu; restitution: e; } }
    }
}
use crates::Thrown;

/// Seven velocities: the rod, and four corners with friction in a plane.
type BoxStepper = SteppedStepper<Thrown, 7, 13>;

lagrange::system! {
    #[scalar(f32)]
    pub struct Pendulum;
    param l = 1, g = 9.81;
    coord theta;
    kinetic = 1/2 * (l * dot(theta))^2;
    potential = -g * l * cos(theta);
}

const FRAME: f32 = 1.0 / 120.0;
const HOUR: f32 = 3600.0;

fn numbers<M: OdeSystem, F>(stepper: &FixedStepper<M, F>) -> Vec<M::Scalar>
where
    F: Formula<M> + Memory<M::Scalar> + Clone,
{
    let mut saved = Vec::new();
    stepper.save(|number| saved.push(number));
    saved
}

#[test]
fn a_box_in_contact_continues_with_the_same_bits() -> Result<(), StepFailure<f32>> {
    let (thrown, method) = (Thrown::default(), Stepped::every(FRAME));
    let start = thrown.start().into();
    let begin = || Method::<Thrown>::start(&method, &thrown, 0.0, &start, HOUR);
    let (mut stepper, mut differs, mut touched) = (begin()?, false, false);
    for frame in 0..60 {
        let mut saved = Vec::new();
        stepper.save(|number| saved.push(number));
        let mut restored = begin()?;
        restored.restore(saved.iter().copied())?;
        let modes = |of: &BoxStepper| of.in_modes(&thrown).map(|thrown| thrown.modes());
        assert_eq!(modes(&restored), modes(&stepper), "frame {frame}");
        assert_eq!(restored.impulses(), stepper.impulses());
        let (mut again, mut ahead) = (begin()?, stepper.clone());
        again.restart(&thrown, stepper.time(), stepper.state())?;
        for _ in 0..20 {
            for each in [&mut restored, &mut ahead, &mut again] {
                each.step(&thrown, HOUR)?;
            }
            assert_eq!(restored.state(), ahead.state(), "frame {frame}");
            assert_eq!(restored.time(), ahead.time());
        }
        differs |= again.state() != ahead.state();
        stepper.step(&thrown, HOUR)?;
        let slides = |mode: &Mode| matches!(mode, Mode::Friction(Friction::SlipsTowards(..)));
        touched |= modes(&stepper).is_some_and(|modes| modes.iter().any(slides));
    }
    assert!(touched, "it slides on its feet");
    assert!(differs, "time and state alone have other bits");
    Ok(())
}

/// Throws whose impulses are hard to determine: those of two corners depend on each other, and the
/// rod hardly rubs.
#[test]
fn throws_in_single_precision_obey_the_law() -> Result<(), StepFailure<f32>> {
    let (thrown, method) = (Thrown::default(), Stepped::every(FRAME));
    for velocities in [
        [1.0863833, 0.32574347, -1.8056226, 2.5778515, 0.9767121, -0.5567714],
        [2.0040731, 1.7545316, 0.7195255, 1.2507917, 0.49595797, 1.5643693],
        [0.3665861, 0.808061, -1.4924257, 3.028977, -0.66928697, -1.8739618],
        [-0.32366502, 0.3590962, 0.085506946, 4.668044, 0.14742966, 1.8883232],
        [2.1480439, -0.8945656, 1.9319725, 3.9487936, -1.3748533, 0.20257732],
        [-0.50808525, 1.1654447, 1.4065089, 3.688229, -1.9070215, 1.4589393],
    ] {
        let mut start: [f32; 15] = thrown.start().into();
        start[9..].copy_from_slice(&velocities);
        let mut stepper = Method::<Thrown>::start(&method, &thrown, 0.0, &start, 3.0)?;
        while stepper.time() < 3.0 {
            stepper.step(&thrown, 3.0)?;
        }
        assert!(stepper.worst_residual() < 1e-3, "{:e}", stepper.worst_residual());
        assert!(stepper.state()[2] < 0.2, "it lies on the ground: {:?}", stepper.state());
    }
    Ok(())
}

/// Saves a swing at every frame, and follows each saved motion for a while.
fn check<F>(
    method: &impl Method<Pendulum, Stepper = FixedStepper<Pendulum, F>>,
) -> Result<(), StepFailure<f32>>
where
    F: Formula<Pendulum> + Memory<f32> + Clone,
{
    let pendulum = Pendulum::default();
    let begin = |y: [f32; 2]| method.start(&pendulum, 0.0, &y, HOUR);
    let mut stepper = begin([2.0, 0.0])?;
    for frame in 0..100 {
        let mut restored = begin([0.1, 0.0])?;
        restored.restore(numbers(&stepper))?;
        let mut ahead = stepper.clone();
        for _ in 0..50 {
            restored.step(&pendulum, HOUR)?;
            ahead.step(&pendulum, HOUR)?;
            assert_eq!(restored.state(), ahead.state(), "{} at frame {frame}", method.name());
            assert_eq!(restored.time(), ahead.time());
        }
        stepper.step(&pendulum, HOUR)?;
        // A picture between frames does not change the motion.
        stepper.interpolate(&pendulum, stepper.time() - 0.5 * FRAME);
    }
    Ok(())
}

#[test]
fn a_swing_continues_with_the_same_bits() -> Result<(), StepFailure<f32>> {
    check(&RungeKutta4 { step: FRAME })?;
    check(&SymplecticEuler { step: FRAME })?;
    check(&StormerVerlet { step: FRAME })?;
    check(&BlanesMoan4 { step: FRAME })
}

#[test]
fn numbers_of_something_else_are_refused() -> Result<(), StepFailure<f32>> {
    let pendulum = Pendulum::default();
    let begin = |y: [f32; 2]| RungeKutta4 { step: FRAME }.start(&pendulum, 0.0, &y, HOUR);
    let saved = numbers(&begin([2.0, 0.0])?);
    let mut stepper = begin([1.0, 0.0])?;
    let (short, long) = (&saved[1..], [&saved[..], &[0.0]].concat());
    let places = 0..saved.len();
    let broken = places.map(|place| [&saved[..place], &[f32::NAN], &saved[place + 1..]].concat());
    for wrong in broken.chain([short.to_vec(), long, Vec::new()]) {
        let failure = stepper.restore(wrong).expect_err("another count, or not finite");
        let words = "the saved numbers are not those of such a motion";
        assert!(failure.to_string().contains(words), "{failure}");
    }
    assert_eq!(stepper.state(), &[1.0, 0.0]);
    Ok(())
}
