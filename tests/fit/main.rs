//! Fits to data agree with those of another tool, their errors are correct, and mistakes are
//! reported. Estimates from forces show which parameters are identifiable.

mod data;
mod honesty;
mod identification;
mod mistakes;
mod noise;
mod references;
