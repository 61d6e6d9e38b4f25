//! White noises of a system, as used by methods of integration.

/// Maximum number of noises of a system.
pub const MAX_NOISES: usize = 16;

/// The white noises that act on a system.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct WhiteNoise {
    /// Number of noises, at most [`MAX_NOISES`].
    pub count: usize,
    /// Dependence of the motion on them.
    pub kind: NoiseKind,
}

impl WhiteNoise {
    /// No noise.
    pub const NONE: WhiteNoise = WhiteNoise { count: 0, kind: NoiseKind::Additive };

    /// True if there is one.
    #[inline]
    pub const fn acts(self) -> bool {
        self.count > 0
    }
}

/// Dependence of diffusions g on the state, which determines the order of methods.
///
/// The equations of Itô and Stratonovich differ by ½ Σ (gₖ·∇) gₖ. Methods need additional terms to
/// reach their order if (gⱼ·∇) gₖ does not vanish for some pair of noises.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum NoiseKind {
    /// They depend at most on time.
    Additive,
    /// They depend on components of the state that no noise drives, such as the positions of a
    /// mechanical system: all (gⱼ·∇) gₖ are zero. Itô and Stratonovich agree.
    Unambiguous,
    /// They depend on components of the state that noise drives. The noise is in the sense of
    /// Stratonovich.
    Multiplicative,
}
