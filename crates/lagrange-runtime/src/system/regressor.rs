//! Systems that provide the regressor of their inverse dynamics.

use super::MechanicalSystem;

/// A system with the regressor of its inverse dynamics. Emitted types implement it if the
/// declaration has `emit { regressor }`.
///
/// The inverse dynamics is τ = Y(t, q, v, a) π + τ₀. It is linear in parameters π, such as masses,
/// first moments and moments of inertia of bodies, friction and stiffness. The rest τ₀ does not
/// depend on them. Source: Khalil, Dombre, *Modeling, Identification and Control of
/// Robots*, §12.6.
///
/// ```
/// use lagrange::system::RegressorSystem;
///
/// lagrange::system! {
///     /// A rod on a hinge with friction.
///     struct Rod;
///     param m = 2.0, l = 1.5, c = 0.1;
///     gravity = (0, -10);
///     body rod { mass: m; shape: slender_rod(l); centroid: (l/2, 0); inertia: m*l^2/12; }
///     revolute phi = ground to rod { damping: c; }
///     emit { regressor }
/// }
///
/// let rod = Rod::default();
/// assert_eq!(Rod::REGRESSOR_PARAMETERS, ["rod.mx", "rod.my", "rod.zz", "c"]);
/// assert_eq!(rod.regressor_parameters(), [1.5, 0.0, 1.5, 0.1]);
/// // Horizontal: the moments of the weight about the hinge, the angular acceleration, the velocity.
/// assert_eq!(rod.regressor(0.0, &[0.0], &[2.0], &[3.0]), [[10.0, 0.0, 3.0, 2.0]]);
/// assert_eq!(rod.inverse_dynamics(0.0, &[0.0], &[2.0], &[3.0]), [15.0 + 4.5 + 0.2]);
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` does not know the regressor of its inverse dynamics",
    note = "add `emit {{ regressor }}` to the declaration"
)]
pub trait RegressorSystem: MechanicalSystem {
    /// A row of the regressor, with one entry for each parameter, such as `[S; K]`.
    type Row: AsRef<[Self::Scalar]>;
    /// The regressor in rows, one for each velocity, such as `[[S; K]; N]`.
    type Regressor: AsRef<[Self::Row]>;

    /// Names of the parameters: `boom.mass` for a body, `c` for a declared parameter.
    const REGRESSOR_PARAMETERS: &'static [&'static str];

    /// Computes the regressor Y, in rows.
    fn regressor(
        &self,
        t: Self::Scalar,
        q: &Self::Coordinates,
        v: &Self::Velocities,
        a: &Self::Velocities,
    ) -> Self::Regressor;

    /// Returns the present parameters π.
    fn regressor_parameters(&self) -> Self::Row;

    /// Computes the inverse dynamics τ.
    fn inverse_dynamics(
        &self,
        t: Self::Scalar,
        q: &Self::Coordinates,
        v: &Self::Velocities,
        a: &Self::Velocities,
    ) -> Self::Velocities;
}
