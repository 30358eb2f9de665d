//! How a rasterised frame's instructions grow with the mesh: the same picture from meshes of
//! 1,000 to 200,000 triangles, with all of them drawn and by level of detail.

use std::fs;

use fixel_scene::{Lod, Scene};
use serde_json::{Map, Value, json};

use crate::board::{self, Board};
use crate::measure::{ONE_BAND, Ready, Target};
use crate::problem::Result;
use crate::report::{Tally, table};
use crate::scaling::{BOARDS, ring, show};
use crate::{paths, readme, scene};

/// The mesh's columns and rows: two triangles each.
const SIZES: [[u32; 2]; 6] = [
    [25, 20],
    [50, 40],
    [100, 50],
    [150, 100],
    [250, 200],
    [500, 200],
];
/// The picture in which the mesh is shown, and its sides.
const PICTURE: &str = "w3_bunny_gouraud";
const SIDE: u32 = 240;
/// The frame that is drawn.
const FRAME: u32 = 2;
/// Most that 100,000 triangles take by level of detail, over what 4,000 take.
const MOST: f64 = 2.0;
/// Rows of [`SIZES`] that have so many.
const COMPARED: [usize; 2] = [1, 4];
/// What an emulated board's flash has room for.
const ROOM: u64 = 3 << 20;

/// Draws every size on both boards, with all triangles and by level of detail. Gives
/// `{"board": [{"triangles": n, "whole": {"scene_bytes": n, "instructions": n}, "levels":
/// {...}}]}`; a scene that has no room in the board's flash has no instructions.
pub fn run(tally: &mut Tally) -> Result<Value> {
    let mut all = Map::new();
    for name in BOARDS {
        let rows = on(board::find(name)?, tally)?;
        let [fewer, more] = COMPARED.map(|at| &rows[at]);
        let what = format!("level of detail on {name}");
        tally.check(&what, follows_pixels(fewer, more));
        all.insert(name.into(), rows.into());
    }
    Ok(all.into())
}

fn on(board: &'static Board, tally: &mut Tally) -> Result<Vec<Value>> {
    let ready = Target::Board(board).prepare()?;
    let mut rows = Vec::new();
    for size in SIZES {
        let mut shown = fixel_scene::load(&scene::file(PICTURE)).map_err(|e| e.to_string())?;
        // Without small waves, which 4,000 triangles cannot show as 100,000 do.
        show(&mut shown, ring(size, 0.0));
        (shown.display.width, shown.display.height) = (SIDE, SIDE);
        let mut row = json!({ "triangles": shown.meshes[0].triangles.len() });
        for (name, lod) in [("whole", None), ("levels", Some(Lod::default()))] {
            shown.lod = lod;
            let what = format!("{} triangles, {name}, on {}", row["triangles"], board.name);
            let measured = measure(&ready, &shown, name);
            row[name] = tally.check(&what, measured).unwrap_or_default();
        }
        rows.push(row);
    }
    Ok(rows)
}

fn measure(ready: &Ready, shown: &Scene, name: &str) -> Result<Value> {
    let blob = fixel_bake::bake(shown).map_err(|e| e.to_string())?;
    let bytes = blob.bytes().len() as u64;
    if bytes > ROOM {
        return Ok(json!({ "scene_bytes": bytes }));
    }
    let path = paths::work("scenes")?.join(format!("ring_{name}_{bytes}.fxl"));
    fs::write(&path, blob.bytes()).map_err(|e| format!("{}: {e}", path.display()))?;
    let baked = scene::Baked { path, bytes };
    let frames = ready.frames(&baked, FRAME..FRAME + 1, ONE_BAND, None)?;
    Ok(json!({ "scene_bytes": bytes, "instructions": frames[0].count }))
}

fn follows_pixels(fewer: &Value, more: &Value) -> Result<()> {
    let instructions = |row: &Value| row["levels"]["instructions"].as_f64();
    let (Some(less), Some(now)) = (instructions(fewer), instructions(more)) else {
        return Err("it was not drawn".into());
    };
    if now > MOST * less {
        return Err(format!(
            "{now:.0} instructions with {} triangles, {less:.0} with {}",
            more["triangles"], fewer["triangles"]
        )
        .into());
    }
    Ok(())
}

/// The figures as a table.
pub fn markdown(figures: &Value) -> String {
    let bytes = |value: &Value| value["scene_bytes"].to_string();
    let millions = |value: &Value| {
        let count = value["instructions"].as_f64();
        count.map_or("-".into(), |count| format!("{:.2}", count / 1e6))
    };
    let rows = (0..SIZES.len()).map(|at| {
        let rows = BOARDS.map(|board| &figures[board][at]);
        let [whole, levels] = ["whole", "levels"].map(|way| bytes(&rows[0][way]));
        let mut cells = vec![rows[0]["triangles"].to_string(), whole, levels];
        let ways = rows
            .into_iter()
            .flat_map(|row| [&row["whole"], &row["levels"]]);
        cells.extend(ways.map(millions));
        cells
    });
    let head = [
        "triangles",
        "scene, bytes",
        "with levels",
        "M4F",
        "M4F, levels",
        "M0+",
        "M0+, levels",
    ];
    format!(
        "Millions of instructions of a frame of {SIDE}x{SIDE}, one band, with all triangles and by \
         level of detail (`[lod]`, one pixel); `cargo xtask scaling`.\n\n{}",
        table(&head, &rows.collect::<Vec<_>>())
    )
}

/// Writes the table into docs/performance.md.
pub fn write(figures: &Value) -> Result<()> {
    let path = paths::root().join("docs/performance.md");
    let fail = |error| format!("{}: {error}", path.display());
    let text = fs::read_to_string(&path).map_err(fail)?;
    let text = readme::replaced(&text, "levels", &markdown(figures))?;
    Ok(fs::write(&path, text).map_err(fail)?)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn growth_is_found() {
        let row = |instructions: u64| json!({ "levels": { "instructions": instructions } });
        assert!(follows_pixels(&row(1000), &row(1900)).is_ok());
        assert!(follows_pixels(&row(1000), &row(2100)).is_err());
        assert!(follows_pixels(&row(1000), &json!({})).is_err());
    }
}
