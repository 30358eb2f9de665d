//! The work of a frame: the core draws it here, as the measured firmware would, and each
//! step is counted.

use std::cell::RefCell;

use fixel::frame::BandRows;
use fixel::render::{Bands, Direct, FrameStats, Paint, Scratch, Shaded, Workspace};
use fixel::scene::{Pose, Projection, Representation};
use fixel::{Band, Scene};

use crate::capacity::Lists;
use crate::counting::{Counter, Counting};
use crate::term::{Term, Work};

/// The work of a frame of a scene, as `pose` has it, drawn by triangles as large as the scene says in bands
/// of at most so many rows, by the measured firmware.
pub fn work(scene: &Scene<'_>, pose: &Pose<'_>, band_rows: u16) -> Work {
    work_with(Lists::Usual, scene, pose, band_rows)
}

/// The same by a renderer with such lists.
pub(crate) fn work_with(lists: Lists, scene: &Scene<'_>, pose: &Pose<'_>, band_rows: u16) -> Work {
    match lists {
        Lists::Usual => of::<64, 10, 4>(scene, pose, band_rows),
        Lists::Short => of::<32, 4, 2>(scene, pose, band_rows),
        Lists::Shortest => of::<32, 2, 1>(scene, pose, band_rows),
    }
}

fn of<const MESHLETS: usize, const SLOTS: usize, const ACTORS: usize>(
    scene: &Scene<'_>,
    pose: &Pose<'_>,
    band_rows: u16,
) -> Work {
    let mut scratch = Box::new(Scratch::<MESHLETS, SLOTS, ACTORS>::new());
    let mut workspace = scratch.workspace();
    let lists = (&mut workspace, [MESHLETS, ACTORS]);
    let paint = Shaded {
        dither: scene.dither(),
    };
    match Direct::new(scene, scene.dither()) {
        Some(direct) => draw(&direct, scene, pose, band_rows, lists, |counter, rows| {
            counter.add(Term::DirectPx, rows.indices.len() as f64);
        }),
        None => {
            let mut before = None;
            let resolved = scene.output().is_resolved();
            draw(&paint, scene, pose, band_rows, lists, |work, rows| {
                if resolved {
                    work.add(Term::SamplePx, rows.indices.len() as f64);
                    return;
                }
                for four in rows.indices.chunks(4) {
                    let same = before.as_deref() == Some(four);
                    let term = if same {
                        Term::RepeatedFour
                    } else {
                        Term::OtherFour
                    };
                    work.add(term, 1.0);
                    before = Some(four.to_vec());
                }
            })
        }
    }
}

fn draw<P: Paint>(
    paint: &P,
    scene: &Scene<'_>,
    pose: &Pose<'_>,
    band_rows: u16,
    (workspace, [meshlets, actors]): (&mut Workspace<'_>, [usize; 2]),
    mut finished: impl FnMut(&mut Work, BandRows<'_, P::Stored>),
) -> Work
where
    P::Stored: Default,
{
    let (width, height) = (scene.frame_width(), scene.frame_height());
    let first = scene.place_viewport(0, pose, width, height);
    let perspective = matches!(first.camera.projection, Projection::Perspective { .. });
    let counter = RefCell::new(Counter::new(scene, perspective, actors));
    let counting = Counting {
        paint: *paint,
        counter: &counter,
    };
    let rows = band_rows.clamp(1, height.max(1));
    let pixels = usize::from(width.max(1)) * usize::from(rows);
    let mut indices = vec![P::Stored::default(); pixels];
    let mut depths = vec![0; pixels];
    let Ok(mut band) = Band::new(width, &mut indices, &mut depths) else {
        return Work::default();
    };
    let mut bands = Bands::with(counting, scene, pose, workspace, &mut band, 0..height);
    let mut shown = Work::default();
    while let Some(rows) = bands.next() {
        finished(&mut shown, rows);
    }
    let stats = bands.stats();
    let mut counter = counter.into_inner();
    // Each list is made from all actors.
    for _ in 0..=stats.list_refills {
        for actor in (0..scene.viewport_count()).flat_map(|_| 0..scene.actor_count()) {
            counter.matrices(actor);
        }
    }
    let mut work = counter.work;
    for (term, amount) in Term::ALL.iter().zip(shown.all()) {
        work.add(*term, *amount);
    }
    add_stats(&mut work, &stats);
    let viewports = f64::from(scene.viewport_count());
    work.add(Term::ViewportInBand, viewports * f64::from(stats.bands));
    let mut cleared = 0.0;
    for number in 0..scene.viewport_count() {
        let rect = scene.place_viewport(number, pose, width, height).rect;
        cleared += f64::from(rect.width()) * f64::from(rect.height());
    }
    if !scene.is_filled(width) {
        cleared += f64::from(width) * f64::from(height);
    }
    work.add(Term::ClearedPx, cleared);
    let marks = f64::from(stats.marks);
    let (px, coloured) = mean_mark(scene);
    work.add(Term::MarkPx, marks * px);
    work.add(Term::ColouredMark, marks * coloured);
    let fills = f64::from(stats.list_refills + 1);
    let listed = stats.meshlets - stats.meshlets_outside - stats.meshlets_away;
    let displaced = (f64::from(listed) / fills - meshlets as f64).max(0.0) * fills;
    work.add(Term::MeshletListed, f64::from(listed));
    work.add(Term::MeshletDisplaced, displaced);
    work
}

/// Pixels of a mark, in the mean of all, and which part of them go by colour.
fn mean_mark(scene: &Scene<'_>) -> (f64, f64) {
    let (mut marks, mut px, mut coloured) = (0.0, 0.0, 0.0);
    for number in 0..scene.actor_count() {
        let Some(look) = scene.look(number) else {
            continue;
        };
        if look.representation != Representation::Points {
            continue;
        }
        let actor = scene.actor(number);
        let mesh = scene.mesh(actor.mesh);
        let meshlets = mesh.first_meshlet..mesh.first_meshlet + mesh.meshlets;
        let vertices = meshlets.filter_map(|number| scene.meshlet(number));
        let count: f64 = vertices.map(|meshlet| f64::from(meshlet.vertices)).sum();
        marks += count;
        px += count * f64::from(look.mark_size[0]) * f64::from(look.mark_size[1]);
        if scene.material(actor.material).coloured {
            coloured += count;
        }
    }
    let all = f64::max(marks, 1.0);
    (px / all, coloured / all)
}

fn add_stats(work: &mut Work, stats: &FrameStats) {
    let counts = [
        (Term::Frame, 1),
        (Term::Band, stats.bands),
        (Term::Meshlet, stats.meshlets),
        (Term::Triangle, stats.triangles),
        (Term::TriangleAway, stats.triangles_away),
        (Term::TriangleMissed, stats.triangles_missed),
        (Term::TriangleClipped, stats.triangles_clipped),
        (Term::Line, stats.lines),
        (Term::Mark, stats.marks),
    ];
    for (term, count) in counts {
        work.add(term, f64::from(count));
    }
}
