//! Baked scenes: making one, and saying what is in one.

use anyhow::{Context, Result, anyhow};
use fixel_bake::Baked;
use serde_json::{Map, Value, json};
use std::path::Path;

use crate::input::Input;

/// What a user may ask for beyond the scene itself.
#[derive(Clone, Copy, Debug)]
pub struct Options {
    /// Simplify each mesh to at most this many triangles.
    pub max_triangles: Option<u32>,
    /// With what the ray caster needs.
    pub ray: bool,
}

/// The bytes of a `.fxl` file.
pub fn bake(input: Input, options: Options) -> Result<Vec<u8>> {
    if let Some(most) = options.max_triangles {
        let larger = input
            .scene
            .meshes
            .iter()
            .find(|m| m.triangles.len() > most as usize);
        if let Some(mesh) = larger {
            let found = mesh.triangles.len();
            return Err(input.refused(&format!(
                "`{}` has {found} triangles; simplifying meshes is not there yet",
                mesh.name
            )));
        }
    }
    let baked = if options.ray {
        input.bake_for_rays()?
    } else {
        input.bake()?
    };
    Ok(baked.bytes().to_vec())
}

/// Reads a `.fxl` file and checks it.
pub fn read(path: &Path) -> Result<Baked> {
    let name = path.display();
    let bytes = std::fs::read(path).with_context(|| name.to_string())?;
    Baked::from_bytes(&bytes)
        .map_err(|error| anyhow!("{name}: {error}; expected a file made by fixel bake"))
}

/// Says what is in a baked scene, in the order to print.
pub fn describe(baked: &Baked) -> Result<Map<String, Value>> {
    let bytes = baked.bytes();
    let scene = baked.scene()?;
    let header = scene.header();
    let triangles = scene.triangle_count();
    let mesh_bytes = scene.mesh_bytes();
    let each = |bytes: usize| bytes as f64 / triangles.max(1) as f64;
    let projection = if header.camera.projection == 0 {
        "perspective"
    } else {
        "parallel"
    };
    let fields = [
        ("bytes", json!(bytes.len())),
        ("version", json!(fixel::scene::layout::VERSION)),
        ("checksum", json!(format!("{:#010x}", header.checksum))),
        (
            "display",
            json!(format!("{}x{}", scene.width(), scene.height())),
        ),
        (
            "colour",
            json!(format!("{:?}", scene.colour_format()).to_lowercase()),
        ),
        ("direct", json!(scene.is_direct())),
        ("palette_colours", json!(scene.palette().len())),
        ("projection", json!(projection)),
        ("world_exponent", json!(scene.world_exponent())),
        ("turntable_frames", json!(header.turntable)),
        ("lights", json!(scene.lights().len())),
        ("materials", json!(scene.material_count())),
        ("actors", json!(scene.actor_count())),
        ("meshes", json!(scene.mesh_count())),
        ("meshlets", json!(scene.meshlet_count())),
        ("vertices", json!(scene.vertex_count())),
        ("triangles", json!(triangles)),
        ("mesh_bytes", json!(mesh_bytes)),
        (
            "mesh_bytes_a_triangle",
            json!((each(mesh_bytes) * 100.0).round() / 100.0),
        ),
    ];
    Ok(fields
        .into_iter()
        .map(|(name, value)| (name.to_owned(), value))
        .collect())
}
