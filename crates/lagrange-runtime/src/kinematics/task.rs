//! Goals of frames.

use super::rotation::{is_rotation, rotation_between};
use crate::scalar::{Number, Scalar};
use crate::system::{MechanicalSystem, OdeSystem};

/// The rotation matrix of a frame, in rows, and the position of its origin in the world, as
/// returned by methods `NAME_frame`. Columns of the matrix are the axes of the frame.
pub type Pose<S> = ([[S; 3]; 3], [S; 3]);

/// A function that returns the pose of a frame, as `NAME_frame` does.
type FrameOf<M> =
    fn(&M, <M as OdeSystem>::Scalar, &<M as MechanicalSystem>::Coordinates) -> Pose<<M as OdeSystem>::Scalar>;

/// A function that returns the Jacobian of a frame, as `NAME_jacobian` does: angular velocity, then
/// velocity.
type JacobianOf<M, const N: usize> = fn(
    &M,
    <M as OdeSystem>::Scalar,
    &<M as MechanicalSystem>::Coordinates,
) -> [[<M as OdeSystem>::Scalar; N]; 6];

/// A frame and the position, the orientation or the pose that it should assume.
pub struct FrameTask<M: MechanicalSystem, const N: usize> {
    frame: FrameOf<M>,
    jacobian: JacobianOf<M, N>,
    rotation: Option<[[M::Scalar; 3]; 3]>,
    position: Option<[M::Scalar; 3]>,
}

impl<M: MechanicalSystem, const N: usize> FrameTask<M, N> {
    /// Creates the task to move the origin of the frame to a position in the world; its orientation
    /// is free.
    pub fn position(frame: FrameOf<M>, jacobian: JacobianOf<M, N>, position: [M::Scalar; 3]) -> Self {
        FrameTask { frame, jacobian, rotation: None, position: Some(position) }
    }

    /// Creates the task to rotate the axes of the frame to those of a rotation matrix; its position
    /// is free.
    pub fn rotation(frame: FrameOf<M>, jacobian: JacobianOf<M, N>, rotation: [[M::Scalar; 3]; 3]) -> Self {
        FrameTask { frame, jacobian, rotation: Some(rotation), position: None }
    }

    /// Creates the task to bring the frame to a pose.
    pub fn pose(
        frame: FrameOf<M>,
        jacobian: JacobianOf<M, N>,
        (rotation, position): Pose<M::Scalar>,
    ) -> Self {
        FrameTask { frame, jacobian, rotation: Some(rotation), position: Some(position) }
    }

    /// True if the goal is finite, and its rotation matrix is a rotation.
    pub(super) fn is_valid(&self) -> bool {
        let is_finite = |place: &[M::Scalar; 3]| place.iter().all(|x| x.is_finite());
        self.rotation.as_ref().is_none_or(is_rotation) && self.position.as_ref().is_none_or(is_finite)
    }

    /// Computes the rotation and the displacement that lead to the goal; zero for a part that is
    /// free.
    pub(super) fn error(&self, system: &M, t: M::Scalar, q: &M::Coordinates) -> TaskError<M::Scalar> {
        let (rotation, position) = (self.frame)(system, t, q);
        let zero = [M::Scalar::ZERO; 3];
        let displaced = |goal: [M::Scalar; 3]| core::array::from_fn(|i| goal[i] - position[i]);
        TaskError {
            rotation: self.rotation.map_or(zero, |goal| rotation_between(&rotation, &goal)),
            displacement: self.position.map_or(zero, displaced),
        }
    }

    pub(super) fn jacobian(&self, system: &M, t: M::Scalar, q: &M::Coordinates) -> [[M::Scalar; N]; 6] {
        (self.jacobian)(system, t, q)
    }

    /// Computes the rows of the Jacobian for rotation, then for displacement; zero for a part that
    /// is free.
    pub(super) fn rows(&self, system: &M, t: M::Scalar, q: &M::Coordinates) -> [[M::Scalar; N]; 6] {
        let mut rows = self.jacobian(system, t, q);
        let [turning, moving] = [self.rotation.is_some(), self.position.is_some()];
        for (row, counts) in rows.iter_mut().zip([turning, turning, turning, moving, moving, moving]) {
            if !counts {
                *row = [M::Scalar::ZERO; N];
            }
        }
        rows
    }
}

impl<M: MechanicalSystem, const N: usize> Clone for FrameTask<M, N> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<M: MechanicalSystem, const N: usize> Copy for FrameTask<M, N> {}

/// The motion that brings a frame to its goal.
#[derive(Clone, Copy)]
pub(super) struct TaskError<S> {
    /// Rotation vector in world axes.
    pub(super) rotation: [S; 3],
    pub(super) displacement: [S; 3],
}

impl<S: Scalar> TaskError<S> {
    pub(super) fn angle(&self) -> S {
        length(&self.rotation)
    }

    pub(super) fn distance(&self) -> S {
        length(&self.displacement)
    }
}

fn length<S: Scalar>(vector: &[S; 3]) -> S {
    vector.iter().fold(S::ZERO, |sum, x| x.multiply_add(*x, sum)).sqrt()
}
