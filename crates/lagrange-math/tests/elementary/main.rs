//! Elementary functions of several numbers beside values with 300 bits.

mod accuracy;
mod promises;
mod rows;
