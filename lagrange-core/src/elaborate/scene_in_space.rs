//! Conversion of bodies and frames in space to the scene of a model.

use super::elaborator::{Elaborator, UNKNOWNS};
use super::expression::value_of;
use super::messages::scene;
use crate::model::BodyMotion;
use crate::model::LinkPose;
use crate::model::LinkTwist;
use crate::model::Product;
use lagrange_expr::expr::Dependencies;
use lagrange_expr::expr::ExprId;
use lagrange_language::bodies::FramePose;
use lagrange_language::bodies::FrameTwist;
use lagrange_language::bodies::SpatialKinematics;
use lagrange_language::bodies::SpatialMotion;
use lagrange_language::syntax::ast::AstId;
use lagrange_language::syntax::ast::Name;

/// Adds the requested quantities to the model.
pub(super) fn add_scene_in_space(elaborator: &mut Elaborator<'_>, kinematics: &SpatialKinematics) {
    let SpatialKinematics { motions, frames, twists } = kinematics;
    for motion in motions {
        let found = spatial_motion(elaborator, motion);
        elaborator.scene.motions.extend(found);
    }
    for frame in frames {
        let found = frame_pose(elaborator, frame);
        elaborator.scene.frames.extend(found);
    }
    for twist in twists {
        let found = link_twist(elaborator, twist);
        elaborator.scene.twists.extend(found);
    }
}

fn spatial_motion(elaborator: &mut Elaborator<'_>, motion: &SpatialMotion) -> Option<BodyMotion> {
    let [xx, yy, zz, xy, xz, yz] = motion.tensor;
    let inertia = [xx, xy, xz, xy, yy, yz, xz, yz, zz];
    let [center, velocity, acceleration] = motion.center;
    let [spin, change] = motion.turning;
    let mut syntax = vec![motion.mass];
    syntax.extend(inertia);
    for vectors in
        [&[motion.centroid, center][..], &rows(motion.axes), &[velocity, spin, acceleration, change]]
    {
        syntax.extend(vectors.iter().flatten());
    }
    let values: [ExprId; BodyMotion::VALUES[1]] = scalars(elaborator, &syntax)?;
    Some(BodyMotion { body: motion.body.clone(), values: values.into() })
}

fn frame_pose(elaborator: &mut Elaborator<'_>, frame: &FramePose) -> Option<LinkPose> {
    let mut syntax = rows(frame.axes).concat();
    syntax.extend(frame.origin);
    let values = scalars(elaborator, &syntax)?;
    let is_place = !depends(elaborator, &values, &[&[Dependencies::VELOCITY], UNKNOWNS].concat());
    if !is_place {
        report_place(elaborator, &frame.name);
    }
    is_place.then(|| LinkPose { name: frame.name.clone(), values })
}

/// Returns the twist of a frame. Velocities in its position would turn into accelerations.
fn link_twist(elaborator: &mut Elaborator<'_>, twist: &FrameTwist) -> Option<LinkTwist> {
    let syntax = [&twist.spin[..], &twist.velocity].concat();
    let values = scalars(elaborator, &syntax)?;
    let is_affine = !depends(elaborator, &values, UNKNOWNS);
    // It has been reported together with the place of the frame.
    if !is_affine && !elaborator.products().contains(&Product::Frames) {
        report_place(elaborator, &twist.name);
    }
    is_affine.then(|| LinkTwist { name: twist.name.clone(), values })
}

/// Returns the rows of the matrix with these axes as columns.
fn rows(axes: [[AstId; 3]; 3]) -> [[AstId; 3]; 3] {
    [0, 1, 2].map(|row| axes.map(|axis| axis[row]))
}

/// Returns the values of scalars; missing ones have been reported.
fn scalars<const N: usize>(elaborator: &mut Elaborator<'_>, syntax: &[AstId]) -> Option<[ExprId; N]> {
    let mut values = Vec::with_capacity(syntax.len());
    for &id in syntax {
        values.extend(value_of(&mut elaborator.evaluator, id)?.components());
    }
    values.try_into().ok()
}

fn depends(elaborator: &Elaborator<'_>, values: &[ExprId], kinds: &[Dependencies]) -> bool {
    let graph = &elaborator.evaluator.graph;
    values.iter().any(|&value| kinds.iter().any(|&kind| graph.dependencies(value).intersects(kind)))
}

/// Reports a frame whose place is not a function of time and coordinates.
fn report_place(elaborator: &mut Elaborator<'_>, name: &Name) {
    let error = elaborator.evaluator.report.error(name.span, scene::place_with_velocities(&name.text));
    error.help(scene::PLACE_WITH_VELOCITIES_HELP);
}
