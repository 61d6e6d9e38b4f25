//! The mass matrix by composite rigid bodies.
//!
//! The reference is the origin of the world and its axes, not those of the links. Inertias and
//! forces then need not be passed on from link to link. That costs more than rotating each link's
//! inertia once, at twenty joints more than twice as much. The axis z of a joint at the position p
//! moves the bodies behind it with z and p × z at the origin. Entry (i, j) is the power of the
//! force for joint j there.

use std::array::from_fn;

use crate::handwritten::{SinCos, fma};

use super::vectors::{
    Matrix, Symmetric, Vector, cross, cross_sum, dot, product, scaled_sum, sum, transposed_product,
};
use super::{Chain, Link, sines};

/// A link, alone or with all links behind it as one rigid body.
#[derive(Clone, Copy, Default)]
struct Composite {
    mass: f64,
    first_moment: Vector,
    inertia: Symmetric,
}

/// The motion of each joint at unit rate at the origin, by components, so that one instruction
/// handles several joints.
struct Motions<const N: usize> {
    angular: [[f64; N]; 3],
    linear: [[f64; N]; 3],
}

impl<const N: usize> Chain<N> {
    #[inline]
    pub(crate) fn mass_matrix<F: SinCos>(&self, q: &[f64; N]) -> [[f64; N]; N] {
        const { assert!(N <= 24) }
        let mut motions = Motions { angular: [[0.0; N]; 3], linear: [[0.0; N]; 3] };
        let links = placed::<F, N>(self, q, &mut motions);
        let mut matrix = [[0.0; N]; N];
        let mut body = Composite::default();
        // Literal indices make trip counts constants: the loops over joints before a link unroll.
        macro_rules! inwards {
            ($($joint:literal)*) => { $(if $joint < N {
                body = body.plus(&links[$joint]);
                motions.fill::<$joint>(&body, &mut matrix);
            })* };
        }
        inwards!(23 22 21 20 19 18 17 16 15 14 13 12 11 10 9 8 7 6 5 4 3 2 1 0);
        matrix
    }
}

/// Returns each link in the axes of the world.
#[inline(always)]
fn placed<F: SinCos, const N: usize>(
    chain: &Chain<N>,
    q: &[f64; N],
    motions: &mut Motions<N>,
) -> [Composite; N] {
    let sines = sines::<F, N>(q);
    let mut rotation = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let mut at = [0.0; 3];
    from_fn(|i| {
        let link = &chain.links[i];
        at = sum(at, transposed_product(&rotation, link.at));
        rotation = link.rotation(sines[i]).map(|row| transposed_product(&rotation, row));
        let linear = cross(at, rotation[2]);
        for k in 0..3 {
            motions.angular[k][i] = rotation[2][k];
            motions.linear[k][i] = linear[k];
        }
        Composite::of(link, &rotation, at)
    })
}

impl Composite {
    /// Returns a link whose axes in the world are the rows of `rotation` and whose joint is at this
    /// position.
    #[inline(always)]
    fn of(link: &Link, rotation: &Matrix, at: Vector) -> Composite {
        let turned = transposed_product(rotation, link.first_moment);
        let first_moment = scaled_sum(link.mass, at, turned);
        let both = dot(at, sum(turned, first_moment));
        let shift = Symmetric::from_entries(|i, j| {
            let outer = fma(turned[i], at[j], at[i] * first_moment[j]);
            if i == j { both - outer } else { -outer }
        });
        Composite { mass: link.mass, first_moment, inertia: link.inertia.turned_back(rotation).plus(shift) }
    }

    #[inline(always)]
    fn plus(&self, other: &Composite) -> Composite {
        Composite {
            mass: self.mass + other.mass,
            first_moment: sum(self.first_moment, other.first_moment),
            inertia: self.inertia.plus(other.inertia),
        }
    }

    /// Returns the moment about the origin and the force that this motion needs per unit
    /// acceleration.
    #[inline(always)]
    fn forces(&self, angular: Vector, linear: Vector) -> [Vector; 2] {
        let moment = cross_sum(self.first_moment, linear, product(&self.inertia.rows(), angular));
        [moment, scaled_sum(self.mass, linear, cross(angular, self.first_moment))]
    }
}

impl<const N: usize> Motions<N> {
    /// Fills row and column J of the matrix up to its diagonal, from the bodies that joint J moves.
    #[inline(always)]
    fn fill<const J: usize>(&self, body: &Composite, matrix: &mut [[f64; N]; N]) {
        let of_joint = |components: &[[f64; N]; 3]| from_fn(|k| components[k][J]);
        let [moment, force] = body.forces(of_joint(&self.angular), of_joint(&self.linear));
        let [a, b] = [&self.angular, &self.linear];
        for i in 0..=J {
            matrix[J][i] = fma(a[0][i], moment[0], fma(a[1][i], moment[1], a[2][i] * moment[2]))
                + fma(b[0][i], force[0], fma(b[1][i], force[1], b[2][i] * force[2]));
        }
        let row = matrix[J];
        for (other, entry) in matrix.iter_mut().zip(row).take(J) {
            other[J] = entry;
        }
    }
}
