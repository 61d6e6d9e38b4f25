//! The swing-up of a pole on a cart with minimum effort, by direct collocation.
//!
//! Within 2 s the cart moves by 1 m, and the pole from hanging to upright. Both are at rest before
//! and after. The integral of u² is minimised. The problem is that of Kelly, "An introduction to
//! trajectory optimization: how to do your own direct collocation", *SIAM Review* 59 (2017)
//! 849–904, appendix E.1.
//!
//! The method is that of Hermite and Simpson. States are cubic and forces quadratic between nodes,
//! and the equations of motion hold at both ends and in the middle. The macro emits their
//! derivatives with respect to states and force.
//!
//! The nonlinear program is solved by sequential quadratic programs (Nocedal, Wright, *Numerical
//! Optimization*, 2nd ed., §18), at first with the Hessian of the effort alone. Near the solution
//! they use the Hessian of the Lagrangian, from differences of the exact gradients; these are steps
//! of Newton's method. Limits of force and rail are not part of the program; a check confirms that
//! the solution satisfies them.
//!
//! References: CasADi and Ipopt with handwritten equations, on the same grid (`tools/optimal.py`).
//! Look for the pole, which swings back before it swings up.
//!
//! `cargo run --example swing_up --features draw,linear,plot`

#[path = "common/gallery.rs"]
mod gallery;

mod common;

use std::error::Error;
use std::f64::consts::PI;

use common::compare;
use lagrange::Simulate;
use lagrange::draw::Drawing;
use lagrange::linear::DenseMatrix;
use lagrange::plot::label::Label;
use lagrange::plot::notation::formula;
use lagrange::plot::{Curve, Figure, Panel};

lagrange::system! {
    /// A cart on a rail with a point mass on a massless pole.
    #[derive(Clone, Debug)]
    pub struct CartPole;

    param m1: kg = 1, m2: kg = 0.3, l: m = 0.5, g: m/s^2 = 9.81;
    coord x: m, theta: rad;
    input u: N;
    gravity = (0, -g);
    line rail { through: (0, -0.08); }
    body cart { mass: m1; shape: rectangle(0.3, 0.16); center: (x, 0); }
    body bob {
        mass: m2;
        shape: point_mass();
        center: cart.center + l * (sin(theta), -cos(theta));
        angle: theta;
        visual { slender_rod(l), at: (0, l/2), angle: pi/2; disk(0.05); }
    }
    slide cart.point(0, -0.08 m) on rail;
    pin cart to bob.point(0, l);
    force x = u;
    output tip = bob.center;
    emit { system_matrix, drawing }
}

const DURATION: f64 = 2.0;
const DISTANCE: f64 = 1.0;
/// Largest force in N, and largest distance from the start in m.
const LIMITS: [f64; 2] = [20.0, 2.0];
/// Intervals of the grid.
const COUNT: usize = 30;
const STEP: f64 = DURATION / COUNT as f64;
/// Unknowns of a node and the middle after it: the state, the force, and the force in the middle.
const NODE: usize = 6;
/// Unknowns of an interval: those of its node, and state and force of the next node.
const LOCAL: usize = 11;
const UNKNOWNS: usize = NODE * COUNT + 5;
/// Number of equations: the equations of motion, and the conditions at both ends.
const EQUATIONS: usize = 4 * COUNT + 8;

/// Effort, first and last force, and largest forces to the left and right, by Ipopt.
const REFERENCE: [f64; 5] =
    [58.80960350000821, 1.9336140174757521, -1.840018814025952, -13.957859123845422, 8.98080889443547];

fn main() -> Result<(), Box<dyn Error>> {
    let cart = CartPole::default();
    let plan = optimal(&cart)?;
    let forces = forces(&plan);
    let extreme = |pick: fn(f64, f64) -> f64| forces.iter().copied().fold(0.0, pick);
    let computed = [effort(&plan), forces[0], forces[2 * COUNT], extreme(f64::min), extreme(f64::max)];
    let names = ["effort, N^2 s", "first force, N", "last force", "to the left", "to the right"];
    let rows: [_; 5] = std::array::from_fn(|i| (names[i], computed[i], REFERENCE[i]));
    compare("the plan", 1e-8, &rows);
    assert!(forces.iter().all(|force| force.abs() < LIMITS[0]), "the force is limited");
    assert!((0..=COUNT).all(|k| plan[NODE * k].abs() < LIMITS[1]), "the rail ends");

    // The forces of the plan move the cart; the plan is not exact between the nodes.
    let law = |_: &CartPole, t: f64, _: CartPoleState| CartPoleInputs { u: force_at(&forces, t) };
    let nodes = (1..COUNT).map(|k| k as f64 * STEP);
    let run =
        cart.simulate([0.0; 4]).drive(law).restart_at(nodes).until(DURATION).every(0.02).tolerance(1e-12);
    let run = run.run()?;
    let [x, theta, ..] = run.last();
    compare("simulated", 5e-3, &[("x, m", x, DISTANCE), ("theta, rad", theta, PI)]);

    plot(&plan, &forces)?;
    let film = Drawing::of(&cart).title("A swing-up").nameless().size(560.0, 360.0);
    let film = film.trace("", |cart, t, y| cart.tip(t, &[y[0], y[1]], &[y[2], y[3]]));
    film.film(&run)?.save(gallery::picture("swing_up.svg")?)?;
    Ok(())
}

/// Computes the plan, starting from a straight line between the ends, without force.
fn optimal(cart: &CartPole) -> Result<Vec<f64>, Box<dyn Error>> {
    let mut plan = vec![0.0; UNKNOWNS];
    for k in 0..=COUNT {
        let part = k as f64 / COUNT as f64;
        (plan[NODE * k], plan[NODE * k + 1]) = (part * DISTANCE, part * PI);
    }
    let (mut multipliers, mut weight) = (None, 0.0_f64);
    for iteration in 0..100 {
        let program = Program::at(cart, &plan);
        let (step, found) =
            program.step(cart, &plan, multipliers.as_deref()).ok_or("no step is determined")?;
        let is_near = multipliers.is_some();
        let largest = largest(&step);
        weight = weight.max(1.5 * self::largest(&found));
        let part = if is_near { 1.0 } else { shortened(cart, &plan, &step, weight) };
        plan.iter_mut().zip(&step).for_each(|(entry, step)| *entry += part * step);
        println!("step {iteration:2} by {largest:8.1e}, effort {:.9}, part {part}", effort(&plan));
        if largest < 1e-10 {
            return Ok(plan);
        }
        multipliers = (is_near || largest < NEAR).then_some(found);
    }
    Err("it does not converge".into())
}

/// Step size below which Newton's method is used.
const NEAR: f64 = 0.1;

/// Returns the fraction of a step that decreases the combined effort and weighted defects.
fn shortened(cart: &CartPole, plan: &[f64], step: &[f64], weight: f64) -> f64 {
    let merit = |part: f64| {
        let plan = plan.iter().zip(step).map(|(entry, step)| entry + part * step).collect::<Vec<_>>();
        let defects = Program::at(cart, &plan).defects;
        effort(&plan) + weight * defects.iter().map(|defect| defect.abs()).sum::<f64>()
    };
    let now = merit(0.0);
    (0..20).map(|k| 0.5_f64.powi(k)).find(|part| merit(*part) < now).unwrap_or(0.0)
}

/// Defects of a plan, and their derivatives.
struct Program {
    defects: Vec<f64>,
    gradients: DenseMatrix,
}

impl Program {
    fn at(cart: &CartPole, plan: &[f64]) -> Program {
        let mut program = Program { defects: Vec::new(), gradients: DenseMatrix::zeros(EQUATIONS, UNKNOWNS) };
        for k in 0..COUNT {
            let (defect, gradient) = collocated(cart, &plan[NODE * k..NODE * k + LOCAL]);
            program.defects.extend(defect);
            for i in 0..4 {
                (0..LOCAL).for_each(|j| program.gradients[(4 * k + i, NODE * k + j)] = gradient[(i, j)]);
            }
        }
        let ends = [[0.0; 4], [DISTANCE, PI, 0.0, 0.0]];
        for (first, end) in [0, NODE * COUNT].into_iter().zip(ends) {
            for (i, wanted) in end.into_iter().enumerate() {
                program.gradients[(program.defects.len(), first + i)] = 1.0;
                program.defects.push(plan[first + i] - wanted);
            }
        }
        program
    }

    /// Returns the step to the minimum effort under linearised equations, and its multipliers. With
    /// multipliers, the curvature of the equations is also included.
    fn step(
        &self,
        cart: &CartPole,
        plan: &[f64],
        multipliers: Option<&[f64]>,
    ) -> Option<(Vec<f64>, Vec<f64>)> {
        let mut matrix = DenseMatrix::zeros(UNKNOWNS + EQUATIONS, UNKNOWNS + EQUATIONS);
        let mut right = vec![0.0; UNKNOWNS + EQUATIONS];
        for (j, share) in shares() {
            matrix[(j, j)] = 2.0 * share;
            right[j] = -2.0 * share * plan[j];
        }
        for i in 0..EQUATIONS {
            for j in 0..UNKNOWNS {
                let gradient = self.gradients[(i, j)];
                (matrix[(UNKNOWNS + i, j)], matrix[(j, UNKNOWNS + i)]) = (gradient, gradient);
            }
            right[UNKNOWNS + i] = -self.defects[i];
        }
        for k in 0..multipliers.map_or(0, |_| COUNT) {
            let curvature =
                curvature(cart, &plan[NODE * k..NODE * k + LOCAL], &multipliers?[4 * k..4 * k + 4]);
            for i in 0..LOCAL {
                (0..LOCAL).for_each(|j| matrix[(NODE * k + i, NODE * k + j)] += curvature[(i, j)]);
            }
        }
        let mut step = matrix.solve(&right)?;
        let multipliers = step.split_off(UNKNOWNS);
        Some((step, multipliers))
    }
}

/// Returns the defect of an interval, and its derivatives with respect to the unknowns of the
/// interval.
fn collocated(cart: &CartPole, local: &[f64]) -> ([f64; 4], DenseMatrix) {
    let (from, to): ([f64; 4], [f64; 4]) =
        (std::array::from_fn(|i| local[i]), std::array::from_fn(|i| local[NODE + i]));
    let ((f0, by0), (f1, by1)) = (rates(cart, from, local[4]), rates(cart, to, local[NODE + 4]));
    let (by0, by1) = (placed(&by0, 0), placed(&by1, NODE));
    let [unit0, unit1] = [0, NODE].map(|at| placed(&DenseMatrix::identity(4), at));

    let middle = std::array::from_fn(|i| 0.5 * (from[i] + to[i]) + STEP / 8.0 * (f0[i] - f1[i]));
    let of_middle = unit0.plus(1.0, &unit1).scaled(0.5).plus(STEP / 8.0, &by0.plus(-1.0, &by1));
    let (fm, by_middle) = rates(cart, middle, local[5]);
    let by_state = DenseMatrix::from_fn(4, 4, |i, j| by_middle[(i, j)]);
    let by_force = placed(&DenseMatrix::from_fn(4, 1, |i, _| by_middle[(i, 4)]), 5);
    let bym = by_state.times(&of_middle).plus(1.0, &by_force);

    let defect = std::array::from_fn(|i| to[i] - from[i] - STEP / 6.0 * (f0[i] + 4.0 * fm[i] + f1[i]));
    let all = by0.plus(4.0, &bym).plus(1.0, &by1);
    (defect, unit1.plus(-1.0, &unit0).plus(-STEP / 6.0, &all))
}

/// Returns the emitted rates of the state under a force, and their derivatives with respect to
/// both.
fn rates(cart: &CartPole, y: [f64; 4], u: f64) -> ([f64; 4], DenseMatrix) {
    let driven = CartPole { u, ..*cart };
    let matrix = driven.system_matrix(0.0, &y);
    (driven.rhs(0.0, &y), DenseMatrix::from_fn(4, 5, |i, j| matrix[i][j]))
}

/// Places columns among those of an interval.
fn placed(columns: &DenseMatrix, at: usize) -> DenseMatrix {
    let shown = at..at + columns.columns();
    DenseMatrix::from_fn(4, LOCAL, |i, j| if shown.contains(&j) { columns[(i, j - at)] } else { 0.0 })
}

/// Computes the second derivatives of λᵀ times the defect of an interval, by central differences.
fn curvature(cart: &CartPole, local: &[f64], multipliers: &[f64]) -> DenseMatrix {
    let gradient = |j: usize, by: f64| {
        let mut moved = local.to_vec();
        moved[j] += by;
        DenseMatrix::from_fn(1, 4, |_, i| multipliers[i]).times(&collocated(cart, &moved).1)
    };
    let by = 1e-5;
    let slopes = (0..LOCAL).map(|j| gradient(j, by).plus(-1.0, &gradient(j, -by)).scaled(0.5 / by));
    let slopes = slopes.collect::<Vec<_>>();
    DenseMatrix::from_fn(LOCAL, LOCAL, |i, j| 0.5 * (slopes[i][(0, j)] + slopes[j][(0, i)]))
}

/// Returns Simpson's weights of the squares of the forces, by their index among the unknowns.
fn shares() -> impl Iterator<Item = (usize, f64)> {
    let of_ends = |k: usize| if k == 0 || k == COUNT { STEP / 6.0 } else { STEP / 3.0 };
    let ends = (0..=COUNT).map(move |k| (NODE * k + 4, of_ends(k)));
    ends.chain((0..COUNT).map(|k| (NODE * k + 5, 4.0 * STEP / 6.0)))
}

/// Computes the integral of u².
fn effort(plan: &[f64]) -> f64 {
    shares().map(|(place, share)| share * plan[place] * plan[place]).sum()
}

/// Returns the forces at nodes and middles, in temporal order.
fn forces(plan: &[f64]) -> Vec<f64> {
    (0..=2 * COUNT).map(|k| plan[NODE * (k / 2) + 4 + k % 2]).collect()
}

/// Returns the force at a time, quadratic in each interval.
fn force_at(forces: &[f64], t: f64) -> f64 {
    let k = ((t / STEP) as usize).min(COUNT - 1);
    let s = t / STEP - k as f64;
    let [before, middle, after] = [0, 1, 2].map(|i| forces[2 * k + i]);
    (1.0 - s) * (1.0 - 2.0 * s) * before + 4.0 * s * (1.0 - s) * middle + s * (2.0 * s - 1.0) * after
}

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |most, value| most.max(value.abs()))
}

/// Plots position and angle at the nodes, and forces, over time.
fn plot(plan: &[f64], forces: &[f64]) -> Result<(), Box<dyn Error>> {
    let curve = |name: &str, points: Vec<(f64, f64)>| Curve { name: Label::parse(name), points };
    let of_nodes = |entry: usize| (0..=COUNT).map(|k| (k as f64 * STEP, plan[NODE * k + entry])).collect();
    let panel = |y: &str, curves: Vec<Curve>| Panel {
        x: Label::parse("time in s"),
        y: Label::parse(y),
        curves,
        ..Panel::default()
    };
    let [x, theta] =
        [("x", "m"), ("theta", "rad")].map(|(name, unit)| format!("{} in {unit}", formula(name)));
    let force = forces.iter().enumerate().map(|(k, force)| (0.5 * k as f64 * STEP, *force)).collect();
    let motion = panel("plan", vec![curve(&x, of_nodes(0)), curve(&theta, of_nodes(1))]);
    let panels = vec![motion, panel("force in N", vec![curve("force", force)])];
    Figure { panels, columns: 1, size: (720, 300) }.save(&gallery::picture("swing_up_plan.svg")?)?;
    Ok(())
}
