//! Units: their description, their sources, and archives of both.

use lagrange_c::Module;
use lagrange_core::pipeline::Programs;

use crate::archive::packed;
use crate::binding::binding;
use crate::compile::{Binary, compiled};
use crate::dependencies::Dependencies;
use crate::description::{Heading, build, description};
use crate::error::ExportError;
use crate::quantities::Definitions;
use crate::variables::{Start, variables};
use crate::version::Version;

/// Default tolerance of steps.
const TOLERANCE: f64 = 1e-10;

/// Sources common to all systems and versions.
const SOURCES: [(&str, &str); 9] = [
    ("export.h", include_str!("../sources/export.h")),
    ("instance.h", include_str!("../sources/instance.h")),
    ("values.h", include_str!("../sources/values.h")),
    ("events.h", include_str!("../sources/events.h")),
    ("exchange.h", include_str!("../sources/exchange.h")),
    ("stepping.h", include_str!("../sources/stepping.h")),
    ("changes.h", include_str!("../sources/changes.h")),
    ("motion.h", include_str!("../sources/motion.h")),
    ("dormand_prince.h", include_str!("../sources/dormand_prince.h")),
];

/// A unit of the Functional Mock-up Interface.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct MockupUnit {
    /// Version of the standard.
    pub version: Version,
    /// Name of the library, the name of the struct in lower case.
    pub name: String,
    /// XML description.
    pub description: String,
    /// Names and texts of the sources.
    pub sources: Vec<(&'static str, String)>,
}

impl MockupUnit {
    /// Writes the description and the sources of a system.
    ///
    /// # Errors
    /// If C cannot compute the system, or an initial value is missing.
    pub fn new(programs: &Programs, start: &Start, version: Version) -> Result<MockupUnit, ExportError> {
        let module = Module::new(programs, Some("model"))?;
        check(programs, start)?;
        let mut units = Definitions::default();
        let follows = Dependencies::new(programs).of_start();
        let follows = follows.iter().zip(&start.are_given).map(|(follows, given)| *follows && !given);
        let variables = variables(programs, start, &follows.collect::<Vec<_>>(), &mut units)?;
        let name = module.name;
        let sources_with = |guid: &str| {
            let fixed =
                version.sources().iter().chain(&SOURCES).map(|(file, text)| (*file, (*text).to_owned()));
            let binding = binding((&name, guid, TOLERANCE), programs, start, &variables);
            let written = [
                ("model.c", module.source.clone()),
                ("model.h", module.header.clone()),
                ("binding.h", binding),
            ];
            fixed.chain(written).collect::<Vec<_>>()
        };
        let described = |guid: &str, sources: &[(&'static str, String)]| {
            let sources = compiled_files(sources);
            let heading = Heading { version, identifier: &name, guid, tolerance: TOLERANCE, sources };
            description(programs, &heading, &variables, &units)
        };
        let sources = sources_with("");
        let guid = guid(sources.iter().map(|(_, text)| text.as_str()).chain([&*described("", &sources)]));
        let sources = sources_with(&guid);
        Ok(MockupUnit { version, description: described(&guid, &sources), sources, name })
    }

    /// Compiles the sources for this machine with a C compiler, such as `cc`.
    ///
    /// # Errors
    /// If the compiler does not start or rejects the sources.
    pub fn compile(&self, compiler: &str) -> Result<Binary, ExportError> {
        compiled((&self.name, self.version), compiler, &self.sources)
    }

    /// Packs the unit into the bytes of a file `*.fmu`. Without a binary, it contains only sources.
    ///
    /// # Errors
    /// If the archive is too large.
    pub fn archive(&self, binary: Option<&Binary>) -> Result<Vec<u8>, ExportError> {
        let mut files = vec![("modelDescription.xml".to_owned(), self.description.as_bytes())];
        files.extend(self.sources.iter().map(|(name, text)| (format!("sources/{name}"), text.as_bytes())));
        let build = build(self.version, &self.name, &compiled_files(&self.sources));
        files.extend(build.as_ref().map(|text| ("sources/buildDescription.xml".to_owned(), text.as_bytes())));
        files.extend(binary.map(|binary| (binary.path.clone(), &*binary.bytes)));
        Ok(packed(&files)?)
    }
}

/// Returns the names of the sources to compile.
fn compiled_files(sources: &[(&'static str, String)]) -> Vec<&'static str> {
    sources.iter().map(|(file, _)| *file).filter(|file| file.ends_with(".c")).collect()
}

fn check(programs: &Programs, start: &Start) -> Result<(), ExportError> {
    let names = [programs.variables.fields.clone(), programs.variables.state_names()].concat();
    let values = start.fields.iter().chain(&start.state).map(Some).chain(std::iter::repeat(None));
    let is_missing = |value: Option<&f64>| value.is_none_or(|value| !value.is_finite());
    let missing = names.into_iter().zip(values).filter(|(_, value)| is_missing(*value));
    let missing = missing.map(|(name, _)| name).collect::<Vec<_>>();
    if missing.is_empty() { Ok(()) } else { Err(ExportError::WithoutValue(missing)) }
}

/// Returns an identifier determined by texts: their 128-bit hash by the function FNV-1a.
fn guid<'a>(texts: impl Iterator<Item = &'a str>) -> String {
    const PRIME: u128 = (1 << 88) + 0x13b;
    const BASIS: u128 = 0x6c62_272e_07bb_0142_62b8_2175_6295_c58d;
    let bytes = texts.flat_map(|text| text.bytes().chain([0]));
    let hash = bytes.fold(BASIS, |hash, byte| (hash ^ u128::from(byte)).wrapping_mul(PRIME));
    let digits = format!("{hash:032x}");
    let parts = [&digits[..8], &digits[8..12], &digits[12..16], &digits[16..20], &digits[20..]];
    format!("{{{}}}", parts.join("-"))
}
