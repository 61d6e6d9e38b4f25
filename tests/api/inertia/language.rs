//! The functions of the language in emitted code against those of the library.

use lagrange::inertia;

lagrange::system! {
    /// Every function of mass geometry as an output.
    struct Solids;

    param m = 2.5, r = 0.8, hole = 0.3, a = 2.0, b = 1.7, c = 1.4, e = 1.1;
    coord x;
    kinetic = kinetic_energy(m, dot(x));
    output point = point_mass(m);
    output rods = (slender_rod(m, a), rod(m, a), slender_rod_end(m, a));
    output cylinders = (solid_cylinder(m, r), disk(m, r), hollow_cylinder(m, hole, r));
    output ring = thin_ring(m, r);
    output boxes = (rectangle(m, a, b), cuboid(m, a, b));
    output sectors = (semicircular_disk(m, r), circular_sector(m, r, e));
    output triangles = (right_triangle(m, a, b), triangle(m, a, b, c));
    output curved = (ellipse(m, a, b), regular_polygon(m, 7, r));
    output spheres = (solid_sphere(m, r), hollow_sphere(m, hole, r), thin_sphere(m, r));
    output quadrangle = polygon(m, (0, 0), (a, hole), (b, c), (-e, r));
    output shifted = steiner(disk(m, r), m, a);
    output semicircular_center = semicircular_disk_center(r);
    output sector_center = circular_sector_center(r, e);
    output right_center = right_triangle_center(a, b);
    output triangular_center = triangle_center(a, b, c);
    output quadrangle_center = polygon_center((0, 0), (a, hole), (b, c), (-e, r));
}

#[test]
fn emitted_functions_are_those_of_the_library() {
    let s = Solids::default();
    let Solids { m, r, hole, a, b, c, e } = s;
    let q = &[0.0];
    let corners = [[0.0, 0.0], [a, hole], [b, c], [-e, r]];
    let rods = [inertia::slender_rod(m, a), inertia::rod(m, a), inertia::slender_rod_end(m, a)];
    let disk = inertia::disk(m, r);
    let cylinders = [inertia::solid_cylinder(m, r), disk, inertia::hollow_cylinder(m, hole, r)];
    let spheres =
        [inertia::solid_sphere(m, r), inertia::hollow_sphere(m, hole, r), inertia::thin_sphere(m, r)];
    let sectors = [inertia::semicircular_disk(m, r), inertia::circular_sector(m, r, e)];
    let triangles = [inertia::right_triangle(m, a, b), inertia::triangle(m, a, b, c)];
    let curved = [inertia::ellipse(m, a, b), inertia::regular_polygon(m, 7, r)];
    assert_alike(&[s.point(0.0, q, q)], &[inertia::point_mass(m)]);
    assert_alike(&s.rods(0.0, q, q), &rods);
    assert_alike(&s.cylinders(0.0, q, q), &cylinders);
    assert_alike(&[s.ring(0.0, q, q)], &[inertia::thin_ring(m, r)]);
    assert_alike(&s.boxes(0.0, q, q), &[inertia::rectangle(m, a, b), inertia::cuboid(m, a, b)]);
    assert_alike(&s.sectors(0.0, q, q), &sectors);
    assert_alike(&s.triangles(0.0, q, q), &triangles);
    assert_alike(&s.curved(0.0, q, q), &curved);
    assert_alike(&s.spheres(0.0, q, q), &spheres);
    assert_alike(&[s.quadrangle(0.0, q, q)], &[inertia::polygon(m, &corners)]);
    assert_alike(&[s.shifted(0.0, q, q)], &[inertia::steiner(disk, m, a)]);
    assert_alike(&s.semicircular_center(0.0, q, q), &inertia::semicircular_disk_center(r));
    assert_alike(&s.sector_center(0.0, q, q), &inertia::circular_sector_center(r, e));
    assert_alike(&s.right_center(0.0, q, q), &inertia::right_triangle_center(a, b));
    assert_alike(&s.triangular_center(0.0, q, q), &inertia::triangle_center(a, b, c));
    assert_alike(&s.quadrangle_center(0.0, q, q), &inertia::polygon_center(&corners));
}

#[track_caller]
fn assert_alike(found: &[f64], expected: &[f64]) {
    assert_eq!(found.len(), expected.len());
    for (&found, &expected) in found.iter().zip(expected) {
        crate::assert_close(found, expected);
    }
}
