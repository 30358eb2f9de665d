//! What the figures are called, and how they are written.

use serde_json::Value;

use crate::escaped;

/// Fields of `fixel compare --json`, what they are, and how many digits they have.
const NAMES: [(&str, &str, usize); 25] = [
    ("covered_px", "Pixels with a surface in the truth", 0),
    (
        "coverage_mismatch_px",
        "Pixels where only one of the two shows a surface",
        0,
    ),
    (
        "coverage_mismatch_percent",
        "The same, % of the covered ones",
        4,
    ),
    (
        "visible_mismatch_px",
        "Pixels with another triangle in front",
        0,
    ),
    (
        "line_doubt_px",
        "Pixels of lines that hang on rounding, left out",
        0,
    ),
    ("agreeing_px", "Pixels with the same triangle in both", 0),
    ("depth_max_lsb", "Depth off at most, of 65535", 3),
    ("depth_mean_lsb", "Depth off in the mean", 4),
    (
        "depth_within_1_percent",
        "Depth within 1 of 65535, % of agreeing pixels",
        3,
    ),
    ("level_max", "Light off at most, of 255", 3),
    ("level_mean", "Light off in the mean", 4),
    (
        "level_within_2_percent",
        "Light within 2 of 255, % of agreeing pixels",
        3,
    ),
    (
        "texel_max",
        "Place in the texture off at most, in texels",
        4,
    ),
    ("texel_mean", "Place in the texture off in the mean", 4),
    ("lit_px", "Pixels that some light gets to", 0),
    ("shadow_mismatch_px", "Pixels with a wrong shadow", 0),
    ("shadow_mismatch_clusters", "Clusters of wrong shadows", 0),
    (
        "rgb_psnr_db",
        "Colour through the same palette, dB (999: identical)",
        2,
    ),
    (
        "rgb_psnr_true_db",
        "Colour against the unquantised truth, dB",
        2,
    ),
    (
        "rgb_psnr_true_covered_db",
        "The same on covered pixels, dB",
        2,
    ),
    (
        "rgb888_psnr_true_db",
        "The same on a display of 8 bits a channel, dB",
        2,
    ),
    (
        "picture_psnr_db",
        "The picture as the panel shows it, dB",
        2,
    ),
    (
        "index_equal_percent",
        "Equal palette indices, % of pixels with a surface",
        2,
    ),
    ("depth_max_at", "Where depth is off most", 0),
    ("level_max_at", "Where light is off most", 0),
];

/// A field's value, rounded for a reader; none if there is none.
pub(crate) fn shown(value: &Value, digits: usize) -> Option<String> {
    match value {
        Value::Number(number) => number.as_f64().map(|number| format!("{number:.digits$}")),
        Value::Array(place) => {
            let numbers: Vec<String> = place.iter().map(Value::to_string).collect();
            Some(numbers.join(", "))
        }
        _ => None,
    }
}

/// All figures as a table.
pub(crate) fn table(figures: &Value) -> String {
    let mut text = String::from("<table class=\"figures\">\n");
    for (name, what, digits) in NAMES {
        let nothing = figures["lit_px"] == 0 && name.contains("shadow")
            || figures["texel_max"] == 0.0 && name.starts_with("texel")
            || ["lit_px", "line_doubt_px"].contains(&name) && figures[name] == 0;
        if nothing {
            continue;
        }
        if let Some(value) = shown(&figures[name], digits) {
            text += &format!(
                "<tr><td>{}</td><td><code>{name}</code></td><td class=\"n\">{value}</td></tr>\n",
                escaped(what)
            );
        }
    }
    text + "</table>\n"
}

/// The pixels that differ in what is seen, as many as are named.
pub(crate) fn mismatches(figures: &Value) -> String {
    let listed = figures["mismatches"]
        .as_array()
        .map_or(&[][..], Vec::as_slice);
    if listed.is_empty() {
        return String::new();
    }
    let mut text = String::from(
        "<h2>Pixels that differ in what is seen</h2>\n<p>The first 20, by rows from the \
         top.</p>\n<table class=\"list\"><tr><th>pixel</th><th>how</th><th>truth</th>\
         <th>frame</th><th>depth of the truth</th><th>of the frame</th></tr>\n",
    );
    let surface = |value: &Value| match value.as_array().map(Vec::as_slice) {
        Some([actor, triangle]) => format!("actor {actor}, triangle {triangle}"),
        _ => "background".into(),
    };
    for m in listed {
        let depth = m["truth_depth_lsb"].as_f64().unwrap_or_default();
        text += &format!(
            "<tr><td>{}, {}</td><td>{}</td><td>{}</td><td>{}</td><td class=\"n\">{depth:.2}</td>\
             <td class=\"n\">{}</td></tr>\n",
            m["x"],
            m["y"],
            m["kind"].as_str().unwrap_or_default(),
            surface(&m["truth"]),
            surface(&m["frame"]),
            m["frame_depth_lsb"],
        );
    }
    text + "</table>\n"
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn figures_are_rounded_and_what_is_not_there_is_left_out() {
        let figures = json!({
            "covered_px": 12, "depth_max_lsb": 0.98765, "lit_px": 0, "shadow_mismatch_px": 0,
            "depth_max_at": [3, 4], "level_max_at": null, "texel_max": 0.0,
        });
        let text = table(&figures);
        assert_eq!(text.matches("<tr>").count(), 3, "{text}");
        for wanted in [">12<", ">0.988<", ">3, 4<"] {
            assert!(text.contains(wanted), "{text}");
        }
    }

    #[test]
    fn mismatches_are_listed() {
        assert_eq!(mismatches(&json!({"mismatches": []})), "");
        let text = mismatches(&json!({"mismatches": [{
            "x": 5, "y": 1, "kind": "extra", "truth": null, "frame": [0, 7],
            "truth_depth_lsb": 0.0, "frame_depth_lsb": 99
        }]}));
        for wanted in ["5, 1", "extra", "background", "actor 0, triangle 7", ">99<"] {
            assert!(text.contains(wanted), "{text}");
        }
    }
}
