//! `docs/gallery.md`: every scene with its golden frame, which the tests hold to what
//! the core draws.

use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};

use crate::problem::Result;
use crate::{paths, scene};

/// Pictures in a row.
const COLUMNS: usize = 3;

/// Writes the page anew.
pub fn run() -> Result<()> {
    let path = file();
    let text = page()?;
    Ok(fixel_output::write(&path, text.as_bytes())?)
}

/// Fails if the page is not what would be written now.
pub fn is_current() -> Result<()> {
    let written = fs::read_to_string(file()).unwrap_or_default();
    if page()? != written {
        return Err("docs/gallery.md is out of date: run `cargo xtask gallery`".into());
    }
    Ok(())
}

fn file() -> PathBuf {
    paths::root().join("docs/gallery.md")
}

/// The page.
fn page() -> Result<String> {
    let mut text = String::from(
        "# Gallery\n\n\
         Every scene in [scenes/](../scenes), frame 0, as the core draws it in fixed \
         point: these are the golden frames that the tests hold it to, byte for byte. \
         Three emulated targets draw all of them, six more a selection (`cargo xtask parity`). How each differs from an f64 reference is in the \
         [README](../README.md). Written by `cargo xtask gallery`.\n\n\
         <table>\n",
    );
    let all = scene::all()?;
    let drawn: Vec<&PathBuf> = all.iter().filter(|file| golden(file).exists()).collect();
    for row in drawn.chunks(COLUMNS) {
        text.push_str("<tr>\n");
        for file in row {
            text.push_str(&cell(file)?);
        }
        text.push_str("</tr>\n");
    }
    text.push_str("</table>\n");
    Ok(text)
}

/// Where a scene's golden frame is.
fn golden(file: &Path) -> PathBuf {
    let name = format!("{}.png", scene::name(file));
    paths::root().join("tests/golden").join(name)
}

fn cell(file: &Path) -> Result<String> {
    let name = scene::name(file);
    let text = fs::read_to_string(file).map_err(|error| format!("{}: {error}", file.display()))?;
    let line = about(&text).ok_or_else(|| {
        format!(
            "{}: no comment on the first line that says what is seen, such as `# A teapot on a turntable.`",
            file.display()
        )
    })?;
    let described = fixel_scene::load(file).map_err(|error| error.to_string())?;
    let baked = if scene::by_rays(&name) {
        fixel_bake::bake_for_rays(&described)
    } else {
        fixel_bake::bake(&described)
    };
    let baked = baked.map_err(|error| format!("{}: {error}", file.display()))?;
    let core = fixel::Scene::parse(baked.bytes())
        .map_err(|error| format!("{}: {error}", file.display()))?;
    let mut cell = String::new();
    let root = paths::root();
    let link = file.strip_prefix(&root).unwrap_or(file).display();
    writeln!(
        cell,
        "<td valign=\"top\" width=\"33%\"><a href=\"../{link}\">\
         <img src=\"../tests/golden/{name}.png\" alt=\"{name}\"></a><br>\n\
         <b>{name}</b>: {line}<br>\n\
         <sub>{}x{}, {} colours</sub></td>",
        core.width(),
        core.height(),
        core.palette().len(),
    )
    .map_err(|error| error.to_string())?;
    Ok(cell)
}

/// The first sentence of the comment that a scene file begins with, as HTML.
fn about(text: &str) -> Option<String> {
    let comment = text.lines().map_while(|line| line.strip_prefix('#'));
    let whole = comment.map(str::trim).collect::<Vec<_>>().join(" ");
    let end = whole.find(". ").map_or(whole.len(), |at| at + 1);
    let sentence = whole.get(..end)?.trim();
    let html = sentence.replace('&', "&amp;").replace('<', "&lt;");
    (!html.is_empty()).then_some(html)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_scene_is_told_by_its_first_sentence() {
        let text = "# A cube that\n# spins. It is red.\n[display]\n# Not this.\n";
        assert_eq!(about(text).as_deref(), Some("A cube that spins."));
        assert_eq!(about("[display]\n"), None);
    }
}
