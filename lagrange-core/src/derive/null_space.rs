//! The null space of a matrix, with sparse basis vectors.

/// Returns a basis of the vectors x with A x = 0, where entries below `rounding` count as zero.
/// Each basis vector has a one in a position where all others have a zero.
///
/// The method is Gauss–Jordan elimination with pivots in the leftmost possible columns. For
/// example, A = (1, 1, 0) has its pivot in the first column, and the basis is (−1, 1, 0), (0, 0,
/// 1).
pub(super) fn null_space(mut rows: Vec<Vec<f64>>, columns: usize, rounding: f64) -> Vec<Vec<f64>> {
    let mut pivots = Vec::new();
    for column in 0..columns {
        let rest = pivots.len();
        let largest =
            (rest..rows.len()).max_by(|&a, &b| rows[a][column].abs().total_cmp(&rows[b][column].abs()));
        let Some(largest) = largest.filter(|&row| rows[row][column].abs() > rounding) else { continue };
        rows.swap(rest, largest);
        eliminate(&mut rows, rest, column);
        pivots.push(column);
    }
    let free = (0..columns).filter(|column| !pivots.contains(column));
    let vector = |column: usize| {
        let mut vector = vec![0.0; columns];
        vector[column] = 1.0;
        pivots.iter().zip(&rows).for_each(|(&pivot, row)| vector[pivot] = -row[column]);
        vector
    };
    free.map(vector).collect()
}

/// Clears a column in all rows except the pivot row, and scales the pivot to one.
fn eliminate(rows: &mut [Vec<f64>], pivot: usize, column: usize) {
    let scale = rows[pivot][column];
    rows[pivot].iter_mut().for_each(|entry| *entry /= scale);
    let pivot_row = rows[pivot].clone();
    for (index, row) in rows.iter_mut().enumerate() {
        let factor = if index == pivot { 0.0 } else { row[column] };
        row.iter_mut().zip(&pivot_row).for_each(|(entry, of_pivot)| *entry -= factor * of_pivot);
    }
}

#[cfg(test)]
mod tests {
    use super::null_space;

    #[test]
    fn bases_are_annihilated_and_complete() {
        let rows = vec![vec![1.0, 2.0, 0.0, 4.0], vec![2.0, 4.0, 1.0, 8.0], vec![3.0, 6.0, 1.0, 12.0]];
        let basis = null_space(rows.clone(), 4, 1e-12);
        assert_eq!(basis, [[-2.0, 1.0, 0.0, 0.0], [-4.0, 0.0, 0.0, 1.0]]);
        for (row, vector) in rows.iter().flat_map(|row| basis.iter().map(move |vector| (row, vector))) {
            assert_eq!(row.iter().zip(vector).map(|(a, b)| a * b).sum::<f64>(), 0.0);
        }
        assert_eq!(null_space(Vec::new(), 2, 1e-12), [[1.0, 0.0], [0.0, 1.0]]);
        assert!(null_space(vec![vec![0.0, 1.0], vec![1.0, 0.0]], 2, 1e-12).is_empty());
    }
}
