//! Exponents of the base units for the kinds of quantities in mechanics.

pub(super) const MASS: [i8; 7] = [1, 0, 0, 0, 0, 0, 0];
pub(super) const LENGTH: [i8; 7] = [0, 1, 0, 0, 0, 0, 0];
pub(super) const TIME: [i8; 7] = [0, 0, 1, 0, 0, 0, 0];
pub(super) const FREQUENCY: [i8; 7] = [0, 0, -1, 0, 0, 0, 0];
pub(super) const FORCE: [i8; 7] = [1, 1, -2, 0, 0, 0, 0];
/// The dimension of energies and moments.
pub(super) const ENERGY: [i8; 7] = [1, 2, -2, 0, 0, 0, 0];
pub(super) const POWER: [i8; 7] = [1, 2, -3, 0, 0, 0, 0];
/// The dimension of a Gibbs function, the square of an acceleration times a mass.
pub(super) const GIBBS: [i8; 7] = [1, 2, -4, 0, 0, 0, 0];
