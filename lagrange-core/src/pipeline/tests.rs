use super::{Derived, parse};
use crate::mechanics::{Conserved, RoadChoice};

fn derived(text: &str) -> Derived {
    parse(text).expect("a correct declaration").derive(RoadChoice::Cheapest).expect("a regular system")
}

const SPRING_PENDULUM: &str = "
    param m, k, l0, g;
    coord r, theta;
    let position = (r * sin(theta), -r * cos(theta));
    kinetic = kinetic_energy(m, dot(position));
    potential = gravitational_energy(m, g, position.y) + spring_energy(k, r - l0);
";

#[test]
fn polar_coordinates_by_way_of_cartesian_ones_are_uncoupled() {
    assert!(derived(SPRING_PENDULUM).equations.structure.mass.is_diagonal());
}

#[test]
fn a_turn_about_the_vertical_is_cyclic_however_it_is_written() {
    let top = "
        param m, l, g;
        coord theta, phi;
        let position = (l * sin(theta) * cos(phi), l * sin(theta) * sin(phi), l * cos(theta));
        kinetic = kinetic_energy(m, dot(position));
        potential = m * g * position.z;
    ";
    let structure = derived(top).equations.structure;
    assert_eq!(structure.cyclic, [1]);
    assert_eq!(structure.conserved, [Conserved::Momentum(1), Conserved::Energy]);
}

#[test]
fn equations_read_like_those_of_a_textbook() {
    let mut derived = derived(SPRING_PENDULUM);
    let documentation = derived.documentation().join("\n");
    let line = "m*r^2*ddot(theta) = -2*m*r*dot(r)*dot(theta) - m*g*r*sin(theta)";
    assert!(documentation.contains(line), "{documentation}");
    let line = r"m r^{2} \ddot{\theta} = -2 m r \dot{r} \dot{\theta} - m g r \sin\left(\theta\right)";
    assert_eq!(derived.equations_latex().lines().nth(1), Some(line));
}
