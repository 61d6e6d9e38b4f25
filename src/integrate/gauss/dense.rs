//! States within a step of a Gauss method.
//!
//! The polynomial through the stages is accurate to the order K + 1 of h only, so that for two and three stages states
//! and rates at the ends serve better. Source: Hairer, Nørsett, Wanner, *Solving Ordinary Differential Equations I*,
//! §II.6.

use crate::integrate::interpolation;
use crate::scalar::Scalar;
use crate::system::{MechanicalSystem, OdeSystem, join, split};

/// A state with its time.
type Place<'a, M> = (<M as OdeSystem>::Scalar, &'a <M as OdeSystem>::State);

/// The state between the ends of a step of the method with K stages, with an error of the order of the method.
pub(super) fn between<M: MechanicalSystem + ?Sized, const K: usize>(
    system: &M,
    from: Place<'_, M>,
    to: Place<'_, M>,
    t: M::Scalar,
) -> M::State {
    match K {
        1 => linear::<M>(from, to, t),
        2 => cubic(system, from, to, t),
        _ => quintic(system, from, to, t),
    }
}

/// As [`between`], for a system without coordinates and velocities; for three stages the error is O(h⁵).
pub(super) fn plainly_between<M: OdeSystem + ?Sized, const K: usize>(
    system: &M,
    from: Place<'_, M>,
    to: Place<'_, M>,
    t: M::Scalar,
) -> M::State {
    match K {
        1 => linear::<M>(from, to, t),
        2 => cubic(system, from, to, t),
        _ => quartic(system, from, to, t),
    }
}

/// How many evaluations an interpolation for K stages takes.
pub(super) fn evaluations(stages: usize) -> u64 {
    match stages {
        1 => 0,
        2 => 2,
        _ => 4,
    }
}

/// The straight line between the ends. The error is O(h²).
fn linear<M: OdeSystem + ?Sized>(from: Place<'_, M>, to: Place<'_, M>, t: M::Scalar) -> M::State {
    let part = (t - from.0) / (to.0 - from.0);
    let mut y = *from.1;
    for (y, end) in y.as_mut().iter_mut().zip(to.1.as_ref()) {
        *y = (*end - *y).multiply_add(part, *y);
    }
    y
}

/// From states and rates at the ends. The error is O(h⁴).
fn cubic<M: OdeSystem + ?Sized>(system: &M, from: Place<'_, M>, to: Place<'_, M>, t: M::Scalar) -> M::State {
    let h = to.0 - from.0;
    let place = interpolation::Place { h, s: (t - from.0) / h };
    let rates = [from, to].map(|(t, y)| system.rhs(t, y));
    interpolation::cubic(place, [from.1, to.1], rates.each_ref())
}

/// From states and rates at the ends and from the rates at two places between, to which the former lead. The error is
/// O(h⁵).
fn quartic<M: OdeSystem + ?Sized>(
    system: &M,
    from: Place<'_, M>,
    to: Place<'_, M>,
    t: M::Scalar,
) -> M::State {
    let h = to.0 - from.0;
    let [first, second] = [1.0, 2.0].map(|thirds| {
        let time = (M::Scalar::from_f64(thirds) / M::Scalar::from_f64(3.0)).multiply_add(h, from.0);
        system.rhs(time, &cubic(system, from, to, time))
    });
    let rates = [system.rhs(from.0, from.1), first, second, system.rhs(to.0, to.1)];
    let mut y = *from.1;
    for (i, (y, end)) in y.as_mut().iter_mut().zip(to.1.as_ref()).enumerate() {
        let rates = rates.map(|rates| rates.as_ref()[i]);
        *y = *y + integral(rates, h, *end - *y, (t - from.0) / h);
    }
    y
}

/// Coordinates from states and accelerations at the ends, velocities from those and from the accelerations at two places
/// between, to which the former lead. The error is O(h⁶).
fn quintic<M: MechanicalSystem + ?Sized>(
    system: &M,
    from: Place<'_, M>,
    to: Place<'_, M>,
    t: M::Scalar,
) -> M::State {
    let h = to.0 - from.0;
    let s = (t - from.0) / h;
    let ((q0, v0), (q1, v1)) = (split::<M>(from.1), split::<M>(to.1));
    let (a0, a1) = (system.acceleration(from.0, &q0, &v0), system.acceleration(to.0, &q1, &v1));
    let ends = [(q0, v0, a0), (q1, v1, a1)];
    let [first, second] = [1.0, 2.0].map(|thirds| {
        let s = M::Scalar::from_f64(thirds) / M::Scalar::from_f64(3.0);
        let (q, v) = coordinates::<M>(&ends, h, s);
        system.acceleration(s.multiply_add(h, from.0), &q, &v)
    });
    let (q, _) = coordinates::<M>(&ends, h, s);
    let mut v = v0;
    for (i, v) in v.as_mut().iter_mut().enumerate() {
        let entry = |vector: &M::Coordinates| vector.as_ref()[i];
        let rates = [a0, first, second, a1].map(|a| entry(&a));
        *v = *v + integral(rates, h, entry(&v1) - entry(&v0), s);
    }
    join::<M>(&q, &v)
}

/// Coordinates at the part s of a step, and their rates, from coordinates, velocities and accelerations at both ends.
fn coordinates<M: MechanicalSystem + ?Sized>(
    [(q0, v0, a0), (q1, v1, a1)]: &[(M::Coordinates, M::Coordinates, M::Coordinates); 2],
    h: M::Scalar,
    s: M::Scalar,
) -> (M::Coordinates, M::Coordinates) {
    let n = M::Scalar::from_f64;
    let half = n(0.5);
    let (mut q, mut v) = (*q0, *v0);
    for (i, (q, v)) in q.as_mut().iter_mut().zip(v.as_mut()).enumerate() {
        let entry = |vector: &M::Coordinates| vector.as_ref()[i];
        let (rate, bend) = (h * entry(v0), half * h * h * entry(a0));
        // What the parabola from the start lacks at the end: in value, slope and curvature.
        let value = (entry(q1) - *q) - rate - bend;
        let slope = h * (entry(v1) - *v) - n(2.0) * bend;
        let curve = half * h * h * (entry(a1) - entry(a0));
        let c3 = n(10.0) * value - n(4.0) * slope + curve;
        let c4 = n(7.0) * slope - n(15.0) * value - n(2.0) * curve;
        let c5 = n(6.0) * value - n(3.0) * slope + curve;
        let rates = n(3.0) * c3 + s * (n(4.0) * c4 + s * (n(5.0) * c5));
        *v = *v + s * (n(2.0) * bend + s * rates) / h;
        *q = *q + s * (rate + s * (bend + s * (c3 + s * (c4 + s * c5))));
    }
    (q, v)
}

/// By how much a value changes up to the part s of a step over which it changes by `change`, from its rates at zero, one,
/// two and three thirds of it.
fn integral<S: Scalar>([f0, f1, f2, f3]: [S; 4], h: S, change: S, s: S) -> S {
    let n = S::from_f64;
    let (d1, d2) = (f1 - f0, (f2 - f1) - (f1 - f0));
    let d3 = ((f3 - f2) - (f2 - f1)) - d2;
    // Newton's formula, integrated over x, three times the part of the step.
    let cubic = |x: S| {
        let (second, third) = (x / n(6.0) - n(0.25), (x / n(24.0) - n(1.0) / n(6.0)) * x + n(1.0) / n(6.0));
        h / n(3.0) * x * (f0 + x * (d1 / n(2.0) + d2 * second + d3 * third))
    };
    let missing = change - cubic(n(3.0));
    // The quintic that leads from zero to one without changing the rates.
    let blend = s * s * (n(30.0) + s * (s * (n(135.0) - n(54.0) * s) - n(110.0)));
    cubic(n(3.0) * s) + missing * blend
}
