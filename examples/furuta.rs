//! A Furuta pendulum: an arm rotates about the vertical, and a pendulum at its end rotates about
//! the arm.
//!
//! The declaration has two rods and two joints. The reference is the equations of motion by
//! Cazzolato and Prime, *On the Dynamics of the Furuta Pendulum*, Journal of Control Science and
//! Engineering (2011). `tools/spatial_examples.py` integrates them with twenty digits:
//!
//! ```text
//! (J₀ + J₂ sin² θ) φ̈ + k cos θ θ̈ = −2 J₂ sin θ cos θ φ̇ θ̇ + k sin θ θ̇²,
//! k cos θ φ̈ + J₂ θ̈ = J₂ sin θ cos θ φ̇² − ½ m₂ g l₂ sin θ, with k = ½ m₂ l₁ l₂.
//! ```
//!
//! Look for the angular momentum about the vertical, which is conserved while the pendulum drives
//! the arm back and forth.

#[path = "common/gallery.rs"]
mod gallery;

mod common;

use std::error::Error;

use common::compare;
use lagrange::Simulate;
use lagrange::draw::Drawing;

lagrange::system! {
    /// Two thin rods.
    #[derive(Clone, Debug)]
    pub struct Furuta;
    param m1: kg = 0.3, m2: kg = 0.075, l1: m = 0.278, l2: m = 0.3, g: m/s^2 = 9.81;
    gravity = (0, 0, -g);
    body arm { mass: m1; shape: slender_rod(l1); centroid: (l1/2, 0, 0); }
    body pendulum { compound { slender_rod(l2), mass: m2, at: (0, 0, -l2/2), turned: (0, pi/2, 0); } }
    revolute phi = ground to arm { at: (0, 0, 0.4); }
    /// From the lower position of rest.
    revolute theta = arm to pendulum { at: (l1, 0, 0); axis: (1, 0, 0); }
    output tip = pendulum.point(0, 0, -l2);
    let all = angular_momentum(arm, (0, 0, 0)) + angular_momentum(pendulum, (0, 0, 0));
    output momentum = all.z;
    emit { drawing }
}

/// Both angles and their rates after one and three seconds.
const REFERENCE: [(f64, [f64; 4]); 2] = [
    (
        1.0,
        [3.008_259_054_885_524_4, 0.101_882_762_584_981_8, -0.481_763_468_267_968_2, 15.915_836_877_461_997],
    ),
    (3.0, [8.892_108_521_889_952, -0.302_531_435_408_786_35, 6.492_341_977_894_405, -15.445_470_921_151_27]),
];
const START: [f64; 4] = [0.0, 2.5, 3.0, 0.0];

fn main() -> Result<(), Box<dyn Error>> {
    let furuta = Furuta::default();
    for (end, reference) in REFERENCE {
        let state = furuta.simulate(START).until(end).tolerance(1e-13).ends_only().run()?.last();
        let names = ["phi, rad", "theta, rad", "phi_dot, rad/s", "theta_dot, rad/s"];
        let rows: [_; 4] = std::array::from_fn(|index| (names[index], state[index], reference[index]));
        compare(&format!("after {end} s"), 1e-10, &rows);
    }
    let motion = furuta.simulate(START).until(6.0).tolerance(1e-12).every(0.03).energy().run()?;
    let momentum = |y: [f64; 4]| furuta.momentum(0.0, &[y[0], y[1]], &[y[2], y[3]]);
    let energy = motion.column("energy").unwrap_or_default();
    let rows = [
        ("momentum, N m s", momentum(motion.last()), momentum(START)),
        ("energy, J", energy[energy.len() - 1], energy[0]),
    ];
    compare("after six seconds", 1e-12, &rows);

    let drawing = Drawing::of(&furuta)
        .title("A Furuta pendulum")
        .view(-0.9, 0.45)
        .floor(0.0)
        .velocities()
        .trace("", |furuta, t, y| furuta.tip(t, &[y[0], y[1]], &[y[2], y[3]]));
    let film = drawing
        .film(&motion)?
        .with_energy("kinetic", &motion, |t, y| furuta.kinetic_energy(t, &[y[0], y[1]], &[y[2], y[3]]))?;
    film.save(gallery::picture("furuta.html")?)?;
    let begin = furuta.simulate(START).until(1.7).every(0.01).run()?;
    let last = drawing.past(begin.iter()).picture(1.7, &begin.last())?;
    last.save(gallery::picture("furuta.svg")?)?;
    Ok(())
}
