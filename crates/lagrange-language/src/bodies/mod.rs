//! Translation of rigid bodies to statements of the plain language: here in the plane, in `space`
//! those in space.
//!
//! A body becomes its kinetic energy ½ m |ċ|² + ½ J φ̇² and its potential energy −m g·c. Springs,
//! dampers and joints become energies, Rayleigh functions and constraints of points on bodies.
//! Contacts become events with an impact and friction, or energies and forces if they have a
//! stiffness. [`plain()`] writes all of this as syntax before names are resolved. Later phases are
//! therefore independent of bodies, and the plain statements can be shown to the user. Nothing is
//! simplified or differentiated here. Bodies whose mass changes also have loads
//! (`changing_mass`).
//!
//! Hand-written energies can be combined with those of bodies, and a scene costs as much as the
//! same system by hand, which `tests/bodies` verifies. Errors point at the user's text. A
//! constraint of a joint that is proved to be zero is omitted.
//!
//! Motions, frames and drawings have expressions in addition to the statements ([`Plain`]).
//! `elaborate::scene` evaluates them only if `emit` requests them. They are emitted as values of
//! `lagrange::body` and `lagrange::scene`, which every build has; pictures are behind the feature
//! `draw`. A drawing contains every load that is declared with bodies. `tests/laws/scenes.rs` and
//! `tests/api/axiom.rs` check it against F = m a and the axiom of angular momentum,
//! `tests/spatial/drawing.rs` and `tests/api/spatial_axiom.rs` in space. On a free body the drawing
//! adds the resultant of unnamed loads, m a − Σ F, from the motion. In space a load on the
//! coordinate of a joint acts along its axis (`space::motors`). In the plane, torques on angles
//! find their bodies by proof (`elaborate::torques`). Joints without multipliers, and torques that
//! match no body or several, are listed as omitted and named below the picture.
//!
//! Source of the formulas: any textbook of plane rigid-body mechanics, such as Meriam, Kraige, *Engineering
//! Mechanics: Dynamics*, ch. 5 and 6.

mod body;
mod changing_mass;
mod compound;
mod connectors;
mod constants;
mod contacts;
mod corners;
mod drawing;
mod expressions;
mod gravity;
mod inertial;
mod joints;
mod kinematics;
mod lines;
mod mass_geometry;
mod messages;
mod mobilizers;
mod names;
mod object;
mod plain;
mod space;
mod statements;
mod surfaces;
mod terms;
mod touching;
mod translation;
mod unneeded;

use crate::syntax::ast::Declaration;
use lagrange_expr::diagnostics::Report;
use names::report_repeated;
use statements::translate;
use translation::Translation;

pub use plain::{
    Drawn, DrawnKind, FramePose, FrameTwist, InertialBody, JointForm, LoadOrigin, Motion, Obligation,
    Outline, Plain, SpatialJointForm, SpatialKinematics, SpatialMotion,
};

/// Replaces statements about bodies by plain statements. Errors are reported.
pub fn plain(mut declaration: Declaration, report: &mut Report) -> Plain {
    report_repeated(&declaration, report);
    let translation = Translation::new(&mut declaration, report);
    translate(translation, declaration)
}
