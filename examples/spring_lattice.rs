//! A grid of five by five masses in the plane, connected by springs to their neighbours and to
//! fixed points around them.
//!
//! Springs are free of tension while the masses are at their rest positions, one length apart. The
//! lattice is therefore stiff along its lines and soft across them. Forces across are of third
//! order, and the motion is far from that of a linear lattice. There is no gravity.
//!
//! The reference is Newton's law for each mass, in SciPy: `tools/many_of_a_kind.py`. Look for
//! twelve correct digits, and for constant energy.
//!
//! `cargo run --example spring_lattice`

mod common;

use std::array::from_fn;
use std::error::Error;

use common::compare;
use lagrange::Simulate;

lagrange::system! {
    /// Masses in rows i and columns j, displaced by u along the rows and by v across them.
    #[derive(Clone, Debug)]
    pub struct SpringLattice;

    const n = 5;
    const spacing: m = 1, mass: kg = 1;
    param k: N/m = 20, rest: m = 1;
    coord u[n][n]: m, v[n][n]: m;
    for i in 0..n {
        for j in 0..n {
            let r[i][j] = (j * spacing + u[i][j], i * spacing + v[i][j]);
            kinetic = kinetic_energy((1 + (i + j)/10) * mass, dot(r[i][j]));
            let left[i][j] = if j > 0 { r[i][j-1] } else { (-spacing, i * spacing) };
            let below[i][j] = if i > 0 { r[i-1][j] } else { (j * spacing, -spacing) };
            potential = spring_energy(k, norm(r[i][j] - left[i][j]) - rest);
            potential = spring_energy(k, norm(r[i][j] - below[i][j]) - rest);
        }
        potential = spring_energy(k, norm(r[i][n-1] - spacing * (n, i)) - rest);
    }
    for j in 0..n {
        potential = spring_energy(k, norm(r[n-1][j] - spacing * (j, n)) - rest);
    }
}

/// Indices of a corner mass, the middle mass, and a mass on the edge.
const MASSES: [(usize, usize); 3] = [(0, 0), (2, 2), (4, 1)];
/// Values from `tools/many_of_a_kind.py`.
const U: [f64; 3] = [0.06735961770228524, -0.3443510586153626, 0.13167790956440584];
const V: [f64; 3] = [-0.1555983658483713, 0.030436138800277103, -0.07072282025838085];
const RATE: f64 = 0.186378252469606;

fn main() -> Result<(), Box<dyn Error>> {
    let grid = |f: fn(f64, f64) -> f64| from_fn(|i| from_fn(|j| f(i as f64, j as f64)));
    let start = SpringLatticeState {
        u: grid(|i, j| 0.2 * (1.0 + i + 2.0 * j).sin()),
        v: grid(|i, j| 0.2 * (3.0 * i - j).cos()),
        u_dot: [[0.0; 5]; 5],
        v_dot: [[0.0; 5]; 5],
    };
    let lattice = SpringLattice::default();
    let run = lattice.simulate(start).until(2.0).tolerance(1e-13).energy().run()?;
    let end = SpringLatticeState::from(run.last());
    let names = ["corner", "middle", "rim"];
    let rows = |found: &[[f64; 5]; 5], known: [f64; 3]| {
        [0, 1, 2].map(|k| (names[k], found[MASSES[k].0][MASSES[k].1], known[k]))
    };
    compare("displacements along the rows, in m", 1e-12, &rows(&end.u, U));
    compare("displacements across them, in m", 1e-12, &rows(&end.v, V));
    compare("rate along the row, in m/s", 1e-12, &[("middle", end.u_dot[2][2], RATE)]);
    println!("{} states; the middle began at u = {:.6} m", run.len(), run.u(2, 2)[0]);
    let energy = run.column("energy").ok_or("it was asked for")?;
    compare("energy, in J", 1e-11, &[("at the end", energy[energy.len() - 1], energy[0])]);
    Ok(())
}
