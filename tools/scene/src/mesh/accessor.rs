//! glTF accessors with every offset checked. The `gltf` crate's own readers
//! trust the file.

use gltf::Accessor;
use gltf::accessor::{DataType, Dimensions};

use super::Refusal;

/// The bytes of each of the document's buffers.
#[derive(Debug)]
pub(super) struct Buffers(pub Vec<Vec<u8>>);

/// The bytes of each item, all of the item's size.
fn items<'a>(
    buffers: &'a Buffers,
    accessor: &Accessor<'_>,
) -> Result<impl Iterator<Item = &'a [u8]>, Refusal> {
    let wrong = |what: &str| Refusal::new(format!("accessors[{}]: {what}", accessor.index()));
    if accessor.sparse().is_some() {
        return Err(wrong("a sparse accessor is not supported yet"));
    }
    let view = accessor
        .view()
        .ok_or_else(|| wrong("has no data; expected a bufferView"))?;
    let (size, count) = (accessor.size(), accessor.count());
    let stride = view.stride().unwrap_or(size);
    if stride < size {
        return Err(wrong("has items that overlap"));
    }
    let data = self::view(buffers, &view)
        .and_then(|data| data.get(accessor.offset()..))
        .filter(|data| {
            let needed = count
                .checked_sub(1)
                .and_then(|last| last.checked_mul(stride)?.checked_add(size));
            needed.is_some_and(|needed| needed <= data.len())
        })
        .ok_or_else(|| wrong("reaches beyond its buffer, or is empty"))?;
    Ok((0..count).map(move |at| &data[at * stride..at * stride + size]))
}

/// Three numbers an item.
pub(super) fn vectors(
    buffers: &Buffers,
    accessor: &Accessor<'_>,
) -> Result<Vec<[f64; 3]>, Refusal> {
    if accessor.data_type() != DataType::F32 || accessor.dimensions() != Dimensions::Vec3 {
        return Err(Refusal::new(format!(
            "accessors[{}]: has another type; expected VEC3 of floats",
            accessor.index()
        )));
    }
    let number = |bytes: &[u8; 4]| f64::from(f32::from_le_bytes(*bytes));
    let vector = |item: &[u8]| match item.as_chunks().0 {
        [x, y, z] => [number(x), number(y), number(z)],
        _ => [f64::NAN; 3],
    };
    Ok(items(buffers, accessor)?.map(vector).collect())
}

/// Linear colours: red, green, blue, with or without alpha, which is left out;
/// floats, or bytes or 16-bit integers over their largest.
pub(super) fn colours(
    buffers: &Buffers,
    accessor: &Accessor<'_>,
) -> Result<Vec<[f32; 3]>, Refusal> {
    let wide = matches!(accessor.dimensions(), Dimensions::Vec3 | Dimensions::Vec4);
    shares(buffers, accessor, wide, "VEC3 or VEC4")
}

/// Texture coordinates, of which the second goes down.
pub(super) fn coordinates(
    buffers: &Buffers,
    accessor: &Accessor<'_>,
) -> Result<Vec<[f32; 2]>, Refusal> {
    let pair = accessor.dimensions() == Dimensions::Vec2;
    shares(buffers, accessor, pair, "VEC2")
}

/// The first numbers of each item: floats, or unsigned bytes or 16-bit integers over
/// their largest. `fits`: the item has enough of them.
fn shares<const N: usize>(
    buffers: &Buffers,
    accessor: &Accessor<'_>,
    fits: bool,
    expected: &str,
) -> Result<Vec<[f32; N]>, Refusal> {
    let size = match accessor.data_type() {
        DataType::F32 if fits => 4,
        DataType::U16 if fits => 2,
        DataType::U8 if fits => 1,
        _ => {
            return Err(Refusal::new(format!(
                "accessors[{}]: has another type; \
                 expected {expected} of floats, unsigned bytes or shorts",
                accessor.index()
            )));
        }
    };
    let number = |bytes: &[u8]| match *bytes {
        [a, b, c, d] => f32::from_le_bytes([a, b, c, d]),
        [a, b] => f32::from(u16::from_le_bytes([a, b])) / f32::from(u16::MAX),
        [a] => f32::from(a) / f32::from(u8::MAX),
        _ => f32::NAN,
    };
    let numbers = |item: &[u8]| std::array::from_fn(|at| number(&item[at * size..(at + 1) * size]));
    Ok(items(buffers, accessor)?.map(numbers).collect())
}

/// The bytes of a view.
pub(super) fn view<'a>(buffers: &'a Buffers, view: &gltf::buffer::View<'_>) -> Option<&'a [u8]> {
    let end = view.offset().checked_add(view.length())?;
    buffers
        .0
        .get(view.buffer().index())?
        .get(view.offset()..end)
}

/// Vertex indices, each below `vertices`.
pub(super) fn indices(
    buffers: &Buffers,
    accessor: &Accessor<'_>,
    vertices: usize,
) -> Result<Vec<u32>, Refusal> {
    let wrong = |what: &str| Refusal::new(format!("accessors[{}]: {what}", accessor.index()));
    let integer = matches!(
        accessor.data_type(),
        DataType::U8 | DataType::U16 | DataType::U32
    );
    if !integer || accessor.dimensions() != Dimensions::Scalar {
        return Err(wrong("has another type; expected unsigned integers"));
    }
    items(buffers, accessor)?
        .map(|item| {
            let index = item
                .iter()
                .rev()
                .fold(0, |index, byte| index << 8 | u32::from(*byte));
            if (index as usize) < vertices {
                Ok(index)
            } else {
                Err(wrong(&format!(
                    "vertex index {index} is out of range (there are {vertices})"
                )))
            }
        })
        .collect()
}
