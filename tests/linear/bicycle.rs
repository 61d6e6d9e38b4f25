//! The benchmark bicycle of four rigid bodies with knife-edge wheels, beside its published matrices
//! and eigenvalues: Meijaard, Papadopoulos, Ruina, Schwab, *Linearized dynamics equations for the
//! balance and steer of a bicycle*, Proc. R. Soc. A 463 (2007) 1955–1982, Tables 1 and 2.

use lagrange::linear::{Eigenmode, LinearModel, Linearise};

lagrange::system! {
    /// Whipple's bicycle; x ahead, y to the right, z down, as published.
    ///
    /// The rear wheel touches the ground at (x, y), its plane has the heading psi and leans by phi.
    /// The rear frame pitches by theta, the front frame is turned by delta about the steer axis.
    #[derive(Debug)]
    struct Bicycle;

    const w = 1.02, c = 0.08, tilt = pi/10, g = 9.81, rr = 0.3, rf = 0.35;
    const mr = 2, mb = 85, mh = 4, mf = 3;
    coord x, y, psi, phi, delta, theta, rear, front;

    // The plane of the rear wheel: ahead, across and downwards in it.
    let ahead = (cos(psi), sin(psi), 0);
    let across = (-sin(psi)*cos(phi), cos(psi)*cos(phi), sin(phi));
    let below = (sin(psi)*sin(phi), -cos(psi)*sin(phi), cos(phi));
    let hub = (x, y, 0) - rr * below;
    let turning = dot(psi) * (0, 0, 1) + dot(phi) * ahead;

    // Axes of the rear frame, and its place.
    let bx = cos(theta) * ahead - sin(theta) * below;
    let bz = sin(theta) * ahead + cos(theta) * below;
    let wb = turning + dot(theta) * across;
    let rider = hub + 0.3 * bx + (rr - 0.9) * bz;

    // The steer axis, and axes that are turned about it.
    let steer = sin(tilt) * bx + cos(tilt) * bz;
    let level = cos(tilt) * bx - sin(tilt) * bz;
    let forward = cos(delta) * level + sin(delta) * across;
    let hy = cos(delta) * across - sin(delta) * level;
    let hx = cos(tilt) * forward + sin(tilt) * steer;
    let hz = cos(tilt) * steer - sin(tilt) * forward;
    let wh = wb + dot(delta) * steer;
    let foot = hub + (w + c) * bx + rr * bz;
    let fork = foot + (0.9 - w - c) * hx - 0.7 * hz;
    let axle = foot - c * hx - rf * hz;

    kinetic = 1/2 * mr * inner(dot(hub), dot(hub)) + 1/2 * mb * inner(dot(rider), dot(rider));
    kinetic = 1/2 * mh * inner(dot(fork), dot(fork)) + 1/2 * mf * inner(dot(axle), dot(axle));
    let wr = turning + dot(rear) * across;
    kinetic = 1/2 * (0.0603 * inner(wr, wr) + (0.12 - 0.0603) * inner(wr, across)^2);
    let (b1, b2, b3) = (inner(wb, bx), inner(wb, across), inner(wb, bz));
    kinetic = 1/2 * (9.2 * b1^2 + 11 * b2^2 + 2.8 * b3^2) + 2.4 * b1 * b3;
    let (h1, h2, h3) = (inner(wh, hx), inner(wh, hy), inner(wh, hz));
    kinetic = 1/2 * (0.05892 * h1^2 + 0.06 * h2^2 + 0.00708 * h3^2) - 0.00756 * h1 * h3;
    let wf = wh + dot(front) * hy;
    kinetic = 1/2 * (0.1405 * inner(wf, wf) + (0.28 - 0.1405) * inner(wf, hy)^2);
    potential = -g * (mr * hub.z + mb * rider.z + mh * fork.z + mf * axle.z);

    // The wheels roll on their lowest points, in the plane of each wheel the farthest down.
    let rear_slip = dot(hub) + cross(wr, rr * below);
    constraint rear_x = rear_slip.x;
    constraint rear_y = rear_slip.y;
    let depth = sqrt(1 - hy.z^2);
    let down = ((0, 0, 1) - hy.z * hy) / depth;
    constraint touch = axle.z + rf * depth;
    let front_slip = dot(axle) + cross(wf, rf * down);
    constraint front_x = front_slip.x;
    constraint front_y = front_slip.y;
    emit { system_matrix, no latex }
}

/// Published: M, C₁, K₀ and K₂ of M q̈ + v C₁ q̇ + (g K₀ + v² K₂) q = 0 for lean and steer.
const M: [[f64; 2]; 2] = [[80.81722, 2.31941332208709], [2.31941332208709, 0.29784188199686]];
const C1: [[f64; 2]; 2] = [[0.0, 33.86641391492494], [-0.85035641456978, 1.68540397397560]];
const K0: [[f64; 2]; 2] = [[-80.95, -2.59951685249872], [-2.59951685249872, -0.80329488458618]];
const K2: [[f64; 2]; 2] = [[0.0, 76.59734589573222], [0.0, 2.65431523794604]];

/// Straight ahead at a speed.
fn ahead(speed: f64) -> LinearModel {
    let mut state = [0.0; 16];
    (state[8], state[14], state[15]) = (speed, -speed / 0.3, -speed / 0.35);
    let found = Bicycle.equilibrium(state).solve().expect("a steady motion");
    assert!(found.state.iter().zip(state).all(|(found, wanted)| (found - wanted).abs() < 1e-12), "{found:?}");
    Bicycle.linearise(0.0, found.state).expect("smooth")
}

#[test]
fn lean_and_steer_have_the_published_matrices() {
    for speed in [0.0, 1.0, 5.0] {
        let model = ahead(speed);
        let place = |name: &str| {
            let found = model.states().iter().position(|state| state == name);
            found.unwrap_or_else(|| panic!("{name} in {:?}", model.states()))
        };
        let [q, v] = [["phi", "delta"], ["phi_dot", "delta_dot"]].map(|names| names.map(place));
        for i in 0..2 {
            for j in 0..2 {
                // M A + … = 0, a row of M at a time.
                let by = |column: usize| (0..2).map(|k| M[i][k] * model.a()[(v[k], column)]).sum::<f64>();
                let stiffness = 9.81 * K0[i][j] + speed * speed * K2[i][j];
                assert!((by(q[j]) + stiffness).abs() < 1e-10, "{speed} {i} {j}: {} {stiffness}", by(q[j]));
                assert!((by(v[j]) + speed * C1[i][j]).abs() < 1e-10, "{speed} {i} {j}: {}", by(v[j]));
            }
        }
    }
}

#[test]
fn weave_capsize_and_castering_have_the_published_eigenvalues() {
    let pair = 5.530943717653933;
    let still = [(-3.131643247906566, 0.0), (3.131643247906566, 0.0), (-pair, 0.0), (pair, 0.0)];
    let capsize = (-0.322866429004087, 0.0);
    let fast = [capsize, (-0.775341882195845, 4.464867713788229), (-14.078389692798216, 0.0)];
    for (speed, wanted) in [(0.0, &still[..]), (5.0, &fast)] {
        let modes = ahead(speed).modes().expect("eigenvalues");
        for (real, imaginary) in wanted {
            let distance = |mode: &Eigenmode| (mode.real - real).hypot(mode.imaginary - imaginary);
            let nearest = modes.modes().iter().map(distance).fold(f64::INFINITY, f64::min);
            assert!(nearest < 1e-11, "{speed}: {real} {imaginary} by {nearest}\n{modes}");
        }
        // Six of the ten are zero: places, heading, angles of the wheels, and the speed.
        let zeros = modes.modes().iter().filter(|mode| mode.natural_frequency() < 1e-3);
        let count = zeros.map(|mode| if mode.imaginary > 0.0 { 2 } else { 1 }).sum::<usize>();
        assert_eq!(count, 6, "{modes}");
    }
}
