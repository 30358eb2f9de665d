//! One square of two triangles in the plane z = 0, facing +z, in each format.

use std::fmt::Write;

use base64::Engine;

const CORNERS: [[f32; 3]; 4] = [
    [0.0, 0.0, 0.0],
    [1.0, 0.0, 0.0],
    [1.0, 1.0, 0.0],
    [0.0, 1.0, 0.0],
];
const TRIANGLES: [[u16; 3]; 2] = [[0, 1, 2], [0, 2, 3]];

pub(super) const OBJ: &str = "# a square\nmtllib none.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n\
                              vn 0 0 2\nvt 0 0\nf 1/1/1 2/1/1 3/1/1 4/1/1\n";

pub(super) const PLY: &str = "ply\nformat ascii 1.0\ncomment a square\nelement vertex 4\n\
    property float x\nproperty float y\nproperty float z\nelement face 1\n\
    property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n";

/// A square with colours: red, green, blue, and red again.
pub(super) const COLOURED_PLY: &str = "ply\nformat ascii 1.0\nelement vertex 4\n\
    property float x\nproperty float y\nproperty float z\nproperty uchar red\n\
    property uchar green\nproperty uchar blue\nproperty uchar alpha\nelement face 1\n\
    property list uchar int vertex_indices\nend_header\n0 0 0 255 0 0 9\n1 0 0 0 51 0 9\n\
    1 1 0 0 0 255 9\n0 1 0 255 0 0 9\n4 0 1 2 3\n";

pub(super) fn ply_binary(big_endian: bool) -> Vec<u8> {
    let order = if big_endian { "big" } else { "little" };
    let mut bytes = PLY[..PLY.find("0 0 0").unwrap()]
        .replace("ascii", &format!("binary_{order}_endian"))
        .into_bytes();
    for number in CORNERS.as_flattened() {
        bytes.extend(if big_endian {
            number.to_be_bytes()
        } else {
            number.to_le_bytes()
        });
    }
    bytes.push(4);
    for index in 0..4_i32 {
        bytes.extend(if big_endian {
            index.to_be_bytes()
        } else {
            index.to_le_bytes()
        });
    }
    bytes
}

pub(super) fn stl_ascii() -> String {
    let mut text = "solid square\n".to_owned();
    for triangle in TRIANGLES {
        text += "facet normal 0 0 0\n  outer loop\n";
        for index in triangle {
            let [x, y, z] = CORNERS[usize::from(index)];
            writeln!(text, "    vertex {x} {y} {z:e}").unwrap();
        }
        text += "  endloop\nendfacet\n";
    }
    text + "endsolid square\n"
}

/// With "solid" in its header, as some exporters have it.
pub(super) fn stl_binary() -> Vec<u8> {
    let mut bytes = format!("{:80}", "solid but binary").into_bytes();
    bytes.extend(2_u32.to_le_bytes());
    for triangle in TRIANGLES {
        bytes.extend([0xff; 12]);
        for index in triangle {
            for number in CORNERS[usize::from(index)] {
                bytes.extend(number.to_le_bytes());
            }
        }
        bytes.extend([0; 2]);
    }
    bytes
}

/// Indices (12 bytes), then positions (48), then normals (48) with one of
/// length 0.
fn gltf_data() -> Vec<u8> {
    let mut bytes: Vec<u8> = TRIANGLES
        .as_flattened()
        .iter()
        .flat_map(|index| index.to_le_bytes())
        .collect();
    let normals = [[0.0, 0.0, 1.0_f32]; 3];
    let numbers = CORNERS.iter().chain(&normals).chain(&[[0.0; 3]]).flatten();
    bytes.extend(numbers.flat_map(|number| number.to_le_bytes()));
    bytes
}

/// `node` is the node's transform, `primitive` what the primitive has beside
/// its attributes.
fn gltf_json(uri: &str, node: &str, primitive: &str) -> String {
    format!(
        r#"{{
"asset": {{"version": "2.0"}},
"scene": 0,
"scenes": [{{"nodes": [0]}}],
"nodes": [{{"children": [1]}}, {{"mesh": 0 {node}}}],
"materials": [{{"pbrMetallicRoughness": {{"baseColorFactor": [1, 0, 0.5, 1]}}}}],
"meshes": [{{"primitives": [{{"attributes": {{"POSITION": 1, "NORMAL": 2}}, "material": 0 {primitive}}}]}}],
"accessors": [
 {{"bufferView": 0, "componentType": 5123, "count": 6, "type": "SCALAR"}},
 {{"bufferView": 1, "componentType": 5126, "count": 4, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]}},
 {{"bufferView": 2, "componentType": 5126, "count": 4, "type": "VEC3"}}
],
"bufferViews": [
 {{"buffer": 0, "byteOffset": 0, "byteLength": 12}},
 {{"buffer": 0, "byteOffset": 12, "byteLength": 48}},
 {{"buffer": 0, "byteOffset": 60, "byteLength": 48}}
],
"buffers": [{{"byteLength": 108 {uri}}}]
}}"#
    )
}

pub(super) fn gltf(node: &str, primitive: &str) -> String {
    let data = base64::engine::general_purpose::STANDARD.encode(gltf_data());
    let uri = format!(r#", "uri": "data:application/octet-stream;base64,{data}""#);
    gltf_json(&uri, node, primitive)
}

/// With its buffer in a file beside it, and what that holds.
pub(super) fn gltf_beside(uri: &str) -> (String, Vec<u8>) {
    let uri = format!(r#", "uri": "{uri}""#);
    (gltf_json(&uri, "", INDICES), gltf_data())
}

pub(super) fn glb(node: &str, primitive: &str) -> Vec<u8> {
    glb_of(gltf_json("", node, primitive), gltf_data())
}

fn glb_of(json: String, mut data: Vec<u8>) -> Vec<u8> {
    let mut json = json.into_bytes();
    json.resize(json.len().next_multiple_of(4), b' ');
    data.resize(data.len().next_multiple_of(4), 0);
    let mut bytes = b"glTF".to_vec();
    let length = |bytes: &[u8]| (bytes.len() as u32).to_le_bytes();
    bytes.extend(2_u32.to_le_bytes());
    bytes.extend((12 + 8 + json.len() as u32 + 8 + data.len() as u32).to_le_bytes());
    bytes.extend(length(&json));
    bytes.extend(b"JSON");
    bytes.extend(json);
    bytes.extend(length(&data));
    bytes.extend(b"BIN\0");
    bytes.extend(data);
    bytes
}

pub(super) const INDICES: &str = r#", "indices": 0"#;

/// Four bytes a colour.
pub(super) const BYTES: &str = r#""componentType": 5121, "normalized": true, "type": "VEC4""#;

/// The square as GLB with an accessor of colours: `kind` is its `componentType`
/// and `type`, `data` its bytes.
pub(super) fn coloured_glb(kind: &str, data: &[u8]) -> Vec<u8> {
    let length = 108 + data.len();
    let json = gltf_json("", "", INDICES)
        .replace("\"NORMAL\": 2", "\"NORMAL\": 2, \"COLOR_0\": 3")
        .replacen(
            "],\n\"bufferViews\"",
            &format!(", {{\"bufferView\": 3, {kind}, \"count\": 4}}],\n\"bufferViews\""),
            1,
        )
        .replacen(
            "],\n\"buffers\"",
            &format!(
                ", {{\"buffer\": 0, \"byteOffset\": 108, \"byteLength\": {}}}],\n\"buffers\"",
                data.len()
            ),
            1,
        )
        .replace("\"byteLength\": 108", &format!("\"byteLength\": {length}"));
    glb_of(json, [&gltf_data(), data].concat())
}

/// The square as GLB with texture coordinates of 2 bytes a corner, a texture of the
/// given file and `more` of the material and of the sampler.
pub(crate) fn textured_glb(image: &[u8], material: &str, sampler: &str) -> Vec<u8> {
    let coordinates: [u8; 8] = [0, 255, 255, 255, 255, 0, 0, 51];
    let image_at = 108 + coordinates.len();
    let json = gltf_json("", "", INDICES)
        .replace("\"NORMAL\": 2", "\"NORMAL\": 2, \"TEXCOORD_0\": 3")
        .replace(
            "\"baseColorFactor\"",
            "\"baseColorTexture\": {\"index\": 0}, \"baseColorFactor\"",
        )
        .replace("0.5, 1]}", &format!("0.5, 1]}} {material}"))
        .replacen(
            "],\n\"bufferViews\"",
            ", {\"bufferView\": 3, \"componentType\": 5121, \"normalized\": true, \
             \"type\": \"VEC2\", \"count\": 4}],\n\"bufferViews\"",
            1,
        )
        .replacen(
            "],\n\"buffers\"",
            &format!(
                ", {{\"buffer\": 0, \"byteOffset\": 108, \"byteLength\": 8}}, \
                 {{\"buffer\": 0, \"byteOffset\": {image_at}, \"byteLength\": {}}}],\n\
                 \"textures\": [{{\"source\": 0, \"sampler\": 0}}],\n\
                 \"samplers\": [{{{sampler}}}],\n\
                 \"images\": [{{\"bufferView\": 4, \"mimeType\": \"image/png\"}}],\n\"buffers\"",
                image.len()
            ),
            1,
        )
        .replace(
            "\"byteLength\": 108",
            &format!("\"byteLength\": {}", image_at + image.len()),
        );
    glb_of(json, [&gltf_data(), &coordinates[..], image].concat())
}

/// All of the above by file name.
pub(super) fn all() -> Vec<(&'static str, Vec<u8>)> {
    let mirrored = r#", "scale": [-1, 1, 1]"#;
    vec![
        ("a.obj", OBJ.into()),
        ("a.ply", PLY.into()),
        ("little.ply", ply_binary(false)),
        ("big.ply", ply_binary(true)),
        ("ascii.stl", stl_ascii().into()),
        ("binary.stl", stl_binary()),
        ("a.gltf", gltf("", INDICES).into()),
        ("a.glb", glb(mirrored, INDICES)),
        ("coloured.ply", COLOURED_PLY.into()),
        ("coloured.glb", coloured_glb(BYTES, &[255; 16])),
    ]
}
