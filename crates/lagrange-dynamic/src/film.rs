//! Films of motions of declared systems.

use std::borrow::Cow;
use std::marker::PhantomData;
use std::path::Path;

use lagrange_core::pipeline::DrawnScene;
use lagrange_draw::{DrawError, Drawing, DrawnSpace, Film, last_at_each};
use lagrange_runtime::scene::{Item, Scene, Spatial};
use lagrange_runtime::system::{Description, MechanicalSystem, OdeSystem, StepFailure, Unnamed};

use crate::declared::{DeclaredSystem, LARGEST};
use crate::inline::Inline;
use crate::items::{NumberedSpace, visit_evaluated};
use crate::system::DynamicSystem;

/// A film of a declared system, in the plane or in space.
#[derive(Clone, PartialEq, Debug)]
pub struct DeclaredFilm {
    kind: Kind,
    /// Indices of the displayed samples.
    shown: Vec<usize>,
}

#[derive(Clone, PartialEq, Debug)]
enum Kind {
    Plane(Film),
    Spatial(Box<Film<Spatial>>),
}

impl DeclaredFilm {
    /// Creates the film of a system at times, with a state `[q…, v…]` for each. If impacts leave
    /// several samples at one time, it shows the last one. With `has_forces` it shows the loads of
    /// [`Drawing::forces`], for constant inputs.
    ///
    /// # Errors
    /// If the system was read without its [drawing](crate::Source::system_with), or there is no
    /// film of its samples, as for [`Drawing::film_of`].
    ///
    /// # Panics
    /// If a state is longer or shorter than those of the system, or there are fewer than times.
    pub fn new<'s>(
        system: &DeclaredSystem,
        times: &[f64],
        states: impl IntoIterator<Item = &'s [f64]>,
        has_forces: bool,
    ) -> Result<DeclaredFilm, DrawError> {
        let Some(scene) = &system.programs().drawing else { return Err(DrawError::NothingToDraw) };
        let dynamic = system.dynamic::<LARGEST>();
        let states = states.into_iter().map(|state| dynamic.state(state)).collect::<Vec<_>>();
        let shown = last_at_each(times);
        let samples = shown.iter().map(|&index| (times[index], states[index]));
        let kind = match scene.is_in_space {
            true => Kind::Spatial(Box::new(filmed(&dynamic, scene, has_forces, samples)?)),
            false => Kind::Plane(filmed(&dynamic, scene, has_forces, samples)?),
        };
        Ok(DeclaredFilm { kind, shown })
    }

    /// Adds a curve to the plot below the picture of a page, with a value for each sample.
    ///
    /// # Errors
    /// If there are fewer values than samples.
    pub fn with_column(self, name: &str, values: &[f64]) -> Result<DeclaredFilm, DrawError> {
        let values = self.shown.iter().filter_map(|&index| values.get(index).copied()).collect();
        let kind = match self.kind {
            Kind::Plane(film) => Kind::Plane(film.with_values(name, values)?),
            Kind::Spatial(film) => Kind::Spatial(Box::new(film.with_values(name, values)?)),
        };
        Ok(DeclaredFilm { kind, ..self })
    }

    /// Returns the film as a self-contained [HTML page](Film::html).
    pub fn html(&self) -> String {
        match &self.kind {
            Kind::Plane(film) => film.html(),
            Kind::Spatial(film) => film.html(),
        }
    }

    /// Saves the film to a [file](Film::save), whose extension selects the format.
    ///
    /// # Errors
    /// If there is no such format of films in the plane or in space, or the file cannot be written.
    pub fn save(&self, path: &Path) -> Result<(), DrawError> {
        match &self.kind {
            Kind::Plane(film) => film.save(path),
            Kind::Spatial(film) => film.save(path),
        }
    }
}

fn filmed<D: NumberedSpace + DrawnSpace>(
    system: &DynamicSystem<LARGEST>,
    scene: &DrawnScene,
    has_forces: bool,
    samples: impl IntoIterator<Item = (f64, Inline<LARGEST>)>,
) -> Result<Film<D>, DrawError> {
    let drawn = Drawn { system: Cow::Borrowed(system), scene, space: PhantomData };
    let drawing = Drawing::of(&drawn).title(&title(&system.numeric.programs().name));
    if has_forces { drawing.forces() } else { drawing }.film_of(samples)
}

/// Returns the name of a struct as words: `Double pendulum` for `DoublePendulum`.
pub fn title(name: &str) -> String {
    let mut title = String::new();
    let mut was_lower = false;
    for letter in name.chars() {
        let begins = letter.is_uppercase() && was_lower;
        was_lower = letter.is_lowercase() || letter.is_ascii_digit();
        match begins {
            true => title.extend([' '].into_iter().chain(letter.to_lowercase())),
            false => title.push(if letter == '_' { ' ' } else { letter }),
        }
    }
    title
}

/// A system and its scene, in the plane or in space.
struct Drawn<'a, D> {
    system: Cow<'a, DynamicSystem<LARGEST>>,
    scene: &'a DrawnScene,
    space: PhantomData<D>,
}

impl<D> OdeSystem for Drawn<'_, D> {
    type Scalar = f64;
    type State = Inline<LARGEST>;

    fn rhs(&self, t: f64, y: &Inline<LARGEST>) -> Inline<LARGEST> {
        self.system.rhs(t, y)
    }

    fn begin(&self, t: f64, y: &Inline<LARGEST>) -> Result<Option<Self>, StepFailure<f64>> {
        if !self.system.is_touching() {
            return Ok(None);
        }
        let begun = self.system.begin(t, y)?;
        Ok(begun.map(|system| Drawn { system: Cow::Owned(system), ..*self }))
    }
}

impl<D> MechanicalSystem for Drawn<'_, D> {
    type Coordinates = Inline<LARGEST>;
    type Velocities = Inline<LARGEST>;
    type Columns<C> = Unnamed<C>;

    const COORDINATES: &'static [&'static str] = &[];

    fn description(&self) -> &'static Description {
        self.system.description()
    }

    fn acceleration(&self, t: f64, q: &Inline<LARGEST>, v: &Inline<LARGEST>) -> Inline<LARGEST> {
        self.system.acceleration(t, q, v)
    }

    fn position_rates(&self, t: f64, q: &Inline<LARGEST>, v: &Inline<LARGEST>) -> Inline<LARGEST> {
        self.system.position_rates(t, q, v)
    }

    fn displacement(&self, t: f64, from: &Inline<LARGEST>, to: &Inline<LARGEST>) -> Inline<LARGEST> {
        self.system.displacement(t, from, to)
    }
}

impl<D: NumberedSpace> Scene for Drawn<'_, D> {
    type Space = D;

    fn items(
        &self,
        t: f64,
        q: &Inline<LARGEST>,
        v: &Inline<LARGEST>,
        visit: &mut dyn FnMut(Item<'_, f64, D>),
    ) {
        let (q, v) = (q.as_ref(), v.as_ref());
        let numbers = self.system.evaluate_at(&self.scene.program, t, q, v);
        visit_evaluated(&self.system.numeric, self.scene, (t, q, v), &numbers, visit);
    }
}

#[cfg(test)]
mod tests {
    use lagrange_core::derive::StrategyChoice;
    use lagrange_core::pipeline::{Programs, parse};
    use lagrange_draw::DrawError;

    use super::{DeclaredFilm, title};
    use crate::declared::DeclaredSystem;

    #[test]
    fn titles_are_words() {
        assert_eq!(
            ["DoublePendulum", "four_bar", "Top2", "RLC"].map(title),
            ["Double pendulum", "four bar", "Top2", "RLC"]
        );
    }

    fn declared(text: &str) -> DeclaredSystem {
        let derived = parse(text).and_then(|system| system.derive(StrategyChoice::Cheapest));
        let programs = Programs::new(&derived.unwrap_or_else(|report| panic!("{report}")));
        DeclaredSystem::new(programs).expect("it can be run")
    }

    #[test]
    fn films_need_a_drawing_and_samples() {
        let body = "struct OneBody; coord x; body b { mass: 1; shape: disk(1); center: (x, 0); angle: x; }";
        let drawn = declared(&format!("{body} emit {{ drawing }}"));
        let states = [[0.0, 1.0], [1.0, 1.0], [2.0, 1.0]];
        let film = |system: &DeclaredSystem, count: usize| {
            DeclaredFilm::new(
                system,
                &[0.0, 1.0, 1.0][..count],
                states[..count].iter().map(|y| &y[..]),
                false,
            )
        };
        assert!(matches!(film(&declared(body), 3), Err(DrawError::NothingToDraw)));
        assert!(film(&drawn, 0).is_err());
        let whole = film(&drawn, 3).expect("two pictures");
        assert!(whole.html().contains("One body"));
        assert!(
            whole.clone().with_column("speed", &[1.0; 3]).is_ok_and(|film| film.html().contains("speed"))
        );
        assert!(whole.with_column("speed", &[1.0]).is_err());
    }
}
