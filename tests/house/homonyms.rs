//! Types, aliases and traits of one name in several files of a crate.

use std::collections::BTreeMap;

use crate::imports::Crate;

/// Largest number of names that denote several types in a crate.
const MAX_HOMONYMS: usize = 10;

/// Returns all such names of a crate with too many of them.
pub(crate) fn too_many(krate: &Crate) -> Option<String> {
    let (names, name) = (homonyms(krate), &krate.name);
    let list = names.join("\n  ");
    (names.len() > MAX_HOMONYMS)
        .then(|| format!("{name} has {} names for several types:\n  {list}", names.len()))
}

/// Returns every such name with its locations.
pub(crate) fn homonyms(krate: &Crate) -> Vec<String> {
    let mut places = BTreeMap::<_, BTreeMap<_, _>>::new();
    for item in &krate.types {
        places.entry(&item.name).or_default().entry(&krate.files[item.file].path).or_insert(item.line);
    }
    let several = places.into_iter().filter(|(_, places)| places.len() > 1);
    several
        .map(|(name, places)| {
            let places = places.into_iter().map(|(path, line)| format!("{path}:{line}"));
            format!("{name}: {}", places.collect::<Vec<_>>().join(", "))
        })
        .collect()
}
