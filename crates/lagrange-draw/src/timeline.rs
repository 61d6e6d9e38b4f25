//! When the pictures of a film are shown, and the quantities that are plotted under them.

use crate::error::{DrawError, refusal};
use lagrange_runtime::scalar::Number;
use lagrange_runtime::simulate::Trajectory;
use lagrange_runtime::system::MechanicalSystem;

/// Times, and values at these times.
#[derive(Clone, PartialEq, Debug)]
pub struct Timeline {
    /// In seconds, rising or falling.
    pub(crate) times: Vec<f64>,
    pub(crate) curves: Vec<Curve>,
}

/// A quantity that is plotted under the picture of a page.
#[derive(Clone, PartialEq, Debug)]
pub(crate) struct Curve {
    pub(crate) name: String,
    /// One for each picture; what is not finite leaves a gap.
    pub(crate) values: Vec<f64>,
}

impl Timeline {
    /// Times that rise or fall throughout.
    pub(crate) fn new(times: Vec<f64>) -> Result<Timeline, DrawError> {
        let is_finite = times.iter().all(|time| time.is_finite());
        let rises = times.windows(2).all(|pair| pair[0] < pair[1]);
        let falls = times.windows(2).all(|pair| pair[0] > pair[1]);
        if is_finite && (rises || falls) {
            return Ok(Timeline { times, curves: Vec::new() });
        }
        Err(refusal("times must be finite, and rise or fall from picture to picture"))
    }

    /// Adds a curve.
    pub(crate) fn with_values(mut self, name: &str, values: Vec<f64>) -> Result<Timeline, DrawError> {
        if values.len() != self.times.len() {
            let (values, pictures) = (values.len(), self.times.len());
            return Err(refusal(&format!("`{name}` has {values} values for {pictures} pictures")));
        }
        self.curves.push(Curve { name: name.to_string(), values });
        Ok(self)
    }

    /// Adds columns of a trajectory.
    pub(crate) fn with_columns<M: MechanicalSystem>(
        mut self,
        trajectory: &Trajectory<M>,
        names: &[&str],
    ) -> Result<Timeline, DrawError>
    where
        M::Scalar: Into<f64>,
    {
        for name in names {
            let column = trajectory
                .column(name)
                .ok_or_else(|| refusal(&format!("the trajectory has no column `{name}`")))?;
            let value = |t: &f64| Some(column[sample(trajectory, *t)?].into());
            let values: Option<Vec<f64>> = self.times.iter().map(value).collect();
            let values = values.ok_or_else(|| refusal("columns hold values at the times of samples only"))?;
            self = self.with_values(name, values)?;
        }
        Ok(self)
    }

    /// Adds a quantity of times and states.
    pub(crate) fn with_energy<M: MechanicalSystem>(
        self,
        name: &str,
        trajectory: &Trajectory<M>,
        energy: impl Fn(M::Scalar, &M::State) -> M::Scalar,
    ) -> Result<Timeline, DrawError>
    where
        M::Scalar: Into<f64>,
    {
        let value = |time: &f64| {
            let t = M::Scalar::from_f64(*time);
            let state = match sample(trajectory, *time).and_then(|index| trajectory.state(index)) {
                Some(state) => state,
                None => trajectory.at(t).map_err(|error| refusal(&error.to_string()))?,
            };
            Ok(energy(t, &state).into())
        };
        let values = self.times.iter().map(value).collect::<Result<Vec<f64>, DrawError>>()?;
        self.with_values(name, values)
    }

    /// Returns the duration in seconds.
    pub(crate) fn duration(&self) -> f64 {
        self.elapsed().last().copied().unwrap_or(0.0)
    }

    /// Seconds from its start to each of its times.
    pub(crate) fn elapsed(&self) -> Vec<f64> {
        let start = self.times.first().copied().unwrap_or(0.0);
        self.times.iter().map(|time| (time - start).abs()).collect()
    }
}

/// The last sample at a time.
fn sample<M: MechanicalSystem>(trajectory: &Trajectory<M>, time: f64) -> Option<usize>
where
    M::Scalar: Into<f64>,
{
    trajectory.times().iter().rposition(|known| Into::<f64>::into(*known) == time)
}
