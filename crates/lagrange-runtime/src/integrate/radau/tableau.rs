//! Coefficients of the Radau IIA method of order five.
//!
//! Its matrix A has one real eigenvalue and a complex pair. In the basis of eigenvectors, T⁻¹ A⁻¹ T
//! = diag(μ, [α −β; β α]). Newton's equations for the three stages are therefore one real and one
//! complex system with the size of a state. Source: Hairer, Wanner, *Solving Ordinary Differential
//! Equations II*, §IV.5 and §IV.8.

/// Number of stages.
pub(super) const STAGES: usize = 3;

const ROOT: f64 = 2.449_489_742_783_178; // √6

/// Fractions of a step at which the stages are evaluated.
pub(super) const NODES: [f64; STAGES] = [(4.0 - ROOT) / 10.0, (4.0 + ROOT) / 10.0, 1.0];

/// The real eigenvalue of A⁻¹, 3 + 3^(2/3) − 3^(1/3).
pub(super) const REAL: f64 = 3.637_834_252_744_496;
/// The complex eigenvalue of A⁻¹ for the second and third row of [`INVERSE_BASIS`], as real and
/// imaginary part.
pub(super) const COMPLEX: (f64, f64) = (2.681_082_873_627_752, -3.050_430_199_247_411);

/// T.
pub(super) const BASIS: [[f64; STAGES]; STAGES] = [
    [0.094_438_762_488_975_24, -0.141_255_295_020_954_2, 0.030_029_194_105_147_42],
    [0.250_213_122_965_333_3, 0.204_129_352_293_799_94, -0.382_942_112_757_261_9],
    [1.0, 1.0, 0.0],
];

/// T⁻¹.
pub(super) const INVERSE_BASIS: [[f64; STAGES]; STAGES] = [
    [4.178_718_591_551_904, 0.327_682_820_761_062_37, 0.523_376_445_499_449_5],
    [-4.178_718_591_551_904, -0.327_682_820_761_062_37, 0.476_623_554_500_550_44],
    [0.502_872_634_945_786_8, -2.571_926_949_855_605, 0.596_039_204_828_224_9],
];

/// Weights of the changes at the stages in the error of a step, which is (μ/h − J)⁻¹ (f(t, y) + Σ
/// eᵢ zᵢ / h).
pub(super) const ERROR: [f64; STAGES] = [(-13.0 - 7.0 * ROOT) / 3.0, (-13.0 + 7.0 * ROOT) / 3.0, -1.0 / 3.0];

/// Coefficients of t, t² and t³ in the polynomial that is one at a stage, and zero at the others
/// and at the start.
pub(super) const POLYNOMIALS: [[f64; STAGES]; STAGES] = [
    [(13.0 + 7.0 * ROOT) / 3.0, (-23.0 - 22.0 * ROOT) / 3.0, 10.0 / 3.0 + 5.0 * ROOT],
    [(13.0 - 7.0 * ROOT) / 3.0, (-23.0 + 22.0 * ROOT) / 3.0, 10.0 / 3.0 - 5.0 * ROOT],
    [1.0 / 3.0, -8.0 / 3.0, 10.0 / 3.0],
];

/// Weights of the changes at the stages in h times the slope of their polynomial at the start of a
/// step.
pub(super) const START_SLOPE: [f64; STAGES] = [POLYNOMIALS[0][0], POLYNOMIALS[1][0], POLYNOMIALS[2][0]];

/// Weights of the changes at the stages in h times the slope at the end of a step, the last row of
/// A⁻¹.
pub(super) const END_SLOPE: [f64; STAGES] = [-1.0 + 8.0 * ROOT / 3.0, -1.0 - 8.0 * ROOT / 3.0, 5.0];

#[cfg(test)]
mod tests {
    use super::{BASIS, COMPLEX, END_SLOPE, ERROR, INVERSE_BASIS, NODES, POLYNOMIALS, REAL, STAGES};

    /// Computes A⁻¹ from the eigenvalues and the basis.
    fn inverse() -> [[f64; STAGES]; STAGES] {
        let (alpha, beta) = COMPLEX;
        let blocks = [[REAL, 0.0, 0.0], [0.0, alpha, -beta], [0.0, beta, alpha]];
        let product = |a: [[f64; STAGES]; STAGES], b: [[f64; STAGES]; STAGES]| {
            core::array::from_fn(|i| core::array::from_fn(|j| (0..STAGES).map(|k| a[i][k] * b[k][j]).sum()))
        };
        product(product(BASIS, blocks), INVERSE_BASIS)
    }

    #[test]
    fn stages_are_collocation_at_the_nodes() {
        // z(t) = tᵖ has the slopes p tᵖ⁻¹ at the nodes.
        for power in 1..=3 {
            let values = NODES.map(|node| node.powi(power));
            for (row, node) in inverse().iter().zip(NODES) {
                let slope: f64 = row.iter().zip(values).map(|(entry, value)| entry * value).sum();
                assert!((slope - f64::from(power) * node.powi(power - 1)).abs() < 1e-13, "{power}: {slope}");
            }
        }
    }

    #[test]
    fn the_slope_at_the_end_is_the_last_row() {
        for (entry, expected) in inverse()[2].iter().zip(END_SLOPE) {
            assert!((entry - expected).abs() < 1e-13, "{entry} {expected}");
        }
    }

    #[test]
    fn polynomials_are_one_at_their_stage_and_zero_at_the_others() {
        for (stage, polynomial) in POLYNOMIALS.iter().enumerate() {
            for (other, node) in NODES.iter().enumerate() {
                let value =
                    polynomial.iter().rev().fold(0.0, |value, coefficient| (value + coefficient) * node);
                let expected = if stage == other { 1.0 } else { 0.0 };
                assert!((value - expected).abs() < 1e-13, "{stage} {other}: {value}");
            }
        }
    }

    #[test]
    fn the_error_is_of_order_three() {
        // f + Σ eᵢ zᵢ / h vanishes for t, t² and t³, with the slope f at the start.
        for power in 1..=3 {
            let sum: f64 = ERROR.iter().zip(NODES).map(|(weight, node)| weight * node.powi(power)).sum();
            let slope = if power == 1 { 1.0 } else { 0.0 };
            assert!((sum + slope).abs() < 1e-13, "{power}: {sum}");
        }
    }
}
