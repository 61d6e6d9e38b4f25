//! Pendulum chains as declarations. Written by `tools/chains.py`.
#![allow(dead_code, reason = "each target that includes this module measures some of the chains")]

pub(crate) mod absolute_10;
pub(crate) mod absolute_100;
pub(crate) mod absolute_2;
pub(crate) mod absolute_20;
pub(crate) mod absolute_30;
pub(crate) mod absolute_5;
pub(crate) mod relative_20;
pub(crate) mod relative_4;
pub(crate) mod relative_8;
