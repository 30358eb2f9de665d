//! Where in its file what a scene has comes from.

use std::collections::HashMap;
use std::path::PathBuf;

use super::Scene;
use crate::error::Error;

/// A table of a scene file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Element {
    /// `[camera]`.
    Camera,
    /// `[animation]`, with its keys.
    Animation,
    /// `[[viewport]]`: [`Scene::viewports`], its own camera included.
    Viewport(usize),
    /// `[[light]]`: [`Scene::lights`].
    Light(usize),
    /// `[[material]]`: [`Scene::materials`].
    Material(usize),
    /// `[[actor]]`, `[[line]]`, `[[marker]]` or `[[text]]`: [`Scene::actors`].
    Actor(usize),
}

/// Where a scene comes from.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Source {
    /// Its file; empty if it has none.
    pub file: PathBuf,
    /// Whether that is a mesh, which says nothing of how it is seen and moves.
    pub bare: bool,
    /// The line, from 1, at which each table begins.
    pub lines: HashMap<Element, usize>,
}

impl Scene {
    /// What is wrong with the scene, or with one of its tables, as an error in its file.
    pub fn error(&self, element: Option<Element>, message: &str) -> Error {
        let whole = |element| match element {
            Element::Actor(actor) => Element::Actor(self.whole(actor)),
            other => other,
        };
        let line = element.and_then(|element| self.source.lines.get(&whole(element)));
        match line {
            Some(line) => Error::at_line(&self.source.file, *line, message),
            None => Error::new(&self.source.file, message),
        }
    }
}
