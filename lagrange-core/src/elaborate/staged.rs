//! Rigid bodies of a declaration, as far as products depend on them.

use crate::model::Product;
use crate::syntax::ast::Name;

/// Rigid bodies of a declaration.
#[derive(Default, Debug)]
pub(super) struct Staged {
    /// Their names.
    pub(super) bodies: Vec<Name>,
    /// Whether anything could be drawn.
    pub(super) is_visible: bool,
}

impl Staged {
    /// Whether there is too little for a product.
    pub(super) fn lacks(&self, product: Product) -> bool {
        match product {
            Product::Motion => self.bodies.is_empty(),
            Product::Drawing | Product::Statements => self.bodies.is_empty() && !self.is_visible,
            _ => false,
        }
    }
}
