//! Links of the Markdown pages: each leads to a file of the repository, and with an
//! anchor to a heading of it; each file of `docs/` is led to. The network is not asked.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Component, Path, PathBuf};

use pulldown_cmark::{Event, Options, Parser, Tag, TagEnd};

use crate::paths;
use crate::problem::Result;

/// Folders whose pages are not ours, or that are made.
const LEFT_OUT: [&str; 4] = ["target", "node_modules", ".git", "fuzz"];

/// What is of interest in a page.
#[derive(Debug, Default, PartialEq, Eq)]
struct Page {
    /// Line and destination.
    links: Vec<(usize, String)>,
    /// What `#` may be followed by.
    anchors: BTreeSet<String>,
}

/// Checks all pages.
pub fn check() -> Result<()> {
    check_in(&paths::root())
}

fn check_in(root: &Path) -> Result<()> {
    let mut files = Vec::new();
    list(root, &mut files)?;
    let mut pages = BTreeMap::new();
    for file in files.iter().filter(|file| is_page(file)) {
        let text =
            fs::read_to_string(file).map_err(|error| format!("{}: {error}", file.display()))?;
        pages.insert(file.clone(), Page::read(&text));
    }
    let mut broken = Vec::new();
    let mut led_to = BTreeSet::new();
    for (file, page) in &pages {
        for (line, link) in &page.links {
            match follow(root, file, link, &pages) {
                Ok(Some(target)) if target != *file => {
                    led_to.insert(target);
                }
                Ok(_) => {}
                Err(why) => {
                    let file = file.strip_prefix(root).unwrap_or(file).display();
                    broken.push(format!("{file}:{line}: `{link}`: {why}"));
                }
            }
        }
    }
    let docs = root.join("docs");
    let lost = files
        .iter()
        .filter(|file| file.starts_with(&docs) && !led_to.contains(*file));
    for file in lost {
        let file = file.strip_prefix(root).unwrap_or(file).display();
        broken.push(format!("{file}: no page leads to it"));
    }
    if broken.is_empty() {
        return Ok(());
    }
    Err(format!("{} broken\n      {}", broken.len(), broken.join("\n      ")).into())
}

fn is_page(file: &Path) -> bool {
    file.extension().is_some_and(|extension| extension == "md")
}

/// All files, in order, without those of folders that are left out.
fn list(folder: &Path, files: &mut Vec<PathBuf>) -> Result<()> {
    let fail = |error| format!("{}: {error}", folder.display());
    let mut entries = Vec::new();
    for entry in fs::read_dir(folder).map_err(fail)? {
        entries.push(entry.map_err(fail)?.path());
    }
    entries.sort();
    for path in entries {
        let name = path.file_name().unwrap_or_default();
        if path.is_dir() {
            if !LEFT_OUT.iter().any(|out| name == *out) {
                list(&path, files)?;
            }
        } else {
            files.push(path);
        }
    }
    Ok(())
}

/// The file that a link leads to; `None` if it is elsewhere than in the repository.
fn follow(
    root: &Path,
    from: &Path,
    link: &str,
    pages: &BTreeMap<PathBuf, Page>,
) -> std::result::Result<Option<PathBuf>, String> {
    let scheme = link.split_once(':').map_or("", |(scheme, _)| scheme);
    if !scheme.is_empty() && scheme.chars().all(|c| c.is_ascii_alphanumeric()) {
        return Ok(None);
    }
    let (path, anchor) = match link.split_once('#') {
        Some((path, anchor)) => (path, Some(anchor)),
        None => (link, None),
    };
    let target = if path.is_empty() {
        from.to_owned()
    } else {
        let folder = from.parent().unwrap_or(root);
        plain(&folder.join(path)).ok_or("it leads out of the file system")?
    };
    if !target.starts_with(root) {
        return Err("it leads out of the repository".into());
    }
    if !target.exists() {
        return Err("there is no such file".into());
    }
    if let Some(anchor) = anchor {
        let page = pages
            .get(&target)
            .ok_or("an anchor, but not of a Markdown page")?;
        if !page.anchors.contains(anchor) {
            let near: Vec<_> = page.anchors.iter().map(|a| format!("#{a}")).collect();
            return Err(format!("no such heading; there are {}", near.join(", ")));
        }
    }
    Ok(Some(target))
}

/// A path without `.` and `..`.
fn plain(path: &Path) -> Option<PathBuf> {
    let mut out = PathBuf::new();
    for part in path.components() {
        match part {
            Component::CurDir => {}
            Component::ParentDir => {
                if !out.pop() {
                    return None;
                }
            }
            part => out.push(part),
        }
    }
    Some(out)
}

impl Page {
    fn read(text: &str) -> Self {
        let mut page = Self::default();
        let mut heading: Option<String> = None;
        let options = Options::ENABLE_TABLES | Options::ENABLE_FOOTNOTES;
        for (event, place) in Parser::new_ext(text, options).into_offset_iter() {
            let line = 1 + text[..place.start].matches('\n').count();
            match event {
                Event::Start(Tag::Link { dest_url, .. } | Tag::Image { dest_url, .. }) => {
                    page.links.push((line, dest_url.into_string()));
                }
                Event::Start(Tag::Heading { .. }) => heading = Some(String::new()),
                Event::End(TagEnd::Heading(_)) => {
                    page.add_heading(&heading.take().unwrap_or_default())
                }
                Event::Text(part) | Event::Code(part) => {
                    if let Some(heading) = &mut heading {
                        heading.push_str(&part);
                    }
                }
                Event::Html(html) | Event::InlineHtml(html) => page.add_html(line, &html),
                _ => {}
            }
        }
        page
    }

    /// Adds a heading's anchor, as hosts of repositories make it: letters, digits, hyphens
    /// and underscores, spaces as hyphens; of several that are alike, the later ones
    /// numbered.
    fn add_heading(&mut self, heading: &str) {
        let kept = heading.trim().chars().filter_map(|c| match c {
            ' ' => Some('-'),
            c if c.is_alphanumeric() || c == '-' || c == '_' => Some(c),
            _ => None,
        });
        let anchor: String = kept.flat_map(char::to_lowercase).collect();
        let numbered = (1..).map(|number| format!("{anchor}-{number}"));
        let mut all = std::iter::once(anchor.clone()).chain(numbered);
        if let Some(free) = all.find(|anchor| !self.anchors.contains(anchor)) {
            self.anchors.insert(free);
        }
    }

    fn add_html(&mut self, line: usize, html: &str) {
        for (name, value) in attributes(html) {
            match name {
                "href" | "src" => self.links.push((line, value.to_owned())),
                "id" => {
                    self.anchors.insert(value.to_owned());
                }
                _ => {}
            }
        }
    }
}

/// Names and values of what is written `name="value"`.
fn attributes(html: &str) -> impl Iterator<Item = (&str, &str)> {
    let mut rest = html;
    std::iter::from_fn(move || {
        let (before, after) = rest.split_once("=\"")?;
        let (value, end) = after.split_once('"')?;
        rest = end;
        let name = before.rsplit([' ', '<', '\n']).next().unwrap_or_default();
        Some((name, value))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn links_pictures_html_and_headings_are_found() {
        let page = Page::read(
            "# One `two`: three\n\n[a](b.md#c) ![d](e.png)\n\n# One two three\n\n\
             <a id=\"here\" href=\"f.md\"><img src=\"g.png\" alt=\"h\"></a>\n\n\
             ```text\n[no](nothing.md)\n```\n",
        );
        let links: Vec<_> = page.links.iter().map(|(n, link)| (*n, &**link)).collect();
        assert_eq!(
            links,
            [(3, "b.md#c"), (3, "e.png"), (7, "f.md"), (7, "g.png")]
        );
        let anchors: Vec<_> = page.anchors.iter().map(|a| &**a).collect();
        assert_eq!(anchors, ["here", "one-two-three", "one-two-three-1"]);
    }

    /// A repository of so many files.
    fn made(name: &str, files: &[(&str, &str)]) -> PathBuf {
        let root = std::env::temp_dir().join(format!("fixel-links-{}-{name}", std::process::id()));
        for (file, text) in files {
            let file = root.join(file);
            fs::create_dir_all(file.parent().expect("a folder")).expect("made");
            fs::write(file, text).expect("written");
        }
        root
    }

    fn broken(name: &str, files: &[(&str, &str)]) -> String {
        let root = made(name, files);
        let result = check_in(&root);
        fs::remove_dir_all(root).expect("removed");
        result.map_or_else(|problem| problem.to_string(), |()| String::new())
    }

    #[test]
    fn what_leads_nowhere_is_told() {
        let page = ("docs/a.md", "# Here\n[up](../README.md#top)");
        let good = "# Top\n[a](docs/a.md) [b](docs/a.md#here) [c](#top) [d](https://example.org) [e](docs/)";
        assert_eq!(broken("good", &[("README.md", good), page]), "");
        for (name, wrong, why) in [
            (
                "file",
                "[a](docs/a.md) [b](no.md)",
                "README.md:2: `no.md`: there is no such file",
            ),
            ("anchor", "[a](docs/a.md#there)", "there are #here"),
            (
                "out",
                "[a](docs/a.md) [b](../../x.md)",
                "out of the repository",
            ),
            (
                "lines",
                "[a](docs/a.md) [b](x.rs#L1)",
                "not of a Markdown page",
            ),
            ("lost", "nothing", "docs/a.md: no page leads to it"),
        ] {
            let text = format!("# Top\n{wrong}");
            let told = broken(name, &[("README.md", &text), page, ("x.rs", "")]);
            assert!(told.contains(why), "{name}: {told}");
        }
    }
}
