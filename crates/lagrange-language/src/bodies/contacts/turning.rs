//! Friction against rolling and spinning.
//!
//! Let ω be the angular velocity relative to the surface, with the tangents t₁ and t₂ and the
//! normal n. Rolling friction is a moment against (t₁·ω, t₂·ω) of at most ρ N for the normal
//! force N. Spinning friction is a moment against n·ω of at most ζ N. The coefficients ρ and ζ
//! are lengths. As with sliding friction, a body whose limit exceeds the load does not roll or
//! spin. In the plane, the only component of ω is that of rolling.
//!
//! A ball of radius r that rolls without slipping is slowed by ρ g/r · 5/7. The moment about its
//! point of contact is ρ m g, and its inertia there is 7/5 m r². One that spins in place loses ω at
//! ζ m g/(2/5 m r²).
//!
//! Source: Johnson, *Contact Mechanics*, §8.4 on rolling and §8.3 on spin; Leine, Glocker, *A
//! set-valued force law for spatial Coulomb–Contensou friction*, European Journal of Mechanics A 22
//! (2003), for moments of friction as forces of their own.

use super::coefficients::TurningCoefficients;
use super::geometry::{ContactGeometry, RelativeMotion, rolling_of, spinning_of};
use super::rub;
use crate::bodies::translation::Translation;
use crate::syntax::ast::{self, AstId};

/// Adds the moments against rolling and spinning, as far as there are coefficients.
pub(super) fn resist_turning(
    translation: &mut Translation<'_>,
    statement: &ast::Contact,
    (motion, geometry): (&RelativeMotion, &ContactGeometry),
    (coefficients, stiction): (TurningCoefficients, Option<AstId>),
) {
    let ast::Contact { name, frictions, .. } = statement;
    if let Some(coefficient) = coefficients.rolling {
        let rate = rolling_of(translation, motion, geometry);
        let rate = translation.bind(&format!("{}_turning", name.text), rate);
        let rates = (rate, translation.space.is_some());
        rub(translation, name, (&frictions.rolling, true), rates, ([coefficient; 2], stiction));
    }
    if let Some(coefficient) = coefficients.spinning {
        let rate = spinning_of(translation, motion, geometry);
        let rate = translation.bind(&format!("{}_spin", name.text), rate);
        rub(translation, name, (&frictions.spinning, true), (rate, false), ([coefficient; 2], stiction));
    }
}
