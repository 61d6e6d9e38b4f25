//! Orientations, as written.

use super::Name;

/// An orientation as a unit quaternion of positions, with its angular velocity in the turned axes.
#[derive(Clone, Debug)]
pub struct Quaternion {
    /// Prefix of the names of its components.
    pub name: Name,
    /// Scalar part and vector part: `hip_qw`, `hip_qx`, `hip_qy`, `hip_qz`.
    pub positions: [Name; 4],
    /// Components of the angular velocity: `hip_wx`, `hip_wy`, `hip_wz`.
    pub velocities: [Name; 3],
}

impl Quaternion {
    /// Creates a quaternion with this name.
    pub fn named(name: Name) -> Quaternion {
        let component = |suffix: &str| Name::new(format!("{}_{suffix}", name.text), name.span);
        Quaternion {
            positions: ["qw", "qx", "qy", "qz"].map(component),
            velocities: ["wx", "wy", "wz"].map(component),
            name,
        }
    }

    pub(super) fn names(&self) -> Vec<&Name> {
        self.positions.iter().chain(&self.velocities).collect()
    }
}
