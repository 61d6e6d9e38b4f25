//! What is written by hand for benches to compare with is right.

#[path = "../../benches/handwritten.rs"]
mod handwritten;
#[path = "../../benches/spatial/rigid_bodies/mod.rs"]
mod rigid_bodies;
#[path = "../../benches/spatial/robots/mod.rs"]
mod robots;

mod bodies;
mod chains;
