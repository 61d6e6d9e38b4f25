//! Mechanisms for tests.

use super::Mechanism;
use crate::system::ConstraintValues;

/// Gravitational acceleration.
const G: f64 = 9.81;

fn unit<const N: usize>() -> [[f64; N]; N] {
    core::array::from_fn(|i| core::array::from_fn(|j| if i == j { 1.0 } else { 0.0 }))
}

/// Returns the constraint (|a − b|² − l²)/2 of two points, and its rate.
fn length(l: f64, (x, y): (f64, f64), (u, w): (f64, f64)) -> (f64, f64) {
    (0.5 * (x * x + y * y - l * l), x * u + y * w)
}

/// A unit mass on a rod of unit length in the plane, with the last coordinate upwards.
#[derive(Clone, Copy, Debug)]
pub(in crate::integrate) struct PlanePendulum;

impl Mechanism<2> for PlanePendulum {
    type State = [f64; 4];

    fn mass(&self, _q: &[f64; 2]) -> [[f64; 2]; 2] {
        unit()
    }

    fn rates(&self, _q: &[f64; 2], _v: &[f64; 2]) -> [f64; 2] {
        [0.0, -G]
    }

    fn potential(&self, [_, y]: &[f64; 2]) -> f64 {
        G * y
    }

    fn constraints(&self, _t: f64, q: &[f64; 2], [u, w]: &[f64; 2]) -> ConstraintValues<f64, [f64; 2]> {
        let (c, rate) = length(1.0, (q[0], q[1]), (*u, *w));
        let mut values = ConstraintValues::NONE;
        values.push_holonomic(c, rate, q);
        values
    }

    fn bend(&self, _t: f64, _q: &[f64; 2], [u, w]: &[f64; 2]) -> [f64; 2] {
        [u * u + w * w, 0.0]
    }
}

/// A unit mass on a rod of unit length in space, with the last coordinate upwards. The constraint
/// may be repeated in other units.
#[derive(Clone, Copy, Debug)]
pub(in crate::integrate) struct SphericalPendulum {
    pub(in crate::integrate) is_said_twice: bool,
}

/// Returns the state of a point on the unit sphere from two angles and their rates.
pub(in crate::integrate) fn on_sphere([polar, azimuth, rate, turn]: [f64; 4]) -> [f64; 6] {
    let ((sp, cp), (sa, ca)) = (polar.sin_cos(), azimuth.sin_cos());
    let velocity = [cp * ca * rate - sp * sa * turn, cp * sa * rate + sp * ca * turn, sp * rate];
    [sp * ca, sp * sa, -cp, velocity[0], velocity[1], velocity[2]]
}

impl Mechanism<3> for SphericalPendulum {
    type State = [f64; 6];

    fn mass(&self, _q: &[f64; 3]) -> [[f64; 3]; 3] {
        unit()
    }

    fn rates(&self, _q: &[f64; 3], _v: &[f64; 3]) -> [f64; 3] {
        [0.0, 0.0, -G]
    }

    fn potential(&self, [_, _, z]: &[f64; 3]) -> f64 {
        G * z
    }

    fn constraints(&self, _t: f64, q: &[f64; 3], v: &[f64; 3]) -> ConstraintValues<f64, [f64; 3]> {
        let [x, y, z] = q;
        let (c, rate) = (0.5 * (x * x + y * y + z * z - 1.0), x * v[0] + y * v[1] + z * v[2]);
        let mut values = ConstraintValues::NONE;
        values.push_holonomic(c, rate, q);
        if self.is_said_twice {
            values.push_holonomic(8.0 * c, 8.0 * rate, &q.map(|x| 8.0 * x));
        }
        values
    }

    fn bend(&self, _t: f64, _q: &[f64; 3], [u, v, w]: &[f64; 3]) -> [f64; 3] {
        let bend = u * u + v * v + w * w;
        [bend, if self.is_said_twice { 8.0 * bend } else { 0.0 }, 0.0]
    }
}

/// Two unit masses on rods of unit length, one below the other, with the second coordinate of each
/// upwards.
#[derive(Clone, Copy, Debug)]
pub(in crate::integrate) struct TwoRods;

impl Mechanism<4> for TwoRods {
    type State = [f64; 8];

    fn mass(&self, _q: &[f64; 4]) -> [[f64; 4]; 4] {
        unit()
    }

    fn rates(&self, _q: &[f64; 4], _v: &[f64; 4]) -> [f64; 4] {
        [0.0, -G, 0.0, -G]
    }

    fn potential(&self, [_, a, _, b]: &[f64; 4]) -> f64 {
        G * (a + b)
    }

    fn constraints(
        &self,
        _t: f64,
        &[x, y, z, w]: &[f64; 4],
        v: &[f64; 4],
    ) -> ConstraintValues<f64, [f64; 4]> {
        let (first, first_rate) = length(1.0, (x, y), (v[0], v[1]));
        let (second, second_rate) = length(1.0, (z - x, w - y), (v[2] - v[0], v[3] - v[1]));
        let mut values = ConstraintValues::NONE;
        values.push_holonomic(first, first_rate, &[x, y, 0.0, 0.0]);
        values.push_holonomic(second, second_rate, &[x - z, y - w, z - x, w - y]);
        values
    }

    fn bend(&self, _t: f64, _q: &[f64; 4], v: &[f64; 4]) -> [f64; 4] {
        let (u, w) = (v[2] - v[0], v[3] - v[1]);
        [v[0] * v[0] + v[1] * v[1], u * u + w * w, 0.0, 0.0]
    }
}

/// A sleigh on a slope: a blade at (x, y) with the angle θ, and the centre of mass in front of it.
/// Its mass matrix depends on θ.
#[derive(Clone, Copy, Debug)]
pub(in crate::integrate) struct Sleigh {
    /// Gravity along −y.
    pub(in crate::integrate) slope: f64,
}

impl Sleigh {
    const MASS: f64 = 1.2;
    const INERTIA: f64 = 0.3;
    const AHEAD: f64 = 0.4;
}

impl Mechanism<3> for Sleigh {
    type State = [f64; 6];

    fn mass(&self, [_, _, theta]: &[f64; 3]) -> [[f64; 3]; 3] {
        let (s, c) = theta.sin_cos();
        let (m, ma) = (Self::MASS, Self::MASS * Self::AHEAD);
        [[m, 0.0, -ma * s], [0.0, m, ma * c], [-ma * s, ma * c, Self::INERTIA + ma * Self::AHEAD]]
    }

    fn rates(&self, [_, _, theta]: &[f64; 3], [u, v, w]: &[f64; 3]) -> [f64; 3] {
        let ((s, c), ma) = (theta.sin_cos(), Self::MASS * Self::AHEAD);
        [0.0, -Self::MASS * self.slope, -ma * w * (u * c + v * s) - ma * self.slope * c]
    }

    fn drift(&self, [_, _, theta]: &[f64; 3], [u, v, w]: &[f64; 3]) -> [f64; 3] {
        let ((s, c), ma) = (theta.sin_cos(), Self::MASS * Self::AHEAD);
        [-ma * c * w * w, -ma * s * w * w, -ma * w * (u * c + v * s)]
    }

    fn potential(&self, [_, y, theta]: &[f64; 3]) -> f64 {
        Self::MASS * self.slope * (y + Self::AHEAD * theta.sin())
    }

    fn constraints(
        &self,
        _t: f64,
        [_, _, theta]: &[f64; 3],
        [u, v, _]: &[f64; 3],
    ) -> ConstraintValues<f64, [f64; 3]> {
        let (s, c) = theta.sin_cos();
        let mut values = ConstraintValues::NONE;
        values.push_nonholonomic(v * c - u * s, &[-s, c, 0.0]);
        values
    }

    fn bend(&self, _t: f64, [_, _, theta]: &[f64; 3], [u, v, w]: &[f64; 3]) -> [f64; 3] {
        let (s, c) = theta.sin_cos();
        [-w * (v * s + u * c), 0.0, 0.0]
    }
}

/// A unit mass on a straight wire that rotates in the plane at a given rate, without gravity.
#[derive(Clone, Copy, Debug)]
pub(in crate::integrate) struct TurningWire {
    pub(in crate::integrate) rate: f64,
}

impl Mechanism<2> for TurningWire {
    type State = [f64; 4];

    fn mass(&self, _q: &[f64; 2]) -> [[f64; 2]; 2] {
        unit()
    }

    fn rates(&self, _q: &[f64; 2], _v: &[f64; 2]) -> [f64; 2] {
        [0.0; 2]
    }

    fn potential(&self, _q: &[f64; 2]) -> f64 {
        0.0
    }

    fn constraints(&self, t: f64, [x, y]: &[f64; 2], [u, v]: &[f64; 2]) -> ConstraintValues<f64, [f64; 2]> {
        let (s, c) = (self.rate * t).sin_cos();
        let mut values = ConstraintValues::NONE;
        values.push_holonomic(y * c - x * s, v * c - u * s - self.rate * (y * s + x * c), &[-s, c]);
        values
    }

    fn bend(&self, t: f64, [x, y]: &[f64; 2], [u, v]: &[f64; 2]) -> [f64; 2] {
        let (s, c) = (self.rate * t).sin_cos();
        [-2.0 * self.rate * (v * s + u * c) + self.rate * self.rate * (x * s - y * c), 0.0]
    }
}

/// A point on a spring whose other end is a massless slide with prescribed oscillation.
#[derive(Clone, Copy, Debug)]
pub(in crate::integrate) struct DrivenSlide;

impl Mechanism<2> for DrivenSlide {
    type State = [f64; 4];

    fn mass(&self, _q: &[f64; 2]) -> [[f64; 2]; 2] {
        [[1.0, 0.0], [0.0, 0.0]]
    }

    fn rates(&self, [x, slide]: &[f64; 2], _v: &[f64; 2]) -> [f64; 2] {
        [4.0 * (slide - x), 4.0 * (x - slide)]
    }

    fn potential(&self, [x, slide]: &[f64; 2]) -> f64 {
        2.0 * (x - slide) * (x - slide)
    }

    fn constraints(
        &self,
        t: f64,
        [_, slide]: &[f64; 2],
        [_, v]: &[f64; 2],
    ) -> ConstraintValues<f64, [f64; 2]> {
        let mut values = ConstraintValues::NONE;
        values.push_holonomic(slide - t.sin(), v - t.cos(), &[0.0, 1.0]);
        values
    }

    fn bend(&self, t: f64, _q: &[f64; 2], _v: &[f64; 2]) -> [f64; 2] {
        [t.sin(), 0.0]
    }
}

/// A unit mass in a trough z = x²/2, dragged sideways with ẏ = z ẋ + 0.3 cos t.
#[derive(Clone, Copy, Debug)]
pub(in crate::integrate) struct Dragged;

impl Mechanism<3> for Dragged {
    type State = [f64; 6];

    fn mass(&self, _q: &[f64; 3]) -> [[f64; 3]; 3] {
        unit()
    }

    fn rates(&self, _q: &[f64; 3], _v: &[f64; 3]) -> [f64; 3] {
        [0.0, 0.0, -G]
    }

    fn potential(&self, [_, _, z]: &[f64; 3]) -> f64 {
        G * z
    }

    fn constraints(
        &self,
        t: f64,
        &[x, _, z]: &[f64; 3],
        [u, v, w]: &[f64; 3],
    ) -> ConstraintValues<f64, [f64; 3]> {
        let mut values = ConstraintValues::NONE;
        values.push_holonomic(z - 0.5 * x * x, w - x * u, &[-x, 0.0, 1.0]);
        values.push_nonholonomic(v - z * u - 0.3 * t.cos(), &[-z, 1.0, 0.0]);
        values
    }

    fn bend(&self, t: f64, _q: &[f64; 3], [u, _, w]: &[f64; 3]) -> [f64; 3] {
        [-u * u, 0.3 * t.sin() - w * u, 0.0]
    }
}

/// A unit bar with unit moment of inertia on three parallel cranks of unit length, one of which is
/// redundant. The constraints are dependent wherever they hold, and only there.
#[derive(Clone, Copy, Debug)]
pub(in crate::integrate) struct ThreeCranks;

impl ThreeCranks {
    /// Returns each crank as a vector, with the vector from the first point of the bar to the
    /// carried one, and its perpendicular.
    fn cranks([x, y, angle]: &[f64; 3]) -> [[f64; 6]; 3] {
        let (s, c) = angle.sin_cos();
        [0.0, 1.0, 2.0].map(|along| {
            let (px, py) = (along * c, along * s);
            [x + px - along, y + py, px, py, -py, px]
        })
    }
}

impl Mechanism<3> for ThreeCranks {
    type State = [f64; 6];

    fn mass(&self, _q: &[f64; 3]) -> [[f64; 3]; 3] {
        unit()
    }

    fn rates(&self, _q: &[f64; 3], _v: &[f64; 3]) -> [f64; 3] {
        [0.0, -G, 0.0]
    }

    fn potential(&self, [_, y, _]: &[f64; 3]) -> f64 {
        G * y
    }

    fn constraints(&self, _t: f64, q: &[f64; 3], v: &[f64; 3]) -> ConstraintValues<f64, [f64; 3]> {
        let mut values = ConstraintValues::NONE;
        for [x, y, _, _, ax, ay] in Self::cranks(q) {
            let row = [x, y, x * ax + y * ay];
            let rate = row[0] * v[0] + row[1] * v[1] + row[2] * v[2];
            values.push_holonomic(0.5 * (x * x + y * y - 1.0), rate, &row);
        }
        values
    }

    fn bend(&self, _t: f64, q: &[f64; 3], [u, v, w]: &[f64; 3]) -> [f64; 3] {
        Self::cranks(q).map(|[x, y, px, py, ax, ay]| {
            let (along, up) = (u + ax * w, v + ay * w);
            along * along + up * up - (x * px + y * py) * w * w
        })
    }
}
