//! The plan that the motions of an ensemble share.

use std::boxed::Box;
use std::vec::Vec;

use crate::simulate::{Act, EventOf, Plan, RunPlan};
use crate::system::{Action, MechanicalSystem, ScalarOf, State};

/// A system that threads may share. Implemented for every system whose fields, numbers and states
/// threads may share.
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot be shared between threads",
    note = "an ensemble needs a system, numbers and states that are `Send` and `Sync`, without `Rc`, `Cell` or pointers"
)]
pub trait SharedSystem: MechanicalSystem<Scalar: Send + Sync, State: Send + Sync> + Send + Sync {}

impl<M: MechanicalSystem<Scalar: Send + Sync, State: Send + Sync> + Send + Sync> SharedSystem for M {}

/// A function that adds columns of a time and state to a row.
pub(super) type SharedExtend<'a, M> =
    Box<dyn Fn(&M, ScalarOf<M>, &State<M>, &mut Vec<ScalarOf<M>>) + Send + Sync + 'a>;

/// A function whose zeros are located, and the response to them.
pub(super) type SharedWatch<'a, M> = (
    Box<dyn Fn(&M, ScalarOf<M>, &State<M>) -> ScalarOf<M> + Send + Sync + 'a>,
    Box<dyn Fn(&M, &EventOf<M>) -> Action<State<M>> + Send + Sync + 'a>,
);

/// A function that creates the controller of a motion.
pub(super) type MakeAct<'a, M> = Box<dyn Fn(usize) -> Act<'a, M> + Send + Sync + 'a>;

/// A plan whose functions threads may share.
pub(super) type SharedPlan<'a, M> = Plan<M, SharedExtend<'a, M>, SharedWatch<'a, M>, MakeAct<'a, M>>;

impl<'a, M: SharedSystem> SharedPlan<'a, M> {
    /// Returns the plan of the motion with this index.
    pub(super) fn of_motion<'s>(&'s self, index: usize) -> RunPlan<'s, M>
    where
        'a: 's,
    {
        let Plan { settings, columns, watches, controllers, inputs } = self;
        Plan {
            settings: settings.clone(),
            columns: columns.iter().map(|extend| Box::new(&**extend) as _).collect(),
            watches: watches
                .iter()
                .map(|(value, react)| (Box::new(&**value) as _, Box::new(&**react) as _))
                .collect(),
            controllers: controllers.iter().map(|make| make(index)).collect(),
            inputs: *inputs,
        }
    }
}
