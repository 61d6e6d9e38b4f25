//! Handwritten code, to which benches compare the emitted code, is correct.

#[path = "../../benches/handwritten.rs"]
mod handwritten;
#[path = "../../benches/spatial/rigid_bodies/mod.rs"]
mod rigid_bodies;
#[path = "../../benches/spatial/robots/mod.rs"]
mod robots;

mod bodies;
mod chains;
