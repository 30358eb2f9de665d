//! A camera moved by hand, as VTK's trackball moves one (vtkInteractorStyleTrackballCamera),
//! and as text for a scene file.

use fixel_scene::{Camera, Projection, Reach};
use glam::{DQuat, DVec3};

/// Degrees that the eye turns when the mouse crosses the picture.
const TURN: f64 = 200.0;

/// Turns the eye about what it looks at: `right` and `down` are ways of the mouse, as parts
/// of the picture's width and height.
pub fn rotate(camera: &mut Camera, right: f64, down: f64) {
    let (eye, focus, up) = vectors(camera);
    let azimuth = DQuat::from_axis_angle(up, (-right * TURN).to_radians());
    let offset = azimuth * (eye - focus);
    let side = up.cross(-offset).normalize_or(DVec3::X);
    let elevation = DQuat::from_axis_angle(side, (down * TURN).to_radians());
    let offset = elevation * offset;
    camera.position = (focus + offset).into();
    // Perpendicular to the line of sight, so that going over the top is like going anywhere.
    camera.view_up = side.cross(offset).normalize_or(up).into();
}

/// Moves eye and focal point in the picture's plane, so that what is as far away as the
/// focal point follows the mouse. Ways are parts of the picture's height.
pub fn pan(camera: &mut Camera, right: f64, down: f64) {
    let (eye, focus, up) = vectors(camera);
    let sight = focus - eye;
    let height = match camera.projection {
        Projection::Perspective { view_angle } => {
            2.0 * sight.length() * (view_angle.to_radians() / 2.0).tan()
        }
        Projection::Parallel { parallel_scale } => 2.0 * parallel_scale,
    };
    let side = sight.cross(up).normalize_or(DVec3::X);
    let above = side.cross(sight).normalize_or(up);
    let way = (above * down - side * right) * height;
    camera.position = (eye + way).into();
    camera.focal_point = (focus + way).into();
}

/// Goes nearer by a factor above 1; or shows less, where distance changes nothing.
pub fn zoom(camera: &mut Camera, factor: f64, reach: &Reach) {
    let (eye, focus, _) = vectors(camera);
    match &mut camera.projection {
        Projection::Perspective { .. } => {
            let size = size(reach, focus);
            let distance = (eye - focus).length() / factor;
            let distance = distance.clamp(size * 1e-3, size * 20.0);
            let back = (eye - focus).normalize_or(DVec3::Z);
            camera.position = (focus + back * distance).into();
        }
        Projection::Parallel { parallel_scale } => {
            let size = size(reach, focus);
            *parallel_scale = (*parallel_scale / factor).clamp(size * 1e-3, size * 20.0);
        }
    }
}

/// Half of what there is to see.
fn size(reach: &Reach, focus: DVec3) -> f64 {
    let far = |(centre, radius): &([f64; 3], f64)| DVec3::from(*centre).distance(focus) + radius;
    let far = reach.actors.iter().map(far).fold(0.0, f64::max);
    if far > 0.0 { far } else { 1.0 }
}

/// Eye, focal point and the unit vector that points up.
fn vectors(camera: &Camera) -> (DVec3, DVec3, DVec3) {
    let up = DVec3::from(camera.view_up).normalize_or(DVec3::Y);
    (camera.position.into(), camera.focal_point.into(), up)
}

/// The camera as a scene file has it.
pub fn text(camera: &Camera) -> String {
    let vector = |v: [f64; 3]| {
        let [x, y, z] = v.map(short);
        format!("[{x}, {y}, {z}]")
    };
    let projection = match camera.projection {
        Projection::Perspective { view_angle } => format!("view_angle = {}", short(view_angle)),
        Projection::Parallel { parallel_scale } => format!(
            "projection = \"parallel\"\nparallel_scale = {}",
            short(parallel_scale)
        ),
    };
    let [near, far] = camera.clipping_range.map(short);
    format!(
        "[camera]\nposition = {}\nfocal_point = {}\nview_up = {}\n{projection}\n\
         clipping_range = [{near}, {far}]\n",
        vector(camera.position),
        vector(camera.focal_point),
        vector(camera.view_up),
    )
}

/// Seven digits.
fn short(value: f64) -> f64 {
    format!("{value:.6e}").parse().unwrap_or(value)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn camera() -> Camera {
        Camera {
            position: [0.0, 0.0, 10.0],
            focal_point: [0.0; 3],
            view_up: [0.0, 1.0, 0.0],
            projection: Projection::Perspective { view_angle: 30.0 },
            clipping_range: [1.0, 20.0],
        }
    }

    fn reach() -> Reach {
        Reach {
            actors: vec![([0.0; 3], 1.0)],
            views: Vec::new(),
        }
    }

    fn near(found: [f64; 3], expected: [f64; 3]) {
        let off = DVec3::from(found).distance(expected.into());
        assert!(off < 1e-9, "{found:?}, not {expected:?}");
    }

    #[test]
    fn the_object_follows_the_mouse() {
        // To the right: the eye goes to the left. Down: the eye goes up.
        let mut turned = camera();
        rotate(&mut turned, 90.0 / TURN, 0.0);
        near(turned.position, [-10.0, 0.0, 0.0]);
        near(turned.view_up, [0.0, 1.0, 0.0]);
        let mut turned = camera();
        rotate(&mut turned, 0.0, 90.0 / TURN);
        near(turned.position, [0.0, 10.0, 0.0]);
        near(turned.view_up, [0.0, 0.0, -1.0]);
        // A whole turn over the top comes back.
        for _ in 0..3 {
            rotate(&mut turned, 0.0, 90.0 / TURN);
        }
        near(turned.position, camera().position);
        near(turned.view_up, camera().view_up);
    }

    #[test]
    fn panning_moves_by_the_pictures_height() {
        let mut moved = camera();
        pan(&mut moved, 0.0, 1.0);
        let height = 20.0 * 15.0_f64.to_radians().tan();
        near(moved.focal_point, [0.0, height, 0.0]);
        near(moved.position, [0.0, height, 10.0]);
        moved.projection = Projection::Parallel {
            parallel_scale: 2.0,
        };
        pan(&mut moved, 0.5, 0.0);
        near(moved.focal_point, [-2.0, height, 0.0]);
    }

    #[test]
    fn zooming_has_ends() {
        let mut zoomed = camera();
        zoom(&mut zoomed, 2.0, &reach());
        near(zoomed.position, [0.0, 0.0, 5.0]);
        zoom(&mut zoomed, 1e9, &reach());
        near(zoomed.position, [0.0, 0.0, 1e-3]);
        zoom(&mut zoomed, 1e-9, &reach());
        near(zoomed.position, [0.0, 0.0, 20.0]);
        zoomed.projection = Projection::Parallel {
            parallel_scale: 3.0,
        };
        zoom(&mut zoomed, 1.5, &reach());
        let scale = Projection::Parallel {
            parallel_scale: 2.0,
        };
        assert_eq!(zoomed.projection, scale);
    }

    /// What is printed is a scene file's.
    #[test]
    fn the_text_is_read_back() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("a.toml");
        for projection in [
            Projection::Perspective { view_angle: 30.0 },
            Projection::Parallel {
                parallel_scale: 1.5,
            },
        ] {
            let camera = Camera {
                position: [0.1, -2.0, 12.345678],
                projection,
                ..camera()
            };
            let text = text(&camera) + "[[actor]]\nsphere = 1\n";
            std::fs::write(&path, text).expect("room");
            let scene = fixel_scene::load(&path).expect("a scene");
            near(scene.camera.position, [0.1, -2.0, 12.34568]);
            assert_eq!(scene.camera.projection, camera.projection);
            assert_eq!(scene.camera.clipping_range, camera.clipping_range);
        }
    }
}
