//! Robots of the tests as declarations: their text, their motion, and the messages about wrong
//! files.

mod dynamics;
mod edits;
mod elements;
mod files;
mod judge;
mod mistakes;
mod reference;
mod touching;
mod writing;
