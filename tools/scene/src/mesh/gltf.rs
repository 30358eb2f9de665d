//! glTF 2.0, as text with buffers or as GLB: the triangles of all meshes in
//! the default scene, each moved by its nodes, with normals, vertex colours, texture
//! coordinates, and base colours and textures of their materials. Cameras, lights,
//! skins, morph targets and all else of materials are left out.

use base64::Engine;
use glam::{DMat3, DMat4, DQuat, DVec3};
use gltf::json::validation::Checked;
use gltf::mesh::Mode;
use gltf::{Document, Gltf, Node, Primitive, Semantic};
use percent_encoding::percent_decode_str;

use super::accessor::{self, Buffers};
use super::gltf_surface::{self, Part};
use super::{MAX_TEXTURE_COORDINATE, MAX_TRIANGLES, Refusal, Soup, polygon};
use crate::files::Origin;

/// Deeper than any sensible scene, and low enough for a scan of all pairs.
const MAX_NODES: usize = 100_000;

pub(super) fn read(origin: Origin<'_>, bytes: &[u8]) -> Result<Soup, Refusal> {
    let unchecked = Gltf::from_slice_without_validation(bytes).map_err(|e| refusal(bytes, &e))?;
    if let Some(extension) = unchecked.extensions_required().next() {
        return Err(Refusal::new(format!(
            "extensionsRequired: \"{extension}\" is not supported; \
             expected a file without it, e.g. exported without compression"
        )));
    }
    check_positions(&unchecked)?;
    let Gltf { document, blob } = Gltf::from_slice(bytes).map_err(|e| refusal(bytes, &e))?;
    let buffers = buffers(origin, &document, blob)?;
    let mut reader = Walk {
        buffers,
        soup: Soup::default(),
        parts: Vec::new(),
    };
    let scene = document
        .default_scene()
        .or_else(|| document.scenes().next());
    match scene {
        Some(scene) => reader.nodes(&document, scene.nodes())?,
        None => {
            for mesh in document.meshes() {
                for primitive in mesh.primitives() {
                    reader.primitive(&primitive, &DMat4::IDENTITY)?;
                }
            }
        }
    }
    let Walk {
        buffers,
        mut soup,
        parts,
    } = reader;
    gltf_surface::give(origin, &document, &buffers, &parts, &mut soup)?;
    Ok(soup)
}

/// The crate's own check trusts these indices (gltf-json 1.4.1, mesh.rs).
fn check_positions(document: &Document) -> Result<(), Refusal> {
    let root = document.as_json();
    for (at, mesh) in root.meshes.iter().enumerate() {
        for attributes in mesh
            .primitives
            .iter()
            .map(|primitive| &primitive.attributes)
        {
            let positions = attributes.get(&Checked::Valid(Semantic::Positions));
            if let Some(index) = positions
                && index.value() >= root.accessors.len()
            {
                let what = format!("meshes[{at}]: accessor {} does not exist", index.value());
                return Err(Refusal::new(what));
            }
        }
    }
    Ok(())
}

fn refusal(bytes: &[u8], error: &gltf::Error) -> Refusal {
    let message = match error.to_string() {
        // The reader's words for it.
        cut if cut.contains("fill whole buffer") => "no valid glTF: it is cut short".into(),
        other => format!("no valid glTF: {other}"),
    };
    match error {
        // In a GLB the line is one of a hidden text.
        gltf::Error::Deserialize(json) if !bytes.starts_with(b"glTF") => {
            Refusal::at(json.line(), message)
        }
        _ => Refusal::new(message),
    }
}

fn buffers(
    origin: Origin<'_>,
    document: &Document,
    blob: Option<Vec<u8>>,
) -> Result<Buffers, Refusal> {
    let mut blob = blob;
    let mut buffers = Vec::new();
    for buffer in document.buffers() {
        let wrong = |what: String| Refusal::new(format!("buffers[{}]: {what}", buffer.index()));
        let data = match buffer.source() {
            gltf::buffer::Source::Bin => blob
                .take()
                .ok_or_else(|| wrong("the file has no binary part".to_owned()))?,
            gltf::buffer::Source::Uri(uri) => uri_data(origin, uri).map_err(wrong)?,
        };
        if data.len() < buffer.length() {
            let (has, needs) = (data.len(), buffer.length());
            return Err(wrong(format!("has {has} bytes where {needs} belong")));
        }
        buffers.push(data);
    }
    Ok(Buffers(buffers))
}

/// A `data:` URI's bytes, or those of a file beside the glTF file.
pub(super) fn uri_data(origin: Origin<'_>, uri: &str) -> Result<Vec<u8>, String> {
    if let Some(data) = uri.strip_prefix("data:") {
        let (_, base64) = data
            .split_once(";base64,")
            .ok_or("its data: URI is not base64")?;
        return base64::engine::general_purpose::STANDARD
            .decode(base64)
            .map_err(|error| format!("its data: URI is not base64: {error}"));
    }
    let name = percent_decode_str(uri)
        .decode_utf8()
        .map_err(|_| format!("\"{uri}\" is no name of a file: it is not UTF-8"))?;
    origin
        .read(&name)
        .map_err(|what| format!("\"{name}\" {what}"))
}

#[derive(Debug)]
struct Walk {
    buffers: Buffers,
    soup: Soup,
    parts: Vec<Part>,
}

impl Walk {
    /// Visits each node once, so that nodes in a circle end too.
    fn nodes<'a>(
        &mut self,
        document: &'a Document,
        roots: impl Iterator<Item = Node<'a>>,
    ) -> Result<(), Refusal> {
        let mut seen = vec![false; document.nodes().len()];
        if seen.len() > MAX_NODES {
            return Err(Refusal::new(format!(
                "nodes: has {}; expected at most {MAX_NODES}",
                seen.len()
            )));
        }
        let mut waiting: Vec<(Node<'a>, DMat4)> =
            roots.map(|node| (node, DMat4::IDENTITY)).collect();
        // As a stack it would go through the nodes from the last to the first.
        waiting.reverse();
        while let Some((node, parent)) = waiting.pop() {
            if std::mem::replace(&mut seen[node.index()], true) {
                let what = format!("nodes[{}]: has more than one parent", node.index());
                return Err(Refusal::new(what));
            }
            let world = parent * local(&node);
            if let Some(mesh) = node.mesh() {
                for primitive in mesh.primitives() {
                    self.primitive(&primitive, &world)?;
                }
            }
            if node.skin().is_some() {
                self.soup.note("skins are left out");
            }
            let first = waiting.len();
            waiting.extend(node.children().map(|child| (child, world)));
            waiting[first..].reverse();
        }
        Ok(())
    }

    fn primitive(&mut self, primitive: &Primitive<'_>, world: &DMat4) -> Result<(), Refusal> {
        let mode = primitive.mode();
        if !matches!(
            mode,
            Mode::Triangles | Mode::TriangleStrip | Mode::TriangleFan
        ) {
            self.soup.note("points and lines are left out");
            return Ok(());
        }
        let Some(positions) = primitive.get(&Semantic::Positions) else {
            return Ok(());
        };
        let positions = accessor::vectors(&self.buffers, &positions)?;
        let normals = match primitive.get(&Semantic::Normals) {
            Some(normals) => accessor::vectors(&self.buffers, &normals)?,
            None => Vec::new(),
        };
        let corners = match primitive.indices() {
            Some(indices) => accessor::indices(&self.buffers, &indices, positions.len())?,
            None => (0..positions.len() as u32).collect(),
        };
        let colours = match primitive.get(&Semantic::Colors(0)) {
            Some(colours) => accessor::colours(&self.buffers, &colours)?,
            None => Vec::new(),
        };
        let first = self.soup.positions.len() as u32;
        let set = self.material(primitive, first as usize);
        let soup = &mut self.soup;
        if !colours.is_empty() || !soup.colours.is_empty() {
            // White where no colour was given, before this primitive and in it.
            soup.colours.resize(soup.positions.len(), [1.0; 3]);
            let encoded = colours.iter().map(|colour| colour.map(encode));
            let all = encoded.chain(std::iter::repeat([1.0; 3]));
            soup.colours.extend(all.take(positions.len()));
        }
        let coordinates = match primitive.get(&Semantic::TexCoords(set)) {
            Some(coordinates) => accessor::coordinates(&self.buffers, &coordinates)?,
            None => Vec::new(),
        };
        let soup = &mut self.soup;
        if !coordinates.is_empty() || !soup.texture_coordinates.is_empty() {
            soup.texture_coordinates
                .resize(soup.positions.len(), [0.0; 2]);
            // Theirs goes down from the upper edge.
            let up = coordinates
                .iter()
                .map(|[u, v]| [f64::from(*u), 1.0 - f64::from(*v)]);
            let all = up.chain(std::iter::repeat([0.0; 2]));
            soup.texture_coordinates.extend(all.take(positions.len()));
            let within = |place: &[f64; 2]| place.iter().all(|c| c.abs() <= MAX_TEXTURE_COORDINATE);
            if !soup.texture_coordinates.iter().all(within) {
                return Err(Refusal::new(
                    "has texture coordinates that are not within 10000",
                ));
            }
        }
        let place = |position: &[f64; 3]| world.transform_point3((*position).into()).to_array();
        soup.positions.extend(positions.iter().map(place));
        // The inverse transpose, but for a factor, which also stands where
        // there is no inverse.
        let linear = DMat3::from_mat4(*world);
        let determinant = linear.determinant();
        let [x, y, z] = [linear.x_axis, linear.y_axis, linear.z_axis];
        let cofactors = DMat3::from_cols(y.cross(z), z.cross(x), x.cross(y));
        let turn = |normal: &[f64; 3]| cofactors * DVec3::from(*normal) * determinant.signum();
        let turned = normals.iter().map(|normal| Some(turn(normal).into()));
        soup.normals
            .extend(turned.chain(std::iter::repeat(None)).take(positions.len()));

        let triangles = soup.triangles.len();
        match mode {
            Mode::TriangleStrip => polygon::strip(&corners, &mut soup.triangles),
            Mode::TriangleFan => {
                let fan = corners.windows(2).skip(1);
                soup.triangles
                    .extend(fan.map(|pair| [corners[0], pair[0], pair[1]]));
            }
            _ => {
                let (whole, _) = corners.as_chunks::<3>();
                soup.triangles.extend(whole);
            }
        }
        for triangle in &mut soup.triangles[triangles..] {
            *triangle = triangle.map(|corner| corner + first);
            // A reflection turns the winding round.
            if determinant < 0.0 {
                triangle.swap(1, 2);
            }
        }
        if soup.triangles.len() > MAX_TRIANGLES {
            return Err(Refusal::too_many());
        }
        Ok(())
    }

    /// Notes a primitive's material; gives the set of texture coordinates that it
    /// uses.
    fn material(&mut self, primitive: &Primitive<'_>, first_vertex: usize) -> u32 {
        let material = primitive.material();
        let base = material.pbr_metallic_roughness();
        let [red, green, blue, _] = base.base_color_factor();
        self.parts.push(Part {
            material: material.index(),
            colour: [red, green, blue].map(encode),
            first_vertex,
            first_triangle: self.soup.triangles.len(),
        });
        if primitive.morph_targets().next().is_some() {
            self.soup.note("morph targets are left out");
        }
        base.base_color_texture().map_or(0, |info| info.tex_coord())
    }
}

/// A node's own transform.
fn local(node: &Node<'_>) -> DMat4 {
    match node.transform() {
        gltf::scene::Transform::Matrix { matrix } => {
            DMat4::from_cols_array_2d(&matrix.map(|column| column.map(f64::from)))
        }
        gltf::scene::Transform::Decomposed {
            translation,
            rotation,
            scale,
        } => {
            // Rounded to f32 in the file, it is not quite of length 1.
            let rotation = DQuat::from_array(rotation.map(f64::from));
            DMat4::from_scale_rotation_translation(
                scale.map(f64::from).into(),
                rotation.normalize(),
                translation.map(f64::from).into(),
            )
        }
    }
}

/// Linear light to display-encoded (IEC 61966-2-1).
fn encode(linear: f32) -> f64 {
    let linear = f64::from(linear).max(0.0);
    if linear <= 0.003_130_8 {
        linear * 12.92
    } else if linear >= 1.0 {
        // The power does not give just 1.
        1.0
    } else {
        1.055 * libm::pow(linear, 1.0 / 2.4) - 0.055
    }
}
