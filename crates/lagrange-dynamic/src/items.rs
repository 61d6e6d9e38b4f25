//! Drawn items from their numbers.

use lagrange_core::bodies::{DrawnKind, JointForm, LoadOrigin as DeclaredOrigin, SpatialJointForm};
use lagrange_core::mobilizers;
use lagrange_core::pipeline::{DrawnScene, NumericSystem, PlacedItem, PlacedPart};
use lagrange_core::syntax::ast::{ConnectorKind, MobilizerKind, SurfaceKind};
use lagrange_runtime::body::{Motion, SpatialMotion};
use lagrange_runtime::scene::{
    Connector, Frame, Height, Item, Joint, LoadOrigin, Outline, Part, Plane, Solid, Space, Spatial,
    SpatialJoint, SpatialJointKind, Surface, SurfaceShape,
};

/// A space whose items are constructed from their numbers. Bodies have no rates, which are only
/// needed for arrows.
pub trait NumberedSpace: Space {
    /// Visits a body, frame, surface or joint, whose numbers come first. `height` returns the
    /// height of terrain over a place.
    fn item(
        item: &PlacedItem,
        numbers: &mut Numbers<'_>,
        height: &dyn Fn([f64; 2]) -> f64,
        visit: &mut dyn FnMut(Item<'_, f64, Self>),
    );
    /// Takes a vector.
    fn vector(numbers: &mut Numbers<'_>) -> Self::Vector<f64>;
    /// Takes a moment.
    fn moment(numbers: &mut Numbers<'_>) -> Self::Moment<f64>;
}

/// Visits the items of a system at a state.
pub fn visit_items<D: NumberedSpace>(
    system: &NumericSystem,
    scene: &DrawnScene,
    (t, q, v): (f64, &[f64], &[f64]),
    visit: &mut dyn FnMut(Item<'_, f64, D>),
) {
    let numbers = system.evaluate(&scene.program, t, q, v);
    visit_evaluated(system, scene, (t, q, v), &numbers, visit);
}

/// Visits the items of a system at a state, for which the program of the scene computed `numbers`.
pub(crate) fn visit_evaluated<D: NumberedSpace>(
    system: &NumericSystem,
    scene: &DrawnScene,
    (t, q, v): (f64, &[f64], &[f64]),
    numbers: &[f64],
    visit: &mut dyn FnMut(Item<'_, f64, D>),
) {
    let mut numbers = Numbers(numbers);
    for item in &scene.items {
        let height = |place| match &item.height {
            Some(height) => system.height(height, (t, q, v), place),
            None => f64::NAN,
        };
        visit_item(item, &mut numbers, &height, visit);
    }
}

/// Visits an item whose numbers come first, and leaves the numbers of other items.
fn visit_item<D: NumberedSpace>(
    item: &PlacedItem,
    numbers: &mut Numbers<'_>,
    height: &dyn Fn([f64; 2]) -> f64,
    visit: &mut dyn FnMut(Item<'_, f64, D>),
) {
    match &item.kind {
        DrawnKind::Connector { name, kind } => {
            let (from, to, tension) = (D::vector(numbers), D::vector(numbers), numbers.one());
            visit(Item::Connector { name, kind: connector(*kind), from, to, tension });
        }
        DrawnKind::Force { name, cause, body } => {
            let (cause, body) = (origin(*cause), body.as_deref());
            let (at, force) = (D::vector(numbers), D::vector(numbers));
            visit(Item::Force { name, cause, body, at, force });
        }
        DrawnKind::Moment { name, cause, body } => {
            let (cause, body) = (origin(*cause), body.as_deref());
            let (at, moment) = (D::vector(numbers), D::moment(numbers));
            visit(Item::Moment { name, cause, body, at, moment });
        }
        DrawnKind::Cone { name, body } => {
            let (at, normal, coefficient) = (D::vector(numbers), D::vector(numbers), numbers.one());
            visit(Item::Cone { name, body: body.as_deref(), at, normal, coefficient });
        }
        // Torques have already become moments.
        DrawnKind::Omitted { name } | DrawnKind::Torque { name } => visit(Item::Omitted { name }),
        DrawnKind::Body { .. }
        | DrawnKind::Surface { .. }
        | DrawnKind::Joint { .. }
        | DrawnKind::Frame { .. }
        | DrawnKind::SpatialJoint { .. } => D::item(item, numbers, height, visit),
    }
}

/// Items with the same values in the plane and in space.
macro_rules! in_both {
    () => {
        DrawnKind::Connector { .. }
            | DrawnKind::Force { .. }
            | DrawnKind::Moment { .. }
            | DrawnKind::Cone { .. }
            | DrawnKind::Omitted { .. }
            | DrawnKind::Torque { .. }
    };
}

/// Numbers that are consumed in order; NaN after the last.
#[derive(Debug)]
pub struct Numbers<'a>(&'a [f64]);

impl Numbers<'_> {
    fn take<const COUNT: usize>(&mut self) -> [f64; COUNT] {
        std::array::from_fn(|_| self.one())
    }

    fn one(&mut self) -> f64 {
        let Some((first, rest)) = self.0.split_first() else { return f64::NAN };
        self.0 = rest;
        *first
    }

    fn rows(&mut self) -> [[f64; 3]; 3] {
        std::array::from_fn(|_| self.take())
    }

    /// Returns the shape of a surface.
    fn shape<'h>(&mut self, kind: SurfaceKind, height: &'h dyn Fn([f64; 2]) -> f64) -> SurfaceShape<'h, f64> {
        match kind {
            SurfaceKind::Line | SurfaceKind::Plane => SurfaceShape::Flat,
            SurfaceKind::Circle | SurfaceKind::Sphere => SurfaceShape::Round(self.one()),
            SurfaceKind::Cylinder => SurfaceShape::Cylinder(self.one()),
            SurfaceKind::Terrain => SurfaceShape::Terrain(Height(height)),
        }
    }

    /// Returns the solid of a part, with its placement.
    fn solid<'p>(&mut self, part: &PlacedPart) -> Part<'p, f64, Spatial> {
        let shape = Solid::of_variant(part.variant, &mut || self.one()).unwrap_or(Solid::PointMass);
        Part { shape, at: self.take(), rotation: self.rows(), is_hole: part.is_hole }
    }

    /// Returns the outline of a part, with its placement. `corners` have already been consumed.
    fn outline<'c>(&mut self, part: &PlacedPart, corners: &'c [[f64; 2]]) -> Part<'c, f64, Plane> {
        let shape = Outline::of_variant(part.variant, corners, &mut || self.one());
        let shape = shape.unwrap_or(Outline::PointMass);
        Part { shape, at: self.take(), rotation: self.one(), is_hole: part.is_hole }
    }

    /// Returns the corners of each part, and the numbers of the parts without them.
    fn without_corners(&mut self, parts: &[PlacedPart]) -> (Vec<Vec<[f64; 2]>>, Vec<f64>) {
        let (mut corners, mut rest) = (Vec::new(), Vec::new());
        for part in parts {
            let count = if part.has_corners { part.dimension_count / 2 } else { 0 };
            corners.push((0..count).map(|_| self.take()).collect());
            // The placement of the part has three numbers.
            let others = 3 + if part.has_corners { 0 } else { part.dimension_count };
            rest.extend((0..others).map(|_| self.one()));
        }
        (corners, rest)
    }
}

impl NumberedSpace for Plane {
    fn item(
        item: &PlacedItem,
        numbers: &mut Numbers<'_>,
        height: &dyn Fn([f64; 2]) -> f64,
        visit: &mut dyn FnMut(Item<'_, f64>),
    ) {
        match &item.kind {
            DrawnKind::Body { .. } => {
                let (centroid, center, angle) = (numbers.take(), numbers.take(), numbers.one());
                let none = [0.0; 2];
                let motion = Motion {
                    mass: 0.0,
                    inertia: 0.0,
                    centroid,
                    center,
                    angle,
                    velocity: none,
                    angular_velocity: 0.0,
                    acceleration: none,
                    angular_acceleration: 0.0,
                };
                let (corners, rest) = numbers.without_corners(&item.parts);
                let mut rest = Numbers(&rest);
                let parts =
                    item.parts.iter().zip(&corners).map(|(part, corners)| rest.outline(part, corners));
                visit(Item::Body { name: &item.body, motion, parts: &parts.collect::<Vec<_>>() });
            }
            DrawnKind::Surface { name, body, kind, is_inside, .. } => {
                let (at, rotation) = (numbers.take(), numbers.one());
                let (body, shape, is_inside) = (body.as_deref(), numbers.shape(*kind, height), *is_inside);
                visit(Item::Surface(Surface { name, body, shape, at, rotation, is_inside }));
            }
            DrawnKind::Joint { name, kind } => {
                let kind = match kind {
                    JointForm::Pin => Joint::Pin,
                    JointForm::Anchor => Joint::Anchor,
                    JointForm::Slide => Joint::Slide,
                    JointForm::Roll => Joint::Roll,
                };
                visit(Item::Joint { name, kind, at: numbers.take() });
            }
            DrawnKind::Frame { .. } | DrawnKind::SpatialJoint { .. } => {}
            in_both!() => {}
        }
    }

    fn vector(numbers: &mut Numbers<'_>) -> [f64; 2] {
        numbers.take()
    }

    fn moment(numbers: &mut Numbers<'_>) -> f64 {
        numbers.one()
    }
}

impl NumberedSpace for Spatial {
    fn item(
        item: &PlacedItem,
        numbers: &mut Numbers<'_>,
        height: &dyn Fn([f64; 2]) -> f64,
        visit: &mut dyn FnMut(Item<'_, f64, Spatial>),
    ) {
        match &item.kind {
            DrawnKind::Body { .. } => {
                let (centroid, center, rotation) = (numbers.take(), numbers.take(), numbers.rows());
                let none = [0.0; 3];
                let motion = SpatialMotion {
                    mass: 0.0,
                    inertia: [none; 3],
                    centroid,
                    center,
                    rotation,
                    velocity: none,
                    angular_velocity: none,
                    acceleration: none,
                    angular_acceleration: none,
                };
                let parts = item.parts.iter().map(|part| numbers.solid(part)).collect::<Vec<_>>();
                visit(Item::Body { name: &item.body, motion, parts: &parts });
            }
            DrawnKind::Surface { name, body, kind, is_inside, .. } => {
                let (at, rotation) = (numbers.take(), numbers.rows());
                let (body, shape, is_inside) = (body.as_deref(), numbers.shape(*kind, height), *is_inside);
                visit(Item::Surface(Surface { name, body, shape, at, rotation, is_inside }));
            }
            DrawnKind::Frame { name } => {
                visit(Item::Frame(Frame { name, rotation: numbers.rows(), origin: numbers.take() }));
            }
            DrawnKind::SpatialJoint { name, kind, links } => {
                let (at, axis) = (numbers.take(), numbers.take());
                let kind =
                    SpatialJoint { kind: joint(*kind), axis, bodies: links.each_ref().map(Option::as_deref) };
                visit(Item::Joint { name, kind, at });
            }
            DrawnKind::Joint { .. } => {}
            in_both!() => {}
        }
    }

    fn vector(numbers: &mut Numbers<'_>) -> [f64; 3] {
        numbers.take()
    }

    fn moment(numbers: &mut Numbers<'_>) -> [f64; 3] {
        numbers.take()
    }
}

/// Defines a conversion between enumerations with the same variants.
macro_rules! same_variants {
    ($(#[doc = $doc:literal])* $visibility:vis $name:ident: $From:ident as $To:ident { $($Variant:ident),* }) => {
        $(#[doc = $doc])*
        $visibility fn $name(kind: $From) -> $To {
            match kind {
                $($From::$Variant => $To::$Variant,)*
            }
        }
    };
}

same_variants! {
    /// Converts the kind of a connector to that of scenes.
    pub connector: ConnectorKind as Connector { Spring, Damper, TorsionSpring, TorsionDamper }
}

same_variants! {
    origin: DeclaredOrigin as LoadOrigin { Applied, Gravity, Connector, Joint, Contact }
}

/// Defines the conversion of joints with coordinates from their rows.
macro_rules! mobilizer {
    ($(
        #[doc = $doc:literal]
        $Kind:ident $word:literal $coordinates:literal [$($motion:tt)*] $soft:ident: $form:literal;
    )*) => {
        same_variants! { mobilizer: MobilizerKind as SpatialJointKind { $($Kind),* } }
    };
}

mobilizers!(mobilizer);

fn joint(form: SpatialJointForm) -> SpatialJointKind {
    match form {
        SpatialJointForm::Pin => SpatialJointKind::Pin,
        SpatialJointForm::Mobilizer(kind) => mobilizer(kind),
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use lagrange_core::derive::StrategyChoice;
    use lagrange_core::pipeline::{NumericSystem, Programs, parse};
    use lagrange_runtime::scene::{Item, Outline, Plane, Solid, Spatial};

    use super::{NumberedSpace, Numbers, visit_item, visit_items};

    /// Every shape in space, with its solid.
    const SHAPES: [(&str, Solid<f64>); 11] = [
        ("point_mass()", Solid::PointMass),
        ("slender_rod(2)", Solid::SlenderRod(2.0)),
        ("solid_sphere(2)", Solid::Sphere(2.0)),
        ("thin_sphere(2)", Solid::Sphere(2.0)),
        ("ellipsoid(2, 3, 4)", Solid::Ellipsoid(2.0, 3.0, 4.0)),
        ("cuboid(2, 3, 4)", Solid::Cuboid(2.0, 3.0, 4.0)),
        ("disk(2)", Solid::Disk(2.0)),
        ("thin_ring(2)", Solid::Ring(2.0)),
        ("solid_cylinder(2, 3)", Solid::Cylinder(2.0, 3.0)),
        ("hollow_cylinder(2, 3, 4)", Solid::HollowCylinder(2.0, 3.0, 4.0)),
        ("cone(2, 3)", Solid::Cone(2.0, 3.0)),
    ];

    /// Every shape in the plane except polygons, with its outline.
    const OUTLINES: [(&str, Outline<f64>); 13] = [
        ("point_mass()", Outline::PointMass),
        ("slender_rod(2)", Outline::SlenderRod(2.0)),
        ("disk(2)", Outline::Disk(2.0)),
        ("hollow_cylinder(2, 3)", Outline::Annulus(2.0, 3.0)),
        ("thin_ring(2)", Outline::Ring(2.0)),
        ("rectangle(2, 3)", Outline::Rectangle(2.0, 3.0)),
        ("semicircular_disk(2)", Outline::SemicircularDisk(2.0)),
        ("circular_sector(2, 1)", Outline::CircularSector(2.0, 1.0)),
        ("right_triangle(2, 3)", Outline::RightTriangle(2.0, 3.0)),
        ("triangle(2, 3, 4)", Outline::Triangle(2.0, 3.0, 4.0)),
        ("ellipse(2, 3)", Outline::Ellipse(2.0, 3.0)),
        ("regular_polygon(5, 2)", Outline::RegularPolygon(5.0, 2.0)),
        ("polygon((0, 0), (2, 0), (0, 2))", Outline::Polygon(&[[0.0, 0.0], [2.0, 0.0], [0.0, 2.0]])),
    ];

    /// Visits the items of a declaration at a position, and checks that no number is left.
    fn items<D: NumberedSpace>(text: &str, visit: &mut dyn FnMut(Item<'_, f64, D>)) {
        let derived = parse(text).and_then(|system| system.derive(StrategyChoice::Cheapest));
        let programs = Programs::new(&derived.unwrap_or_else(|report| panic!("{text}: {report}")));
        let drawing = programs.drawing.clone().expect("a body is drawn");
        let system = NumericSystem::of(Arc::new(programs));
        let at = system.evaluate(&drawing.program, 0.0, &[0.5], &[0.0]);
        visit_items(&system, &drawing, (0.0, &[0.5], &[0.0]), visit);
        let mut numbers = Numbers(&at);
        drawing.items.iter().for_each(|item| visit_item::<D>(item, &mut numbers, &|_| f64::NAN, &mut |_| {}));
        assert!(numbers.0.is_empty(), "{text}: {:?}", numbers.0);
    }

    #[test]
    fn every_solid_takes_its_own_numbers() {
        for (shape, wanted) in SHAPES {
            let text = format!(
                "gravity = (0, 0, -1); body b {{ mass: 1; shape: {shape}; }} prismatic s = ground to b; emit {{ drawing }}"
            );
            let mut found = Vec::new();
            items::<Spatial>(&text, &mut |item| {
                if let Item::Body { parts, .. } = item {
                    found.extend(parts.iter().map(|part| part.shape));
                }
            });
            assert_eq!(found, [wanted], "{shape}");
        }
    }

    #[test]
    fn every_outline_takes_its_own_numbers() {
        for (shape, wanted) in OUTLINES {
            let text = format!(
                "coord x; body b {{ mass: 1; shape: {shape}; center: (x, 3); angle: 0.25; }} emit {{ drawing }}"
            );
            let mut found = 0;
            items::<Plane>(&text, &mut |item| {
                let Item::Body { name, motion, parts } = item else { return };
                assert_eq!((name, motion.center, motion.angle), ("b", [0.5, 3.0], 0.25));
                assert_eq!(parts.iter().map(|part| part.shape).collect::<Vec<_>>(), [wanted], "{shape}");
                found += 1;
            });
            assert_eq!(found, 1, "{shape}");
        }
    }
}
