//! Random trees of bodies against Newton's and Euler's equations in the world, written with forty
//! digits by `tools/spatial_trees.py`.

use lagrange_core::derive::{Strategy, StrategyChoice};

use crate::cases::{Case, cases};
use crate::comparison::{assert_none, failures};

/// Strategies, which the trees use in turn.
const CHOICES: [StrategyChoice; 4] = [
    StrategyChoice::Cheapest,
    StrategyChoice::Always(Strategy::MassMatrix),
    StrategyChoice::Always(Strategy::ArticulatedBody),
    StrategyChoice::Always(Strategy::SumOfSquares),
];
/// Number of velocities beyond which trees are not derived in every way.
const MAX_VELOCITIES: usize = 4;
/// Velocities of a free body. Strict equations of some, which keep all roundings apart, take a
/// minute.
const FREE: usize = 6;
const LEVELS: [&str; 3] = ["fast", "standard", "strict"];

fn trees() -> Vec<Case> {
    let trees = cases("trees.txt");
    assert!(trees.len() >= 200, "there are {}", trees.len());
    trees
}

/// Judges every second tree, so that two tests share the time.
fn failures_of_half(half: usize) -> Vec<String> {
    let trees = trees();
    let chosen = trees.iter().enumerate().filter(|(index, _)| index % 2 == half);
    let wrong =
        chosen.flat_map(|(index, tree)| failures(tree, "standard", CHOICES[index / 2 % CHOICES.len()]));
    wrong.collect()
}

#[test]
#[ignore = "takes half a minute: `cargo xtask sweeps`"]
fn every_second_tree_moves_as_newton_and_euler_say() {
    assert_none(&failures_of_half(0));
}

#[test]
fn every_other_tree_moves_as_newton_and_euler_say() {
    assert_none(&failures_of_half(1));
}

/// Returns the numbers of positions and of velocities.
fn size(tree: &Case) -> [usize; 2] {
    ["q", "v"].map(|word| tree.states[0].numbers(word).len())
}

/// True if a tree has ball joints or free bodies.
fn is_oriented(tree: &Case) -> bool {
    let [positions, velocities] = size(tree);
    positions > velocities
}

/// Returns the failures of some trees, by all strategies.
fn failures_by_all<'a>(trees: impl Iterator<Item = &'a Case>, levels: &[&str]) -> Vec<String> {
    let ways = |tree| {
        let ways = CHOICES.iter().flat_map(|choice| levels.iter().map(|level| (*choice, *level)));
        ways.flat_map(|(choice, level)| failures(tree, level, choice)).collect::<Vec<_>>()
    };
    trees.flat_map(ways).collect()
}

#[test]
fn small_trees_move_so_whatever_the_strategy_and_the_level() {
    let trees = trees();
    let small = trees.iter().filter(|tree| !is_oriented(tree) && size(tree)[1] <= MAX_VELOCITIES);
    assert_none(&failures_by_all(small.step_by(8), &LEVELS));
}

#[test]
fn small_trees_with_quaternions_move_so_whatever_the_strategy_and_the_level() {
    let trees = trees();
    let oriented = trees.iter().filter(|tree| is_oriented(tree)).collect::<Vec<_>>();
    assert!(oriented.len() >= 50, "there are {}", oriented.len());
    let of_size = |least: usize, most: usize| {
        let of_size = oriented.iter().filter(move |tree| (least..=most).contains(&size(tree)[1]));
        of_size.copied()
    };
    assert_none(&failures_by_all(of_size(0, MAX_VELOCITIES).step_by(4), &LEVELS));
    assert_none(&failures_by_all(of_size(FREE, FREE).step_by(7), &LEVELS[..1]));
}

#[test]
fn a_weight_that_is_a_little_lighter_is_noticed() {
    let mut tree = trees().into_iter().find(|tree| tree.text.contains("-9.81")).expect("one with gravity");
    tree.text = tree.text.replace("-9.81", "-9.80999999999");
    let wrong = failures(&tree, "standard", StrategyChoice::Cheapest);
    assert!(wrong.iter().any(|what| what.contains("accelerations off by")), "{wrong:?}");
}

#[test]
fn a_body_that_is_turned_a_little_further_is_noticed() {
    let is_driven = |tree: &Case| tree.text.contains("gravity = (1.5") || tree.text.contains("-9.81");
    let is_top = |tree: &Case| size(tree) == [4, 3] && tree.text.contains("centroid") && is_driven(tree);
    let mut tree = trees().into_iter().find(is_top).expect("one body on a ball");
    for state in &mut tree.states {
        let [w, x, y, z] = *state.numbers("q") else { panic!("a quaternion") };
        // Times (1, 1e-9, 0, 0).
        *state.numbers_mut("q") = vec![w - 1e-9 * x, x + 1e-9 * w, y + 1e-9 * z, z - 1e-9 * y];
    }
    let wrong = failures(&tree, "standard", StrategyChoice::Cheapest);
    assert!(wrong.iter().any(|what| what.contains("accelerations off by")), "{wrong:?}");
}
