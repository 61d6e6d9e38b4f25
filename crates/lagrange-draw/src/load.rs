//! Forces and moments of a scene.

use lagrange_runtime::scene::{LoadOrigin, Plane, Space};

/// A force or a moment.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Load<D: Space = Plane> {
    pub(super) name: String,
    pub(super) cause: LoadOrigin,
    pub(super) body: Option<String>,
    pub(super) at: D::Vector<f64>,
    pub(super) value: Value<D>,
}

#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) enum Value<D: Space = Plane> {
    Force(D::Vector<f64>),
    Moment(D::Moment<f64>),
}

impl<D: Space> Load<D> {
    pub(super) fn is_moment(&self) -> bool {
        matches!(self.value, Value::Moment(_))
    }
}
