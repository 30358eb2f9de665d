//! A program for firmware that shows the scene, whatever drives the panel.

use fixel::Scene;
use fixel::scene::{Output, PanelDithering};
use fixel_scene::{ColourFormat, Panel};

use crate::facts::band_rows;

/// What differs from scene to scene and panel to panel.
#[derive(Debug, Default)]
struct Parts {
    /// What the function is generic over.
    bound: &'static str,
    /// What it depends on.
    crates: &'static str,
    /// Who implements the bound.
    who: String,
    /// `use` lines beside the usual ones.
    uses: Vec<&'static str>,
    /// Fields of the memory: name, type, value.
    memory: Vec<[String; 3]>,
    /// How the panel is wrapped.
    panel: Vec<String>,
}

/// How frames are drawn.
struct Way {
    uses: [&'static str; 2],
    /// Fields of the memory: name, type, value.
    memory: &'static [[&'static str; 3]],
    /// What is made once.
    band: &'static str,
    /// What is done for each frame.
    draw: &'static str,
}

const TRIANGLES: Way = Way {
    uses: ["use fixel::{Renderer, Scene};", ""],
    memory: &[[
        "renderer",
        "Renderer<FRAME_WIDTH, BAND_ROWS>",
        "Renderer::new()",
    ]],
    band: "",
    draw: "        memory.renderer.draw(&scene, &scene.pose(frame), &mut panel)?;\n",
};

/// Triangles without a palette.
const COLOURS: Way = Way {
    uses: [
        "use fixel::render::Bands;",
        "use fixel::{Band, Scene, Scratch};",
    ],
    memory: &[
        ["scratch", "Scratch<64, 10, 4>", "Scratch::new()"],
        ["colours", ARRAYS[1][0], ARRAYS[1][1]],
        ["depths", ARRAYS[1][0], ARRAYS[1][1]],
    ],
    band: BAND_OF_COLOURS,
    draw: "        let pose = scene.pose(frame);
        let mut work = memory.scratch.workspace();
        let bands = Bands::direct(&scene, &pose, scene.dither(), &mut work, &mut band);
        let mut bands = bands.expect(\"a scene that is baked without a palette\");
        while let Some(rows) = bands.next() {
            for (y, row) in (rows.top..).zip(rows.indices.chunks(FRAME_WIDTH)) {
                panel.row(y, row)?;
            }
        }
",
};

const RAYS: Way = Way {
    uses: [
        "use fixel::ray::{RayScratch, render_frame};",
        "use fixel::{Band, Scene};",
    ],
    memory: &[
        ["scratch", "RayScratch<4>", "RayScratch::new()"],
        ["indices", ARRAYS[0][0], ARRAYS[0][1]],
        ["depths", ARRAYS[1][0], ARRAYS[1][1]],
    ],
    band: BAND_OF_INDICES,
    draw: "        let work = &mut memory.scratch.workspace();
        render_frame(&scene, &scene.pose(frame), work, &mut band, &mut panel)?;
",
};

/// Types and values of a band's bytes and words.
const ARRAYS: [[&str; 2]; 2] = [
    [
        "[u8; FRAME_WIDTH * BAND_ROWS]",
        "[0; FRAME_WIDTH * BAND_ROWS]",
    ],
    [
        "[u16; FRAME_WIDTH * BAND_ROWS]",
        "[0; FRAME_WIDTH * BAND_ROWS]",
    ],
];

const BAND_OF_INDICES: &str =
    "    let (indices, depths) = (&mut memory.indices, &mut memory.depths);
    let mut band = Band::new(FRAME_WIDTH as u16, indices, depths).expect(\"whole rows\");
";
const BAND_OF_COLOURS: &str =
    "    let (colours, depths) = (&mut memory.colours, &mut memory.depths);
    let mut band = Band::new(FRAME_WIDTH as u16, colours, depths).expect(\"whole rows\");
";

/// A module that shows the scene of `name.fxl` on the panel, frame after frame.
pub(crate) fn program(scene: &Scene<'_>, panel: &Panel, name: &str, rays: bool) -> String {
    let (columns, rows) = (panel.width as u16, panel.height as u16);
    let (width, height) = scene.output().frame_size((columns, rows));
    let rows = band_rows(rays).min(height.into());
    let way = match (rays, scene.is_direct()) {
        (true, _) => RAYS,
        (_, true) => COLOURS,
        _ => TRIANGLES,
    };
    let parts = match panel.colour {
        ColourFormat::Mono | ColourFormat::Gray4 => packed(scene, panel),
        _ if scene.is_direct() => colours_alone(),
        _ => colour(scene.output(), panel),
    };
    let own = way.memory.iter().map(|field| field.map(String::from));
    let memory: Vec<[String; 3]> = own.chain(parts.memory).collect();
    let fields = |entry: fn(&[String; 3]) -> String| memory.iter().map(entry).collect::<String>();
    let types = fields(|[name, of, _]| format!("    {name}: {of},\n"));
    let values = fields(|[name, _, value]| format!("            {name}: {value},\n"));
    let mut uses = [parts.uses, way.uses.to_vec()].concat();
    uses.retain(|line| !line.is_empty());
    uses.sort_unstable();
    let uses = uses.join("\n");
    let wrapped = parts.panel.iter().map(|line| format!("    {line}\n"));
    let wrapped: String = wrapped.collect();
    let Way { band, draw, .. } = way;
    let Parts {
        bound, who, crates, ..
    } = parts;
    format!(
        "//! {name}.fxl on a {}: {}x{}, in bands of {rows} rows.\n\
         //! In Cargo.toml: {crates}\n\
         {uses}\n\n\
         static SCENE: &[u8] = fixel::include_scene!(\"{name}.fxl\");\n\
         const FRAME_WIDTH: usize = {width};\n\
         const BAND_ROWS: usize = {rows};\n\n\
         /// All the RAM that drawing takes: put it into a `static`.\n\
         pub struct Memory {{\n{types}}}\n\n\
         impl Memory {{\n    \
             pub const fn new() -> Self {{\n        \
                 Self {{\n{values}        }}\n    \
             }}\n\
         }}\n\n\
         /// Shows frame after frame on {who}.\n\
         pub fn animate<P: {bound}>(panel: P, memory: &mut Memory) -> Result<(), P::Error> {{\n    \
             let scene = Scene::embedded(SCENE).expect(\"a scene that fixel has baked\");\n\
             {band}{wrapped}    \
             for frame in 0.. {{\n\
                 {draw}    \
             }}\n    \
             Ok(())\n\
         }}\n",
        panel.name, panel.width, panel.height,
    )
}

fn draw_target() -> Parts {
    Parts {
        bound: "DrawTarget<Color = Rgb565>",
        crates: "fixel, embedded-graphics-core = \"0.4\"",
        who: "any display of embedded-graphics, such as a driver from mipidsi".into(),
        uses: vec![
            "use embedded_graphics_core::draw_target::DrawTarget;",
            "use embedded_graphics_core::geometry::Point;",
            "use embedded_graphics_core::pixelcolor::Rgb565;",
        ],
        ..Parts::default()
    }
}

/// Indices through a palette.
fn colour(output: Output, panel: &Panel) -> Parts {
    let mut parts = draw_target();
    if !output.is_resolved() {
        parts.uses.push("use fixel::DrawTargetDisplay;");
        parts.panel = vec!["let mut panel = DrawTargetDisplay::new(panel, Point::zero());".into()];
        return parts;
    }
    parts
        .uses
        .push("use fixel::display::{DrawTargetRows, Resolve};");
    parts.memory = vec![sums(panel), line("row", "u16", panel.width)];
    parts.panel = vec![
        "let rows = DrawTargetRows::new(panel, Point::zero());".into(),
        "let (sums, row) = (&mut memory.sums, &mut memory.row);".into(),
        "let mut panel = Resolve::new(scene.output(), sums, row, rows);".into(),
    ];
    parts
}

/// Colours without a palette.
fn colours_alone() -> Parts {
    let mut parts = draw_target();
    parts
        .uses
        .push("use fixel::display::{DrawTargetRows, Rgb565Rows};");
    parts.panel = vec!["let mut panel = DrawTargetRows::new(panel, Point::zero());".into()];
    parts
}

/// Greys, several pixels in a byte.
fn packed(scene: &Scene<'_>, panel: &Panel) -> Parts {
    let (packing, bytes) = match (panel.colour, panel.name.split('-').next()) {
        (ColourFormat::Gray4, _) => ("Rows4", panel.width.div_ceil(2)),
        (_, Some("sharp" | "uc8151" | "ssd1681")) => ("Rows1", panel.width.div_ceil(8)),
        _ => ("Pages", panel.width),
    };
    let (kind, dither) = match scene.panel_dithering() {
        PanelDithering::None => ("Nearest", "Nearest"),
        PanelDithering::Bayer4 => ("Ordered", "Ordered::BAYER4"),
        PanelDithering::Bayer8 => ("Ordered", "Ordered::BAYER8"),
        PanelDithering::BlueNoise => ("Ordered", "Ordered::BLUE_NOISE"),
        PanelDithering::FloydSteinberg => ("Diffused", "Diffused::new(&mut memory.errors)"),
    };
    let resolved = scene.output().is_resolved();
    let uses = match (kind, resolved) {
        ("Nearest", false) => "use fixel::display::{Nearest, Packed, PackedRows, Packing};",
        ("Ordered", false) => "use fixel::display::{Ordered, Packed, PackedRows, Packing};",
        (_, false) => "use fixel::display::{Diffused, Packed, PackedRows, Packing};",
        ("Nearest", true) => {
            "use fixel::display::{Nearest, Packed, PackedRows, Packing, ResolvePacked};"
        }
        ("Ordered", true) => {
            "use fixel::display::{Ordered, Packed, PackedRows, Packing, ResolvePacked};"
        }
        (_, true) => "use fixel::display::{Diffused, Packed, PackedRows, Packing, ResolvePacked};",
    };
    let mut memory = vec![line("line", "u8", bytes)];
    if kind == "Diffused" {
        memory.push(line("errors", "i16", panel.width));
    }
    let height = panel.height;
    let own = if resolved { "packed" } else { "mut panel" };
    let mut wrapped = vec![
        format!("let dither = {dither};"),
        "let line = &mut memory.line;".into(),
        format!("let {own} = Packed::new(Packing::{packing}, {height}, dither, line, panel);"),
    ];
    if resolved {
        memory.push(sums(panel));
        wrapped.push("let sums = &mut memory.sums;".into());
        wrapped.push("let mut panel = ResolvePacked::new(scene.output(), sums, packed);".into());
    }
    let how = if packing == "Pages" {
        "pages of 8 rows"
    } else {
        "rows"
    };
    Parts {
        bound: "PackedRows",
        crates: "fixel",
        who: format!(
            "a panel that takes {how}: `PackedRows` is one function,\n\
             /// `rows(&mut self, y, bytes)`, which sends them"
        ),
        uses: vec![uses],
        memory,
        panel: wrapped,
    }
}

fn line(name: &str, of: &str, count: u32) -> [String; 3] {
    [
        name.into(),
        format!("[{of}; {count}]"),
        format!("[0; {count}]"),
    ]
}

fn sums(panel: &Panel) -> [String; 3] {
    line("sums", "u32", panel.width)
}
