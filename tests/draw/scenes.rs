//! Scenes with prescribed motions.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_6};

use lagrange::body::Motion;
use lagrange::draw::Drawing;
use lagrange::scene::{
    Connector, Item, Joint, LoadOrigin, Outline, Part, Plane, Scene, Surface, SurfaceShape,
};
use lagrange::system::{MechanicalSystem, OdeSystem, Unnamed};

/// A scene that shows its items as a function of a single coordinate.
pub(crate) struct Puppet(pub(crate) Items);

/// Hands out the items.
pub(crate) type Items = fn(f64, &mut dyn FnMut(Item<'_, f64>));

impl OdeSystem for Puppet {
    type Scalar = f64;
    type State = [f64; 2];

    fn rhs(&self, _t: f64, y: &[f64; 2]) -> [f64; 2] {
        [y[1], 0.0]
    }
}

impl MechanicalSystem for Puppet {
    type Coordinates = [f64; 1];
    type Velocities = [f64; 1];
    type Columns<C> = Unnamed<C>;
    const COORDINATES: &'static [&'static str] = &["s"];

    fn acceleration(&self, _t: f64, _q: &[f64; 1], _v: &[f64; 1]) -> [f64; 1] {
        [0.0]
    }

    fn position_rates(&self, _t: f64, _q: &[f64; 1], v: &[f64; 1]) -> [f64; 1] {
        *v
    }
}

impl Scene for Puppet {
    type Space = Plane;

    fn items(&self, _t: f64, q: &[f64; 1], _v: &[f64; 1], visit: &mut dyn FnMut(Item<'_, f64>)) {
        (self.0)(q[0], visit);
    }
}

/// Returns a body at rest.
pub(crate) fn still(center: [f64; 2], angle: f64) -> Motion<f64> {
    Motion {
        mass: 1.0,
        inertia: 1.0,
        centroid: [0.0, 0.0],
        center,
        angle,
        velocity: [0.0, 0.0],
        angular_velocity: 0.0,
        acceleration: [0.0, 0.0],
        angular_acceleration: 0.0,
    }
}

/// Returns a line at rest.
pub(crate) fn line(name: &str, at: [f64; 2], rotation: f64) -> Item<'_, f64> {
    Item::Surface(Surface { name, body: None, shape: SurfaceShape::Flat, at, rotation, is_inside: false })
}

pub(crate) fn part(outline: Outline<'_, f64>) -> Part<'_, f64> {
    Part { shape: outline, at: [0.0, 0.0], rotation: 0.0, is_hole: false }
}

/// The two halves of a step ladder, the left foot at rest; the coordinate is the angle φ to the
/// floor, φ̇ = −1.
pub(crate) const LADDER: Puppet = Puppet(|phi, visit| {
    let (sin, cos) = phi.sin_cos();
    visit(line("floor", [0.0, 0.0], 0.0));
    let rod = [part(Outline::SlenderRod(1.0))];
    let left = Motion {
        velocity: [0.5 * sin, -0.5 * cos],
        angular_velocity: -1.0,
        acceleration: [-0.5 * cos, -0.5 * sin],
        ..still([0.5 * cos, 0.5 * sin], phi)
    };
    let right = Motion {
        velocity: [1.5 * sin, -0.5 * cos],
        angular_velocity: 1.0,
        acceleration: [-1.5 * cos, -0.5 * sin],
        ..still([1.5 * cos, 0.5 * sin], -phi)
    };
    visit(Item::Body { name: "left", motion: left, parts: &rod });
    visit(Item::Body { name: "right", motion: right, parts: &rod });
    visit(Item::Joint { name: "foot", kind: Joint::Anchor, at: [0.0, 0.0] });
    visit(Item::Joint { name: "hinge", kind: Joint::Pin, at: [cos, sin] });
    visit(Item::Joint { name: "slide", kind: Joint::Slide, at: [2.0 * cos, 0.0] });
});

/// Returns the drawing of the step ladder with every option on.
pub(crate) fn ladder() -> Drawing<'static, Puppet> {
    Drawing::of(&LADDER)
        .title("The instantaneous centre M of the right half")
        .velocities()
        .trace("M", |_, _, y| [2.0 * y[0].cos(), 2.0 * y[0].sin()])
        .annotate(|sketch, moment| {
            let (sin, cos) = moment.q[0].sin_cos();
            sketch.point([cos, sin], "B").point([2.0 * cos, 0.0], "C").ink(3);
            sketch.dashed([cos, sin], [2.0 * cos, 2.0 * sin]);
            sketch.dashed([2.0 * cos, 0.0], [2.0 * cos, 2.0 * sin]);
            sketch.dashed_circle([0.0, 0.0], 2.0).ink(0);
            sketch.angle([0.0, 0.0], 0.0, moment.q[0], "phi").dimension([0.0, 0.0], [cos, sin], "L");
        })
}

/// A rolling cylinder behind a sliding cuboid on a slope; the coordinate is the distance that the
/// cylinder has rolled.
pub(crate) const SLOPE: Puppet = Puppet(|s, visit| {
    let (alpha, radius) = (FRAC_PI_6, 0.5);
    let (along, up) = ([alpha.cos(), -alpha.sin()], [alpha.sin(), alpha.cos()]);
    let at = |x: f64, y: f64| [x * along[0] + y * up[0], x * along[1] + y * up[1]];
    visit(line("slope", [0.0, 0.0], -alpha));
    let cylinder = Motion {
        velocity: at(1.0, 0.0),
        angular_velocity: -1.0 / radius,
        acceleration: at(9.81 * alpha.sin() * 2.0 / 3.0, 0.0),
        angular_acceleration: -1.0 - 9.81 * alpha.sin() / 3.0 * radius,
        ..still(at(s, radius), -s / radius - alpha)
    };
    let acceleration = at(9.81 * alpha.sin(), 0.0);
    let cuboid = Motion { velocity: at(1.5, 0.0), acceleration, ..still(at(s + 2.5, radius), -alpha) };
    visit(Item::Body { name: "cylinder", motion: cylinder, parts: &[part(Outline::Disk(radius))] });
    let shape = [part(Outline::Rectangle(2.0 * radius, 2.0 * radius))];
    visit(Item::Body { name: "cuboid", motion: cuboid, parts: &shape });
    visit(Item::Joint { name: "contact", kind: Joint::Roll, at: at(s, 0.0) });
    visit(Item::Joint { name: "face", kind: Joint::Slide, at: at(s + 2.5, 0.0) });
    let mut load = |name, cause, body, at: [f64; 2], force: [f64; 2]| {
        visit(Item::Force { name, cause, body: Some(body), at, force });
    };
    let weight = [0.0, -9.81];
    load("weight", LoadOrigin::Gravity, "cylinder", cylinder.center, weight);
    load("weight", LoadOrigin::Gravity, "cuboid", cuboid.center, weight);
    load("N", LoadOrigin::Joint, "cylinder", at(s, 0.0), at(0.0, 9.81 * alpha.cos()));
    load("H", LoadOrigin::Joint, "cylinder", at(s, 0.0), at(-9.81 * alpha.sin() / 3.0, 0.0));
    load("N", LoadOrigin::Joint, "cuboid", at(s + 2.5, 0.0), at(0.0, 9.81 * alpha.cos()));
    visit(Item::Moment {
        name: "M",
        cause: LoadOrigin::Applied,
        body: Some("cylinder"),
        at: cylinder.center,
        moment: -1.0,
    });
});

/// A body of every shape and every connector.
pub(crate) const COLLECTION: Puppet = Puppet(|s, visit| {
    const CORNERS: [[f64; 2]; 6] = [[0.0, 0.0], [1.0, 0.0], [1.0, 0.3], [0.3, 0.3], [0.3, 1.0], [0.0, 1.0]];
    let shapes = [
        ("mass", Outline::PointMass),
        ("rod", Outline::SlenderRod(1.0)),
        ("disk", Outline::Disk(0.5)),
        ("tube", Outline::Annulus(0.3, 0.5)),
        ("ring", Outline::Ring(0.5)),
        ("plate", Outline::Rectangle(1.0, 0.6)),
        ("half", Outline::SemicircularDisk(0.5)),
        ("sector", Outline::CircularSector(0.8, 1.0)),
        ("wedge", Outline::RightTriangle(0.8, 0.6)),
        ("triangle", Outline::Triangle(1.0, 0.8, 0.6)),
        ("ellipse", Outline::Ellipse(0.5, 0.3)),
        ("hexagon", Outline::RegularPolygon(6.0, 0.5)),
        ("bracket", Outline::Polygon(&CORNERS)),
    ];
    for (index, (name, outline)) in shapes.into_iter().enumerate() {
        let at = [1.6 * (index % 5) as f64, -1.6 * (index / 5) as f64];
        visit(Item::Body { name, motion: still(at, s), parts: &[part(outline)] });
    }
    let hole = |at, radius| Part { is_hole: true, at, ..part(Outline::Disk(radius)) };
    let wheel = [
        part(Outline::Disk(0.5)),
        Part { at: [0.5, 0.0], ..part(Outline::Rectangle(0.8, 0.3)) },
        hole([-0.25, 0.0], 0.12),
        hole([0.9, 0.0], 0.08),
        hole([0.0, 0.5], 0.15),
    ];
    visit(Item::Body { name: "wheel", motion: still([4.8, -3.2], s), parts: &wheel });
    let connectors =
        [Connector::Spring, Connector::Damper, Connector::TorsionSpring, Connector::TorsionDamper];
    for (index, kind) in connectors.into_iter().enumerate() {
        let x = 1.6 * index as f64;
        let to = if index < 2 { [x + 1.0, -4.8 + 0.2 * s] } else { [x, -4.8] };
        let name = ["k1", "c1", "k_phi", "c_phi"][index];
        visit(Item::Connector { name, kind, from: [x, -4.8], to, tension: 0.0 });
    }
    visit(Item::Joint { name: "pin", kind: Joint::Anchor, at: [6.4, -4.8] });
});

/// A rod against a wall and a cart on a floor, which end where they meet; the wall extends
/// downwards.
pub(crate) const CORNER: Puppet = Puppet(|phi, visit| {
    let (sin, cos) = phi.sin_cos();
    visit(line("floor", [0.0, 0.0], 0.0));
    visit(line("wall", [0.0, 0.0], -FRAC_PI_2));
    let rod = [part(Outline::SlenderRod(2.0))];
    visit(Item::Body { name: "rod", motion: still([cos, sin], -phi), parts: &rod });
    visit(Item::Joint { name: "foot", kind: Joint::Slide, at: [2.0 * cos, 0.0] });
    visit(Item::Joint { name: "top", kind: Joint::Slide, at: [0.0, 2.0 * sin] });
});

/// Three bodies with a torsion spring, a pin and a torsion damper at their centres.
pub(crate) const CROWDED: Puppet = Puppet(|s, visit| {
    let bodies = [
        ("tube", Outline::Annulus(0.3, 0.5)),
        ("plate", Outline::Rectangle(1.0, 0.6)),
        ("left_rod", Outline::SlenderRod(1.0)),
    ];
    for (index, (name, outline)) in bodies.into_iter().enumerate() {
        visit(Item::Body { name, motion: still([1.5 * index as f64, 0.0], s), parts: &[part(outline)] });
    }
    let mut connector =
        |name, kind, at| visit(Item::Connector { name, kind, from: at, to: at, tension: 0.0 });
    connector("torsion_spring_1", Connector::TorsionSpring, [0.0, 0.0]);
    connector("torsion_damper_1", Connector::TorsionDamper, [3.0, 0.0]);
    visit(Item::Joint { name: "pin", kind: Joint::Anchor, at: [1.5, 0.0] });
});
