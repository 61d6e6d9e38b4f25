//! Accelerations of imported robots equal those that Pinocchio computes from the same file.

use lagrange_import::urdf::{Import, Options};

use crate::files::{imported, read};
use crate::reference::{derive, largest_difference, states};

const TOLERANCE: f64 = 1e-11;

/// `every_joint.urdf` as imported.
mod compiled {
    include!("../data/every_joint.rs");
}

fn assert_agreement(imported: &Import, reference: &str, file: &str) {
    let derived = derive(imported).unwrap_or_else(|report| panic!("{file}: {report}"));
    let difference = largest_difference(imported, &derived, reference);
    let difference = difference.unwrap_or_else(|how| panic!("{file}: {how}"));
    println!("{file}: {difference:.1e}");
    assert!(difference < TOLERANCE, "{file}: {difference:.1e}");
}

#[test]
fn every_type_of_joint_moves_as_pinocchio_says() {
    let file = "every_joint.urdf";
    assert_agreement(&imported(file, &Options::default()), &read("every_joint.txt"), file);
}

#[test]
fn imported_code_compiles_and_moves_as_in_pinocchio() {
    let imported = imported("every_joint.urdf", &Options::default());
    let machine = compiled::OddMachine2;
    for [q, v, expected] in states(&imported, &read("every_joint.txt")).expect("the same joints") {
        let (q, v) = (q.try_into().expect("all positions"), v.try_into().expect("all velocities"));
        let found = machine.acceleration(0.0, &q, &v);
        let size = expected.iter().fold(1.0_f64, |size, value| size.max(value.abs()));
        let are_close = found.iter().zip(&expected).all(|(a, b)| (a - b).abs() < TOLERANCE * size);
        assert!(are_close && found.len() == expected.len(), "{found:?} {expected:?}");
    }
}

#[test]
fn a_tree_of_thirty_links_moves_as_pinocchio_says() {
    let imported = imported("tree_of_30.urdf", &Options::default());
    assert_agreement(&imported, &read("tree_of_30.txt"), "tree_of_30.urdf");
}

#[test]
fn a_tree_on_a_free_base_moves_as_pinocchio_says() {
    let options = Options { is_free: true, ..Options::default() };
    assert_agreement(&imported("tree_of_5.urdf", &options), &read("tree_of_5_free.txt"), "tree_of_5.urdf");
}

#[test]
fn planes_across_any_axis_move_as_prismatic_and_revolute_joints_do() {
    let reference = read("tilted_plane.txt");
    let by_hand = imported("tilted_plane_by_hand.urdf", &Options::default());
    assert_agreement(&by_hand, &reference, "tilted_plane_by_hand.urdf");
    let planar = imported("tilted_plane.urdf", &Options::default());
    assert_agreement(&planar, &joined(&reference), "tilted_plane.urdf");
}

/// Returns a line for each planar joint, made of those for the three joints in its place.
fn joined(reference: &str) -> String {
    let mut lines = Vec::new();
    let parts = reference.lines().filter(|line| !line.starts_with(['#'])).collect::<Vec<_>>();
    for state in parts.split(|line| *line == "state").skip(1) {
        lines.push("state".to_owned());
        for three in state.chunks(3) {
            let columns = three.iter().map(|line| line.split('\t').collect::<Vec<_>>()).collect::<Vec<_>>();
            let name = columns[0][0].trim_end_matches("_x");
            let numbers =
                [1, 2, 3].map(|column| columns.iter().map(|row| row[column]).collect::<Vec<_>>().join(" "));
            lines.push(format!("{name}\t{}", numbers.join("\t")));
        }
    }
    lines.join("\n") + "\n"
}
