//! Levels of accuracy of emitted code.

/// `#[accuracy(…)]`: the trade-off between rounding errors of the emitted code and its speed.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub enum Accuracy {
    /// Sines and cosines within an ulp, several at a time.
    Fast,
    /// Elementary functions of the platform.
    #[default]
    Standard,
    /// Differences of nearly equal terms are avoided where possible.
    Strict,
}

impl Accuracy {
    /// Every level.
    pub const ALL: [Accuracy; 3] = [Accuracy::Fast, Accuracy::Standard, Accuracy::Strict];

    /// Returns its name in the attribute.
    pub fn name(self) -> &'static str {
        match self {
            Accuracy::Fast => "fast",
            Accuracy::Standard => "standard",
            Accuracy::Strict => "strict",
        }
    }
}
