//! Coefficients of the Gauss methods and the eigenvalues of their matrices.
//!
//! Sources: Butcher 1964; Hairer, Lubich, Wanner, *Geometric Numerical Integration*, §II.1.3, table
//! 1.1. The eigenvalues and eigenvectors only control iterations, so the precision of `f64`
//! suffices for every number type.

use crate::scalar::Scalar;

/// A collocation method with K stages.
#[derive(Clone, Copy, Debug)]
pub struct Tableau<S, const K: usize> {
    /// Coefficients of the stages.
    pub(super) a: [[S; K]; K],
    /// Weights.
    pub(super) b: [S; K],
    /// Nodes.
    pub(super) c: [S; K],
    /// The real eigenvalue of `a`, if there is one.
    pub(super) real: Option<EigenMode<f64, K>>,
    /// The complex eigenvalue of `a` with the positive imaginary part, if there is a pair.
    pub(super) complex: Option<EigenMode<(f64, f64), K>>,
}

/// An eigenvalue with its right eigenvector, a column, and its left eigenvector, a row. The product
/// of row and column is one.
#[derive(Clone, Copy, Debug)]
pub(super) struct EigenMode<N, const K: usize> {
    pub(super) value: N,
    pub(super) column: [N; K],
    pub(super) row: [N; K],
}

/// Numbers of stages with known coefficients.
pub trait Coefficients {
    /// Returns the coefficients.
    fn coefficients() -> Self;
}

impl<S: Scalar> Coefficients for Tableau<S, 1> {
    fn coefficients() -> Self {
        let half = ratio(1.0, 2.0);
        Tableau {
            a: [[half]],
            b: [S::ONE],
            c: [half],
            real: Some(EigenMode { value: 0.5, column: [1.0], row: [1.0] }),
            complex: None,
        }
    }
}

impl<S: Scalar> Coefficients for Tableau<S, 2> {
    fn coefficients() -> Self {
        let root = S::from_f64(3.0).sqrt();
        let (half, quarter, shift) = (ratio(1.0, 2.0), ratio(1.0, 4.0), root / S::from_f64(6.0));
        Tableau {
            a: [[quarter, quarter - shift], [quarter + shift, quarter]],
            b: [half, half],
            c: [half - shift, half + shift],
            real: None,
            complex: Some(EigenMode {
                value: (0.25, 0.144_337_567_297_406_44),
                column: [(0.0, 0.267_949_192_431_122_7), (1.0, 0.0)],
                row: [(0.0, -1.866_025_403_784_438_6), (0.5, 0.0)],
            }),
        }
    }
}

impl<S: Scalar> Coefficients for Tableau<S, 3> {
    fn coefficients() -> Self {
        let root = S::from_f64(15.0).sqrt();
        let part = |n: f64| root / S::from_f64(n);
        let (edge, middle, half) = (ratio(5.0, 36.0), ratio(2.0, 9.0), ratio(1.0, 2.0));
        Tableau {
            a: [
                [edge, middle - part(15.0), edge - part(30.0)],
                [edge + part(24.0), middle, edge - part(24.0)],
                [edge + part(30.0), middle + part(15.0), edge],
            ],
            b: [ratio(5.0, 18.0), ratio(4.0, 9.0), ratio(5.0, 18.0)],
            c: [half - part(10.0), half, half + part(10.0)],
            real: Some(EigenMode {
                value: 0.215_314_423_116_112_18,
                column: [0.072_151_852_055_200_17, 0.118_832_578_741_277_8, 1.0],
                row: [5.991_698_084_937_801, 1.139_214_295_155_735_4, 0.432_312_113_783_858_4],
            }),
            complex: Some(EigenMode {
                value: (0.142_342_788_441_943_9, 0.135_799_925_708_153_8),
                column: [
                    (-0.082_241_230_573_630_67, -0.060_120_738_619_308_5),
                    (0.053_065_090_742_061_4, 0.316_205_051_132_291_6),
                    (1.0, 0.0),
                ],
                row: [
                    (-2.995_849_042_468_900_4, 0.623_106_636_793_115_7),
                    (-0.569_607_147_577_867_7, -1.462_779_823_096_156_8),
                    (0.283_843_943_108_070_8, 0.128_867_600_636_716_25),
                ],
            }),
        }
    }
}

fn ratio<S: Scalar>(numerator: f64, denominator: f64) -> S {
    S::from_f64(numerator) / S::from_f64(denominator)
}

#[cfg(test)]
mod tests;
