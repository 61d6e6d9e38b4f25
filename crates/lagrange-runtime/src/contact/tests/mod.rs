//! Contacts, impacts and friction on systems that are written by hand.

mod cone;
mod friction;
mod impacts;
mod lemke;
mod motions;
mod rounding;
mod systems;
