//! Pictures and films of systems of rigid bodies in the plane and in space.
//!
//! A [`Drawing`] turns a [`Scene`](lagrange_runtime::scene::Scene) and its states into
//! [`Picture`]s. The motion itself is not computed here. Nothing needs tuning: window, scales,
//! colours and label positions follow from the drawing. SVG pictures are dark on screens of readers
//! who prefer this, and white otherwise.
//!
//! ```
//! use std::f64::consts::FRAC_PI_2;
//!
//! use lagrange::draw::Drawing;
//!
//! lagrange::system! {
//!     /// A rod that swings about its upper end; θ is measured from the rest position.
//!     pub struct Pendulum;
//!
//!     param m = 1.0, l = 1.0, g = 9.81;
//!     coord theta;
//!     gravity = (0, -g);
//!     body rod {
//!         mass: m;
//!         shape: slender_rod(l);
//!         center: l / 2 * (sin(theta), -cos(theta));
//!         angle: theta - pi / 2;
//!     }
//!     pin rod.point(-l / 2, 0) to (0, 0);
//!     emit { drawing }
//! }
//!
//! let pendulum = Pendulum::default();
//! let drawing = Drawing::of(&pendulum).title("A pendulum").velocities().annotate(|sketch, moment| {
//!     sketch.dashed([0.0, 0.0], [0.0, -1.0]);
//!     sketch.angle([0.0, 0.0], -FRAC_PI_2, moment.q[0] - FRAC_PI_2, "theta");
//! });
//! let picture = drawing.picture(0.0, &[0.5, 1.0])?;
//! assert!(picture.svg().contains("θ"));
//! # Ok::<(), lagrange::draw::DrawError>(())
//! ```
#![forbid(unsafe_code)]

mod anchored;
mod beside;
mod colour;
mod cut;
mod drawing;
mod element;
mod error;
mod files;
mod film;
mod geometry;
mod heading;
mod labels;
mod layout;
mod load;
mod load_label;
mod look;
mod marks;
mod moment;
mod outline;
mod paper;
mod parallel;
mod picture;
mod plane;
mod raster;
mod recorded;
mod remainder;
mod sketch;
mod snapshot;
mod space;
mod stage;
mod stretch;
mod svg;
mod tag;
mod timeline;
mod view;

pub use colour::{body_colour, named_colours};
pub use drawing::{Drawing, DrawnSpace};
pub use error::DrawError;
pub use film::Film;
pub use film::page::{SCHEME as PAGE_SCHEME, style as page_style};
pub use film::trajectory::last_at_each;
pub use load_label::LiveLoads;
pub use moment::Moment;
pub use picture::Picture;
pub use sketch::Sketch;
pub use space::live::{LiveMesh, LiveScene};
pub use stage::is_made_up;
pub use stretch::live_terrain;
