//! What the ray caster needs beyond what is drawn: how rays are cast, a hierarchy of
//! boxes over each mesh, mirrors and glass, lights that have a size.
#![expect(
    clippy::arithmetic_side_effects,
    reason = "fields of a word; tests stop at overflow"
)]

use super::records::{i, u, w};
use super::{Mesh, Record, Scene};

/// How rays are cast.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RaySettings {
    /// Whether lights cast shadows.
    pub shadows: bool,
    /// Most rays one after the other, the camera's counted: 1..=8.
    pub depth: u8,
    /// Rays of a pixel that differs from a neighbour: 1..=16.
    pub samples: u8,
    /// Shadow rays to a light that has a size: 1..=16.
    pub light_samples: u8,
    /// A channel's difference beyond which two neighbours differ, in 1/64 of a level.
    pub threshold: u16,
    /// Which way is up for backgrounds seen in mirrors: length 1, Q30.
    pub up: [i32; 3],
}

impl RaySettings {
    /// Those of a scene that says nothing.
    pub const DEFAULT: Self = Self {
        shadows: true,
        depth: 4,
        samples: 1,
        light_samples: 4,
        threshold: 1632,
        up: [0, 1 << 30, 0],
    };
}

impl Record for RaySettings {
    type Words = [u32; 5];

    fn from_words(&[head, threshold, x, y, z]: &Self::Words) -> Self {
        let [shadows, depth, samples, light_samples] = head.to_ne_bytes();
        Self {
            shadows: shadows != 0,
            depth,
            samples,
            light_samples,
            threshold: u(threshold) as u16,
            up: [i(x), i(y), i(z)],
        }
    }

    fn to_words(&self) -> Self::Words {
        let shadows = u8::from(self.shadows);
        let head = [shadows, self.depth, self.samples, self.light_samples];
        let [x, y, z] = self.up.map(w);
        let threshold = u32::from(self.threshold).to_le();
        [u32::from_ne_bytes(head), threshold, x, y, z]
    }
}

/// What rays meet of a mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// Its triangles, through a hierarchy of boxes.
    Triangles {
        /// The hierarchy's root; the others follow.
        first_node: u32,
        /// How many nodes; 0: nothing to meet.
        nodes: u32,
    },
    /// A ball.
    Ball {
        /// Its centre, grid steps from the grid's.
        centre: [i32; 3],
        /// In 1/256 of a grid step, above 0.
        radius: u32,
    },
    /// An ellipsoid: what `rows` bring to the unit ball.
    Ellipsoid {
        /// Its centre, grid steps from the grid's.
        centre: [i32; 3],
        /// From grid steps to the unit ball, each entry times `2^-exponent`.
        rows: [[i32; 3]; 3],
        /// See `rows`: 30..=60.
        exponent: u8,
    },
    /// A rectangle across the grid's y axis.
    Rectangle {
        /// Its centre, grid steps from the grid's.
        centre: [i32; 3],
        /// Half its sides along x and z, in 1/256 of a grid step, above 0.
        half: [u32; 2],
        /// Axes on which the grid runs against the model, which faces its y axis and
        /// whose texture coordinates grow with x and z.
        against: [bool; 3],
    },
}

impl Record for Shape {
    type Words = [u32; 13];

    fn from_words(words: &Self::Words) -> Self {
        let [head, a, b, c, rest @ ..] = *words;
        let centre = [i(a), i(b), i(c)];
        let [r0, r1, r2, r3, r4, r5, r6, r7, r8] = rest.map(i);
        match u(head) & 3 {
            1 => Self::Ball {
                centre,
                radius: r0 as u32,
            },
            2 => Self::Ellipsoid {
                centre,
                rows: [[r0, r1, r2], [r3, r4, r5], [r6, r7, r8]],
                exponent: (u(head) >> 8) as u8,
            },
            3 => Self::Rectangle {
                centre,
                half: [r0 as u32, r1 as u32],
                against: [8, 9, 10].map(|bit| u(head) >> bit & 1 != 0),
            },
            _ => Self::Triangles {
                first_node: u(a),
                nodes: u(b),
            },
        }
    }

    fn to_words(&self) -> Self::Words {
        let mut words = [0; 13];
        let [head, c0, c1, c2, rest @ ..] = &mut words;
        match *self {
            Self::Triangles { first_node, nodes } => {
                (*c0, *c1) = (first_node.to_le(), nodes.to_le());
            }
            Self::Ball { centre, radius } => {
                *head = 1u32.to_le();
                [*c0, *c1, *c2] = centre.map(w);
                let [r0, ..] = rest;
                *r0 = radius.to_le();
            }
            Self::Ellipsoid {
                centre,
                rows,
                exponent,
            } => {
                *head = (2 | u32::from(exponent) << 8).to_le();
                [*c0, *c1, *c2] = centre.map(w);
                let entries = rows.as_flattened().iter().copied();
                rest.iter_mut().zip(entries).for_each(|(to, c)| *to = w(c));
            }
            Self::Rectangle {
                centre,
                half,
                against,
            } => {
                let [x, y, z] = against.map(u32::from);
                *head = (3 | x << 8 | y << 9 | z << 10).to_le();
                [*c0, *c1, *c2] = centre.map(w);
                let [r0, r1, ..] = rest;
                [*r0, *r1] = half.map(u32::to_le);
            }
        }
        words
    }
}

/// A node of a hierarchy: up to four boxes, each around another node or a leaf. Boxes
/// are in bytes from the node's origin, in units of `2^exponent` grid steps, after
/// Ylitie, Karras and Laine, "Efficient incoherent ray traversal on GPUs through
/// compressed wide BVHs" (2017).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Node {
    /// The least corner, in grid steps from the grid's centre.
    pub origin: [i32; 3],
    /// See above, 0..=15.
    pub exponent: u8,
    /// For each axis, the lower and the upper sides of the four boxes.
    pub sides: [[[u8; 4]; 2]; 3],
    /// What the boxes are around.
    pub children: [Child; 4],
}

/// What a node's box is around.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Child {
    /// Nothing, nor are those after it around anything.
    None,
    /// Another node: its number in the mesh.
    Node(u32),
    /// Triangles of one meshlet that follow each other.
    Leaf(Leaf),
}

/// Triangles of one meshlet that follow each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Leaf {
    /// The meshlet's number in the mesh, below 2^22.
    pub meshlet: u32,
    /// The first triangle's number in the meshlet.
    pub first: u8,
    /// How many, 1..=4.
    pub count: u8,
}

impl Child {
    /// From a node's word.
    #[inline(always)]
    pub fn from_word(word: u32) -> Self {
        let word = u(word);
        if word == 0 {
            Self::None
        } else if word >> 31 == 0 {
            Self::Node(word)
        } else {
            Self::Leaf(Leaf {
                meshlet: word & 0x3f_ffff,
                first: (word >> 22 & 0x7f) as u8,
                count: (word >> 29 & 3) as u8 + 1,
            })
        }
    }

    /// As a node has it.
    pub fn to_word(self) -> u32 {
        let word = match self {
            Self::None => 0,
            Self::Node(number) => number,
            Self::Leaf(leaf) => {
                let count = u32::from(leaf.count.saturating_sub(1) & 3);
                1 << 31 | count << 29 | u32::from(leaf.first & 0x7f) << 22 | leaf.meshlet
            }
        };
        word.to_le()
    }
}

impl Record for Node {
    type Words = [u32; 13];

    fn from_words(words: &Self::Words) -> Self {
        let [o0, o1, o2, s0, s1, s2, s3, s4, s5, c0, c1, c2, c3] = *words;
        let [s0, s1, s2, s3, s4, s5] = [s0, s1, s2, s3, s4, s5].map(u32::to_ne_bytes);
        Self {
            origin: [o0, o1, o2].map(|word| i(word) >> 5),
            exponent: (i(o0) & 31) as u8,
            sides: [[s0, s1], [s2, s3], [s4, s5]],
            children: [c0, c1, c2, c3].map(Child::from_word),
        }
    }

    fn to_words(&self) -> Self::Words {
        let [o0, o1, o2] = self.origin.map(|c| c << 5);
        let [[s0, s1], [s2, s3], [s4, s5]] = self.sides.map(|axis| axis.map(u32::from_ne_bytes));
        let [c0, c1, c2, c3] = self.children.map(Child::to_word);
        let o0 = w(o0 | i32::from(self.exponent));
        [o0, w(o1), w(o2), s0, s1, s2, s3, s4, s5, c0, c1, c2, c3]
    }
}

/// What a material does with rays.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Optics {
    /// The part that it mirrors, 2^16 is 1.
    pub reflectivity: u32,
    /// The part of its own colour in what is left, 2^16 is 1.
    pub opacity: u32,
    /// Refractive index of what it encloses, 2^16 is 1; 1..=4.
    pub index: u32,
}

impl Optics {
    /// Neither a mirror nor glass.
    pub const PLAIN: Self = Self {
        reflectivity: 0,
        opacity: 1 << 16,
        index: 1 << 16,
    };
}

impl Record for Optics {
    type Words = [u32; 3];

    fn from_words(words: &Self::Words) -> Self {
        let [reflectivity, opacity, index] = words.map(u);
        Self {
            reflectivity,
            opacity,
            index,
        }
    }

    fn to_words(&self) -> Self::Words {
        [self.reflectivity, self.opacity, self.index].map(u32::to_le)
    }
}

/// The edges of a light that is a parallelogram, raw world bits; all 0: a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LightArea {
    /// Both edges.
    pub edges: [[i32; 3]; 2],
}

impl LightArea {
    /// A point.
    pub const POINT: Self = Self { edges: [[0; 3]; 2] };
}

impl Record for LightArea {
    type Words = [u32; 6];

    fn from_words(words: &Self::Words) -> Self {
        let [a, b, c, d, e, f] = words.map(i);
        Self {
            edges: [[a, b, c], [d, e, f]],
        }
    }

    fn to_words(&self) -> Self::Words {
        let [[a, b, c], [d, e, f]] = self.edges;
        [a, b, c, d, e, f].map(w)
    }
}

impl<'a> Scene<'a> {
    /// How rays are cast.
    pub fn ray_settings(&self) -> RaySettings {
        let words = self.ray_settings.first();
        words.map_or(RaySettings::DEFAULT, RaySettings::from_words)
    }

    /// Whether it was baked for the ray caster: without, rays meet nothing.
    pub fn has_rays(&self) -> bool {
        !self.ray_settings.is_empty()
    }

    /// What rays meet of a mesh.
    pub fn shape(&self, mesh: u16) -> Shape {
        let words = self.shapes.get(usize::from(mesh));
        words.map_or(
            Shape::Triangles {
                first_node: 0,
                nodes: 0,
            },
            Shape::from_words,
        )
    }

    /// The nodes of all hierarchies from one on; see [`Node`].
    pub fn nodes_from(&self, first: u32) -> &'a [<Node as Record>::Words] {
        self.nodes.get(first as usize..).unwrap_or_default()
    }

    /// What a material does with rays.
    pub fn optics(&self, material: u16) -> Optics {
        let words = self.optics.get(usize::from(material));
        words.map_or(Optics::PLAIN, Optics::from_words)
    }

    /// A light's edges.
    pub fn light_area(&self, light: usize) -> LightArea {
        let words = self.light_areas.get(light);
        words.map_or(LightArea::POINT, LightArea::from_words)
    }

    /// The first meshlets of a mesh from one on.
    pub fn meshlets_of(&self, mesh: &Mesh) -> &'a [<super::Meshlet as Record>::Words] {
        let first = mesh.first_meshlet as usize;
        let all = self.meshlets.get(first..).unwrap_or_default();
        all.get(..mesh.meshlets as usize).unwrap_or_default()
    }

    /// Bytes that only the ray caster needs.
    pub fn ray_bytes(&self) -> usize {
        size_of_val(self.shapes) + size_of_val(self.nodes) + size_of_val(self.optics)
    }
}
