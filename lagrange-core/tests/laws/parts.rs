//! Parts: the code equals that of a declaration in which each placed part is written by hand.

use std::fmt::Write as _;

use lagrange_core::derive::StrategyChoice;
use lagrange_core::diagnostics::Report;
use lagrange_core::expand::without_arrays;
use lagrange_core::pipeline::parse;
use lagrange_core::syntax::{parse_text, print};
use quote::quote;

use crate::random::Random;

/// A trunk with four legs on springy ground.
const QUADRUPED: &str = "
    param g = 9.81, mass = 12;
    gravity = (0, 0, -g);
    body trunk { mass: mass; shape: cuboid(0.6, 0.3, 0.15); }
    free trunk;
    part Leg(on, at, stiffness = 2e4) {
        param l = 0.25, thigh_mass = 1.2, shank_mass = 0.4;
        input moment[2];
        body thigh { mass: thigh_mass; shape: cuboid(0.03, 0.03, l); centroid: (0, 0, -l / 2); }
        body shank { mass: shank_mass; shape: cuboid(0.02, 0.02, l); centroid: (0, 0, -l / 2); }
        revolute hip = on to thigh { at: at; axis: (0, 1, 0); damping: 0.1; }
        revolute knee = thigh to shank { at: (0, 0, -l); axis: (0, 1, 0); damping: 0.1; }
        force hip = moment[0];
        force knee = moment[1];
        let foot = shank.point(0, 0, -l);
        force (0, 0, if foot.z < 0 { -stiffness * foot.z } else { 0 }) at foot;
        output height = foot.z;
    }
    leg[i in 0..4]: Leg {
        on: trunk;
        at: [(0.3, 0.15, 0), (0.3, -0.15, 0), (-0.3, 0.15, 0), (-0.3, -0.15, 0)];
    }
    output mean = sum(i in 0..4, leg[i].foot.z) / 4;
    emit { statements, no inverse_dynamics }";

/// Returns the same robot without parts.
fn quadruped_by_hand() -> String {
    let mut text = "param g = 9.81, mass = 12; gravity = (0, 0, -g);
        body trunk { mass: mass; shape: cuboid(0.6, 0.3, 0.15); } free trunk;"
        .to_owned();
    let corners = ["(0.3, 0.15, 0)", "(0.3, -0.15, 0)", "(-0.3, 0.15, 0)", "(-0.3, -0.15, 0)"];
    for (i, at) in corners.iter().enumerate() {
        let leg = "
            param L_l = 0.25, L_thigh_mass = 1.2, L_shank_mass = 0.4;
            input L_moment[2];
            body L_thigh { mass: L_thigh_mass; shape: cuboid(0.03, 0.03, L_l); centroid: (0, 0, -L_l / 2); }
            body L_shank { mass: L_shank_mass; shape: cuboid(0.02, 0.02, L_l); centroid: (0, 0, -L_l / 2); }
            revolute L_hip = trunk to L_thigh { at: AT; axis: (0, 1, 0); damping: 0.1; }
            revolute L_knee = L_thigh to L_shank { at: (0, 0, -L_l); axis: (0, 1, 0); damping: 0.1; }
            force L_hip = L_moment[0];
            force L_knee = L_moment[1];
            let L_foot = L_shank.point(0, 0, -L_l);
            force (0, 0, if L_foot.z < 0 { -2e4 * L_foot.z } else { 0 }) at L_foot;
            output L_height = L_foot.z;";
        text.push_str(&leg.replace("L_", &format!("leg_{i}_")).replace("AT", at));
    }
    text + "output mean = (leg_0_foot.z + leg_1_foot.z + leg_2_foot.z + leg_3_foot.z) / 4;
        emit { statements, no inverse_dynamics }"
}

/// Boxes whose corners touch the ground.
const BOXES: &str = "
    gravity = (0, -9.81);
    part Box(at, w = 0.4) {
        coord x, y, phi;
        body case { mass: 1; shape: rectangle(w, 0.3); center: (x + at, y); angle: phi; }
        contact foot = case on ground { friction: 0.3; }
        output load = foot[0].normal + foot[3].normal;
    }
    chest[i in 0..2]: Box { at: i; }";

/// Returns the same boxes without parts.
fn boxes_by_hand() -> String {
    let mut text = "gravity = (0, -9.81);".to_owned();
    for i in 0..2 {
        let case = "
            coord B_x, B_y, B_phi;
            body B_case { mass: 1; shape: rectangle(0.4, 0.3); center: (B_x + AT, B_y); angle: B_phi; }
            contact B_foot = B_case on ground { friction: 0.3; }
            output B_load = B_foot[0].normal + B_foot[3].normal;";
        text.push_str(&case.replace("B_", &format!("chest_{i}_")).replace("AT", &i.to_string()));
    }
    text
}

#[test]
fn corners_in_parts_touch_as_those_written_by_hand() {
    let (composed, flat) = (format!("struct S; {BOXES}"), format!("struct S; {}", boxes_by_hand()));
    assert_eq!(emitted(&composed), emitted(&flat));
}

/// Returns the code emitted for a correct text if members are named as in the expanded text.
fn emitted(text: &str) -> String {
    let derived = parse(text).and_then(|mut system| {
        system.declaration.arrays.clear();
        system.declaration.placed.clear();
        system.derive(StrategyChoice::Cheapest)
    });
    let tokens = derived.and_then(|derived| derived.emit(&quote!(::lagrange)));
    tokens.unwrap_or_else(|report| panic!("{text}\n{report}")).to_string()
}

/// Returns the statements without parts as text.
fn written_out(text: &str) -> String {
    let mut report = Report::default();
    let declaration = parse_text(text, &mut report).expect("tokens");
    let printed = print::statements(&declaration);
    let again = parse_text(&printed, &mut report).expect("tokens");
    assert_eq!(print::statements(&again), printed, "{text}");
    let written_out = print::statements(&without_arrays(declaration, &mut report));
    assert!(!report.has_errors(), "{text}\n{report}");
    written_out
}

#[test]
fn a_quadruped_of_one_leg_has_the_code_of_one_with_four() {
    let by_hand = quadruped_by_hand();
    assert_eq!(emitted(QUADRUPED), emitted(&by_hand));
    // The plain statements declare the same system.
    let statements = parse(QUADRUPED).expect("a correct declaration").statements();
    assert_eq!(statements, parse(&by_hand).expect("a correct declaration").statements());
    assert_eq!(statements, parse(&statements).expect("a correct declaration").statements());
}

/// A part of a random declaration.
#[derive(Default)]
struct RandomPart {
    /// Names of arguments, with their defaults.
    arguments: Vec<(String, Option<Text>)>,
    items: Vec<Item>,
    /// Numbers in it, by their names outside.
    numbers: Vec<String>,
}

/// A text with names in it.
type Text = Vec<Piece>;

enum Piece {
    Text(String),
    Name(String),
}

enum Item {
    Statement(Text),
    /// A part by its number, under a name, with the number of elements and the arguments, one list
    /// for each element.
    Place {
        name: String,
        part: usize,
        count: Option<usize>,
        arguments: Vec<(String, Vec<Text>)>,
    },
}

fn text(text: impl Into<String>) -> Piece {
    Piece::Text(text.into())
}

fn name(name: impl Into<String>) -> Piece {
    Piece::Name(name.into())
}

/// Returns a sum of products of these names and numbers.
fn sum(names: &[String], random: &mut Random) -> Text {
    let mut sum = vec![text(format!("{}", random.below(9)))];
    for _ in 0..random.below(3) {
        if !names.is_empty() {
            sum.extend([text(format!(" - {} * ", random.below(9))), name(random.choice(names).clone())]);
        }
    }
    sum
}

/// Returns parts that place earlier parts; the last one is the declaration itself.
fn random_parts(random: &mut Random) -> Vec<RandomPart> {
    let mut parts: Vec<RandomPart> = Vec::new();
    let count = 2 + random.below(3);
    for number in 0..count {
        let part = random_part(&parts, number + 1 == count, random);
        parts.push(part);
    }
    parts
}

fn random_part(before: &[RandomPart], is_whole: bool, random: &mut Random) -> RandomPart {
    let mut part = RandomPart::default();
    let mut known = Vec::new();
    for i in 0..if is_whole { 0 } else { random.below(4) } {
        let default = (random.below(2) == 0).then(|| sum(&known, random));
        part.arguments.push((format!("a{i}"), default));
        known.push(format!("a{i}"));
    }
    let mut items = vec!["coord"];
    items.extend(
        (0..1 + random.below(5))
            .map(|_| *random.choice(&["param", "array", "let", "potential", "place", "place"])),
    );
    for (i, kind) in items.into_iter().enumerate() {
        let mut declared = Vec::new();
        match kind {
            "coord" | "param" => {
                let own = format!("{}{i}", &kind[..1]);
                part.items.push(Item::Statement(vec![text(format!("{kind} ")), name(own.clone())]));
                declared.push(own);
            }
            "array" => {
                let own = format!("k{i}");
                part.items.push(Item::Statement(vec![text("param "), name(own.clone()), text("[2]")]));
                declared.extend([format!("{own}[0]"), format!("{own}[1]")]);
            }
            "let" => {
                let own = format!("l{i}");
                let mut definition = vec![text("let "), name(own.clone()), text(" = ")];
                definition.extend(sum(&known, random));
                part.items.push(Item::Statement(definition));
                declared.push(own);
            }
            "place" if !before.is_empty() => declared = place(&mut part, before, &known, i, random),
            _ => {}
        }
        known.extend(declared.iter().cloned());
        part.numbers.extend(declared);
    }
    let mut potential = vec![text("potential = (")];
    potential.extend(sum(&known, random));
    potential.push(text(")^2"));
    let kinetic = vec![text("kinetic = dot("), name("c0"), text(")^2")];
    part.items.extend([Item::Statement(kinetic), Item::Statement(potential)]);
    part
}

/// Places a part, and returns the numbers in it.
fn place(
    part: &mut RandomPart,
    before: &[RandomPart],
    known: &[String],
    i: usize,
    random: &mut Random,
) -> Vec<String> {
    let placed = random.below(before.len());
    let count = (random.below(2) == 0).then(|| 1 + random.below(3));
    let mut arguments = Vec::new();
    for (argument, default) in &before[placed].arguments {
        if default.is_none() || random.below(2) == 0 {
            let values = if random.below(2) == 0 { count.unwrap_or(1) } else { 1 };
            arguments.push((argument.clone(), (0..values).map(|_| sum(known, random)).collect()));
        }
    }
    let own = format!("p{i}");
    let elements = match count {
        None => vec![own.clone()],
        Some(count) => (0..count).map(|element| format!("{own}[{element}]")).collect(),
    };
    part.items.push(Item::Place { name: own, part: placed, count, arguments });
    let numbers = &before[placed].numbers;
    elements
        .iter()
        .flat_map(|element| numbers.iter().map(move |number| format!("{element}.{number}")))
        .collect()
}

fn as_written(piece: &Piece) -> &str {
    match piece {
        Piece::Text(text) | Piece::Name(text) => text,
    }
}

fn composed_text(pieces: &Text) -> String {
    pieces.iter().map(as_written).collect()
}

/// Returns the declaration of parts.
fn composed(parts: &[RandomPart]) -> String {
    let mut out = String::new();
    for (number, part) in parts.iter().enumerate() {
        let is_whole = number + 1 == parts.len();
        if !is_whole {
            let arguments = part.arguments.iter().map(|(name, default)| match default {
                None => name.clone(),
                Some(default) => format!("{name} = {}", composed_text(default)),
            });
            write!(out, "part P{number}({}) {{", arguments.collect::<Vec<_>>().join(", ")).expect("a string");
        }
        for item in &part.items {
            out.push_str(&composed_item(item));
        }
        out.push_str(if is_whole { "" } else { "}\n" });
    }
    out
}

fn composed_item(item: &Item) -> String {
    match item {
        Item::Statement(pieces) => composed_text(pieces) + "; ",
        Item::Place { name, part, count, arguments } => {
            let range = count.map_or(String::new(), |count| format!("[i in 0..{count}]"));
            let arguments = arguments.iter().map(|(name, values)| match (&values[..], count) {
                ([value], None) => format!("{name}: {};", composed_text(value)),
                ([value], Some(1)) => format!("{name}: [{}];", composed_text(value)),
                ([value], _) => format!("{name}: {};", composed_text(value)),
                (values, _) => {
                    let list = values.iter().map(composed_text).collect::<Vec<_>>();
                    format!("{name}: [{}];", list.join(", "))
                }
            });
            format!("{name}{range}: P{part} {{ {} }} ", arguments.collect::<Vec<_>>().join(" "))
        }
    }
}

/// Values of arguments by name, written by hand.
type Values = Vec<(String, String)>;

/// Returns a text with the names used when everything is written by hand.
fn flat_text(pieces: &Text, prefix: &str, values: &Values) -> String {
    let flat = pieces.iter().map(|piece| match piece {
        Piece::Text(text) => text.clone(),
        Piece::Name(path) => match values.iter().find(|(name, _)| name == path) {
            Some((_, value)) => format!("({value})"),
            None => {
                // Indices of parts become part of the name; those of an array stay.
                let (around, own) =
                    path.rsplit_once('.').map_or((String::new(), &path[..]), |(around, own)| {
                        (around.replace(['[', '.'], "_").replace(']', "") + "_", own)
                    });
                format!("{prefix}{around}{own}")
            }
        },
    });
    flat.collect()
}

/// Returns the statements of a part, written by hand.
fn flat(parts: &[RandomPart], number: usize, prefix: &str, values: &Values, out: &mut String) {
    for item in &parts[number].items {
        match item {
            Item::Statement(pieces) => *out += &(flat_text(pieces, prefix, values) + "; "),
            Item::Place { name, part, count, arguments } => {
                for element in 0..count.unwrap_or(1) {
                    let index = count.map_or(String::new(), |_| format!("_{element}"));
                    let mut given: Values = Vec::new();
                    for (argument, default) in &parts[*part].arguments {
                        let value = arguments.iter().find(|(name, _)| name == argument);
                        let value = match (value, default) {
                            (Some((_, list)), _) => {
                                flat_text(&list[element.min(list.len() - 1)], prefix, values)
                            }
                            (None, Some(default)) => flat_text(default, "", &given),
                            (None, None) => panic!("an argument is missing"),
                        };
                        given.push((argument.clone(), value));
                    }
                    flat(parts, *part, &format!("{prefix}{name}{index}_"), &given, out);
                }
            }
        }
    }
}

#[test]
fn random_parts_are_what_they_are_by_hand() {
    let mut placed = 0;
    for case in 0..400 {
        let parts = random_parts(&mut Random::of_case(case));
        let (composed, mut by_hand) = (composed(&parts), String::new());
        flat(&parts, parts.len() - 1, "", &Vec::new(), &mut by_hand);
        assert_eq!(written_out(&composed), written_out(&by_hand), "case {case}: {composed}\n{by_hand}");
        placed += composed.matches(": P").count();
        if case % 40 == 0 {
            assert_eq!(emitted(&composed), emitted(&by_hand), "case {case}: {composed}");
        }
    }
    assert!(placed > 400, "{placed}");
}
