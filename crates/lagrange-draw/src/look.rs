//! The look of pictures and the requested additions to a scene.

/// The look of pictures, independent of their content.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Look {
    pub(super) size: [f64; 2],
    pub(super) title: String,
    /// Viewing direction, used in space only.
    pub(super) direction: Direction,
}

/// The viewing direction of a scene in space.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Direction {
    /// Azimuth in radians.
    pub(super) azimuth: f64,
    /// Elevation in radians.
    pub(super) elevation: f64,
    pub(super) is_perspective: bool,
}

/// The requested additions to the scene.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub(super) struct Wanted {
    pub(super) velocities: bool,
    pub(super) accelerations: bool,
    pub(super) forces: bool,
    pub(super) frames: bool,
    pub(super) names: bool,
    /// True if instantaneous centres are drawn, in the plane.
    pub(super) centers: bool,
    /// True if a body is drawn without its surroundings, in the plane.
    pub(super) is_free: bool,
    /// True if the axes of the world are drawn, in space.
    pub(super) axes: bool,
    /// Height of a floor, in space.
    pub(super) floor: Option<f64>,
}

impl Default for Direction {
    fn default() -> Self {
        Direction { azimuth: -60.0_f64.to_radians(), elevation: 25.0_f64.to_radians(), is_perspective: false }
    }
}
