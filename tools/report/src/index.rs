//! All scenes.

use fixel_reference::Frame;
use serde_json::Value;

use crate::picture::thumbnail;
use crate::style::head;
use crate::{escaped, figures};

/// Width of a small picture at most, in pixels.
const SMALL: u32 = 100;

/// A row.
#[derive(Clone, Debug)]
pub struct Entry {
    /// The scene.
    pub scene: String,
    /// The renderer.
    pub renderer: String,
    /// The page's file, beside the index.
    pub file: String,
    /// The frame, small, as an address.
    pub picture: String,
    /// As the page has them.
    pub figures: Value,
    /// Which limits are broken; none: it holds.
    pub broken: Option<String>,
}

impl Entry {
    /// A small picture of a frame.
    pub fn small(frame: &Frame) -> String {
        thumbnail(frame.width, frame.height, &frame.rgb, SMALL)
    }
}

/// Titles, fields and digits of the columns of numbers.
const COLUMNS: [(&str, &str, usize); 11] = [
    ("covered px", "covered_px", 0),
    ("coverage differs, px", "coverage_mismatch_px", 0),
    ("another triangle, px", "visible_mismatch_px", 0),
    ("depth off most, of 65535", "depth_max_lsb", 2),
    ("depth within 1, %", "depth_within_1_percent", 2),
    ("light off most, of 255", "level_max", 2),
    ("light within 2, %", "level_within_2_percent", 2),
    ("wrong shadow, px", "shadow_mismatch_px", 0),
    ("colour, same palette, dB", "rgb_psnr_db", 1),
    ("colour, true, dB", "rgb_psnr_true_db", 1),
    ("8 bits a channel, dB", "rgb888_psnr_true_db", 1),
];

/// Sorts the table by the column whose title is pressed, and the other way when it is
/// pressed again.
const SORT: &str = r#"<script>
const table = document.querySelector("table"), body = table.tBodies[0];
const heads = [...table.tHead.rows[0].cells];
heads.forEach((head, column) => head.querySelector("button")?.addEventListener("click", () => {
  const down = head.getAttribute("aria-sort") === "ascending";
  heads.forEach(other => other.removeAttribute("aria-sort"));
  head.setAttribute("aria-sort", down ? "descending" : "ascending");
  const key = row => row.cells[column].dataset.key ?? row.cells[column].textContent;
  const order = (a, b) => isNaN(a) || isNaN(b) ? String(a).localeCompare(b) : a - b;
  const rows = [...body.rows].sort((a, b) => order(key(a), key(b)) * (down ? -1 : 1));
  body.append(...rows);
}));
</script>
"#;

/// The page; a press on a column's title sorts by it.
pub fn index(entries: &[Entry]) -> String {
    let mut html = head("fixel: accuracy of all scenes");
    let broken = entries
        .iter()
        .filter(|entry| entry.broken.is_some())
        .count();
    let scenes = entries.len();
    html += &format!(
        "<p>Each scene's first frame in fixed point against a reference in double precision, by \
         both renderers: {scenes} comparisons, {broken} beyond a limit. Press a column's title \
         to sort by it, a scene's name for its maps.</p>\n\
         <div class=\"scroll\">\n<table class=\"index\">\n<thead><tr><th></th>"
    );
    let titles = ["scene", "by"].into_iter().map(|title| (title, ""));
    let numbers = COLUMNS.iter().map(|(title, ..)| (*title, " class=\"n\""));
    for (title, class) in titles.chain(numbers).chain([("limits", "")]) {
        html += &format!("<th{class}><button type=\"button\">{title}</button></th>");
    }
    html += "</tr></thead>\n<tbody>\n";
    html.extend(entries.iter().map(row));
    html + "</tbody>\n</table>\n</div>\n" + SORT + "</html>\n"
}

fn row(entry: &Entry) -> String {
    let (file, scene) = (escaped(&entry.file), escaped(&entry.scene));
    let mut html = format!(
        "<tr><td><a href=\"{file}\"><img src=\"{}\" alt=\"\" loading=\"lazy\"></a></td>\
         <td><a href=\"{file}\">{scene}</a></td><td>{}</td>",
        entry.picture,
        escaped(&entry.renderer)
    );
    for (_, field, digits) in COLUMNS {
        let value = &entry.figures[field];
        let shadows = field != "shadow_mismatch_px" || entry.figures["lit_px"] != 0;
        let text = figures::shown(value, digits).filter(|_| shadows);
        let key = if shadows {
            value.as_f64().unwrap_or(-1.0)
        } else {
            -1.0
        };
        html += &format!(
            "<td class=\"n\" data-key=\"{key}\">{}</td>",
            text.unwrap_or_default()
        );
    }
    html += &match &entry.broken {
        None => "<td class=\"good\">held</td></tr>\n".to_owned(),
        Some(what) => format!("<td class=\"bad\">{}</td></tr>\n", escaped(what)),
    };
    html
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn each_row_has_as_many_cells_as_there_are_titles() {
        let entry = |scene: &str, broken: Option<&str>| Entry {
            scene: scene.into(),
            renderer: "raster".into(),
            file: format!("{scene}-raster.html"),
            picture: "data:image/png;base64,".into(),
            figures: json!({"covered_px": 12, "depth_max_lsb": 0.987, "lit_px": 0}),
            broken: broken.map(Into::into),
        };
        let html = index(&[entry("a", None), entry("b<", Some("depth"))]);
        let titles = html.matches("<th").count() - html.matches("<thead").count();
        assert_eq!(html.matches("<td").count(), 2 * titles);
        for wanted in [
            "2 comparisons, 1 beyond a limit",
            "href=\"a-raster.html\"",
            "b&lt;",
            "data-key=\"0.987\">0.99<",
            "class=\"bad\">depth<",
        ] {
            assert!(html.contains(wanted), "{wanted}");
        }
    }
}
