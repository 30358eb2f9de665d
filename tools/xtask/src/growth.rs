//! How instructions of a frame grow with its pixels, its actors and its lights: tables and a
//! plot.

use fixel_scene::{Actor, Light, LightKind, Scene, Shading};
use serde_json::{Map, Value, json};

use crate::measure::{self, Ready};
use crate::problem::Result;
use crate::report::{Tally, table};
use crate::{parallel, paths, plot, readme, scene};

/// Boards that are measured, and what they are called in tables.
const BOARDS: [(&str, &str); 2] = [("cortex-m4f", "M4F"), ("cortex-m0plus", "M0+")];
/// The frame that is drawn.
const FRAME: u32 = 4;
/// Rows of a band: the largest picture has no room in one.
const BAND_ROWS: u32 = 16;
/// The teapot in Gouraud shading.
const TEAPOT: &str = "w2_teapot_gouraud";

/// Columns and rows of pictures.
const SIZES: [[u32; 2]; 7] = [
    [64, 64],
    [128, 64],
    [128, 128],
    [160, 120],
    [240, 240],
    [320, 240],
    [480, 320],
];
const ACTORS: [usize; 8] = [1, 2, 5, 10, 20, 50, 100, 200];
/// The same by rays: no more than the measuring firmware knows the places of.
const RAY_ACTORS: [usize; 6] = [1, 2, 5, 10, 20, 50];
const LIGHTS: [usize; 5] = [1, 2, 3, 5, 8];

/// What grows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// The picture.
    Pixels,
    /// The number of cubes that share the picture.
    Actors,
    /// The same by rays, with shadows.
    RayActors,
    /// The number of grey lights from infinitely far.
    Lights,
    /// The number of coloured lights that have a place.
    PlacedLights,
}

impl Kind {
    const ALL: [Self; 5] = [
        Self::Pixels,
        Self::Actors,
        Self::RayActors,
        Self::Lights,
        Self::PlacedLights,
    ];

    /// In JSON.
    fn name(self) -> &'static str {
        match self {
            Self::Pixels => "pixels",
            Self::Actors => "actors",
            Self::RayActors => "ray_actors",
            Self::Lights => "lights",
            Self::PlacedLights => "placed_lights",
        }
    }

    fn what(self) -> &'static str {
        match self {
            Self::Pixels => "The teapot in Gouraud shading against the picture's pixels",
            Self::Actors => {
                "Cubes in flat shading that share a picture of 320x240, smaller the more there are"
            }
            Self::RayActors => "The same by rays, with shadows",
            Self::Lights => "The teapot against grey lights from infinitely far",
            Self::PlacedLights => "The teapot against coloured lights that have a place",
        }
    }
}

/// A scene of some size.
#[derive(Clone, Debug)]
pub struct Grown {
    /// What grows.
    pub kind: Kind,
    /// How much of it there is.
    pub amount: usize,
    /// The scene.
    pub scene: Scene,
}

impl Grown {
    /// A name for files and figures.
    pub fn name(&self) -> String {
        format!("{}_{}", self.kind.name(), self.amount)
    }

    /// Bakes it into a file.
    pub fn bake(&self) -> Result<(fixel_bake::Baked, scene::Baked)> {
        let blob = match self.kind {
            Kind::RayActors => fixel_bake::bake_for_rays(&self.scene),
            _ => fixel_bake::bake(&self.scene),
        };
        let blob = blob.map_err(|error| error.to_string())?;
        let baked = scene::Baked::keep("scenes", &format!("grown_{}", self.name()), &blob)?;
        Ok((blob, baked))
    }
}

/// All scenes, smaller ones first.
pub fn scenes() -> Result<Vec<Grown>> {
    let load = |name| fixel_scene::load(&scene::file(name)).map_err(|error| error.to_string());
    let (teapot, cube) = (load(TEAPOT)?, load("cube")?);
    let mut all = Vec::new();
    for [width, height] in SIZES {
        let mut scene = teapot.clone();
        (scene.display.width, scene.display.height) = (width, height);
        all.push((Kind::Pixels, (width * height) as usize, scene));
    }
    for count in ACTORS {
        all.push((Kind::Actors, count, cubes(&teapot, &cube, count)));
    }
    for count in RAY_ACTORS {
        all.push((Kind::RayActors, count, cubes(&teapot, &cube, count)));
    }
    for count in LIGHTS {
        let mut scene = teapot.clone();
        scene.lights = (0..count).map(|which| far_light(which, count)).collect();
        all.push((Kind::Lights, count, scene));
        let mut scene = teapot.clone();
        scene.lights = (0..count).map(|which| placed_light(which, count)).collect();
        all.push((Kind::PlacedLights, count, scene));
    }
    let grown = |(kind, amount, scene)| Grown {
        kind,
        amount,
        scene,
    };
    Ok(all.into_iter().map(grown).collect())
}

/// So many cubes in rows and columns, in the view of the teapot.
fn cubes(view: &Scene, cube: &Scene, count: usize) -> Scene {
    let mut scene = view.clone();
    scene.meshes = vec![cube.meshes[cube.actors[0].mesh].clone()];
    scene.materials.truncate(1);
    scene.materials[0].shading = Shading::Flat;
    let columns = (count as f64).sqrt().ceil();
    // The view is 31.5 units high at the middle.
    let apart = 28.0 / columns;
    let corners = scene.meshes[0].positions.iter().flatten();
    let reach = corners.fold(0.0_f64, |most, c| most.max(c.abs()));
    let model = Actor {
        mesh: 0,
        material: 0,
        ..scene.actors[0].clone()
    };
    scene.actors = (0..count)
        .map(|number| {
            let place = |at: f64| (at + 0.5) * apart - 14.0;
            let (column, row) = (number as f64 % columns, (number as f64 / columns).floor());
            let mut actor = model.clone();
            actor.name = format!("cube {number}");
            actor.origin = [0.0; 3];
            actor.position = [place(column), place(row), 0.0];
            actor.scale = [0.3 * apart / reach; 3];
            actor
        })
        .collect();
    scene
}

fn far_light(which: usize, count: usize) -> Light {
    let turn = which as f64 / count as f64 * std::f64::consts::TAU;
    Light {
        kind: LightKind::Directional {
            direction: [turn.cos(), -1.0, turn.sin() - 1.0],
        },
        colour: [1.0; 3],
        intensity: 1.0 / count as f64,
        edges: None,
    }
}

fn placed_light(which: usize, count: usize) -> Light {
    let turn = which as f64 / count as f64 * std::f64::consts::TAU;
    Light {
        kind: LightKind::Point {
            position: [15.0 * turn.cos(), 15.0 * turn.sin(), 20.0],
            attenuation: [1.0, 0.0, 0.0],
        },
        colour: [1.0, 0.5 + 0.5 * turn.cos(), 0.5 + 0.5 * turn.sin()],
        intensity: 1.0 / count as f64,
        edges: None,
    }
}

/// Draws every scene on both boards. Gives `{"pixels": [{"amount": n, "cortex-m4f":
/// instructions, ...}], ...}`.
pub fn run(tally: &mut Tally) -> Result<Value> {
    let ready = measure::boards(&BOARDS.map(|(name, _)| name), "growth", tally);
    let scenes = scenes()?;
    let counts = parallel::map(&scenes, |grown| {
        let (_, baked) = grown.bake()?;
        let count = |ready: &Ready| -> Result<(String, Value)> {
            let frames = ready.frames(&baked, FRAME..FRAME + 1, BAND_ROWS, None)?;
            let count: u64 = frames.iter().map(|frame| frame.count).sum();
            Ok((ready.target.name().into(), count.into()))
        };
        ready.iter().map(count).collect::<Result<Map<_, _>>>()
    });
    let mut all = Map::new();
    for (grown, counts) in scenes.iter().zip(counts) {
        let Some(mut row) = tally.check(&grown.name(), counts) else {
            continue;
        };
        row.insert("amount".into(), grown.amount.into());
        let rows = all.entry(grown.kind.name()).or_insert_with(|| json!([]));
        if let Some(rows) = rows.as_array_mut() {
            rows.push(row.into());
        }
    }
    Ok(all.into())
}

/// The figures as tables.
pub fn markdown(figures: &Value) -> String {
    let mut text = format!(
        "Millions of instructions of one frame, bands of {BAND_ROWS} rows; `cargo xtask scaling`.\n\n\
         ![Instructions against pixels, actors and lights](images/scaling.svg)\n"
    );
    for kind in Kind::ALL {
        let rows = figures[kind.name()].as_array().cloned().unwrap_or_default();
        let rows: Vec<Vec<String>> = rows
            .iter()
            .map(|row| {
                let mut cells = vec![row["amount"].to_string()];
                cells.extend(BOARDS.map(|(board, _)| {
                    let count = row[board].as_f64();
                    count.map_or("-".into(), |count| format!("{:.2}", count / 1e6))
                }));
                cells
            })
            .collect();
        let head: Vec<&str> = std::iter::once(kind.name())
            .chain(BOARDS.map(|(_, title)| title))
            .collect();
        text += &format!("\n{}:\n\n{}", kind.what(), table(&head, &rows));
    }
    text
}

/// Writes the tables into docs/performance.md, and the plot beside it.
pub fn write(figures: &Value) -> Result<()> {
    readme::replace("docs/performance.md", "scaling", &markdown(figures))?;
    draw(figures)
}

fn draw(figures: &Value) -> Result<()> {
    let panels = Kind::ALL.map(|kind| {
        let rows = figures[kind.name()].as_array().cloned().unwrap_or_default();
        let lines = BOARDS.map(|(board, title)| {
            let point = |row: &Value| Some([row["amount"].as_f64()?, row[board].as_f64()? / 1e6]);
            (title, rows.iter().filter_map(point).collect())
        });
        plot::Panel {
            title: kind.name().replace('_', " "),
            lines: lines.into(),
        }
    });
    let path = paths::root().join("docs/images/scaling.svg");
    let svg = plot::svg(&panels, "millions of instructions");
    Ok(fixel_output::write(&path, svg.as_bytes())?)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scenes_grow() {
        let scenes = scenes().unwrap_or_default();
        let amounts = SIZES.len() + ACTORS.len() + RAY_ACTORS.len() + 2 * LIGHTS.len();
        assert_eq!(scenes.len(), amounts);
        for grown in scenes {
            match grown.kind {
                Kind::Pixels => {}
                Kind::Actors | Kind::RayActors => {
                    assert_eq!(grown.scene.actors.len(), grown.amount);
                }
                Kind::Lights | Kind::PlacedLights => {
                    assert_eq!(grown.scene.lights.len(), grown.amount);
                }
            }
        }
    }
}
