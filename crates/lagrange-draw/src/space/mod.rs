//! Pictures and films of systems of bodies in space.
//!
//! A motion is recorded as things ([`recording`]): meshes that turn, move and are stretched, made
//! of what a scene hands out ([`stage`]). Pictures ([`projector`]) are drawn of them by a camera,
//! from back to front ([`sort`]). Pages ([`page`]) and glTF files ([`glb`]) hold the things
//! themselves: triangles with normals ([`surface`]), and tracks of quaternions ([`motion`]).

mod arrows;
mod camera;
mod drawing;
mod film;
mod glb;
mod mesh;
mod motion;
mod page;
mod projector;
mod recording;
mod size;
mod skeleton;
mod snapshot;
mod solids;
mod sort;
mod stage;
mod store;
mod surface;
mod vector;

#[cfg(test)]
mod tests;
