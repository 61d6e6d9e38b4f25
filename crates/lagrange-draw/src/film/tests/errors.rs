use crate::film::Film;
use crate::film::tests::{line, pendulum, stroke};
use crate::picture::Picture;

fn reason(film: Result<Film, crate::DrawError>) -> String {
    film.expect_err("is refused").to_string()
}

#[test]
fn refuses_what_is_no_film() {
    let pictures = pendulum(3).recording;
    let film = |pictures, times: &[f64]| reason(Film::new(pictures, times.to_vec()));
    assert!(film(vec![], &[]).contains("at least one"));
    assert!(film(pictures.clone(), &[0.0, 1.0]).contains("3 pictures have 2 times"));
    for times in [[0.0, 1.0, 1.0], [0.0, 1.0, 0.5], [0.0, 1.0, f64::NAN], [0.0, 1.0, f64::INFINITY]] {
        assert!(film(pictures.clone(), &times).contains("rise or fall"), "{times:?}");
    }
}

#[test]
fn refuses_pictures_that_do_not_match() {
    let with = |change: &dyn Fn(&mut Picture)| {
        let mut pictures = pendulum(3).recording;
        change(&mut pictures[1]);
        reason(Film::new(pictures, vec![0.0, 1.0, 2.0]))
    };
    assert!(with(&|picture| picture.size[0] += 1.0).contains("picture 1 differs in size"));
    assert!(with(&|picture| picture.marks.truncate(2)).contains("picture 1 differs in its marks"));
    let nowhere = |picture: &mut Picture| picture.marks[0] = stroke(line(&[[0.0, 0.0], [f64::NAN, 0.0]]));
    assert!(with(&nowhere).contains("picture 1 is not at a finite position"));
}

#[test]
fn takes_motions_that_ran_backwards() {
    let pictures = pendulum(3).recording;
    let film = Film::new(pictures, vec![1.0, 0.5, 0.0]).expect("is a film");
    assert_eq!(film.timeline.elapsed(), [0.0, 0.5, 1.0]);
}

#[test]
fn refuses_curves_of_another_length() {
    assert!(reason(pendulum(3).with_values("energy", vec![1.0])).contains("1 values for 3 pictures"));
}

#[test]
fn refuses_formats_that_it_cannot_write() {
    let refused = pendulum(1).save("film.mp4").expect_err("is refused").to_string();
    assert_eq!(refused, "`film.mp4` does not end in the name of a format, which is one of svg, gif, html");
}
