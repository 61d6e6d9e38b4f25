//! Quantiles over time, grids and maps.

use std::fs;
use std::path::PathBuf;

use lagrange::Ensembles;
use lagrange::ensemble::{Grid, Samples};
use lagrange::event::Direction;
#[cfg(feature = "plot")]
use lagrange::{ensemble::Map, simulate::PlotError};

lagrange::system! {
    /// A body of mass 1 moves uniformly; one without mass does not move at all.
    #[derive(Clone)]
    struct Body;
    param m = 1.0;
    coord x;
    kinetic = 1/2 * m * dot(x)^2;
    force x = 1 / m - 1;
}

lagrange::system! {
    /// A bead on a wire.
    #[derive(Clone)]
    struct Bead;
    param m: kg = 1.0;
    coord x: m;
    kinetic = 1/2 * m * dot(x)^2;
}

/// Returns eleven bodies with speeds 0, 1, … 10. One fails, and those that reach 11 stop there.
fn bodies() -> Samples<Body> {
    let bodies = Body::default();
    let bodies = bodies.ensemble(12).start(|i, _| [0.0, i as f64]).parameters(|i, body| {
        body.m = if i == 11 { 0.0 } else { 1.0 };
    });
    let bodies = bodies.until(2.0).every(0.5).stop_at("wall", Direction::Rising, |_, _, [x, _]| x - 11.0);
    bodies.run().expect("runs")
}

#[test]
fn quantiles_are_those_of_the_motions_that_are_there() {
    let samples = bodies();
    assert_eq!((samples.times(), samples.failures().count()), (&[0.0, 0.5, 1.0, 1.5, 2.0][..], 1));
    let found = samples.quantiles("x", &[0.0, 0.25, 0.5, 1.0]).expect("a column");
    // A quarter of the speeds from 0 to 10 is at most 2.5. At 1.5 s those from 8 on have stopped,
    // and at 2 s those from 6 on.
    let wanted = [[0.0, 0.0, 0.0], [0.0, 1.25, 2.5], [0.0, 2.5, 5.0], [0.0, 5.0, 10.0]];
    for (found, wanted) in found.iter().zip(wanted) {
        let near = found.iter().zip(wanted).all(|(found, wanted)| (found - wanted).abs() < 1e-9);
        assert!(found.len() == 5 && near, "{found:?} {wanted:?}");
    }
    let late: Vec<f64> = found.iter().map(|quantiles| quantiles[3]).collect();
    assert!(
        late.iter().zip([0.0, 2.625, 5.25, 10.5]).all(|(late, wanted)| (late - wanted).abs() < 1e-9),
        "{late:?}"
    );
    assert!(samples.quantiles("x", &[f64::NAN]).expect("a column")[0].iter().all(|value| value.is_nan()));
    assert!(samples.quantiles("y", &[0.5]).is_none());
}

#[test]
fn a_grid_counts_cells_in_rows() {
    let grid = Grid::new(("x", 0.0..4.0, 4), ("y", -1.0..1.0, 2));
    assert_eq!((grid.len(), grid.is_empty()), (8, false));
    assert_eq!([grid.at(0), grid.at(3), grid.at(4)], [[0.5, -0.5], [3.5, -0.5], [0.5, 0.5]]);
    assert!(Grid::new(("x", 0.0..1.0, 0), ("y", 0.0..1.0, 5)).is_empty());
    assert_eq!(Grid::new(("x", 0.0..1.0, usize::MAX), ("y", 0.0..1.0, 5)).len(), usize::MAX);
}

#[cfg(feature = "plot")]
fn written(name: &str, save: impl FnOnce(PathBuf) -> Result<(), PlotError>) -> String {
    let path = std::env::temp_dir().join(format!("lagrange_{}_{name}.svg", std::process::id()));
    save(path.clone()).expect("plots");
    let text = fs::read_to_string(&path).expect("is there");
    fs::remove_file(path).expect("was there");
    text
}

/// True if a plot has these labels, as text or as outlines.
#[cfg(feature = "plot")]
fn has_labels(svg: &str, wanted: &[&str]) -> bool {
    let has = |wanted: &&str| {
        svg.contains(&format!(">{wanted}<")) || svg.contains(&format!("aria-label=\"{wanted}\""))
    };
    wanted.iter().all(has)
}

#[cfg(feature = "plot")]
#[test]
fn quantiles_are_drawn() {
    let samples = bodies();
    let svg = written("quantiles", |path| samples.plot_quantiles("x", path));
    let labels = ["90 %", "50 %", "median", "time ", "t", " in s", "x"];
    assert!(has_labels(&svg, &labels), "{svg}");
    let unknown = samples.plot_quantiles("y", "y.svg").expect_err("no such column");
    assert_eq!(unknown.to_string(), "there is no column `y`; the columns are `x`, `x_dot`");
}

#[cfg(feature = "plot")]
#[test]
fn ends_are_a_map_over_the_grid_of_their_starts() {
    let grid = Grid::new(("x", 0.0..4.0, 4), ("x_dot", -1.0..1.0, 2));
    let ends = Bead::default().ensemble(grid.len()).start(|i, _| grid.at(i)).until(1.0).run().expect("runs");
    let map = ends.map(&grid, "x").expect("a column");
    let svg = written("map", |path| {
        map.clone().named("where it is").curve("rest", [(0.0, 0.0), (4.0, 0.0)]).save(path)
    });
    assert!(has_labels(&svg, &[" in m", "x\u{307} in m/s", "where it is"]), "{svg}");
    assert_eq!(svg.matches("<image").count(), 2);
    let plain = Map::new(&grid, "x", ends.column("x").expect("a column").to_vec()).expect("fits");
    let svg = written("plain", |path| plain.save(path));
    assert!(has_labels(&svg, &["x", "x\u{307}"]), "{svg}");
    assert!(ends.map(&grid, "t").is_ok());

    assert!(matches!(ends.map(&grid, "y"), Err(PlotError::UnknownColumn { .. })));
    let other = Grid::new(("x", 0.0..4.0, 4), ("y", -1.0..1.0, 3));
    let refused = ends.map(&other, "x").expect_err("too many cells");
    assert_eq!(refused.to_string(), "a map of 12 cells needs a value for each; there are 8");
    for range in [1.0..1.0, 1.0..-1.0, 0.0..f64::INFINITY, f64::NAN..1.0] {
        let grid = Grid::new(("x", 0.0..4.0, 4), ("y", range, 2));
        let refused = ends.map(&grid, "x").expect_err("no range");
        assert_eq!(refused.to_string(), "the range of `y` must go from a finite number to a larger one");
    }
}
