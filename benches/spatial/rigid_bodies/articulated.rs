//! Forward dynamics by articulated bodies.
//!
//! The inertia of an articulated body is kept in three blocks. With motion (α, a) it answers with
//! the moment A α + B a and the force Bᵀ α + C a, in addition to its bias. A joint about z that
//! transmits no torque leaves nothing in row 2 of A and B. Only a corner of A and two rows of B are
//! therefore rotated.

use crate::handwritten::{SinCos, fma};

use super::vectors::{
    Matrix, Symmetric, Vector, cross, cross_sum, dot, product, scaled, scaled_sum, sum, transposed_product,
};
use super::{Chain, Link, handed_on, sines};

/// Quantities per link that the sweeps pass to each other.
#[derive(Clone, Copy, Default)]
struct Swept {
    rotation: Matrix,
    /// x and y of v × S q̇, angular and linear.
    coriolis: [f64; 4],
    /// Moment about the joint and force at zero acceleration.
    bias: [Vector; 2],
    /// Acceleration of the joint for unit accelerations of the previous link in these axes,
    /// negated, except for rotation about z.
    factor: [f64; 5],
    /// Acceleration of the joint when the previous link does not accelerate.
    free: f64,
}

/// The inertia of a link with all that it carries, and its bias.
#[derive(Clone, Copy, Default)]
struct Articulated {
    rotary: Symmetric,
    coupling: Matrix,
    massive: Symmetric,
    bias: [Vector; 2],
}

/// The inertia of an articulated body released by its joint: nothing resists rotation about z.
struct Freed {
    /// xx, xy and yy of A.
    corner: [f64; 3],
    /// Rows 0 and 1 of B.
    coupling: [Vector; 2],
    massive: Symmetric,
}

impl<const N: usize> Chain<N> {
    /// Computes accelerations without torques.
    #[inline]
    pub(crate) fn accelerations<F: SinCos>(&self, q: &[f64; N], v: &[f64; N]) -> [f64; N] {
        let mut swept = [Swept::default(); N];
        outward::<F, N>(self, q, v, &mut swept);
        let mut body = Articulated::default();
        for i in (2..N).rev() {
            body.add(&self.links[i], swept[i].bias);
            body = body.handed_on(&self.links[i], &mut swept[i]);
        }
        // Separate from the others, since most of what is passed on to the first link is not
        // needed.
        body.add(&self.links[1], swept[1].bias);
        body = body.handed_on(&self.links[1], &mut swept[1]);
        body.add(&self.links[0], swept[0].bias);
        let linear = scaled(self.gravity, swept[0].rotation.map(|row| row[2]));
        let torque = -body.bias[0][2] - dot(body.coupling[2], linear);
        let mut accelerations = [0.0; N];
        accelerations[0] = torque / body.rotary.zz;
        let mut motion = [[0.0, 0.0, accelerations[0]], linear];
        for i in 1..N {
            accelerations[i] = swept[i].accelerate(&mut motion, self.links[i].at);
        }
        accelerations
    }
}

/// Computes velocities, and the quantities that depend on them.
#[inline(always)]
fn outward<F: SinCos, const N: usize>(chain: &Chain<N>, q: &[f64; N], v: &[f64; N], swept: &mut [Swept; N]) {
    let sines = sines::<F, N>(q);
    swept[0].rotation = chain.links[0].rotation(sines[0]);
    let (mut angular, mut linear) = ([0.0, 0.0, v[0]], [0.0; 3]);
    for i in 1..N {
        let link = &chain.links[i];
        let rotation = link.rotation(sines[i]);
        linear = product(&rotation, cross_sum(angular, link.at, linear));
        angular = product(&rotation, angular);
        angular[2] += v[i];
        let coriolis = [angular[1] * v[i], -angular[0] * v[i], linear[1] * v[i], -linear[0] * v[i]];
        swept[i] = Swept { rotation, coriolis, bias: link.bias(angular, linear), ..Swept::default() };
    }
}

impl Link {
    /// Returns v ×* I v.
    #[inline(always)]
    fn bias(&self, angular: Vector, linear: Vector) -> [Vector; 2] {
        let momentum = scaled_sum(self.mass, linear, cross(angular, self.first_moment));
        let spin = cross_sum(self.first_moment, linear, product(&self.inertia.rows(), angular));
        [cross_sum(angular, spin, cross(linear, momentum)), cross(angular, momentum)]
    }
}

impl Articulated {
    /// Adds a link, which is rigid.
    #[inline(always)]
    fn add(&mut self, link: &Link, bias: [Vector; 2]) {
        let [x, y, z] = link.first_moment;
        self.rotary = self.rotary.plus(link.inertia);
        for (row, entries) in self.coupling.iter_mut().zip([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]]) {
            *row = sum(*row, entries);
        }
        self.massive.xx += link.mass;
        self.massive.yy += link.mass;
        self.massive.zz += link.mass;
        self.bias = [sum(self.bias[0], bias[0]), sum(self.bias[1], bias[1])];
    }

    /// Returns the articulated inertia and bias that the previous link feels through the joint.
    #[inline(always)]
    fn handed_on(&self, link: &Link, swept: &mut Swept) -> Articulated {
        let inverse = 1.0 / self.rotary.zz;
        let (last, [moment, force]) = (self.coupling[2], self.bias);
        swept.factor =
            [self.rotary.xz, self.rotary.yz, last[0], last[1], last[2]].map(|entry| entry * inverse);
        swept.free = -moment[2] * inverse;
        let freed = self.freed(swept.factor);
        let [mx, my, fx, fy, fz] = freed.forces(swept.coriolis);
        let moment = [
            fma(self.rotary.xz, swept.free, moment[0] + mx),
            fma(self.rotary.yz, swept.free, moment[1] + my),
            0.0,
        ];
        let force = scaled_sum(swept.free, last, sum(force, [fx, fy, fz]));
        let bias = handed_on(&swept.rotation, link.at, [moment, force]);
        freed.before(&swept.rotation, link.at, bias)
    }

    /// Returns the inertia that remains when the joint moves freely: I − U Uᵀ / D, with U / D.
    #[inline(always)]
    fn freed(&self, [p, q, r, s, t]: [f64; 5]) -> Freed {
        let Articulated { rotary: a, coupling: b, massive: c, .. } = *self;
        let last = b[2];
        Freed {
            corner: [fma(-p, a.xz, a.xx), fma(-p, a.yz, a.xy), fma(-q, a.yz, a.yy)],
            coupling: [scaled_sum(-p, last, b[0]), scaled_sum(-q, last, b[1])],
            massive: Symmetric {
                xx: fma(-r, last[0], c.xx),
                yy: fma(-s, last[1], c.yy),
                zz: fma(-t, last[2], c.zz),
                xy: fma(-r, last[1], c.xy),
                xz: fma(-r, last[2], c.xz),
                yz: fma(-s, last[2], c.yz),
            },
        }
    }
}

impl Freed {
    /// Returns x and y of the moment and the force for an acceleration whose components along z are
    /// zero.
    #[inline(always)]
    fn forces(&self, [u, v, x, y]: [f64; 4]) -> [f64; 5] {
        let Freed { corner: [xx, xy, yy], coupling: [first, second], massive } = self;
        let rows = massive.rows();
        let rotary = [fma(*xx, u, xy * v), fma(*xy, u, yy * v)];
        let linear = [first, second].map(|row| fma(row[0], x, row[1] * y));
        let force =
            sum(scaled_sum(u, *first, scaled(v, *second)), scaled_sum(x, rows[0], scaled(y, rows[1])));
        [rotary[0] + linear[0], rotary[1] + linear[1], force[0], force[1], force[2]]
    }

    /// Transforms to the axes of the previous link and about its joint, and adds to an existing
    /// bias.
    #[inline(always)]
    fn before(&self, e: &Matrix, at: Vector, bias: [Vector; 2]) -> Articulated {
        let Freed { corner: [xx, xy, yy], coupling: rows, massive } = self;
        let half = [scaled_sum(*xx, e[0], scaled(*xy, e[1])), scaled_sum(*xy, e[0], scaled(*yy, e[1]))];
        let rotary = Symmetric::from_entries(|i, j| fma(e[0][i], half[0][j], e[1][i] * half[1][j]));
        let rows = rows.map(|row| transposed_product(e, row));
        let turned = std::array::from_fn(|i| scaled_sum(e[0][i], rows[0], scaled(e[1][i], rows[1])));
        let massive = massive.turned_back(e);
        let [x, y, z] = massive.rows().map(|column| cross(at, column));
        let coupling = std::array::from_fn(|i| sum(turned[i], [x[i], y[i], z[i]]));
        Articulated { rotary: rotary.plus(about(at, &turned, &coupling)), coupling, massive, bias }
    }
}

/// Computes (r × row j of B) i + (r × row i of B') j. This is the gain of rotary inertia when
/// moments are taken about −r, where B becomes B'.
#[inline(always)]
fn about([x, y, z]: Vector, b: &Matrix, c: &Matrix) -> Symmetric {
    Symmetric {
        xx: fma(y, b[0][2] + c[0][2], -z * (b[0][1] + c[0][1])),
        yy: fma(z, b[1][0] + c[1][0], -x * (b[1][2] + c[1][2])),
        zz: fma(x, b[2][1] + c[2][1], -y * (b[2][0] + c[2][0])),
        xy: fma(y, b[1][2], -z * b[1][1]) + fma(z, c[0][0], -x * c[0][2]),
        xz: fma(y, b[2][2], -z * b[2][1]) + fma(x, c[0][1], -y * c[0][0]),
        yz: fma(z, b[2][0], -x * b[2][2]) + fma(x, c[1][1], -y * c[1][0]),
    }
}

impl Swept {
    /// Computes the acceleration of the joint from the motion of the previous link, which becomes
    /// that of this link.
    #[inline(always)]
    fn accelerate(&self, [angular, linear]: &mut [Vector; 2], at: Vector) -> f64 {
        let [u, v, x, y] = self.coriolis;
        let [p, q, r, s, t] = self.factor;
        *linear = sum(product(&self.rotation, cross_sum(*angular, at, *linear)), [x, y, 0.0]);
        *angular = sum(product(&self.rotation, *angular), [u, v, 0.0]);
        let turned = fma(p, angular[0], fma(q, angular[1], angular[2]));
        let acceleration = self.free - (turned + dot([r, s, t], *linear));
        angular[2] += acceleration;
        acceleration
    }
}
