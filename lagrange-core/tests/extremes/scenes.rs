//! Declarations at chosen extremes: every file `tests/extremes/NAME.csv` beside `NAME.lag`.

use std::path::{Path, PathBuf};
use std::{fs, iter};

use lagrange_core::model::Model;

use crate::digits::Arithmetic;
use crate::reference::{Reference, relative_error};
use crate::trial::{Errors, STRICT, Sample, Subject, WAYS, Way};

/// Tables give 20 digits.
const PRINTED: f64 = 1e-19;

/// A declaration with its table.
pub(crate) struct Scene {
    pub(crate) name: String,
    pub(crate) declaration: String,
    rows: Vec<Row>,
}

/// A row of a table: columns with their entries, without the empty ones.
struct Row {
    cells: Vec<(String, String)>,
}

/// Returns all scenes of points or in the plane, by name.
pub(crate) fn scenes() -> Vec<Scene> {
    scenes_in("")
}

/// Returns the scenes of a folder beside the tables.
pub(crate) fn scenes_in(folder: &str) -> Vec<Scene> {
    let directory = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../tests/extremes")).join(folder);
    let entries = fs::read_dir(directory).expect("the directory of scenes");
    let mut paths = entries.map(|entry| entry.expect("a readable entry").path()).collect::<Vec<_>>();
    paths.retain(|path| path.extension().is_some_and(|extension| extension == "lag"));
    paths.sort();
    assert!(!paths.is_empty());
    paths.iter().map(|path| Scene::read(path)).collect()
}

impl Scene {
    fn read(path: &Path) -> Scene {
        let text = |path: PathBuf| {
            fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
        };
        let table = text(path.with_extension("csv"));
        let mut lines = table.lines().map(|line| line.split(',').map(str::trim).collect::<Vec<_>>());
        let columns = lines.next().expect("names of columns");
        let rows = lines.map(|entries| {
            assert_eq!(entries.len(), columns.len(), "{}: {entries:?}", path.display());
            let cells = columns.iter().zip(entries).filter(|(_, entry)| !entry.is_empty());
            Row { cells: cells.map(|(column, entry)| ((*column).to_owned(), entry.to_owned())).collect() }
        });
        let name = path.file_stem().expect("a name").to_string_lossy().into_owned();
        Scene { name, declaration: text(path.to_owned()), rows: rows.collect() }
    }
}

/// Returns the column of a velocity: `dot x` for a coordinate, the name for an angular velocity.
fn speed(model: &Model, index: usize) -> String {
    let speed = &model.speeds[index];
    match speed.coordinate {
        Some(coordinate) if speed.name.ends_with("_dot") => {
            format!("dot {}", model.coordinates[coordinate].name)
        }
        _ => speed.name.clone(),
    }
}

/// Returns the column of an acceleration.
fn acceleration(model: &Model, index: usize) -> String {
    let speed = speed(model, index);
    if speed.starts_with("dot ") { format!("d{speed}") } else { format!("dot {speed}") }
}

impl Row {
    fn text(&self, column: &str) -> Option<&str> {
        self.cells.iter().find(|(known, _)| known == column).map(|(_, entry)| entry.as_str())
    }

    fn number(&self, column: &str) -> Option<f64> {
        self.text(column).map(|entry| entry.parse().unwrap_or_else(|_| panic!("{entry} in {column}")))
    }

    fn sample(&self, reference: &Reference) -> Sample {
        let model = &reference.model;
        let settings = model.parameters.iter().filter_map(|p| Some((p.name.clone(), self.number(&p.name)?)));
        let number = |column: String| self.number(&column).unwrap_or_else(|| panic!("no column {column}"));
        Sample {
            settings: settings.collect(),
            t: 0.0,
            q: model.coordinates.iter().map(|coordinate| number(coordinate.name.clone())).collect(),
            v: (0..model.speeds.len()).map(|i| number(speed(model, i))).collect(),
        }
    }

    /// True if a way keeps its bounds. Where a table has no bound, any error is allowed.
    fn allows(&self, way: Way, errors: &Errors) -> bool {
        let keeps = |column: &str, error: f64| self.number(column).is_none_or(|bound| error <= bound);
        let keeps_energy = way != STRICT || keeps("strict energy", errors.energy);
        keeps(way.name, errors.worst_component()) && keeps_energy
    }

    /// Returns the remark on the goal of a scene.
    fn remark(&self, way: Way, errors: &Errors) -> &'static str {
        let Some(goal) = self.number("goal").filter(|_| way == STRICT) else { return "" };
        let is_promised = ["strict", "strict energy"].iter().all(|column| self.number(column).is_some());
        match (errors.worst_component().max(errors.energy) <= goal, is_promised) {
            (false, _) => "  misses its goal",
            (true, false) => "  reaches its goal, which can be promised",
            (true, true) => "",
        }
    }
}

/// Prints the errors of every row, shown by `--nocapture`.
#[test]
fn accelerations_keep_their_digits_at_the_extremes() {
    let failures = scenes().iter().flat_map(Scene::judge).collect::<Vec<_>>();
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

impl Scene {
    /// Prints the errors of every row, and returns those that are too large.
    fn judge(&self) -> Vec<String> {
        println!("\n{}: cond M, cond of M with unit diagonal; magnification of rounded inputs;", self.name);
        println!("  along each way the relative error of every acceleration; of the energy");
        let reference = Reference::new(&self.declaration);
        let mut subjects = WAYS.map(|way| (way, Subject::new(&self.declaration, way)));
        let mut failures = Vec::new();
        for (number, row) in (1..).zip(&self.rows) {
            let sample = row.sample(&reference);
            let truth =
                reference.truth(&sample).unwrap_or_else(|| panic!("{} row {number} is singular", self.name));
            let [plain, scaled] = reference.conditions_at(&sample);
            print!(
                "{number:3} {plain:6.0e} {scaled:6.0e}; {}",
                listed(&reference.magnification(&sample, &truth).components)
            );
            for (way, subject) in &mut subjects {
                let errors = subject.errors(&sample, &truth);
                let remark = row.remark(*way, &errors);
                print!(
                    "\n      {:9} {}; {:.1e}{remark}",
                    way.name,
                    listed(&errors.components),
                    errors.energy
                );
                if !row.allows(*way, &errors) {
                    failures.push(format!("{} row {number}, {}: {errors:?}", self.name, way.name));
                }
            }
            println!();
        }
        failures
    }
}

fn listed(numbers: &[f64]) -> String {
    numbers.iter().map(|number| format!("{number:.1e}")).collect::<Vec<_>>().join(" ")
}

/// The printed numbers were computed elsewhere, with sixty digits.
#[test]
fn the_reference_gives_the_printed_accelerations() {
    let mut arithmetic = Arithmetic::new(256);
    let mut compared = 0;
    for scene in scenes().into_iter().chain(scenes_in("space")) {
        let reference = Reference::new(&scene.declaration);
        for row in &scene.rows {
            let model = &reference.model;
            let names = (0..model.speeds.len()).map(|i| acceleration(model, i));
            let printed = names.map(|name| row.text(&name)).collect::<Option<Vec<_>>>();
            let Some(printed) = printed else { continue };
            let truth = reference.truth(&row.sample(&reference)).expect("a regular state");
            for (printed, found) in iter::zip(printed, &truth.accelerations) {
                let error = relative_error(found, &arithmetic.decimal(printed));
                assert!(error <= PRINTED, "{}: {printed} is off by {error:e}", scene.name);
                compared += 1;
            }
        }
    }
    assert!(compared > 0, "some rows have printed accelerations");
}
