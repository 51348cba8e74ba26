use std::collections::BTreeMap;

use crate::syntax::ast::Document;

use super::definition::{Definition, definition_of};

/// The standard library: its declarations by name, found once for all texts that are compiled.
#[derive(Debug)]
pub struct Library {
    document: Document,
    /// The item that declares a name.
    places: BTreeMap<String, usize>,
}

impl Library {
    /// A library of these declarations.
    #[must_use]
    pub fn new(document: Document) -> Self {
        let items = document.items.iter().enumerate();
        let names = items.filter_map(|(place, item)| {
            let definition = definition_of(&item.declaration)?;
            Some((definition.name.text.clone(), place))
        });
        Self {
            places: names.collect(),
            document,
        }
    }

    /// The declarations, in order.
    #[must_use]
    pub fn document(&self) -> &Document {
        &self.document
    }

    pub(super) fn get(&self, name: &str) -> Option<Definition<'_>> {
        let place = *self.places.get(name)?;
        definition_of(&self.document.items[place].declaration)
    }

    pub(super) fn names(&self) -> impl Iterator<Item = &str> {
        self.places.keys().map(String::as_str)
    }
}
