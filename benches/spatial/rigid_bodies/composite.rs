//! The mass matrix by composite rigid bodies.
//!
//! Forces for unit accelerations are handed on for all joints behind a link at a time, components apart, so that the compiler
//! handles several joints in one instruction.

use crate::handwritten::{SinCos, fma};

use super::vectors::{Matrix, Symmetric, Vector, dot, scaled_sum, sum, transposed_product};
use super::{Chain, Link};

/// The link with all behind it as one rigid body.
#[derive(Clone, Copy, Default)]
struct Composite {
    mass: f64,
    first_moment: Vector,
    inertia: Symmetric,
}

/// Moment about the joint of a link and force on it for a unit acceleration of each joint.
struct Forces<const N: usize> {
    moment: [[f64; N]; 3],
    force: [[f64; N]; 3],
}

impl<const N: usize> Chain<N> {
    #[inline]
    pub(crate) fn mass_matrix<F: SinCos>(&self, q: &[f64; N]) -> [[f64; N]; N] {
        const { assert!(N <= 24) }
        let waves = F::of(*q);
        let mut matrix = [[0.0; N]; N];
        let mut body = Composite::default();
        let mut forces = Forces { moment: [[0.0; N]; 3], force: [[0.0; N]; 3] };
        // Literal indices make trip counts constants: the loops over joints behind a link unroll.
        macro_rules! inwards {
            ($($index:literal)*) => { $(if $index < N {
                let link = &self.links[$index];
                body.add(link);
                forces.begin::<$index>(&body);
                forces.fill::<$index>(&mut matrix);
                let rotation = link.rotation(F::at(&waves, $index));
                body = body.before(&rotation, link.at);
                forces.hand_on::<$index>(&rotation, link.at);
            })* };
        }
        inwards!(23 22 21 20 19 18 17 16 15 14 13 12 11 10 9 8 7 6 5 4 3 2 1);
        body.add(&self.links[0]);
        forces.begin::<0>(&body);
        forces.fill::<0>(&mut matrix);
        matrix
    }
}

impl Composite {
    #[inline(always)]
    fn add(&mut self, link: &Link) {
        self.mass += link.mass;
        self.first_moment = sum(self.first_moment, link.first_moment);
        self.inertia = self.inertia.plus(link.inertia);
    }

    /// In the axes of the link before and about its joint.
    #[inline(always)]
    fn before(&self, rotation: &Matrix, at: Vector) -> Composite {
        let turned = transposed_product(rotation, self.first_moment);
        let first_moment = scaled_sum(self.mass, at, turned);
        let both = dot(at, sum(turned, first_moment));
        let shift = Symmetric::from_entries(|i, j| {
            let outer = fma(turned[i], at[j], at[i] * first_moment[j]);
            if i == j { both - outer } else { -outer }
        });
        Composite { mass: self.mass, first_moment, inertia: self.inertia.turned_back(rotation).plus(shift) }
    }
}

impl<const N: usize> Forces<N> {
    /// Those for joint J, about whose z the body turns.
    #[inline(always)]
    fn begin<const J: usize>(&mut self, body: &Composite) {
        let [x, y, _] = body.first_moment;
        let Symmetric { xz, yz, zz, .. } = body.inertia;
        for (components, value) in self.moment.iter_mut().zip([xz, yz, zz]) {
            components[J] = value;
        }
        for (components, value) in self.force.iter_mut().zip([-y, x, 0.0]) {
            components[J] = value;
        }
    }

    /// Row and column I from its diagonal on.
    #[inline(always)]
    fn fill<const I: usize>(&self, matrix: &mut [[f64; N]; N]) {
        for (j, &moment) in self.moment[2].iter().enumerate().skip(I) {
            matrix[I][j] = moment;
            matrix[j][I] = moment;
        }
    }

    /// Those of joint I and behind to the link before.
    #[inline(always)]
    fn hand_on<const I: usize>(&mut self, e: &Matrix, [x, y, z]: Vector) {
        let turned = |components: &[[f64; N]; 3], i: usize, j: usize| {
            fma(e[0][i], components[0][j], fma(e[1][i], components[1][j], e[2][i] * components[2][j]))
        };
        for j in I..N {
            let [fx, fy, fz] = [0, 1, 2].map(|i| turned(&self.force, i, j));
            let [mx, my, mz] = [0, 1, 2].map(|i| turned(&self.moment, i, j));
            self.moment[0][j] = fma(y, fz, fma(-z, fy, mx));
            self.moment[1][j] = fma(z, fx, fma(-x, fz, my));
            self.moment[2][j] = fma(x, fy, fma(-y, fx, mz));
            (self.force[0][j], self.force[1][j], self.force[2][j]) = (fx, fy, fz);
        }
    }
}
