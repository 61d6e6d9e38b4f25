//! The linear equations of an iteration with constraints, for velocities at both ends of a step and
//! multipliers at its start and in its middle.

use crate::integrate::canonical::{Derivatives, Pencil, factors, stiffened, stiffness};
use crate::integrate::variational::linearised::{Linearised, turned};
use crate::linalg::pivoted::Matrix;
use crate::linalg::ranked::RankedFactors;
use crate::linalg::vector::{add, dot};
use crate::scalar::{Number, Scalar};
use crate::system::{
    CanonicalSystem, ConstraintValues, MechanicalSystem, OdeSystem, StateVector, StepFailure, Vector, join,
    split,
};

type Square<M> = <<M as MechanicalSystem>::Coordinates as StateVector<<M as OdeSystem>::Scalar>>::Square;

/// The constraints at a place.
pub(super) type AtPlace<M> = ConstraintValues<<M as OdeSystem>::Scalar, <M as MechanicalSystem>::Coordinates>;

/// Weights of the velocities at the start, in the middle and at the end of a step. They yield the
/// change of coordinates in its first half, and in the whole step.
pub(super) const PARTS: [[f64; 3]; 2] =
    [[5.0 / 24.0, 1.0 / 3.0, -1.0 / 24.0], [1.0 / 6.0, 2.0 / 3.0, 1.0 / 6.0]];

/// Weights of the velocities at both ends in the parabola.
pub(super) const PARABOLA: [[f64; 2]; 2] = [[0.375, 0.125], [0.5, 0.5]];

/// Weights of the constraint forces at the start and in the middle in the two equations of a step,
/// in units of its length.
pub(super) const FORCES: [[f64; 2]; 2] = [[1.0 / 6.0, 0.0], [1.0 / 6.0, 1.0]];

/// The factors of the equations, by blocks.
#[derive(Debug)]
pub(super) struct Coupled<M: CanonicalSystem + ?Sized> {
    linearised: Linearised<M::Scalar, M::Coordinates>,
    /// The weight of AᵀA that replaces missing inertia.
    stiffness: M::Scalar,
    /// The constraints at the start, in the middle and at the end.
    places: [AtPlace<M>; 3],
    /// Changes of the velocities at both ends per multiplier at the start and in the middle.
    moved: [[Square<M>; 2]; 2],
    /// Changes of all constraints per multiplier, first in the first half and then in the whole
    /// step.
    mobility: RankedFactors<M::Scalar, M::State>,
}

impl<M: CanonicalSystem + ?Sized> Coupled<M> {
    pub(super) fn new(
        pencil: &Derivatives<M>,
        places: [AtPlace<M>; 3],
        h: M::Scalar,
    ) -> Result<Self, StepFailure<M::Scalar>> {
        let (linearised, stiffness) = linearised::<M>(pencil, &places[1])?;
        let moved = moved::<M>(&linearised, &places, h);
        let count = places[0].count();
        let mut mobility = Matrix::<M::Scalar, M::State>(M::State::ZERO_SQUARE);
        for k in 0..2 {
            for i in 0..count {
                let ends = [moved[k][0].as_ref()[i], moved[k][1].as_ref()[i]];
                let demands = demands::<M>(&places, &ends);
                for (row, demand) in demands.as_ref().iter().enumerate().take(2 * count) {
                    mobility[(row, k * count + i)] = *demand;
                }
            }
        }
        let mobility = RankedFactors::new(mobility, 2 * count).ok_or(StepFailure::NotFinite)?;
        Ok(Coupled { linearised, stiffness, places, moved, mobility })
    }

    /// Returns the corrections of velocities and multipliers for the residuals of the equations and
    /// of the constraints.
    #[inline]
    pub(super) fn solve(&self, residual: &[M::State; 2]) -> [M::State; 2] {
        let [(first, half), (second, whole)] = residual.each_ref().map(split::<M>);
        let mut forces = turned(&[first, second]);
        if self.stiffness != M::Scalar::ZERO {
            self.stiffen(&mut forces, [&half, &whole]);
        }
        let mut ends = self.linearised.solve_turned(&forces);
        let multipliers = self.mobility.solve(&self.missing([&half, &whole], &ends));
        let (count, all) = (self.places[0].count(), multipliers.as_ref());
        let mut shares = [Vector::<M>::ZERO; 2];
        for (k, (share, moved)) in shares.iter_mut().zip(&self.moved).enumerate() {
            for i in 0..count {
                let multiplier = all[k * count + i];
                share.as_mut()[i] = multiplier;
                for (end, moved) in ends.iter_mut().zip(moved) {
                    add(end, multiplier, &moved.as_ref()[i]);
                }
            }
        }
        [join::<M>(&ends[0], &shares[0]), join::<M>(&ends[1], &shares[1])]
    }

    /// Returns the constraint residuals that remain after these changes of velocities.
    fn missing(&self, [half, whole]: [&M::Coordinates; 2], ends: &[M::Coordinates; 2]) -> M::State {
        let count = self.places[0].count();
        let mut missing = demands::<M>(&self.places, ends);
        let wanted = half.as_ref()[..count].iter().chain(&whole.as_ref()[..count]);
        for (missing, wanted) in missing.as_mut().iter_mut().zip(wanted) {
            *missing = *wanted - *missing;
        }
        missing
    }

    /// Adds ρ Aᵀ times the product of A with each velocity. These products follow from those in
    /// both parts of the step.
    fn stiffen(&self, forces: &mut [M::Coordinates; 2], [half, whole]: [&M::Coordinates; 2]) {
        let middle = &self.places[1];
        let (half, whole) = (middle.force(half), middle.force(whole));
        // The inverse of `PARABOLA`.
        for (force, (first, second)) in forces.iter_mut().zip([(4.0, -1.0), (-4.0, 3.0)]) {
            add(force, self.stiffness * M::Scalar::from_f64(first), &half);
            add(force, self.stiffness * M::Scalar::from_f64(second), &whole);
        }
    }
}

/// Factors of the equations without constraints, and the weight ρ of the added stiffness.
type Stiffened<M> =
    (Linearised<<M as OdeSystem>::Scalar, <M as MechanicalSystem>::Coordinates>, <M as OdeSystem>::Scalar);

/// Returns the factors of the equations without constraints, with stiffness that replaces missing
/// inertia.
fn linearised<M: CanonicalSystem + ?Sized>(
    pencil: &Derivatives<M>,
    middle: &AtPlace<M>,
) -> Result<Stiffened<M>, StepFailure<M::Scalar>> {
    if let Some(linearised) = Linearised::new(pencil) {
        return Ok((linearised, M::Scalar::ZERO));
    }
    let stiffness = stiffness(&pencil.constant, middle);
    let constant = stiffened(&pencil.constant, middle, stiffness);
    match Linearised::new(&Pencil { constant: constant.clone(), derivatives: pencil.derivatives.clone() }) {
        Some(linearised) => Ok((linearised, stiffness)),
        None => Err(factors(&constant).err().unwrap_or(StepFailure::NotFinite)),
    }
}

/// Returns the changes of the velocities at both ends per multiplier at the start and in the
/// middle.
fn moved<M: CanonicalSystem + ?Sized>(
    linearised: &Linearised<M::Scalar, M::Coordinates>,
    places: &[AtPlace<M>; 3],
    h: M::Scalar,
) -> [[Square<M>; 2]; 2] {
    let mut moved = [(); 2].map(|()| [Vector::<M>::ZERO_SQUARE, Vector::<M>::ZERO_SQUARE]);
    for ((moved, place), parts) in moved.iter_mut().zip(places).zip(FORCES) {
        for (i, row) in place.rows().enumerate() {
            let loads = parts.map(|part| {
                let mut load = Vector::<M>::ZERO;
                add(&mut load, h * M::Scalar::from_f64(part), row);
                load
            });
            for (moved, end) in moved.iter_mut().zip(linearised.solve(&loads)) {
                moved.as_mut()[i] = end;
            }
        }
    }
    moved
}

/// Returns the changes of the constraints due to velocities at both ends. They are for the first
/// half and the whole of a step of length one.
fn demands<M: CanonicalSystem + ?Sized>(places: &[AtPlace<M>; 3], ends: &[M::Coordinates; 2]) -> M::State {
    let (mut demands, count) = (M::State::ZERO, places[0].count());
    for (part, (parabola, parts)) in PARABOLA.iter().zip(PARTS).enumerate() {
        let moved = combined(&[parabola[0], parabola[1]], ends);
        let middle = combined(&[0.5, 0.5], ends);
        for i in 0..count {
            let demand = if places[0].is_holonomic(i) {
                dot(places[part + 1].row(i), &moved)
            } else {
                let rates = [&ends[0], &middle, &ends[1]];
                let terms = parts.into_iter().zip(places).zip(rates);
                terms.fold(M::Scalar::ZERO, |sum, ((part, place), rate)| {
                    M::Scalar::from_f64(part).multiply_add(dot(place.row(i), rate), sum)
                })
            };
            demands.as_mut()[part * count + i] = demand;
        }
    }
    demands
}

/// Computes Σ parts vectors.
#[inline]
pub(super) fn combined<S: Scalar, Q: StateVector<S>, const K: usize>(
    parts: &[f64; K],
    vectors: &[Q; K],
) -> Q {
    let mut sum = Q::ZERO;
    for (part, vector) in parts.iter().zip(vectors) {
        add(&mut sum, S::from_f64(*part), vector);
    }
    sum
}
