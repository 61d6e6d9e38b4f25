//! Drawings of the random trees: joints are in their places, and all forces and moments are shown.

use lagrange_core::bodies::{DrawnKind, SpatialJointForm};
use lagrange_core::derive::StrategyChoice;
use lagrange_core::expr::ExprId;
use lagrange_core::expr::evaluate;
use lagrange_core::pipeline::{Derived, NumericSystem, parse};
use lagrange_core::symbol::Role;
use lagrange_core::syntax::ast::MobilizerKind;

use crate::cases::{Case, State, cases};

type Vector = [f64; 3];

/// Relative error of sums of loads where the equations are well conditioned.
const TOLERANCE: f64 = 1e-10;
/// Additional error per unit of the condition number.
const ROUNDING: f64 = 1e-14;

/// Larger trees take most of the time and contain nothing new.
const MAX_VELOCITIES: usize = 7;

/// Returns every tree of moderate size whose number is a multiple of this one.
fn trees(step: usize) -> impl Iterator<Item = Case> {
    let is_small = |tree: &Case| tree.states[0].numbers("v").len() <= MAX_VELOCITIES;
    cases("trees.txt").into_iter().filter(is_small).step_by(step)
}

/// A tree at one of its states.
struct Scene<'a> {
    derived: &'a Derived,
    t: f64,
    q: &'a [f64],
    v: &'a [f64],
    a: Vec<f64>,
    multipliers: Vec<f64>,
    parameters: [Vec<f64>; 2],
}

fn derived(tree: &Case) -> Derived {
    let text = format!("{} emit {{ drawing, frames, frame_jacobians }}", tree.text);
    let derived = parse(&text).and_then(|system| system.derive(StrategyChoice::Cheapest));
    derived.unwrap_or_else(|report| panic!("{text}\n{report}"))
}

impl<'a> Scene<'a> {
    fn new(derived: &'a Derived, state: &'a State) -> Scene<'a> {
        let numeric = NumericSystem::new(derived);
        let t = state.number("state").expect("a time");
        let [q, v] = ["q", "v"].map(|word| state.numbers(word));
        let (a, multipliers) = (numeric.acceleration(t, q, v), numeric.multipliers(t, q, v));
        let model = &derived.model;
        let number = |default: ExprId| evaluate(&model.graph, &[default], |_| f64::NAN)[0];
        let parameters = [&model.parameters, &model.inputs]
            .map(|list| list.iter().map(|one| number(one.default.expect("a number"))).collect());
        Scene { derived, t, q, v, a, multipliers, parameters }
    }

    fn values(&self, roots: &[ExprId]) -> Vec<f64> {
        evaluate(&self.derived.model.graph, roots, |role| match role {
            Role::Time => self.t,
            Role::Parameter(i) => self.parameters[0][i as usize],
            Role::Input(i) => self.parameters[1][i as usize],
            Role::Coordinate(i) => self.q[i as usize],
            Role::Velocity(i) => self.v[i as usize],
            Role::Acceleration(i) => self.a[i as usize],
            Role::Multiplier(i) => self.multipliers[i as usize],
            other => panic!("{other:?}"),
        })
    }

    /// Returns the axes of a link in rows of coordinates, and its origin. The ground has those of
    /// the world.
    fn frame(&self, name: Option<&str>) -> ([Vector; 3], Vector) {
        let Some(name) = name else {
            return ([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], [0.0; 3]);
        };
        let frames = &self.derived.model.scene.frames;
        let frame = frames.iter().find(|frame| frame.name.text == name).expect("a frame");
        let values = self.values(&frame.values);
        ([0, 1, 2].map(|row| vector(&values, 3 * row)), vector(&values, 9))
    }

    /// Returns the origins of all links, and their motion.
    fn links(&self) -> Vec<Link<'_>> {
        let (twists, n) = (&self.derived.model.scene.twists, self.v.len());
        let moved = |values: Vec<f64>| {
            let column = |j| [0, 3].map(|first| [0, 1, 2].map(|row| values[(first + row) * n + j]));
            (0..n).map(column).collect::<Vec<_>>()
        };
        let links = twists.iter().zip(&self.derived.equations.frame_jacobians);
        let link = links.map(|(twist, jacobian)| {
            let name = twist.name.text.as_str();
            Link { name, origin: self.frame(Some(name)).1, moved_by: moved(self.values(jacobian)) }
        });
        link.collect()
    }
}

/// A body or frame.
struct Link<'a> {
    name: &'a str,
    origin: Vector,
    /// Angular velocity, and velocity of the origin, for each velocity of the tree.
    moved_by: Vec<[Vector; 2]>,
}

fn vector(values: &[f64], first: usize) -> Vector {
    [values[first], values[first + 1], values[first + 2]]
}

fn minus(a: Vector, b: Vector) -> Vector {
    [0, 1, 2].map(|i| a[i] - b[i])
}

fn plus(a: Vector, b: Vector) -> Vector {
    [0, 1, 2].map(|i| a[i] + b[i])
}

fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn size(a: Vector) -> f64 {
    dot(a, a).sqrt()
}

/// Returns Aᵀ a: the components of a vector in axes that are the columns of A.
fn own(axes: [Vector; 3], a: Vector) -> Vector {
    [0, 1, 2].map(|column| (0..3).map(|row| axes[row][column] * a[row]).sum())
}

/// A joint with the links that it connects.
struct Joint<'a> {
    name: &'a str,
    form: SpatialJointForm,
    at: Vector,
    axis: Vector,
    links: [Option<&'a str>; 2],
}

fn joints<'a>(scene: &Scene<'a>) -> Vec<Joint<'a>> {
    let joint = |item: &'a lagrange_core::model::DrawnItem| {
        let DrawnKind::SpatialJoint { name, kind, links } = &item.kind else { return None };
        let values = scene.values(&item.values);
        let links = links.each_ref().map(Option::as_deref);
        let (at, axis) = (vector(&values, 0), vector(&values, 3));
        Some(Joint { name, form: *kind, at, axis, links })
    };
    scene.derived.model.scene.drawing.iter().filter_map(joint).collect()
}

/// Returns the distance of the moving link from its allowed positions.
fn gap_of(scene: &Scene<'_>, joint: &Joint<'_>) -> f64 {
    let (_, origin) = scene.frame(joint.links[1]);
    let moved = minus(origin, joint.at);
    let SpatialJointForm::Mobilizer(kind) = joint.form else { return 0.0 };
    match kind {
        MobilizerKind::Revolute | MobilizerKind::Universal | MobilizerKind::Ball | MobilizerKind::Weld => {
            size(moved)
        }
        MobilizerKind::Prismatic | MobilizerKind::Cylindrical | MobilizerKind::Screw => {
            size(cross(joint.axis, moved))
        }
        MobilizerKind::Planar => dot(joint.axis, moved).abs(),
        MobilizerKind::Free => size(joint.at),
    }
}

/// True if the axis is at rest in the moving link.
fn keeps_axis(form: SpatialJointForm) -> bool {
    use MobilizerKind::{Ball, Free, Universal};
    !matches!(form, SpatialJointForm::Pin | SpatialJointForm::Mobilizer(Ball | Free | Universal))
}

#[test]
fn joints_are_where_both_sides_say() {
    let (mut seen, mut pins) = (0, 0);
    for tree in trees(3) {
        let derived = derived(&tree);
        let scenes = tree.states.iter().take(3).map(|state| Scene::new(&derived, state)).collect::<Vec<_>>();
        let joints = scenes.iter().map(joints).collect::<Vec<_>>();
        for (index, first) in joints[0].iter().enumerate() {
            let what = format!("{}: {}", tree.name, first.name);
            let mut at_first = [[f64::NAN; 3]; 3];
            for (number, (scene, joints)) in scenes.iter().zip(&joints).enumerate() {
                let joint = &joints[index];
                assert!((size(joint.axis) - 1.0).abs() < 1e-12, "{what}: {:?}", joint.axis);
                assert!(gap_of(scene, joint) < 1e-12, "{what}: {}", gap_of(scene, joint));
                let [(carrier, origin), (placed, _)] = joint.links.map(|link| scene.frame(link));
                let now = [
                    own(carrier, minus(joint.at, origin)),
                    own(carrier, joint.axis),
                    own(placed, joint.axis),
                ];
                if joint.form == SpatialJointForm::Pin {
                    pins += 1;
                    continue;
                }
                if number == 0 {
                    at_first = now;
                }
                let kept = if keeps_axis(joint.form) { 3 } else { 2 };
                for (before, now) in at_first.iter().zip(now).take(kept) {
                    assert!(size(minus(*before, now)) < 1e-12, "{what}: {before:?} and then {now:?}");
                }
                seen += 1;
            }
        }
    }
    assert!(seen > 200 && pins > 5, "{seen} joints and {pins} pins");
}

/// Returns the virtual power of all forces and moments for each velocity, and the magnitude of its
/// summands. The total vanishes, since they do no work on motions that the joints allow.
///
/// Source: Jourdain's principle, in Roberson, Schwertassek, *Dynamics of Multibody Systems*, §6.1.
fn powers(scene: &Scene<'_>) -> Vec<[f64; 2]> {
    let mut powers = vec![[0.0; 2]; scene.v.len()];
    let links = scene.links();
    let mut add = |name: &str, at: Vector, force: Vector, moment: Vector| {
        let link = links.iter().find(|link| link.name == name).expect("a link");
        for (power, &[spin, velocity]) in powers.iter_mut().zip(&link.moved_by) {
            let moved = plus(velocity, cross(spin, minus(at, link.origin)));
            power[0] += dot(force, moved) + dot(moment, spin);
            power[1] += size(force) * size(moved) + size(moment) * size(spin);
        }
    };
    for item in &scene.derived.model.scene.drawing {
        let values = scene.values(&item.values);
        match &item.kind {
            DrawnKind::Force { body: Some(body), .. } => {
                add(body, vector(&values, 0), vector(&values, 3), [0.0; 3]);
            }
            DrawnKind::Moment { body: Some(body), .. } => {
                add(body, vector(&values, 0), [0.0; 3], vector(&values, 3));
            }
            _ => {}
        }
    }
    for motion in &scene.derived.model.scene.motions {
        let values = scene.values(&motion.values);
        let inertia = [1, 4, 7].map(|row| vector(&values, row));
        let rotation = [16, 19, 22].map(|row| vector(&values, row));
        let [spin, acceleration, change] = [28, 31, 34].map(|first| vector(&values, first));
        let [spin, change] = [spin, change].map(|world| own(rotation, world));
        let times = |a: Vector| inertia.map(|row| dot(row, a));
        let rate = plus(times(change), cross(spin, times(spin)));
        let force = acceleration.map(|component| -values[0] * component);
        let moment = rotation.map(|row| -dot(row, rate));
        add(&motion.body.text, vector(&values, 13), force, moment);
    }
    powers
}

/// True if some force or moment has no place in the picture.
fn is_incomplete(tree: &Case, derived: &Derived) -> bool {
    let items = &derived.model.scene.drawing;
    let is_hidden =
        |kind: &DrawnKind| matches!(kind, DrawnKind::Omitted { .. } | DrawnKind::Force { body: None, .. });
    ["potential", "constraint", "kinetic", "dissipation"].iter().any(|word| tree.text.contains(word))
        || items.iter().any(|item| is_hidden(&item.kind))
}

#[test]
fn drawn_loads_move_the_trees() {
    let mut complete = 0;
    for tree in trees(2) {
        let derived = derived(&tree);
        if is_incomplete(&tree, &derived) {
            continue;
        }
        complete += 1;
        for (index, state) in tree.states.iter().take(2).enumerate() {
            let scene = Scene::new(&derived, state);
            let condition = state.number("condition").unwrap_or(1.0);
            for [sum, size] in powers(&scene) {
                let bound = (TOLERANCE + ROUNDING * condition) * (1.0 + size);
                assert!(sum.abs() <= bound, "{}, state {index}: {sum} of {size}\n{}", tree.name, tree.text);
            }
        }
    }
    assert!(complete > 50, "{complete} trees");
}
