//! Modes of a linear model: eigenvalues with frequencies, damping ratios and shapes, and a verdict
//! on stability.
//!
//! Rounding leaves an eigenvalue uncertain by about n ε |A| / |yᴴx|. Here y and x are the unit left
//! and right eigenvectors of the balanced matrix. Real parts below that are not distinguished from
//! zero. If k eigenvectors coincide, yᴴx vanishes and rounding changes eigenvalues by about ε^(1/k)
//! |A|. Sources: Golub, Van Loan, *Matrix Computations*, 4th ed., §7.2.2, §7.6.1; Wilkinson, *The
//! Algebraic Eigenvalue Problem*, §2.

use std::fmt::{Display, Formatter, Result as Written};
use std::string::String;
use std::vec::Vec;

use super::error::NotConverged;
use super::names::Components;
use crate::linalg::dense::{DenseMatrix, TriangularFactors};
use crate::linalg::eigenvalues::{balanced, eigenvalues};
use crate::linalg::singular_values::{dot, length};

/// Number of steps of inverse iteration; the second one corrects an unfortunate start.
const STEPS: usize = 3;
/// Maximum residual (A − λ) x of an eigenvector x, relative to the matrix.
const RESIDUAL: f64 = 1e-8;

/// Maximum diameter, relative to the matrix, of a cluster of eigenvalues that may be equal up to
/// rounding.
const CLUSTER: f64 = 1e-3;

/// Displacements of a shape below this, relative to its other components, are rounding.
const MOTIONLESS: f64 = 1e-12;

/// The verdict of the linear theory on an equilibrium or a steady motion.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Stability {
    /// All real parts are negative: small deviations decay, in the nonlinear system as well.
    AsymptoticallyStable,
    /// No real part is positive, and some are zero up to rounding. The nonlinear terms decide.
    Undecided,
    /// A real part is positive: some deviations grow, in the nonlinear system as well.
    Unstable,
}

impl Display for Stability {
    fn fmt(&self, f: &mut Formatter<'_>) -> Written {
        f.write_str(match self {
            Stability::AsymptoticallyStable => "asymptotically stable",
            Stability::Undecided => "not decided by the linear theory",
            Stability::Unstable => "unstable",
        })
    }
}

/// A mode: a motion e^{λt} of fixed shape. A complex pair is represented by the mode with positive
/// imaginary part.
#[derive(Clone, PartialEq, Debug)]
pub struct Eigenmode {
    /// The real part of the eigenvalue λ, a rate of growth.
    pub real: f64,
    /// The imaginary part, an angular frequency; not negative.
    pub imaginary: f64,
    /// The real and the imaginary part of each component of the shape, in the order of
    /// [`Modes::components`]. The largest displacement is one, or the largest component if no
    /// displacement moves.
    pub shape: Vec<(f64, f64)>,
    /// The uncertainty of λ by rounding.
    pub uncertainty: f64,
}

impl Eigenmode {
    /// Returns the undamped angular frequency |λ|.
    #[must_use]
    pub fn natural_frequency(&self) -> f64 {
        self.real.hypot(self.imaginary)
    }

    /// Returns the damping ratio −Re λ / |λ|: 1 for a decay without oscillation, 0 without damping,
    /// negative for growth. NaN for λ = 0.
    #[must_use]
    pub fn damping_ratio(&self) -> f64 {
        -self.real / self.natural_frequency()
    }

    /// Returns the damped frequency Im λ / 2π.
    #[must_use]
    pub fn frequency(&self) -> f64 {
        self.imaginary / core::f64::consts::TAU
    }
}

/// The modes of a linear model.
#[derive(Clone, PartialEq, Debug)]
pub struct Modes {
    modes: Vec<Eigenmode>,
    components: Components,
}

impl Modes {
    /// Computes the modes of ẋ = A x.
    pub(super) fn of(a: &DenseMatrix, components: &Components) -> Result<Modes, NotConverged> {
        let (a, scales) = balanced(a.clone());
        let all = eigenvalues(&a).ok_or(NotConverged)?;
        let mut found = all.clone();
        found.retain(|(_, imaginary)| *imaginary >= 0.0);
        found.sort_by(|one, other| {
            let sizes = one.0.hypot(one.1).total_cmp(&other.0.hypot(other.1));
            sizes.then(one.0.total_cmp(&other.0))
        });
        let mut modes = Modes { modes: Vec::new(), components: components.clone() };
        let (mut right, mut left) = (Eigenvectors::new(a.clone()), Eigenvectors::new(a.transposed()));
        for (real, imaginary) in found {
            let (x, y) = (right.next((real, imaginary)), left.next((real, -imaginary)));
            let cosine = x.product(&y).hypot(x.conjugate_product(&y));
            let part = (f64::EPSILON / cosine).min(of_cluster(&all, (real, imaginary), a.largest()));
            let uncertainty = a.rows() as f64 * part * a.largest();
            let shape = modes.shape(&x, &scales);
            modes.modes.push(Eigenmode { real, imaginary, shape, uncertainty });
        }
        Ok(modes)
    }

    /// Returns the components of the shape of an eigenvector of the balanced matrix.
    fn shape(&self, x: &ComplexVector, scales: &[f64]) -> Vec<(f64, f64)> {
        let Components { basis, displacements, .. } = &self.components;
        let all = |part: &[f64]| {
            let states = part.iter().zip(scales).map(|(entry, scale)| entry * scale).collect::<Vec<_>>();
            (0..basis.rows()).map(|i| dot(basis.row(i), &states)).collect::<Vec<_>>()
        };
        let (real, imaginary) = (all(&x.real), all(&x.imaginary));
        let size = |index: usize| real[index].hypot(imaginary[index]);
        // The first of equal ones, even if rounding makes another one larger.
        let larger = |best: usize, index| if size(index) > size(best) * (1.0 + 1e-9) { index } else { best };
        let of_all = (0..real.len()).fold(0, larger);
        let of_displacements = (0..*displacements).fold(0, larger);
        let moves = size(of_displacements) > MOTIONLESS * size(of_all);
        let largest = if *displacements > 0 && moves { of_displacements } else { of_all };
        let (a, b) = (real[largest] / size(largest), imaginary[largest] / size(largest));
        let turned = |index: usize| {
            let (x, y) = (real[index] / size(largest), imaginary[index] / size(largest));
            (a * x + b * y, a * y - b * x)
        };
        (0..real.len()).map(turned).collect()
    }

    /// Returns the modes, slowest first.
    #[must_use]
    pub fn modes(&self) -> &[Eigenmode] {
        &self.modes
    }

    /// Returns the names of the components of shapes: all displacements, first-order states and
    /// velocities, including those that follow from constraints.
    #[must_use]
    pub fn components(&self) -> &[String] {
        &self.components.names
    }

    /// Returns the real and imaginary part of the component of this name in a mode's shape.
    #[must_use]
    pub fn component(&self, mode: usize, name: &str) -> Option<(f64, f64)> {
        let index = self.components.names.iter().position(|component| component == name)?;
        self.modes.get(mode).map(|mode| mode.shape[index])
    }

    /// Returns the verdict on stability. It is valid if the model is that of an equilibrium or of a
    /// steady motion.
    #[must_use]
    pub fn stability(&self) -> Stability {
        if self.modes.iter().any(|mode| mode.real > mode.uncertainty) {
            return Stability::Unstable;
        }
        match self.modes.iter().all(|mode| mode.real < -mode.uncertainty) {
            true => Stability::AsymptoticallyStable,
            false => Stability::Undecided,
        }
    }
}

/// Writes a table of the modes: eigenvalues, frequencies, damping ratios and the largest
/// displacements of their shapes.
impl Display for Modes {
    fn fmt(&self, f: &mut Formatter<'_>) -> Written {
        writeln!(f, "{:>12} {:>12} {:>10} {:>9}  shape", "real", "imaginary", "Hz", "damping")?;
        for mode in &self.modes {
            let (ratio, frequency) = (unsigned_zero(mode.damping_ratio(), 5e-5), mode.frequency());
            write!(
                f,
                "{:>12.5} {:>12.5} {frequency:>10.4} ",
                unsigned_zero(mode.real, 5e-6),
                mode.imaginary
            )?;
            // The mode of an ignorable coordinate has no damping ratio.
            match ratio.is_nan() {
                true => write!(f, "{:>9} ", "–")?,
                false => write!(f, "{ratio:>9.4} ")?,
            }
            let all =
                self.components.names.iter().zip(&mode.shape).take(self.components.displacements.max(1));
            for (name, (real, imaginary)) in all.filter(|(_, (x, y))| x.hypot(*y) > 0.01) {
                let angle = imaginary.atan2(*real).to_degrees().round() + 0.0;
                let angle = if angle == -180.0 { 180.0 } else { angle };
                write!(f, " {name} {:.2}", real.hypot(*imaginary))?;
                if angle != 0.0 {
                    write!(f, "∠{angle}°")?;
                }
            }
            writeln!(f)?;
        }
        write!(f, "{}", self.stability())
    }
}

/// Returns the number, or zero if it is smaller than this. Its digits would be zeros after the sign
/// of a rounding error.
fn unsigned_zero(number: f64, least: f64) -> f64 {
    if number.abs() < least { 0.0 } else { number }
}

/// Returns the relative change of an eigenvalue by rounding, in a cluster of k: ε^(1/k), if they
/// share an eigenvector.
fn of_cluster(all: &[(f64, f64)], eigenvalue: (f64, f64), size: f64) -> f64 {
    let distance = |other: &&(f64, f64)| (eigenvalue.0 - other.0).hypot(eigenvalue.1 - other.1);
    let close = all.iter().filter(|other| distance(other) <= CLUSTER * size).count();
    f64::EPSILON.powf(1.0 / close.max(1) as f64)
}

/// A vector of complex numbers.
#[derive(Clone)]
struct ComplexVector {
    real: Vec<f64>,
    imaginary: Vec<f64>,
}

impl ComplexVector {
    /// Returns the real part of yᴴx.
    fn product(&self, y: &ComplexVector) -> f64 {
        dot(&self.real, &y.real) + dot(&self.imaginary, &y.imaginary)
    }

    /// Returns the imaginary part of yᴴx.
    fn conjugate_product(&self, y: &ComplexVector) -> f64 {
        dot(&self.imaginary, &y.real) - dot(&self.real, &y.imaginary)
    }

    fn normalised(mut self) -> ComplexVector {
        let size = length(&self.real).hypot(length(&self.imaginary));
        self.real.iter_mut().chain(&mut self.imaginary).for_each(|entry| *entry /= size);
        self
    }

    /// Returns the vector minus its component along a unit vector.
    fn without(mut self, unit: &ComplexVector) -> ComplexVector {
        let (real, imaginary) = (self.product(unit), self.conjugate_product(unit));
        for (k, (x, y)) in unit.real.iter().zip(&unit.imaginary).enumerate() {
            self.real[k] -= real * x - imaginary * y;
            self.imaginary[k] -= real * y + imaginary * x;
        }
        self
    }
}

/// Unit eigenvectors by inverse iteration; for equal eigenvalues independent ones, if they exist.
struct Eigenvectors {
    a: DenseMatrix,
    found: Vec<((f64, f64), ComplexVector)>,
}

impl Eigenvectors {
    fn new(a: DenseMatrix) -> Eigenvectors {
        Eigenvectors { a, found: Vec::new() }
    }

    fn next(&mut self, eigenvalue: (f64, f64)) -> ComplexVector {
        let near = f64::EPSILON.sqrt() * self.size();
        let is_equal = |other: &(f64, f64)| (eigenvalue.0 - other.0).hypot(eigenvalue.1 - other.1) <= near;
        let equal = self.found.iter().filter(|(other, _)| is_equal(other)).map(|(_, vector)| vector.clone());
        let equal = equal.collect::<Vec<_>>();
        let apart = self.iterate(eigenvalue, &equal);
        let vector = match self.residual(eigenvalue, &apart) <= RESIDUAL * self.size() {
            true => apart,
            // There are fewer independent eigenvectors than equal eigenvalues.
            false => self.iterate(eigenvalue, &[]),
        };
        self.found.push((eigenvalue, vector.clone()));
        vector
    }

    fn size(&self) -> f64 {
        let size = self.a.largest();
        if size > 0.0 { size } else { 1.0 }
    }

    /// Solves (A − λ) x' = x in real numbers, orthogonal to the vectors of equal eigenvalues.
    fn iterate(&self, (real, imaginary): (f64, f64), equal: &[ComplexVector]) -> ComplexVector {
        let n = self.a.rows();
        let shifted = DenseMatrix::from_fn(2 * n, 2 * n, |i, j| {
            let diagonal = if i % n == j % n { 1.0 } else { 0.0 };
            match (i < n, j < n) {
                (true, true) | (false, false) => self.a[(i % n, j % n)] - real * diagonal,
                (true, false) => imaginary * diagonal,
                (false, true) => -imaginary * diagonal,
            }
        });
        let start = |k: usize| 1.0 / (1.0 + ((k + equal.len()) % n) as f64);
        let real = (0..n).map(start).collect::<Vec<_>>();
        let mut x = ComplexVector { imaginary: std::vec![0.0; n], real };
        let Some(factors) = TriangularFactors::new(shifted, f64::EPSILON * self.size()) else {
            return x.normalised();
        };
        for _ in 0..STEPS {
            let all = factors.solve(&[&x.real[..], &x.imaginary].concat());
            let (real, imaginary) = all.split_at(n);
            x = ComplexVector { real: real.to_vec(), imaginary: imaginary.to_vec() }.normalised();
            x = equal.iter().fold(x, ComplexVector::without).normalised();
        }
        x
    }

    /// Computes |A x − λ x|.
    fn residual(&self, (real, imaginary): (f64, f64), x: &ComplexVector) -> f64 {
        let rows = (0..self.a.rows()).map(|i| {
            let (re, im) = (dot(self.a.row(i), &x.real), dot(self.a.row(i), &x.imaginary));
            let (re, im) = (
                re - real * x.real[i] + imaginary * x.imaginary[i],
                im - real * x.imaginary[i] - imaginary * x.real[i],
            );
            re.hypot(im)
        });
        length(&rows.collect::<Vec<_>>())
    }
}
