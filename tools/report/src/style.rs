//! What pages look like.

/// Colours of light and dark, and the layout of both kinds of page.
pub(crate) const STYLE: &str = r#"
:root {
  color-scheme: light dark;
  --back: #f6f7f9; --card: #ffffff; --line: #dfe3e8; --text: #1d2127; --quiet: #5c6673;
  --accent: #0a6c8f; --bar: #3b8ea5; --beyond: #c2452d; --good: #1a7f4b; --bad: #b3261e;
}
@media (prefers-color-scheme: dark) {
  :root {
    --back: #15181c; --card: #1e2228; --line: #343a43; --text: #e6e9ed; --quiet: #9aa4b1;
    --accent: #6cc3e0; --bar: #5fb0c6; --beyond: #ef7a62; --good: #5fce93; --bad: #ff8a80;
  }
}
* { box-sizing: border-box; }
body {
  font: 15px/1.5 system-ui, sans-serif; margin: 0 auto; padding: 1.5rem; max-width: 1500px;
  color: var(--text); background: var(--back);
}
h1 { font-size: 1.5rem; margin: 0 0 .25rem; overflow-wrap: anywhere; }
h2 { font-size: 1.1rem; margin: 2rem 0 .75rem; }
p { margin: .25rem 0 1rem; color: var(--quiet); max-width: 75ch; }
a { color: var(--accent); }
code { font: .85em ui-monospace, monospace; color: var(--quiet); }
.key { display: flex; flex-wrap: wrap; gap: .75rem; margin: 1rem 0; }
.key div {
  background: var(--card); border: 1px solid var(--line); border-radius: 8px;
  padding: .5rem .9rem; min-width: 9rem;
}
.key b { display: block; font-size: 1.3rem; font-variant-numeric: tabular-nums; }
.key span { color: var(--quiet); font-size: .85rem; }
main { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(100%, 340px), 1fr)); gap: 1rem; }
figure {
  margin: 0; background: var(--card); border: 1px solid var(--line); border-radius: 8px;
  overflow: hidden;
}
figure img { width: 100%; height: auto; image-rendering: pixelated; display: block; }
figcaption { padding: .6rem .8rem; font-size: .9rem; color: var(--quiet); }
figcaption b { color: var(--text); }
.both { position: relative; }
.both img + img { position: absolute; inset: 0; opacity: 0; }
.both:hover img + img, .both:focus img + img { opacity: 1; }
.ramp { display: inline-block; width: 4.5em; height: .7em; border: 1px solid var(--line);
  background: linear-gradient(90deg, #000, #f00, #ff0, #fff); vertical-align: baseline; }
.dot { display: inline-block; width: .7em; height: .7em; border: 1px solid var(--line); }
.histogram { width: 100%; display: block; padding: .8rem .8rem 0; }
.histogram rect { fill: var(--bar); }
.histogram rect.beyond { fill: var(--beyond); }
.histogram line { stroke: var(--quiet); }
.histogram text { fill: var(--quiet); font-size: 11px; }
.scroll { overflow-x: auto; background: var(--card); border: 1px solid var(--line); border-radius: 8px; }
table { border-collapse: collapse; width: 100%; }
th, td { padding: .3rem .8rem; text-align: left; border-bottom: 1px solid var(--line); }
tr:last-child td { border-bottom: 0; }
.n { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
.index img { height: 60px; max-width: 100px; object-fit: contain; display: block; image-rendering: auto; }
.index th { position: sticky; top: 0; background: var(--card); vertical-align: bottom; font-size: .85rem; }
.index th button {
  font: inherit; font-weight: 600; color: inherit; background: none; border: 0; padding: 0;
  cursor: pointer; text-align: inherit;
}
.index th[aria-sort] button::after { content: " \2191"; color: var(--accent); }
.index th[aria-sort=descending] button::after { content: " \2193"; }
.good { color: var(--good); } .bad { color: var(--bad); }
"#;

/// The beginning of a page, up to its heading.
pub(crate) fn head(title: &str) -> String {
    format!(
        "<!doctype html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <title>{title}</title>\n<style>{STYLE}</style>\n<h1>{title}</h1>\n"
    )
}
