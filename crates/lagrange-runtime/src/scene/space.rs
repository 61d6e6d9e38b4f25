//! The plane and space: their types of places, rotations and moments.

use core::convert::Infallible;
use core::fmt::Debug;

use super::plane::{Joint, Outline};
use super::spatial::{Frame, Solid, SpatialJoint};
use crate::body::{Motion, SpatialMotion};
use crate::scalar::Scalar;

/// A space in which bodies move: [`Plane`] or [`Spatial`].
pub trait Space: Copy + PartialEq + Debug + 'static {
    /// A place, direction or force.
    type Vector<S: Scalar>: Copy + PartialEq + Debug;
    /// A moment; in the plane a number.
    type Moment<S: Scalar>: Copy + PartialEq + Debug;
    /// A rotation; in the plane an angle, in space a matrix in rows.
    type Rotation<S: Scalar>: Copy + PartialEq + Debug;
    /// The motion of a body.
    type Motion<S: Scalar>: Copy + PartialEq + Debug;
    /// The shape of a part of a body, in its own coordinates.
    type Shape<'a, S: Scalar>: Copy + PartialEq + Debug;
    /// A joint, apart from its name and place.
    type Joint<'a, S: Scalar>: Copy + PartialEq + Debug;
    /// A frame; [`Infallible`] in the plane, so that patterns can omit it.
    type Frame<'a, S: Scalar>: Copy + PartialEq + Debug;
}

/// The plane, x to the right, y upwards.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Plane;

/// Space, z upwards.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Spatial;

impl Space for Plane {
    type Vector<S: Scalar> = [S; 2];
    type Moment<S: Scalar> = S;
    type Rotation<S: Scalar> = S;
    type Motion<S: Scalar> = Motion<S>;
    type Shape<'a, S: Scalar> = Outline<'a, S>;
    type Joint<'a, S: Scalar> = Joint;
    type Frame<'a, S: Scalar> = Infallible;
}

impl Space for Spatial {
    type Vector<S: Scalar> = [S; 3];
    type Moment<S: Scalar> = [S; 3];
    type Rotation<S: Scalar> = [[S; 3]; 3];
    type Motion<S: Scalar> = SpatialMotion<S>;
    type Shape<'a, S: Scalar> = Solid<S>;
    type Joint<'a, S: Scalar> = SpatialJoint<'a, S>;
    type Frame<'a, S: Scalar> = Frame<'a, S>;
}
