//! Every Rust block of the book, compiled and run as a documentation test of its page. Pages that
//! write files do so in the folder of this crate.

macro_rules! pages {
    ($($name:ident = $path:literal;)*) => {
        $(
            #[cfg(doctest)]
            #[doc = include_str!(concat!("../../../docs/", $path))]
            struct $name;
        )*
    };
}

pages! {
    FromDrake = "coming_from/drake.md";
    FromHeyoka = "coming_from/heyoka.md";
    FromSimscape = "coming_from/simscape.md";
    FromSideBySide = "coming_from/side_by_side.md";
    FromSymPy = "coming_from/sympy.md";
    Choosing = "choosing.md";
    Cluster = "cluster.md";
    ComputedTorque = "cookbook/computed_torque.md";
    Contacts = "contacts.md";
    Ensemble = "cookbook/ensemble.md";
    Ensembles = "ensembles.md";
    Expand = "cookbook/expand.md";
    Feedback = "cookbook/feedback.md";
    FirstFilm = "first_film.md";
    Game = "cookbook/game.md";
    Identification = "identification.md";
    Introduction = "README.md";
    Kinematics = "cookbook/kinematics.md";
    Kernel = "cookbook/kernel.md";
    Laws = "cookbook/laws.md";
    Linear = "linear.md";
    Loops = "cookbook/loops.md";
    Lqr = "cookbook/lqr.md";
    Models = "models.md";
    NoStd = "cookbook/no_std.md";
    Noise = "cookbook/noise.md";
    Orbits = "cookbook/orbits.md";
    Pictures = "cookbook/pictures.md";
    Quadruped = "cookbook/quadruped.md";
    Road = "cookbook/road.md";
    Robot = "cookbook/robot.md";
    Sampled = "cookbook/sampled.md";
    Delay = "cookbook/delay.md";
    Sensitivities = "sensitivities.md";
    States = "cookbook/states.md";
    SwingUp = "cookbook/swing_up.md";
    Touching = "cookbook/contacts.md";
    Wrong = "wrong.md";
}

#[cfg(test)]
mod tests {
    use lagrange_import::urdf::{Options, import};

    /// Recipes include the output of commands.
    #[test]
    fn files_beside_the_pages_are_those_of_the_pages() {
        let block = |page: &str, language: &str| {
            let (_, rest) = page.split_once(&format!("```{language}\n")).expect("a block");
            rest.split_once("```").expect("its end").0.to_owned()
        };
        let robot = block(include_str!("../../../docs/cookbook/robot.md"), "xml");
        let options = Options { has_inputs: true, ..Options::default() };
        let imported = import(&robot, &options).expect("a robot");
        assert_eq!(imported.declaration, include_str!("two_link.rs"));
        let road = block(include_str!("../../../docs/cookbook/road.md"), "text");
        assert_eq!(road, include_str!("../road.csv"));
    }
}
