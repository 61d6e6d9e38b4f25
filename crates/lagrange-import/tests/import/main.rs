//! Robots of the tests, as declarations: how they are written, how they move, and what is said of
//! files that are wrong.

mod dynamics;
mod edits;
mod elements;
mod files;
mod judge;
mod mistakes;
mod reference;
mod touching;
mod writing;
