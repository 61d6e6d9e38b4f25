//! Values of `lagrange::body` and `lagrange::scene`: motions and items to draw.

use std::fmt::Debug;
use std::slice::Iter;

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use crate::emit::base::method::Returns;
use crate::emit::base::shape::local;
use crate::model::{DrawnItem, OutlinedPart, Scene};
use lagrange_expr::expr::ExprId;
use lagrange_language::bodies::DrawnKind;
use lagrange_language::bodies::LoadOrigin;
use lagrange_language::bodies::SpatialJointForm;
use lagrange_language::syntax::ast::{ConnectorKind, SurfaceKind};

/// Returns the name of the body that an item draws, and its motion.
pub(super) fn body_of<'a>(scene: &'a Scene, item: &DrawnItem) -> Option<(&'a str, &'a [ExprId])> {
    let DrawnKind::Body { body, .. } = item.kind else { return None };
    scene.motions.get(body).map(|motion| (motion.body.text.as_str(), &motion.values[..]))
}

/// Results of a program, consumed one after another.
pub(super) struct Values<'a> {
    rest: Iter<'a, TokenStream>,
    /// Functions for the heights of terrain.
    pub(super) heights: Iter<'a, TokenStream>,
    /// Number of components of vectors: 3 in space.
    dimension: usize,
}

impl<'a> Values<'a> {
    pub(super) fn new(results: &'a [TokenStream], dimension: usize) -> Values<'a> {
        Values { rest: results.iter(), heights: [].iter(), dimension }
    }

    fn is_in_space(&self) -> bool {
        self.dimension == 3
    }

    fn scalar(&mut self) -> TokenStream {
        let missing = || quote!(::core::compile_error!("a number of this scene is missing"));
        self.rest.next().cloned().unwrap_or_else(missing)
    }

    fn scalars(&mut self, count: usize) -> Vec<TokenStream> {
        (0..count).map(|_| self.scalar()).collect()
    }

    fn vector(&mut self) -> TokenStream {
        let components = self.scalars(self.dimension);
        quote!([#(#components),*])
    }

    /// Takes three rows.
    fn matrix(&mut self) -> TokenStream {
        Returns::Matrix(3, 3).collect(&self.scalars(9))
    }

    /// Takes a number, or in space a matrix in rows: a rotation, or the inertia of a body.
    fn rotation(&mut self) -> TokenStream {
        if self.is_in_space() { self.matrix() } else { self.scalar() }
    }

    /// Takes a number, or in space a vector.
    fn moment(&mut self) -> TokenStream {
        if self.is_in_space() { self.vector() } else { self.scalar() }
    }

    /// Emits the motion of a body.
    pub(super) fn motion(&mut self, krate: &TokenStream) -> TokenStream {
        let [motion, turn] =
            if self.is_in_space() { ["SpatialMotion", "rotation"] } else { ["Motion", "angle"] }.map(local);
        let (mass, inertia, centroid) = (self.scalar(), self.rotation(), self.vector());
        let (center, rotation) = (self.vector(), self.rotation());
        let (velocity, angular_velocity) = (self.vector(), self.moment());
        let (acceleration, angular_acceleration) = (self.vector(), self.moment());
        quote! {
            #krate::body::#motion {
                mass: #mass,
                inertia: #inertia,
                centroid: #centroid,
                center: #center,
                #turn: #rotation,
                velocity: #velocity,
                angular_velocity: #angular_velocity,
                acceleration: #acceleration,
                angular_acceleration: #angular_acceleration,
            }
        }
    }

    /// Emits an item to draw.
    pub(super) fn item(&mut self, krate: &TokenStream, scene: &Scene, item: &DrawnItem) -> TokenStream {
        let content = match &item.kind {
            DrawnKind::Body { .. } => {
                let name = body_of(scene, item).map_or("", |(name, _)| name);
                let motion = self.motion(krate);
                let parts = item.parts.iter().map(|part| self.part(krate, part));
                quote!(Body { name: #name, motion: #motion, parts: &[#(#parts),*] })
            }
            DrawnKind::Frame { name } => {
                let (rotation, origin) = (self.matrix(), self.vector());
                quote!(Frame(#krate::scene::Frame { name: #name, rotation: #rotation, origin: #origin }))
            }
            DrawnKind::Surface { name, body, kind, is_inside, .. } => {
                self.surface(krate, (name, body.as_deref()), *kind, *is_inside)
            }
            DrawnKind::Cone { name, body } => {
                let (body, at, normal) = (option(body.as_deref()), self.vector(), self.vector());
                let coefficient = self.scalar();
                quote!(Cone { name: #name, body: #body, at: #at, normal: #normal, coefficient: #coefficient })
            }
            DrawnKind::Connector { name, kind } => self.connector(krate, name, *kind),
            DrawnKind::Joint { name, kind } => {
                let (kind, at) = (variant(kind), self.vector());
                quote!(Joint { name: #name, kind: #krate::scene::Joint::#kind, at: #at })
            }
            DrawnKind::SpatialJoint { name, kind, links } => self.spatial_joint(krate, name, *kind, links),
            DrawnKind::Force { name, cause: from, body } => {
                let acts = acts(krate, name, *from, body.as_deref());
                let (at, force) = (self.vector(), self.vector());
                quote!(Force { #acts at: #at, force: #force })
            }
            // Torques have already become moments.
            DrawnKind::Omitted { name } | DrawnKind::Torque { name } => quote!(Omitted { name: #name }),
            DrawnKind::Moment { name, cause: from, body } => {
                let acts = acts(krate, name, *from, body.as_deref());
                let (at, moment) = (self.vector(), self.moment());
                quote!(Moment { #acts at: #at, moment: #moment })
            }
        };
        quote!(#krate::scene::Item::#content)
    }

    fn surface(
        &mut self,
        krate: &TokenStream,
        (name, body): (&str, Option<&str>),
        kind: SurfaceKind,
        is_inside: bool,
    ) -> TokenStream {
        let (body, at, rotation) = (option(body), self.vector(), self.rotation());
        let shape = match kind {
            SurfaceKind::Line | SurfaceKind::Plane => quote!(Flat),
            SurfaceKind::Circle | SurfaceKind::Sphere => {
                let radius = self.scalar();
                quote!(Round(#radius))
            }
            SurfaceKind::Cylinder => {
                let radius = self.scalar();
                quote!(Cylinder(#radius))
            }
            SurfaceKind::Terrain => {
                let height = self.heights.next();
                quote!(Terrain(#krate::scene::Height(#height)))
            }
        };
        quote! {
            Surface(#krate::scene::Surface {
                name: #name,
                body: #body,
                shape: #krate::scene::SurfaceShape::#shape,
                at: #at,
                rotation: #rotation,
                is_inside: #is_inside,
            })
        }
    }

    fn connector(&mut self, krate: &TokenStream, name: &str, kind: ConnectorKind) -> TokenStream {
        let kind = variant(kind);
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

    fn spatial_joint(
        &mut self,
        krate: &TokenStream,
        name: &str,
        form: SpatialJointForm,
        links: &[Option<String>; 2],
    ) -> TokenStream {
        let kind = match form {
            SpatialJointForm::Mobilizer(kind) => variant(kind),
            SpatialJointForm::Pin => variant(form),
        };
        let (at, axis) = (self.vector(), self.vector());
        let [carrier, placed] = links.each_ref().map(|link| option(link.as_deref()));
        quote! {
            Joint {
                name: #name,
                kind: #krate::scene::SpatialJoint {
                    kind: #krate::scene::SpatialJointKind::#kind,
                    axis: #axis,
                    bodies: [#carrier, #placed],
                },
                at: #at,
            }
        }
    }

    fn part(&mut self, krate: &TokenStream, part: &OutlinedPart) -> TokenStream {
        let &OutlinedPart { variant, has_corners, dimension_count: count, is_hole, .. } = part;
        let dimensions = match has_corners {
            true => {
                let corners = (0..count / 2).map(|_| self.vector());
                quote!((&[#(#corners),*]))
            }
            false if count == 0 => TokenStream::new(),
            false => {
                let lengths = self.scalars(count);
                quote!((#(#lengths),*))
            }
        };
        let (variant, at, rotation) = (local(variant), self.vector(), self.rotation());
        let shape = local(if self.is_in_space() { "Solid" } else { "Outline" });
        quote! {
            #krate::scene::Part {
                shape: #krate::scene::#shape::#variant #dimensions,
                at: #at,
                rotation: #rotation,
                is_hole: #is_hole,
            }
        }
    }
}

/// Writes the common members of forces and moments.
fn acts(krate: &TokenStream, name: &str, from: LoadOrigin, body: Option<&str>) -> TokenStream {
    let (cause, body) = (variant(from), option(body));
    quote!(name: #name, cause: #krate::scene::LoadOrigin::#cause, body: #body,)
}

fn option(name: Option<&str>) -> TokenStream {
    match name {
        Some(name) => quote!(::core::option::Option::Some(#name)),
        None => quote!(::core::option::Option::None),
    }
}

/// Returns the variant of `lagrange::scene` for an enumeration with the same variants.
fn variant(kind: impl Debug) -> Ident {
    local(&format!("{kind:?}"))
}
