//! Visuals of bodies, shown by pictures instead of their solids.

use lagrange::scene::{Item, Outline, Scene, Solid};

lagrange::system! {
    /// With declared inertia, and a cylinder beside the centre of mass and a sphere with a hole as
    /// visuals.
    struct Link;
    param r = 0.1, h = 0.5;
    body link {
        mass: 2;
        centroid: (0, 0, 0.2);
        inertia: (0.1, 0.1, 0.02);
        visual { solid_cylinder(r, h), at: (0, 0, h/2), turned: (pi/2, 0, 0); hole solid_sphere(r/2); }
    }
    revolute q = ground to link;
    emit { drawing }
}

lagrange::system! {
    /// A disk shown as a rod.
    struct Wheel;
    coord phi;
    body wheel { mass: 1; shape: disk(1); center: (0, 0); angle: phi; visual { slender_rod(2), angle: pi/2; } }
    emit { drawing }
}

#[test]
fn a_body_in_space_is_seen_as_its_visuals() {
    let mut parts = Vec::new();
    Link::default().items(0.0, &[0.3], &[0.0], &mut |item| {
        if let Item::Body { parts: of_body, .. } = item {
            parts.extend(of_body.iter().map(|part| (part.shape, part.at, part.rotation, part.is_hole)));
        }
    });
    let [cylinder, hole] = parts[..] else { panic!("{parts:?}") };
    let (shape, at, rotation, is_hole) = cylinder;
    assert_eq!((shape, at, is_hole), (Solid::Cylinder(0.1, 0.5), [0.0, 0.0, 0.25], false));
    // A quarter turn about x takes z to −y.
    assert_eq!(rotation.map(|row: [f64; 3]| row[2].round()), [0.0, -1.0, 0.0]);
    assert_eq!((hole.0, hole.1, hole.3), (Solid::Sphere(0.05), [0.0; 3], true));
}

#[test]
fn a_body_in_the_plane_is_seen_as_its_visuals_and_moves_as_before() {
    let mut inertia = 0.0;
    Wheel.items(0.0, &[0.0], &[0.0], &mut |item| {
        if let Item::Body { motion, parts, .. } = item {
            assert_eq!(parts.iter().map(|part| part.shape).collect::<Vec<_>>(), [Outline::SlenderRod(2.0)]);
            inertia = motion.inertia;
        }
    });
    assert_eq!(inertia, 0.5);
}
