//! Films of simulated motions.

use lagrange::Simulate;
use lagrange::draw::{Drawing, Film};
use lagrange::simulate::Trajectory;

use crate::scenes::{LADDER, Puppet};

/// The ladder's angle decreases from 1 at a rate of 1.
const START: [f64; 2] = [1.0, -1.0];

fn run(duration: f64) -> Trajectory<Puppet> {
    let angle = |_: &Puppet, _: f64, y: &[f64; 2]| y[0];
    LADDER
        .simulate(START)
        .until(duration)
        .every(0.04)
        .observe("energy", angle)
        .dense()
        .run()
        .expect("is simple")
}

fn values(film: &Film, name: &str) -> Vec<f64> {
    let html = film.html();
    let (_, json) = html.split_once("type=\"application/json\">").expect("has data");
    let (json, _) = json.split_once("</script>").expect("ends");
    let data: serde_json::Value = serde_json::from_str(json).expect("is JSON");
    let curves = data["curves"].as_array().expect("has curves");
    let curve = curves.iter().find(|curve| curve["name"] == name).expect("is plotted");
    curve["values"].as_array().expect("has values").iter().filter_map(serde_json::Value::as_f64).collect()
}

#[test]
fn show_each_sample_at_its_time() {
    let run = run(0.5);
    let film = Drawing::of(&LADDER).film(&run).expect("can be drawn");
    assert_eq!(film.times(), run.times());
    assert_eq!(film.pictures().len(), 14, "0.5 s are 12 intervals and a half");
    let last = Drawing::of(&LADDER).past(run.iter().take(13)).picture(run.end_time(), &run.last());
    assert_eq!(film.pictures()[13], last.expect("can be drawn"));
    let (plotted, observed) = (values(&film, "energy"), run.column("energy").expect("is observed"));
    assert_eq!(plotted.len(), observed.len(), "is taken along");
    assert!(plotted.iter().zip(observed).all(|(plotted, observed)| (plotted - observed).abs() < 1e-15));
}

#[test]
fn show_as_many_pictures_a_second_as_fit_evenly() {
    let film = Drawing::of(&LADDER).film_at(30.0, &run(0.51)).expect("can be drawn");
    let times = film.times();
    assert_eq!((times.len(), times[0], times[15]), (16, 0.0, 0.51));
    assert!(times.windows(2).all(|pair| (pair[1] - pair[0] - 0.034).abs() < 1e-12), "{times:?}");
}

#[test]
fn show_states_at_seconds_of_their_own() {
    // The system is fixed in time, and the film shows its states in slow motion.
    let drawing = Drawing::of(&LADDER);
    let moments = |seconds: [f64; 3]| seconds.into_iter().zip([1.0, 0.9, 0.8].map(|a| (2.0, [a, -1.0])));
    let film = drawing.timed_film(moments([0.0, 0.5, 1.0])).expect("can be drawn");
    assert_eq!(film.times(), [0.0, 0.5, 1.0]);
    let pictures = drawing.pictures(moments([0.0; 3]).map(|(_, instant)| instant)).expect("can be drawn");
    assert_eq!(*film.pictures(), pictures);
    let error = drawing.timed_film(moments([0.0, 0.0, 1.0])).expect_err("stands still");
    assert_eq!(error.to_string(), "times must be finite, and rise or fall from picture to picture");
    assert!(drawing.timed_film(moments([0.0, f64::NAN, 1.0])).is_err());
    assert!(drawing.timed_film([]).is_err(), "there is no picture");
}

#[test]
fn plot_what_is_computed_at_their_times() {
    let run = run(0.5);
    let film = Drawing::of(&LADDER).film_at(30.0, &run).expect("can be drawn");
    let film = film.with_energy("twice", &run, |_, y| 2.0 * y[0]).expect("is known");
    let twice = values(&film, "twice");
    assert_eq!(twice.len(), film.times().len());
    for (twice, time) in twice.iter().zip(film.times()) {
        assert!((twice - 2.0 * (1.0 - time)).abs() < 1e-12);
    }
}

#[test]
fn plot_values_at_the_times_of_states_in_slow_motion() {
    let run = run(0.5);
    let twice = |_, y: &[f64; 2]| 2.0 * y[0];
    let film = Drawing::of(&LADDER).timed_film(run.iter().map(|(t, y)| (10.0 * t, (t, y))));
    let film = film.expect("can be drawn").with_energy("twice", &run, twice).expect("is known");
    let film = film.with_columns(&run, &["energy"]).expect("is observed");
    let states = run.states().map(|y| 2.0 * y[0]).collect::<Vec<_>>();
    let (twice, energy) = (values(&film, "twice"), values(&film, "energy"));
    assert_eq!((twice.len(), energy.len()), (run.len(), run.len()));
    assert!(twice.iter().zip(states).all(|(value, state)| (value - state).abs() < 1e-12));
}

#[test]
fn refuse_what_is_not_known_at_their_times() {
    let (drawing, run) = (Drawing::of(&LADDER), run(0.5));
    let film = drawing.film_at(30.0, &run).expect("can be drawn");
    let columns = film.clone().with_columns(&run, &["energy"]).expect_err("lies between samples");
    assert!(columns.to_string().contains("samples"), "{columns}");
    let unknown = film.with_columns(&run, &["entropy"]).expect_err("is no column");
    assert!(unknown.to_string().contains("`entropy`"), "{unknown}");
    let sparse = LADDER.simulate(START).until(0.5).run().expect("is simple");
    assert!(drawing.film_at(30.0, &sparse).expect_err("is not kept").to_string().contains("dense"));
    for number in [0.0, -25.0, f64::NAN, f64::INFINITY] {
        assert!(drawing.film_at(number, &run).is_err(), "{number}");
    }
    for (number, pictures) in [(1e9, "500000001"), (2e5, "100001"), (f64::MAX, "89884656743115")] {
        let error = drawing.film_at(number, &run).expect_err("is no film").to_string();
        assert!(
            error.contains(&format!("at most 100000 pictures, but this would have {pictures}")),
            "{error}"
        );
    }
}

#[test]
fn write_each_path_of_a_point_once() {
    // Motion so slow at first that its points coincide.
    let hinge = |_: &Puppet, _: f64, y: &[f64; 2]| {
        let angle = 1.0 + (y[0] - 1.0) * (y[0] - 1.0) / 2.0;
        [angle.cos(), angle.sin()]
    };
    let film = Drawing::of(&LADDER).trace("hinge", hinge).film(&run(1.0)).expect("can be drawn");
    let svg = film.svg();
    assert_eq!(svg.matches("attributeName=\"stroke-dashoffset\"").count(), 1);
    let data = svg.split(" d=\"").skip(1).filter_map(|rest| rest.split('"').next());
    let is_long_line = |data: &&str| data.matches('L').count() > 10 && data.matches('M').count() == 1;
    assert_eq!(data.filter(is_long_line).count(), 1);
}

#[test]
fn are_written_by_their_extension() {
    let film = Drawing::of(&LADDER).size(200.0, 150.0).film(&run(0.2)).expect("can be drawn");
    for (extension, start) in [("svg", "<svg"), ("html", "<!DOCTYPE html>"), ("gif", "GIF89a")] {
        let path = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("film.{extension}"));
        film.save(&path).expect("can be written");
        assert!(std::fs::read(&path).expect("is there").starts_with(start.as_bytes()), "{extension}");
    }
}

lagrange::system! {
    /// A trolley pushed by a force.
    #[derive(Debug)]
    struct Trolley;
    coord x;
    input push;
    body cart { mass: 2; shape: rectangle(0.4, 0.2); center: (x, 0); }
    force (push, 0) at cart.center;
    emit { drawing }
}

/// The forces in a film follow the inputs set by a control, not the defaults of the system.
#[test]
fn show_the_forces_that_a_control_set() {
    let trolley = Trolley::default();
    let law = |_: &Trolley, t: f64, _: TrolleyState| TrolleyInputs { push: 5.0 - 2.0 * t };
    let driven = trolley.simulate([0.0, 0.0]).until(1.0).drive(law).every(0.25).dense().run().expect("moves");
    let held = trolley.simulate([0.0, 0.0]).until(1.0).sampled(0.5, law).dense().run().expect("moves");
    let drawing = Drawing::of(&trolley).forces();
    let arrows = |picture: &lagrange::draw::Picture| {
        picture.svg().matches("<polygon").count() + picture.svg().matches("<path").count()
    };
    let idle = arrows(&drawing.picture(0.0, &[0.0, 0.0]).expect("can be drawn"));
    for film in [
        drawing.film(&driven),
        drawing.film_at(8.0, &driven),
        drawing.film(&held),
        drawing.film_at(8.0, &held),
    ] {
        let film = film.expect("can be drawn");
        assert!(film.pictures().iter().all(|picture| arrows(picture) > idle), "each with its arrow");
    }
    let after = driven.with_inputs_at(2, &trolley).expect("inputs were set");
    assert_eq!(after.push, 4.0);
    let free = trolley.simulate([0.0, 0.0]).until(1.0).run().expect("moves");
    assert!(free.with_inputs_at(0, &trolley).is_none());
}
