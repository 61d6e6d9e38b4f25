use crate::derive::StrategyChoice;
use crate::pipeline::{NumericSystem, parse};

#[test]
fn explore() {
    let texts = [
        "param m = 1, l = 1, g = 9.81; coord theta, phi; let x = l * sin(theta) * cos(phi); let y = l * sin(theta) * sin(phi); let z = -l * cos(theta);
         kinetic = kinetic_energy(m, dot((x, y, z))); potential = m * g * z; output bob = (x, y, z); output ax = ddot(x); emit { conserved, jacobian } reduce R { ignore phi; }",
        "param a = 1, c = 1, w = 1; coord theta, phi, psi;
         kinetic = 1/2 * a * (dot(theta)^2 + sin(theta)^2 * dot(phi)^2) + 1/2 * c * (dot(psi) + dot(phi) * cos(theta))^2; potential = w * cos(theta);
         reduce R { ignore phi, psi; } reduce One { ignore psi; } reduce Steady { ignore phi, psi; small theta = 1/2; }",
        "param mc = 1, mp = 0.1, l = 0.5, g = 9.81, w = 2; coord x, theta, y; input u;
         let (px, py) = (x + l * sin(theta), -l * cos(theta));
         kinetic = kinetic_energy(mc, dot(x)) + kinetic_energy(mp, dot((px, py))) + 1/2*mc*dot(y)^2 + w * y * dot(x) ; potential = mp * g * py; force theta = u * dot(x); 
         reduce R { ignore x; } reduce F { freeze y = 1; ignore x; }",
    ];
    for text in texts {
        let mut derived = parse(text).unwrap_or_else(|e| panic!("{e}")).derive(StrategyChoice::Cheapest).unwrap_or_else(|e| panic!("{e}"));
        for part in &mut derived.reduced {
            println!("{}", crate::emit::documentation(&mut part.reduced.model, &part.equations).join("\n"));
            let numeric = NumericSystem::of_part(part);
            println!("{:?}", numeric.programs().defaults);
        }
        println!("{}", derived.emit(&quote::quote!(::lagrange)).unwrap().to_string().len());
    }
    panic!();
}
