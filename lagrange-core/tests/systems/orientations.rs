//! Unit quaternions along a motion.
//!
//! They follow q̇ = ½ q ⊗ ω. Neighbouring motions rotate them by small rotations η, under which ω
//! changes by η̇ + ω × η (Lurie, *Analytical Mechanics*, §10.1).

use crate::digits::Real;
use crate::jet::{Jet, ORDERS};
use crate::scene::Matrix;
use crate::tree::Expr;
use crate::world::World;

impl World<'_> {
    /// Returns the rotation of a unit quaternion.
    pub(crate) fn oriented(&mut self, name: &str) -> Option<Matrix> {
        let q = ["w", "x", "y", "z"].map(|part| Expr::Name(format!("{name}_q{part}")));
        let q = self.scalars(&q)?;
        let mut rotation = self.unit(3);
        for row in 0..3 {
            for column in 0..3 {
                let product = self.field.multiply(&q[1 + row], &q[1 + column]);
                let other = match (column + 3 - row) % 3 {
                    // 1 − 2 (y² + z²) for x
                    0 => {
                        let sides = [q[1 + (row + 1) % 3].clone(), q[1 + (row + 2) % 3].clone()];
                        let square = self.field.dot(&sides, &sides);
                        let twice = self.field.add(&square, &square);
                        rotation[row][column] = self.field.subtract(&rotation[row][column], &twice);
                        continue;
                    }
                    1 => {
                        let product = self.field.multiply(&q[0], &q[1 + (row + 2) % 3]);
                        self.field.negate(&product)
                    }
                    _ => self.field.multiply(&q[0], &q[1 + (row + 1) % 3]),
                };
                let sum = self.field.add(&product, &other);
                rotation[row][column] = self.field.add(&sum, &sum);
            }
        }
        Some(rotation)
    }

    /// Normalises a quaternion, and puts it and its angular velocity into the scope.
    pub(crate) fn set_orientation(
        &mut self,
        name: &str,
        velocity: usize,
        q: &[Real; 4],
        w: &[Real; 3],
        accelerations: &[Real],
    ) {
        let length = self.field.arithmetic.sqrt(&self.field.arithmetic.dot(q, q));
        let q = q.each_ref().map(|part| self.field.arithmetic.divide(part, &length));
        let rates = w.iter().zip(accelerations).map(|(w, a)| self.field.series(&[w.clone(), a.clone()]));
        let rates = rates.collect::<Vec<_>>();
        let mut turning = q.map(|part| self.field.series(&[part])).to_vec();
        let pure = |world: &mut Self, of: &[Jet]| [vec![world.field.whole(0)], of.to_vec()].concat();
        for order in 1..ORDERS {
            // q̇ = ½ q ⊗ ω, order by order
            let spin = pure(self, &rates);
            let flow = self.hamilton(&turning, &spin);
            for (part, flow) in turning.iter_mut().zip(flow) {
                let share = self.field.arithmetic.float(0.5 / order as f64);
                part.value[order] = self.field.product(&share, &flow.value[order - 1]);
            }
        }
        let mut spin = rates.clone();
        let n = self.layout.velocities;
        for axis in 0..3 {
            let axes = [0, 1, 2].map(|k| self.field.whole(i32::from(k == axis)));
            let small = pure(self, &axes);
            let turned = self.hamilton(&turning, &small);
            let crossed = self.cross(&rates, &axes);
            let half = self.field.arithmetic.float(0.5);
            for (part, turned) in turning.iter_mut().zip(turned) {
                let change = turned.value.iter().map(|c| self.field.product(&half, c)).collect::<Vec<_>>();
                part.variations[n + velocity + axis] = shifted(self.field.integer(0), &change);
                part.variations[velocity + axis] = change;
            }
            for (k, (part, crossed)) in spin.iter_mut().zip(crossed).enumerate() {
                let mut growing = shifted(self.field.integer(0), &crossed.value);
                growing[0] = self.field.integer(i32::from(k == axis));
                part.variations[n + velocity + axis] = growing;
                part.variations[velocity + axis] = crossed.value;
            }
        }
        for (part, turning) in ["w", "x", "y", "z"].iter().zip(turning) {
            self.scope.insert(format!("{name}_q{part}"), vec![turning]);
        }
        for (axis, spin) in ["x", "y", "z"].iter().zip(spin) {
            self.scope.insert(format!("{name}_w{axis}"), vec![spin]);
        }
    }

    /// Multiplies quaternions: a₀ b₀ − a·b and a₀ b + b₀ a + a × b.
    fn hamilton(&mut self, a: &[Jet], b: &[Jet]) -> Vec<Jet> {
        let inner = self.field.dot(&a[1..], &b[1..]);
        let scalar = self.field.multiply(&a[0], &b[0]);
        let mut product = vec![self.field.subtract(&scalar, &inner)];
        for (k, crossed) in self.cross(&a[1..], &b[1..]).into_iter().enumerate() {
            let [first, second] =
                [self.field.multiply(&a[0], &b[1 + k]), self.field.multiply(&b[0], &a[1 + k])];
            let sum = self.field.add(&first, &second);
            product.push(self.field.add(&sum, &crossed));
        }
        product
    }

    fn cross(&mut self, a: &[Jet], b: &[Jet]) -> Vec<Jet> {
        let component = |k: usize| {
            let (next, last) = ((k + 1) % 3, (k + 2) % 3);
            let [left, right] =
                [self.field.multiply(&a[next], &b[last]), self.field.multiply(&a[last], &b[next])];
            self.field.subtract(&left, &right)
        };
        (0..3).map(component).collect()
    }
}

/// Multiplies coefficients by τ.
fn shifted(zero: Real, series: &[Real]) -> Vec<Real> {
    let kept = series.len() - 1;
    std::iter::once(zero).chain(series[..kept].iter().cloned()).collect()
}
