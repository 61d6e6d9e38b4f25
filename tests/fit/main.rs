//! Are fits to data those of another tool, are their errors honest, and are mistakes told?

mod data;
mod honesty;
mod mistakes;
mod references;
