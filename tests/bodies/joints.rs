//! Forces of joints as vectors: on the body named first, as in the free-body diagram of the source.

use lagrange::Simulate;

use crate::assert_within;
use crate::pairs::Random;

lagrange::system! {
    /// Two plates, one hanging from the other, each with its own coordinates; a spring holds the
    /// lower one.
    #[derive(Clone, Debug)]
    struct Plates;

    param m1 = 1.2, m2 = 0.7, a = 0.3, b = 0.8, k = 12.0, g = 9.81;
    coord x1, y1, p, x2, y2, q;
    gravity = (0, -g);
    body upper { shape: rectangle(a, b); mass: m1; center: (x1, y1); angle: p; }
    body lower { shape: rectangle(a, b); mass: m2; center: (x2, y2); angle: q; }
    pin pivot = upper.point(0, b/2) to (0, 0);
    pin hinge = lower.point(0, b/2) to upper.point(0, -b/2);
    spring band { from: (1, -1); to: lower; stiffness: k; rest: 1/4; }
    output on_upper = pivot.force;
    output on_lower = hinge.force;
    output of_band = (band.force, band.length);
}

/// Returns states that satisfy the constraints.
fn states(plates: &Plates) -> impl Iterator<Item = ([f64; 6], [f64; 6])> + '_ {
    let mut random = Random::new(4);
    (0..20).map(move |_| {
        let mut draw = || random.next();
        let (p, q, v) = (draw(), draw(), std::array::from_fn(|_| draw()));
        let (x1, y1) = (plates.b / 2.0 * p.sin(), -plates.b / 2.0 * p.cos());
        let (x2, y2) = (2.0 * x1 + plates.b / 2.0 * q.sin(), 2.0 * y1 - plates.b / 2.0 * q.cos());
        let place = [x1, y1, p, x2, y2, q];
        (place, plates.consistent_velocity(0.0, &place, &v).expect("velocities exist"))
    })
}

/// m a = F of all forces: the pin at the ground, the reversed force of the hinge, the weight, the
/// spring.
#[test]
fn forces_of_pins_and_springs_accelerate_the_centers() {
    let plates = Plates::default();
    for (q, v) in states(&plates) {
        let a = plates.acceleration(0.0, &q, &v);
        let (pivot, hinge) = (plates.on_upper(0.0, &q, &v), plates.on_lower(0.0, &q, &v));
        let [tension, length] = plates.of_band(0.0, &q, &v);
        let pull = [1.0 - q[3], -1.0 - q[4]].map(|component| tension * component / length);
        assert_within(1e-13, tension, plates.k * (length - 0.25));
        assert_within(1e-12, plates.m1 * a[0], pivot[0] - hinge[0]);
        assert_within(1e-12, plates.m1 * a[1], pivot[1] - hinge[1] - plates.m1 * plates.g);
        assert_within(1e-12, plates.m2 * a[3], hinge[0] + pull[0]);
        assert_within(1e-12, plates.m2 * a[4], hinge[1] + pull[1] - plates.m2 * plates.g);
    }
}

/// J φ̈ equals the moments of the same forces about the centres of mass.
#[test]
fn forces_of_pins_turn_the_bodies() {
    let plates = Plates::default();
    let j = |m: f64| m * (plates.a * plates.a + plates.b * plates.b) / 12.0;
    for (q, v) in states(&plates) {
        let a = plates.acceleration(0.0, &q, &v);
        let (pivot, hinge) = (plates.on_upper(0.0, &q, &v), plates.on_lower(0.0, &q, &v));
        let top = |angle: f64| [-plates.b / 2.0 * angle.sin(), plates.b / 2.0 * angle.cos()];
        let moment = |arm: [f64; 2], force: [f64; 2]| arm[0] * force[1] - arm[1] * force[0];
        // The hinge pulls the lower end of the upper plate by the opposite force, on the opposite
        // arm.
        let upper = moment(top(q[2]), pivot) + moment(top(q[2]), hinge);
        assert_within(1e-12, j(plates.m1) * a[2], upper);
        assert_within(1e-12, j(plates.m2) * a[5], moment(top(q[5]), hinge));
    }
}

lagrange::system! {
    /// A plate that hangs at rest.
    struct Hanging;

    param m = 2.0, a = 0.5, g = 9.81;
    coord x, y, phi;
    gravity = (0, -g);
    body plate { mass: m; shape: rectangle(a, a); center: (x, y); angle: phi; }
    pin nail = plate.point(0, a/2) to (0, 0);
    output holds = nail.force;
}

#[test]
fn a_nail_carries_the_weight() {
    let hanging = Hanging::default();
    let [x, y] = hanging.holds(0.0, &[0.0, -hanging.a / 2.0, 0.0], &[0.0; 3]);
    assert_within(1e-14, x, 0.0);
    assert_within(1e-14, y, hanging.m * hanging.g);
}

lagrange::system! {
    /// A block that slides down a wedge, which slides on the floor.
    #[derive(Clone, Debug)]
    struct Wedge;

    param m1 = 5.0, m2 = 1.0, a = 0.2, alpha = 0.4, g = 9.81;
    coord s, x, y;
    gravity = (0, -g);
    body wedge { mass: m1; center: (s, 0); }
    line incline { on: wedge; angle: -alpha; }
    body block { mass: m2; shape: rectangle(a, a); center: (x, y); angle: -alpha; }
    slide contact = block.point(0, -a/2) on incline;
    output pressure = contact.normal;
    output along = incline.along(block);
    output away = incline.distance(block);
}

/// The block and the wedge by Newton's laws: N = m₁ m₂ g cos α/(m₁ + m₂ sin² α).
#[test]
fn a_block_presses_less_on_a_wedge_that_gives_way() {
    let wedge = Wedge::default();
    let (sine, cosine) = wedge.alpha.sin_cos();
    let start = [0.0, wedge.a / 2.0 * sine, wedge.a / 2.0 * cosine, 0.0, 0.0, 0.0];
    let normal = wedge.m1 * wedge.m2 * wedge.g * cosine / (wedge.m1 + wedge.m2 * sine * sine);
    let q = [start[0], start[1], start[2]];
    assert_within(1e-13, wedge.pressure(0.0, &q, &[0.0; 3]), normal);
    assert_within(1e-14, wedge.along(0.0, &q, &[0.0; 3]), 0.0);
    assert_within(1e-14, wedge.away(0.0, &q, &[0.0; 3]), wedge.a / 2.0);

    // Along the wedge it accelerates at (m₁ + m₂) g sin α/(m₁ + m₂ sin² α), the wedge at −N sin
    // α/m₁.
    let run = wedge.simulate(start).until(1.0).tolerance(1e-13).run().expect("it runs");
    let state = WedgeState::from(run.last());
    let (q, v) = (state.coordinates(), state.velocities());
    let slid = (wedge.m1 + wedge.m2) * wedge.g * sine / (wedge.m1 + wedge.m2 * sine * sine);
    assert_within(1e-12, wedge.along(1.0, &q, &v), slid / 2.0);
    assert_within(1e-12, state.s, -normal * sine / wedge.m1 / 2.0);
}
