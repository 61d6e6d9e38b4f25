//! Checksums of whole files.
//!
//! The metadata at the end of a file contain the XXH64 of all its bytes, with zeros in place of the
//! checksum. Other readers of Parquet ignore it.

use core::hash::Hasher;
use std::format;
use std::fs::File;
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::vec;
use std::vec::Vec;

use twox_hash::XxHash64;

/// Metadata key of the checksum.
pub(super) const KEY: &str = "lagrange.checksum";
/// Value of the checksum in a file that is not sealed.
pub(super) const UNSEALED: &str = "xxh64:0000000000000000";
const LABEL: &str = "xxh64:";
const ZEROS: [u8; 16] = [b'0'; 16];
/// Last bytes of a Parquet file, after the length of its metadata.
const END: &[u8; 4] = b"PAR1";

/// Writes the checksum into the place reserved for it in the metadata of a file.
pub(super) fn seal(mut file: &File) -> io::Result<()> {
    let place = place(file)?.ok_or_else(|| io::Error::other("there is no place for the checksum"))?;
    let digits = format!("{:016x}", checksum(file, place)?);
    file.seek(SeekFrom::Start(place))?;
    file.write_all(digits.as_bytes())
}

/// True if the file has the same bytes as when it was sealed; `None` if no checksum is found in its
/// metadata.
pub(super) fn is_intact(mut file: &File) -> io::Result<Option<bool>> {
    let Some(place) = place(file)? else { return Ok(None) };
    let digits = format!("{:016x}", checksum(file, place)?);
    let mut sealed = ZEROS;
    file.seek(SeekFrom::Start(place))?;
    file.read_exact(&mut sealed)?;
    Ok(Some(sealed == digits.as_bytes()))
}

/// Returns the offset of the checksum's digits.
fn place(mut file: &File) -> io::Result<Option<u64>> {
    let length = file.metadata()?.len();
    let Some(end) = length.checked_sub(8) else { return Ok(None) };
    let (mut size, mut mark) = ([0; 4], [0; 4]);
    file.seek(SeekFrom::Start(end))?;
    file.read_exact(&mut size)?;
    file.read_exact(&mut mark)?;
    let start = end.checked_sub(u64::from(u32::from_le_bytes(size)));
    let Some(start) = start.filter(|_| mark == *END) else { return Ok(None) };
    let mut metadata = vec![0; (end - start) as usize];
    file.seek(SeekFrom::Start(start))?;
    file.read_exact(&mut metadata)?;
    // In Thrift's compact protocol the value is the next field, a text, and its length takes one
    // byte.
    let before: Vec<u8> = [KEY.as_bytes(), &[0x18, UNSEALED.len() as u8], LABEL.as_bytes()].concat();
    let found = metadata.windows(before.len() + ZEROS.len()).rposition(|bytes| bytes.starts_with(&before));
    Ok(found.map(|found| start + (found + before.len()) as u64))
}

/// Computes the checksum of a file, with zeros in place of the checksum.
fn checksum(mut file: &File, place: u64) -> io::Result<u64> {
    let mut sum = Sum(XxHash64::with_seed(0));
    file.seek(SeekFrom::Start(0))?;
    io::copy(&mut file.take(place), &mut sum)?;
    sum.write_all(&ZEROS)?;
    file.seek(SeekFrom::Start(place + ZEROS.len() as u64))?;
    io::copy(&mut file, &mut sum)?;
    Ok(sum.0.finish())
}

/// A writer that accumulates the checksum of its input.
struct Sum(XxHash64);

impl Write for Sum {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.write(bytes);
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}
