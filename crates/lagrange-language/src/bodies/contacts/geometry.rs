//! Gaps and slip velocities.
//!
//! A body touches at a point c with the radius r about it. The surface has the normal n on its free
//! side, and orthogonal tangents with t₁ × t₂ = n. The gap is n·(c − p) − r for a plane through p.
//! For a circle or sphere of radius R about p, it is |c − p| − R − r outside and R − r −
//! |c − p| inside, with n along ±(c − p). For a cylinder, c − p is taken across its axis.
//!
//! The slip velocity is that of the material points at c − r n. Let u be the velocity at c and ω
//! the angular velocity, of the body minus those of the carrier. Its components are t₁·u − r t₂·ω
//! and t₂·u + r t₁·ω, because t·(ω × n) = ω·(n × t). In the plane, t₂ = −e_z, and the slip velocity
//! is t₁·u + r ω.
//!
//! The body rolls with the components t₁·ω and t₂·ω, and spins with n·ω.
//!
//! Terrain is in a separate file.
//!
//! A disk of radius 0.2 that rotates at −3 rad/s and moves at 1 m/s along the ground slips at 1 +
//! 0.2 · (−3) = 0.4 m/s.
//!
//! Source: Pfeiffer, Glocker, *Multibody Dynamics with Unilateral Contacts*, ch. 4.

use crate::bodies::object::Surface;
use crate::bodies::plain::Obligation;
use crate::bodies::space::vectors::{Triple, cross, inner, minus, plus, scale, unit};
use crate::bodies::surfaces::{bind_vector, scene_vector, tangents_of};
use crate::bodies::terms::TermWriter;
use crate::bodies::touching::{Touching, motion_at, rate_of};
use crate::bodies::translation::Translation;
use crate::syntax::ast::{self, AstId, SurfaceKind};

/// Geometry of a contact in the world.
pub(super) struct ContactGeometry {
    pub(super) center: Triple,
    pub(super) radius: AstId,
    pub(super) gap: AstId,
    pub(super) normal: Triple,
    pub(super) tangents: [Triple; 2],
    /// Velocity of the touched surface, in addition to that of its carrier.
    pub(super) rising: Option<Triple>,
}

/// Computes gap, normal and tangents at a point with a radius.
pub(super) fn geometry(
    translation: &mut Translation<'_>,
    statement: &ast::Contact,
    surface: &Surface,
    (center, radius): (Triple, AstId),
) -> ContactGeometry {
    let (&Surface { kind, direction: normal, tangents, .. }, rising) = (surface, None);
    let mut terms = translation.terms();
    let arm = minus(&mut terms, center, surface.place);
    if let SurfaceKind::Line | SurfaceKind::Plane = kind {
        let height = inner(&mut terms, normal, arm);
        let gap = terms.minus(height, radius);
        return ContactGeometry { center, radius, gap, normal, tangents, rising };
    }
    let (distance, outward) = away_from(translation, statement, surface, arm);
    let mut terms = translation.terms();
    let (gap, normal) = match statement.is_inside {
        true => {
            let room = terms.minus(surface.radius, radius);
            (terms.minus(room, distance), outward.map(|component| terms.negative(component)))
        }
        false => {
            let sum = terms.plus(surface.radius, radius);
            (terms.minus(distance, sum), outward)
        }
    };
    let normal = bind_vector(translation, &format!("{}_normal", statement.name.text), normal);
    let is_spatial = translation.space.is_some();
    let mut terms = translation.terms();
    let tangents = match surface.kind {
        SurfaceKind::Cylinder => [surface.direction, cross(&mut terms, normal, surface.direction)],
        _ => tangents_at(&mut terms, is_spatial, normal),
    };
    ContactGeometry { center, radius, gap, normal, tangents, rising }
}

/// Returns the distance from the centre or axis of a round surface, and the direction away from it.
fn away_from(
    translation: &mut Translation<'_>,
    statement: &ast::Contact,
    surface: &Surface,
    arm: Triple,
) -> (AstId, Triple) {
    let name = &statement.name.text;
    let mut terms = translation.terms();
    let arm = match surface.kind {
        SurfaceKind::Cylinder => {
            let along = inner(&mut terms, surface.direction, arm);
            let along = scale(&mut terms, along, surface.direction);
            minus(&mut terms, arm, along)
        }
        _ => arm,
    };
    let arm = bind_vector(translation, &format!("{name}_arm"), arm);
    let whole = scene_vector(translation, arm);
    let distance = translation.terms().call("norm", &[whole]);
    let distance = translation.bind(&format!("{name}_distance"), distance);
    if statement.compliance.way().is_some() {
        let contact = statement.name.clone();
        translation.obligations.push(Obligation::Apart { contact, distance });
    }
    let mut terms = translation.terms();
    (distance, arm.map(|component| terms.divide(component, distance)))
}

/// Returns the tangents of a curved surface where it has this normal.
pub(super) fn tangents_at(terms: &mut TermWriter<'_>, is_spatial: bool, normal: Triple) -> [Triple; 2] {
    if is_spatial {
        return tangents_of(terms, normal);
    }
    let [x, y, zero] = normal;
    let down = unit(terms, 2).map(|component| terms.negative(component));
    [[y, terms.negative(x), zero], down]
}

/// The motion of a body at the centre of a contact, relative to the surface.
pub(super) struct RelativeMotion {
    velocity: Triple,
    spin: Triple,
}

/// Computes the motion of a body relative to the surface.
pub(super) fn relative_motion(
    translation: &mut Translation<'_>,
    surface: &Surface,
    touching: &Touching,
    geometry: &ContactGeometry,
) -> RelativeMotion {
    let (of_surface, turning) = match surface.carrier {
        Some(carrier) => motion_at(translation, carrier, touching.center),
        None => motion_of_surface(translation, surface, touching.center),
    };
    let mut terms = translation.terms();
    let of_surface = geometry.rising.map_or(of_surface, |rising| plus(&mut terms, of_surface, rising));
    let velocity = minus(&mut terms, touching.velocity, of_surface);
    let spin = minus(&mut terms, touching.spin, turning);
    RelativeMotion { velocity, spin }
}

/// Computes the slip velocity, in space along both tangents.
pub(super) fn slip_of(
    translation: &mut Translation<'_>,
    &RelativeMotion { velocity, spin }: &RelativeMotion,
    geometry: &ContactGeometry,
) -> AstId {
    let is_spatial = translation.space.is_some();
    let mut terms = translation.terms();
    let &ContactGeometry { radius, tangents: [first, second], .. } = geometry;
    let along = inner(&mut terms, first, velocity);
    let rolling = rolling_part(&mut terms, radius, second, spin);
    let slip = terms.minus(along, rolling);
    if !is_spatial {
        return slip;
    }
    let across = inner(&mut terms, second, velocity);
    let rolling = rolling_part(&mut terms, radius, first, spin);
    let across = terms.plus(across, rolling);
    terms.tuple([slip, across])
}

/// Computes the angular velocity of rolling: in space along both tangents, in the plane its only
/// component.
pub(super) fn rolling_of(
    translation: &mut Translation<'_>,
    &RelativeMotion { spin, .. }: &RelativeMotion,
    geometry: &ContactGeometry,
) -> AstId {
    if translation.space.is_none() {
        return spin[2];
    }
    let mut terms = translation.terms();
    let rates = geometry.tangents.map(|tangent| inner(&mut terms, tangent, spin));
    terms.tuple(rates)
}

/// Computes the angular velocity about the normal.
pub(super) fn spinning_of(
    translation: &mut Translation<'_>,
    motion: &RelativeMotion,
    geometry: &ContactGeometry,
) -> AstId {
    inner(&mut translation.terms(), geometry.normal, motion.spin)
}

/// Returns the velocity at a place of a surface that no body carries, and its angular velocity. Its
/// place or angle may depend on time or coordinates.
fn motion_of_surface(
    translation: &mut Translation<'_>,
    surface: &Surface,
    center: Triple,
) -> (Triple, Triple) {
    let rates = surface.place.map(|component| rate_of(translation, component));
    let mut terms = translation.terms();
    let zero = terms.number(0);
    let spin = [zero, zero, surface.turning];
    let arm = minus(&mut terms, center, surface.place);
    let turning = cross(&mut terms, spin, arm);
    (plus(&mut terms, rates, turning), spin)
}

/// Returns r t·ω.
fn rolling_part(terms: &mut TermWriter<'_>, radius: AstId, tangent: Triple, spin: Triple) -> AstId {
    let rate = inner(terms, tangent, spin);
    terms.times(radius, rate)
}
