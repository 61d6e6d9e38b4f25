//! Written forms of each statement.

use super::scenes;

/// The form of the statement that begins with a keyword.
pub(in crate::syntax) fn form(keyword: &str) -> &'static str {
    match keyword {
        "param" => "write `param m = 1.0, l;`",
        "const" => "write `const k = 1/2;`",
        "coord" => "write `coord x, theta;`",
        "input" => "write `input u;`",
        "let" => "write `let name = e;`, or `let (a, b) = (e, f);` for the components of a vector",
        "kinetic" => "write `kinetic = e;`",
        "potential" => "write `potential = e;`",
        "lagrangian" => "write `lagrangian = e;`",
        "gibbs" => super::GIBBS_HELP,
        "dissipation" => "write `dissipation = e;`, the Rayleigh function",
        "force" => super::FORCE_HELP,
        "torque" => super::TORQUE_HELP,
        "constraint" => "write `constraint name = e;`, with what is to be zero behind the name",
        "stabilise" => "write `stabilise = rate;`",
        "event" => super::EVENT_HELP,
        "friction" => super::FRICTION_HELP,
        "output" => "write `output name = e;`",
        "emit" => super::EMIT_HELP,
        "reduce" => super::REDUCTION_HELP,
        "gravity" => "write `gravity = (0, -g);`",
        "body" => scenes::BODY_HELP,
        "line" => scenes::LINE_HELP,
        "spring" => scenes::SPRING_HELP,
        "damper" => scenes::DAMPER_HELP,
        "torsion_spring" => scenes::TORSION_SPRING_HELP,
        "torsion_damper" => scenes::TORSION_DAMPER_HELP,
        "pin" => scenes::PIN_HELP,
        "slide" => scenes::SLIDE_HELP,
        "roll" => scenes::ROLL_HELP,
        _ => "statements are listed in the documentation of `lagrange::system!`",
    }
}

/// Behind the words of others: which statement they mean.
pub(in crate::syntax) fn meant_form(keyword: &str) -> String {
    format!("`{keyword}` is meant: {}", form(keyword))
}
