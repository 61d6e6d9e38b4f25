//! Contacts, impacts and friction on systems that are written by hand.

mod cone;
mod friction;
mod impacts;
mod lemke;
mod motions;
mod responses;
mod rounding;
mod stepped;
mod systems;
