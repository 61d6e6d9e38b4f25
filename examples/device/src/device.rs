//! Devices, and the search for one.

use lagrange_runtime::simulate::InitialState;
use lagrange_runtime::system::KernelSystem;

use crate::backend::{Backend, devices};
use crate::ensemble::Motions;
use crate::error::DeviceError;
use crate::number::DeviceNumber;

/// A device that computes many motions at once.
pub struct Device {
    backend: Box<dyn Backend>,
}

impl Device {
    /// Opens the first device: a graphics processor if there is one, by CUDA rather than by OpenCL,
    /// else another device of OpenCL.
    ///
    /// # Errors
    /// [`NotFound`](DeviceError::NotFound), which names the missing parts and how to install them.
    pub fn open() -> Result<Device, DeviceError> {
        let mut all = Device::all()?;
        let first = all.iter().position(|device| device.backend.description().is_graphics).unwrap_or(0);
        Ok(all.swap_remove(first))
    }

    /// Returns all devices, at least one. A device known to both CUDA and OpenCL appears twice.
    ///
    /// # Errors
    /// [`NotFound`](DeviceError::NotFound), which names the missing parts and how to install them.
    pub fn all() -> Result<Vec<Device>, DeviceError> {
        let (found, missing) = devices();
        if found.is_empty() {
            return Err(DeviceError::NotFound(missing));
        }
        Ok(found.into_iter().map(|backend| Device { backend }).collect())
    }

    /// Returns the name from the driver, and the API that leads to the device.
    pub fn name(&self) -> &str {
        &self.backend.description().name
    }

    /// True if it computes in `f64`.
    pub fn has_double_precision(&self) -> bool {
        self.backend.description().has_doubles
    }

    #[cfg(test)]
    pub(crate) fn backend(&self) -> &dyn Backend {
        &*self.backend
    }

    /// Creates motions of a system from each of these states, to be configured and run.
    pub fn ensemble<'a, M>(
        &'a self,
        system: &'a M,
        starts: impl IntoIterator<Item: InitialState<M::State>>,
    ) -> Motions<'a, M>
    where
        M: KernelSystem<Scalar: DeviceNumber>,
    {
        let starts = starts.into_iter().map(InitialState::into_state).collect();
        Motions::new(&*self.backend, system, starts)
    }
}

impl std::fmt::Debug for Device {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_tuple("Device").field(&self.name()).finish()
    }
}
