//! Systems whose units are known.

use lagrange_core::model::{Availability, Extent, Product};

/// A declaration, with the powers of mass and length in the units of its parameters, coordinates
/// and constraints.
#[derive(Debug)]
pub(super) struct Subject {
    pub(super) name: String,
    pub(super) declaration: String,
    /// Parameters and inputs, each with the powers of mass and length in its unit.
    pub(super) parameters: Vec<(String, [i32; 2])>,
    /// The power of length in the unit of each coordinate, and of its speed.
    pub(super) coordinates: Vec<i32>,
    /// The power of length in the unit of each constraint.
    pub(super) constraints: Vec<i32>,
    /// Largest distance of states from zero. Constraints that become dependent in one configuration
    /// have solutions only near it.
    pub(super) spread: f64,
}

const MASS: [i32; 2] = [1, 0];
const LENGTH: [i32; 2] = [0, 1];
const INERTIA: [i32; 2] = [1, 2];
const FORCE: [i32; 2] = [1, 1];
const NONE: [i32; 2] = [0, 0];

impl Subject {
    /// Reads units from the list of names before each `:`, such as `m1 m2: mass; l g: length`.
    fn new(name: &str, declaration: &str, units: &str, coordinates: &[i32], constraints: &[i32]) -> Subject {
        let parameters = units.split(';').filter(|group| !group.trim().is_empty()).flat_map(|group| {
            let (names, unit) = group.split_once(':').unwrap_or_else(|| panic!("{name}: {group}"));
            let unit = match unit.trim() {
                "mass" => MASS,
                "length" => LENGTH,
                "inertia" => INERTIA,
                "force" => FORCE,
                "none" => NONE,
                other => panic!("{name}: {other}"),
            };
            names.split_whitespace().map(move |name| (name.to_owned(), unit)).collect::<Vec<_>>()
        });
        Subject {
            name: name.to_owned(),
            declaration: declaration.to_owned(),
            parameters: parameters.collect(),
            coordinates: coordinates.to_vec(),
            constraints: constraints.to_vec(),
            spread: 1.0,
        }
    }

    fn at_rest(self) -> Subject {
        Subject { spread: 0.0, ..self }
    }
}

macro_rules! extreme {
    ($name:literal) => {
        include_str!(concat!("../../../../tests/extremes/", $name, ".lag"))
    };
}

macro_rules! constrained {
    ($name:literal) => {
        include_str!(concat!("../../../../tests/constrained/", $name, ".lag"))
    };
}

/// Returns systems without constraints.
pub(super) fn free() -> Vec<Subject> {
    let three = "m1 m2 m3: mass; l1 l2 l3 g: length";
    vec![
        Subject::new(
            "double pendulum",
            extreme!("double_pendulum"),
            "m1 m2: mass; l1 l2 g: length",
            &[0, 0],
            &[],
        ),
        Subject::new("triple pendulum", extreme!("triple_pendulum"), three, &[0; 3], &[]),
        Subject::new("branching tree", extreme!("branching_tree"), three, &[0; 3], &[]),
        Subject::new("relative pendulum", extreme!("relative_pendulum"), three, &[0; 3], &[]),
        Subject::new(
            "written-out pendulum",
            extreme!("written_out_pendulum"),
            "m1 m2: mass; l1 l2 g: length",
            &[0, 0],
            &[],
        ),
        Subject::new(
            "two-link arm",
            extreme!("two_link_arm"),
            "m1 m2: mass; j1 j2: inertia; l1 c1 c2 g: length",
            &[0, 0],
            &[],
        ),
        Subject::new("cart-pole", extreme!("cart_pole"), "mc mp: mass; l g: length", &[1, 0], &[]),
        Subject::new("spring pendulum", extreme!("spring_pendulum"), "m k: mass; l0 g: length", &[1, 0], &[]),
        Subject::new("rolling ball", extreme!("rolling_ball"), "m mc: mass; r R g: length", &[0, 0], &[]),
        Subject::new(
            "spherical pendulum",
            extreme!("spherical_pendulum"),
            "m: mass; l g: length",
            &[0, 0],
            &[],
        ),
        Subject::new(
            "arm in space",
            extreme!("space/arm"),
            "m1 m2 m3 m4: mass; l1 l2 l3 l4 g: length",
            &[0; 4],
            &[],
        ),
        Subject::new("universal joint and hinge", extreme!("space/universal_arm"), three, &[0; 4], &[]),
        Subject::new(
            "coupled line",
            "param a = 3, b = 1; coord x, y;
            kinetic = 1/2*a*dot(x)^2 + 1/2*a*dot(y)^2 + 0.2*b*dot(x)*dot(y); potential = a*(y^2 + x^2);",
            "a b: mass",
            &[1, 1],
            &[],
        ),
        Subject::new("chain of five", CHAIN, "j: inertia", &[0; 5], &[]),
        Subject::new("damped oscillators", OSCILLATORS, "m0 m1 m2 k c: mass; f push: force", &[1, 1, 1], &[]),
        Subject::new(
            "Lagrangian without a sure sign",
            "param m = 1, l = 1; coord x, y;
            lagrangian = m * (1/2 * sin(x / l) * dot(x)^2 + dot(x) * dot(y)) - m * (x^2 + x * y);",
            "m: mass; l: length",
            &[1, 1],
            &[],
        ),
    ]
}

/// Returns systems with independent constraints.
pub(super) fn constrained() -> Vec<Subject> {
    vec![
        Subject::new("ladder", constrained!("ladder_on_wall"), "m: mass; l g: length", &[1, 1, 0], &[1, 1]),
        Subject::new(
            "cylinder on a slope",
            constrained!("cylinder_on_slope"),
            "m: mass; r: length; alpha: none; g: length",
            &[1, 1, 0],
            &[1, 1],
        ),
        Subject::new(
            "Chaplygin's sleigh",
            constrained!("chaplygin_sleigh"),
            "m: mass; j: inertia; a: length",
            &[1, 1, 0],
            &[1],
        ),
        Subject::new(
            "Andrews' squeezer",
            constrained!("andrews_squeezer"),
            "m1 m2 m3 m4 m5 m6 m7: mass; i1 i2 i3 i4 i5 i6 i7: inertia; xa ya xb yb xc yc: length; c0: mass;
            l0 d da e ea rr ra ss sa sb sc sd ta tb u ua ub zf zt fa: length; drive: inertia",
            &[0; 7],
            &[1; 6],
        ),
        Subject::new(
            "bob on a rod",
            "param m = 1, l = 1, g = 9.81; coord x, y;
            kinetic = 1/2 * m * (dot(x)^2 + dot(y)^2); potential = m * g * y;
            stabilise = 3; constraint rod = hypot(x, y) - l;",
            "m: mass; l g: length",
            &[1, 1],
            &[1],
        ),
        Subject::new(
            "bob on a rod by squares",
            "param m = 1, l = 1, g = 9.81; coord x, y;
            kinetic = 1/2 * m * (dot(x)^2 + dot(y)^2); potential = m * g * y;
            constraint rod = x^2 + y^2 - l^2;",
            "m: mass; l g: length",
            &[1, 1],
            &[2],
        ),
        Subject::new(
            "a length and an angle held",
            "param m = 1, n = 1, l = 1, g = 9.81; coord x, y, a;
            kinetic = 1/2 * m * (dot(x)^2 + dot(y)^2) + 1/2 * n * l^2 * dot(a)^2; potential = m * g * y + m * l * g * sin(a);
            constraint turn = a - 2 * x / l; constraint square = x * y - l^2 * cos(a);",
            "m n: mass; l g: length",
            &[1, 1, 0],
            &[0, 2],
        ),
        Subject::new("three rods, pinned", &rods(3, ""), "m: mass; l g: length", &[1, 1, 0].repeat(3), &[1; 6]),
    ]
}

/// Returns systems with dependent constraints, in all configurations or in one.
pub(super) fn dependent() -> Vec<Subject> {
    let plain = |kinetic: &str| {
        format!(
            "param m = 1, c = 0.5; coord s, x, y; kinetic = m * ({kinetic}); potential = m * (s^2 + s * x - x^2);
            constraint first = (s + x) * cos(c); constraint second = (s + x) * sin(c);"
        )
    };
    vec![
        Subject::new(
            "one direction, held twice",
            &plain("1/2 * (dot(s)^2 + dot(x)^2 + dot(y)^2)"),
            "m: mass; c: none",
            &[1; 3],
            &[1; 2],
        ),
        Subject::new(
            "one direction without inertia, held twice",
            &plain("1/2 * (dot(x)^2 + dot(y)^2)"),
            "m: mass; c: none",
            &[1; 3],
            &[1; 2],
        ),
        Subject::new(
            "an angle without inertia, held twice",
            "param m = 1, l = 1, c = 0.5; coord a, x; kinetic = 1/2 * m * dot(x)^2; potential = m * l * x;
            constraint first = (l * a - x) * cos(c); constraint second = (x - l * a) * sin(c);
            constraint third = (l * a - x) * cos(3 * c);",
            "m: mass; l: length; c: none",
            &[0, 1],
            &[1; 3],
        ),
        Subject::new("table", TABLE, "m: mass; l g: length", &[1, 0, 0], &[1; 4]),
        Subject::new("dead point", DEAD_POINT, "m: mass; l g: length", &[0, 0], &[1, 1]).at_rest(),
        Subject::new(
            "three rods, pinned twice",
            &rods(
                3,
                "param c = 0.5; constraint again = (x1 - l/2 * sin(a1)) * cos(c);
                constraint sum = (x1 - l/2 * sin(a1) + y1 + l/2 * cos(a1)) * sin(c);",
            ),
            "m: mass; l g: length; c: none",
            &[1, 1, 0].repeat(3),
            &[1; 8],
        ),
        Subject::new(
            "joint in space with the same axis twice",
            "param m = 1, l = 1, g = 9.81, c = 0.5; gravity = (0, 0, -g);
            body a { mass: m; inertia: (m*l^2, m*l^2, m*l^2); } body b { mass: m; inertia: (m*l^2, m*l^2, m*l^2); }
            prismatic s = ground to a { axis: (c, c^2, sin(c)); } prismatic r = a to b { axis: (c, c^2, sin(c)); }
            pin b.center to (0, 0, 0);",
            "m: mass; l g: length; c: none",
            &[1, 1],
            &[1; 3],
        ),
    ]
}

/// A table on four legs at (±l, ±l).
const TABLE: &str = "param m = 1, l = 1, g = 9.81; coord z, a, b;
    kinetic = 1/2 * m * (dot(z)^2 + l^2 * (dot(a)^2 + dot(b)^2) / 3); potential = m * g * (z + l / 2 * b);
    constraint one = z + l * a - l * b; constraint two = z + l * a + l * b;
    constraint three = z - l * a - l * b; constraint four = z - l * a + l * b;";

/// Two aligned rods whose end is held. Across their line the constraint depends on one angle only
/// through its square.
const DEAD_POINT: &str = "param m = 1, l = 1, g = 9.81; coord a, b;
    let (x, y) = (l * sin(a) + l * sin(b), -l * cos(a) - l * cos(b));
    kinetic = 1/2 * m * l^2 * (dot(a)^2 + dot(b)^2); potential = m * g * y + m * g * l * a;
    constraint across = x; constraint along = y + 2 * l;";

/// Three oscillators in one line; the inertia of one of them couples all.
const OSCILLATORS: &str = "param m0 = 1, m1 = 2, m2 = 3, k = 5, c = 0.3, f = 2; input push = 1.5; coord x[3];
    kinetic = kinetic_energy(m0, dot(x[0])) + kinetic_energy(m1, dot(x[1])) + kinetic_energy(m2, dot(x[2]));
    kinetic = 1/2 * m0 * (dot(x[0]) + dot(x[1]) / 3 + dot(x[2]))^2;
    potential = spring_energy(k, x[0] - x[1]) + spring_energy(k, x[1] - x[2]);
    dissipation = 1/2 * c * (dot(x[1]) - dot(x[2]))^2; force x[0] = push + f;";

/// Five rods, each affected by all that it carries.
const CHAIN: &str = "param j = 1; coord x0, x1, x2, x3, x4;
    kinetic = 1/2*5*j*dot(x0)^2 + 1/2*4*j*dot(x1)^2 + 1/2*3*j*dot(x2)^2 + 1/2*2*j*dot(x3)^2 + 1/2*1*j*dot(x4)^2
        + 4*j*cos(x0-x1)*dot(x0)*dot(x1) + 3*j*cos(x0-x2)*dot(x0)*dot(x2) + 2*j*cos(x0-x3)*dot(x0)*dot(x3)
        + 1*j*cos(x0-x4)*dot(x0)*dot(x4) + 3*j*cos(x1-x2)*dot(x1)*dot(x2) + 2*j*cos(x1-x3)*dot(x1)*dot(x3)
        + 1*j*cos(x1-x4)*dot(x1)*dot(x4) + 2*j*cos(x2-x3)*dot(x2)*dot(x3) + 1*j*cos(x2-x4)*dot(x2)*dot(x4)
        + 1*j*cos(x3-x4)*dot(x3)*dot(x4);
    potential = 0 - 5*j*9.81*cos(x0) - 4*j*9.81*cos(x1) - 3*j*9.81*cos(x2) - 2*j*9.81*cos(x3) - 1*j*9.81*cos(x4);";

/// Returns rods hung from each other in maximal coordinates, with two constraints for each joint.
fn rods(n: usize, more: &str) -> String {
    let mut text = "param m = 1, l = 1, g = 9.81; let (ex0, ey0) = (0 * l, 0 * l);\n".to_owned();
    for k in 1..=n {
        let before = k - 1;
        text += &format!(
            "coord x{k}, y{k}, a{k};
            kinetic = kinetic_energy(m, dot(x{k})) + kinetic_energy(m, dot(y{k})) + kinetic_energy(m * l^2 / 12, dot(a{k}));
            potential = m * g * y{k};
            let (ex{k}, ey{k}) = (x{k} + l/2 * sin(a{k}), y{k} - l/2 * cos(a{k}));
            constraint jx{k} = x{k} - l/2 * sin(a{k}) - ex{before};
            constraint jy{k} = y{k} + l/2 * cos(a{k}) - ey{before};\n"
        );
    }
    text + more
}

impl Subject {
    /// True if the system has a product.
    pub(super) fn has(&self, product: Product) -> bool {
        if product == Product::InverseMassMatrix && self.name.contains("without inertia") {
            return false;
        }
        match product.row().when {
            Availability::Constraints => !self.constraints.is_empty(),
            Availability::SeparateEnergies => !self.declaration.contains("lagrangian"),
            _ => true,
        }
    }

    /// Returns the powers of mass and length in the units of a vector's entries.
    pub(super) fn units(&self, extent: Extent) -> Vec<[i32; 2]> {
        let lengths = |powers: &[i32]| powers.iter().map(|power| [0, *power]).collect::<Vec<_>>();
        match extent {
            Extent::Velocities => lengths(&self.coordinates),
            Extent::State | Extent::Tangent | Extent::LinearColumns => lengths(&self.coordinates.repeat(2)),
            Extent::LinearRows => [self.units(Extent::Tangent), self.units(Extent::Constraints)].concat(),
            Extent::Constraints => lengths(&self.constraints),
            Extent::Fields => self.parameters.iter().map(|(_, unit)| *unit).collect(),
            // The derivation chooses the columns, no subject has events, and few have bodies.
            Extent::Regressed | Extent::Events | Extent::StateAndTime | Extent::Axes | Extent::Motions => {
                Vec::new()
            }
        }
    }

    /// Returns the units of forces on entries with these lengths, which are energies over lengths.
    fn forces(lengths: &[i32]) -> Vec<[i32; 2]> {
        lengths.iter().map(|length| [1, 2 - length]).collect()
    }

    /// Returns the units of multipliers.
    pub(super) fn multipliers(&self) -> Vec<[i32; 2]> {
        Subject::forces(&self.constraints)
    }

    /// Returns the units of a product's entries.
    pub(super) fn units_of(&self, product: Product) -> Vec<[i32; 2]> {
        let slopes = |rows: Vec<[i32; 2]>, columns: Vec<[i32; 2]>| {
            let row =
                |row: [i32; 2]| columns.iter().map(move |column| [row[0] - column[0], row[1] - column[1]]);
            rows.into_iter().flat_map(row).collect()
        };
        let forces = Subject::forces(&self.coordinates);
        match product {
            Product::KineticEnergy | Product::PotentialEnergy | Product::Energy => vec![INERTIA],
            Product::Constraints | Product::ConstraintVelocity => self.units(Extent::Constraints),
            Product::ConstraintJacobian => {
                slopes(self.units(Extent::Constraints), self.units(Extent::Velocities))
            }
            Product::MassMatrix | Product::CoriolisMatrix => slopes(forces, self.units(Extent::Velocities)),
            Product::InverseMassMatrix => slopes(self.units(Extent::Velocities), forces),
            Product::InverseDynamicsJacobian => slopes(forces, self.units(Extent::Tangent)),
            Product::Jacobian => slopes(self.units(Extent::Velocities), self.units(Extent::State)),
            Product::TangentJacobian => slopes(self.units(Extent::Velocities), self.units(Extent::Tangent)),
            Product::ParameterJacobian => slopes(self.units(Extent::Velocities), self.units(Extent::Fields)),
            _ => forces,
        }
    }
}
