//! Equations of motion from energies alone.
//!
//! Let δL be the change of L(τ) under a displacement η of a velocity's positions. With `F = ∂L/∂q`
//! and `p = ∂L/∂q̇` it is `F η + p η̇`, so that `η = 1` gives F, and `η = τ` gives p and `F + ṗ`.
//! So `ṗ − F`, the left side of Lagrange's equations, is a coefficient of a series, for rotations
//! and other quasi-coordinates, too. See Goldstein, Poole and Safko, *Classical Mechanics*, 3rd
//! ed., §2.2. It is affine in the accelerations, and so are second rates of constraints. Hence one
//! more motion for each acceleration gives M, A and the remainders of both.

use std::collections::HashMap;

use crate::digits::Real;
use crate::jet::{Field, Jet};
use crate::layout::Layout;
use crate::linear::solve;
use crate::tree::{Declaration, Statement};
use crate::world::{State, Sums, World};

/// Results by name.
pub(crate) type Results = Vec<(String, Vec<Real>)>;

/// Accelerations without constraints, since constrained ones may be small differences of these.
pub(crate) const FREE: &str = "free accelerations";

/// A declaration at a state, with accelerations that forces should produce.
pub(crate) struct Question<'a> {
    pub(crate) declaration: &'a Declaration,
    pub(crate) layout: &'a Layout,
    pub(crate) state: &'a State,
    pub(crate) wanted: &'a [f64],
}

/// Left side, momenta, constraints and other results along one motion.
struct Motion {
    left: Vec<Real>,
    momenta: Vec<Real>,
    energy: Real,
    /// Forces of declared loads and losses.
    forces: Vec<Real>,
    /// Derivatives of constraints by the velocities, and their rates.
    slopes: Vec<Vec<Real>>,
    drifts: Vec<Real>,
    sums: Sums,
}

impl Question<'_> {
    /// Returns all results of a system, or `None` where something has no value.
    pub(crate) fn results(&self, field: &mut Field) -> Option<Results> {
        let n = self.layout.velocities;
        field.variations = 2 * n;
        let mut roots = HashMap::new();
        let rest = vec![field.integer(0); n];
        let state_rates = match self.layout.states.len() {
            0 => Vec::new(),
            _ => self.sums(field, &rest, None, false, &mut roots)?.state_rates,
        };
        let base = self.motion(field, &rest, &state_rates, false, &mut roots)?;
        let mut columns = Vec::with_capacity(n);
        for j in 0..n {
            let mut unit = rest.clone();
            unit[j] = field.integer(1);
            columns.push(self.motion(field, &unit, &state_rates, true, &mut roots)?);
        }
        let arithmetic = &field.arithmetic;
        let difference = |of: &dyn Fn(&Motion) -> Real| {
            columns.iter().map(|column| arithmetic.subtract(&of(column), &of(&base))).collect::<Vec<_>>()
        };
        let mass = (0..n).map(|i| difference(&|motion| motion.left[i].clone())).collect::<Vec<_>>();
        let forcing = base.forces.iter().zip(&base.left).map(|(q, left)| arithmetic.subtract(q, left));
        let forcing = forcing.collect::<Vec<_>>();
        let m = base.drifts.len();
        let rows = (0..m).map(|k| difference(&|motion| motion.drifts[k].clone())).collect::<Vec<_>>();
        let mut matrix = Vec::new();
        for (i, row) in mass.iter().enumerate() {
            matrix.extend(row.iter().cloned());
            matrix.extend(base.slopes.iter().map(|slopes| slopes[i].neg()));
        }
        for row in &rows {
            matrix.extend(row.iter().cloned());
            matrix.extend(vec![arithmetic.integer(0); m]);
        }
        let drifts = base.drifts.iter().map(Real::neg).collect::<Vec<_>>();
        let right = [jittered(field, &forcing), drifts].concat();
        let arithmetic = &field.arithmetic;
        let mut accelerations = solve(arithmetic, &matrix, &right)?;
        let free = if m == 0 { None } else { solve(arithmetic, &mass.concat(), &forcing) };
        let multipliers = accelerations.split_off(n);
        let wanted = self.wanted.iter().map(|a| arithmetic.float(*a)).collect::<Vec<_>>();
        let needed =
            mass.iter().zip(&forcing).map(|(row, f)| arithmetic.subtract(&arithmetic.dot(row, &wanted), f));
        let needed = needed.collect();
        let has_outputs = !base.sums.outputs.is_empty();
        let along = match has_outputs {
            true => self.sums(field, &accelerations, Some(&state_rates), false, &mut roots)?.outputs,
            false => Vec::new(),
        };
        let mut results = vec![
            ("accelerations".to_owned(), accelerations),
            ("multipliers".to_owned(), multipliers),
            ("state rates".to_owned(), state_rates),
            ("energy".to_owned(), vec![base.energy]),
            ("momenta".to_owned(), base.momenta),
            ("mass matrix".to_owned(), mass.concat()),
            ("forcing".to_owned(), forcing),
            ("inverse dynamics".to_owned(), needed),
        ];
        results.extend(free.map(|free| (FREE.to_owned(), free)));
        if !self.is_lagrangian() {
            results.push(("kinetic energy".to_owned(), vec![base.sums.kinetic.value[0].clone()]));
            results.push(("potential energy".to_owned(), vec![base.sums.potential.value[0].clone()]));
        }
        for (name, value) in along {
            let value =
                value.iter().map(|component| component.value.first().cloned()).collect::<Option<_>>()?;
            results.push((format!("output {name}"), value));
        }
        let is_number = |value: &Real| !value.is_nan() && !value.is_inf();
        results.iter().all(|(_, values)| values.iter().all(is_number)).then_some(results)
    }

    fn is_lagrangian(&self) -> bool {
        self.declaration.statements.iter().any(|s| matches!(s, Statement::Energy("lagrangian", _)))
    }

    /// Returns the sums over all statements.
    fn sums(
        &self,
        field: &mut Field,
        accelerations: &[Real],
        state_rates: Option<&[Real]>,
        only_energies: bool,
        roots: &mut HashMap<String, Real>,
    ) -> Option<Sums> {
        let mut world = World::new(field, self.layout, self.state, accelerations, state_rates);
        world.only_energies = only_energies;
        world.roots = std::mem::take(roots);
        let statements = &self.declaration.statements;
        statements.iter().try_for_each(|statement| world.read(statement))?;
        for statement in statements {
            if let Statement::Body(body) = statement {
                world.add_energies(body)?;
            }
        }
        *roots = world.roots;
        Some(world.sums)
    }

    fn motion(
        &self,
        field: &mut Field,
        accelerations: &[Real],
        state_rates: &[Real],
        only_energies: bool,
        roots: &mut HashMap<String, Real>,
    ) -> Option<Motion> {
        let n = self.layout.velocities;
        let sums = self.sums(field, accelerations, Some(state_rates), only_energies, roots)?;
        let lagrangian = field.subtract(&sums.kinetic, &sums.potential);
        let lagrangian = field.add(&lagrangian, &sums.lagrangian);
        let left = (0..n).map(|i| {
            let stays = field.change(&lagrangian, i, 0);
            let twice = field.sum(&stays, &stays);
            let grows = field.change(&lagrangian, n + i, 1);
            field.sum(&grows, &twice.neg())
        });
        let left = left.collect();
        let momenta = (0..n).map(|i| field.change(&lagrangian, n + i, 0)).collect::<Vec<_>>();
        let mut energy = lagrangian.value[0].neg();
        for (momentum, velocity) in momenta.iter().zip(&self.state.v) {
            let velocity = field.arithmetic.float(*velocity);
            let product = field.product(momentum, &velocity);
            energy = field.sum(&energy, &product);
        }
        let losses = (0..n).map(|i| field.change(&sums.dissipation, n + i, 0).neg()).collect::<Vec<_>>();
        let forces = sums.forces.iter().zip(&losses).map(|(force, loss)| field.sum(force, loss)).collect();
        let slopes = sums.constraints.iter().map(|(zero, holds_rates)| {
            let first = if *holds_rates { n } else { 0 };
            (0..n).map(|i| field.change(zero, first + i, 0)).collect()
        });
        let slopes = slopes.collect();
        let drifts = sums.constraints.iter().map(|(zero, holds_rates)| drift(field, zero, *holds_rates));
        let drifts = drifts.collect();
        Some(Motion { left, momenta, energy, forces, slopes, drifts, sums })
    }
}

/// Returns the rate of a constraint on velocities, or the second rate of one on positions.
fn drift(field: &mut Field, zero: &Jet, holds_rates: bool) -> Real {
    let rate = field.rate(zero);
    if holds_rates { rate.value[0].clone() } else { field.rate(&rate).value[0].clone() }
}

/// Perturbs forces by a rounding of the largest, as for sums that nearly vanish.
fn jittered(field: &mut Field, forces: &[Real]) -> Vec<Real> {
    let zero = field.integer(0);
    let largest = forces.iter().fold(zero, |largest, force| largest.max(&force.abs()));
    let each = forces.iter().zip(1..).map(|(force, place)| {
        // The noise differs for each force.
        let size = field.arithmetic.multiply(&largest, &field.integer(place));
        let off = field.rounded(size.clone());
        let off = field.arithmetic.subtract(&off, &size);
        field.arithmetic.add(force, &off)
    });
    each.collect()
}
