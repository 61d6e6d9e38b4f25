//! Text on the standard output and the standard error, whose readers may be gone.

use std::io::{self, ErrorKind, StdoutLock, Write, stderr, stdout};

/// Writes results to the standard output. A reader that is gone, such as `head`, has read enough.
///
/// # Errors
/// If they cannot be written for another reason.
pub(crate) fn answer(write: impl FnOnce(&mut StdoutLock<'_>) -> io::Result<()>) -> Result<(), String> {
    let mut output = stdout().lock();
    match write(&mut output).and_then(|()| output.flush()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => Err(error.to_string()),
        _ => Ok(()),
    }
}

/// Writes a message to the standard error. Nobody misses it if there is no reader.
pub(crate) fn report(text: &str) {
    let mut error = stderr().lock();
    let _ = error.write_all(text.as_bytes()).and_then(|()| error.flush());
}
