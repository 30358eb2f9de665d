//! The scene through `retrofire-core`.

use retrofire_core::geom::{Tri, Vertex, vertex};
use retrofire_core::math::mat::{Mat4, ProjMat3};
use retrofire_core::math::{Color4, Point3, pt3, rgba};
use retrofire_core::render::raster::Frag;
use retrofire_core::render::target::{Colorbuf, Framebuf};
use retrofire_core::render::{Context, Model as ModelSpace, Ndc, Screen, render, shader};
use retrofire_core::util::pixfmt::IntoPixel;
use retrofire_core::util::{Buf2, Dims};

use crate::Renderer;
use crate::model::{Model, rgb565};

/// What it needs.
#[derive(Debug)]
pub struct Retrofire<'a> {
    model: &'a Model,
    triangles: Vec<Tri<usize>>,
    vertices: Vec<Vertex<Point3<ModelSpace>, Attributes>>,
    colour: Buf2<u16>,
    depth: Buf2<f32>,
}

#[derive(Clone, Copy, Debug)]
struct Attributes {
    normal: [f32; 3],
    coordinates: [f32; 2],
}

/// RGB565, high byte first.
#[derive(Clone, Copy, Debug, Default)]
struct Panel;

impl IntoPixel<u16, Panel> for Color4 {
    #[inline(always)]
    fn into_pixel(self, _: Panel) -> u16 {
        let [r, g, b, _] = self.0;
        rgb565([r, g, b])
    }
}

impl<'a> Retrofire<'a> {
    /// Ready for the first frame.
    pub fn new(model: &'a Model) -> Self {
        let size = Dims(model.size[0] as u32, model.size[1] as u32);
        let vertices = model.positions.iter().zip(&model.normals).enumerate();
        Self {
            model,
            // With y downwards it culls what goes counter-clockwise.
            triangles: model
                .triangles
                .iter()
                .map(|[a, b, c]| Tri([*a, *c, *b]))
                .collect(),
            vertices: vertices
                .map(|(number, ([x, y, z], normal))| {
                    let coordinates = model.coordinates.get(number).copied();
                    let attributes = Attributes {
                        normal: *normal,
                        coordinates: coordinates.unwrap_or_default(),
                    };
                    vertex(pt3(*x, *y, *z), attributes)
                })
                .collect(),
            colour: Buf2::new(size),
            depth: Buf2::new(size),
        }
    }
}

/// What a frame's vertices need.
#[derive(Clone, Copy)]
struct Frame<'a> {
    model: &'a Model,
    to_clip: ProjMat3<ModelSpace>,
    towards: [f32; 3],
}

impl Renderer for Retrofire<'_> {
    fn name(&self) -> &'static str {
        "retrofire-core"
    }

    fn draw(&mut self, frame: u32) {
        let model = self.model;
        let to_world = model.to_world(frame);
        let to_clip = (model.to_clip() * to_world).transpose().to_cols_array_2d();
        let uniform = Frame {
            model,
            to_clip: ProjMat3::<ModelSpace>::new(to_clip),
            towards: model.light_in_mesh(&to_world),
        };
        let [width, height] = model.size.map(|side| side as f32 / 2.0);
        let to_screen: Mat4<Ndc, Screen> = Mat4::new([
            [width, 0.0, 0.0, width],
            [0.0, -height, 0.0, height],
            [0.0, 0.0, 1.0, 0.0],
            [0.0, 0.0, 0.0, 1.0],
        ]);
        self.colour.data_mut().fill(model.empty());
        self.depth.data_mut().fill(0.0);
        let mut target = Framebuf {
            color_buf: Colorbuf {
                buf: &mut self.colour,
                fmt: Panel,
            },
            depth_buf: &mut self.depth,
        };
        let context = Context::default();
        let (triangles, vertices) = (&self.triangles, &self.vertices);
        match &model.texture {
            None => {
                let shader = shader::new(
                    |v: Vertex<Point3<ModelSpace>, Attributes>, frame: Frame<'_>| {
                        let level = frame.model.light(v.attrib.normal, frame.towards);
                        vertex(frame.to_clip.apply(&v.pos), level)
                    },
                    |frag: Frag<f32>, frame: Frame<'_>| {
                        let [r, g, b] = frame.model.lit(frag.var);
                        rgba(r, g, b, 255)
                    },
                );
                render(
                    triangles,
                    vertices,
                    &shader,
                    uniform,
                    to_screen,
                    &mut target,
                    &context,
                );
            }
            Some((texels, [columns, rows])) => {
                let shader = shader::new(
                    |v: Vertex<Point3<ModelSpace>, Attributes>, frame: Frame<'_>| {
                        let level = frame.model.light(v.attrib.normal, frame.towards);
                        let [across, down] = v.attrib.coordinates;
                        vertex(frame.to_clip.apply(&v.pos), (across, (down, level)))
                    },
                    |frag: Frag<(f32, (f32, f32))>, _: Frame<'_>| {
                        let (across, (down, level)) = frag.var;
                        let x = ((across * *columns as f32) as usize).min(columns - 1);
                        let y = ((down * *rows as f32) as usize).min(rows - 1);
                        let [r, g, b] =
                            texels[y * columns + x].map(|c| (f32::from(c) * level) as u8);
                        rgba(r, g, b, 255)
                    },
                );
                render(
                    triangles,
                    vertices,
                    &shader,
                    uniform,
                    to_screen,
                    &mut target,
                    &context,
                );
            }
        }
    }

    fn pixels(&self) -> &[u16] {
        self.colour.data()
    }
}
