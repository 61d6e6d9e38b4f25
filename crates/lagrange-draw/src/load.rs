//! Forces and moments of a scene.

use crate::picture::Point;
use lagrange_runtime::scene::LoadOrigin;

/// A force or a moment.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Load {
    pub(super) name: String,
    pub(super) cause: LoadOrigin,
    pub(super) body: Option<String>,
    pub(super) at: Point,
    pub(super) value: Value,
}

#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) enum Value {
    Force(Point),
    Moment(f64),
}

impl Load {
    pub(super) fn is_moment(&self) -> bool {
        matches!(self.value, Value::Moment(_))
    }
}
