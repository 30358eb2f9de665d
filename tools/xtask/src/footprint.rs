//! What a minimal firmware takes, and whether it keeps its promises: with flat
//! shading alone, with Gouraud shading, and with everything.

use serde_json::{Map, Value, json};

use crate::board::{self, BOARDS, Board};
use crate::firmware::Parts;
use crate::problem::Result;
use crate::report::{Tally, table};
use crate::{elf, emulator, firmware, measure, parallel, scene};

/// Most static RAM and stack of the Cortex-M0+ demo, in bytes.
const RAM_LIMIT: u64 = 32 * 1024;
/// The same with everything but rays linked, where the stack does not hold a surface's
/// lights.
const ALL_TRIANGLES_RAM_LIMIT: u64 = 36 * 1024;
/// The same with rays alone and a band of 4 rows, in the scene that takes the most stack.
const RAYS_RAM_LIMIT: u64 = 19 * 1024;
/// The RAM of a small chip, stack included.
const CHIP_RAM: u64 = 20 * 1024;
/// The board that limits hold for.
const LIMITED: &str = "cortex-m0plus";
/// How much the stack may differ between two meshes, in bytes: static RAM may
/// not differ at all.
const STACK_SLACK: u64 = 256;

/// A demo that is looked at.
struct Case {
    /// Its name in JSON.
    name: &'static str,
    scene: &'static str,
    parts: Parts,
    /// Most static RAM and stack.
    limit: Option<u64>,
}

const fn case(name: &'static str, scene: &'static str, parts: Parts, limit: Option<u64>) -> Case {
    Case {
        name,
        scene,
        parts,
        limit,
    }
}

/// Those with the same parts stand side by side, and must need the same RAM but for
/// what a scene's materials ask of the stack.
const CASES: [Case; 7] = [
    case(
        "w1_teapot_flat",
        "w1_teapot_flat",
        Parts::Flat,
        Some(RAM_LIMIT),
    ),
    case(
        "w2_teapot_gouraud",
        "w2_teapot_gouraud",
        Parts::Gouraud,
        Some(RAM_LIMIT),
    ),
    case(
        "w3_bunny_gouraud",
        "w3_bunny_gouraud",
        Parts::Gouraud,
        Some(RAM_LIMIT),
    ),
    case(
        "w2_teapot_gouraud with all but rays",
        "w2_teapot_gouraud",
        Parts::Triangles,
        Some(ALL_TRIANGLES_RAM_LIMIT),
    ),
    case(
        "w3_bunny_gouraud with all but rays",
        "w3_bunny_gouraud",
        Parts::Triangles,
        Some(ALL_TRIANGLES_RAM_LIMIT),
    ),
    case(
        "leaf_shadows by rays alone",
        "leaf_shadows",
        Parts::Rays,
        Some(RAYS_RAM_LIMIT),
    ),
    case(
        "w4_cube_textured with everything",
        "w4_cube_textured",
        Parts::All,
        None,
    ),
];

/// A demo for a chip with 20 KB of RAM, two wire buffers and the stack included.
const IN_A_SMALL_CHIP: (&Board, Case) = (
    &BOARDS[0],
    case(
        "w3_bunny_gouraud in 20 KB",
        "w3_bunny_gouraud",
        Parts::Compact,
        Some(CHIP_RAM),
    ),
);

/// What one firmware takes, in bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Footprint {
    code: u64,
    static_ram: u64,
    stack: u64,
    mesh: u64,
}

impl Footprint {
    fn json(self) -> Value {
        json!({
            "code_bytes": self.code,
            "static_ram_bytes": self.static_ram,
            "stack_bytes": self.stack,
            "mesh_bytes": self.mesh,
        })
    }
}

/// Builds the demo firmware of the boards that are not measured, and checks what it
/// holds.
pub fn of_others(tally: &mut Tally) {
    let others = board::OTHERS.iter().filter(|board| board.is_elf());
    let others: Vec<&Board> = others.collect();
    parallel::check(tally, &others, |board, tally| {
        let demo = scene::bake(board.scene)
            .and_then(|baked| firmware::demo(board, &baked, Parts::All))
            .and_then(|demo| promises(&demo.image));
        tally.check(&format!("promises of {}", board.name), demo);
    });
}

/// Builds the demo firmware of each case on every board, checks it, and runs it for
/// its stack. Gives `{"case": {"board": {"code_bytes": n, ...}}}`.
pub fn run(tally: &mut Tally) -> Result<Value> {
    let mut all: Map<String, Value> = Map::new();
    let boards = parallel::check(tally, &BOARDS, of_board);
    for (board, cases) in BOARDS.iter().zip(boards) {
        for (case, footprint) in cases {
            let boards = all.entry(case.name).or_insert_with(|| json!({}));
            boards[board.name] = footprint.json();
        }
    }
    let (board, case) = &IN_A_SMALL_CHIP;
    let what = format!("footprint of {} on {}", case.name, board.name);
    let result = one(board, case, tally);
    if let Some(footprint) = tally.need(&what, result) {
        tally.check(&what, limits(board, case, footprint));
        all.insert(case.name.into(), json!({ board.name: footprint.json() }));
    }
    Ok(all.into())
}

/// What each case takes on a board.
fn of_board(board: &Board, tally: &mut Tally) -> Vec<(&'static Case, Footprint)> {
    let mut known: Vec<(&Case, Footprint)> = Vec::new();
    for case in &CASES {
        let what = format!("footprint of {} on {}", case.name, board.name);
        let result = one(board, case, tally);
        let Some(footprint) = tally.need(&what, result) else {
            continue;
        };
        tally.check(&what, limits(board, case, footprint));
        let other = known.iter().find(|(other, _)| other.parts == case.parts);
        if let Some((_, other)) = other {
            let what = format!(
                "RAM does not grow with the mesh on {}, {}",
                board.name,
                case.parts.name()
            );
            tally.check(&what, independent_of_mesh(other, &footprint));
        }
        known.push((case, footprint));
    }
    let code: Vec<(Parts, u64)> = known.iter().map(|(c, f)| (c.parts, f.code)).collect();
    let what = format!("what is not used costs no flash on {}", board.name);
    tally.check(&what, unused_is_not_linked(&code));
    known
}

fn one(board: &Board, case: &Case, tally: &mut Tally) -> Result<Footprint> {
    let baked = scene::bake(case.scene)?;
    let demo = firmware::demo(board, &baked, case.parts)?;
    let what = format!("promises of {} on {}", case.name, board.name);
    tally.check(&what, promises(&demo.image));
    if case.parts < Parts::Triangles {
        let what = format!("{} of {} on {}", case.parts.name(), case.name, board.name);
        tally.check(&what, only(&demo.image, case.parts));
    }
    emulator::provide(board)?;
    let text = emulator::run(board, &demo.path, &[])?;
    Ok(Footprint {
        code: demo.image.code_bytes(),
        static_ram: demo.image.static_ram_bytes,
        stack: stack_bytes(&text)?,
        mesh: demo.image.scene_bytes,
    })
}

/// Modules of the core that only some firmware needs, as they are in mangled names.
const OPTIONAL: [&str; 5] = [
    "5light",
    "4line7segment",
    // Its own module: what a scene says of fog is checked by all firmware.
    "5fixel3fog",
    "5shade7texture",
    "7surface",
];

/// Fails if a firmware holds code that it has no use for.
fn only(image: &elf::Image, parts: Parts) -> Result<()> {
    let gouraud = ["raster11perspective"].into_iter();
    let unwanted: Vec<&str> = match parts {
        Parts::Flat => gouraud.chain(OPTIONAL).collect(),
        Parts::Gouraud | Parts::Compact => OPTIONAL.into(),
        Parts::Triangles | Parts::Rays | Parts::All => Vec::new(),
    };
    let mut symbols = image.symbols.iter().filter(|name| name.contains("5fixel"));
    let found = symbols.find(|name| unwanted.iter().any(|part| name.contains(part)));
    match found {
        Some(name) => Err(format!("it has no use for {name}").into()),
        None => Ok(()),
    }
}

/// Fails unless each more of the renderer makes a firmware larger.
fn unused_is_not_linked(code: &[(Parts, u64)]) -> Result<()> {
    for (parts, bytes) in code {
        let smaller = code.iter().filter(|(other, _)| other < parts);
        for (other, less) in smaller {
            // Rays alone are another renderer, not more of one.
            if less >= bytes && *other != Parts::Rays && *parts != Parts::Rays {
                return Err(format!(
                    "{less} bytes of code for {}, {bytes} for {}",
                    other.name(),
                    parts.name()
                )
                .into());
            }
        }
    }
    Ok(())
}

/// The stack's high-water mark among a firmware's lines.
fn stack_bytes(text: &str) -> Result<u64> {
    let stack = measure::stack_bytes(text);
    stack.ok_or_else(|| format!("the firmware did not say how deep its stack went: {text}").into())
}

/// Most bytes of statics that are not zero at the start. The working memory is all zero: as
/// much flash as RAM, otherwise, and a start that copies it.
const INITIALISED_LIMIT: u64 = 256;

/// Fails if a firmware floats, allocates, could panic, or keeps working memory in flash.
pub fn promises(image: &elf::Image) -> Result<()> {
    let broken = elf::broken(image.symbols.iter().map(String::as_str));
    if !broken.floats.is_empty() {
        return Err(format!("floating point: {}", broken.floats.join(", ")).into());
    }
    if !broken.allocations.is_empty() {
        return Err(format!("allocation: {}", broken.allocations.join(", ")).into());
    }
    if !broken.panics.is_empty() {
        return Err(format!("it could panic: {}", broken.panics.join(", ")).into());
    }
    if image.initialised_bytes > INITIALISED_LIMIT {
        let bytes = image.initialised_bytes;
        return Err(format!("{bytes} bytes of statics that are not zero").into());
    }
    Ok(())
}

/// Builds a firmware that panics and floats, and fails unless the checks see
/// both in it.
pub fn checks_can_fail() -> Result<()> {
    let board = &BOARDS[0];
    let baked = scene::bake(scene::SMALL)?;
    let demo = firmware::faulty_demo(board, &baked)?;
    let broken = elf::broken(demo.image.symbols.iter().map(String::as_str));
    if broken.panics.is_empty() || broken.floats.is_empty() {
        return Err(format!("a faulty firmware passed for a good one: {broken:?}").into());
    }
    if promises(&demo.image).is_ok() {
        return Err("a firmware that floats kept its promises".into());
    }
    Ok(())
}

fn limits(board: &Board, case: &Case, footprint: Footprint) -> Result<()> {
    let ram = footprint.static_ram + footprint.stack;
    if let Some(limit) = case
        .limit
        .filter(|limit| board.name == LIMITED && ram >= *limit)
    {
        return Err(format!("{ram} bytes of RAM and stack, the limit is {limit}").into());
    }
    if footprint.mesh == 0 {
        return Err("the scene is not in the firmware".into());
    }
    Ok(())
}

fn independent_of_mesh(one: &Footprint, other: &Footprint) -> Result<()> {
    if one.static_ram != other.static_ram || one.stack.abs_diff(other.stack) > STACK_SLACK {
        return Err(format!(
            "{} + {} bytes with one mesh, {} + {} with another",
            one.static_ram, one.stack, other.static_ram, other.stack
        )
        .into());
    }
    Ok(())
}

/// The figures as a table.
pub fn markdown(figures: &Value) -> String {
    let mut rows = Vec::new();
    let of_all = CASES
        .iter()
        .flat_map(|case| BOARDS.iter().map(move |b| (b, case)));
    let (board, case) = &IN_A_SMALL_CHIP;
    for (board, case) in of_all.chain([(*board, case)]) {
        let cell = |field: &str| {
            let value = figures[case.name][board.name][field].as_u64();
            value.map_or("-".into(), |value| value.to_string())
        };
        rows.push(vec![
            format!("{}, {}", case.scene, board.name),
            case.parts.name().into(),
            cell("code_bytes"),
            cell("static_ram_bytes"),
            cell("stack_bytes"),
            cell("mesh_bytes"),
        ]);
    }
    let head = [
        "scene, board",
        "linked",
        "code",
        "static RAM",
        "stack",
        "scene",
    ];
    format!(
        "Bytes of the demo firmware, 320x240 in bands of 16 rows unless it says otherwise, by \
         rays alone of 4; \
         `cargo xtask footprint`.\n\n{}",
        table(&head, &rows)
    )
}

#[cfg(test)]
mod tests;
