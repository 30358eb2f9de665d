//! What is in a baked scene.

use anyhow::Result;
use fixel::Scene;
use fixel::math::SUBPX_BITS;
use fixel::scene::Mesh;
use fixel_bake::Baked;
use fixel_scene::Disk;
use serde_json::{Map, Value, json};
use std::path::Path;

/// Reads a `.fxl` file and checks it.
pub fn read(path: &Path) -> Result<Baked> {
    Ok(Baked::read(path, &Disk)?)
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
    let levels = levels(&scene);
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
        (
            "level_error_px",
            json!(f64::from(header.level_error) / f64::from(1 << SUBPX_BITS)),
        ),
        ("levels", json!(levels)),
    ];
    Ok(fields
        .into_iter()
        .map(|(name, value)| (name.to_owned(), value))
        .collect())
}

/// For each mesh that has levels of detail, the triangles of each, and how far it is off the
/// mesh in percent of the mesh's diameter.
fn levels(scene: &Scene<'_>) -> Vec<String> {
    let says = |mesh: Mesh| {
        let meshlets = mesh.first_meshlet..mesh.first_meshlet + mesh.meshlets;
        let triangles = meshlets.filter_map(|number| scene.meshlet(number));
        let triangles: u32 = triangles.map(|m| u32::from(m.triangles)).sum();
        let percent = f64::from(mesh.error) / f64::from(2 * mesh.radius) * 100.0;
        format!("{triangles} ({percent:.2} %)")
    };
    let chain = |number: u16| {
        let (first, levels) = scene.mesh(number).levels;
        let all = std::iter::once(number).chain(first..first + u16::from(levels));
        let all: Vec<String> = all.map(|number| says(scene.mesh(number))).collect();
        (levels != 0).then(|| format!("mesh {number}: {}", all.join(", ")))
    };
    (0..scene.mesh_count()).filter_map(chain).collect()
}
