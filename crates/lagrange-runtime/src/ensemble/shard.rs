//! Shares of an ensemble for several processes.

use core::ops::Range;
use std::collections::BTreeMap;
use std::ffi::OsString;
use std::format;
use std::string::String;

use super::error::EnsembleError;

/// One of several shares of an ensemble, each computed by a separate process. Its motions are
/// consecutive and form whole parts of the saved results.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Shard {
    index: u64,
    count: u64,
}

/// Lookup of an environment variable.
type Lookup<'a> = &'a dyn Fn(&str) -> Option<String>;

/// Suffixes of the variables in which launchers number their processes.
const PLACES: [&str; 12] = [
    "RANK",
    "RANKID",
    "PROCID",
    "PROCNO",
    "TASK_ID",
    "TASKID",
    "TASK_INDEX",
    "ARRAY_INDEX",
    "ARRAYID",
    "JOBINDEX",
    "COMPLETION_INDEX",
    "APP_PE",
];
/// Prefix of Slurm's variables, which are never taken for an unknown launcher's.
const SLURM: &str = "SLURM_";

/// Variables with the index of a process and with the number of processes, in order of precedence.
const LAUNCHERS: [[&str; 2]; 3] = [
    // Open MPI's mpirun.
    ["OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE"],
    // MPICH and Intel MPI.
    ["PMI_RANK", "PMI_SIZE"],
    // Only srun sets SLURM_STEP_NUM_TASKS. A batch script also has SLURM_PROCID and SLURM_NTASKS,
    // but is one process.
    [BATCH, "SLURM_STEP_NUM_TASKS"],
];
/// The only index that may be set without a number of processes.
const BATCH: &str = "SLURM_PROCID";
const ARRAY_TASK: &str = "SLURM_ARRAY_TASK_ID";
const HYPER_QUEUE_TASK: &str = "HQ_TASK_ID";
/// Variable set by hand: `3/8` is the fourth of eight.
const BY_HAND: &str = "LAGRANGE_SHARD";
/// Variable with the number of tasks, for launchers that do not provide it.
const COUNT: &str = "LAGRANGE_SHARDS";

impl Shard {
    /// The whole ensemble.
    pub const WHOLE: Shard = Shard::of(0, 1);

    /// Creates the share `index`, counted from zero, of `count`. An index beyond the count is
    /// reported as an error by the run.
    pub const fn of(index: u64, count: u64) -> Self {
        Shard { index, count }
    }

    /// Returns the share that the launcher of this process set in its environment.
    ///
    /// | launcher | variables |
    /// |---|---|
    /// | by hand | `LAGRANGE_SHARD=3/8`, which takes precedence over all others |
    /// | `mpirun` of Open MPI, of MPICH | `OMPI_COMM_WORLD_RANK`, `_SIZE`; `PMI_RANK`, `PMI_SIZE` |
    /// | `srun` | `SLURM_PROCID`, `SLURM_STEP_NUM_TASKS` |
    /// | a Slurm array, each of whose tasks may start one of the above | `SLURM_ARRAY_TASK_ID`, `_COUNT`, `_MIN`, `_STEP`, all of them |
    /// | HyperQueue | `HQ_TASK_ID`, counted from zero, and `LAGRANGE_SHARDS` for the number of tasks, which it does not provide |
    ///
    /// If none is set, the share is [everything](Shard::WHOLE).
    ///
    /// # Errors
    /// If variables are incomplete, are not numbers, or exceed their count. Also if only a variable
    /// is set that looks like the index of a process started by another launcher, such as
    /// `PBS_ARRAY_INDEX`. Otherwise every process would compute everything.
    pub fn from_environment() -> Result<Self, EnsembleError> {
        let text = |text: OsString| text.to_string_lossy().into_owned();
        Shard::from_variables(&std::env::vars_os().map(|(name, value)| (text(name), text(value))).collect())
    }

    fn from_variables(variables: &BTreeMap<String, String>) -> Result<Self, EnsembleError> {
        let lookup: Lookup<'_> = &|name| variables.get(name).cloned();
        let shard = match lookup(BY_HAND) {
            Some(text) => by_hand(&text)?,
            None => match from_launchers(lookup)? {
                Some(shard) => shard,
                None => from_none(variables)?,
            },
        };
        shard.check()?;
        Ok(shard)
    }

    /// Returns the index, counted from zero.
    pub fn index(self) -> u64 {
        self.index
    }

    /// Returns the number of shards.
    pub fn count(self) -> u64 {
        self.count
    }

    /// Checks the index.
    ///
    /// # Errors
    /// If the index is beyond the count.
    pub(super) fn check(self) -> Result<(), EnsembleError> {
        if self.index < self.count {
            return Ok(());
        }
        let Shard { index, count } = self;
        Err(EnsembleError::Setting(format!("there is no shard {index} of {count}: the first has index 0")))
    }

    /// Returns the share of this many items.
    pub(super) fn share(self, number: usize) -> Range<usize> {
        let before = |index: u64| (number as u128 * u128::from(index) / u128::from(self.count)) as usize;
        before(self.index)..before(self.index + 1)
    }
}

impl Default for Shard {
    fn default() -> Self {
        Shard::WHOLE
    }
}

fn by_hand(text: &str) -> Result<Shard, EnsembleError> {
    let numbers = text
        .split_once('/')
        .and_then(|(index, count)| Some(Shard::of(index.trim().parse().ok()?, count.trim().parse().ok()?)));
    numbers.ok_or_else(|| {
        EnsembleError::Setting(format!(
            "{BY_HAND} is `{text}`; it must be of the form `3/8`, the fourth of eight"
        ))
    })
}

/// Returns the whole ensemble, unless an unknown launcher seems to have started several processes.
fn from_none(variables: &BTreeMap<String, String>) -> Result<Shard, EnsembleError> {
    let is_place = |name: &str| {
        PLACES
            .iter()
            .any(|place| name.strip_suffix(place).is_some_and(|rest| rest.is_empty() || rest.ends_with('_')))
    };
    // LSF counts from one; zero means that there is no array.
    let is_none = |name: &str, value: &str| name == "LSB_JOBINDEX" && value == "0";
    let mut places = variables.iter().filter(|(name, value)| {
        is_place(name) && !name.starts_with(SLURM) && value.parse::<u64>().is_ok() && !is_none(name, value)
    });
    match places.next() {
        None => Ok(Shard::WHOLE),
        Some((name, value)) => Err(EnsembleError::Setting(format!(
            "the environment has {name}=`{value}`, apparently from an unknown launcher of processes: specify \
            the shard by {BY_HAND}, `3/8` for the fourth of eight, `0/1` for everything"
        ))),
    }
}

/// Returns the share set by a known launcher; `None` without one.
fn from_launchers(lookup: Lookup<'_>) -> Result<Option<Shard>, EnsembleError> {
    let array = array(lookup)?;
    let mut inner = None;
    for [index, count] in LAUNCHERS {
        let is_launched = lookup(count).is_some() || (index != BATCH && lookup(index).is_some());
        if is_launched {
            inner = Some(Shard::of(number(lookup, index)?, number(lookup, count)?));
            break;
        }
    }
    if inner.is_none() && array.is_none() {
        return Ok(None);
    }
    let (inner, array) = (inner.unwrap_or_default(), array.unwrap_or_default());
    inner.check()?;
    array.check()?;
    let count = array.count.checked_mul(inner.count);
    let count = count.ok_or_else(|| EnsembleError::Setting("there are too many shards".into()))?;
    Ok(Some(Shard::of(array.index * inner.count + inner.index, count)))
}

/// Returns the share set by an array of jobs, if there is one.
fn array(lookup: Lookup<'_>) -> Result<Option<Shard>, EnsembleError> {
    if lookup(ARRAY_TASK).is_some() {
        let (id, count) = (number(lookup, ARRAY_TASK)?, number(lookup, "SLURM_ARRAY_TASK_COUNT")?);
        let (first, step) =
            (number(lookup, "SLURM_ARRAY_TASK_MIN")?, number(lookup, "SLURM_ARRAY_TASK_STEP")?);
        let place = id.checked_sub(first).ok_or_else(|| {
            EnsembleError::Setting(format!(
                "the environment has {ARRAY_TASK}=`{id}`, which is below {first}, the first"
            ))
        })?;
        return Ok(Some(Shard::of(place / step.max(1), count)));
    }
    // `LAGRANGE_SHARDS` alone is probably a typo for `LAGRANGE_SHARD`, and every process would
    // compute everything.
    if lookup(HYPER_QUEUE_TASK).is_some() || lookup(COUNT).is_some() {
        return Ok(Some(Shard::of(number(lookup, HYPER_QUEUE_TASK)?, number(lookup, COUNT)?)));
    }
    Ok(None)
}

fn number(lookup: Lookup<'_>, name: &str) -> Result<u64, EnsembleError> {
    let text = lookup(name).ok_or_else(|| {
        EnsembleError::Setting(format!("the environment does not specify a shard: {name} is not set"))
    })?;
    let wrong =
        || EnsembleError::Setting(format!("the environment has {name}=`{text}`, which is not a number"));
    text.trim().parse().map_err(|_| wrong())
}

#[cfg(test)]
mod tests;
