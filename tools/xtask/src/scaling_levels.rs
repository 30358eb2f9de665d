//! How a rasterised frame's instructions grow with the mesh: the same picture from meshes of
//! 1,000 to 200,000 triangles, with all of them drawn and by level of detail.

use fixel_scene::{Lod, Scene};
use serde_json::{Map, Value, json};

use crate::board::{self, Board};
use crate::measure::{ONE_BAND, Ready, Target};
use crate::problem::Result;
use crate::report::{Tally, table};
use crate::scaling::{BOARDS, grows_slowly, ring, show};
use crate::{readme, scene};

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
/// Rows of [`SIZES`] that are compared: by level of detail, 100,000 triangles are to take
/// little more than 4,000.
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
        let compared = COMPARED.map(|at| &rows[at]);
        let what = format!("level of detail on {name}");
        tally.check(&what, grows_slowly(compared, with_levels, "instructions"));
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
    let baked = scene::Baked::keep("scenes", &format!("ring_{name}_{bytes}"), &blob)?;
    let frames = ready.frames(&baked, FRAME..FRAME + 1, ONE_BAND, None)?;
    Ok(json!({ "scene_bytes": bytes, "instructions": frames[0].count }))
}

fn with_levels(row: &Value) -> Option<f64> {
    row["levels"]["instructions"].as_f64()
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
    readme::replace("docs/performance.md", "levels", &markdown(figures))
}
