//! Delayed signals follow the method of steps: closed forms, and motions from another tool.

mod combined;
mod history;
mod jumps;
mod linear;
mod loops;
mod refusals;
mod switches;
