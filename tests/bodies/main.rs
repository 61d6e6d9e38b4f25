//! Systems of plane rigid bodies, declared with bodies: the same motions as by hand, and the values of textbooks.

mod pairs;
