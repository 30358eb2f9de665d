//! How many pixels are how far off, as bars.

use std::fmt::Write;

/// Bars; the last takes all beyond.
const BARS: usize = 16;
const WIDTH: usize = 320;
const HEIGHT: usize = 120;

/// A drawing of absolute differences from 0 to `full`, on a scale of logarithms, for what
/// is far off is rare; and what there is to say of them.
pub(crate) fn histogram(values: impl Iterator<Item = f64>, full: f64, unit: &str) -> String {
    let mut counts = [0_usize; BARS + 1];
    for value in values {
        let bar = (value / full * BARS as f64) as usize;
        counts[bar.min(BARS)] += 1;
    }
    let all: usize = counts.iter().sum();
    let most = counts.iter().max().copied().unwrap_or(0);
    let tall = |count: usize| match count {
        0 => 0.0,
        // A single pixel is seen.
        _ => 4.0 + (HEIGHT - 4) as f64 * log(count) / log(most).max(1.0),
    };
    let wide = WIDTH / (BARS + 1);
    let mut svg = format!(
        "<svg class=\"histogram\" viewBox=\"0 0 {WIDTH} {}\" role=\"img\" \
         aria-label=\"Histogram, {unit}\">\n",
        HEIGHT + 18
    );
    for (bar, count) in counts.iter().enumerate() {
        let height = tall(*count);
        let from = full * bar as f64 / BARS as f64;
        let upto = full * (bar + 1) as f64 / BARS as f64;
        let range = if bar == BARS {
            format!("{from} and more")
        } else {
            format!("{from} to {upto}")
        };
        let share = 100.0 * *count as f64 / all.max(1) as f64;
        let beyond = if bar == BARS { " class=\"beyond\"" } else { "" };
        let _ = writeln!(
            svg,
            "<rect{beyond} x=\"{}\" y=\"{:.1}\" width=\"{}\" height=\"{height:.1}\">\
             <title>{range} {unit}: {count} px, {share:.3} %</title></rect>",
            bar * wide + 1,
            HEIGHT as f64 - height,
            wide - 2,
        );
    }
    let _ = writeln!(
        svg,
        "<line x1=\"0\" x2=\"{WIDTH}\" y1=\"{HEIGHT}\" y2=\"{HEIGHT}\"/>\n\
         <text x=\"1\" y=\"{y}\">0</text>\n\
         <text x=\"{}\" y=\"{y}\" text-anchor=\"middle\">{}</text>\n\
         <text x=\"{}\" y=\"{y}\" text-anchor=\"end\">{full} and more</text>\n</svg>",
        wide * BARS / 2,
        full / 2.0,
        wide * (BARS + 1),
        y = HEIGHT + 14,
    );
    svg
}

fn log(count: usize) -> f64 {
    (count as f64).log10()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_value_is_in_its_bar() {
        let svg = histogram([0.0, 0.1, 0.25, 3.9, 4.0, 99.0].into_iter(), 4.0, "units");
        let titles: Vec<&str> = svg
            .split("<title>")
            .skip(1)
            .filter_map(|text| text.split_once("</title>"))
            .map(|(title, _)| title)
            .collect();
        assert_eq!(titles.len(), BARS + 1);
        assert_eq!(titles[0], "0 to 0.25 units: 2 px, 33.333 %");
        assert_eq!(titles[1], "0.25 to 0.5 units: 1 px, 16.667 %");
        assert_eq!(titles[2], "0.5 to 0.75 units: 0 px, 0.000 %");
        assert_eq!(titles[15], "3.75 to 4 units: 1 px, 16.667 %");
        assert_eq!(titles[16], "4 and more units: 2 px, 33.333 %");
        assert!(!histogram(std::iter::empty(), 4.0, "units").contains("NaN"));
    }
}
