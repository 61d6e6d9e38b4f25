//! Are fits to data those of another tool, are their errors honest, and are mistakes told? Which
//! parameters do forces tell?

mod data;
mod honesty;
mod identification;
mod mistakes;
mod noise;
mod references;
