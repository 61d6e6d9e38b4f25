//! Rigid bodies of a declaration, with the properties that products depend on.

use crate::model::Product;
use lagrange_language::syntax::ast::Name;

/// Rigid bodies and frames of a declaration.
#[derive(Default, Debug)]
pub(super) struct Staged {
    /// Names of bodies.
    pub(super) bodies: Vec<Name>,
    /// Names of frames.
    pub(super) frames: Vec<Name>,
    /// True if the bodies move in space.
    pub(super) is_in_space: bool,
    /// True if anything could be drawn.
    pub(super) is_visible: bool,
}

impl Staged {
    /// True if the scene lacks bodies or frames for a product, or the product belongs to the other
    /// kind of scene.
    pub(super) fn lacks(&self, product: Product) -> bool {
        let is_empty = self.bodies.is_empty() && self.frames.is_empty();
        match product {
            Product::Motion => self.bodies.is_empty(),
            _ if product.is_centroidal() => self.bodies.is_empty(),
            Product::Drawing => self.bodies.is_empty() && !self.is_visible,
            Product::Frames | Product::FrameJacobians => !self.is_in_space || is_empty,
            _ => false,
        }
    }

    /// True if a name belongs to a frame.
    pub(super) fn is_frame(&self, name: &str) -> bool {
        self.frames.iter().any(|frame| frame.text == name)
    }

    /// Returns the methods of a product, each with its body or frame.
    pub(super) fn methods(&self, product: Product) -> Vec<(&Name, String)> {
        let frames = if product == Product::Motion { &[] } else { &self.frames[..] };
        let methods = product.methods_of_bodies();
        let links = self.bodies.iter().chain(frames);
        links.flat_map(|link| methods.iter().map(move |method| (link, method.name(&link.text)))).collect()
    }
}
