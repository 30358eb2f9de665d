//! How an actor is drawn: as a surface, or by its lines or its points.

/// What of an actor is drawn, and how.
#[derive(Clone, Debug, PartialEq)]
pub struct Look {
    /// Which part of the mesh.
    pub representation: Representation,
    /// What lies behind something else is hidden. If not, lines and points are
    /// drawn over everything, in the file's order.
    pub depth_test: bool,
    /// Added to the depth of lines and points, in units of the 16-bit depth
    /// buffer, 0..=1000: what lies on a surface is not hidden by it.
    pub bias: u32,
    /// Width of lines in pixels, 1..=16.
    pub line_width: u32,
    /// What is drawn at a point.
    pub mark: Mark,
    /// What the mesh's positions mean.
    pub space: Space,
}

impl Default for Look {
    fn default() -> Self {
        Self {
            representation: Representation::Surface,
            depth_test: true,
            bias: 0,
            line_width: 1,
            mark: Mark::Shape {
                shape: Shape::Square,
                size: 2,
            },
            space: Space::World,
        }
    }
}

/// Which part of a mesh is drawn. Lines and points are lit at the vertices,
/// by their normals, and seen from all sides, whatever the material's
/// `shading` and `cull`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Representation {
    /// Its triangles.
    Surface,
    /// Its [edges](crate::Mesh::edges).
    Wireframe,
    /// Its edges, hidden by its own triangles and those of others: the
    /// triangles, seen from both sides, show the background. They lie deeper
    /// than they are by `(|dz/dx| + |dz/dy|) * line_width / 2 + 1` depth units
    /// (the slopes a pixel), but by no more than the range of depths of the
    /// triangle's corners and 1, so that they do not hide their own edges.
    HiddenLine,
    /// Its vertices, each as a [`Mark`].
    Points,
}

/// What a mesh's positions mean.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Space {
    /// Places in model space.
    World,
    /// Pixels from the picture's top left corner: x to the right, y down, z
    /// not used. Pixel (0, 0) has its centre at 0.5, 0.5. Nearer than all that
    /// has depth; neither the camera nor the actor's placement matters.
    Screen,
}

/// What is drawn at a point: some pixels around it.
#[derive(Clone, Debug, PartialEq)]
pub enum Mark {
    /// A shape in a square of `size` x `size` pixels, whose first column is
    /// `floor(x - size / 2 + 1 / 2)` and whose first row the same of y.
    Shape {
        /// Which.
        shape: Shape,
        /// 1..=32 pixels.
        size: u32,
    },
    /// Letters.
    Text {
        /// The string; lines are divided by line feeds.
        text: String,
        /// The letters' size.
        font: Font,
        /// What part of the text's box is at the point.
        anchor: Anchor,
    },
    /// Single bits, as a baked scene has them.
    Bitmap {
        /// Columns and rows.
        size: [u16; 2],
        /// From the point to the first column and row, in half pixels.
        offset: [i16; 2],
        /// Rows from the top, each from a byte's highest bit on.
        rows: Vec<u8>,
    },
}

/// A marker's shape. With `u` and `v` from -(size - 1) to size - 1 in steps of
/// 2 across and down the square, so that its middle is 0, and a stroke of
/// `t = max(1, size / 5)` pixels (rounded down), a pixel belongs to
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// the filled disc: `u^2 + v^2 < size^2`.
    Dot,
    /// the filled square: always.
    Square,
    /// the upright cross: `|u| <= t` or `|v| <= t`.
    Plus,
    /// the slanting cross: `||u| - |v|| <= t`.
    Cross,
    /// the ring: `(size - 2t)^2 <= u^2 + v^2 < size^2`.
    Circle,
    /// the filled diamond: `|u| + |v| <= size - 1`.
    Diamond,
    /// the filled triangle, a corner up: `2 |u| <= v + size`.
    Triangle,
}

/// One of embedded-graphics' fonts (ISO 8859-1).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Font {
    /// 4 x 6 pixels a letter.
    F4x6,
    /// 5 x 8.
    F5x8,
    /// 6 x 10.
    F6x10,
    /// 7 x 13.
    F7x13,
    /// 9 x 15.
    F9x15,
    /// 10 x 20.
    F10x20,
}

/// A text's box (its lines' width and height, every letter with its spacing)
/// against its point: the column of the box that is in the point's pixel, and
/// the row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Anchor {
    /// The first column, the column `width / 2` (rounded down), or one past
    /// the last.
    pub horizontal: Side,
    /// The same of rows, from the top.
    pub vertical: Side,
}

/// A place along a length.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// Left or top.
    Start,
    /// In the middle.
    Middle,
    /// Right or bottom.
    End,
}
