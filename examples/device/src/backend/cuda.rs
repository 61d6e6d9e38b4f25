//! CUDA through `cudarc`, which loads the driver and the compiler NVRTC at run time.
#![expect(
    unsafe_code,
    reason = "libraries are looked for, and kernels are called, without the compiler's checks"
)]

use std::sync::Arc;

use cudarc::driver::{
    CudaContext, CudaFunction, CudaStream, DeviceRepr, DriverError, LaunchConfig, PushKernelArg,
};
use cudarc::nvrtc::{CompileError, CompileOptions, compile_ptx_with_opts};

use super::{BUDGET, Backend, Description, Found, GROUP, Run, Status, Work};
use crate::error::DeviceError;

struct Cuda {
    description: Description,
    context: Arc<CudaContext>,
    stream: Arc<CudaStream>,
}

/// Returns all devices of the driver.
pub(super) fn devices() -> Found {
    // SAFETY: these only try to load the libraries.
    let (driver, compiler) =
        unsafe { (cudarc::driver::sys::is_culib_present(), cudarc::nvrtc::sys::is_culib_present()) };
    if !driver {
        return Err("CUDA has no driver: install the NVIDIA driver".to_owned());
    }
    if !compiler {
        return Err("CUDA has no compiler: install NVRTC from the CUDA toolkit".to_owned());
    }
    let count = CudaContext::device_count().map_err(|error| format!("CUDA counts no devices: {error}"))?;
    let opened = (0..count.unsigned_abs() as usize).map(Cuda::open).collect::<Result<Vec<_>, _>>();
    let opened = opened.map_err(|error| format!("CUDA cannot open a device: {error}"))?;
    if opened.is_empty() {
        return Err("CUDA has no device".to_owned());
    }
    Ok(opened.into_iter().map(|device| Box::new(device) as Box<dyn Backend>).collect())
}

impl Cuda {
    fn open(index: usize) -> Result<Cuda, DriverError> {
        let context = CudaContext::new(index)?;
        let name = format!("{} (CUDA)", context.name()?);
        let description = Description { name, is_graphics: true, has_doubles: true };
        Ok(Cuda { description, stream: context.default_stream(), context })
    }

    /// Calls the kernel until no motion has steps left.
    fn advance<T: DeviceRepr + Copy>(
        &self,
        kernel: &CudaFunction,
        work: &mut Work<T>,
    ) -> Result<(), DriverError> {
        let stream = &self.stream;
        let (mut states, parameters) =
            (stream.clone_htod(&work.states)?, stream.clone_htod(&work.parameters)?);
        let (mut times, mut controls) = (stream.clone_htod(&work.times)?, stream.clone_htod(&work.controls)?);
        let (mut taken, mut statuses) = (stream.clone_htod(&work.taken)?, stream.clone_htod(&work.statuses)?);
        let threads = LaunchConfig {
            grid_dim: (work.motions.div_ceil(GROUP), 1, 1),
            block_dim: (GROUP, 1, 1),
            shared_mem_bytes: 0,
        };
        while Status::any_running(&work.statuses) {
            let mut call = stream.launch_builder(kernel);
            call.arg(&mut states)
                .arg(&parameters)
                .arg(&mut times)
                .arg(&mut controls)
                .arg(&mut taken)
                .arg(&mut statuses);
            call.arg(&work.end).arg(&work.step).arg(&work.relative).arg(&work.absolute);
            call.arg(&work.motions).arg(&BUDGET).arg(&work.most);
            // SAFETY: these are the arguments of all kernels in `methods.c`. Memory has an entry in
            // each column for every motion, and threads beyond the last motion return at once.
            unsafe { call.launch(threads) }?;
            stream.memcpy_dtoh(&statuses, &mut work.statuses)?;
            stream.synchronize()?;
        }
        stream.memcpy_dtoh(&states, &mut work.states)?;
        stream.memcpy_dtoh(&times, &mut work.times)?;
        stream.memcpy_dtoh(&controls, &mut work.controls)?;
        stream.synchronize()
    }
}

impl<T: DeviceRepr + Copy> Run<T> for Cuda {
    fn run(&self, text: &str, work: &mut Work<T>) -> Result<(), DeviceError> {
        let failed = |task| {
            move |error: DriverError| DeviceError::Driver {
                device: self.description.name.clone(),
                task,
                reason: error.to_string(),
            }
        };
        let (major, minor) = self.context.compute_capability().map_err(failed("report its version"))?;
        let options = vec![format!("--gpu-architecture=compute_{major}{minor}")];
        let options = CompileOptions { options, ..CompileOptions::default() };
        let compiled = compile_ptx_with_opts(text, options).map_err(|error| {
            let log = match error {
                CompileError::CompileError { log, .. } => log.to_string_lossy().into_owned(),
                other => other.to_string(),
            };
            DeviceError::Build { device: self.description.name.clone(), log }
        })?;
        let module = self.context.load_module(compiled).map_err(failed("load the kernel"))?;
        let kernel = module.load_function(work.method.kernel()).map_err(failed("find the kernel"))?;
        self.advance(&kernel, work).map_err(failed("compute motions"))
    }
}

impl Backend for Cuda {
    fn description(&self) -> &Description {
        &self.description
    }
}
