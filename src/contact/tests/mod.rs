//! Contacts, impacts and friction on systems that are written by hand.

mod complementarity;
mod friction;
mod impacts;
mod motions;
mod systems;
