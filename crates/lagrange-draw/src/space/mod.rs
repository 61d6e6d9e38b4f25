//! Pictures and films of systems of bodies in space.
//!
//! A motion is recorded as meshes that rotate, move and are stretched ([`recording`]), from the
//! items of a scene ([`stage`]). A camera draws pictures ([`projector`]) of them, from back to
//! front ([`sort`]). Pages ([`page`]) and glTF files ([`glb`]) contain the meshes themselves:
//! triangles with normals ([`surface`]), and tracks of quaternions ([`motion`]).

mod arrows;
mod camera;
mod drawing;
mod film;
mod glb;
pub(crate) mod live;
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
mod surroundings;
mod vector;

#[cfg(test)]
mod tests;
