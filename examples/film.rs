//! Films of two systems: a double pendulum of rods, and a cart with a pole that falls over.
//!
//! A film needs bodies with shapes, `emit { drawing }` and a simulated motion. A page (`.html`)
//! opens in any browser. It plays, pauses, jumps to any moment and shows the energies below the
//! picture. An animated drawing (`.svg`) plays without a page. Look for the tip of the pendulum,
//! whose path is drawn, and for the sum of both energies, which is constant.
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
    param m: kg = 1.0, l: m = 1.0, g: m/s^2 = 9.81;
    coord p: rad, q: rad;
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
    param mc: kg = 1.0, mp: kg = 0.3, l: m = 1.0, g: m/s^2 = 9.81;
    coord x: m, theta: rad;
    gravity = (0, -g);
    line rail { through: (0, -0.1); }
    body cart { mass: mc; shape: rectangle(0.4, 0.2); center: (x, 0); }
    body pole { mass: mp; shape: slender_rod(l); origin: cart.center + l / 2 * (sin(theta), cos(theta)); angle: pi / 2 - theta; }
    slide cart.point(0, -0.1 m) on rail;
    pin cart to pole.point(-l / 2, 0);
    emit { drawing }
}

fn main() -> Result<(), Box<dyn Error>> {
    double_pendulum()?;
    cart_pole()
}

fn double_pendulum() -> Result<(), Box<dyn Error>> {
    let pendulum = DoublePendulum::default();
    let run =
        pendulum.simulate([2.0, 2.6, 0.0, 0.0]).until(6.0).tolerance(1e-12).every(0.04).energy().run()?;
    let film = Drawing::of(&pendulum)
        .size(420.0, 420.0)
        .title("Double pendulum")
        .nameless()
        .trace("", |pendulum, t, y| pendulum.tip(t, &[y[0], y[1]], &[y[2], y[3]]))
        .film(&run)?
        .with_energy("kinetic", &run, |t, y| pendulum.kinetic_energy(t, &[y[0], y[1]], &[y[2], y[3]]))?
        .with_energy("potential", &run, |t, y| pendulum.potential_energy(t, &[y[0], y[1]]))?;
    film.save(gallery::picture("double_pendulum.svg")?)?;
    film.save(gallery::picture("double_pendulum.html")?)?;
    let energy = run.column("energy").unwrap_or_default();
    compare("double pendulum", 1e-10, &[("energy, J", energy[energy.len() - 1], energy[0])]);
    Ok(())
}

fn cart_pole() -> Result<(), Box<dyn Error>> {
    let cart = CartPole::default();
    let run = cart.simulate([0.0, 0.1, 0.0, 0.0]).until(4.0).tolerance(1e-12).every(0.04).energy().run()?;
    let film = Drawing::of(&cart)
        .title("Cart and pole")
        .forces()
        .film(&run)?
        .with_energy("kinetic", &run, |t, y| cart.kinetic_energy(t, &[y[0], y[1]], &[y[2], y[3]]))?
        .with_energy("potential", &run, |t, y| cart.potential_energy(t, &[y[0], y[1]]))?;
    film.save(gallery::picture("cart_pole.html")?)?;
    let energy = run.column("energy").unwrap_or_default();
    compare("cart and pole", 1e-10, &[("energy, J", energy[energy.len() - 1], energy[0])]);
    Ok(())
}
