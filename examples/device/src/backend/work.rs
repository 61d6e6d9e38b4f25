//! Columns transferred to and from a device.

/// A method of integration by its kernel in `methods.c`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Method {
    RungeKutta4,
    DormandPrince,
}

impl Method {
    pub(crate) fn kernel(self) -> &'static str {
        match self {
            Method::RungeKutta4 => "lagrange_runge_kutta_4",
            Method::DormandPrince => "lagrange_dormand_prince",
        }
    }
}

/// The status of a motion, by its number in `methods.c`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Status {
    Running,
    Done,
    NotFinite,
    TooManySteps,
    StepUnderflow,
}

impl Status {
    pub(crate) fn of(number: u32) -> Status {
        match number {
            0 => Status::Running,
            1 => Status::Done,
            2 => Status::NotFinite,
            3 => Status::TooManySteps,
            _ => Status::StepUnderflow,
        }
    }

    /// True if any motion has steps left.
    pub(crate) fn any_running(numbers: &[u32]) -> bool {
        numbers.iter().any(|number| Status::of(*number) == Status::Running)
    }
}

/// Motions in columns: every column has an entry for each of them.
pub(crate) struct Work<T> {
    pub(crate) method: Method,
    pub(crate) motions: u32,
    /// Positions, then velocities.
    pub(crate) states: Vec<T>,
    /// Parameters, then inputs; never empty, since buffers must not be.
    pub(crate) parameters: Vec<T>,
    pub(crate) times: Vec<T>,
    /// The length of the next step, zero before the first; the error of the last; the part of the
    /// time lost by rounding.
    pub(crate) controls: Vec<T>,
    /// Steps so far.
    pub(crate) taken: Vec<u32>,
    /// Numbers of [`Status`].
    pub(crate) statuses: Vec<u32>,
    pub(crate) end: T,
    /// Step length of the method with equal steps, or the longest step of the other method.
    pub(crate) step: T,
    pub(crate) relative: T,
    pub(crate) absolute: T,
    /// The largest number of steps of a motion.
    pub(crate) most: u32,
}
