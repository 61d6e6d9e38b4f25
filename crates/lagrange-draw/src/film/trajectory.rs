//! Films of simulated motions.

use crate::drawing::{Drawing, DrawnSpace, Shot};
use crate::error::{DrawError, refusal};
use crate::film::Film;
use crate::timeline::Timeline;
use lagrange_runtime::scalar::Number;
use lagrange_runtime::scene::Scene;
use lagrange_runtime::simulate::Trajectory;
use lagrange_runtime::system::MechanicalSystem;

/// The column that a film includes automatically.
const ENERGY: &str = "energy";

impl<M: Scene<Space: DrawnSpace>> Drawing<'_, M>
where
    M::Scalar: Into<f64>,
{
    /// Creates a film of the samples of a trajectory, such as those of a run
    /// [`every`](lagrange_runtime::simulate::Simulation::every) twenty-fifth of a second. If
    /// impacts leave several samples at one time, it shows the last one. If a control set inputs,
    /// forces are those for the inputs of each sample. If the run observed its
    /// [`energy`](lagrange_runtime::simulate::Simulation::energy), pages plot it.
    ///
    /// # Errors
    /// If there are more than 100 000 pictures, or one cannot be made, as for
    /// [`pictures`](Drawing::pictures).
    pub fn film(&self, trajectory: &Trajectory<M>) -> Result<Film<M::Space>, DrawError> {
        let film = self.recorded(&samples(trajectory, self.system())?)?;
        if trajectory.column(ENERGY).is_some() { film.with_columns(trajectory, &[ENERGY]) } else { Ok(film) }
    }

    /// Creates a film of about this many pictures a second from a run that was
    /// [`dense`](lagrange_runtime::simulate::Simulation::dense). The intervals are equal, and the
    /// last picture shows the end. If a control set inputs, forces are those for the inputs of the
    /// last sample before each picture.
    ///
    /// # Errors
    /// If the run was not dense, the number is not positive and finite, there are more than 100 000
    /// pictures, or one cannot be made.
    pub fn film_at(
        &self,
        pictures_a_second: f64,
        trajectory: &Trajectory<M>,
    ) -> Result<Film<M::Space>, DrawError> {
        self.recorded(&samples_at(pictures_a_second, trajectory, self.system())?)
    }

    /// Creates a film of these times and states, such as recorded data. Times must rise or fall
    /// throughout. Forces are those for the current inputs of the system.
    ///
    /// # Errors
    /// If there are more than 100 000 pictures, or one cannot be made, as for
    /// [`pictures`](Drawing::pictures).
    pub fn film_of(
        &self,
        states: impl IntoIterator<Item = (M::Scalar, M::State)>,
    ) -> Result<Film<M::Space>, DrawError> {
        self.timed_film(states.into_iter().map(|instant| (instant.0.into(), instant)))
    }

    /// Creates a film of times and states, each with its display time in seconds. Display times may
    /// differ from the times: for slow motion, or for a system at a constant time, as in
    /// [modes](lagrange_runtime::linear::ModeMotion).
    ///
    /// # Errors
    /// If seconds neither rise nor fall throughout, there are more than 100 000 pictures, or one
    /// cannot be made.
    pub fn timed_film(
        &self,
        moments: impl IntoIterator<Item = (f64, (M::Scalar, M::State))>,
    ) -> Result<Film<M::Space>, DrawError> {
        let (seconds, shots): (Vec<f64>, Vec<Shot<M>>) =
            moments.into_iter().map(|(second, instant)| (second, (instant, None))).unzip();
        refuse_too_many(shots.len() as f64)?;
        self.shown_at(seconds, &shots)
    }

    fn recorded(&self, shots: &[Shot<M>]) -> Result<Film<M::Space>, DrawError> {
        self.shown_at(instants(shots), shots)
    }

    fn shown_at(&self, seconds: Vec<f64>, shots: &[Shot<M>]) -> Result<Film<M::Space>, DrawError> {
        let recording = M::Space::record(self, shots)?;
        Ok(Film { recording, timeline: Timeline::new(seconds)?, instants: instants(shots) })
    }
}

impl<D: DrawnSpace> Film<D> {
    /// Adds columns of the film's trajectory to the plots of pages. Their values are those at the
    /// times of the states, regardless of display times.
    ///
    /// # Errors
    /// If there is no such column, or no sample at the time of one of the states.
    pub fn with_columns<M: MechanicalSystem>(
        self,
        trajectory: &Trajectory<M>,
        names: &[&str],
    ) -> Result<Self, DrawError>
    where
        M::Scalar: Into<f64>,
    {
        let mut film = self;
        for name in names {
            let column = trajectory
                .column(name)
                .ok_or_else(|| refusal(&format!("the trajectory has no column `{name}`")))?;
            let value = |t: &f64| Some(column[sample(trajectory, *t)?].into());
            let values: Option<Vec<f64>> = film.instants.iter().map(value).collect();
            let values =
                values.ok_or_else(|| refusal("columns contain values only at the times of samples"))?;
            film = film.with_values(name, values)?;
        }
        Ok(film)
    }

    /// Adds a quantity to the plots of pages, such as a kinetic energy, from times and states of
    /// the film's trajectory.
    ///
    /// # Errors
    /// If the trajectory has no state at the time of one of the pictures.
    pub fn with_energy<M: MechanicalSystem>(
        self,
        name: &str,
        trajectory: &Trajectory<M>,
        energy: impl Fn(M::Scalar, &M::State) -> M::Scalar,
    ) -> Result<Self, DrawError>
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
        let values = self.instants.iter().map(value).collect::<Result<Vec<f64>, DrawError>>()?;
        self.with_values(name, values)
    }
}

/// Returns the times of the shots.
fn instants<M: MechanicalSystem<Scalar: Into<f64>>>(shots: &[Shot<M>]) -> Vec<f64> {
    shots.iter().map(|((t, _), _)| (*t).into()).collect()
}

/// Returns the index of the last sample at each time, in order. Impacts leave several at one time.
pub fn last_at_each<S: PartialEq>(times: &[S]) -> Vec<usize> {
    let is_last = |index: &usize| times.get(index + 1).is_none_or(|next| *next != times[*index]);
    (0..times.len()).filter(is_last).collect()
}

/// Maximum number of pictures. At sixty per second, they last for half an hour, and take gigabytes.
const MAX_PICTURES: f64 = 1e5;

fn refuse_too_many(pictures: f64) -> Result<(), DrawError> {
    if pictures <= MAX_PICTURES {
        return Ok(());
    }
    Err(refusal(&format!(
        "a film has at most {MAX_PICTURES} pictures, but this would have {pictures:.0}: use fewer per second, or a shorter run"
    )))
}

/// Returns the last sample of a trajectory at each time, each with the system under the inputs at
/// that time.
fn samples<M: MechanicalSystem>(trajectory: &Trajectory<M>, system: &M) -> Result<Vec<Shot<M>>, DrawError> {
    let times = trajectory.times();
    let shown = last_at_each(times);
    refuse_too_many(shown.len() as f64)?;
    let shot = |index| {
        let state = trajectory.state(index)?;
        Some(((times[index], state), trajectory.with_inputs_at(index, system)))
    };
    Ok(shown.into_iter().filter_map(shot).collect())
}

/// Returns states of a dense trajectory at equal intervals, at about this many per second,
/// including its end.
fn samples_at<M: MechanicalSystem>(
    pictures_a_second: f64,
    trajectory: &Trajectory<M>,
    system: &M,
) -> Result<Vec<Shot<M>>, DrawError>
where
    M::Scalar: Into<f64>,
{
    if !(pictures_a_second > 0.0 && pictures_a_second.is_finite()) {
        return Err(refusal("a film needs a positive number of pictures per second"));
    }
    let (start, end) = (trajectory.start_time(), trajectory.end_time());
    let duration: f64 = (end - start).into();
    let intervals = (duration.abs() * pictures_a_second).round().max(1.0);
    refuse_too_many(intervals + 1.0)?;
    let time = |index: u64| start + (end - start) * M::Scalar::from_f64(index as f64 / intervals);
    let state = |t| trajectory.at(t).map(|state| (t, state)).map_err(|error| refusal(&error.to_string()));
    let inner = (0..intervals as u64).map(time).map(state);
    let last = Ok((end, trajectory.last()));
    let is_past = |t: M::Scalar, other: M::Scalar| if end < start { other >= t } else { other <= t };
    let shot = |instant: Result<(M::Scalar, M::State), DrawError>| {
        let (t, y) = instant?;
        let passed = trajectory.times().partition_point(|sample| is_past(t, *sample));
        Ok(((t, y), trajectory.with_inputs_at(passed.saturating_sub(1), system)))
    };
    inner.chain([last]).map(shot).collect()
}

/// Returns the last sample at a time.
fn sample<M: MechanicalSystem>(trajectory: &Trajectory<M>, time: f64) -> Option<usize>
where
    M::Scalar: Into<f64>,
{
    trajectory.times().iter().rposition(|known| Into::<f64>::into(*known) == time)
}
