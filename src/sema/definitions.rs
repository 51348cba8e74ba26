use std::collections::{BTreeMap, BTreeSet};

use super::definition::Definition;
use super::library::Library;

/// What is declared by name: in the files, and in the standard library where they do not replace it.
pub(super) struct Definitions<'a> {
    library: &'a Library,
    own: BTreeMap<&'a str, Definition<'a>>,
}

impl<'a> Definitions<'a> {
    pub(super) fn new(library: &'a Library) -> Self {
        Self {
            library,
            own: BTreeMap::new(),
        }
    }

    /// Declares a name of a file.
    pub(super) fn insert(&mut self, definition: Definition<'a>) {
        self.own.insert(&definition.name.text, definition);
    }

    pub(super) fn get(&self, name: &str) -> Option<Definition<'a>> {
        let own = self.own.get(name).copied();
        own.or_else(|| self.library.get(name))
    }

    pub(super) fn contains(&self, name: &str) -> bool {
        self.get(name).is_some()
    }

    /// The definitions of the files, by name.
    pub(super) fn of_files(&self) -> impl Iterator<Item = &Definition<'a>> {
        self.own.values()
    }

    /// What a file declares by a name.
    pub(super) fn of_file(&self, name: &str) -> Option<&Definition<'a>> {
        self.own.get(name)
    }

    /// All names, in order.
    pub(super) fn names(&self) -> BTreeSet<&'a str> {
        let own = self.own.keys().copied();
        own.chain(self.library.names()).collect()
    }
}
