//! The blob: all parts together.

use fixel::scene::layout::{CHECKED_FROM, HEADER_WORDS, LIGHTS, PREFIX_BYTES, SECTIONS};
use fixel::scene::{Header, Mesh, Optics, Record, SceneError, Shape, checksum};
use fixel_scene::{Actor, Element, Scene, Space};

use crate::error::{BakeError, Problem, at_most};
use crate::facing::cones;
use crate::fog;
use crate::instance::instances;
use crate::light::{light, material};
use crate::look::looks;
use crate::mesh::{Parts, Source, Sources};
use crate::palette::{Sample, direct, needs_palette, tables};
use crate::placement::placed;
use crate::ray::{Rays, mixes, seen};
use crate::records::{Instances, actors, header};
use crate::simplify::levels;
use crate::texture::textures;
use crate::texturing::{Texturing, padded};
use crate::track::tracks;
use crate::transparency::{possible, transparencies};
use crate::units::Units;
use crate::viewport::{output, viewports};

/// Lines and points closer than this, half their extent in world units, get the grid
/// of such an extent: 2^-18 world units a step.
const LEAST_HALF: f64 = 8.0;

/// What rays meet of a coarser mesh.
const NO_SHAPE: Shape = Shape::Triangles {
    first_node: 0,
    nodes: 0,
};

/// A baked scene.
#[derive(Clone, Debug)]
pub struct Baked {
    words: Vec<u32>,
    /// For each triangle, edge and vertex of the blob, where it comes from.
    pub sources: Sources,
}

impl Baked {
    /// A blob from its bytes, checked.
    ///
    /// # Errors
    /// As [`fixel::Scene::parse`].
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, SceneError> {
        let mut words = vec![0u32; bytes.len().div_ceil(4)];
        bytemuck::cast_slice_mut(&mut words)[..bytes.len()].copy_from_slice(bytes);
        let scene = fixel::Scene::parse(&bytemuck::cast_slice(&words)[..bytes.len()])?;
        let mut sources = Sources::default();
        let meshes = || (0..scene.mesh_count()).map(|mesh| (mesh, scene.mesh(mesh)));
        let levels = |record: &Mesh| record.levels.0..record.levels.0 + u16::from(record.levels.1);
        let levels: Vec<u16> = meshes().flat_map(|(_, record)| levels(&record)).collect();
        let mut in_order: Vec<_> = meshes().collect();
        in_order.sort_by_key(|(_, record)| record.first_meshlet);
        for (mesh, record) in in_order {
            let is_level = levels.contains(&mesh);
            let meshlets = || record.first_meshlet..record.first_meshlet + record.meshlets;
            let all = || meshlets().filter_map(|m| scene.meshlet(m));
            let triangles: u32 = all().map(|m| u32::from(m.triangles)).sum();
            let edges: u32 = meshlets()
                .map(|m| scene.meshlet_edges(m).0.len() as u32)
                .sum();
            let vertices: u32 = all().map(|m| u32::from(m.vertices)).sum();
            let source = |triangle| Source {
                mesh: mesh.into(),
                triangle: if is_level { Source::LEVEL } else { triangle },
            };
            let after_edges = triangles + edges;
            sources.triangles.extend((0..triangles).map(source));
            sources.edges.extend((triangles..after_edges).map(source));
            let vertices = after_edges..after_edges + vertices;
            sources.vertices.extend(vertices.map(source));
        }
        Ok(Self { words, sources })
    }

    /// The scene, ready to be rendered.
    ///
    /// # Errors
    /// None for a blob of [`bake`] or [`Baked::from_bytes`].
    pub fn scene(&self) -> Result<fixel::Scene<'_>, SceneError> {
        fixel::Scene::parse(self.bytes())
    }

    pub(crate) fn of_words(words: Vec<u32>, sources: Sources) -> Self {
        Self { words, sources }
    }

    pub(crate) fn words(&self) -> &[u32] {
        &self.words
    }

    /// The blob's bytes, aligned as the core needs them.
    pub fn bytes(&self) -> &[u8] {
        bytemuck::cast_slice(&self.words)
    }
}

/// Bakes a scene for the rasteriser.
///
/// # Errors
/// If the scene has more of something than the format holds, a number out of
/// its range, or asks for what the renderer cannot do yet.
pub fn bake(scene: &Scene) -> Result<Baked, BakeError> {
    bake_with(scene, None)
}

/// Bakes a scene for the ray caster and the rasteriser.
///
/// # Errors
/// As [`bake`].
pub fn bake_for_rays(scene: &Scene) -> Result<Baked, BakeError> {
    let first = bake_with(scene, Some(&[]))?;
    // Which colours there are to choose entries for is seen only when rays are cast.
    let seen = first.scene().map_or(Vec::new(), |core| {
        let chosen = !core.colours().is_empty() && scene.palette.fixed.is_empty();
        let frames = scene.animation.length().unwrap_or(1);
        if chosen {
            seen(&core, frames)
        } else {
            Vec::new()
        }
    });
    if seen.is_empty() {
        return Ok(first);
    }
    bake_with(scene, Some(&seen))
}

/// `rays`: colours that rays have been seen to bring back; none: not for rays.
fn bake_with(scene: &Scene, rays: Option<&[Sample]>) -> Result<Baked, BakeError> {
    at_most("actors", scene.actors.len(), 65535)?;
    at_most("materials", scene.materials.len(), 65535)?;
    at_most("lights with a direction", scene.lights.len(), LIGHTS)
        .map_err(|error| error.problem.at(Element::Light(LIGHTS)))?;
    possible(scene)?;
    let units = Units::new(scene);
    let textures = textures(scene);
    let texturing = Texturing::new(&textures.textures)?;
    if scene.palette.direct
        && let Some(what) = needs_palette(scene, rays.is_some())
    {
        return Err(Problem::NotYet { what: what.into() }.into());
    }
    let tables = match rays {
        _ if scene.palette.direct => direct(scene),
        Some(seen) => tables(scene, &textures.bases, mixes(scene), seen),
        None => tables(scene, &textures.bases, false, &[]),
    };
    let bases = textures.bases.len();
    let shades = tables.texture_shades.iter();
    let texture_shades: Vec<Vec<u8>> = shades.map(|table| padded(table, bases)).collect();
    let placed = placed(scene)?;
    let (instances, uses) = instances(scene, &placed, rays.is_some());
    let mut parts = Parts::default();
    for instance in &instances {
        let mesh = &scene.meshes[instance.mesh];
        // Of a single point, a pixel or some world units.
        let on_screen =
            |actor: &Actor| actor.mesh == instance.mesh && actor.look.space == Space::Screen;
        let least = if !mesh.triangles.is_empty() {
            f64::MIN_POSITIVE
        } else if scene.actors.iter().any(on_screen) {
            1.0
        } else {
            units.scene_length(LEAST_HALF)
        };
        let detailed = scene.lod.is_some() && !instance.edges && !instance.points;
        let levels = if detailed && !mesh.triangles.is_empty() {
            levels(&instance.shaped(mesh), instance.smooth)
        } else {
            Vec::new()
        };
        parts.add_mesh(instance, mesh, &levels, least)?;
    }
    let lights = scene
        .lights
        .iter()
        .zip(1..)
        .map(|(l, number)| light(&units, number, l))
        .collect::<Result<Vec<_>, _>>()?;
    let materials = scene
        .materials
        .iter()
        .zip(&tables.paths)
        .zip(&textures.of_material)
        .zip(transparencies(scene))
        .map(|(((m, path), texture), how)| material(scene, *path, *texture, how, m));
    let mut materials = materials.collect::<Vec<_>>();
    let looks = looks(scene, &mut materials);
    let all = Instances {
        instances: &instances,
        uses: &uses,
        grids: &parts.grids,
        materials: &looks.materials,
    };
    let actors = actors(scene, &units, &placed, &all)?;
    if parts.edges.is_empty() {
        parts.meshlet_edges.clear();
    }

    let (tracks, keys) = tracks(scene, &units, &placed)?;
    let fogs: Vec<_> = scene.fog.iter().map(|f| fog::fog(f, &units)).collect();

    let rays = if rays.is_some() {
        let mut rays = crate::ray::rays(scene, &units, &instances, &mut parts)?;
        // Those of lines and points.
        rays.optics.resize(materials.len(), Optics::PLAIN);
        parts.add_levels()?;
        rays.shapes.resize(parts.meshes.len(), NO_SHAPE);
        rays
    } else {
        parts.add_levels()?;
        Rays::default()
    };

    let cones = cones(&parts);
    let output = Vec::from_iter(output(scene));
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
            little_endian_words(&parts.face_normals),
            parts.face_normals.len(),
        ),
        (words(parts.fine.as_flattened()), parts.fine.len()),
        records(&viewports(scene, &units, &tables.viewport_backgrounds)?),
        flat_bytes(&tables.viewport_backgrounds),
        records(&tracks),
        records(&keys),
        records(&fogs),
        (words(tables.fog.as_flattened()), tables.fog.len()),
        (words(parts.colours.as_flattened()), parts.colours.len()),
        (
            words(&tables.colours),
            usize::from(!tables.colours.is_empty()),
        ),
        records(&output),
        records(&looks.looks),
        (words(&looks.marks), looks.marks.len()),
        (words(parts.edges.as_flattened()), parts.edges.len()),
        (
            little_endian_words(&parts.meshlet_edges),
            parts.meshlet_edges.len(),
        ),
        (little_endian(&parts.coordinates), parts.coordinates.len()),
        records(&texturing.textures),
        flat_bytes(&texturing.texels),
        (words(textures.bases.as_flattened()), textures.bases.len()),
        (texture_shades.concat(), texture_shades.len()),
        records(&rays.settings),
        records(&rays.shapes),
        records(&rays.nodes),
        records(&rays.optics),
        records(&rays.areas),
        (words(cones.as_flattened()), cones.len()),
    ];
    let cycle = scene.animation.palette_cycle;
    if let Some(cycle) = cycle.filter(|c| c.last as usize >= tables.palette.len()) {
        let problem = Problem::Range {
            what: format!(
                "animation.palette_cycle.last of a palette of {} entries",
                tables.palette.len()
            ),
            value: cycle.last.into(),
            most: (tables.palette.len() - 1) as f64,
        };
        return Err(problem.at(Element::Animation));
    }
    let mut words = assemble(header(scene, &units, tables.spread)?, &sections)?;
    let whole = fixel::Scene::parse(bytemuck::cast_slice(&words))?;
    let header = Header {
        features: whole.features_used(),
        ..*whole.header()
    };
    seal(&mut words, header);
    Ok(Baked {
        words,
        sources: parts.sources,
    })
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
    let header = Header {
        length: length as u32,
        ..header
    };
    seal(&mut words, header);
    Ok(words)
}

/// Puts the header at the beginning, with its checksum.
pub(crate) fn seal(words: &mut [u32], mut header: Header) {
    words[..HEADER_WORDS].copy_from_slice(&header.to_words());
    header.checksum = checksum(&words[CHECKED_FROM / 4..]);
    words[..HEADER_WORDS].copy_from_slice(&header.to_words());
}

fn records<R: Record>(records: &[R]) -> (Vec<u8>, usize)
where
    R::Words: bytemuck::NoUninit,
{
    let words: Vec<R::Words> = records.iter().map(Record::to_words).collect();
    (bytemuck::cast_slice(&words).to_vec(), records.len())
}

/// Bytes of all lists, one after the other.
fn flat_bytes(lists: &[Vec<u8>]) -> (Vec<u8>, usize) {
    let bytes = lists.concat();
    let count = bytes.len();
    (bytes, count)
}

fn little_endian<const N: usize>(vertices: &[[i16; N]]) -> Vec<u8> {
    vertices
        .as_flattened()
        .iter()
        .flat_map(|v| v.to_le_bytes())
        .collect()
}

fn little_endian_words(words: &[u32]) -> Vec<u8> {
    words.iter().flat_map(|word| word.to_le_bytes()).collect()
}
