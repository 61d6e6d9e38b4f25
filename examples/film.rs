//! Ten lines: declare bodies, simulate them, look at the film.
//!
//! A double pendulum of two rods, and a cart with a pole that falls over. Open the pages in a browser: they play, pause and
//! show the energy under the picture; the animated drawings play by themselves.
//!
//! `cargo run --example film --features draw`

#[path = "common/gallery.rs"]
mod gallery;

mod common;

use std::error::Error;

use common::compare;
use lagrange::Simulate;
use lagrange::draw::Drawing;

lagrange::system! {
    /// Two rods that hang from each other.
    #[derive(Clone, Debug)]
    pub struct DoublePendulum;
    param m = 1.0, l = 1.0, g = 9.81;
    coord p, q;
    gravity = (0, -g);
    body upper { mass: m; shape: slender_rod(l); origin: l / 2 * (sin(p), -cos(p)); angle: p - pi / 2; }
    body lower {
        mass: m;
        shape: slender_rod(l);
        origin: upper.point(l / 2, 0) + l / 2 * (sin(q), -cos(q));
        angle: q - pi / 2;
    }
    pin upper.point(-l / 2, 0) to (0, 0);
    pin upper.point(l / 2, 0) to lower.point(-l / 2, 0);
    output tip = lower.point(l / 2, 0);
    emit { drawing }
}

lagrange::system! {
    /// A cart with a pole, on a rail.
    #[derive(Clone, Debug)]
    pub struct CartPole;
    param mc = 1.0, mp = 0.3, l = 1.0, g = 9.81;
    coord x, theta;
    gravity = (0, -g);
    line rail { through: (0, -0.1); }
    body cart { mass: mc; shape: rectangle(0.4, 0.2); center: (x, 0); }
    body pole { mass: mp; shape: slender_rod(l); origin: cart.center + l / 2 * (sin(theta), cos(theta)); angle: pi / 2 - theta; }
    slide cart.point(0, -0.1) on rail;
    pin cart to pole.point(-l / 2, 0);
    emit { drawing }
}

fn main() -> Result<(), Box<dyn Error>> {
    let pendulum = DoublePendulum::default();
    let run =
        pendulum.simulate([2.0, 2.6, 0.0, 0.0]).until(6.0).tolerance(1e-12).every(0.04).energy().run()?;
    let drawing = Drawing::of(&pendulum).size(420.0, 420.0).title("Double pendulum").nameless();
    let drawing = drawing.trace("", |pendulum, t, y| pendulum.tip(t, &[y[0], y[1]], &[y[2], y[3]]));
    drawing.picture(0.0, &run.first())?.save(gallery::picture("double_pendulum.png")?)?;
    let kinetic = |t: f64, y: &[f64; 4]| pendulum.kinetic_energy(t, &[y[0], y[1]], &[y[2], y[3]]);
    let potential = |t: f64, y: &[f64; 4]| pendulum.potential_energy(t, &[y[0], y[1]]);
    let film = drawing.film(&run)?.with_energy("kinetic", &run, kinetic)?.with_energy(
        "potential",
        &run,
        potential,
    )?;
    film.save(gallery::picture("double_pendulum.svg")?)?;
    film.save(gallery::picture("double_pendulum.html")?)?;
    let energy = run.column("energy").unwrap_or_default();
    compare("double pendulum", 1e-10, &[("energy, J", energy[energy.len() - 1], energy[0])]);

    let cart = CartPole::default();
    let run = cart.simulate([0.0, 0.1, 0.0, 0.0]).until(4.0).tolerance(1e-12).every(0.04).energy().run()?;
    Drawing::of(&cart)
        .title("Cart and pole")
        .forces()
        .film(&run)?
        .save(gallery::picture("cart_pole.html")?)?;
    let energy = run.column("energy").unwrap_or_default();
    compare("cart and pole", 1e-10, &[("energy, J", energy[energy.len() - 1], energy[0])]);
    Ok(())
}
