//! Random trees of point masses on massless links, and their accelerations by all strategies.

use std::f64::consts::PI;
use std::fmt::Write;

use crate::cases::cases;
use crate::random::Random;
use crate::reference::Reference;
use crate::trial::{DENSE, RECURSIVE, SQUARES, Sample, Subject};

/// Numbers of bodies, with the number of trees for each.
const SIZES: [(usize, usize); 6] = [(1, 2), (2, 6), (5, 6), (12, 4), (30, 2), (60, 2)];
const SEED: u64 = 60;
/// The largest errors of the mass matrix and of the other strategies, relative to the largest
/// acceleration in the scales of the mass matrix. The condition of the mass matrix grows with a
/// power of the number of links, but does not affect the other strategies.
const BOUNDS: [f64; 2] = [1e-10, 1e-13];

/// The shape of a tree.
#[derive(Clone, Copy, Debug)]
enum Shape {
    Chain,
    Branching,
}

/// The direction from which angles are measured.
#[derive(Clone, Copy, Debug)]
enum Angles {
    Absolute,
    Relative,
    /// Either of them, body by body.
    Mixed,
}

/// All pairs, used in turn.
const KINDS: [(Shape, Angles); 6] = [
    (Shape::Chain, Angles::Absolute),
    (Shape::Branching, Angles::Relative),
    (Shape::Chain, Angles::Relative),
    (Shape::Branching, Angles::Mixed),
    (Shape::Chain, Angles::Mixed),
    (Shape::Branching, Angles::Absolute),
];

/// Returns the declaration of a tree with `n` bodies. Half of the trees have torsion springs at
/// their joints.
fn declaration(n: usize, shape: Shape, angles: Angles, random: &mut Random) -> String {
    let mut text = "const g = 9.81; let p0 = (0, 0); let a0 = 0;\n".to_owned();
    let has_springs = random.below(2) == 0;
    for i in 1..=n {
        let parent = match shape {
            Shape::Chain => i - 1,
            Shape::Branching => random.below(i),
        };
        let is_relative = match angles {
            Angles::Absolute => false,
            Angles::Relative => true,
            Angles::Mixed => random.below(2) == 0,
        };
        let [mass, length, stiffness] = [(); 3].map(|()| random.between(0.5, 2.0));
        let base = if is_relative { format!("a{parent} + ") } else { String::new() };
        write!(
            text,
            "param m{i} = {mass}, l{i} = {length}; coord q{i}; let a{i} = {base}q{i};
             let p{i} = p{parent} + (l{i}*sin(a{i}), -l{i}*cos(a{i}));
             kinetic = kinetic_energy(m{i}, dot(p{i})); potential = gravitational_energy(m{i}, g, p{i}.y);\n"
        )
        .expect("a string takes it");
        if has_springs {
            writeln!(text, "potential = spring_energy({stiffness}, a{i} - a{parent});")
                .expect("a string takes it");
        }
    }
    text
}

fn state(n: usize, random: &mut Random) -> Sample {
    let mut numbers = |size: f64| (0..n).map(|_| random.between(-size, size)).collect::<Vec<_>>();
    Sample { settings: Vec::new(), t: 0.0, q: numbers(PI), v: numbers(2.0) }
}

#[test]
fn all_strategies_agree_with_the_reference_on_random_trees() {
    let mut random = Random::new(SEED);
    let mut kinds = KINDS.into_iter().cycle();
    println!("\nbodies, errors by the mass matrix, body by body, and by squares");
    for (n, count) in SIZES {
        for (shape, angles) in kinds.by_ref().take(cases(count)) {
            let text = declaration(n, shape, angles, &mut random);
            let sample = state(n, &mut random);
            let truth = Reference::new(&text).truth(&sample).expect("a regular state");
            let ways = [DENSE, RECURSIVE, SQUARES];
            let [dense, recursive, squares] =
                ways.map(|way| Subject::new(&text, way).errors(&sample, &truth).scaled);
            println!("{n:3} {dense:.0e} {recursive:.0e} {squares:.0e} {shape:?}, {angles:?}");
            let is_kept = dense <= BOUNDS[0] && recursive.max(squares) <= BOUNDS[1];
            assert!(is_kept, "{dense:e}, {recursive:e} or {squares:e}: {text}{sample:?}");
        }
    }
}
