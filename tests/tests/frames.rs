//! Whole frames: golden ones, and the same bytes whatever the bands and the
//! working memory.

use std::convert::Infallible;
use std::ffi::OsStr;
use std::fs;
use std::path::{Path, PathBuf};

use fixel::display::Display;
use fixel::frame::BandRows;
use fixel::palette::Palette;
use fixel::{Band, FrameStats, Scene, Scratch, render_frame};
use fixel_host::{Options, picture as picture_of, render, render_rays};
use fixel_tests::{load, load_for_rays, root, scenes};

fn write_png(path: &Path, (width, height): (u32, u32), rgb: &[u8]) {
    let mut encoder = png::Encoder::new(fs::File::create(path).expect("a new file"), width, height);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    let mut writer = encoder.write_header().expect("a header");
    writer.write_image_data(rgb).expect("pixels");
}

fn read_png(path: &Path) -> Vec<u8> {
    let file = fs::File::open(path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
    let decoder = png::Decoder::new(std::io::BufReader::new(file));
    let mut reader = decoder.read_info().expect("a header");
    let mut rgb = vec![0; reader.output_buffer_size().expect("a size")];
    let frame = reader.next_frame(&mut rgb).expect("pixels");
    rgb.truncate(frame.buffer_size());
    rgb
}

/// Those of `scenes/ray`, and of the bench those that are not drawn by triangles.
fn is_by_rays(path: &Path) -> bool {
    let within = |folder: &str| path.parent().is_some_and(|parent| parent.ends_with(folder));
    let starts_with_w = |name: &OsStr| name.as_encoded_bytes().starts_with(b"w");
    within("scenes/ray") || within("scenes/bench") && !path.file_name().is_some_and(starts_with_w)
}

/// `FIXEL_BLESS=1` (`cargo xtask bless`) writes the golden frames anew.
#[test]
fn golden_frames() {
    let bless = std::env::var_os("FIXEL_BLESS").is_some();
    let folder = root().join("tests/golden");
    let mut differ = Vec::new();
    let of = |folders: &[&str]| folders.iter().flat_map(|f| scenes(f)).collect::<Vec<_>>();
    for path in of(&["scenes", "scenes/bench", "scenes/ray"]) {
        let by_rays = is_by_rays(&path);
        let (_, baked) = if by_rays {
            load_for_rays(&path)
        } else {
            load(&path)
        };
        let scene = baked.scene().expect("baked a moment ago");
        let options = Options::of(&scene);
        let drawn = if by_rays {
            render_rays(&scene, &options)
        } else {
            render(&scene, &options)
        };
        let (pixels, _) = picture_of(&scene, &drawn);
        let rgb: Vec<u8> = pixels.into_iter().flatten().collect();
        let name = path
            .file_stem()
            .expect("a name")
            .to_string_lossy()
            .into_owned();
        let golden: PathBuf = folder.join(format!("{name}.png"));
        if bless {
            fs::create_dir_all(&folder).expect("tests/golden");
            write_png(&golden, (options.width.into(), options.height.into()), &rgb);
        } else if read_png(&golden) != rgb {
            differ.push(name);
        }
    }
    assert!(
        differ.is_empty(),
        "differ from their golden frames: {differ:?}"
    );
}

#[derive(Default)]
struct Sink(Vec<u8>, Vec<u16>);

impl Display for Sink {
    type Error = Infallible;

    fn begin(&mut self, _: &Palette<'_>) -> Result<(), Infallible> {
        Ok(())
    }

    fn show(&mut self, rows: BandRows<'_>) -> Result<(), Infallible> {
        self.0.extend(rows.indices);
        self.1.extend(rows.depths);
        Ok(())
    }
}

fn with<const M: usize, const S: usize, const A: usize>(scene: &Scene<'_>, rows: u16) -> Sink {
    counted::<M, S, A>(scene, rows).0
}

fn counted<const M: usize, const S: usize, const A: usize>(
    scene: &Scene<'_>,
    rows: u16,
) -> (Sink, FrameStats) {
    let pixels = usize::from(scene.frame_width()) * usize::from(rows);
    let (mut indices, mut depths) = (vec![0; pixels], vec![0; pixels]);
    let mut band =
        Band::new(scene.frame_width(), &mut indices, &mut depths).expect("one row at least");
    let mut scratch = Box::new(Scratch::<M, S, A>::new());
    let mut sink = Sink::default();
    let work = &mut scratch.workspace();
    let Ok(stats) = render_frame(scene, &scene.pose(5), work, &mut band, &mut sink);
    assert_eq!(stats.bands, u32::from(scene.frame_height().div_ceil(rows)));
    (sink, stats)
}

#[test]
fn no_capacity_and_no_band_height_changes_a_byte() {
    for name in [
        "suzanne",
        "many_actors",
        "behind_camera",
        "near_clip",
        "two_materials",
        "viewports",
        "fog_exponential",
        "antialiased",
        "stereo_anaglyph",
        "wireframe",
        "hidden_line",
        "lines_in_colour",
        "lines_markers_text",
        "screen_door",
        "blend",
        "blend_fog",
    ] {
        let (_, baked) = load(&root().join(format!("scenes/{name}.toml")));
        let scene = baked.scene().expect("baked a moment ago");
        let whole = with::<4096, 64, 64>(&scene, scene.frame_height());
        for rows in [1, 7, 16, 100] {
            let small = with::<1, 1, 1>(&scene, rows);
            assert!(
                whole.0 == small.0 && whole.1 == small.1,
                "{name} in bands of {rows}"
            );
            let middle = with::<20, 3, 2>(&scene, rows);
            assert!(
                whole.0 == middle.0 && whole.1 == middle.1,
                "{name} in bands of {rows}"
            );
        }
    }
}

/// Lists of just as many meshlets, slots and actors as a frame has, of one less, and of one: the
/// statistics say how often a list was made anew, and no byte differs.
#[test]
fn lists_at_their_bounds_and_beyond() {
    const MESHLETS: usize = 300;
    const ACTORS: usize = 20;
    let (_, baked) = load(&root().join("scenes/many_actors.toml"));
    let scene = baked.scene().expect("baked a moment ago");
    let (whole, stats) = counted::<4096, 64, 64>(&scene, scene.frame_height());
    assert_eq!(usize::from(scene.actor_count()), ACTORS);
    assert_eq!(stats.meshlets_transformed as usize, MESHLETS);
    let (rows, height) = (16, scene.frame_height());
    for (which, (drawn, stats), refills) in [
        (
            "all",
            counted::<MESHLETS, MESHLETS, ACTORS>(&scene, rows),
            0,
        ),
        (
            "one less",
            counted::<{ MESHLETS - 1 }, { MESHLETS - 1 }, { ACTORS - 1 }>(&scene, height),
            1,
        ),
        ("one", counted::<1, 1, 1>(&scene, height), 299),
    ] {
        assert_eq!(stats.list_refills, refills, "{which}");
        assert!(drawn.0 == whole.0 && drawn.1 == whole.1, "{which}");
    }
}

/// Fails when so many calls were made.
struct Faulty(Sink, u32);

impl Display for Faulty {
    type Error = u32;

    fn begin(&mut self, palette: &Palette<'_>) -> Result<(), u32> {
        self.0.begin(palette).map_err(|e| match e {})
    }

    fn show(&mut self, rows: BandRows<'_>) -> Result<(), u32> {
        self.1 = self.1.checked_sub(1).ok_or(u32::from(rows.top))?;
        self.0.show(rows).map_err(|e| match e {})
    }
}

#[test]
fn a_broken_bus_is_reported_and_the_next_frame_is_right() {
    let (_, baked) = load(&root().join("scenes/teapot.toml"));
    let scene = baked.scene().expect("baked a moment ago");
    let good = with::<64, 8, 4>(&scene, 16);
    let pixels = usize::from(scene.width()) * 16;
    let (mut indices, mut depths) = (vec![0; pixels], vec![0; pixels]);
    let mut scratch = Box::new(Scratch::<64, 8, 4>::new());
    for bands in 0..15 {
        let mut band = Band::new(scene.width(), &mut indices, &mut depths).expect("a band");
        let pose = scene.pose(5);
        let mut panel = Faulty(Sink::default(), bands);
        let work = &mut scratch.workspace();
        let result = render_frame(&scene, &pose, work, &mut band, &mut panel);
        assert_eq!(result.expect_err("the bus broke"), bands * 16);
        let mut sink = Sink::default();
        let work = &mut scratch.workspace();
        let Ok(_) = render_frame(&scene, &pose, work, &mut band, &mut sink);
        assert!(
            sink.0 == good.0 && sink.1 == good.1,
            "after a fault at band {bands}"
        );
    }
}
