//! Elementary functions of several numbers, against values with 300 bits.

mod accuracy;
mod promises;
mod rows;
