//! The blob: all parts together.

use std::collections::HashMap;

use fixel::scene::layout::{self, CHECKED_FROM, HEADER_WORDS, LIGHTS, PREFIX_BYTES, SECTIONS};
use fixel::scene::{self as core_scene, Header, Record};
use fixel_scene::{
    ColourFormat, Cull, Light, LightKind, Material, Mesh, Projection, Scene, Shading,
};
use glam::{DVec3, IVec3};

use crate::grid::{Bounds, Grid};
use crate::instance::{Instance, instances};
use crate::palette::{ambient_level, tables};
use crate::units::{Units, mantissa_exponent, turns, unit_q30, world_exponent};
use crate::{BakeError, meshlet, normal};

/// A baked scene.
#[derive(Clone, Debug)]
pub struct Baked {
    words: Vec<u32>,
    /// For each triangle of the blob, where it comes from.
    pub sources: Vec<Source>,
}

/// A triangle of the description.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Source {
    /// Index into the description's meshes.
    pub mesh: u32,
    /// Index into that mesh's triangles.
    pub triangle: u32,
}

impl Baked {
    /// The blob's bytes, aligned as the core needs them.
    pub fn bytes(&self) -> &[u8] {
        bytemuck::cast_slice(&self.words)
    }
}

/// Sections as they grow.
#[derive(Default)]
struct Parts {
    meshes: Vec<core_scene::Mesh>,
    meshlets: Vec<core_scene::Meshlet>,
    vertices: Vec<[i16; 4]>,
    triangles: Vec<[u8; 3]>,
    face_normals: Vec<[i8; 2]>,
    sources: Vec<Source>,
    grids: Vec<Grid>,
}

/// Bakes a scene.
///
/// # Errors
/// If the scene has more of something than the format holds, a number out of
/// its range, or asks for what the renderer cannot do yet.
pub fn bake(scene: &Scene) -> Result<Baked, BakeError> {
    at_most("actors", scene.actors.len(), 65535)?;
    at_most("materials", scene.materials.len(), 65535)?;
    at_most("lights with a direction", scene.lights.len(), LIGHTS)?;
    let units = Units {
        exponent: world_exponent(scene),
    };
    let tables = tables(scene);
    let (instances, uses) = instances(scene);
    let mut parts = Parts::default();
    for instance in &instances {
        parts.add_mesh(instance, &scene.meshes[instance.mesh]);
    }
    let actors = actors(scene, &units, &instances, &uses, &parts.grids)?;
    let lights = scene
        .lights
        .iter()
        .map(light)
        .collect::<Result<Vec<_>, _>>()?;
    let materials = scene
        .materials
        .iter()
        .enumerate()
        .map(|(i, m)| material(scene, i as u16, m));
    let materials = materials.collect::<Result<Vec<_>, _>>()?;

    let words = |records: &[u8]| records.to_vec();
    let sections: [(Vec<u8>, usize); SECTIONS] = [
        (words(tables.palette.as_flattened()), tables.palette.len()),
        (words(tables.shades.as_flattened()), tables.shades.len()),
        (words(&tables.background), tables.background.len()),
        records(&lights),
        records(&materials),
        records(&actors),
        records(&parts.meshes),
        records(&parts.meshlets),
        (little_endian(&parts.vertices), parts.vertices.len()),
        (words(parts.triangles.as_flattened()), parts.triangles.len()),
        (
            parts
                .face_normals
                .as_flattened()
                .iter()
                .map(|c| *c as u8)
                .collect(),
            parts.face_normals.len(),
        ),
    ];
    let words = assemble(header(scene, &units)?, &sections)?;
    Ok(Baked {
        words,
        sources: parts.sources,
    })
}

fn at_most(what: &'static str, found: usize, most: usize) -> Result<(), BakeError> {
    if found <= most {
        Ok(())
    } else {
        Err(BakeError::TooMany { what, found, most })
    }
}

/// Header, section table and sections; then length and checksum.
fn assemble(
    header: Header,
    sections: &[(Vec<u8>, usize); SECTIONS],
) -> Result<Vec<u32>, BakeError> {
    let mut body: Vec<u8> = Vec::new();
    let mut table = Vec::new();
    for (bytes, count) in sections {
        table.push((PREFIX_BYTES + body.len()) as u32);
        table.push(*count as u32);
        body.extend(bytes);
        body.resize(body.len().next_multiple_of(4), 0);
    }
    let length = PREFIX_BYTES + body.len();
    at_most("bytes", length, i32::MAX as usize)?;
    let mut words = vec![0; HEADER_WORDS];
    words.extend(table.iter().map(|w| w.to_le()));
    words.extend(
        body.chunks_exact(4)
            .map(|c| u32::from_ne_bytes([c[0], c[1], c[2], c[3]])),
    );
    let mut header = Header {
        length: length as u32,
        ..header
    };
    words[..HEADER_WORDS].copy_from_slice(&header.to_words());
    header.checksum = core_scene::checksum(&words[CHECKED_FROM / 4..]);
    words[..HEADER_WORDS].copy_from_slice(&header.to_words());
    Ok(words)
}

fn records<R: Record>(records: &[R]) -> (Vec<u8>, usize)
where
    R::Words: bytemuck::NoUninit,
{
    let words: Vec<R::Words> = records.iter().map(Record::to_words).collect();
    (bytemuck::cast_slice(&words).to_vec(), records.len())
}

fn little_endian(vertices: &[[i16; 4]]) -> Vec<u8> {
    vertices
        .as_flattened()
        .iter()
        .flat_map(|v| v.to_le_bytes())
        .collect()
}

fn header(scene: &Scene, units: &Units) -> Result<Header, BakeError> {
    let camera = &scene.camera;
    let [mut near, mut far] = camera.clipping_range;
    let (focus, mut eye) = (
        DVec3::from(camera.focal_point),
        DVec3::from(camera.position),
    );
    let (projection, half_height) = match camera.projection {
        Projection::Perspective { view_angle } => {
            let tangent = (view_angle.to_radians() / 2.0).tan() * f64::exp2(24.0);
            if !(1.0..f64::exp2(32.0)).contains(&tangent) {
                return Err(BakeError::Range {
                    what: "camera.view_angle".into(),
                    value: view_angle,
                });
            }
            (0, tangent.round() as u32)
        }
        Projection::Parallel { parallel_scale } => {
            if near <= 0.0 {
                // The eye may stand anywhere along the line of sight: back to
                // where all is in front of it.
                let back = far - near;
                let away = (eye - focus).normalize_or_zero();
                eye += away * back;
                (near, far) = (near + back, far + back);
            }
            let half = units.length("camera.parallel_scale", parallel_scale)?;
            (1, half.max(1) as u32)
        }
    };
    // What is farther than a world length holds is farther than all there is.
    let far = match units.length("camera.clipping_range", far) {
        Ok(far) => far,
        Err(_) if projection == 0 => i32::MAX,
        Err(error) => return Err(error),
    };
    let near = units.length("camera.clipping_range", near)?.max(1);
    Ok(Header {
        length: 0,
        checksum: 0,
        width: scene.display.width as u16,
        height: scene.display.height as u16,
        colour_format: match scene.display.colour {
            ColourFormat::Rgb888 => 0,
            ColourFormat::Rgb565 => 1,
            ColourFormat::Rgb444 => 2,
            ColourFormat::Gray8 => 3,
            ColourFormat::Gray4 => 4,
            ColourFormat::Gray2 => 5,
            ColourFormat::Mono => 6,
        },
        world_exponent: units.exponent as i8,
        turntable: scene.animation.turntable.unwrap_or(0),
        position: units.point("camera.position", eye)?,
        focal_point: units.point("camera.focal_point", focus)?,
        // Only its direction counts.
        view_up: unit_q30(DVec3::from(camera.view_up)),
        projection,
        half_height,
        near,
        far: far.max(near + 1),
    })
}

fn light(light: &Light) -> Result<core_scene::Light, BakeError> {
    let LightKind::Directional { direction } = light.kind;
    let [r, g, b] = light.colour;
    if r != g || g != b {
        return Err(BakeError::NotYet {
            what: "a coloured light".into(),
        });
    }
    let intensity = light.intensity * r;
    if !(0.0..=32.0).contains(&intensity) {
        return Err(BakeError::Range {
            what: "light.intensity".into(),
            value: intensity,
        });
    }
    Ok(core_scene::Light {
        towards: unit_q30(-DVec3::from(direction)),
        intensity: (intensity * 65536.0).round() as u32,
    })
}

fn material(
    scene: &Scene,
    shade: u16,
    material: &Material,
) -> Result<core_scene::Material, BakeError> {
    let name = &material.name;
    let [r, g, b] = scene.ambient;
    if r != g || g != b {
        return Err(BakeError::NotYet {
            what: "coloured ambient light".into(),
        });
    }
    if material.ambient > 0.0 && material.ambient_colour != material.diffuse_colour {
        let what = format!("material `{name}`: an ambient colour other than the diffuse one");
        return Err(BakeError::NotYet { what });
    }
    Ok(core_scene::Material {
        shading: match material.shading {
            Shading::Flat => core_scene::Shading::Flat,
            Shading::Gouraud => core_scene::Shading::Gouraud,
        },
        cull: match material.cull {
            Cull::Back => core_scene::Cull::Back,
            Cull::Front => core_scene::Cull::Front,
            Cull::None => core_scene::Cull::None,
        },
        shade,
        ambient: (ambient_level(material, r) * 64.0).round() as u16,
        diffuse: (material.diffuse.clamp(0.0, 1.0) * 65536.0).round() as u32,
    })
}

fn actors(
    scene: &Scene,
    units: &Units,
    instances: &[Instance],
    uses: &[(usize, f64)],
    grids: &[Grid],
) -> Result<Vec<core_scene::Actor>, BakeError> {
    let actor = |(actor, (which, factor)): (&fixel_scene::Actor, &(usize, f64))| {
        let (instance, grid) = (&instances[*which], &grids[*which]);
        let origin = DVec3::from(actor.origin);
        let pivot = DVec3::from(actor.position) + origin;
        let offset = (grid.centre - origin * instance.scale) * *factor;
        let name = &actor.name;
        let step = factor * f64::exp2(f64::from(units.exponent - grid.exponent));
        let (step_mantissa, step_exponent) = mantissa_exponent(step);
        if !(-64..=32).contains(&step_exponent) {
            return Err(BakeError::Range {
                what: format!("actor `{name}`: scale"),
                value: *factor,
            });
        }
        Ok(core_scene::Actor {
            mesh: *which as u16,
            material: actor.material as u16,
            position: units.point(&format!("actor `{name}`: position"), pivot)?,
            orientation: actor.orientation.map(turns),
            offset: units.point(&format!("actor `{name}`: origin"), offset)?,
            step_mantissa,
            step_exponent,
        })
    };
    scene.actors.iter().zip(uses).map(actor).collect()
}

impl Parts {
    fn add_mesh(&mut self, instance: &Instance, mesh: &Mesh) {
        let positions = instance.positions(mesh);
        let normals = instance.normals(mesh);
        // Vertices that differ only in a normal that nobody needs are one.
        let keep = if instance.smooth {
            (0..positions.len() as u32).collect()
        } else {
            weld(&positions)
        };
        let wide: Vec<(usize, [u32; 3])> = mesh
            .triangles
            .iter()
            .enumerate()
            .map(|(i, t)| (i, instance.corners(*t).map(|v| keep[v as usize])))
            .filter(|(_, t)| has_area(&positions, t))
            .collect();
        let triangles: Vec<[u32; 3]> = wide.iter().map(|(_, t)| *t).collect();
        let clusters = meshlet::clusters(&positions, &triangles);
        let members = |cluster: &meshlet::Cluster| {
            Bounds::of(
                cluster
                    .iter()
                    .flat_map(|t| triangles[*t])
                    .map(|v| positions[v as usize]),
            )
        };
        let used = triangles
            .as_flattened()
            .iter()
            .map(|v| positions[*v as usize]);
        let grid = Grid::new(Bounds::of(used), clusters.iter().map(members));
        let snapped: Vec<IVec3> = positions.iter().map(|p| grid.snap(*p)).collect();

        let first_meshlet = self.meshlets.len() as u32;
        let mut radius: f64 = 4096.0;
        for cluster in &clusters {
            let list: Vec<[u32; 3]> = cluster.iter().map(|t| triangles[*t]).collect();
            self.add_meshlet(&list, &positions, &snapped, &normals, instance.flat);
            self.sources.extend(cluster.iter().map(|t| Source {
                mesh: instance.mesh as u32,
                triangle: wide[*t].0 as u32,
            }));
            let length = |v: &u32| snapped[*v as usize].as_dvec3().length();
            radius = list
                .as_flattened()
                .iter()
                .map(length)
                .fold(radius, f64::max);
        }
        self.meshes.push(core_scene::Mesh {
            first_meshlet,
            meshlets: clusters.len() as u32,
            radius: radius.ceil() as u32 + 1,
            face_normals: instance.flat,
        });
        self.grids.push(grid);
    }

    fn add_meshlet(
        &mut self,
        list: &[[u32; 3]],
        positions: &[DVec3],
        snapped: &[IVec3],
        normals: &[DVec3],
        flat: bool,
    ) {
        let mut members: Vec<u32> = Vec::new();
        for v in list.as_flattened() {
            if !members.contains(v) {
                members.push(*v);
            }
        }
        let points = || members.iter().map(|v| snapped[*v as usize]);
        let low = points().fold(IVec3::MAX, IVec3::min);
        let high = points().fold(IVec3::MIN, IVec3::max);
        let base = low + (high - low) / 2;
        let radius = points()
            .map(|p| (p - base).as_dvec3().length())
            .fold(0.0, f64::max);

        let faces: Vec<DVec3> = list
            .iter()
            .map(|t| {
                let [a, b, c] = t.map(|v| positions[v as usize]);
                (b - a).cross(c - a).normalize_or_zero()
            })
            .collect();
        let (cone_axis, cone_cutoff) = cone(&faces);
        self.meshlets.push(core_scene::Meshlet {
            base: base.to_array(),
            radius: radius.ceil() as u16,
            vertices: members.len() as u8,
            triangles: list.len() as u8,
            cone_axis,
            cone_cutoff,
            first_vertex: self.vertices.len() as u32,
            first_triangle: self.triangles.len() as u32,
        });
        for v in &members {
            let from_base = (snapped[*v as usize] - base).to_array().map(|c| c as i16);
            let code = normal::encode(normals[*v as usize]).map(|c| c as u8);
            let [x, y, z] = from_base;
            self.vertices.push([x, y, z, i16::from_le_bytes(code)]);
        }
        let index: HashMap<u32, u8> = members
            .iter()
            .enumerate()
            .map(|(i, v)| (*v, i as u8))
            .collect();
        self.triangles
            .extend(list.iter().map(|t| t.map(|v| index[&v])));
        if flat {
            self.face_normals
                .extend(faces.iter().map(|n| normal::encode(*n)));
        }
    }
}

/// For each vertex the first one at the same place.
fn weld(positions: &[DVec3]) -> Vec<u32> {
    let mut first = HashMap::new();
    let key = |p: &DVec3| p.to_array().map(|c| (c + 0.0).to_bits());
    positions
        .iter()
        .enumerate()
        .map(|(i, p)| *first.entry(key(p)).or_insert(i as u32))
        .collect()
}

fn has_area(positions: &[DVec3], t: &[u32; 3]) -> bool {
    let [a, b, c] = t.map(|v| positions[v as usize]);
    (b - a).cross(c - a) != DVec3::ZERO
}

/// Axis and cutoff of the cone of face normals; see
/// [`core_scene::Meshlet::cone_cutoff`].
fn cone(faces: &[DVec3]) -> ([i8; 3], i8) {
    let axis = faces.iter().sum::<DVec3>().normalize_or_zero();
    let narrowest = faces.iter().map(|n| n.dot(axis)).fold(1.0, f64::min);
    if narrowest <= 0.05 {
        return ([0; 3], 127);
    }
    let coarse = (axis * 127.0).round();
    // What rounding the axis costs is added to the cutoff.
    let off = (coarse / 127.0 - axis).length();
    let cutoff = ((1.0 - narrowest * narrowest).max(0.0).sqrt() + off) * 127.0;
    (
        coarse.to_array().map(|c| c as i8),
        cutoff.ceil().min(127.0) as i8,
    )
}

const _: () = assert!(layout::MESHLET_TRIANGLES <= u8::MAX as usize);
