//! Members for rigid bodies: their motions, and the items to draw.

use proc_macro2::TokenStream;
use quote::quote;

use super::items::{Values, body_of};
use crate::emit::base::docs;
use crate::emit::base::members::Members;
use crate::emit::base::method::{ArgumentNames, Arguments};
use crate::emit::base::shape::{Shape, local, motion_name};
use crate::emit::base::writer::MethodWriter;
use crate::model::{BodyMotion, DrawnItem, Product, SampledHeight, Scene};
use lagrange_expr::expr::Dependencies;
use lagrange_expr::expr::ExprId;
use lagrange_language::syntax::ast::Name;

/// Writes a method for each body, and the function body of `items`.
pub(in crate::emit) fn write_scene(writer: &mut MethodWriter<'_>) {
    let wants = |product| writer.model.products.contains(&product);
    let (moves, is_drawn) = (wants(Product::Motion), wants(Product::Drawing));
    let scene = writer.model.scene.clone();
    if moves {
        scene.motions.iter().for_each(|motion| write_motion(writer, motion));
    }
    if is_drawn {
        writer.members.items = Some(visits(writer, &scene));
    }
}

fn write_motion(writer: &mut MethodWriter<'_>, motion: &BodyMotion) {
    let (krate, dimension) = (writer.shape.krate, dimension(writer));
    let (body, counts) = writer
        .lowered(&motion.values, Arguments::State, |results| Values::new(results, dimension).motion(krate));
    let line = format!("Motion of the body `{}`.", motion.body.text);
    let docs = docs::with_counts(writer.shape.body_docs(&motion.body, &line), counts);
    writer.members.motions.extend(motion_method(
        writer.shape,
        &writer.members.names,
        &motion.body,
        &docs,
        &body,
    ));
}

fn visits(writer: &mut MethodWriter<'_>, scene: &Scene) -> TokenStream {
    let heights = scene.drawing.iter().filter_map(|item| item.height.as_ref());
    let heights = heights.map(|height| height_function(writer, height)).collect::<Vec<_>>();
    let roots = scene.drawing.iter().flat_map(|item| roots(scene, item)).collect::<Vec<_>>();
    let (krate, dimension) = (writer.shape.krate, dimension(writer));
    let visit = writer.members.names.visit.clone();
    let (body, _) = writer.lowered(&roots, Arguments::State, |results| {
        let mut values = Values::new(results, dimension);
        values.heights = heights.iter();
        let items = scene.drawing.iter().map(|item| values.item(krate, scene, item));
        quote!(#(#visit(#items);)*)
    });
    body
}

/// Returns a closure for the height of terrain over a place.
fn height_function(writer: &mut MethodWriter<'_>, height: &SampledHeight) -> TokenStream {
    let is_level = !writer.model.graph.dependencies(height.value).intersects(Dependencies::PLACEHOLDER);
    let place = if is_level { local("_") } else { writer.members.names.place.clone() };
    let scalar = writer.shape.scalar();
    let (body, _) =
        writer.lowered_as_declared(&[height.value], Arguments::State, |results| quote!(#(#results)*));
    quote!(&|#place: [#scalar; 2]| { #body })
}

/// Returns the number of components of vectors.
fn dimension(writer: &MethodWriter<'_>) -> usize {
    if writer.shape.declaration.is_in_space { 3 } else { 2 }
}

/// Returns the numbers of an item: for a body its motion, then its shape.
fn roots(scene: &Scene, item: &DrawnItem) -> Vec<ExprId> {
    let mut roots = body_of(scene, item).map_or_else(Vec::new, |(_, values)| values.to_vec());
    roots.extend(&item.values);
    roots.extend(item.parts.iter().flat_map(|part| &part.values));
    roots
}

/// Writes the method for the motion of a body, with this content.
pub(in crate::emit) fn motion_method(
    shape: &Shape<'_>,
    names: &ArgumentNames,
    body: &Name,
    docs: &TokenStream,
    content: &TokenStream,
) -> TokenStream {
    let (krate, scalar, name) = (shape.krate, shape.scalar(), motion_name(body));
    let [parameters, _] = Arguments::State.written(shape, names);
    let motion = local(if shape.declaration.is_in_space { "SpatialMotion" } else { "Motion" });
    quote! {
        #docs
        #[must_use]
        #[inline]
        pub fn #name(&self, #parameters) -> #krate::body::#motion<#scalar> {
            #content
        }
    }
}

/// Emits the implementation of `Scene`, if it is requested.
pub(in crate::emit) fn scene_impl(shape: &Shape<'_>, members: &Members) -> TokenStream {
    let Some(items) = &members.items else { return TokenStream::new() };
    let (name, generics, bounds, scalar) = (shape.name(), shape.generics(), shape.bounds(), shape.scalar());
    let (krate, visit) = (shape.krate, &members.names.visit);
    let [parameters, _] = Arguments::State.written(shape, &members.names);
    let space = local(if shape.declaration.is_in_space { "Spatial" } else { "Plane" });
    quote! {
        #[automatically_derived]
        impl #bounds #krate::scene::Scene for #name #generics {
            type Space = #krate::scene::#space;

            #[inline]
            fn items(
                &self,
                #parameters,
                #visit: &mut dyn ::core::ops::FnMut(#krate::scene::Item<'_, #scalar, #krate::scene::#space>),
            ) {
                #items
            }
        }
    }
}
