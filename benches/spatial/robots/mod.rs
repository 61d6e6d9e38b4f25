//! Robots as declarations and as tables. Written by `tools/spatial_benches.py`.

pub(crate) mod panda;
pub(crate) mod universal_10;
pub(crate) mod universal_5;
pub(crate) mod ur5;
