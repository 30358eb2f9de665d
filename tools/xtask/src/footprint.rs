//! What a minimal firmware takes, and whether it keeps its promises.

use serde_json::{Map, Value, json};

use crate::board::{BOARDS, Board};
use crate::problem::Result;
use crate::report::{Tally, table};
use crate::{elf, firmware, qemu, scene};

/// Most static RAM and stack of the Cortex-M0+ demo, in bytes.
const RAM_LIMIT: u64 = 32 * 1024;
/// The board that the limit holds for.
const LIMITED: &str = "cortex-m0plus";
/// How much the stack may differ between two meshes, in bytes: static RAM may
/// not differ at all.
const STACK_SLACK: u64 = 256;
/// Whether a firmware that could panic fails the check; until the core is free
/// of panics it is only told.
const PANICS_FAIL: bool = true;

/// What one firmware takes, in bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Footprint {
    code: u64,
    static_ram: u64,
    stack: u64,
    mesh: u64,
}

/// Builds the demo firmware with each of [`scene::FOOTPRINT`] on every board,
/// checks it, and runs it for its stack. Gives
/// `{"scene": {"board": {"code_bytes": n, ...}}}`.
pub fn run(tally: &mut Tally) -> Result<Value> {
    let mut all: Map<String, Value> = Map::new();
    for board in &BOARDS {
        let mut by_scene = Vec::new();
        for name in scene::FOOTPRINT {
            let what = format!("footprint of {name} on {}", board.name);
            let result = one(board, name, tally);
            let Some(footprint) = tally.need(&what, result) else {
                continue;
            };
            tally.check(&what, limits(board, footprint));
            by_scene.push(footprint);
            let boards = all.entry(name).or_insert_with(|| json!({}));
            boards[board.name] = json!({
                "code_bytes": footprint.code,
                "static_ram_bytes": footprint.static_ram,
                "stack_bytes": footprint.stack,
                "mesh_bytes": footprint.mesh,
            });
        }
        if let [one, other] = by_scene.as_slice() {
            let what = format!("RAM does not grow with the mesh on {}", board.name);
            tally.check(&what, independent_of_mesh(one, other));
        }
    }
    Ok(all.into())
}

fn one(board: &Board, name: &str, tally: &mut Tally) -> Result<Footprint> {
    let baked = scene::bake(name)?;
    let demo = firmware::demo(board, &baked)?;
    let what = format!("promises of {name} on {}", board.name);
    tally.check(&what, promises(&demo.image));
    qemu::provide(&board.machine)?;
    let text = qemu::run(board, &demo.path, None, &[])?;
    Ok(Footprint {
        code: demo.image.code_bytes(),
        static_ram: demo.image.static_ram_bytes,
        stack: stack_bytes(&text)?,
        mesh: demo.image.scene_bytes,
    })
}

/// The stack's high-water mark among a firmware's lines.
fn stack_bytes(text: &str) -> Result<u64> {
    let lines = text.lines();
    let mut values = lines.filter_map(|line| serde_json::from_str::<Value>(line).ok());
    let stack = values.find_map(|value| value["stack"].as_u64());
    stack.ok_or_else(|| format!("the firmware did not say how deep its stack went: {text}").into())
}

/// Fails if a firmware floats or allocates; says so if it could panic.
fn promises(image: &elf::Image) -> Result<()> {
    let broken = elf::broken(image.symbols.iter().map(String::as_str));
    if !broken.floats.is_empty() {
        return Err(format!("floating point: {}", broken.floats.join(", ")).into());
    }
    if !broken.allocations.is_empty() {
        return Err(format!("allocation: {}", broken.allocations.join(", ")).into());
    }
    if !broken.panics.is_empty() {
        let text = format!("it could panic: {}", broken.panics.join(", "));
        if PANICS_FAIL {
            return Err(text.into());
        }
        eprintln!("note  {text}");
    }
    Ok(())
}

/// Builds a firmware that panics and floats, and fails unless the checks see
/// both in it.
pub fn checks_can_fail() -> Result<()> {
    let board = &BOARDS[0];
    let baked = scene::bake(scene::FOOTPRINT[0])?;
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

fn limits(board: &Board, footprint: Footprint) -> Result<()> {
    let ram = footprint.static_ram + footprint.stack;
    if board.name == LIMITED && ram >= RAM_LIMIT {
        return Err(format!("{ram} bytes of RAM and stack, the limit is {RAM_LIMIT}").into());
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
    for name in scene::FOOTPRINT {
        for board in &BOARDS {
            let cell = |field: &str| {
                let value = figures[name][board.name][field].as_u64();
                value.map_or("-".into(), |value| value.to_string())
            };
            rows.push(vec![
                format!("{name}, {}", board.name),
                cell("code_bytes"),
                cell("static_ram_bytes"),
                cell("stack_bytes"),
                cell("mesh_bytes"),
            ]);
        }
    }
    let head = ["scene, board", "code", "static RAM", "stack", "scene"];
    format!(
        "Bytes of the demo firmware, 320x240 in bands of 16 rows; `cargo xtask footprint`.\n\n{}",
        table(&head, &rows)
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    const SMALL: Footprint = Footprint {
        code: 8000,
        static_ram: 20_000,
        stack: 1000,
        mesh: 30_000,
    };

    #[test]
    fn limits_can_be_exceeded() {
        assert!(limits(&BOARDS[0], SMALL).is_ok());
        let large = Footprint {
            static_ram: 31_768,
            ..SMALL
        };
        assert!(limits(&BOARDS[0], large).is_err());
        assert!(limits(&BOARDS[0], Footprint { mesh: 0, ..SMALL }).is_err());
    }

    #[test]
    fn growth_with_the_mesh_is_found() {
        let grown = Footprint {
            static_ram: 20_004,
            ..SMALL
        };
        assert!(independent_of_mesh(&SMALL, &SMALL).is_ok());
        assert!(independent_of_mesh(&SMALL, &grown).is_err());
        let deeper = Footprint {
            stack: 1300,
            ..SMALL
        };
        assert!(independent_of_mesh(&SMALL, &deeper).is_err());
    }

    #[test]
    fn stack_among_lines() {
        assert_eq!(stack_bytes("{\"stack\":660}\n").ok(), Some(660));
        assert!(stack_bytes("{\"error\":\"panic\"}\n").is_err());
    }
}
