//! Accelerations of all references without constraints, from the device and from the scalar code.
//!
//! Without a device nothing is compared, and a message reports that; `LAGRANGE_DEVICE=required`
//! makes it an error.

mod cuda;

use std::path::Path;

use lagrange_runtime::system::{KernelSystem, MechanicalSystem, StateVector};

use crate::backend::{Method, Work};
use crate::device::Device;
use reference::{Reference, names};

/// Only some of its items are used here.
#[path = "../../../../tests/oracle/reference.rs"]
#[allow(dead_code, reason = "other tests compare more")]
mod reference;

/// A kernel with the arguments of a method, which replaces the velocities by accelerations.
const ACCELERATIONS: &str = include_str!("accelerations.c");

/// Returns the device, unless there is none and none is required.
pub(crate) fn device() -> Option<Device> {
    match Device::open() {
        Ok(device) => Some(device),
        Err(error) => {
            assert!(std::env::var("LAGRANGE_DEVICE").as_deref() != Ok("required"), "{error}");
            println!("nothing is compared: {error}");
            None
        }
    }
}

/// Declares a reference, compiled, with its own test.
macro_rules! declare {
    ($name:ident, $($key:ident: $word:ident),*; $($declaration:tt)*) => {
        mod $name {
            lagrange::system! {
                pub(crate) struct Compiled;
                $($declaration)*
                emit { kernel, no mass_matrix, no forcing, no momenta, no inverse_dynamics, no energy }
            }

            #[test]
            fn accelerations_are_those_of_the_scalar_code() {
                super::super::check(stringify!($name), &Compiled::default());
            }
        }
    };
}

#[path = "../../../../tests/oracle/systems.rs"]
mod systems;

fn directory() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/oracle"))
}

#[test]
fn every_reference_is_compiled() {
    let systems = include_str!("../../../../tests/oracle/systems.rs");
    let declared = systems.lines().filter_map(|line| line.strip_prefix("declare! { ")?.split(',').next());
    assert!(declared.eq(names(directory()).iter()));
}

fn check<M: KernelSystem<Scalar = f64>>(name: &str, system: &M) {
    let Some(device) = device() else { return };
    let reference = Reference::read(directory(), name);
    for state in reference.states() {
        let mut work = work_at(system, state.t, &[state.q.as_slice(), &state.v].concat());
        let text = [M::KERNEL_F64, include_str!("../methods.c"), ACCELERATIONS].concat();
        let text = text.replacen("lagrange_runge_kutta_4(", "lagrange_unused(", 1);
        device.backend().run(&text, &mut work).unwrap_or_else(|error| panic!("{name}: {error}"));
        let found = &work.states[state.q.len()..];
        let expected = acceleration(system, state.t, &state.q, &state.v);
        let largest = expected.iter().fold(0.0_f64, |largest, value| largest.max(value.abs()));
        let agree = found.iter().zip(&expected).all(|(a, b)| (a - b).abs() <= 1e-12 * largest);
        assert!(agree, "{name} at t = {}: {found:?}, not {expected:?}", state.t);
    }
}

fn acceleration<M: MechanicalSystem<Scalar = f64>>(system: &M, t: f64, q: &[f64], v: &[f64]) -> Vec<f64> {
    let (mut positions, mut velocities) = (M::Coordinates::ZERO, M::Velocities::ZERO);
    positions.as_mut().copy_from_slice(q);
    velocities.as_mut().copy_from_slice(v);
    system.acceleration(t, &positions, &velocities).as_ref().to_vec()
}

/// Returns one motion at a state.
fn work_at<M: KernelSystem<Scalar = f64>>(system: &M, t: f64, state: &[f64]) -> Work<f64> {
    Work {
        method: Method::RungeKutta4,
        motions: 1,
        states: state.to_vec(),
        parameters: [system.parameters().as_ref(), &[0.0]].concat(),
        times: vec![t],
        controls: vec![0.0; 2],
        taken: vec![0],
        statuses: vec![0],
        end: t,
        step: 1.0,
        relative: 1e-9,
        absolute: 1e-9,
        most: 1,
    }
}
