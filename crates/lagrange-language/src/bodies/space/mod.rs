//! Translation of rigid bodies in space to statements of the plain language.
//!
//! Velocities are written recursively in the axes of each body ([`poses`]), as in Newton–Euler
//! methods. ω and the velocity of the origin follow from those of the carrier by a rotation and the
//! contribution of the joint. T = ½ m v_S² + ½ ω·J ω of each body is then sparse. The resulting
//! equations cost a fraction of those from rotation matrices and their rates. World positions are
//! written separately, for weights, points and outputs.
//!
//! Source: Featherstone, *Rigid Body Dynamics Algorithms*, ch. 4 and 5; Roberson, Schwertassek, *Dynamics
//! of Multibody Systems*, ch. 5.

mod accelerations;
mod base_parameters;
mod bodies;
mod compound;
pub(super) mod dimension;
mod drawing;
mod expressions;
mod frames;
mod gibbs;
mod inertia;
mod inertial;
mod kinematics;
mod links;
mod loads;
mod messages;
mod mobilizers;
mod motors;
mod numbers;
mod orientations;
mod points;
mod poses;
mod quantities;
mod regrouping;
pub(super) mod scene;
mod solids;
pub(super) mod vectors;

pub(super) use bodies::{
    report_unplaced, translate_frame, translate_spatial_body, translate_spatial_gravity,
};
pub(super) use drawing::{draw_pin, draw_scene};
pub(super) use expressions::{
    call_of_link, in_axes, part_of_link, place_of_link, point_on_link, rate_of_link_point,
};
pub(super) use gibbs::push_gibbs_function;
pub(super) use inertia::{fixed_triple, triple_of};
pub(super) use inertial::{inertial_bodies_in_space, inertial_parameters};
pub(super) use kinematics::{Asked, kinematics_asked_for};
pub(super) use loads::{translate_spatial_force, translate_spatial_torque};
pub(super) use mobilizers::translate_spatial_mobilizer;
pub(super) use mobilizers::{coordinates_of, dampen, link_of};
pub(super) use motors::{draw_force_on_coordinate, draw_torque_on_angle};
pub(super) use numbers::{frame_along, is_no_vector, triple_of_numbers, written};
pub(super) use points::{origin_motion, place_on_link, spin_of_link, vector_on_link, velocity_on_link};
pub(super) use poses::named_vector;
