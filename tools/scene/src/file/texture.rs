//! A material's `texture`.

use toml::de::DeValue;

use super::table::{Keys, Table};
use crate::error::Error;
use crate::picture;
use crate::texture::{Filter, Texture, Texturing, Wrap};

pub(super) const TEXTURE: Keys = Keys {
    known: &[
        "file",
        "filter",
        "wrap",
        "perspective",
        "mipmaps",
        "alpha_test",
    ],
    later: &[],
};

const EXAMPLE: &str = "textures/wood.png";

/// A file's name, or a table with the name and more. Each file is read once.
pub(super) fn texture(
    material: &Table<'_, '_>,
    textures: &mut Vec<Texture>,
) -> Result<Option<Texturing>, Error> {
    let key = "texture";
    let Some(value) = material.get(key) else {
        return Ok(None);
    };
    match value.get_ref() {
        DeValue::String(name) => {
            let texture = read(material, key, name, textures)?;
            Ok(Some(Texturing::new(texture)))
        }
        DeValue::Table(table) => {
            let header = value.span();
            let table = Table::new(material.source, "material.texture", table, header, &TEXTURE)?;
            laid_on(&table, textures).map(Some)
        }
        _ => {
            let what = format!(
                "is neither a file's name nor a table; expected e.g. texture = \"{EXAMPLE}\" \
                 or texture = {{ file = \"{EXAMPLE}\", filter = \"nearest\" }}"
            );
            Err(material.error(key, what))
        }
    }
}

fn laid_on(table: &Table<'_, '_>, textures: &mut Vec<Texture>) -> Result<Texturing, Error> {
    let Some(name) = table.text("file", EXAMPLE)? else {
        let what = format!("is missing; expected e.g. file = \"{EXAMPLE}\"");
        return Err(table.error("file", what));
    };
    let mut texturing = Texturing::new(read(table, "file", name, textures)?);
    let filters = [("nearest", Filter::Nearest), ("bilinear", Filter::Bilinear)];
    if let Some(filter) = table.choice("filter", &filters, &[])? {
        texturing.filter = filter;
    }
    let wraps = [
        ("clamp", Wrap::Clamp),
        ("repeat", Wrap::Repeat),
        ("mirror", Wrap::Mirror),
    ];
    if let Some(wrap) = table.choice("wrap", &wraps, &[])? {
        texturing.wrap = wrap;
    }
    for (key, flag) in [
        ("perspective", &mut texturing.perspective),
        ("mipmaps", &mut texturing.mipmaps),
    ] {
        if let Some(said) = table.boolean(key)? {
            *flag = said;
        }
    }
    if let Some(least) = table.number("alpha_test", 0.0..=1.0)? {
        texturing.alpha_test = least;
    }
    Ok(texturing)
}

/// The index of a file's texture.
fn read(
    table: &Table<'_, '_>,
    key: &str,
    name: &str,
    textures: &mut Vec<Texture>,
) -> Result<usize, Error> {
    if let Some(known) = textures.iter().position(|texture| texture.name == name) {
        return Ok(known);
    }
    let picture = table
        .source
        .origin
        .read(name)
        .and_then(|bytes| picture::decode(&bytes));
    let picture = picture.map_err(|what| table.file_error(key, name, &what, EXAMPLE))?;
    textures.push(picture.texture(name));
    Ok(textures.len() - 1)
}
