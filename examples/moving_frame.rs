//! Velocity and acceleration of a point of a moving body, relative to another point.
//!
//! A plate flies through the plane. The body-fixed axes start at the corner P; Q is one of its
//! points, ρ leads from P to Q. With e_z × (x, y) = (−y, x)
//!
//! ```text
//! v_Q = v_P + ω e_z × ρ,    a_Q = a_P + ω̇ e_z × ρ − ω² ρ
//! ```
//!
//! (Meriam, Kraige, *Engineering Mechanics: Dynamics*, §5/4 and §5/6). The declaration
//! differentiates the position of Q; the formulas are evaluated for comparison. Look for the
//! picture, in which the arrows of v_P and ω e_z × ρ add up to v_Q.
//!
//! `cargo run --example moving_frame --features draw`

#[path = "common/gallery.rs"]
mod gallery;

mod common;

use std::error::Error;

use common::compare;
use lagrange::body::Motion;
use lagrange::draw::{Drawing, Moment, Sketch};

lagrange::system! {
    /// A plate that is thrown, by its corner and its angle; a motor inside speeds up its turning.
    #[derive(Clone, Debug)]
    pub struct Plate;

    param m: kg = 2.0, a: m = 1.0, b: m = 0.6, motor: N*m = 0.4, g: m/s^2 = 9.81;
    coord x: m, y: m, phi: rad;
    gravity = (0, -g);
    body plate {
        mass: m;
        shape: rectangle(a, b);
        center: (x, y) + a / 2 * (cos(phi), sin(phi)) + b / 2 * (-sin(phi), cos(phi));
        angle: phi;
    }
    torque motor on plate;

    // P and Q in the axes of the plate, with the origin at its centre.
    output velocity_p = velocity(plate.point(-a / 2, -b / 2));
    output velocity_q = velocity(plate.point(a / 4, b / 3));
    output acceleration_p = acceleration(plate.point(-a / 2, -b / 2));
    output acceleration_q = acceleration(plate.point(a / 4, b / 3));
    output spin = (angular_velocity(plate), angular_acceleration(plate));
    emit { motion, drawing }
}

const START: PlateState = PlateState { x: 1.1, y: 0.5, phi: 0.45, x_dot: 0.35, y_dot: 0.55, phi_dot: 0.9 };

fn main() -> Result<(), Box<dyn Error>> {
    let system = Plate::default();
    let (q, v) = (START.coordinates(), START.velocities());
    let [vp, vq] = [system.velocity_p(0.0, &q, &v), system.velocity_q(0.0, &q, &v)];
    let [ap, aq] = [system.acceleration_p(0.0, &q, &v), system.acceleration_q(0.0, &q, &v)];
    let [omega, omega_dot] = system.spin(0.0, &q, &v);
    let [p, point] = points(&system);
    let motion = system.plate_motion(0.0, &q, &v);
    let [rx, ry] = difference(motion.point(point), motion.point(p));

    let rows = [("v_Q x", vq[0], vp[0] - omega * ry), ("v_Q y", vq[1], vp[1] + omega * rx)];
    compare("v_Q = v_P + omega e_z x rho", 1e-14, &rows);
    let rows = [
        ("a_Q x", aq[0], ap[0] - omega_dot * ry - omega * omega * rx),
        ("a_Q y", aq[1], ap[1] + omega_dot * rx - omega * omega * ry),
    ];
    compare("a_Q = a_P + omega' e_z x rho - omega^2 rho", 1e-13, &rows);
    let (velocity, acceleration) = (motion.velocity_at(point), motion.acceleration_from(point, p).total());
    let rows = [("v_Q x", velocity[0], vq[0]), ("v_Q y", velocity[1], vq[1])];
    compare("the motion of the plate", 1e-14, &rows);
    let rows = [("a_Q x", acceleration[0], aq[0]), ("a_Q y", acceleration[1], aq[1])];
    compare("its acceleration", 1e-13, &rows);

    Drawing::of(&system)
        .title("A moving frame")
        .nameless()
        .annotate(explain)
        .picture(0.0, &START.into())?
        .save(gallery::picture("moving_frame.svg")?)?;
    Ok(())
}

/// Returns P and Q in the plate's own coordinates.
fn points(&Plate { a, b, .. }: &Plate) -> [[f64; 2]; 2] {
    [[-a / 2.0, -b / 2.0], [a / 4.0, b / 3.0]]
}

/// Draws both frames, the vectors between them, and the velocities.
fn explain(sketch: &mut Sketch, moment: &Moment<'_, Plate>) {
    let Some(plate) = moment.motion("plate") else { return };
    let [p, q] = points(moment.system);
    let (at_p, at_q) = (plate.point(p), plate.point(q));
    let rho = difference(at_q, at_p);
    sketch.ink(0).arrow([0.0, 0.0], [0.5, 0.0], "x").arrow([0.0, 0.0], [0.0, 0.5], "y");
    sketch.arrow(at_p, plate.vector([1.25, 0.0]), "X").arrow(at_p, plate.vector([0.0, 0.85]), "Y");
    sketch.dashed(at_p, [at_p[0] + 0.6, at_p[1]]).angle(at_p, 0.0, plate.angle, "phi");
    sketch.point([0.0, 0.0], "O").point(at_p, "P").point(at_q, "Q");
    sketch.ink(4).arrow([0.0, 0.0], at_p, "").arrow([0.0, 0.0], at_q, "").arrow(at_p, rho, "");
    for (from, to, label) in [([0.0; 2], at_p, "r_P"), ([0.0; 2], at_q, "r_Q"), (at_p, at_q, "ρ")] {
        let [x, y] = difference(to, from);
        let aside = 0.06 / x.hypot(y);
        sketch.text([from[0] + x / 2.0 - aside * y, from[1] + y / 2.0 + aside * x], label);
    }
    velocities(sketch, &plate, p, q);
}

fn velocities(sketch: &mut Sketch, plate: &Motion<f64>, p: [f64; 2], q: [f64; 2]) {
    let at_q = plate.point(q);
    let [of_p, turning] = plate.velocity_from(q, p);
    sketch.velocity(plate.point(p), of_p, "v_P").velocity(at_q, plate.velocity_at(q), "v_Q");
    sketch.velocity(at_q, of_p, "v_P");
    sketch.velocity(at_q, turning, "omega e_z × rho");
}

fn difference(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] - b[0], a[1] - b[1]]
}
