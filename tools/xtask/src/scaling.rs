//! How instructions grow with the mesh: the same picture from meshes of 1,000 to 100,000
//! triangles, by rays; by triangles see [`crate::scaling_levels`].

use std::f64::consts::TAU;

use fixel_scene::{Mesh, Scene};
use serde_json::{Map, Value, json};

use crate::board::{self, Board};
use crate::measure::{ONE_BAND, Target};
use crate::problem::Result;
use crate::report::{Tally, table};
use crate::{scaling_levels, scene};

/// Boards that are measured.
pub const BOARDS: [&str; 2] = ["cortex-m4f", "cortex-m0plus"];
/// The mesh's columns and rows: two triangles each.
const SIZES: [[u32; 2]; 5] = [[25, 20], [50, 40], [100, 50], [150, 100], [250, 200]];
/// The picture in which the mesh is shown: rays of the eye alone.
const PICTURE: &str = "r1_bunny_rays";
/// The frame that is drawn.
const FRAME: u32 = 2;
/// Most that a larger mesh takes, over what the smaller one that it is compared with takes.
const MOST: f64 = 2.0;

/// Draws every size on both boards. Gives `{"board": [{"triangles": n, "scene_bytes": n,
/// "rays": n, "instructions": n}]}`. Ten times the triangles are held to twice the
/// instructions a ray. And `"levels"`, what [`crate::scaling_levels`] gives.
pub fn run(tally: &mut Tally) -> Result<Value> {
    let mut all = Map::new();
    for name in BOARDS {
        let rows = on(board::find(name)?, tally)?;
        for (fewer, more) in [(0, 2), (2, 4)] {
            let what = format!("ten times the triangles on {name}");
            let grown = grows_slowly([&rows[fewer], &rows[more]], a_ray, "instructions a ray");
            tally.check(&what, grown);
        }
        all.insert(name.into(), rows.into());
    }
    all.insert("levels".into(), scaling_levels::run(tally)?);
    Ok(all.into())
}

fn on(board: &'static Board, tally: &mut Tally) -> Result<Vec<Value>> {
    let ready = Target::Board(board).prepare()?;
    let mut rows = Vec::new();
    for size in SIZES {
        let mut shown = fixel_scene::load(&scene::file(PICTURE)).map_err(|e| e.to_string())?;
        show(&mut shown, ring(size, 0.06));
        let triangles = shown.meshes[0].triangles.len();
        let blob = fixel_bake::bake_for_rays(&shown).map_err(|e| e.to_string())?;
        let baked = scene::Baked::keep("scenes", &format!("ring_{triangles}"), &blob)?;
        let frames = ready.frames(&baked, FRAME..FRAME + 1, ONE_BAND, None);
        let what = format!("{triangles} triangles on {}", board.name);
        let Some(frames) = tally.check(&what, frames) else {
            rows.push(json!({ "triangles": triangles }));
            continue;
        };
        rows.push(json!({
            "triangles": triangles,
            "scene_bytes": baked.bytes,
            "rays": u64::from(frames[0].width) * u64::from(frames[0].height),
            "instructions": frames[0].count,
        }));
    }
    Ok(rows)
}

/// Puts a mesh in the place of the scene's.
pub fn show(scene: &mut Scene, mesh: Mesh) {
    scene.meshes = vec![mesh];
    scene.actors.truncate(1);
    let actor = &mut scene.actors[0];
    (actor.origin, actor.position) = ([0.0; 3], [0.0; 3]);
}

/// A ring with waves of two sizes on it, so that it is nowhere flat and hides parts of
/// itself; the small ones are `fine` high.
pub fn ring([columns, rows]: [u32; 2], fine: f64) -> Mesh {
    let (mut positions, mut normals, mut triangles) = (Vec::new(), Vec::new(), Vec::new());
    for column in 0..columns {
        for row in 0..rows {
            let (a, b) = (
                TAU * f64::from(column) / f64::from(columns),
                TAU * f64::from(row) / f64::from(rows),
            );
            let thick = 1.7 + 0.25 * (5.0 * a).sin() * (3.0 * b).cos() + fine * (23.0 * a).sin();
            let out = [b.cos() * a.cos(), b.sin(), b.cos() * a.sin()];
            let middle = [3.4 * a.cos(), 0.0, 3.4 * a.sin()];
            positions.push([0, 1, 2].map(|i| middle[i] + thick * out[i]));
            normals.push(out);
            let at = |c: u32, r: u32| (c % columns) * rows + r % rows;
            let (here, right) = (at(column, row), at(column + 1, row));
            let (above, across) = (at(column, row + 1), at(column + 1, row + 1));
            triangles.extend([[here, above, across], [here, across, right]]);
        }
    }
    Mesh {
        name: "ring".into(),
        positions,
        normals,
        colours: Vec::new(),
        texture_coordinates: Vec::new(),
        triangles,
        edges: Vec::new(),
        primitive: None,
    }
}

fn a_ray(row: &Value) -> Option<f64> {
    Some(row["instructions"].as_f64()? / row["rays"].as_f64()?)
}

/// Holds the rows of two meshes, the smaller first, to [`MOST`]: what `taken` says of each,
/// in `unit`.
pub fn grows_slowly(
    [fewer, more]: [&Value; 2],
    taken: impl Fn(&Value) -> Option<f64>,
    unit: &str,
) -> Result<()> {
    let (Some(less), Some(now)) = (taken(fewer), taken(more)) else {
        return Err("it was not drawn".into());
    };
    if now > MOST * less {
        return Err(format!(
            "{now:.0} {unit} with {} triangles, {less:.0} with {}",
            more["triangles"], fewer["triangles"]
        )
        .into());
    }
    Ok(())
}

/// The figures as a table.
pub fn markdown(figures: &Value) -> String {
    let number = |value: Option<f64>| value.map_or("-".into(), |value| format!("{value:.0}"));
    let rows = (0..SIZES.len()).map(|at| {
        let rows = BOARDS.map(|board| &figures[board][at]);
        let mut cells = vec![
            rows[0]["triangles"].to_string(),
            number(rows[0]["scene_bytes"].as_f64()),
        ];
        cells.extend(rows.map(|row| number(a_ray(row))));
        cells
    });
    let head = ["triangles", "scene, bytes", "M4F", "M0+"];
    format!(
        "Instructions a ray, 76,800 rays of the eye, one band; `cargo xtask scaling`.\n\n{}\n{}",
        table(&head, &rows.collect::<Vec<_>>()),
        scaling_levels::markdown(&figures["levels"])
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn growth_is_found() {
        let row = |instructions: u64| json!({ "rays": 10, "instructions": instructions });
        let grows = |more: Value| grows_slowly([&row(1000), &more], a_ray, "instructions a ray");
        assert!(grows(row(1900)).is_ok());
        assert!(grows(row(2100)).is_err());
        assert!(grows(json!({})).is_err());
    }

    #[test]
    fn a_ring_has_the_triangles_and_faces_outward() {
        let ring = ring([25, 20], 0.06);
        assert_eq!(ring.triangles.len(), 1000);
        let [a, b, c] = ring.triangles[0].map(|i| ring.positions[i as usize]);
        let side = |to: [f64; 3]| [0, 1, 2].map(|i| to[i] - a[i]);
        let ([ux, uy, uz], [vx, vy, vz]) = (side(b), side(c));
        let across = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
        let outward: f64 = across.iter().zip(ring.normals[0]).map(|(c, n)| c * n).sum();
        assert!(outward > 0.0);
    }
}
