//! Postures in which frames are at their goals: the settings of a search, and the search from its
//! starts.

use super::descent::{Descent, Goals};
use super::error::{ReachError, Shortfall};
use super::limit::Limit;
use super::task::FrameTask;
use crate::linalg::singular::negligible;
use crate::scalar::{Number, Scalar};
use crate::spread::spread;
use crate::system::{MechanicalSystem, OdeSystem, displaced};

/// Range of starts without limits, in rad or units of the coordinate.
const REACH: f64 = core::f64::consts::PI;

/// A result of a search on a system.
type SearchResult<M, T> =
    Result<T, ReachError<<M as MechanicalSystem>::Coordinates, <M as OdeSystem>::Scalar>>;

/// Inverse kinematics of systems whose velocities are an array.
pub trait InverseKinematics<const N: usize>:
    OdeSystem + MechanicalSystem<Velocities = [<Self as OdeSystem>::Scalar; N]>
{
    /// Searches for positions in which the frames of all tasks are at their goals, starting from
    /// `near`. If there are several postures, one close to `near` is found. Coordinates remain in
    /// their declared ranges. Constraints hold throughout; the search begins at the positions
    /// nearest to `near` that satisfy them.
    fn reach<'a>(&'a self, tasks: &'a [FrameTask<Self, N>], near: &Self::Coordinates) -> Reach<'a, Self, N>
    where
        Self: Sized,
    {
        Reach {
            goals: Goals {
                system: self,
                tasks,
                time: <Self as OdeSystem>::Scalar::ZERO,
                limits: declared_limits(self),
                tolerance: negligible(),
            },
            near: *near,
            starts: 1,
            mistake: None,
        }
    }
}

impl<M, const N: usize> InverseKinematics<N> for M where
    M: OdeSystem + MechanicalSystem<Velocities = [<M as OdeSystem>::Scalar; N]>
{
}

/// A search for a posture.
#[must_use = "a search does nothing before `solve`"]
pub struct Reach<'a, M: MechanicalSystem, const N: usize> {
    goals: Goals<'a, M, N>,
    near: M::Coordinates,
    starts: usize,
    mistake: Option<ReachError<M::Coordinates, M::Scalar>>,
}

/// A posture in which all frames are at their goals.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Posture<Q> {
    /// Positions.
    pub q: Q,
    /// Number of steps, summed over all starts.
    pub iterations: u32,
}

impl<M, const N: usize> Reach<'_, M, N>
where
    M: OdeSystem + MechanicalSystem<Velocities = [<M as OdeSystem>::Scalar; N]>,
{
    /// Sets the time, which defaults to 0. It matters only if frames depend on it.
    pub fn at(mut self, time: M::Scalar) -> Self {
        self.goals.time = time;
        self
    }

    /// Keeps a coordinate between limits, infinite ones included, instead of in its declared range.
    /// A posture in which constraints move it beyond them is an error.
    pub fn within(mut self, name: &'static str, lower: M::Scalar, upper: M::Scalar) -> Self {
        match freedom_of(self.goals.system, name) {
            Some((position, freedom)) if lower < upper => {
                self.goals.limits[freedom] = Some(Limit { name, position, lower, upper });
            }
            Some(_) => self.mistake = self.mistake.or(Some(ReachError::Limits { name })),
            None => {
                let known = self.goals.system.description().coordinates;
                self.mistake = self.mistake.or(Some(ReachError::UnknownCoordinate { name, known }));
            }
        }
        self
    }

    /// Searches from at most this number of starts until a posture is found.
    ///
    /// The first start is the given one. The others are the same in every run: between the limits,
    /// or within half a turn of the first start for coordinates without limits.
    pub fn starts(self, starts: usize) -> Self {
        Reach { starts, ..self }
    }

    /// Sets the largest angle in rad, and the largest distance relative to the largest lever arm,
    /// of a frame at its goal. The default is 2·10⁻¹², and 6·10⁻⁶ for `f32`.
    pub fn tolerance(mut self, tolerance: M::Scalar) -> Self {
        self.goals.tolerance = tolerance;
        self
    }

    /// Searches for the posture.
    ///
    /// # Errors
    /// If a setting is invalid, or if no start leads to the goals. The error then contains the
    /// nearest posture.
    pub fn solve(&self) -> SearchResult<M, Posture<M::Coordinates>> {
        self.check()?;
        let (mut iterations, mut nearest) = (0, None::<(M::Scalar, Shortfall<_, _>)>);
        let mut failure = ReachError::NotFinite;
        for start in 0..self.starts.max(1) {
            let start = match self.goals.restored(self.start(start)) {
                Ok(start) => start,
                Err(cause) => {
                    failure = ReachError::Constrained { q: self.start(start), cause };
                    continue;
                }
            };
            let descent = Descent::new(&self.goals, &start);
            let Some(found) = descent.run(start, &mut iterations) else { continue };
            if descent.is_reached(&found) {
                match self.beyond(&found.q) {
                    None => return Ok(Posture { q: found.q, iterations }),
                    Some(name) => failure = ReachError::BeyondLimit { q: found.q, name },
                }
                continue;
            }
            if nearest.as_ref().is_none_or(|(cost, _)| found.cost < *cost) {
                nearest = Some((found.cost, self.shortfall(found.q, descent.lever)));
            }
        }
        Err(nearest.map_or(failure, |(_, shortfall)| ReachError::Short(shortfall)))
    }

    fn check(&self) -> SearchResult<M, ()> {
        if let Some(mistake) = self.mistake {
            return Err(mistake);
        }
        self.goals
            .tasks
            .iter()
            .position(|task| !task.is_valid())
            .map_or(Ok(()), |task| Err(ReachError::Goal { task }))
    }

    /// Returns the positions of a start, within the limits.
    fn start(&self, start: usize) -> M::Coordinates {
        let mut q = displaced(self.goals.system, self.goals.time, &self.near, []);
        if start > 0 {
            let by = core::array::from_fn(|j| M::Scalar::from_f64(REACH) * spread(start, j));
            q = displaced(self.goals.system, self.goals.time, &q, [(M::Scalar::ONE, &by)]);
        }
        for (j, limit) in self.goals.limits.iter().enumerate() {
            let Some(limit) = limit else { continue };
            let Limit { position, lower, upper, .. } = *limit;
            let entry = &mut q.as_mut()[position];
            let is_bounded = lower.is_finite() && upper.is_finite();
            if start > 0 && is_bounded {
                let half = M::Scalar::from_f64(0.5);
                *entry = half.multiply_add(lower + upper, half * (upper - lower) * spread(start, j));
            }
            *entry = limit.nearest(*entry);
        }
        q
    }

    /// Returns the name of a coordinate that constraints move beyond its limits, if there is one.
    fn beyond(&self, q: &M::Coordinates) -> Option<&'static str> {
        let is_beyond = |limit: &&Limit<M::Scalar>| {
            let value = q.as_ref()[limit.position];
            (limit.nearest(value) - value).abs() > self.goals.tolerance
        };
        self.goals.limits.iter().flatten().find(is_beyond).map(|limit| limit.name)
    }

    /// Returns the nearest posture, with the task that has the largest error.
    fn shortfall(&self, q: M::Coordinates, lever: M::Scalar) -> Shortfall<M::Coordinates, M::Scalar> {
        let error = |task: usize| self.goals.tasks[task].error(self.goals.system, self.goals.time, &q);
        let size = |task: usize| error(task).angle().max(error(task).distance() / lever);
        let worst = (0..self.goals.tasks.len())
            .fold(0, |worst, task| if size(task) > size(worst) { task } else { worst });
        let is_at = |limit: &&Limit<M::Scalar>| limit.is_at(q.as_ref()[limit.position]);
        let at_limit = self.goals.limits.iter().flatten().find(is_at).map(|limit| limit.name);
        Shortfall { q, task: worst, distance: error(worst).distance(), angle: error(worst).angle(), at_limit }
    }
}

/// Returns the declared ranges of coordinates as limits, bounds included.
fn declared_limits<M, const N: usize>(system: &M) -> [Option<Limit<M::Scalar>>; N]
where
    M: OdeSystem + MechanicalSystem<Velocities = [<M as OdeSystem>::Scalar; N]>,
{
    let mut limits = [None; N];
    for range in system.domain().ranges {
        if let Some((position, freedom)) =
            freedom_of(system, range.name).filter(|(position, _)| *position == range.entry)
        {
            let (lower, upper) = range.ends();
            limits[freedom] = Some(Limit { name: range.name, position, lower, upper });
        }
    }
    limits
}

/// Returns the index of a coordinate among the positions, and the index of the velocity that is its
/// rate.
fn freedom_of<M: MechanicalSystem>(system: &M, name: &str) -> Option<(usize, usize)> {
    let description = system.description();
    let position = description.coordinates.iter().position(|known| *known == name)?;
    match description.velocities_are_rates() {
        true => Some((position, position)),
        false => Some((position, description.rates_of.iter().position(|of| *of == name)?)),
    }
}
