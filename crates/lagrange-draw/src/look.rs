//! The look of pictures and the additions to a scene, as a drawing requests them.

/// The look of pictures, independent of their content.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Look {
    pub(super) size: [f64; 2],
    pub(super) title: String,
    /// Used in space only.
    pub(super) direction: Direction,
}

/// The viewing direction of a scene in space.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Direction {
    /// In radians.
    pub(super) azimuth: f64,
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
    /// In the plane: instantaneous centres.
    pub(super) centers: bool,
    /// In the plane: true if a body is drawn without what surrounds it.
    pub(super) is_free: bool,
    /// In space: the axes of the world.
    pub(super) axes: bool,
    /// In space: the height of a floor.
    pub(super) floor: Option<f64>,
}

impl Default for Direction {
    fn default() -> Self {
        Direction { azimuth: -60.0_f64.to_radians(), elevation: 25.0_f64.to_radians(), is_perspective: false }
    }
}
