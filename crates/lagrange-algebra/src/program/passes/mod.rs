//! Passes: each returns an equivalent program.

mod batch;
mod fuse;
mod rewrite;
mod schedule;
mod trigonometry;

pub use batch::batch_sines_and_cosines;
pub use fuse::fuse_multiply_adds;
pub use schedule::schedule;
pub use trigonometry::pair_sines_and_cosines;

use super::ir::Program;
use lagrange_expr::accuracy::Accuracy;

/// A pass, with its name for tests and tools.
#[derive(Clone, Copy, Debug)]
pub struct Pass {
    /// The name.
    pub name: &'static str,
    /// Function that runs it.
    pub run: fn(&Program) -> Program,
}

/// Returns the passes for a level of accuracy in the order in which they run.
pub fn passes(accuracy: Accuracy) -> [Pass; 3] {
    let pair = match accuracy {
        Accuracy::Fast => Pass { name: "batch sines and cosines", run: batch_sines_and_cosines },
        Accuracy::Standard | Accuracy::Strict => {
            Pass { name: "pair sines and cosines", run: pair_sines_and_cosines }
        }
    };
    let fuse = Pass { name: "fuse multiply-adds", run: fuse_multiply_adds };
    [pair, fuse, Pass { name: "schedule", run: schedule }]
}

/// Runs every pass.
pub fn optimise(program: &Program, accuracy: Accuracy) -> Program {
    passes(accuracy).iter().fold(program.clone(), |program, pass| (pass.run)(&program))
}
