//! Public models of robots against Pinocchio: accelerations, inverse dynamics and mass matrices,
//! written by `tools/spatial_models.py`.

use lagrange_core::derive::{Strategy, StrategyChoice};

use crate::cases::{Case, cases, read};
use crate::comparison::{assert_none, failures};

fn model(name: &str) -> Case {
    let mut states = cases(&format!("models/{name}.txt"));
    let case = states.pop().expect("a system");
    assert!(states.is_empty() && case.states.len() >= 11, "{name}");
    Case { text: read(&format!("models/{name}.lag")), ..case }
}

fn assert_agreement(name: &str, ways: &[(&str, StrategyChoice)]) {
    let model = model(name);
    let wrong = ways.iter().flat_map(|(level, choice)| failures(&model, level, *choice));
    assert_none(&wrong.collect::<Vec<_>>());
}

const ALL: [(&str, StrategyChoice); 6] = [
    ("standard", StrategyChoice::Cheapest),
    ("standard", StrategyChoice::Always(Strategy::MassMatrix)),
    ("standard", StrategyChoice::Always(Strategy::ArticulatedBody)),
    ("standard", StrategyChoice::Always(Strategy::SumOfSquares)),
    ("fast", StrategyChoice::Cheapest),
    ("strict", StrategyChoice::Cheapest),
];

#[test]
fn arms_move_as_pinocchio_says() {
    assert_agreement("ur5", &ALL);
    assert_agreement("panda", &ALL[..1]);
}

#[test]
fn chains_of_universal_joints_move_as_pinocchio_says() {
    assert_agreement("universal_2", &ALL);
    assert_agreement("universal_5", &ALL[2..5]);
    assert_agreement("universal_10", &ALL[2..3]);
}

#[test]
fn a_quadruped_moves_as_pinocchio_says() {
    assert_agreement("go2", &ALL[2..3]);
}

#[test]
fn free_bodies_and_ball_joints_move_as_pinocchio_says() {
    assert_agreement("ball_2", &ALL);
    assert_agreement("ball_5", &ALL[2..3]);
    assert_agreement("go2_free", &ALL[2..3]);
}
