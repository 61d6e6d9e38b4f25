//! Methods of bodies and frames in space: poses of frames, their Jacobians and biases.

use proc_macro2::TokenStream;
use quote::quote;

use super::sparse::{Sparse, lowered_sparse};
use crate::derive::Equations;
use crate::emit::base::docs::with_counts;
use crate::emit::base::method::{Arguments, Method, Returns};
use crate::emit::base::shape::{Shape, doc, method_of};
use crate::emit::base::writer::MethodWriter;
use crate::model::BodyMethod;
use crate::model::LinkPose;
use lagrange_expr::expr::ExprId;
use lagrange_language::syntax::ast::Name;

/// Writes a method for each body or frame and each requested product.
pub(in crate::emit) fn write_frames(writer: &mut MethodWriter<'_>) {
    let scene = writer.model.scene.clone();
    scene.frames.iter().for_each(|frame| write_frame(writer, frame));
    let Equations { frame_jacobians, frame_biases, .. } = writer.equations;
    for (twist, (jacobian, bias)) in scene.twists.iter().zip(frame_jacobians.iter().zip(frame_biases)) {
        write_jacobian(writer, &twist.name, jacobian);
        write_bias(writer, &twist.name, bias);
    }
}

fn write_frame(writer: &mut MethodWriter<'_>, LinkPose { name, values }: &LinkPose) {
    let lines = [
        format!(
            "Pose of the frame of `{}` in the world: its rotation, in rows, whose columns are the axes of the frame,",
            name.text
        ),
        "and its origin.".to_owned(),
    ];
    let signature = (Arguments::Positions, Returns::Frame);
    push(writer, (name, BodyMethod::Frame), (&lines, "The origin is in m."), signature, values);
}

fn write_jacobian(writer: &mut MethodWriter<'_>, name: &Name, values: &[ExprId]) {
    let lines = [
        format!("Jacobian of the frame of `{}` by the generalised velocities, in the axes of the world: rows 0 to 2", name.text),
        "are those of its angular velocity, rows 3 to 5 those of the velocity of its origin. What time alone adds to".to_owned(),
        "these is left out.".to_owned(),
    ];
    let returns = Returns::Matrix(6, writer.shape.velocities.len());
    let units = "Rows are in rad/s, then in m/s, over the units of the velocities.";
    push(writer, (name, BodyMethod::Jacobian), (&lines, units), (Arguments::Positions, returns), values);
}

fn write_bias(writer: &mut MethodWriter<'_>, name: &Name, values: &[ExprId]) {
    let jacobian = method_of(name, BodyMethod::Jacobian);
    let lines = [
        format!(
            "Bias acceleration of the frame of `{}` in the axes of the world: its angular acceleration and the",
            name.text
        ),
        "acceleration of its origin at constant generalised velocities.".to_owned(),
        format!("`{jacobian}` times the generalised accelerations adds to them."),
    ];
    let signature = (Arguments::State, Returns::Vector(6));
    push(
        writer,
        (name, BodyMethod::BiasAcceleration),
        (&lines, "In rad/s^2, then in m/s^2."),
        signature,
        values,
    );
}

/// Lowers and adds a method. Units are stated if the declaration has any.
fn push(
    writer: &mut MethodWriter<'_>,
    (name, method): (&Name, BodyMethod),
    (lines, units): (&[String], &str),
    (arguments, returns): (Arguments, Returns),
    values: &[ExprId],
) {
    let (body, counts) = match Sparse::of(&writer.model.graph, returns, values) {
        Some(sparse) => lowered_sparse(writer, &sparse, arguments),
        None => writer.lowered(values, arguments, |results| returns.collect(results)),
    };
    let units = writer.shape.declaration.has_dimensions.then_some(["", units]);
    let lines = lines.iter().map(String::as_str).chain(units.into_iter().flatten());
    let own = lines.map(doc).collect::<TokenStream>();
    let docs = with_counts(described(writer.shape, name, own), counts);
    writer.members.methods.push(Method { name: method_of(name, method), docs, arguments, returns, body });
}

/// Appends the user's documentation.
fn described(shape: &Shape<'_>, name: &Name, own: TokenStream) -> TokenStream {
    let Some(users) = shape.user_docs(name) else { return own };
    let blank = doc("");
    quote!(#own #blank #users)
}
