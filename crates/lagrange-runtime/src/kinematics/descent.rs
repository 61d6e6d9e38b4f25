//! A damped Gauss–Newton method between limits.
//!
//! A step δ of the degrees of freedom minimises |e − J δ|² + λ |δ|². Here e are the rotation
//! vectors and displacements that lead to the goals. λ is proportional to |e|², so that steps stay
//! short far from the goal and in singular postures, and converge quadratically near it. Degrees of
//! freedom at a limit are fixed if the gradient pushes against it. If a step would pass a limit,
//! the degree of freedom stops there, and the step of the others is recomputed. Displacements are
//! measured in units of the largest lever arm for comparison with rotations. Sources: Sugihara,
//! "Solvability-unconcerned inverse kinematics by the Levenberg–Marquardt method", *IEEE Trans.
//! Robotics* 27 (2011) 984–991; Fan, Yuan, "On the quadratic convergence of the Levenberg–Marquardt
//! method without nonsingularity assumption", *Computing* 74 (2005) 23–39.
//!
//! Under constraints a step δ moves the system by P δ. Here P projects displacements onto those
//! permitted by the constraints on positions, in the metric of the mass matrix. J P replaces J, and
//! positions are then brought back onto the constraints. P is the projection of velocities, unless
//! there are constraints on velocities, which exclude no posture. The trace of a projection is the
//! number of degrees of freedom, which reveals such constraints. P is then the derivative of the
//! projection of positions, by central differences of relative error ε^⅔. Limits hold during the
//! search for degrees of freedom that no constraint couples to others. All others are checked at
//! its end.
//!
//! Fits solve the same kind of problem by singular values, in `f64` with heap allocation. Their
//! data are numerous and their variables badly scaled. Here steps must be cheap and of fixed size.
//!
//! Example: a rod of length 1 at θ = 0 whose end should be at height 1/2. e = ½, J = 1, and with λ
//! = |e|²/10 = 0.025 the step is 0.5/1.025 = 0.488. Then e = 0.0313 and the next steps lead to θ =
//! 0.523 and π/6.

use super::limit::Limit;
use super::task::FrameTask;
use crate::linalg::singular::regular;
use crate::linalg::vector::dot;
use crate::scalar::{Number, Scalar};
use crate::system::{MechanicalSystem, OdeSystem, StepFailure, displaced, join, split};

/// Maximum number of steps of a search from one start.
const MAX_STEPS: u32 = 100;
/// Initial λ relative to the squared error.
const FIRST_DAMPING: f64 = 0.1;
/// λ falls by the factor [`GROWTH`] after a step that achieves more than this fraction of the
/// predicted decrease.
const GOOD: f64 = 0.75;
/// λ grows by the factor [`GROWTH`] after a step that achieves less than this fraction of the
/// predicted decrease.
const POOR: f64 = 0.25;
const GROWTH: f64 = 4.0;
/// Minimum λ, in units of rounding: with more degrees of freedom than rows, JᵀJ is singular.
const ROUNDING: f64 = 256.0;
/// The search is abandoned beyond this λ, relative to the squared error.
const MAX_DAMPING: f64 = 1e12;
/// The search ends when the predicted decrease of the squared error is below this fraction of it.
const LEAST_DECREASE: f64 = 1e-13;

/// Frames, their goals, and limits.
pub(super) struct Goals<'a, M: MechanicalSystem, const N: usize> {
    pub(super) system: &'a M,
    pub(super) tasks: &'a [FrameTask<M, N>],
    pub(super) time: M::Scalar,
    /// Limits of the coordinate that each velocity changes.
    pub(super) limits: [Option<Limit<M::Scalar>>; N],
    /// The angle, and the distance in lever arms, within which a frame counts as at its goal.
    pub(super) tolerance: M::Scalar,
}

impl<M: OdeSystem + MechanicalSystem<Velocities = [<M as OdeSystem>::Scalar; N]>, const N: usize>
    Goals<'_, M, N>
{
    /// Returns the nearest positions that satisfy the constraints.
    pub(super) fn restored(&self, q: M::Coordinates) -> Result<M::Coordinates, StepFailure<M::Scalar>> {
        if !self.system.is_constrained() {
            return Ok(q);
        }
        let mut y = join::<M>(&q, &[M::Scalar::ZERO; N]);
        self.system.restore(self.time, &mut y)?;
        Ok(split::<M>(&y).0)
    }

    /// True if there are constraints on velocities alone.
    fn has_constraints_of_velocities(&self, q: &M::Coordinates) -> bool {
        let trace = |columns: [[M::Scalar; N]; N]| (0..N).fold(M::Scalar::ZERO, |sum, j| sum + columns[j][j]);
        let more = trace(self.allowed_displacements(q)) - trace(self.allowed_velocities(q));
        more > M::Scalar::from_f64(0.5)
    }

    /// Returns the columns of P as a projection of velocities; zero if constraints cannot be
    /// satisfied.
    fn allowed_velocities(&self, q: &M::Coordinates) -> [[M::Scalar; N]; N] {
        let projected = |v: [M::Scalar; N]| {
            let mut y = join::<M>(q, &v);
            self.system.restore(self.time, &mut y).ok().map(|()| split::<M>(&y).1)
        };
        // Moving constraints require a velocity of their own.
        let own = projected([M::Scalar::ZERO; N]);
        core::array::from_fn(|j| match (projected(unit(j)), own) {
            (Some(found), Some(own)) => core::array::from_fn(|i| found[i] - own[i]),
            _ => [M::Scalar::ZERO; N],
        })
    }

    /// Returns the columns of P as a projection of displacements; zero if constraints cannot be
    /// satisfied.
    fn allowed_displacements(&self, q: &M::Coordinates) -> [[M::Scalar; N]; N] {
        let reach = M::Scalar::epsilon().powf(M::Scalar::from_f64(1.0 / 3.0));
        core::array::from_fn(|j| {
            let beside = |h| self.restored(displaced(self.system, self.time, q, [(h, &unit(j))]));
            let (Ok(behind), Ok(ahead)) = (beside(-reach), beside(reach)) else {
                return [M::Scalar::ZERO; N];
            };
            let way = self.system.displacement(self.time, &behind, &ahead);
            way.map(|entry| entry / (reach + reach))
        })
    }
}

fn unit<S: Number, const N: usize>(place: usize) -> [S; N] {
    core::array::from_fn(|i| if i == place { S::ONE } else { S::ZERO })
}

/// A search from one start.
pub(super) struct Descent<'a, M: MechanicalSystem, const N: usize> {
    goals: &'a Goals<'a, M, N>,
    /// The unit of displacements: the largest lever arm at the start.
    pub(super) lever: M::Scalar,
    has_constraints_of_velocities: bool,
}

/// An intermediate posture of the search.
pub(super) struct PostureTrial<M: MechanicalSystem> {
    pub(super) q: M::Coordinates,
    /// The sum of the squares of angles, and of distances in lever arms.
    pub(super) cost: M::Scalar,
    /// The largest angle, or distance in lever arms.
    worst: M::Scalar,
}

impl<M: MechanicalSystem> PostureTrial<M> {
    /// Returns a trial that is rejected, used if constraints cannot be satisfied.
    fn failed(&self) -> Self {
        PostureTrial { q: self.q, cost: M::Scalar::NAN, worst: self.worst }
    }
}

/// JᵀJ and Jᵀe of a posture, with J P in place of J under constraints.
struct Normal<S, const N: usize> {
    /// The columns of P, if there are constraints.
    allowed: Option<[[S; N]; N]>,
    matrix: [[S; N]; N],
    right: [S; N],
    /// The largest diagonal entries so far in the search.
    scales: [S; N],
}

impl<'a, M, const N: usize> Descent<'a, M, N>
where
    M: OdeSystem + MechanicalSystem<Velocities = [<M as OdeSystem>::Scalar; N]>,
{
    pub(super) fn new(goals: &'a Goals<'a, M, N>, start: &M::Coordinates) -> Self {
        let mut lever = M::Scalar::ZERO;
        for task in goals.tasks {
            let rows = task.jacobian(goals.system, goals.time, start);
            for j in 0..N {
                let square = |rows: &[[M::Scalar; N]]| {
                    rows.iter().fold(M::Scalar::ZERO, |sum, row| row[j].multiply_add(row[j], sum))
                };
                let (turns, moves) = (square(&rows[..3]), square(&rows[3..]));
                if turns > M::Scalar::ZERO {
                    lever = lever.max((moves / turns).sqrt());
                }
            }
        }
        Descent {
            goals,
            lever: if lever > M::Scalar::ZERO { lever } else { M::Scalar::ONE },
            has_constraints_of_velocities: goals.system.is_constrained()
                && goals.has_constraints_of_velocities(start),
        }
    }

    /// Moves to the goals, or to a posture from which no step leads nearer. `None` if frames are
    /// not finite at the start.
    pub(super) fn run(&self, start: M::Coordinates, iterations: &mut u32) -> Option<PostureTrial<M>> {
        let mut now = Some(self.trial(start)).filter(|now| now.cost.is_finite())?;
        let mut normal = self.normal(&now.q, &[M::Scalar::ZERO; N]);
        let mut damping = M::Scalar::from_f64(FIRST_DAMPING);
        for _ in 0..MAX_STEPS {
            if self.is_reached(&now) || damping > M::Scalar::from_f64(MAX_DAMPING) {
                break;
            }
            *iterations += 1;
            let rounding = M::Scalar::from_f64(ROUNDING) * M::Scalar::epsilon();
            let step = self.step(&now.q, &normal, (damping * now.cost).max(rounding));
            let expected = normal.decrease(&step);
            let moved = self.goals.restored(self.moved(&now.q, &normal, &step));
            let next = moved.map_or_else(|_| now.failed(), |q| self.trial(q));
            let is_level = expected <= M::Scalar::from_f64(LEAST_DECREASE) * now.cost;
            if is_level || !expected.is_finite() {
                break;
            }
            damping = adapted(damping, (now.cost - next.cost) / expected);
            if next.cost < now.cost {
                now = next;
                normal = self.normal(&now.q, &normal.scales);
            }
        }
        Some(now)
    }

    /// True if all frames are at their goals.
    pub(super) fn is_reached(&self, trial: &PostureTrial<M>) -> bool {
        trial.worst <= self.goals.tolerance
    }

    fn trial(&self, q: M::Coordinates) -> PostureTrial<M> {
        let (mut cost, mut worst) = (M::Scalar::ZERO, M::Scalar::ZERO);
        for task in self.goals.tasks {
            let error = task.error(self.goals.system, self.goals.time, &q);
            for size in [error.angle(), error.distance() / self.lever] {
                cost = size.multiply_add(size, cost);
                worst = worst.max(size);
            }
        }
        PostureTrial { q, cost, worst }
    }

    fn normal(&self, q: &M::Coordinates, scales: &[M::Scalar; N]) -> Normal<M::Scalar, N> {
        let (mut matrix, mut right) = ([[M::Scalar::ZERO; N]; N], [M::Scalar::ZERO; N]);
        let allowed = self.goals.system.is_constrained().then(|| match self.has_constraints_of_velocities {
            true => self.goals.allowed_displacements(q),
            false => self.goals.allowed_velocities(q),
        });
        for task in self.goals.tasks {
            let rows = task.rows(self.goals.system, self.goals.time, q);
            let error = task.error(self.goals.system, self.goals.time, q);
            let errors = error.rotation.iter().chain(&error.displacement);
            for (index, (row, error)) in rows.iter().zip(errors).enumerate() {
                let unit = if index < 3 { M::Scalar::ONE } else { self.lever };
                let row = row.map(|entry| entry / unit);
                let row = allowed.map_or(row, |allowed| allowed.map(|column| dot(&row, &column)));
                for (i, entry) in row.iter().enumerate() {
                    right[i] = entry.multiply_add(*error / unit, right[i]);
                    matrix[i] = core::array::from_fn(|j| entry.multiply_add(row[j], matrix[i][j]));
                }
            }
        }
        Normal { allowed, matrix, right, scales: core::array::from_fn(|j| scales[j].max(matrix[j][j])) }
    }

    /// Computes the step of all degrees of freedom, within the limits.
    fn step(&self, q: &M::Coordinates, normal: &Normal<M::Scalar, N>, damping: M::Scalar) -> [M::Scalar; N] {
        let value = |limit: &Limit<M::Scalar>| q.as_ref()[limit.position];
        let limits: [_; N] = core::array::from_fn(|j| self.limit(normal, j));
        let mut is_free: [bool; N] = core::array::from_fn(|j| {
            limits[j].is_none_or(|limit| !limit.holds(value(limit), normal.right[j]))
        });
        let mut step = [M::Scalar::ZERO; N];
        // Each iteration moves at least one degree of freedom to its limit.
        for _ in 0..=N {
            step = normal.step(&is_free, &step, damping);
            let mut is_within = true;
            for j in 0..N {
                let Some(limit) = limits[j].filter(|_| is_free[j]) else { continue };
                let to = value(limit) + step[j];
                if limit.nearest(to) != to {
                    (step[j], is_free[j], is_within) = (limit.nearest(to) - value(limit), false, false);
                }
            }
            if is_within {
                break;
            }
        }
        step
    }

    /// Returns the limit of a degree of freedom that no constraint couples to others.
    fn limit(&self, normal: &Normal<M::Scalar, N>, freedom: usize) -> Option<&Limit<M::Scalar>> {
        self.goals.limits[freedom].as_ref().filter(|_| !normal.is_coupled(freedom))
    }

    /// Returns the posture after a step.
    fn moved(
        &self,
        q: &M::Coordinates,
        normal: &Normal<M::Scalar, N>,
        step: &[M::Scalar; N],
    ) -> M::Coordinates {
        let Goals { system, time, .. } = self.goals;
        let mut q = displaced(*system, *time, q, [(M::Scalar::ONE, &normal.motion(step))]);
        // Rounding may exceed the limits.
        for limit in (0..N).filter_map(|j| self.limit(normal, j)) {
            let entry = &mut q.as_mut()[limit.position];
            *entry = limit.nearest(*entry);
        }
        q
    }
}

impl<S: Scalar, const N: usize> Normal<S, N> {
    /// Returns the decrease |e|² − |e − J δ|² predicted by the linear equations.
    fn decrease(&self, step: &[S; N]) -> S {
        let shorter: [S; N] =
            core::array::from_fn(|i| self.right[i] + self.right[i] - dot(&self.matrix[i], step));
        dot(step, &shorter)
    }

    /// True if constraints prevent this degree of freedom from moving alone.
    fn is_coupled(&self, freedom: usize) -> bool {
        let is_off = |(i, entry): (usize, &S)| {
            let unit = if i == freedom { S::ONE } else { S::ZERO };
            (*entry - unit).abs() > S::epsilon().sqrt()
        };
        self.allowed.as_ref().is_some_and(|allowed| allowed[freedom].iter().enumerate().any(is_off))
    }

    /// Returns the motion P δ of a step.
    fn motion(&self, step: &[S; N]) -> [S; N] {
        let Some(allowed) = &self.allowed else { return *step };
        let of = |i: usize| (0..N).fold(S::ZERO, |sum, j| allowed[j][i].multiply_add(step[j], sum));
        core::array::from_fn(of)
    }

    /// Computes the step of the free degrees of freedom for given steps of the others.
    fn step(&self, is_free: &[bool; N], fixed: &[S; N], damping: S) -> [S; N] {
        let (mut free, mut count) = ([0; N], 0);
        let mut step = *fixed;
        for j in (0..N).filter(|&j| is_free[j]) {
            (free[count], step[j], count) = (j, S::ZERO, count + 1);
        }
        let (mut matrix, mut right) = ([[S::ZERO; N]; N], [S::ZERO; N]);
        for (place, &i) in free[..count].iter().enumerate() {
            right[place] = self.right[i] - dot(&self.matrix[i], &step);
            for (other, &j) in free[..count].iter().enumerate() {
                matrix[place][other] = self.matrix[i][j];
            }
            let scale = if self.scales[i] > S::ZERO { self.scales[i] } else { S::ONE };
            matrix[place][place] = damping.multiply_add(scale, matrix[place][place]);
        }
        let solution = regular(&matrix, &right, count);
        free[..count].iter().zip(solution).for_each(|(&j, entry)| step[j] = entry);
        step
    }
}

/// Returns the damping after a step that achieved this fraction of the predicted decrease.
fn adapted<S: Scalar>(damping: S, ratio: S) -> S {
    let growth = S::from_f64(GROWTH);
    if ratio > S::from_f64(GOOD) {
        damping / growth
    } else if ratio > S::from_f64(POOR) {
        damping
    } else {
        damping * growth
    }
}
