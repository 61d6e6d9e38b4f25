//! The possible starts of a run.

/// A state Y in any form: the array `[q…, v…]`, the emitted type with named fields, or another type
/// that converts into the array.
#[diagnostic::on_unimplemented(
    message = "a run cannot start from `{Self}`: the state is `{Y}`",
    label = "this is not a state of the system",
    note = "a state is an array of all coordinates and then all velocities, such as `[0.5, 0.0]`, or the emitted type with named fields",
    note = "numbers are written with a decimal point: `1.0`, not `1`"
)]
pub trait InitialState<Y> {
    /// Returns the state as an array.
    fn into_state(self) -> Y;
}

#[diagnostic::do_not_recommend]
impl<T: Into<Y>, Y> InitialState<Y> for T {
    fn into_state(self) -> Y {
        self.into()
    }
}
