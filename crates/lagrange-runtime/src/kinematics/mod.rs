//! Inverse kinematics: positions in which frames of bodies are at given places, and velocities that
//! move them as given. It needs no heap.
//!
//! ```
//! use lagrange::kinematics::{InverseKinematics, FrameTask};
//!
//! lagrange::system! {
//!     /// Two links in a plane.
//!     struct Arm;
//!     emit { frames, frame_jacobians }
//!     body upper { mass: 1; shape: slender_rod(0.4); }
//!     body lower { mass: 1; shape: slender_rod(0.3); }
//!     frame tip;
//!     revolute shoulder = ground to upper { axis: (0, 0, 1); }
//!     revolute elbow = upper to lower { at: (0.4, 0, 0); axis: (0, 0, 1); }
//!     weld lower to tip { at: (0.3, 0, 0); }
//! }
//!
//! let arm = Arm::default();
//! let touch = [FrameTask::position(Arm::tip_frame, Arm::tip_jacobian, [0.5, 0.0, 0.0])];
//! let posture = arm.reach(&touch, &[-0.5, 0.5]).within("elbow", 0.0, 2.6).solve()?;
//!
//! // The law of cosines.
//! assert!((posture.q[1].cos() - (0.25 - 0.16 - 0.09) / 0.24).abs() < 1e-12);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod descent;
mod error;
mod limit;
mod posture;
mod rates;
mod rotation;
mod task;

pub use error::{ReachError, Shortfall};
pub use posture::{InverseKinematics, Posture, Reach};
pub use rates::resolved_rates;
pub use task::{FrameTask, Pose};
