//! Motions of compiled text have the bits of interpreted text, including all interruptions.

use std::iter;

use lagrange_core::derive::StrategyChoice;
use lagrange_core::pipeline::{Programs, parse};
use lagrange_dynamic::{DeclaredSystem, DynamicSystem, MethodChoice, RunSettings, Visitor};
use lagrange_jit::Compiler;

/// Constraints, impacts with outputs, switches, modes with clocks, an unknown with a table, a body
/// in space with its quaternion.
const SYSTEMS: [&str; 6] = [
    "param g = 9.81; coord x = 1, y; kinetic = 1/2 * (dot(x)^2 + dot(y)^2); potential = g * y;
     constraint length = hypot(x, y) - 1; output tension = length; emit { jacobian }",
    "param e = 0.8; coord h = 2; kinetic = 1/2 * dot(h)^2; potential = 10 * h;
     event floor = h, falling => { dot(h) = -e * dot(h); } event low = dot(h) + 6, falling => stop;
     output height = h + ddot(h);",
    "coord x = 1; kinetic = 1/2 * dot(x)^2; potential = 2 * x^2; force x = -0.3 * sign(dot(x)) - max(x, 0.2);",
    "coord x; state warm = 20; discrete held = 0; mode heater = off | on; kinetic = 1/2 * dot(x)^2;
     force x = held; dot(warm) = 0.1 * (5 - warm) + if heater == on { 3 } else { 0 };
     event cold = warm - 19.8, falling => { heater = on; } event hot = warm - 20.2, rising => { heater = off; }
     every 0.1 => { held = warm - 20 - x - dot(x); }",
    "coord x = 0.3; table push(s) = [(-2, -1), (0, 0), (2, 3)], interpolation: natural, outside: extend; solve y: 0 = y + 0.1 * sin(y) - x;
     kinetic = 1/2 * dot(x)^2; force x = -push(x) - y;",
    "gravity = (0, 0, -9.81); body rotor { mass: 0.5; centroid: (0, 0, 0.3); inertia: (0.02, 0.03, 0.01); }
     ball tip = ground to rotor { damping: 0.02; }",
];

/// Columns and events of a motion, with all digits.
struct Run(RunSettings);

impl Visitor for Run {
    type Output = String;

    fn visit<const CAPACITY: usize>(self, system: &DynamicSystem<CAPACITY>) -> String {
        let motion = self.0.run(system).expect("a motion");
        let mut csv = Vec::new();
        motion.write_csv(&mut csv).expect("memory");
        let events = motion.events().iter().map(|event| format!("{} {:?}\n", event.name, event.time));
        let events = events.collect::<String>();
        String::from_utf8(csv).expect("text") + &events + &format!("{:?}", motion.work())
    }
}

fn settings(system: &DeclaredSystem, method: MethodChoice) -> RunSettings {
    let start = system.start().unwrap_or_else(|| vec![1.0, 0.0, 0.0, 0.0, 0.1, 3.0, 0.2]);
    RunSettings { start, from: 0.0, until: 2.0, every: Some(0.1), method, has_energy: false }
}

#[test]
fn motions_have_the_bits_of_interpreted_text() {
    let compiler = Compiler::for_this_processor().expect("a known processor");
    for text in SYSTEMS {
        let text = format!("{text} emit {{ taylor }}");
        let derived = parse(&text).and_then(|system| system.derive(StrategyChoice::Cheapest));
        let programs = Programs::new(&derived.unwrap_or_else(|report| panic!("{text}: {report}")));
        let interpreted = DeclaredSystem::new(programs).unwrap_or_else(|refusal| panic!("{refusal}"));
        let compiled = interpreted.clone().compiled_by(compiler.clone());
        let adaptive = MethodChoice::Verner { tolerance: 1e-9 };
        let others = [
            MethodChoice::Taylor { tolerance: 1e-10 },
            MethodChoice::Radau { tolerance: 1e-7 },
            MethodChoice::RungeKutta4 { step: 0.01 },
        ];
        for method in iter::once(adaptive).chain(others) {
            let run = |system: &DeclaredSystem| system.visit(Run(settings(system, method)));
            let (found, wanted) = (run(&compiled), run(&interpreted));
            assert!(wanted.lines().count() > 10, "{text}: {wanted}");
            assert_eq!(found, wanted, "{text}");
        }
    }
}
