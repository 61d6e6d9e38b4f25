//! OpenCL 1.2 through `opencl3`, which loads it at run time.
#![expect(unsafe_code, reason = "memory of the device and calls of kernels are not checked by the compiler")]

use std::ptr::null_mut;
use std::sync::{Mutex, PoisonError};

use opencl3::command_queue::CommandQueue;
use opencl3::context::Context;
use opencl3::device::{CL_DEVICE_TYPE_ALL, CL_DEVICE_TYPE_GPU, Device};
use opencl3::error_codes::ClError;
use opencl3::kernel::{ExecuteKernel, Kernel};
use opencl3::memory::{Buffer, CL_MEM_READ_WRITE};
use opencl3::platform::get_platforms;
use opencl3::program::Program;
use opencl3::types::{CL_BLOCKING, cl_device_id};

use super::{BUDGET, Backend, Description, Found, GROUP, Run, Status, Work};
use crate::error::DeviceError;

const ADVICE: &str = "install the OpenCL driver of the device, or `pocl-opencl-icd` for processors";

struct OpenCl {
    description: Description,
    context: Context,
    queue: CommandQueue,
}

/// Lock so that only one thread looks for devices at a time. PoCL shows a second thread devices
/// that the first has not yet initialised.
static LOOKING: Mutex<()> = Mutex::new(());

/// Returns all devices of all platforms.
pub(super) fn devices() -> Found {
    let _looking = LOOKING.lock().unwrap_or_else(PoisonError::into_inner);
    let platforms =
        get_platforms().map_err(|error| format!("OpenCL finds no platform ({error}): {ADVICE}"))?;
    let ids =
        platforms.iter().flat_map(|platform| platform.get_devices(CL_DEVICE_TYPE_ALL).unwrap_or_default());
    let opened = ids.map(OpenCl::open).collect::<Result<Vec<_>, _>>();
    let opened = opened.map_err(|error| format!("OpenCL cannot open a device: {error}"))?;
    if opened.is_empty() {
        return Err(format!("OpenCL has no device: {ADVICE}"));
    }
    Ok(opened.into_iter().map(|device| Box::new(device) as Box<dyn Backend>).collect())
}

impl OpenCl {
    fn open(id: cl_device_id) -> Result<OpenCl, ClError> {
        let device = Device::new(id);
        let context = Context::from_device(&device)?;
        // The newer function does not exist in OpenCL 1.2.
        let queue = CommandQueue::create_default(&context, 0)?;
        let description = Description {
            name: format!("{} (OpenCL)", device.name()?.trim()),
            is_graphics: device.dev_type()? & CL_DEVICE_TYPE_GPU != 0,
            has_doubles: device.extensions()?.split_whitespace().any(|extension| extension == "cl_khr_fp64"),
        };
        Ok(OpenCl { description, context, queue })
    }

    /// Calls the kernel until no motion has steps left.
    fn advance<T: Copy>(&self, kernel: &Kernel, work: &mut Work<T>) -> Result<(), ClError> {
        let (states, parameters) = (self.filled(&work.states)?, self.filled(&work.parameters)?);
        let (times, controls) = (self.filled(&work.times)?, self.filled(&work.controls)?);
        let (taken, statuses) = (self.filled(&work.taken)?, self.filled(&work.statuses)?);
        while Status::any_running(&work.statuses) {
            // SAFETY: these are the arguments of all kernels in `methods.c`. Buffers have an entry
            // in each column for every motion, and threads beyond the last motion return at once.
            let event = unsafe {
                ExecuteKernel::new(kernel)
                    .set_arg(&states)
                    .set_arg(&parameters)
                    .set_arg(&times)
                    .set_arg(&controls)
                    .set_arg(&taken)
                    .set_arg(&statuses)
                    .set_arg(&work.end)
                    .set_arg(&work.step)
                    .set_arg(&work.relative)
                    .set_arg(&work.absolute)
                    .set_arg(&work.motions)
                    .set_arg(&BUDGET)
                    .set_arg(&work.most)
                    .set_global_work_size(work.motions.next_multiple_of(GROUP) as usize)
                    .enqueue_nd_range(&self.queue)?
            };
            event.wait()?;
            self.read(&statuses, &mut work.statuses)?;
        }
        self.read(&states, &mut work.states)?;
        self.read(&times, &mut work.times)?;
        self.read(&controls, &mut work.controls)
    }

    /// Returns memory of the device with these values.
    fn filled<T: Copy>(&self, values: &[T]) -> Result<Buffer<T>, ClError> {
        // SAFETY: the memory is the device's own, and as long as the data written to it before
        // anything reads it. The call returns when `values` are no longer needed.
        unsafe {
            let mut buffer = Buffer::create(&self.context, CL_MEM_READ_WRITE, values.len(), null_mut())?;
            self.queue.enqueue_write_buffer(&mut buffer, CL_BLOCKING, 0, values, &[])?;
            Ok(buffer)
        }
    }

    fn read<T: Copy>(&self, buffer: &Buffer<T>, values: &mut [T]) -> Result<(), ClError> {
        // SAFETY: the buffer was made for this number of values, and the call returns when they
        // have arrived.
        unsafe { self.queue.enqueue_read_buffer(buffer, CL_BLOCKING, 0, values, &[]) }.map(|_| ())
    }

    fn failed(&self, task: &'static str, error: &ClError) -> DeviceError {
        DeviceError::Driver { device: self.description.name.clone(), task, reason: error.to_string() }
    }
}

impl<T: Copy> Run<T> for OpenCl {
    fn run(&self, text: &str, work: &mut Work<T>) -> Result<(), DeviceError> {
        let refused = |log| DeviceError::Build { device: self.description.name.clone(), log };
        let program =
            Program::create_and_build_from_source(&self.context, text, "-cl-std=CL1.2").map_err(refused)?;
        let kernel = Kernel::create(&program, work.method.kernel());
        let kernel = kernel.map_err(|error| self.failed("find the kernel", &error))?;
        self.advance(&kernel, work).map_err(|error| self.failed("compute motions", &error))
    }
}

impl Backend for OpenCl {
    fn description(&self) -> &Description {
        &self.description
    }
}
