//! Centre of mass and moment of inertia of a rod and of half a disk, summed over elements of mass.
//!
//! The rod is divided into pieces, the half-disk into pieces of rings. Their sums converge to
//!
//! ```text
//! rod:        J_S = m l²/12,    J_end = m l²/3,
//! half-disk:  s = 4 r/(3 π),    J_M = m r²/2,    J_S = J_M − m s² = (1/2 − 16/(9 π²)) m r²,
//! ```
//!
//! where M is the centre of the circle and s its distance from the centre of mass S (Meriam,
//! Kraige, *Engineering Mechanics: Dynamics*, table D/4). m s² is subtracted when moving from M to
//! S, since J_S is the smallest of all moments of inertia.
//!
//! The half-disk then rocks on a floor, without slipping. For small angles
//!
//! ```text
//! ω² = m g s/(J_S + m (r − s)²).
//! ```
//!
//! Look for the errors of the sums, which fall by a factor of four when the elements are halved.
//!
//! `cargo run --example rod_and_half_disk --features draw`

#[path = "common/gallery.rs"]
mod gallery;

mod common;

use std::error::Error;
use std::f64::consts::{FRAC_PI_2, PI};

use common::compare;
use lagrange::Simulate;
use lagrange::draw::{Drawing, Moment, Sketch};
use lagrange::event::Direction;
use lagrange::inertia::{semicircular_disk, semicircular_disk_center, slender_rod, slender_rod_end};

lagrange::system! {
    /// Half a disk that rocks on the floor, with its flat side up.
    #[derive(Clone, Debug)]
    pub struct Rocker;

    param m: kg = 2.0, r: m = 0.5, g: m/s^2 = 9.81;
    coord phi: rad;
    gravity = (0, -g);
    line floor {}
    body half { mass: m; shape: semicircular_disk(r); origin: (-r * phi, r); angle: phi + pi; }
    roll contact = half on floor, radius: r;
}

lagrange::system! {
    /// A rod and half a disk that lie side by side.
    #[derive(Clone, Debug)]
    pub struct Solids;

    param m: kg = 2.0, r: m = 0.5, l: m = 1.2;
    coord x: m;
    body rod { mass: m; shape: slender_rod(l); origin: (x - 0.9 [m], 0.2); }
    body half { mass: m; shape: semicircular_disk(r); origin: (x + 0.5 [m], 0); }
    emit { motion, drawing }
}

/// Number of elements along the rod, along the radius and around half the circle.
const PIECES: usize = 400;

fn main() -> Result<(), Box<dyn Error>> {
    let solids = Solids::default();
    let &Solids { m, r, l, .. } = &solids;
    let half_disk = summed(&half_disk_elements(r, PIECES), m);
    let expected = (0.5 - 16.0 / (9.0 * PI * PI)) * m * r * r;
    let rows = [
        ("s, m", half_disk.center[1], 4.0 * r / (3.0 * PI)),
        ("J_M, kg m^2", half_disk.about_origin, m * r * r / 2.0),
        ("J_S, kg m^2", half_disk.about_center, expected),
    ];
    compare("half-disk, sums", 1e-5, &rows);
    let rows = [
        ("s, m", semicircular_disk_center(r)[1], 4.0 * r / (3.0 * PI)),
        ("J_S, kg m^2", semicircular_disk(m, r), expected),
        ("J_S/(m r^2)", semicircular_disk(m, r) / (m * r * r), 0.3198734513),
    ];
    compare("half-disk, functions", 1e-10, &rows);
    let rod = summed(&rod_elements(l, PIECES), m);
    let rows = [
        ("J_S, kg m^2", rod.about_center, slender_rod(m, l)),
        ("J_end, kg m^2", rod.about_origin, slender_rod_end(m, l)),
    ];
    compare("rod, sums", 1e-5, &rows);
    let errors = [50, 100].map(|pieces| summed(&half_disk_elements(r, pieces), m).about_center - expected);
    compare("halving the elements", 1e-2, &[("error falls by", errors[0] / errors[1], 4.0)]);
    rocking()?;

    Drawing::of(&solids)
        .title("Rod and half-disk with elements of mass")
        .nameless()
        .annotate(explain)
        .picture(0.0, &[0.0; 2])?
        .save(gallery::picture("rod_and_half_disk.svg")?)?;
    Ok(())
}

/// Sums over the elements of mass.
struct Summed {
    center: [f64; 2],
    about_origin: f64,
    about_center: f64,
}

/// Sums elements of equal density, given by position and size, with the total mass `mass`.
fn summed(elements: &[([f64; 2], f64)], mass: f64) -> Summed {
    let density = mass / elements.iter().map(|(_, size)| size).sum::<f64>();
    let moment = |of: &dyn Fn([f64; 2]) -> f64| {
        elements.iter().map(|&(place, size)| density * size * of(place)).sum::<f64>()
    };
    let center = [moment(&|[x, _]| x) / mass, moment(&|[_, y]| y) / mass];
    let about = |[a, b]: [f64; 2]| moment(&|[x, y]| (x - a).powi(2) + (y - b).powi(2));
    Summed { center, about_origin: about([0.0; 2]), about_center: about(center) }
}

/// Returns the midpoints of pieces of a rod from the origin along X, with their lengths.
fn rod_elements(l: f64, pieces: usize) -> Vec<([f64; 2], f64)> {
    let length = l / pieces as f64;
    (0..pieces).map(|i| ([(i as f64 + 0.5) * length, 0.0], length)).collect()
}

/// Returns the midpoints of pieces of half rings, with their areas.
fn half_disk_elements(r: f64, pieces: usize) -> Vec<([f64; 2], f64)> {
    let (width, step) = (r / pieces as f64, PI / pieces as f64);
    let element = |i: usize, j: usize| {
        let (radius, angle) = ((i as f64 + 0.5) * width, (j as f64 + 0.5) * step);
        ([radius * angle.cos(), radius * angle.sin()], radius * width * step)
    };
    (0..pieces).flat_map(|i| (0..pieces).map(move |j| element(i, j))).collect()
}

/// Compares the period of a small oscillation, between two passages through the middle.
fn rocking() -> Result<(), Box<dyn Error>> {
    let rocker = Rocker::default();
    let &Rocker { m, r, g } = &rocker;
    let s = semicircular_disk_center(r)[1];
    let frequency = (m * g * s / (semicircular_disk(m, r) + m * (r - s).powi(2))).sqrt();
    let run = rocker
        .simulate([1e-5, 0.0])
        .until(10.0)
        .tolerance(1e-13)
        .stop_at("middle", Direction::Falling, |_: &Rocker, _, y: &[f64; 2]| y[0])
        .run()?;
    compare(
        "a quarter of the time of a small oscillation",
        1e-9,
        &[("t, s", run.end_time(), FRAC_PI_2 / frequency)],
    );
    Ok(())
}

/// Draws some elements of mass, the centres and their distances.
fn explain(sketch: &mut Sketch, moment: &Moment<'_, Solids>) {
    let (Some(rod), Some(half)) = (moment.motion("rod"), moment.motion("half")) else { return };
    let &Solids { r, l, .. } = moment.system;
    sketch.ink(1);
    for i in 1..12 {
        let x = l * (f64::from(i) / 12.0 - 0.5);
        sketch.segment(rod.point([x, -0.02]), rod.point([x, 0.02]));
    }
    for i in 1..=4 {
        let radius = r * f64::from(i) / 5.0;
        let arc = (0..=36).map(|j| PI * f64::from(j) / 36.0);
        sketch.polyline(&arc.map(|a| half.point([radius * a.cos(), radius * a.sin()])).collect::<Vec<_>>());
    }
    for i in 1..10 {
        let (sine, cosine) = (PI * f64::from(i) / 10.0).sin_cos();
        sketch.segment(half.point([0.2 * r * cosine, 0.2 * r * sine]), half.point([r * cosine, r * sine]));
    }
    let origin = half.point([0.0, 0.0]);
    sketch.ink(2).point(half.center, "S").point(rod.center, "S").ink(0).point(origin, "M");
    sketch.dimension(half.point([r, half.centroid[1]]), half.point([r, 0.0]), "s");
    sketch.dimension(half.point([r, 0.0]), origin, "r");
    sketch.dimension(rod.point([l / 2.0, 0.0]), rod.point([-l / 2.0, 0.0]), "l");
}
