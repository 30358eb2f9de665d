//! The scene through `euc`.

use euc::buffer::Buffer2d;
use euc::{Pipeline, Target, rasterizer};
use glam::Mat4;

use crate::Renderer;
use crate::model::{Model, rgb565};

/// What it needs.
#[derive(Debug)]
pub struct Euc<'a> {
    model: &'a Model,
    indices: Vec<usize>,
    colour: Buffer2d<u16>,
    depth: Buffer2d<f32>,
}

struct Lit<'a> {
    model: &'a Model,
    to_clip: Mat4,
    towards: [f32; 3],
}

impl Lit<'_> {
    #[inline(always)]
    fn place(&self, index: usize) -> [f32; 4] {
        let at = self.model.positions[index];
        (self.to_clip * glam::Vec3::from(at).extend(1.0)).to_array()
    }

    #[inline(always)]
    fn light(&self, index: usize) -> f32 {
        self.model.light(self.model.normals[index], self.towards)
    }
}

struct Plain<'a>(Lit<'a>);

impl Pipeline for Plain<'_> {
    type Vertex = usize;
    type VsOut = f32;
    type Pixel = u16;

    #[inline(always)]
    fn vert(&self, index: &usize) -> ([f32; 4], f32) {
        (self.0.place(*index), self.0.light(*index))
    }

    #[inline(always)]
    fn frag(&self, level: &f32) -> u16 {
        rgb565(self.0.model.lit(*level))
    }
}

struct Textured<'a>(Lit<'a>, &'a [[u8; 3]], [usize; 2]);

impl Pipeline for Textured<'_> {
    type Vertex = usize;
    type VsOut = (f32, f32, f32);
    type Pixel = u16;

    #[inline(always)]
    fn vert(&self, index: &usize) -> ([f32; 4], (f32, f32, f32)) {
        let [u, v] = self.0.model.coordinates[*index];
        (self.0.place(*index), (u, v, self.0.light(*index)))
    }

    #[inline(always)]
    fn frag(&self, (u, v, level): &(f32, f32, f32)) -> u16 {
        let Self(_, texels, [width, height]) = self;
        let x = ((u * *width as f32) as usize).min(width - 1);
        let y = ((v * *height as f32) as usize).min(height - 1);
        rgb565(texels[y * width + x].map(|c| (f32::from(c) * level) as u8))
    }
}

impl<'a> Euc<'a> {
    /// Ready for the first frame.
    pub fn new(model: &'a Model) -> Self {
        Self {
            model,
            indices: model.triangles.iter().flatten().copied().collect(),
            colour: Buffer2d::new(model.size, 0),
            depth: Buffer2d::new(model.size, 1.0),
        }
    }
}

impl Renderer for Euc<'_> {
    fn name(&self) -> &'static str {
        "euc"
    }

    fn draw(&mut self, frame: u32) {
        let model = self.model;
        let to_world = model.to_world(frame);
        let lit = Lit {
            model,
            to_clip: model.to_clip() * to_world,
            towards: model.light_in_mesh(&to_world),
        };
        self.colour.clear(model.empty());
        self.depth.clear(1.0);
        let (colour, depth) = (&mut self.colour, Some(&mut self.depth));
        match &model.texture {
            Some((texels, size)) => Textured(lit, texels, *size)
                .draw::<rasterizer::Triangles<_>, _>(&self.indices, colour, depth),
            None => Plain(lit).draw::<rasterizer::Triangles<_>, _>(&self.indices, colour, depth),
        }
    }

    fn pixels(&self) -> &[u16] {
        self.colour.as_ref()
    }
}
