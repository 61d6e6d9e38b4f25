//! Rigid bodies of a declaration, as far as products depend on them.

use crate::model::Product;
use lagrange_language::syntax::ast::Name;

/// Rigid bodies of a declaration.
#[derive(Default, Debug)]
pub(super) struct Staged {
    /// Their names.
    pub(super) bodies: Vec<Name>,
    /// Names of frames.
    pub(super) frames: Vec<Name>,
    /// True if they move in space.
    pub(super) is_in_space: bool,
    /// True if anything could be drawn.
    pub(super) is_visible: bool,
}

impl Staged {
    /// True if there is too little for a product, or it is of scenes of the other kind.
    pub(super) fn lacks(&self, product: Product) -> bool {
        let is_empty = self.bodies.is_empty() && self.frames.is_empty();
        match product {
            Product::Motion => self.bodies.is_empty(),
            Product::Drawing => self.bodies.is_empty() && !self.is_visible,
            Product::Frames | Product::FrameJacobians => !self.is_in_space || is_empty,
            Product::Statements => is_empty && !self.is_visible,
            _ => false,
        }
    }

    /// True if a name is that of a frame.
    pub(super) fn is_frame(&self, name: &str) -> bool {
        self.frames.iter().any(|frame| frame.text == name)
    }

    /// Bodies and frames with a method that a product has for each of them.
    pub(super) fn with_method(&self, product: Product) -> Vec<&Name> {
        let frames = if product == Product::Motion { &[] } else { &self.frames[..] };
        self.bodies.iter().chain(frames).collect()
    }
}
