//! Repeatedly run programs: their arguments, and their machine code if a compiler is available.
//!
//! This is where a compiler plugs in. Compiled code computes the bits of the interpreter. A program
//! without code is interpreted, which changes nothing but the time.

use std::fmt::Debug;
use std::ptr;
use std::sync::{Arc, OnceLock};

use super::callables::Callables;
use super::layout::{Layout, Place};
use super::programs::{Programs, takes};
use lagrange_algebra::program::{Op, Program};
use lagrange_expr::opaque::Opaque;
use lagrange_expr::symbol::Role;

/// The arguments of programs, in lists by their kind.
#[derive(Clone, Copy, Debug)]
pub struct Numbers<'a> {
    /// The time.
    pub t: f64,
    /// Positions.
    pub positions: &'a [f64],
    /// Velocities.
    pub velocities: &'a [f64],
    /// Parameters, then inputs.
    pub fields: &'a [f64],
    /// Sides of the switches; like the lists below, empty for programs that do not use them.
    pub sides: &'a [f64],
    /// Multipliers.
    pub multipliers: &'a [f64],
    /// Accelerations.
    pub accelerations: &'a [f64],
    /// Reactions of contacts and friction.
    pub reactions: &'a [f64],
}

/// Number of the lists.
pub const LISTS: usize = 7;

impl<'a> Numbers<'a> {
    /// No arguments.
    pub(super) const NONE: Numbers<'static> = Numbers {
        t: f64::NAN,
        positions: &[],
        velocities: &[],
        fields: &[],
        sides: &[],
        multipliers: &[],
        accelerations: &[],
        reactions: &[],
    };

    /// Returns the lists in the order of [`Layout::entry`].
    pub fn lists(&self) -> [&'a [f64]; LISTS] {
        let of_state = [self.positions, self.velocities];
        let [positions, velocities] = of_state;
        let of_motion = [self.multipliers, self.accelerations, self.reactions];
        let [multipliers, accelerations, reactions] = of_motion;
        [positions, velocities, self.fields, self.sides, multipliers, accelerations, reactions]
    }
}

impl Layout {
    /// Returns the list of [`Numbers`] with the number of a place, and the index in it. `None` for
    /// the time, and for places beyond all lists.
    pub fn entry(&self, place: Place) -> Option<(usize, usize)> {
        let of_state = [self.positions, self.velocities];
        let [positions, velocities] = of_state;
        let (fields, multipliers, reactions) = (self.fields(), self.multipliers, self.reactions);
        let lengths = [positions, velocities, fields, self.sides, multipliers, velocities, reactions];
        let (lists, mut index) = match place {
            Place::Time => return None,
            Place::State(index) => (0..of_state.len(), index),
            Place::Parameter(index) => (of_state.len()..LISTS, index),
        };
        for list in lists {
            match index.checked_sub(lengths[list]) {
                None => return Some((list, index)),
                Some(rest) => index = rest,
            }
        }
        None
    }
}

/// Machine code of a program.
pub trait Code: Debug + Send + Sync {
    /// Computes the outputs of the program, with the operations of the interpreter. Returns false
    /// without any computation if `outputs` has the wrong length or a list is too short.
    fn run(&self, numbers: &Numbers<'_>, outputs: &mut [f64]) -> bool;
}

/// Evaluates functions without a formula. Returns one value, or the values of all jointly solved
/// unknowns.
pub type Call = Arc<dyn Fn(&Opaque, &[f64]) -> Vec<f64> + Send + Sync>;

/// A compiler of programs.
pub trait Backend: Debug + Send + Sync {
    /// Compiles a program; programs without a result are interpreted.
    fn compile(&self, program: &Program, layout: &Layout, call: &Call) -> Option<Box<dyn Code>>;
}

/// Kinds of arguments that are only computed for programs that use them.
#[derive(Clone, Copy, Debug)]
pub(super) struct Taken {
    pub(super) sides: bool,
    pub(super) multipliers: bool,
    pub(super) accelerations: bool,
    pub(super) reactions: bool,
}

impl Taken {
    fn by(program: &Program) -> Taken {
        Taken {
            sides: takes(program, |role| matches!(role, Role::Side(_))),
            multipliers: takes(program, |role| matches!(role, Role::Multiplier(_))),
            accelerations: takes(program, |role| matches!(role, Role::Acceleration(_))),
            reactions: takes(program, |role| matches!(role, Role::Reaction(_))),
        }
    }
}

/// A program of a system, compiled on its first run.
#[derive(Debug)]
struct Routine {
    taken: Taken,
    code: OnceLock<Option<Box<dyn Code>>>,
}

/// A program with its routine; there is none for programs of no system.
#[derive(Clone, Copy)]
pub(super) struct Found<'a> {
    pub(super) program: &'a Program,
    routine: Option<&'a Routine>,
}

impl Found<'_> {
    pub(super) fn taken(self) -> Taken {
        self.routine.map_or_else(|| Taken::by(self.program), |routine| routine.taken)
    }
}

/// All programs of a system.
#[derive(Debug)]
pub(super) struct Routines {
    /// Routines with the addresses of the programs, which are stable while the programs are shared.
    /// The programs of the rates come first, since each step of a motion searches for them.
    routines: Vec<(usize, Routine)>,
    /// True if no program calls functions of the user's crate, directly or to solve equations.
    is_closed: bool,
    pub(super) backend: Option<Arc<dyn Backend>>,
}

impl Routines {
    /// Creates the routines of the programs of a system, which the owner must keep in place.
    pub(super) fn new(programs: &Arc<Programs>, backend: Option<Arc<dyn Backend>>) -> Routines {
        let routine =
            |program| (address(program), Routine { taken: Taken::by(program), code: OnceLock::new() });
        let steps = programs.known_series().map(|series| &series.step);
        let routines = programs.all().chain(steps).map(routine).collect();
        Routines { routines, is_closed: programs.functions().is_empty(), backend }
    }

    /// Searches for the routine of a program.
    pub(super) fn find<'a>(&'a self, program: &'a Program) -> Found<'a> {
        let address = address(program);
        let found = self.routines.iter().find(|(known, _)| *known == address);
        Found { program, routine: found.map(|(_, routine)| routine) }
    }

    /// Returns the code of a program of the system. There is none if it calls functions that may be
    /// defined later.
    pub(super) fn code<'a>(
        &self,
        Found { program, routine }: Found<'a>,
        layout: &Layout,
        callables: &Callables,
    ) -> Option<&'a dyn Code> {
        let (backend, routine) = (self.backend.as_ref()?, routine?);
        let compiled = routine.code.get_or_init(|| {
            let callables = callables.clone();
            let call: Call = Arc::new(move |function, arguments| callables.call(function, arguments));
            self.is_settled(program).then(|| backend.compile(program, layout, &call))?
        });
        compiled.as_deref()
    }

    fn is_settled(&self, program: &Program) -> bool {
        let is_open = |op: &Op| matches!(op, Op::Opaque(function, _) if function.table().is_none());
        self.is_closed || !program.values().any(|(_, op)| is_open(op))
    }
}

fn address(program: &Program) -> usize {
    ptr::from_ref(program).addr()
}
