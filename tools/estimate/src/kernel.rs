//! How an actor's triangles are drawn, as its material has it.

use fixel::Scene;
use fixel::math::Scaled;
use fixel::scene::{DitherPattern, LightKind, Look, Shading, Transparency};
use fixel::shade::{Attributes, Lighting};

use crate::seen::Seen;
use crate::term::{Term, Work};

/// What of an actor decides on its work.
#[derive(Clone, Debug)]
pub(crate) struct Kernel {
    /// How its pixels are made.
    pub way: Way,
    /// Whether light at its vertices is in grey from infinitely far, or everything.
    pub vertices: AtVertices,
    /// Whether its mesh has finer positions.
    pub fine: bool,
    pub lights: Lights,
    /// Whether its vertices have colours of their own.
    pub tinted: bool,
    pub look: Option<Look>,
    pub coloured: bool,
}

/// How pixels are made.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Way {
    /// One index a triangle.
    Flat { plain: bool },
    /// A level a corner.
    Gouraud,
    /// Any few attributes.
    Surface(Surface),
}

#[derive(Clone, Copy, Debug)]
pub(crate) struct Surface {
    pub attributes: f64,
    pub lighting: Lighting,
    pub textured: bool,
    pub bilinear: bool,
    /// Whether there are smaller copies.
    pub copies: bool,
    pub cut_out: bool,
    pub coloured: bool,
    pub dithered: bool,
    pub blended: bool,
    /// Whether fog lies before it, if it is blended.
    pub fogged: bool,
    pub door: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum AtVertices {
    Nothing,
    Plain,
    Everything,
}

/// The scene's lights, by what they take.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Lights {
    pub directional: f64,
    pub placed: f64,
    pub falling: f64,
    pub cones: f64,
    /// Highlights of all of them, if the material has some.
    pub gloss: f64,
}

impl Lights {
    pub fn count(&self) -> f64 {
        self.directional + self.placed
    }

    /// Counts so many places that are lit by all that there is.
    pub fn shine(&self, work: &mut Work, what: Term, places: f64, tinted: bool) {
        work.add(what, places);
        work.add(Term::LitDirectional, places * self.directional);
        work.add(Term::LitPlaced, places * self.placed);
        work.add(Term::LitFalling, places * self.falling);
        work.add(Term::LitCone, places * self.cones);
        work.add(Term::LitTint, places * f64::from(u8::from(tinted)));
        work.add(Term::LitGloss, places * self.gloss);
    }
}

impl Kernel {
    pub fn of(scene: &Scene<'_>, number: u16) -> Self {
        let actor = scene.actor(number);
        let (material, mesh) = (scene.material(actor.material), scene.mesh(actor.mesh));
        let tinted = mesh.colours.is_some();
        let attributes = Attributes::new(&material, tinted);
        let texture = material.texture.and_then(|t| scene.texture(t));
        let mut lights = Lights::default();
        for light in scene.lights() {
            match light.kind {
                LightKind::Directional => lights.directional += 1.0,
                LightKind::Point => lights.placed += 1.0,
                LightKind::Spot => {
                    lights.placed += 1.0;
                    lights.cones += 1.0;
                }
            }
            let [_, linear, quadratic] = light.attenuation;
            if light.kind != LightKind::Directional
                && [linear, quadratic].iter().any(|part| *part != Scaled::ZERO)
            {
                lights.falling += 1.0;
            }
        }
        if material.channels.specular != [0; 3] {
            lights.gloss = lights.count();
        }
        let blended = matches!(material.transparency, Transparency::Blend { .. });
        let door = matches!(material.transparency, Transparency::ScreenDoor { .. });
        let opaque = material.transparency == Transparency::Opaque;
        let face = attributes.lighting == Lighting::Face;
        let way = if !material.is_surface() {
            match material.shading {
                Shading::Flat => Way::Flat { plain: true },
                _ => Way::Gouraud,
            }
        } else if face && !material.coloured && texture.is_none() && opaque {
            Way::Flat { plain: false }
        } else {
            Way::Surface(Surface {
                attributes: attributes.count() as f64,
                lighting: attributes.lighting,
                textured: attributes.textured,
                bilinear: texture.is_some_and(|texture| texture.bilinear),
                copies: texture.is_some_and(|texture| texture.copies > 1),
                cut_out: texture.is_some_and(|texture| texture.cut_out),
                coloured: material.coloured,
                dithered: material.coloured && scene.dither().pattern != DitherPattern::None,
                blended,
                fogged: scene.fog().is_some(),
                door,
            })
        };
        let vertices = match material.shading {
            Shading::Gouraud if material.full => AtVertices::Everything,
            Shading::Gouraud => AtVertices::Plain,
            _ => AtVertices::Nothing,
        };
        Self {
            way,
            vertices,
            fine: mesh.fine.is_some(),
            lights,
            tinted,
            look: scene.look(number),
            coloured: material.coloured,
        }
    }
}

impl Surface {
    /// Whether kernels of texels by level draw it.
    pub fn is_texels(&self) -> bool {
        self.textured && !self.coloured && !self.blended && !self.door
    }

    /// How many of a triangle's pixels are shown: what is mixed changes no depth.
    pub fn shown(&self, seen: &Seen) -> f64 {
        if self.blended { seen.px } else { seen.in_front }
    }

    /// Whether light is worked out where it is drawn, by the meshlet's own lights.
    pub fn lit_here(&self) -> bool {
        matches!(self.lighting, Lighting::Face | Lighting::Pixel)
            || self.textured && self.lighting == Lighting::Colour
    }
}
