//! Elimination of accelerations and multipliers from a quadratic form.
//!
//! An unknown x stands in ½ D x² + (Σ wⱼ xⱼ + c) x. It is stationary at x = −(Σ wⱼ xⱼ + c) / D.
//! Inserting this leaves −½ (Σ wⱼ xⱼ + c)² / D in the other unknowns. D is the *pivot*, wⱼ / D are
//! the *factors*, and c is the *bias*.
//!
//! # Two masses in numbers
//!
//! Take two carts, the second at the distance y from the first, with T = ½ ẋ² + ½ (ẋ + ẏ)² and V =
//! 3 x + 5 y. With accelerations as unknowns, the form is ½ (2 x² + 2 x y + y²) + 3 x + 5 y. It
//! holds the mass matrix [2, 1; 1, 1] and minus the forcing.
//!
//! | step | pivot | factor | bias | what follows | what is left |
//! |---|---|---|---|---|---|
//! | x | 2 | 1/2 | 3 | x = −3/2 − y/2 | ½ (1 − 1/2) y² + (5 − 3/2) y |
//! | y | 1/2 | | 7/2 | y = −7 | |
//!
//! Substituted back, x = −3/2 + 7/2 = 2. These are the factors L and D of M = L D Lᵀ. They are
//! reused for other linear parts ([`record::Elimination::solve_again`]): (1, 0) instead of (3, 5)
//! gives (−1, 1), minus the first column of M⁻¹.
//!
//! # A mass on a slope in numbers
//!
//! Take a unit mass in the plane under g = 10 on the slope 4 y = 3 x. The constraint adds −λ (4 y −
//! 3 x) to the form, and with it an unknown without a square. The form is then ½ (x² + y²) + 10 y +
//! 3 λ x − 4 λ y.
//!
//! | step | pivot | bias | what is left |
//! |---|---|---|---|
//! | x | 1 | 0 | ½ y² + 10 y − 4 λ y − ½ 9 λ² |
//! | y | 1 | 10 | −½ (9 + 16) λ² + 40 λ |
//! | λ | −25 | 40 | |
//!
//! The velocities contribute the square −A M⁻¹ Aᵀ = −25 of λ, which has a maximum. Then λ = 40/25 =
//! 1.6, y = −10 + 4 λ = −3.6 and x = −3 λ = −4.8: down the slope with g · 3/5. Nothing else reduced
//! the square. Its ratio to the contribution of the velocities is therefore one, and the constraint
//! is fully independent.

pub(super) mod contracted;
pub(super) mod order;
pub(super) mod pivot;
mod queue;
pub(super) mod record;
pub(super) mod solution;

#[cfg(test)]
mod tests;
