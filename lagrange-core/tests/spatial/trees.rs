//! Random trees of bodies against Newton's and Euler's equations in the world, written with forty digits by `tools/spatial_trees.py`.

use lagrange_core::derive::{Strategy, StrategyChoice};

use crate::cases::{Case, cases};
use crate::comparison::{assert_none, failures};

/// Each tree is derived by one of them in turn.
const CHOICES: [StrategyChoice; 4] = [
    StrategyChoice::Cheapest,
    StrategyChoice::Always(Strategy::MassMatrix),
    StrategyChoice::Always(Strategy::ArticulatedBody),
    StrategyChoice::Always(Strategy::SumOfSquares),
];
/// Trees with more coordinates are not derived in every way.
const MOST_COORDINATES: usize = 4;

fn trees() -> Vec<Case> {
    let trees = cases("trees.txt");
    assert!(trees.len() >= 200, "there are {}", trees.len());
    trees
}

/// Every second tree, so that two tests share the time.
fn failures_of_half(half: usize) -> Vec<String> {
    let trees = trees();
    let chosen = trees.iter().enumerate().filter(|(index, _)| index % 2 == half);
    let wrong =
        chosen.flat_map(|(index, tree)| failures(tree, "standard", CHOICES[index / 2 % CHOICES.len()]));
    wrong.collect()
}

#[test]
fn every_second_tree_moves_as_newton_and_euler_say() {
    assert_none(&failures_of_half(0));
}

#[test]
fn every_other_tree_moves_as_newton_and_euler_say() {
    assert_none(&failures_of_half(1));
}

#[test]
fn small_trees_move_so_whatever_the_strategy_and_the_level() {
    let trees = trees();
    let small = trees.iter().filter(|tree| tree.states[0].numbers("q").len() <= MOST_COORDINATES);
    let small = small.step_by(8).collect::<Vec<_>>();
    let wrong = small.into_iter().flat_map(|tree| {
        let ways =
            CHOICES.iter().flat_map(|choice| ["fast", "standard", "strict"].map(|level| (*choice, level)));
        ways.flat_map(|(choice, level)| failures(tree, level, choice))
    });
    assert_none(&wrong.collect::<Vec<_>>());
}

#[test]
fn a_weight_that_is_a_little_lighter_is_noticed() {
    let mut tree = trees().into_iter().find(|tree| tree.text.contains("-9.81")).expect("one with gravity");
    tree.text = tree.text.replace("-9.81", "-9.80999999999");
    let wrong = failures(&tree, "standard", StrategyChoice::Cheapest);
    assert!(wrong.iter().any(|what| what.contains("accelerations off by")), "{wrong:?}");
}
