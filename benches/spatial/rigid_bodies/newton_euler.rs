//! Inverse dynamics by recursive Newton–Euler.
//!
//! Accelerations are classical ones of the joints, so linear velocities are not needed (Luh,
//! Walker, Paul). The six products of K = ω̇× + (ω×)² serve both the position of the next joint and
//! the forces on the link (Balafoutis and Patel):
//!
//! ```text
//! a_next = a + K r,    f = m a + K h,    n = h × a + Σ x × K x dm.
//! ```

use crate::handwritten::{SinCos, fma};

use super::vectors::{Matrix, Symmetric, Vector, cross_sum, product, scaled_sum, sum, transposed_product};
use super::{Chain, Link, handed_on, sines};

/// The motion of a link.
#[derive(Clone, Copy)]
struct Motion {
    rate: Vector,
    angular: Vector,
    /// Acceleration of the joint, with gravity as an acceleration of the ground.
    linear: Vector,
    /// K.
    spread: Matrix,
}

impl<const N: usize> Chain<N> {
    /// Computes torques for accelerations `a`.
    #[inline]
    pub(crate) fn inverse_dynamics<F: SinCos>(&self, q: &[f64; N], v: &[f64; N], a: &[f64; N]) -> [f64; N] {
        let sines = sines::<F, N>(q);
        let mut rotations = [Matrix::default(); N];
        let mut forces = [[Vector::default(); 2]; N];
        let first = &self.links[0];
        let mut motion = Motion::of_first(first.rotation(sines[0]), v[0], a[0], self.gravity);
        let own = first_torque(first, a[0], motion.linear);
        for i in 1..N {
            let link = &self.links[i];
            rotations[i] = link.rotation(sines[i]);
            motion = motion.next(link, &rotations[i], v[i], a[i]);
            forces[i] = motion.forces(link);
        }
        let mut torques = [0.0; N];
        let mut carried = [Vector::default(); 2];
        for i in (1..N).rev() {
            let [moment, force] = forces[i];
            carried = [sum(carried[0], moment), sum(carried[1], force)];
            torques[i] = carried[0][2];
            carried = handed_on(&rotations[i], self.links[i].at, carried);
        }
        torques[0] = own + carried[0][2];
        torques
    }
}

/// Returns the torque on the first link as if it were the only one.
#[inline(always)]
fn first_torque(link: &Link, acceleration: f64, linear: Vector) -> f64 {
    let [x, y, _] = link.first_moment;
    fma(link.inertia.zz, acceleration, fma(x, linear[1], -(y * linear[0])))
}

impl Motion {
    #[inline(always)]
    fn of_first(rotation: Matrix, rate: f64, acceleration: f64, gravity: f64) -> Motion {
        let centripetal = -(rate * rate);
        Motion {
            rate: [0.0, 0.0, rate],
            angular: [0.0, 0.0, acceleration],
            linear: [gravity * rotation[0][2], gravity * rotation[1][2], gravity * rotation[2][2]],
            spread: [[centripetal, -acceleration, 0.0], [acceleration, centripetal, 0.0], [0.0; 3]],
        }
    }

    #[inline(always)]
    fn next(&self, link: &Link, rotation: &Matrix, rate: f64, acceleration: f64) -> Motion {
        let [x, y, z] = product(rotation, self.rate);
        let [ax, ay, az] = product(rotation, self.angular);
        let at_joint = sum(self.linear, product(&self.spread, link.at));
        let (z, ax, ay, az) = (z + rate, fma(y, rate, ax), fma(-x, rate, ay), az + acceleration);
        let (xx, yy, zz, xy, xz, yz) = (x * x, y * y, z * z, x * y, x * z, y * z);
        Motion {
            rate: [x, y, z],
            angular: [ax, ay, az],
            linear: product(rotation, at_joint),
            spread: [
                [-(yy + zz), xy - az, xz + ay],
                [xy + az, -(xx + zz), yz - ax],
                [xz - ay, yz + ax, -(xx + yy)],
            ],
        }
    }

    /// Returns the moment about the joint and the force that the link needs.
    #[inline(always)]
    fn forces(&self, link: &Link) -> [Vector; 2] {
        let force = scaled_sum(link.mass, self.linear, product(&self.spread, link.first_moment));
        let moment = moment_of(&self.spread, link.second_moment);
        [cross_sum(link.first_moment, self.linear, moment), force]
    }
}

/// Returns Σ x × K x dm.
#[inline(always)]
fn moment_of(spread: &Matrix, second: Symmetric) -> Vector {
    // Rows of the symmetric J times rows of K: (K J) by rows.
    let [x, y, z] = spread.map(|row| transposed_product(&second.rows(), row));
    [z[1] - y[2], x[2] - z[0], y[0] - x[1]]
}
