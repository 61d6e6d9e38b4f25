//! Equations grow in proportion to the number of bodies, counted in operations, expressions and
//! emitted tokens. That holds for chains and trees, in generalised coordinates and with pins
//! between bodies.

use std::fmt::Write;

use lagrange_core::derive::{Strategy, StrategyChoice};
use lagrange_core::pipeline::{Derived, parse};
use lagrange_core::program::{Labels, OperationCounts, lower, optimise};
use proc_macro2::{TokenStream, TokenTree};
use quote::quote;

use super::mechanisms::Mechanism;

const CHAINS: [usize; 2] = [20, 150];
const WITHOUT_MATRIX: [usize; 2] = [50, 200];
/// Sizes of trees. Smaller random trees are flat, and cheaper by a strategy that large trees do not
/// use.
const TREES: [usize; 2] = [100, 400];
/// Sizes at which trees have bodies with many pins, which couple all attached bodies.
const PINNED: [usize; 2] = [48, 144];
/// Sizes at which mass matrices are large enough that zeros are not written.
const EMITTED: [usize; 2] = [36, 144];

/// Returns n point masses on massless rods under gravity, each hanging from its parent, 0 being the
/// support.
fn pendulums(n: usize, relative: bool, parent: impl Fn(usize) -> usize) -> String {
    let mut text = "param g; let (x0, y0) = (0, 0); let a0 = 0;".to_owned();
    for i in 1..=n {
        let p = parent(i);
        let carried = if relative { format!("a{p} + ") } else { String::new() };
        write!(
            text,
            "param m{i}, l{i}; coord q{i}; let a{i} = {carried}q{i};
            let (x{i}, y{i}) = (x{p} + l{i}*sin(a{i}), y{p} - l{i}*cos(a{i}));
            kinetic = 1/2*m{i}*(dot(x{i})^2 + dot(y{i})^2); potential = m{i}*g*y{i};"
        )
        .expect("a string takes it");
    }
    text
}

fn chain(n: usize, relative: bool) -> String {
    pendulums(n, relative, |i| i - 1)
}

/// Returns the same system without the product that has n² entries.
fn without_mass_matrix(text: &str) -> String {
    format!("{text} emit {{ no mass_matrix }}")
}

/// Returns a tree in which the parent of each body is drawn from all before it. The generator is
/// linear congruential (Knuth, *The Art of Computer Programming*, vol. 2, §3.3.4, table 1, line
/// 26).
fn tree(n: usize, relative: bool) -> String {
    let mut state = 1_u64;
    let parents = (1..=n as u64).map(|i| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        ((state >> 33) % i) as usize
    });
    let parents = parents.collect::<Vec<_>>();
    pendulums(n, relative, |i| parents[i - 1])
}

/// The cost of a derivation.
struct Cost {
    bodies: usize,
    /// Operations of the accelerations.
    operations: usize,
    /// Values of their program.
    values: usize,
    /// Expressions created during the derivation, without those of the mass matrix.
    expressions: usize,
}

fn derived(text: &str, strategy: StrategyChoice) -> Derived {
    parse(text).and_then(|system| system.derive(strategy)).unwrap_or_else(|report| panic!("{report}"))
}

fn cost(bodies: usize, text: &str, strategy: StrategyChoice) -> Cost {
    let Derived { model, equations, .. } = derived(text, strategy);
    let program =
        optimise(&lower(&model.graph, &equations.accelerations, &Labels::default()), model.accuracy);
    let couplings = equations.mass_matrix.iter().flatten().filter(|&&entry| !model.graph.is_zero(entry));
    // Both triangles are counted, so this allows five expressions for each coupling.
    let of_couplings = couplings.count() * 5 / 2;
    Cost {
        bodies,
        operations: OperationCounts::of(&program).total(),
        values: program.len(),
        expressions: model.graph.len().saturating_sub(of_couplings),
    }
}

/// True if a body of a large system costs as much as one of a small system, up to a quarter. Small
/// systems have a larger share of bodies at their ends. A cost of n log n would fail.
fn is_linear(costs: &[Cost], cost: impl Fn(&Cost) -> usize) -> Result<(), Vec<usize>> {
    let per_body = costs.iter().map(|c| cost(c) / c.bodies).collect::<Vec<_>>();
    let linear = per_body.iter().all(|&each| each * 4 <= per_body[0] * 5);
    if linear { Ok(()) } else { Err(per_body) }
}

fn assert_linear(sizes: &[usize], declaration: impl Fn(usize) -> String) {
    assert_linear_on(StrategyChoice::Cheapest, sizes, declaration);
}

fn assert_linear_on(strategy: StrategyChoice, sizes: &[usize], declaration: impl Fn(usize) -> String) {
    let costs = sizes.iter().map(|&n| cost(n, &declaration(n), strategy)).collect::<Vec<_>>();
    assert_eq!(is_linear(&costs, |cost| cost.operations), Ok(()), "operations");
    assert_eq!(is_linear(&costs, |cost| cost.values), Ok(()), "values");
    assert_eq!(is_linear(&costs, |cost| cost.expressions), Ok(()), "expressions");
}

#[test]
fn chains_in_absolute_angles_grow_in_proportion() {
    assert_linear(&CHAINS, |n| chain(n, false));
}

#[test]
fn chains_in_relative_angles_grow_in_proportion() {
    assert_linear(&CHAINS, |n| chain(n, true));
}

#[test]
fn chains_whose_mass_matrix_nobody_wants_never_write_it_down() {
    for relative in [false, true] {
        assert_linear(&WITHOUT_MATRIX, |n| without_mass_matrix(&chain(n, relative)));
        let with = derived(&chain(50, relative), StrategyChoice::Cheapest);
        let without = derived(&without_mass_matrix(&chain(50, relative)), StrategyChoice::Cheapest);
        assert!(without.equations.mass_matrix.is_empty() && !with.equations.mass_matrix.is_empty());
        assert_eq!(without.equations.structure, with.equations.structure);
        assert_eq!(without.equations.costs, with.equations.costs);
        assert_eq!(without.equations.forcing.len(), 50);
    }
}

#[test]
fn the_structure_of_a_mass_matrix_that_nobody_wants_is_found_in_it_where_points_do_not_show_it() {
    let apart = pendulums(100, true, |i| if i == 51 { 0 } else { i - 1 });
    let mass = derived(&without_mass_matrix(&apart), StrategyChoice::Cheapest).equations.structure.mass;
    assert_eq!(mass.blocks, [(0..50).collect::<Vec<_>>(), (50..100).collect()]);
    let on_a_line = (1..=50).map(|i| {
        let p = i - 1;
        format!("param m{i}; coord q{i}; let x{i} = x{p} + q{i}; kinetic = 1/2*m{i}*dot(x{i})^2;")
    });
    let on_a_line = format!("let x0 = 0; {}", on_a_line.collect::<String>());
    let mass = derived(&without_mass_matrix(&on_a_line), StrategyChoice::Cheapest).equations.structure.mass;
    assert!(mass.is_constant && mass.blocks.len() == 1);
}

#[test]
fn random_trees_in_absolute_angles_grow_in_proportion() {
    assert_linear(&TREES, |n| tree(n, false));
}

#[test]
fn random_trees_in_relative_angles_grow_in_proportion() {
    assert_linear(&TREES, |n| tree(n, true));
}

/// Mechanisms that have the places and the angles of all bars as coordinates.
const MECHANISMS: [fn(usize) -> Mechanism; 3] =
    [Mechanism::chain, Mechanism::random_tree, Mechanism::four_bars];

#[test]
fn pinned_bodies_grow_in_proportion_by_every_strategy() {
    for mechanism in MECHANISMS {
        let declaration = |n| mechanism(n).declaration("standard", |i| i);
        assert_linear(&PINNED, declaration);
        assert_linear_on(StrategyChoice::Always(Strategy::MassMatrix), &PINNED, declaration);
        assert_linear_on(StrategyChoice::Always(Strategy::ArticulatedBody), &PINNED, declaration);
    }
}

#[test]
fn pinned_bodies_may_be_declared_in_any_order() {
    // Multiples of a number coprime to the sizes, which are products of twos and threes.
    let declaration = |n| Mechanism::chain(n).declaration("standard", |i| (i * 5 + 2) % n);
    assert_linear(&PINNED, declaration);
}

#[test]
fn strict_pinned_bodies_cost_at_most_twice_as_much() {
    for mechanism in MECHANISMS {
        let [standard, strict] = ["standard", "strict"].map(|level| {
            cost(48, &mechanism(48).declaration(level, |i| i), StrategyChoice::Cheapest).operations
        });
        assert!(strict <= 2 * standard, "{strict} operations beside {standard}");
    }
}

fn count(tokens: TokenStream) -> usize {
    let count_tree = |tree| match tree {
        TokenTree::Group(group) => 1 + count(group.stream()),
        _ => 1,
    };
    tokens.into_iter().map(count_tree).sum()
}

#[test]
fn code_for_pinned_bodies_grows_in_proportion() {
    let per_body = EMITTED.map(|n| {
        let derived = derived(&Mechanism::chain(n).declaration("standard", |i| i), StrategyChoice::Cheapest);
        count(derived.emit(&quote!(lagrange)).unwrap_or_else(|report| panic!("{report}"))) / n
    });
    assert!(per_body[1] * 4 <= per_body[0] * 5, "{per_body:?} tokens");
}
