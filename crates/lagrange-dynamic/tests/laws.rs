//! Programs with one wrong sign or one missing term break a law.

use lagrange::laws;
use lagrange::system::{MechanicalSystem, StateVector};
use lagrange_core::derive::StrategyChoice;
use lagrange_core::pipeline::{Programs, parse};
use lagrange_core::program::{Builder, Op, Program, ValueId};
use lagrange_dynamic::{DeclaredSystem, DynamicSystem, Visitor};

/// Systems of every kind whose laws are checked.
const SYSTEMS: [&str; 6] = [
    "param m = 3, p = 0.4, l = 0.6, g = 9.81, c = 0.3; coord x, theta; input u = 2;
     kinetic = 1/2*m*dot(x)^2 + kinetic_energy(p, dot((x + l*sin(theta) + sin(3*t), -l*cos(theta))));
     potential = -p*g*l*cos(theta); dissipation = 1/2*c*dot(theta)^2; force x = u - 0.5*dot(x);",
    "param m = 1, l = 1, g = 9.81; coord a, b, c; let p = (l*sin(a), -l*cos(a));
     let q = p + (l*sin(b), -l*cos(b)); let r = q + (l*sin(c), -l*cos(c));
     kinetic = kinetic_energy(m, dot(p)) + kinetic_energy(m, dot(q)) + kinetic_energy(m, dot(r));
     potential = m*g*(p.y + q.y + r.y);",
    "param m = 0.7, r = 1.2, k = 30; coord x = 1.2, y; kinetic = kinetic_energy(m, dot((x, y)));
     potential = m*9.81*y + 1/2*k*max(0, x - 0.5)^2; constraint ring = x^2 + y^2 - r^2;",
    "param m = 0.5, l = 0.3, a = 0.02, b = 0.03, c = 0.01, g = 9.81; gravity = (0, 0, -g);
     body rotor { mass: m; centroid: (0, 0, l); inertia: (a, b, c); }
     ball tip = ground to rotor { damping: 0.02; } state i = 1;
     force tip_wz = 0.3*i; dot(i) = 5 - 2*i - 0.3*tip_wz;",
    "param m = 2, b = 3; coord x, y;
     lagrangian = 1/2*m*(dot(x)^2 + dot(y)^2) + b/2*(x*dot(y) - y*dot(x)) - 1/4*x^4;",
    "param M = 2; coord r = 1.5, phi; kinetic = 1/2*(dot(r)^2 + r^2*dot(phi)^2); potential = -M/r;",
];

fn programs(text: &str) -> Programs {
    let jacobian = if text.contains("constraint") { "" } else { ", jacobian" };
    let system =
        parse(&format!("{text} emit {{ tests{jacobian} }}")).unwrap_or_else(|report| panic!("{report}"));
    Programs::new(&system.derive(StrategyChoice::Cheapest).unwrap_or_else(|report| panic!("{report}")))
}

/// The verdict on a system, `None` if all laws hold.
struct Verdict(Option<Vec<f64>>);

impl Visitor for Verdict {
    type Output = Option<String>;

    fn visit<const CAPACITY: usize>(self, system: &DynamicSystem<CAPACITY>) -> Option<String> {
        let positions = system.description().coordinates.len();
        let velocities = system.description().velocities.len();
        let velocities = if velocities == 0 { positions } else { velocities };
        let start = self.0.unwrap_or_else(|| vec![0.0; positions + velocities]);
        let (positions, velocities) = start.split_at(positions);
        let start = StateVector::joined(positions, velocities);
        laws::verify(system, &start).err().map(|broken| broken.to_string())
    }
}

fn verdict(programs: Programs) -> Option<String> {
    let system = DeclaredSystem::new(programs).unwrap_or_else(|refusal| panic!("{refusal}"));
    let start = system.start();
    system.visit(Verdict(start))
}

/// Returns operations with one wrong sign or one missing term that can replace another.
fn mutations(op: &Op) -> Vec<Mutant> {
    let instead = |op| Mutant::Op(op);
    match *op {
        Op::Add(a, b) => vec![instead(Op::Subtract(a, b)), Mutant::Operand(a), Mutant::Operand(b)],
        Op::Subtract(a, b) => vec![instead(Op::Add(a, b)), Mutant::Operand(a)],
        Op::Negate(a) => vec![Mutant::Operand(a)],
        Op::MultiplyAdd(a, b, c) => vec![
            instead(Op::MultiplySubtract(a, b, c)),
            instead(Op::SubtractProduct(a, b, c)),
            Mutant::Operand(c),
            instead(Op::Multiply(a, b)),
        ],
        Op::MultiplySubtract(a, b, c) => vec![instead(Op::MultiplyAdd(a, b, c)), instead(Op::Multiply(a, b))],
        Op::SubtractProduct(a, b, c) => vec![instead(Op::MultiplyAdd(a, b, c)), Mutant::Operand(c)],
        _ => Vec::new(),
    }
}

#[derive(Debug)]
enum Mutant {
    Op(Op),
    Operand(ValueId),
}

/// Returns the program with a mutant in place of one of its operations.
fn mutated(program: &Program, place: ValueId, mutant: &Mutant) -> Program {
    let mut builder = Builder::new();
    let mut new: Vec<(ValueId, ValueId)> = Vec::new();
    for (id, op) in program.values() {
        let at = |old: ValueId| new.iter().find(|(known, _)| *known == old).expect("an earlier value").1;
        let value = match mutant {
            Mutant::Operand(operand) if id == place => at(*operand),
            Mutant::Op(op) if id == place => builder.push(op.map_operands(at)),
            _ => builder.push(op.map_operands(at)),
        };
        new.push((id, value));
    }
    let at = |old: &ValueId| new.iter().find(|(known, _)| known == old).expect("a value").1;
    builder.finish(&program.outputs().iter().map(at).collect::<Vec<_>>())
}

/// Returns the programs that laws concern, for replacement.
fn tested(programs: &mut Programs) -> Vec<(String, &mut Program)> {
    let Programs { accelerations, products, jacobian, .. } = programs;
    let products = products
        .iter_mut()
        .filter(|(product, _)| ["energy", "lagrangian", "generalised_forces"].contains(&product.name()));
    let products = products.map(|(product, program)| (product.name().to_owned(), program));
    let jacobian = jacobian.iter_mut().map(|program| ("jacobian".to_owned(), program));
    std::iter::once(("accelerations".to_owned(), accelerations)).chain(products).chain(jacobian).collect()
}

#[test]
fn systems_keep_their_laws() {
    for text in SYSTEMS {
        assert_eq!(verdict(programs(text)), None, "{text}");
    }
}

#[test]
fn wrong_signs_and_missing_terms_break_laws() {
    let (mut count, mut survivors) = (0, Vec::new());
    for text in SYSTEMS {
        let whole = programs(text);
        let mut copy = whole.clone();
        for (index, (name, program)) in tested(&mut copy).into_iter().enumerate() {
            for (place, op) in program.values() {
                for mutant in mutations(op) {
                    let mut changed = whole.clone();
                    *tested(&mut changed)[index].1 = mutated(program, place, &mutant);
                    count += 1;
                    if verdict(changed).is_none() {
                        survivors.push(format!("{name} of {}…: {mutant:?} for {op:?}", &text[..30]));
                    }
                }
            }
        }
    }
    println!("{} of {count} survive:\n{}", survivors.len(), survivors.join("\n"));
    assert!(count >= 200, "{count}");
    assert!(
        50 * survivors.len() <= count,
        "{} of {count} survive:\n{}",
        survivors.len(),
        survivors.join("\n")
    );
}
