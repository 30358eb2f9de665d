//! Points from space to space and back, in fixed point, against f64; and picking.

use fixed::types::{I8F24, U8F24};
use fixel::math::{Angle, Factor, SubPx, Vec3, World};
use fixel::scene::{Camera, Place, Placement, Projection};
use fixel::view::{DisplayPoint, ViewFrame};
use fixel_host::Options;
use fixel_tests::{load, root};
use glam::DVec3;
use proptest::prelude::*;

const UNIT: f64 = 65536.0;

fn place(v: Vec3) -> DVec3 {
    DVec3::from(v.to_bits().map(f64::from)) / UNIT
}

fn bits(v: DVec3) -> Vec3 {
    Vec3::from_bits((v * UNIT).round().to_array().map(|c| c as i32))
}

#[derive(Clone, Debug)]
struct Case {
    camera: Camera,
    size: [u16; 2],
    /// Across, up (1: the picture's side) and along the line of sight, from near (0)
    /// to far (1).
    point: DVec3,
}

fn vector(reach: f64) -> impl Strategy<Value = DVec3> {
    prop::array::uniform3(-reach..reach).prop_map(DVec3::from)
}

fn case() -> impl Strategy<Value = Case> {
    let lens = (any::<bool>(), -6.0..6.0f64, -3.0..6.0f64, 1.0..8.0f64);
    let size = (1u16..2048, 1u16..2048);
    (
        vector(8000.0),
        vector(1.0),
        vector(1.0),
        lens,
        size,
        vector(1.0),
    )
        .prop_filter_map(
            "directions",
            |(eye, sight, up, (parallel, opening, near, range), (width, height), point)| {
                let (sight, up) = (sight.try_normalize()?, up.try_normalize()?);
                if sight.cross(up).length() < 0.1 {
                    return None;
                }
                let near = near.exp2();
                let far = (near * range.exp2()).min(16000.0);
                Some(Case {
                    camera: Camera {
                        position: bits(eye),
                        focal_point: bits(eye + sight * 1000.0),
                        view_up: bits(up * 1000.0),
                        projection: if parallel {
                            let half_height = World::from_num((opening + 7.0).exp2());
                            Projection::Parallel { half_height }
                        } else {
                            let tan_half_angle = U8F24::from_num(opening.exp2());
                            Projection::Perspective { tan_half_angle }
                        },
                        near: World::from_num(near),
                        far: World::from_num(far),
                        range_exponent: 0,
                    },
                    size: [width, height],
                    point: DVec3::new(point.x, point.y, point.z.abs()),
                })
            },
        )
}

/// The same camera in f64.
struct Exact {
    eye: DVec3,
    axes: [DVec3; 3],
    /// Half the picture at distance 1, or in world units.
    half: [f64; 2],
    perspective: bool,
    near: f64,
    far: f64,
}

impl Exact {
    fn of(case: &Case) -> Self {
        let camera = &case.camera;
        let eye = place(camera.position);
        let back = (eye - place(camera.focal_point)).normalize();
        let right = place(camera.view_up).cross(back).normalize();
        let (high, perspective) = match camera.projection {
            Projection::Perspective { tan_half_angle } => (tan_half_angle.to_num::<f64>(), true),
            Projection::Parallel { half_height } => (half_height.to_num(), false),
        };
        let [width, height] = case.size.map(f64::from);
        Self {
            eye,
            axes: [right, back.cross(right), back],
            half: [high * width / height, high],
            perspective,
            near: camera.near.to_num(),
            far: camera.far.to_num(),
        }
    }

    /// The case's point in view space.
    fn view(&self, case: &Case) -> DVec3 {
        let distance = self.near + (self.far - self.near) * case.point.z;
        let size = if self.perspective { distance } else { 1.0 };
        let [x, y] = self.half;
        DVec3::new(case.point.x * x * size, case.point.y * y * size, -distance)
    }

    fn to_world(&self, view: DVec3) -> DVec3 {
        let [x, y, z] = self.axes;
        self.eye + x * view.x + y * view.y + z * view.z
    }

    fn depth(&self, distance: f64) -> f64 {
        if self.perspective {
            self.near / distance
        } else {
            (self.far - distance) / (self.far - self.near)
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(4000))]

    #[test]
    fn there_and_back(case in case()) {
        let exact = Exact::of(&case);
        // Steeper lines of sight than 1000 saturate.
        prop_assume!(!exact.perspective || exact.half[0] < 500.0);
        let [width, height] = case.size;
        let frame = ViewFrame::new(&case.camera, width, height);
        let view = exact.view(&case);
        let world = exact.to_world(view);
        prop_assume!(world.abs().max_element() < 32000.0 && view.abs().max_element() < 32000.0);

        // World and view: half a step of each of three coordinates there, half a step
        // here, and what the axes (2^-28) add over the way.
        let way = view.length();
        let step = 1.5 / UNIT + way * f64::exp2(-26.0);
        let seen = frame.world_to_view(bits(world));
        prop_assert!((place(seen) - view).abs().max_element() < step, "{seen:?} is not {view}");
        let again = frame.view_to_world(seen);
        prop_assert!((place(again) - world).abs().max_element() < 3.0 * step);

        // The picture, from the rounded point.
        let view = place(seen);
        let distance = -view.z;
        prop_assume!(distance > 0.1);
        let size = if exact.perspective { distance } else { 1.0 };
        let ndc = frame.view_to_ndc(seen).expect("before the eye");
        for (found, view, half) in [(ndc.x, view.x, exact.half[0]), (ndc.y, view.y, exact.half[1])] {
            let exact = view / size / half;
            let off = (found.to_num::<f64>() - exact).abs();
            // The lens has 29 bits or more.
            let most = f64::exp2(-23.0) * (1.0 + exact.abs());
            prop_assert!(off < most, "ndc {found} is not {exact}, off by {off:e}");
        }
        let off = (ndc.depth.to_num::<f64>() - exact.depth(distance)).abs();
        prop_assert!(off < f64::exp2(-23.0), "depth {} is not {}", ndc.depth, exact.depth(distance));

        // Pixels.
        let display = frame.ndc_to_display(ndc);
        let pixels = [
            (display.x, (view.x / size / exact.half[0] + 1.0) / 2.0 * f64::from(width)),
            (display.y, (1.0 - view.y / size / exact.half[1]) / 2.0 * f64::from(height)),
        ];
        for (found, exact) in pixels {
            let off = (found.to_num::<f64>() - exact).abs();
            prop_assert!(off < 1.0 / 2048.0, "pixel {found} is not {exact}");
        }
        prop_assert_eq!(Some(display), frame.world_to_display(bits(world)));

        // Back: as exact as the picture's steps are, at this distance.
        let back = frame.ndc_to_view(ndc).expect("a depth above 0");
        let share = if exact.perspective {
            // A step of depth is so much of the distance.
            f64::exp2(-24.0) / ndc.depth.to_num::<f64>()
        } else {
            f64::exp2(-24.0) * (exact.far - exact.near) / distance
        };
        let most = 2.0 / UNIT + share * way + f64::exp2(-23.0) * (exact.half[0] + exact.half[1] + 1.0) * size;
        prop_assert!(
            (place(back) - view).length() < 2.0 * most,
            "{} is not {view}, most {most}", place(back)
        );

        // The line of sight through it.
        let ray = frame.ray(display.x, display.y);
        let direction = DVec3::from(ray.direction.map(f64::from)) / f64::exp2(30.0);
        prop_assert!((direction.length() - 1.0).abs() < 1e-7);
        let to = exact.to_world(view) - place(ray.origin);
        let aside = to.cross(direction).length();
        // A pixel's 4096th at this distance, in both directions.
        let pixel = size * (exact.half[0] / f64::from(width) + exact.half[1] / f64::from(height)) * 2.0;
        let most = pixel / 2048.0 + 3.0 / UNIT + to.length() * f64::exp2(-23.0);
        prop_assert!(aside < most, "{aside} aside of {to}, most {most}");
    }

    #[test]
    fn an_actors_space_and_the_world(
        position in vector(8000.0),
        orientation in any::<[u32; 3]>(),
        factor in 0.01..20.0f64,
        model in vector(400.0),
    ) {
        let place = Place::from(Placement {
            position: bits(position),
            orientation: orientation.map(Angle::from_bits),
            scale: Factor::from_num(factor),
        });
        let model = bits(model);
        let world = place.model_to_world(model);
        let length = self::place(world).distance(self::place(bits(position)));
        let wanted = self::place(model).length() * place.scale.to_num::<f64>();
        prop_assert!((length - wanted).abs() < 2.0 / UNIT + wanted * 1e-7);
        let back = self::place(place.world_to_model(world)) - self::place(model);
        let most = 2.0 / UNIT + 2.0 / UNIT / factor + self::place(model).length() * 1e-7;
        prop_assert!(back.abs().max_element() < most, "{back}");
    }
}

#[test]
fn behind_the_eye_is_nowhere() {
    let (_, baked) = load(&root().join("scenes/cube.toml"));
    let scene = baked.scene().expect("baked a moment ago");
    let camera = scene.pose(0).camera;
    let frame = ViewFrame::new(&camera, 320, 240);
    assert_eq!(frame.world_to_display(camera.position), None);
    let middle = frame
        .world_to_display(camera.focal_point)
        .expect("in sight");
    assert!((middle.x.to_num::<f64>() - 160.0).abs() < 0.001);
    assert!((middle.y.to_num::<f64>() - 120.0).abs() < 0.001);
    let depth = I8F24::ZERO;
    let nowhere = DisplayPoint { depth, ..middle };
    assert_eq!(frame.display_to_world(nowhere), None);
}

/// What is picked is what is drawn, and the line of sight goes through it.
#[test]
fn picking() {
    for name in ["many_actors", "parents", "viewports"] {
        let (_, baked) = load(&root().join(format!("scenes/{name}.toml")));
        let scene = baked.scene().expect("baked a moment ago");
        let options = Options {
            frame: 7,
            ..Options::of(&scene)
        };
        let (frame, _) = fixel_host::frame(&baked, &scene, &options);
        let (mut hits, mut misses) = (0, 0);
        for (x, y) in (3..options.width)
            .step_by(37)
            .flat_map(|x| (2..options.height).step_by(23).map(move |y| (x, y)))
        {
            let at = usize::from(y) * usize::from(options.width) + usize::from(x);
            match fixel_host::pick(&scene, &options, x, y) {
                None => {
                    assert_eq!(frame.actor[at], 0, "{name} at {x}, {y}");
                    misses += 1;
                }
                Some(picked) => {
                    assert_eq!(frame.actor[at], picked.actor + 1, "{name} at {x}, {y}");
                    let source = baked.sources.triangles[picked.triangle as usize];
                    assert_eq!(frame.triangle[at], source.triangle, "{name} at {x}, {y}");
                    assert_eq!(frame.depth[at], picked.depth, "{name} at {x}, {y}");
                    hits += 1;
                }
            }
        }
        assert!(hits > 5 && misses > 5, "{name}: {hits} and {misses}");
        assert_eq!(fixel_host::pick(&scene, &options, options.width, 0), None);
        assert_eq!(fixel_host::pick(&scene, &options, 0, options.height), None);
    }
}

/// The place under a pixel, by its depth: on the reference's surface there.
#[test]
fn the_place_under_a_pixel() {
    let (description, baked) = load(&root().join("scenes/teapot.toml"));
    let scene = baked.scene().expect("baked a moment ago");
    let options = Options::of(&scene);
    let size = [options.width, options.height];
    let frame = ViewFrame::new(&scene.pose(0).camera, size[0], size[1]);
    let unit = f64::from(scene.world_exponent()).exp2();
    let camera = fixel_reference::camera_at(&description, 0);
    let view = fixel_reference::View::new(&camera, size[0].into(), size[1].into());
    let (x, y) = (150, 120);
    let picked = fixel_host::pick(&scene, &options, x, y).expect("the pot is there");
    let depth = f64::from(picked.depth) / 65535.0;
    let centre = |pixel: u16| SubPx::from_num(f64::from(pixel) + 0.5);
    let point = DisplayPoint {
        x: centre(x),
        y: centre(y),
        depth: I8F24::from_num(depth),
    };
    let world = frame.display_to_world(point).expect("a depth above 0");
    let seen = view.to_view(place(world) / unit);
    let distance = camera.clipping_range[0] / depth;
    assert!(
        (seen.z - distance).abs() < 0.01 * distance,
        "{seen} at {distance}"
    );
    let ray = frame.ray(point.x, point.y);
    let direction = DVec3::from(ray.direction.map(f64::from)).normalize();
    let aside = (place(world) - place(ray.origin)).cross(direction).length();
    assert!(aside < 0.01, "{aside}");
}
