//! GIF: a common palette, and only the changed region of each picture.

use std::borrow::Cow;

use gif::{DisposalMethod, Encoder, EncodingError, Frame, Repeat};

use crate::drawing::DrawnSpace;
use crate::error::{DrawError, refusal};
use crate::film::Film;
use crate::film::palette::{Histogram, Palette};
use crate::picture::Picture;
use crate::raster::rasterise;

/// Index of the colour that leaves a pixel unchanged.
const UNCHANGED: u8 = u8::MAX;
/// Maximum number of pictures from which the palette is computed.
const SAMPLES: usize = 16;
/// Shortest duration of a picture, in hundredths of a second, that viewers respect. They treat
/// shorter ones as errors.
const SHORTEST: u64 = 2;

impl<D: DrawnSpace> Film<D> {
    /// Returns the film as a GIF that plays in a loop. Times are rounded to hundredths of a second,
    /// without accumulating. At more than fifty pictures a second, some are omitted.
    ///
    /// # Errors
    /// If pictures are larger than 65535 pixels, or one is to be shown for longer than 655 seconds.
    pub fn gif(&self) -> Result<Vec<u8>, DrawError> {
        let pictures = self.pictures();
        let mut palette = palette(&pictures)?;
        let first = rasterise(&pictures[0], 1.0)?;
        let (Ok(width), Ok(height)) = (u16::try_from(first.width()), u16::try_from(first.height())) else {
            return Err(refusal("a GIF is at most 65535 pixels wide and high"));
        };
        let mut encoder = Encoder::new(Vec::new(), width, height, palette.colours.as_flattened())
            .map_err(|error| failure(&error))?;
        encoder.set_repeat(Repeat::Infinite).map_err(|error| failure(&error))?;
        let mut before: Option<Vec<u8>> = None;
        for (index, delay) in shown(&self.timeline.elapsed()) {
            let picture = palette.indices(rasterise(&pictures[index], 1.0)?.rgba());
            let mut frame = difference(before.as_deref(), &picture, width, height);
            frame.delay =
                u16::try_from(delay).map_err(|_| refusal("a GIF shows a picture for at most 655 seconds"))?;
            encoder.write_frame(&frame).map_err(|error| failure(&error))?;
            before = Some(picture);
        }
        encoder.into_inner().map_err(|error| failure(&error))
    }
}

fn palette(pictures: &[Picture]) -> Result<Palette, DrawError> {
    let mut histogram = Histogram::default();
    for picture in pictures.iter().step_by(pictures.len().div_ceil(SAMPLES)) {
        histogram.add(rasterise(picture, 1.0)?.rgba());
    }
    Ok(histogram.palette(usize::from(UNCHANGED)))
}

/// Returns the pictures that are shown, and their durations in hundredths of a second. The last one
/// lasts as long as the one before it.
fn shown(elapsed: &[f64]) -> Vec<(usize, u64)> {
    let mut starts: Vec<(usize, u64)> = Vec::new();
    for (index, time) in elapsed.iter().enumerate() {
        let start = (100.0 * time).round() as u64;
        match starts.last() {
            Some((_, last)) if start < last + SHORTEST => {}
            _ => starts.push((index, start)),
        }
    }
    // The end of a motion must be visible.
    if let Some(last) = starts.last_mut().filter(|last| last.0 > 0) {
        last.0 = elapsed.len() - 1;
    }
    let mut delays: Vec<u64> = starts.windows(2).map(|pair| pair[1].1 - pair[0].1).collect();
    delays.push(delays.last().copied().unwrap_or(SHORTEST));
    starts.into_iter().zip(delays).map(|((index, _), delay)| (index, delay)).collect()
}

/// Returns the changed region of a picture relative to the one before. It has at least one pixel,
/// since every picture has a duration.
fn difference(before: Option<&[u8]>, picture: &[u8], width: u16, height: u16) -> Frame<'static> {
    let Some(before) = before else {
        return Frame {
            width,
            height,
            dispose: DisposalMethod::Keep,
            buffer: Cow::Owned(picture.to_vec()),
            ..Frame::default()
        };
    };
    let (columns, rows) = extent(before, picture, usize::from(width));
    let pixel = |index: usize| if before[index] == picture[index] { UNCHANGED } else { picture[index] };
    let row = |row: usize| columns.clone().map(move |column| row * usize::from(width) + column).map(pixel);
    // Regions of pictures whose sides fit into 16 bits also fit.
    Frame {
        left: columns.start as u16,
        top: rows.start as u16,
        width: columns.len() as u16,
        height: rows.len() as u16,
        dispose: DisposalMethod::Keep,
        transparent: Some(UNCHANGED),
        buffer: Cow::Owned(rows.clone().flat_map(row).collect()),
        ..Frame::default()
    }
}

type Range = std::ops::Range<usize>;

/// Returns the columns and rows of the bounding box of all differences, or of the first pixel if
/// there are none.
fn extent(before: &[u8], picture: &[u8], width: usize) -> (Range, Range) {
    let differs = |index: &usize| before[*index] != picture[*index];
    let places = (0..picture.len()).filter(differs).map(|index| (index % width, index / width));
    let with = |range: Range, at: usize| range.start.min(at)..range.end.max(at + 1);
    let extent = places.fold(None, |extent: Option<(Range, Range)>, (column, row)| match extent {
        Some((columns, rows)) => Some((with(columns, column), with(rows, row))),
        None => Some((column..column + 1, row..row + 1)),
    });
    extent.unwrap_or((0..1, 0..1))
}

fn failure(error: &EncodingError) -> DrawError {
    DrawError::Film(format!("the pictures cannot be written as GIF: {error}"))
}
