//! A T-shaped handle rotates in space without forces, about the axis of its middle moment of
//! inertia.
//!
//! This rotation is unstable. A disturbance of a thousandth grows until the handle flips over,
//! again and again, as cosmonaut Dzhanibekov observed with a wing nut. Flips follow each other at
//! intervals of 2 K(m)/λ, with the complete elliptic integral K (Landau, Lifshitz, *Mechanics*,
//! §37), computed with twenty digits by `tools/spatial_examples.py`. After two flips the angular
//! velocity in the axes of the handle is the initial one. The declaration lists the cylinders of
//! the handle.
//!
//! Look for energy and angular momentum, which are conserved up to rounding over ten flips.

#[path = "common/gallery.rs"]
mod gallery;

mod common;

use std::error::Error;

use common::compare;
use lagrange::Simulate;
use lagrange::draw::Drawing;

lagrange::system! {
    /// Two cylinders of steel: a bar along y and a stem along x.
    #[derive(Clone, Debug)]
    pub struct Handle;
    param r: m = 0.01, bar: m = 0.1, stem: m = 0.06, density: kg/m^3 = 7800.0;
    let section = density * pi * r^2;
    body handle {
        compound {
            solid_cylinder(r, bar), mass: section * bar, at: (0, 0, 0), turned: (pi/2, 0, 0);
            solid_cylinder(r, stem), mass: section * stem, at: (stem/2, 0, 0), turned: (0, pi/2, 0);
        }
    }
    free handle;
    output momentum = angular_momentum(handle, handle.center);
    emit { drawing }
}

/// Time between flips in seconds.
const FLIP: f64 = 3.028_201_494_335_086;

fn main() -> Result<(), Box<dyn Error>> {
    let handle = Handle::default();
    // The centre of mass stays at rest: v = −ω × r for the position r of the origin relative to it.
    let center = handle.stem * handle.stem / 2.0 / (handle.bar + handle.stem);
    let start = HandleState {
        handle_x: 0.0,
        handle_y: 0.0,
        handle_z: 0.0,
        handle_qw: 1.0,
        handle_qx: 0.0,
        handle_qy: 0.0,
        handle_qz: 0.0,
        handle_vx: 0.0,
        handle_vy: -0.01 * center,
        handle_vz: 0.01 * center,
        handle_wx: 12.0,
        handle_wy: 0.01,
        handle_wz: 0.01,
    };
    let after = |flips: f64| {
        let motion = handle.simulate(start).until(flips * FLIP).tolerance(1e-14).ends_only().run()?;
        Ok::<_, Box<dyn Error>>(HandleState::from(motion.last()))
    };
    let (once, twice) = (after(1.0)?, after(2.0)?);
    let rows = [
        ("w_x once, rad/s", once.handle_wx, -start.handle_wx),
        ("w_x twice, rad/s", twice.handle_wx, start.handle_wx),
        ("w_y twice, rad/s", twice.handle_wy, start.handle_wy),
        ("w_z twice, rad/s", twice.handle_wz, start.handle_wz),
    ];
    compare("a handle turns over", 1e-8, &rows);

    let motion = handle.simulate(start).until(10.0 * FLIP).tolerance(1e-13).every(0.04).energy().run()?;
    let momentum = |state: HandleState| handle.momentum(0.0, &state.coordinates(), &state.velocities());
    let (before, now) = (momentum(start), momentum(HandleState::from(motion.last())));
    let energy = motion.column("energy").unwrap_or_default();
    let rows = [
        ("L_x, N m s", now[0], before[0]),
        ("L_y, N m s", now[1], before[1]),
        ("L_z, N m s", now[2], before[2]),
        ("energy, J", energy[energy.len() - 1], energy[0]),
    ];
    compare("after ten flips", 1e-14, &rows);

    let drawing = Drawing::of(&handle).size(300.0, 260.0).title("A handle turns over").nameless();
    let seen = handle.simulate(start).until(2.0 * FLIP).every(FLIP / 40.0).energy().run()?;
    drawing.film(&seen)?.save(gallery::picture("t_handle.gif")?)?;
    Ok(())
}
