use gif::{ColorOutput, DecodeOptions};

use crate::film::tests::{pendulum, pendulum_at};
use crate::raster::rasterise;

struct Shown {
    delay: u16,
    size: (u16, u16),
    rgba: Vec<u8>,
}

/// Returns the pictures of a GIF as a viewer displays them.
fn play(bytes: &[u8]) -> Vec<Shown> {
    let mut options = DecodeOptions::new();
    options.set_color_output(ColorOutput::RGBA);
    let mut decoder = options.read_info(bytes).expect("is a GIF");
    let (width, height) = (usize::from(decoder.width()), usize::from(decoder.height()));
    let mut screen = vec![0; 4 * width * height];
    let mut shown = Vec::new();
    while let Some(frame) = decoder.read_next_frame().expect("is readable") {
        for (row, line) in frame.buffer.chunks_exact(4 * usize::from(frame.width)).enumerate() {
            let start = 4 * ((usize::from(frame.top) + row) * width + usize::from(frame.left));
            for (pixel, new) in screen[start..].chunks_exact_mut(4).zip(line.chunks_exact(4)) {
                if new[3] > 0 {
                    pixel.copy_from_slice(new);
                }
            }
        }
        let size = (frame.width, frame.height);
        shown.push(Shown { delay: frame.delay, size, rgba: screen.clone() });
    }
    shown
}

#[test]
fn shows_every_picture() {
    let film = pendulum(12);
    let shown = play(&film.gif().expect("can be written"));
    assert_eq!(shown.len(), 12);
    for (shown, picture) in shown.iter().zip(&film.recording) {
        let wanted = rasterise(picture, 1.0).expect("can be drawn").rgba().to_vec();
        let off = shown.rgba.iter().zip(&wanted).map(|(a, b)| a.abs_diff(*b)).max();
        let exact = shown.rgba.iter().zip(&wanted).filter(|(a, b)| a == b).count();
        assert!(off <= Some(24), "{off:?}");
        assert!(exact * 100 > wanted.len() * 98, "{exact} of {}", wanted.len());
    }
}

#[test]
fn holds_only_what_changes() {
    let shown = play(&pendulum(12).gif().expect("can be written"));
    assert_eq!(shown[0].size, (320, 200));
    assert!(shown[1..].iter().all(|shown| shown.size.0 < 300 && shown.size.1 < 200));
}

#[test]
fn lasts_as_long_as_the_motion() {
    // A third of a second is not a whole number of hundredths, yet errors do not accumulate.
    let times: Vec<f64> = (0..10).map(|index| f64::from(index) / 3.0).collect();
    let delays: Vec<u16> =
        play(&pendulum_at(&times).gif().expect("can be written")).iter().map(|shown| shown.delay).collect();
    assert_eq!(delays, [33, 34, 33, 33, 34, 33, 33, 34, 33, 33]);
}

#[test]
fn leaves_out_pictures_that_no_viewer_shows_but_never_the_last() {
    let times: Vec<f64> = (0..=100).map(|index| f64::from(index) / 1000.0).collect();
    let film = pendulum_at(&times);
    let shown = play(&film.gif().expect("can be written"));
    assert!(shown.iter().all(|shown| shown.delay >= 2), "shorter delays are ignored by browsers");
    assert!((5..=6).contains(&shown.len()), "{}", shown.len());
    let last = rasterise(&film.recording[100], 1.0).expect("can be drawn").rgba().to_vec();
    let exact = shown[shown.len() - 1].rgba.iter().zip(&last).filter(|(a, b)| a == b).count();
    assert!(exact * 100 > last.len() * 98);
}

#[test]
fn refuses_pictures_that_stay_for_longer_than_a_gif_can_tell() {
    assert!(pendulum_at(&[0.0, 700.0]).gif().is_err());
}
