//! Members for rigid bodies: how each moves, and what there is to draw.

use std::slice::Iter;

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use crate::bodies::{DrawnKind, JointForm, LoadOrigin};
use crate::emit::base::docs;
use crate::emit::base::members::Members;
use crate::emit::base::method::{ArgumentNames, Arguments};
use crate::emit::base::shape::{Shape, local, motion_name};
use crate::emit::base::writer::MethodWriter;
use crate::expr::ExprId;
use crate::model::{BodyMotion, DrawnItem, OutlinedPart, Product, Scene};
use crate::syntax::ast::{ConnectorKind, Name};

/// A method for each body, and the body of `Scene::items`.
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
    let krate = writer.shape.krate;
    let (body, counts) =
        writer.lowered(&motion.values, Arguments::State, |results| Values::new(results).motion(krate));
    let line = format!("How the body `{}` moves.", motion.body.text);
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
    let roots = scene.drawing.iter().flat_map(|item| roots(scene, item)).collect::<Vec<_>>();
    let (krate, visit) = (writer.shape.krate, writer.members.names.visit.clone());
    let (body, _) = writer.lowered(&roots, Arguments::State, |results| {
        let mut values = Values::new(results);
        let items = scene.drawing.iter().map(|item| values.item(krate, scene, item));
        quote!(#(#visit(#items);)*)
    });
    body
}

/// The numbers of an item: for a body how it moves, then its shape.
fn roots(scene: &Scene, item: &DrawnItem) -> Vec<ExprId> {
    let mut roots = body_of(scene, item).map_or_else(Vec::new, |motion| motion.values.to_vec());
    roots.extend(&item.values);
    roots.extend(item.parts.iter().flat_map(|part| &part.values));
    roots
}

fn body_of<'a>(scene: &'a Scene, item: &DrawnItem) -> Option<&'a BodyMotion> {
    match item.kind {
        DrawnKind::Body { body, .. } => scene.motions.get(body),
        _ => None,
    }
}

/// Results of a program, taken one after another.
struct Values<'a> {
    rest: Iter<'a, TokenStream>,
}

impl<'a> Values<'a> {
    fn new(results: &'a [TokenStream]) -> Values<'a> {
        Values { rest: results.iter() }
    }

    fn scalar(&mut self) -> TokenStream {
        let missing = || quote!(::core::compile_error!("a number of this scene is missing"));
        self.rest.next().cloned().unwrap_or_else(missing)
    }

    fn vector(&mut self) -> TokenStream {
        let (x, y) = (self.scalar(), self.scalar());
        quote!([#x, #y])
    }

    fn motion(&mut self, krate: &TokenStream) -> TokenStream {
        let (mass, inertia, centroid) = (self.scalar(), self.scalar(), self.vector());
        let (center, angle) = (self.vector(), self.scalar());
        let (velocity, angular_velocity) = (self.vector(), self.scalar());
        let (acceleration, angular_acceleration) = (self.vector(), self.scalar());
        quote! {
            #krate::body::Motion {
                mass: #mass,
                inertia: #inertia,
                centroid: #centroid,
                center: #center,
                angle: #angle,
                velocity: #velocity,
                angular_velocity: #angular_velocity,
                acceleration: #acceleration,
                angular_acceleration: #angular_acceleration,
            }
        }
    }

    fn item(&mut self, krate: &TokenStream, scene: &Scene, item: &DrawnItem) -> TokenStream {
        let content = match &item.kind {
            DrawnKind::Body { .. } => {
                let name = body_of(scene, item).map_or("", |motion| motion.body.text.as_str());
                let motion = self.motion(krate);
                let parts = item.parts.iter().map(|part| self.part(krate, part));
                quote!(Body { name: #name, motion: #motion, parts: &[#(#parts),*] })
            }
            DrawnKind::Line { name, body } => {
                let (body, through, angle) = (option(body.as_deref()), self.vector(), self.scalar());
                quote!(Line { name: #name, body: #body, through: #through, angle: #angle })
            }
            DrawnKind::Connector { name, kind } => {
                let kind = connector(*kind);
                let (from, to, tension) = (self.vector(), self.vector(), self.scalar());
                quote! {
                    Connector {
                        name: #name,
                        kind: #krate::scene::Connector::#kind,
                        from: #from,
                        to: #to,
                        tension: #tension,
                    }
                }
            }
            DrawnKind::Joint { name, kind } => {
                let (kind, at) = (joint(*kind), self.vector());
                quote!(Joint { name: #name, kind: #krate::scene::Joint::#kind, at: #at })
            }
            DrawnKind::Force { name, cause: from, body } => {
                let acts = acts(krate, name, *from, body.as_deref());
                let (at, force) = (self.vector(), self.vector());
                quote!(Force { #acts at: #at, force: #force })
            }
            // Torques have become moments.
            DrawnKind::Omitted { name } | DrawnKind::Torque { name } => quote!(Omitted { name: #name }),
            DrawnKind::Moment { name, cause: from, body } => {
                let acts = acts(krate, name, *from, body.as_deref());
                let (at, moment) = (self.vector(), self.scalar());
                quote!(Moment { #acts at: #at, moment: #moment })
            }
        };
        quote!(#krate::scene::Item::#content)
    }

    fn part(&mut self, krate: &TokenStream, part: &OutlinedPart) -> TokenStream {
        let OutlinedPart { outline, has_corners, values, is_hole } = part;
        // The last three numbers say where the part is.
        let count = values.len().saturating_sub(3);
        let dimensions = match has_corners {
            true => {
                let corners = (0..count / 2).map(|_| self.vector());
                quote!((&[#(#corners),*]))
            }
            false if count == 0 => TokenStream::new(),
            false => {
                let lengths = (0..count).map(|_| self.scalar());
                quote!((#(#lengths),*))
            }
        };
        let (outline, at, angle) = (local(outline), self.vector(), self.scalar());
        quote! {
            #krate::scene::Part {
                outline: #krate::scene::Outline::#outline #dimensions,
                at: #at,
                angle: #angle,
                is_hole: #is_hole,
            }
        }
    }
}

/// Members that forces and moments have in common.
fn acts(krate: &TokenStream, name: &str, from: LoadOrigin, body: Option<&str>) -> TokenStream {
    let (cause, body) = (cause(from), option(body));
    quote!(name: #name, cause: #krate::scene::LoadOrigin::#cause, body: #body,)
}

fn option(name: Option<&str>) -> TokenStream {
    match name {
        Some(name) => quote!(::core::option::Option::Some(#name)),
        None => quote!(::core::option::Option::None),
    }
}

fn connector(kind: ConnectorKind) -> Ident {
    local(match kind {
        ConnectorKind::Spring => "Spring",
        ConnectorKind::Damper => "Damper",
        ConnectorKind::TorsionSpring => "TorsionSpring",
        ConnectorKind::TorsionDamper => "TorsionDamper",
    })
}

fn joint(form: JointForm) -> Ident {
    local(match form {
        JointForm::Pin => "Pin",
        JointForm::Anchor => "Anchor",
        JointForm::Slide => "Slide",
        JointForm::Roll => "Roll",
    })
}

fn cause(cause: LoadOrigin) -> Ident {
    local(match cause {
        LoadOrigin::Applied => "Applied",
        LoadOrigin::Gravity => "Gravity",
        LoadOrigin::Connector => "Connector",
        LoadOrigin::Joint => "Joint",
    })
}

/// The method that says how a body moves, with this content.
pub(in crate::emit) fn motion_method(
    shape: &Shape<'_>,
    names: &ArgumentNames,
    body: &Name,
    docs: &TokenStream,
    content: &TokenStream,
) -> TokenStream {
    let (krate, scalar) = (shape.krate, shape.scalar());
    let (nq, nv) = (shape.positions_length(), shape.velocities_length());
    let (name, ArgumentNames { time, positions, velocities, .. }) = (motion_name(body), names);
    let motion = local(if shape.declaration.is_in_space { "SpatialMotion" } else { "Motion" });
    quote! {
        #docs
        #[must_use]
        #[inline]
        pub fn #name(
            &self,
            #time: #scalar,
            #positions: &[#scalar; #nq],
            #velocities: &[#scalar; #nv],
        ) -> #krate::body::#motion<#scalar> {
            #content
        }
    }
}

/// The implementation of `Scene`, if it is asked for.
pub(in crate::emit) fn scene_impl(shape: &Shape<'_>, members: &Members) -> TokenStream {
    let Some(items) = &members.items else { return TokenStream::new() };
    let (name, generics, bounds, scalar) = (shape.name(), shape.generics(), shape.bounds(), shape.scalar());
    let (krate, nq, nv) = (shape.krate, shape.positions_length(), shape.velocities_length());
    let ArgumentNames { time, positions, velocities, visit, .. } = &members.names;
    quote! {
        #[automatically_derived]
        impl #bounds #krate::scene::Scene for #name #generics {
            #[inline]
            fn items(
                &self,
                #time: #scalar,
                #positions: &[#scalar; #nq],
                #velocities: &[#scalar; #nv],
                #visit: &mut dyn ::core::ops::FnMut(#krate::scene::Item<'_, #scalar>),
            ) {
                #items
            }
        }
    }
}
