//! What the description says of camera and actors, in the blob's records.

use fixel::math::SUBPX_BITS;
use fixel::scene::layout::{FEATURES, STEP_EXPONENTS};
use fixel::scene::{self as core_scene, CameraRecord, Header};
use fixel_scene::{
    Camera, ColourFormat, Dithering, Element, PanelDithering, Projection, Scene, Space,
};
use glam::DVec3;

use crate::error::{BakeError, Problem, Spot};
use crate::grid::Grid;
use crate::instance::Instance;
use crate::placement::Placed;
use crate::units::{Units, mantissa_exponent, turns, unit_q30};

pub(crate) fn header(scene: &Scene, units: &Units, spread: f64) -> Result<Header, BakeError> {
    let camera = camera(&scene.camera, Element::Camera, units)?;
    let cycle = scene.animation.palette_cycle;
    Ok(Header {
        length: 0,
        checksum: 0,
        width: scene.display.width as u16,
        height: scene.display.height as u16,
        colour_format: colour_format(scene.display.colour),
        panel_dithering: panel_dithering(scene.display.dithering) as u8,
        world_exponent: units.exponent as i8,
        world_centre: units.centre,
        centre_exponent: units.centre_exponent as i8,
        turntable: scene.animation.turntable.unwrap_or(0),
        frames: scene.animation.frames.unwrap_or(0),
        dither_pattern: match scene.palette.dithering {
            Dithering::None => core_scene::DitherPattern::None,
            Dithering::Bayer4 => core_scene::DitherPattern::Bayer4,
            Dithering::Bayer8 => core_scene::DitherPattern::Bayer8,
        } as u8,
        direct: scene.palette.direct,
        dither_spread: (spread * 255.0 * 64.0).round() as u16,
        cycle: cycle.map_or((0, 0), |c| (c.first as u16, (c.last - c.first + 1) as u16)),
        cycle_frames: cycle.map_or(0, |c| c.frames),
        level_error: scene.lod.map_or(0, |lod| {
            let [across, down] = scene.display.samples.map(f64::from);
            // In the frame's pixels, of which there may be several a pixel of the picture.
            let sub_pixels = lod.error * across.min(down) * f64::from(1 << SUBPX_BITS);
            sub_pixels.round().max(1.0) as u16
        }),
        // Until it is known what the whole needs.
        features: (1 << FEATURES) - 1,
        camera,
    })
}

/// A panel's colours, by their number.
pub(crate) fn colour_format(format: ColourFormat) -> u8 {
    match format {
        ColourFormat::Rgb888 => 0,
        ColourFormat::Rgb565 => 1,
        ColourFormat::Rgb444 => 2,
        ColourFormat::Gray8 => 3,
        ColourFormat::Gray4 => 4,
        ColourFormat::Gray2 => 5,
        ColourFormat::Mono => 6,
    }
}

/// The description's ways of dithering and the core's.
pub(crate) const PANEL_DITHERING: [(PanelDithering, core_scene::PanelDithering); 5] = [
    (PanelDithering::None, core_scene::PanelDithering::None),
    (PanelDithering::Bayer4, core_scene::PanelDithering::Bayer4),
    (PanelDithering::Bayer8, core_scene::PanelDithering::Bayer8),
    (
        PanelDithering::BlueNoise,
        core_scene::PanelDithering::BlueNoise,
    ),
    (
        PanelDithering::FloydSteinberg,
        core_scene::PanelDithering::FloydSteinberg,
    ),
];

pub(crate) fn panel_dithering(way: PanelDithering) -> core_scene::PanelDithering {
    let found = PANEL_DITHERING.iter().find(|(own, _)| *own == way);
    found.map_or(core_scene::PanelDithering::None, |(_, core)| *core)
}

/// A camera of the description in a baked scene's world, as if it stood in the scene's
/// file.
///
/// # Errors
/// If the world does not hold it.
pub fn camera_in(
    blob: &fixel::Scene<'_>,
    camera: &Camera,
) -> Result<core_scene::Camera, BakeError> {
    let header = blob.header();
    let units = Units {
        exponent: header.world_exponent.into(),
        centre: header.world_centre,
        centre_exponent: header.centre_exponent.into(),
    };
    Ok(self::camera(camera, Element::Camera, &units)?.camera())
}

/// A camera's record.
pub(crate) fn camera(
    camera: &Camera,
    element: Element,
    units: &Units,
) -> Result<CameraRecord, BakeError> {
    let spot = |what| Spot::new(element, what);
    let (mut focus, eye) = (
        DVec3::from(camera.focal_point),
        DVec3::from(camera.position),
    );
    // A focal point far from the scene, which can only be a direction, comes nearer.
    let sight = focus - eye;
    let world = |power: i32| f64::exp2(f64::from(power - units.exponent));
    let longest = world(14);
    if sight.length() > longest {
        focus = eye + sight.normalize_or_zero() * longest;
    }
    // One so near that a world unit's fractions do not tell its direction goes farther.
    if sight.length() < world(-8) {
        focus = eye + sight.normalize_or_zero() * world(0);
    }
    let view_up = DVec3::from(camera.view_up);
    if sight.length() == 0.0 || view_up.length() == 0.0 {
        return Err(Problem::NoDirection.at(element));
    }
    let (projection, half_height) = match camera.projection {
        Projection::Perspective { view_angle } => {
            let tangent = (view_angle.to_radians() / 2.0).tan() * f64::exp2(24.0);
            if !(1.0..f64::exp2(32.0)).contains(&tangent) {
                let problem = Problem::Range {
                    what: "camera.view_angle".into(),
                    value: view_angle,
                    most: 179.0,
                };
                return Err(problem.at(element));
            }
            (0, tangent.round() as u32)
        }
        Projection::Parallel { parallel_scale } => {
            let half = units.length(spot("camera.parallel_scale"), parallel_scale)?;
            (1, half.max(1) as u32)
        }
    };
    let (near, far, range_exponent) =
        range(camera, spot("camera.clipping_range"), units, projection)?;
    Ok(CameraRecord {
        position: units.place(spot("camera.position"), eye)?,
        focal_point: units.place(spot("camera.focal_point"), focus)?,
        // Only its direction counts.
        view_up: unit_q30(view_up),
        projection,
        half_height,
        range_exponent,
        near,
        far,
    })
}

/// Near, far and the power of two that they are in.
fn range(
    camera: &Camera,
    spot: Spot<'_>,
    units: &Units,
    projection: u8,
) -> Result<(i32, i32, u8), BakeError> {
    let [near, far] = camera.clipping_range;
    if projection == 0 {
        // What is farther than a world length holds is farther than all there is.
        let near = units.length(spot, near)?.max(1);
        let far = units.bits(far).unwrap_or(i32::MAX);
        return Ok((near, far.max(near.saturating_add(1)), 0));
    }
    let fits = |exponent: &u8| {
        let unit = f64::exp2(-f64::from(*exponent));
        [near, far].iter().all(|d| units.bits(d * unit).is_some())
    };
    let Some(exponent) = (0..=11).find(fits) else {
        let most = units.scene_length(f64::exp2(26.0));
        let problem = Problem::Range {
            what: spot.what.into(),
            value: far,
            most,
        };
        return Err(problem.at(spot.element));
    };
    let unit = f64::exp2(-f64::from(exponent));
    let (near, far) = (
        units.length(spot, near * unit)?,
        units.length(spot, far * unit)?,
    );
    Ok((near, far.max(near.saturating_add(1)), exponent))
}

/// What actors have of the blob's other records.
pub(crate) struct Instances<'a> {
    pub instances: &'a [Instance],
    /// For each actor, its instance and its even factor.
    pub uses: &'a [(usize, f64)],
    pub grids: &'a [Grid],
    /// For each actor, its material.
    pub materials: &'a [u16],
}

pub(crate) fn actors(
    scene: &Scene,
    units: &Units,
    placed: &[Placed],
    all: &Instances<'_>,
) -> Result<Vec<core_scene::Actor>, BakeError> {
    let actor = |number: usize| {
        let (actor, placed) = (&scene.actors[number], &placed[number]);
        let (which, factor) = all.uses[number];
        let (instance, grid) = (&all.instances[which], &all.grids[which]);
        let record = core_scene::Actor {
            mesh: which as u16,
            material: all.materials[number],
            position: [0; 3],
            orientation: [0; 3],
            offset: [0; 3],
            step_mantissa: 0,
            step_exponent: 0,
            parent: actor.parent.map(|parent| parent as u16),
            still: actor.still,
            part: actor.part,
        };
        if actor.look.space == Space::Screen {
            // A world unit is a pixel.
            let step = f64::exp2(-f64::from(grid.exponent));
            let (step_mantissa, step_exponent) = mantissa_exponent(step);
            let pixels = |c: f64| (c * 65536.0).round() as i32;
            return Ok(core_scene::Actor {
                offset: grid.centre.to_array().map(pixels),
                step_mantissa,
                step_exponent,
                ..record
            });
        }
        let offset = (grid.centre - instance.linear * DVec3::from(actor.origin)) * factor;
        let (name, element) = (&actor.name, Element::Actor(number));
        let step = factor * f64::exp2(f64::from(units.exponent - grid.exponent));
        let (step_mantissa, step_exponent) = mantissa_exponent(step);
        let (least, most) = STEP_EXPONENTS;
        if !(least..=most).contains(&step_exponent) {
            let problem = Problem::Range {
                what: format!("actor `{name}`: scale"),
                value: factor,
                most: f64::exp2(f64::from(most)) * factor / step,
            };
            return Err(problem.at(element));
        }
        Ok(core_scene::Actor {
            position: placed.position(units, (number, actor), actor.position)?,
            orientation: placed.orientation.map(turns),
            offset: units.vector(
                Spot::new(element, &format!("actor `{name}`: origin")),
                offset,
            )?,
            step_mantissa,
            step_exponent,
            ..record
        })
    };
    (0..scene.actors.len()).map(actor).collect()
}
