//! Contacts, impacts and friction on hand-written systems.

mod cone;
mod friction;
mod impacts;
mod lemke;
mod motions;
mod responses;
mod rounding;
mod stepped;
mod systems;
