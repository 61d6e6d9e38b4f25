//! Grids of motions over two quantities.

use core::ops::Range;
use std::string::{String, ToString};

/// A grid over two quantities. An ensemble computes one motion per cell.
///
/// ```
/// use lagrange::Ensembles;
/// use lagrange::ensemble::Grid;
///
/// lagrange::system! {
///     #[derive(Clone)]
///     pub struct Pendulum;
///     param l = 1.0, g = 9.81;
///     coord theta;
///     kinetic = 1/2 * (l * dot(theta))^2;
///     potential = -g * l * cos(theta);
/// }
///
/// let grid = Grid::new(("theta", -3.0..3.0, 30), ("theta_dot", -6.0..6.0, 20));
/// let pendulum = Pendulum::default();
/// let ends = pendulum.ensemble(grid.len()).start(|i, _| grid.at(i)).until(1.0).run()?;
/// assert_eq!(ends.len(), 600);
/// // With the feature `plot`: ends.map(&grid, "theta")?.save("theta.png")?;
/// # Ok::<(), lagrange::ensemble::EnsembleError>(())
/// ```
#[derive(Clone, PartialEq, Debug)]
pub struct Grid {
    pub(super) x: Quantity,
    pub(super) y: Quantity,
}

/// A quantity divided into intervals of equal length.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Quantity {
    pub(super) name: String,
    pub(super) range: Range<f64>,
    pub(super) cells: usize,
}

impl Grid {
    /// Creates a grid with the first quantity to the right and the second upwards. Each has a name,
    /// a range, and a number of cells in its direction.
    pub fn new(x: (&str, Range<f64>, usize), y: (&str, Range<f64>, usize)) -> Self {
        let quantity = |(name, range, cells): (&str, Range<f64>, usize)| {
            let name = name.to_string();
            Quantity { name, range, cells }
        };
        Grid { x: quantity(x), y: quantity(y) }
    }

    /// Returns the number of cells.
    pub fn len(&self) -> usize {
        self.x.cells.saturating_mul(self.y.cells)
    }

    /// True if it has no cells.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Returns both quantities at the centre of the cell with this index. Cells are counted from
    /// left to right, row by row from the bottom.
    pub fn at(&self, index: usize) -> [f64; 2] {
        let columns = self.x.cells.max(1);
        [self.x.middle(index % columns), self.y.middle(index / columns)]
    }
}

impl Quantity {
    fn middle(&self, cell: usize) -> f64 {
        let Range { start, end } = self.range;
        start + (end - start) * ((cell as f64 + 0.5) / self.cells as f64)
    }

    /// Returns both ends of the range, if it is finite and ascending.
    #[cfg(feature = "plot")]
    pub(super) fn bounds(&self) -> Option<(f64, f64)> {
        let Range { start, end } = self.range;
        (start < end && (end - start).is_finite()).then_some((start, end))
    }
}
