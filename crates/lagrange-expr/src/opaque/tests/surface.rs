//! Monotone tables of two arguments.

use super::super::{Interpolation, Outside, Table};

/// Numbers from 0 to 1, by a linear congruential generator with Knuth's constants.
struct Random(u64);

impl Random {
    fn number(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// Returns a step that is often zero, and varies by four orders of magnitude otherwise.
    fn rise(&mut self) -> f64 {
        if self.number() < 0.4 { 0.0 } else { 10.0_f64.powf(4.0 * self.number() - 2.0) }
    }

    fn knots(&mut self) -> Vec<f64> {
        let count = 2 + (self.number() * 4.0) as usize;
        let mut knots = vec![self.number() - 0.5];
        while knots.len() < count {
            knots.push(knots[knots.len() - 1] + 10.0_f64.powf(2.0 * self.number() - 1.0));
        }
        knots
    }
}

fn monotone(axes: &[Vec<f64>; 2], values: &[f64]) -> Table {
    Table::new(axes.to_vec(), values, Interpolation::Monotone, Outside::Extend)
}

/// Returns numbers between the ends of knots, which include the knots and what is close to them.
fn dense(knots: &[f64]) -> Vec<f64> {
    let parts = [0.0, 1e-4, 0.04, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 0.96, 0.9999];
    let between = knots.windows(2).flat_map(|ends| parts.map(|part| ends[0] + part * (ends[1] - ends[0])));
    between.chain([knots[knots.len() - 1]]).collect()
}

/// Returns the signs with which the values at both corners of an edge change monotonically toward
/// the opposite edge.
fn signs(from: [f64; 2], to: [f64; 2]) -> [bool; 2] {
    let rises = [to[0] - from[0], to[1] - from[1]];
    [rises.iter().all(|rise| *rise >= 0.0), rises.iter().all(|rise| *rise <= 0.0)]
}

/// Asserts that a derivative has one of these signs, up to a rounding error of this size.
fn assert_sign(derivative: f64, [rises, falls]: [bool; 2], error: f64, text: &str) {
    assert!(!rises || derivative >= -error, "{derivative} falls, {text}");
    assert!(!falls || derivative <= error, "{derivative} rises, {text}");
}

/// Values are nowhere below the previous ones along either argument, nor beyond the corners of the
/// grid. Half of the grids have steps of zero and of very different sizes.
#[test]
fn a_thousand_random_monotone_grids_are_monotone_along_every_line() {
    let mut random = Random(1);
    for case in 0..1000 {
        let axes = [random.knots(), random.knots()];
        let (rows, columns) = (axes[0].len(), axes[1].len());
        let mut values = vec![0.0; rows * columns];
        for index in 0..values.len() {
            let left = if index % columns > 0 { values[index - 1] } else { 0.0 };
            let below = if index >= columns { values[index - columns] } else { 0.0 };
            values[index] = f64::max(left, below) + random.rise();
        }
        let table = monotone(&axes, &values);
        assert!(table.goes_through(&values) && table.is_finite(), "case {case}");
        let highest = values[values.len() - 1];
        let error = 1e-13 * highest;
        let [across, along] = [dense(&axes[0]), dense(&axes[1])];
        let surface = across.iter().map(|x| along.iter().map(|y| table.value(&[0, 0], &[*x, *y])).collect());
        let surface = surface.collect::<Vec<Vec<f64>>>();
        for (i, line) in surface.iter().enumerate() {
            for (j, value) in line.iter().enumerate() {
                assert!((values[0] - error..=highest + error).contains(value), "case {case}");
                assert!(i == 0 || *value >= surface[i - 1][j] - error, "case {case} at {i}, {j}");
                assert!(j == 0 || *value >= line[j - 1] - error, "case {case} at {i}, {j}");
            }
        }
    }
}

/// Cells in which the values of both edges rise, or both fall, have slopes of that sign. Cells of
/// saddles and peaks beside them are free.
#[test]
fn each_cell_is_monotone_along_each_argument_along_which_its_values_are() {
    let mut random = Random(2);
    let mut monotone_cells = 0;
    for case in 0..500 {
        let axes = [random.knots(), random.knots()];
        let columns = axes[1].len();
        let values = (0..axes[0].len() * columns).map(|_| random.rise() * (random.number() - 0.5).signum());
        let values = values.collect::<Vec<_>>();
        let table = monotone(&axes, &values);
        let error = 1e-11 * table.largest_value();
        for (row, ends) in axes[0].windows(2).enumerate() {
            for (column, sides) in axes[1].windows(2).enumerate() {
                let corner = |i: usize, j: usize| values[(row + i) * columns + column + j];
                let along_first = signs([corner(0, 0), corner(0, 1)], [corner(1, 0), corner(1, 1)]);
                let along_second = signs([corner(0, 0), corner(1, 0)], [corner(0, 1), corner(1, 1)]);
                monotone_cells += usize::from(along_first != [false; 2]);
                for part in 0..100 {
                    let parts = [0.05 + 0.1 * f64::from(part % 10), 0.05 + 0.1 * f64::from(part / 10)];
                    let x = [
                        ends[0] + parts[0] * (ends[1] - ends[0]),
                        sides[0] + parts[1] * (sides[1] - sides[0]),
                    ];
                    let text = format!("case {case} at {x:?}");
                    assert_sign(table.value(&[1, 0], &x), along_first, error / (ends[1] - ends[0]), &text);
                    assert_sign(table.value(&[0, 1], &x), along_second, error / (sides[1] - sides[0]), &text);
                }
            }
        }
    }
    assert!(monotone_cells > 1000, "{monotone_cells}");
}

/// Values, both slopes and the twist are those of the adjacent cells, at all points of the grid
/// and beyond its ends.
#[test]
fn first_derivatives_are_continuous() {
    let axes = [vec![0.0, 1.0, 3.0], vec![-1.0, 0.0, 0.5, 2.0]];
    let values = [0.0, 1.0, 1.0, 4.0, 0.5, 1.0, 3.0, 4.0, 0.5, 6.0, 7.0, 20.0];
    let table = monotone(&axes, &values);
    for (i, value) in values.iter().enumerate() {
        let [x, y] = [axes[0][i / 4], axes[1][i % 4]];
        assert!((table.value(&[0, 0], &[x, y]) - value).abs() < 1e-13);
    }
    for orders in [[0, 0], [1, 0], [0, 1], [1, 1]] {
        for y in dense(&axes[1]) {
            for x in &axes[0] {
                let [before, after] = [-1e-12, 1e-12].map(|by| table.value(&orders, &[x + by, y]));
                assert!((before - after).abs() < 1e-9, "{orders:?} at {x}, {y}: {before}, {after}");
            }
        }
        for x in dense(&axes[0]) {
            for y in &axes[1] {
                let [before, after] = [-1e-12, 1e-12].map(|by| table.value(&orders, &[x, y + by]));
                assert!((before - after).abs() < 1e-9, "{orders:?} at {x}, {y}: {before}, {after}");
            }
        }
    }
}

#[test]
fn values_that_depend_on_one_argument_are_those_of_one_argument() {
    let knots = vec![0.0, 1.0, 1.5, 3.0, 3.5, 6.0];
    let values = [0.0, 0.5, 2.0, 2.0, 1.0, -4.0];
    let line = Table::new(vec![knots.clone()], &values, Interpolation::Monotone, Outside::Extend);
    let others = vec![-1.0, 0.0, 7.0];
    let repeated = values.iter().flat_map(|value| [*value; 3]).collect::<Vec<_>>();
    let first = monotone(&[knots.clone(), others.clone()], &repeated);
    let second = monotone(&[others, knots.clone()], &[values; 3].concat());
    for x in dense(&knots).into_iter().chain([-2.0, 8.0]) {
        for other in [-3.0, -1.0, -0.5, 0.0, 4.0, 7.0, 9.0] {
            for order in 0..3 {
                let expected = line.value(&[order], &[x]);
                let found = [first.value(&[order, 0], &[x, other]), second.value(&[0, order], &[other, x])];
                assert_eq!(found, [expected; 2], "order {order} at {x}, {other}");
                assert_eq!(first.value(&[order, 1], &[x, other]), 0.0);
            }
        }
    }
}

/// Exchanging the arguments exchanges them in the surface; a sum of bilinear terms that rises is
/// reproduced.
#[test]
fn both_arguments_are_treated_alike_and_bilinear_values_are_exact() {
    let axes = [vec![0.0, 1.0, 3.0, 4.0], vec![0.0, 0.5, 2.0]];
    let at = |x: f64, y: f64| 1.0 + 2.0 * x + 0.5 * y + 3.0 * x * y;
    let steep = |x: f64, y: f64| (x + 0.1).powi(4) * (0.2 + y * y);
    let grid = |f: &dyn Fn(f64, f64) -> f64| {
        axes[0].iter().flat_map(|x| axes[1].iter().map(|y| f(*x, *y))).collect::<Vec<f64>>()
    };
    let bilinear = monotone(&axes, &grid(&at));
    let turned = axes[1].iter().flat_map(|y| axes[0].iter().map(|x| steep(*x, *y))).collect::<Vec<f64>>();
    let [straight, turned] =
        [monotone(&axes, &grid(&steep)), monotone(&[axes[1].clone(), axes[0].clone()], &turned)];
    for x in dense(&axes[0]) {
        for y in dense(&axes[1]) {
            assert!((bilinear.value(&[0, 0], &[x, y]) - at(x, y)).abs() < 1e-13, "{x}, {y}");
            let [a, b] = [straight.value(&[0, 0], &[x, y]), turned.value(&[0, 0], &[y, x])];
            assert!((a - b).abs() < 1e-12 * straight.largest_value(), "{a} or {b} at {x}, {y}");
        }
    }
}

/// The product of two rising polynomials on finer and finer grids.
#[test]
fn errors_fall_with_the_square_of_the_spacing_at_least() {
    let at = |x: f64, y: f64| (x + x * x) * (1.0 + y * y * y) + y;
    let error = |count: u32| {
        let knots = (0..=count).map(|i| f64::from(i) / f64::from(count)).collect::<Vec<_>>();
        let values = knots.iter().flat_map(|x| knots.iter().map(|y| at(*x, *y))).collect::<Vec<_>>();
        let table = monotone(&[knots.clone(), knots], &values);
        let places = (0..=200).map(|i| f64::from(i) / 200.0).collect::<Vec<_>>();
        let errors = places
            .iter()
            .flat_map(|x| places.iter().map(|y| (table.value(&[0, 0], &[*x, *y]) - at(*x, *y)).abs()));
        errors.fold(0.0, f64::max)
    };
    let errors = [4, 8, 16].map(error);
    assert!(errors.windows(2).all(|pair| pair[1] < 0.28 * pair[0]), "{errors:?}");
    assert!(errors[2] < 5e-3, "{errors:?}");
}

#[test]
fn values_at_the_limits_of_numbers_are_finite_or_refused() {
    for scale in [1e-300, 1e290, f64::MAX / 4.0] {
        let table = monotone(
            &[vec![0.0, 1e-3], vec![0.0, 1e-3, 1.0]],
            &[0.0, 1.0, 1.0, 1.0, 2.0, 4.0].map(|v| v * scale),
        );
        assert_eq!(table.is_finite(), scale < 1e300, "{scale}");
    }
}
