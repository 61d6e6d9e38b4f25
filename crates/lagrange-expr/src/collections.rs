//! Maps and sets whose order never depends on a hash.
//!
//! Generated code must be identical to the byte in every process. Containers in this crate that can
//! be iterated therefore keep insertion order. [`HashMap`] and [`HashSet`] support lookup but not
//! iteration.

use std::borrow::Borrow;
use std::hash::Hash;

use indexmap::IndexMap;
use rustc_hash::FxBuildHasher;

/// A map that supports lookup but not iteration.
#[derive(Clone, Debug)]
pub struct HashMap<K, V>(rustc_hash::FxHashMap<K, V>);

impl<K, V> Default for HashMap<K, V> {
    fn default() -> Self {
        HashMap(rustc_hash::FxHashMap::default())
    }
}

impl<K: Eq + Hash, V> HashMap<K, V> {
    /// Returns the value at `key`.
    pub fn get(&self, key: &K) -> Option<&V> {
        self.0.get(key)
    }

    /// True if `key` is present.
    pub fn contains(&self, key: &K) -> bool {
        self.0.contains_key(key)
    }

    /// Sets `key` and returns its previous value.
    pub fn insert(&mut self, key: K, value: V) -> Option<V> {
        self.0.insert(key, value)
    }

    /// Returns the value at `key`, to change.
    pub fn get_mut(&mut self, key: &K) -> Option<&mut V> {
        self.0.get_mut(key)
    }

    /// Removes `key` and returns its value.
    pub fn remove(&mut self, key: &K) -> Option<V> {
        self.0.remove(key)
    }

    /// Returns the value at `key`, created first if it is absent.
    pub fn get_or_insert_with(&mut self, key: K, value: impl FnOnce() -> V) -> &mut V {
        self.0.entry(key).or_insert_with(value)
    }

    /// Returns the number of entries.
    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// True if there is no entry.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }
}

impl<K: Eq + Hash, V> FromIterator<(K, V)> for HashMap<K, V> {
    fn from_iter<I: IntoIterator<Item = (K, V)>>(entries: I) -> Self {
        HashMap(entries.into_iter().collect())
    }
}

/// A set that supports lookup but not iteration.
#[derive(Clone, Debug)]
pub struct HashSet<T>(rustc_hash::FxHashSet<T>);

impl<T> Default for HashSet<T> {
    fn default() -> Self {
        HashSet(rustc_hash::FxHashSet::default())
    }
}

impl<T: Eq + Hash> HashSet<T> {
    /// True if `element` is present.
    pub fn contains<Q: Eq + Hash + ?Sized>(&self, element: &Q) -> bool
    where
        T: Borrow<Q>,
    {
        self.0.contains(element)
    }

    /// Adds `element` and returns true if it was absent.
    pub fn insert(&mut self, element: T) -> bool {
        self.0.insert(element)
    }

    /// Returns the number of elements.
    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// True if there is no element.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }
}

impl<T: Eq + Hash> FromIterator<T> for HashSet<T> {
    fn from_iter<I: IntoIterator<Item = T>>(elements: I) -> Self {
        HashSet(elements.into_iter().collect())
    }
}

/// A map that is iterated in the order of first insertion. Entries are never removed, so an entry's
/// index is stable.
#[derive(Clone, Debug)]
pub struct OrderedMap<K, V>(IndexMap<K, V, FxBuildHasher>);

impl<K, V> Default for OrderedMap<K, V> {
    fn default() -> Self {
        OrderedMap(IndexMap::with_hasher(FxBuildHasher))
    }
}

impl<K: Eq + Hash, V> OrderedMap<K, V> {
    /// Returns the value at `key`.
    pub fn get(&self, key: &K) -> Option<&V> {
        self.0.get(key)
    }

    /// Returns the value at `key`, to change.
    pub fn get_mut(&mut self, key: &K) -> Option<&mut V> {
        self.0.get_mut(key)
    }

    /// True if `key` is present.
    pub fn contains(&self, key: &K) -> bool {
        self.0.contains_key(key)
    }

    /// Sets `key`, which keeps its place if it was present, and returns its previous value.
    pub fn insert(&mut self, key: K, value: V) -> Option<V> {
        self.0.insert(key, value)
    }

    /// Returns the value at `key`, created first if it is absent.
    pub fn get_or_insert_with(&mut self, key: K, value: impl FnOnce() -> V) -> &mut V {
        self.0.entry(key).or_insert_with(value)
    }

    /// Returns the index of `key`, which is added with `value` if it is absent.
    pub fn index_or_insert_with(&mut self, key: K, value: impl FnOnce() -> V) -> usize {
        let entry = self.0.entry(key);
        let index = entry.index();
        entry.or_insert_with(value);
        index
    }

    /// Returns the index of `key`.
    pub fn index_of(&self, key: &K) -> Option<usize> {
        self.0.get_index_of(key)
    }

    /// Returns the key at an index returned by this map.
    pub fn key_at(&self, index: usize) -> &K {
        self.0.get_index(index).expect("an index of this map").0
    }

    /// Returns the value at an index returned by this map.
    pub fn value_at(&self, index: usize) -> &V {
        &self.0[index]
    }

    /// Returns the entries in order of insertion.
    pub fn iter(&self) -> impl DoubleEndedIterator<Item = (&K, &V)> + ExactSizeIterator {
        self.0.iter()
    }

    /// Returns the number of entries.
    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// True if there is no entry.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }
}

/// Returns the indices below `count` in sets that are not coupled to each other, each in ascending
/// order.
pub fn coupled_blocks(count: usize, is_coupled: impl Fn(usize, usize) -> bool) -> Vec<Vec<usize>> {
    let mut is_placed = vec![false; count];
    let mut blocks = Vec::new();
    for start in 0..count {
        let (mut members, mut pending) = (Vec::new(), vec![start]);
        while let Some(i) = pending.pop() {
            if !std::mem::replace(&mut is_placed[i], true) {
                members.push(i);
                pending.extend((0..count).filter(|&j| is_coupled(i, j) || is_coupled(j, i)));
            }
        }
        if !members.is_empty() {
            members.sort_unstable();
            blocks.push(members);
        }
    }
    blocks
}
