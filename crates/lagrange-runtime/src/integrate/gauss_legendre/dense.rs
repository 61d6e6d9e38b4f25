//! States within a step of a Gauss method.
//!
//! The polynomial through the stages is only accurate to the order K + 1 of h. For two and three
//! stages, states and rates at the ends are therefore used instead. Source: Hairer, Nørsett,
//! Wanner, *Solving Ordinary Differential Equations I*, §II.6.

use crate::integrate::fixed::WithinStep;
use crate::integrate::interpolation::{Motion, Place, cubic, quintic};
use crate::integrate::method::Work;
use crate::linalg::vector::combined;
use crate::scalar::{Number, Scalar};
use crate::system::{CanonicalSystem, OdeSystem, StateVector, join, split};

impl<M: CanonicalSystem + ?Sized> WithinStep<'_, M> {
    /// Computes the state in a step of the method with K stages, with an error of the order of the
    /// method.
    pub(super) fn canonical_state<const K: usize>(&self, work: &mut Work) -> M::State {
        match K {
            1 => self.linear(),
            2 => self.third_degree(work),
            _ => self.sixth_order(work),
        }
    }

    /// Interpolates coordinates by the quintic through states and accelerations at the ends.
    /// Velocities follow from these and from the accelerations at two intermediate points on the
    /// quintic. The error is O(h⁶).
    fn sixth_order(&self, work: &mut Work) -> M::State {
        work.evaluations += 4;
        let (WithinStep { system, from, to, .. }, Place { h, s }) = (self, self.place());
        let ((q0, v0), (q1, v1)) = (split::<M>(from.1), split::<M>(to.1));
        let (a0, a1) = (system.acceleration(from.0, &q0, &v0), system.acceleration(to.0, &q1, &v1));
        let change = combined(&q1, -M::Scalar::ONE, &q0);
        let motion = Motion { change, velocities: [v0, v1], accelerations: [a0, a1] };
        let moved = |s| {
            let (change, velocities) = quintic(Place { h, s }, &motion);
            (combined(&q0, M::Scalar::ONE, &change), velocities)
        };
        let [first, second] = thirds().map(|s| {
            let (q, v) = moved(s);
            system.acceleration(s.multiply_add(h, from.0), &q, &v)
        });
        join::<M>(&moved(s).0, &integrated([&v0, &v1], &[a0, first, second, a1], Place { h, s }))
    }
}

impl<M: OdeSystem + ?Sized> WithinStep<'_, M> {
    /// Computes the state like [`canonical_state`](Self::canonical_state) for a system whose
    /// velocities need not be rates of coordinates. For three stages the error is O(h⁵).
    pub(super) fn plain_state<const K: usize>(&self, work: &mut Work) -> M::State {
        match K {
            1 => self.linear(),
            2 => self.third_degree(work),
            _ => self.fifth_order(work),
        }
    }

    /// Interpolates linearly between the ends. The error is O(h²).
    fn linear(&self) -> M::State {
        let part = self.place().s;
        let mut y = *self.from.1;
        for (y, end) in y.as_mut().iter_mut().zip(self.to.1.as_ref()) {
            *y = (*end - *y).multiply_add(part, *y);
        }
        y
    }

    /// Interpolates by the cubic with the right rates at the ends. The error is O(h⁴).
    fn third_degree(&self, work: &mut Work) -> M::State {
        work.evaluations += 2;
        let [f0, f1] = self.rates();
        cubic(self.place(), self.states(), [&f0, &f1])
    }

    /// Interpolates from the states at both ends, with the rates there and at two intermediate
    /// points on the cubic. The error is O(h⁵).
    fn fifth_order(&self, work: &mut Work) -> M::State {
        work.evaluations += 4;
        let (ends, Place { h, s }, [f0, f1]) = (self.states(), self.place(), self.rates());
        let [first, second] = thirds().map(|s| {
            let y = cubic(Place { h, s }, ends, [&f0, &f1]);
            self.system.rhs(s.multiply_add(h, self.from.0), &y)
        });
        integrated(ends, &[f0, first, second, f1], Place { h, s })
    }
}

/// Returns one and two thirds.
fn thirds<S: Scalar>() -> [S; 2] {
    [1.0, 2.0].map(|number| S::from_f64(number) / S::from_f64(3.0))
}

/// Computes values from those at the ends and from their rates at zero, one, two and three thirds
/// of the step.
fn integrated<S: Scalar, Y: StateVector<S>>(ends: [&Y; 2], rates: &[Y; 4], place: Place<S>) -> Y {
    let mut result = *ends[0];
    for (i, (y, end)) in result.as_mut().iter_mut().zip(ends[1].as_ref()).enumerate() {
        *y = *y + integral(rates.each_ref().map(|rates| rates.as_ref()[i]), *end - *y, place);
    }
    result
}

/// Returns the change of a value up to the fraction s of a step over which it changes by `change`.
fn integral<S: Scalar>([f0, f1, f2, f3]: [S; 4], change: S, Place { h, s }: Place<S>) -> S {
    let n = S::from_f64;
    let (d1, d2) = (f1 - f0, (f2 - f1) - (f1 - f0));
    let d3 = ((f3 - f2) - (f2 - f1)) - d2;
    // Newton's formula, integrated over x, which is three times the fraction of the step.
    let cubic = |x: S| {
        let (second, third) = (x / n(6.0) - n(0.25), (x / n(24.0) - n(1.0) / n(6.0)) * x + n(1.0) / n(6.0));
        h / n(3.0) * x * (f0 + x * (d1 / n(2.0) + d2 * second + d3 * third))
    };
    let missing = change - cubic(n(3.0));
    // The quintic from zero to one that does not change the rates.
    let blend = s * s * (n(30.0) + s * (s * (n(135.0) - n(54.0) * s) - n(110.0)));
    cubic(n(3.0) * s) + missing * blend
}
