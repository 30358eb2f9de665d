//! The scene through `embedded-3dgfx`.

use std::convert::Infallible;

use embedded_3dgfx::engine::K3dengine;
use embedded_3dgfx::pipeline::command_buffer::CommandBuffer;
use embedded_3dgfx::pipeline::rasterize::texture::{Texture, TextureManager};
use embedded_3dgfx::pipeline::renderer::FrameCtx;
use embedded_3dgfx::pipeline::vertex::mesh::{Geometry, K3dMesh, RenderMode};
use embedded_3dgfx::{Z_MAX_VALUE, ZDepth};
use embedded_graphics_core::geometry::{OriginDimensions, Size};
use embedded_graphics_core::pixelcolor::{IntoStorage, Rgb565};
use embedded_graphics_core::prelude::{DrawTarget, Pixel, PixelColor};
use embedded_graphics_core::primitives::Rectangle;
use nalgebra::{Point3, UnitQuaternion, Vector3};

use crate::Renderer;
use crate::model::Model;

/// Triangles that are recorded in a frame: all of the bunny's.
const COMMANDS: usize = 4096;

/// What it needs.
pub struct Embedded<'a> {
    model: &'a Model,
    engine: K3dengine,
    commands: Box<CommandBuffer<COMMANDS>>,
    textures: TextureManager<1>,
    texture: Option<u32>,
    depths: Vec<ZDepth>,
    frame: Picture,
}

/// A frame that takes spans and rectangles at once, in the panel's byte order.
#[derive(Debug)]
struct Picture {
    pixels: Vec<u16>,
    size: [usize; 2],
}

fn stored<C: PixelColor + IntoStorage<Storage = u16>>(colour: C) -> u16 {
    colour.into_storage().to_be()
}

impl OriginDimensions for Picture {
    fn size(&self) -> Size {
        let [width, height] = self.size;
        Size::new(width as u32, height as u32)
    }
}

impl DrawTarget for Picture {
    type Color = Rgb565;
    type Error = Infallible;

    #[inline(always)]
    fn draw_iter<I: IntoIterator<Item = Pixel<Rgb565>>>(
        &mut self,
        pixels: I,
    ) -> Result<(), Infallible> {
        let [width, height] = self.size;
        for Pixel(at, colour) in pixels {
            let (x, y) = (at.x as usize, at.y as usize);
            if x < width && y < height {
                self.pixels[y * width + x] = stored(colour);
            }
        }
        Ok(())
    }

    #[inline(always)]
    fn fill_contiguous<I: IntoIterator<Item = Rgb565>>(
        &mut self,
        area: &Rectangle,
        colours: I,
    ) -> Result<(), Infallible> {
        let mut colours = colours.into_iter();
        let [width, height] = self.size.map(|side| side as i32);
        let left = area.top_left.x;
        let right = left + area.size.width as i32;
        let top = area.top_left.y;
        for y in top..top + area.size.height as i32 {
            let inside = (0..height).contains(&y) && left >= 0 && right <= width;
            if inside {
                let start = (y * width) as usize;
                let row = &mut self.pixels[start + left as usize..start + right as usize];
                for pixel in row {
                    let Some(colour) = colours.next() else {
                        return Ok(());
                    };
                    *pixel = stored(colour);
                }
                continue;
            }
            for x in left..right {
                let Some(colour) = colours.next() else {
                    return Ok(());
                };
                if (0..height).contains(&y) && (0..width).contains(&x) {
                    self.pixels[(y * width + x) as usize] = stored(colour);
                }
            }
        }
        Ok(())
    }

    #[inline(always)]
    fn fill_solid(&mut self, area: &Rectangle, colour: Rgb565) -> Result<(), Infallible> {
        let [width, height] = self.size.map(|side| side as i32);
        let left = area.top_left.x.clamp(0, width);
        let right = (area.top_left.x + area.size.width as i32).clamp(left, width);
        let top = area.top_left.y.clamp(0, height);
        let end = (area.top_left.y + area.size.height as i32).clamp(top, height);
        for y in top..end {
            let start = (y * width) as usize;
            self.pixels[start + left as usize..start + right as usize].fill(stored(colour));
        }
        Ok(())
    }

    fn clear(&mut self, colour: Rgb565) -> Result<(), Infallible> {
        self.pixels.fill(stored(colour));
        Ok(())
    }
}

impl<'a> Embedded<'a> {
    /// Ready for the first frame.
    ///
    /// # Errors
    /// If the texture does not suit it.
    pub fn new(model: &'a Model) -> Result<Self, String> {
        let [width, height] = model.size;
        let mut engine = K3dengine::new(width as u16, height as u16);
        let (eye, focal_point, angle) = model.camera;
        engine.camera.set_position(Point3::from(eye));
        engine.camera.set_target(Point3::from(focal_point));
        engine.camera.set_fovy(angle);
        let [near, far] = model.range;
        engine.camera.set_near_far(near, far);
        let mut textures = TextureManager::<1>::new();
        let texture = match &model.texture {
            Some((texels, [width, height])) => {
                let colour = |[r, g, b]: &[u8; 3]| Rgb565::new(r >> 3, g >> 2, b >> 3);
                let texels: Vec<Rgb565> = texels.iter().map(colour).collect();
                let texture = Texture::new(texels.leak(), *width as u32, *height as u32);
                Some(
                    textures
                        .add_texture(texture)
                        .ok_or("no room for a texture")?,
                )
            }
            None => None,
        };
        Ok(Self {
            model,
            engine,
            commands: Box::new(CommandBuffer::new()),
            textures,
            texture,
            depths: vec![Z_MAX_VALUE; width * height],
            frame: Picture {
                pixels: vec![0; width * height],
                size: model.size,
            },
        })
    }
}

impl Renderer for Embedded<'_> {
    fn name(&self) -> &'static str {
        "embedded-3dgfx"
    }

    fn draw(&mut self, frame: u32) {
        let model = self.model;
        let (_, turned, moved) = model.to_world(frame).to_scale_rotation_translation();
        // It turns the sign of z over.
        let [x, y, z] = model.towards;
        let towards = Vector3::new(x, y, -z);
        let mode = match (self.texture, model.is_flat) {
            (Some(_), _) => RenderMode::TexturedGouraud(towards),
            (None, true) => RenderMode::SolidLightDir(towards),
            (None, false) => RenderMode::GouraudLightDir(towards),
        };
        let by_face = model.is_flat && self.texture.is_none();
        let mut mesh = K3dMesh::new(Geometry {
            vertices: &model.positions,
            faces: &model.triangles,
            normals: &model.face_normals,
            vertex_normals: if by_face { &[] } else { &model.normals },
            uvs: &model.coordinates,
            texture_id: self.texture,
            ..Geometry::default()
        });
        mesh.set_render_mode(mode);
        let [r, g, b] = model.colour.map(|c| (c * 255.0) as u8);
        mesh.set_color(Rgb565::new(r >> 3, g >> 2, b >> 3));
        let [x, y, z, w] = turned.to_array();
        mesh.set_rotation(UnitQuaternion::from_quaternion(nalgebra::Quaternion::new(
            w, x, y, z,
        )));
        mesh.set_position(moved.x, moved.y, moved.z);
        let [r, g, b] = model.background;
        let Ok(()) = self.frame.clear(Rgb565::new(r >> 3, g >> 2, b >> 3));
        self.depths.fill(Z_MAX_VALUE);
        self.commands.clear();
        let recorded = self
            .engine
            .record(std::iter::once(&mesh), &mut self.commands, None);
        let mut context = FrameCtx {
            zbuffer: &mut self.depths,
            width: model.size[0],
            height: model.size[1],
        };
        let (frame, commands) = (&mut self.frame, &self.commands);
        let drawn = match self.texture {
            Some(_) => {
                let textures = &self.textures;
                let engine = &self.engine;
                engine.execute_with_textures(frame, &mut context, commands, textures, None)
            }
            None => self.engine.execute(frame, &mut context, commands, None),
        };
        assert!(recorded.is_ok() && drawn.is_ok(), "{recorded:?} {drawn:?}");
    }

    fn pixels(&self) -> &[u16] {
        &self.frame.pixels
    }
}
