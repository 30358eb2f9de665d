//! Plots as SVG: a few panels side by side, each with lines over logarithmic axes.

use std::fmt::Write;

/// Width and height of a panel, and what is left around its axes.
const SIZE: [f64; 2] = [240.0, 220.0];
const MARGIN: [f64; 4] = [44.0, 28.0, 10.0, 36.0];
const COLOURS: [&str; 4] = ["#2563eb", "#dc2626", "#15803d", "#9333ea"];

/// Lines over the same axes.
#[derive(Clone, Debug)]
pub struct Panel {
    /// What goes to the right.
    pub title: String,
    /// Each with its name; points are above 0.
    pub lines: Vec<(&'static str, Vec<[f64; 2]>)>,
}

/// The panels beside each other; `upwards` says what goes up in all of them.
pub fn svg(panels: &[Panel], upwards: &str) -> String {
    let [width, height] = SIZE;
    let mut text = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} {height}\" \
         font-family=\"sans-serif\" font-size=\"10\">\n\
         <rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n",
        width * panels.len() as f64
    );
    for (number, panel) in panels.iter().enumerate() {
        let moved = width * number as f64;
        let _ = writeln!(text, "<g transform=\"translate({moved} 0)\">");
        draw(&mut text, panel, upwards);
        text.push_str("</g>\n");
    }
    text + "</svg>\n"
}

fn draw(text: &mut String, panel: &Panel, upwards: &str) {
    let ([width, height], [left, top, right, bottom]) = (SIZE, MARGIN);
    let points = || panel.lines.iter().flat_map(|(_, points)| points);
    let range = |axis: usize| {
        let values = points().map(|point| point[axis]);
        let (least, most) = values.fold((f64::MAX, f64::MIN_POSITIVE), |(least, most), v| {
            (least.min(v), most.max(v))
        });
        (least.min(most), most.max(least.min(most) * 1.01))
    };
    let (across, up) = (range(0), range(1));
    // From 0 on where that shows proportions: upwards. To the right by ratio.
    let x = |v: f64| {
        let part = (v / across.0).ln() / (across.1 / across.0).ln();
        left + part * (width - left - right)
    };
    let y = |v: f64| height - bottom - v / (up.1 * 1.05) * (height - top - bottom);
    let (end, base) = (width - right, height - bottom);
    let _ = writeln!(
        text,
        "<path d=\"M{left} {top}V{base}H{end}\" fill=\"none\" stroke=\"#555\"/>\n\
         <text x=\"{left}\" y=\"{:.1}\" fill=\"#555\">{upwards}</text>\n\
         <text x=\"{end}\" y=\"{:.1}\" text-anchor=\"end\">{}</text>",
        top - 14.0,
        height - 6.0,
        panel.title
    );
    for part in [0.25, 0.5, 0.75, 1.0] {
        let value = up.1 * part;
        let _ = writeln!(
            text,
            "<text x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"end\">{value:.1}</text>",
            left - 4.0,
            y(value) + 3.0
        );
    }
    if let Some((_, points)) = panel.lines.first() {
        let last = points.len().saturating_sub(1);
        for (number, [value, _]) in points.iter().enumerate() {
            // All would stand over each other.
            if number == 0 || number == last || number * 2 == last {
                let _ = writeln!(
                    text,
                    "<text x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"middle\">{value}</text>",
                    x(*value),
                    base + 12.0
                );
            }
        }
    }
    for ((name, points), colour) in panel.lines.iter().zip(COLOURS) {
        let places = points
            .iter()
            .map(|[a, b]| format!("{:.1},{:.1}", x(*a), y(*b)));
        let places: Vec<String> = places.collect();
        let _ = writeln!(
            text,
            "<polyline points=\"{}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"1.5\"/>",
            places.join(" ")
        );
        for [a, b] in points {
            let _ = writeln!(
                text,
                "<circle cx=\"{:.1}\" cy=\"{:.1}\" r=\"2\" fill=\"{colour}\"/>",
                x(*a),
                y(*b)
            );
        }
        if let Some([_, b]) = points.last() {
            let _ = writeln!(
                text,
                "<text x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"end\" fill=\"{colour}\">{name}</text>",
                end - 4.0,
                y(*b) - 5.0
            );
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_point_is_within_the_picture() {
        let panel = Panel {
            title: "n".into(),
            lines: vec![
                ("a", vec![[1.0, 2.0], [10.0, 30.0]]),
                ("b", vec![[1.0, 3.0]]),
            ],
        };
        let text = svg(&[panel.clone(), panel], "much");
        let places = text.split("cx=\"").skip(1).map(|rest| {
            let number = rest.split('"').next().unwrap_or_default();
            number.parse::<f64>().unwrap_or(f64::NAN)
        });
        let all: Vec<f64> = places.collect();
        assert_eq!(all.len(), 6);
        assert!(all.iter().all(|x| (0.0..=SIZE[0]).contains(x)), "{all:?}");
    }
}
