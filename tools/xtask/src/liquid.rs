//! As much of the Liquid language as the template for `cargo generate` has: values in double
//! braces, and `if`, `else`, `endif` that compare a value with a text.

use std::fmt::Write;

/// Values by their names.
type Values<'a> = [(&'a str, &'a str)];

/// A text with its values filled in.
pub fn expand(text: &str, values: &Values<'_>) -> Result<String, String> {
    let mut out = String::new();
    // Of each `if` that is open, whether its part is taken.
    let mut taken: Vec<bool> = Vec::new();
    let mut rest = text;
    while let Some(at) = rest.find('{') {
        let (before, tag) = rest.split_at(at);
        let shown = taken.iter().all(|taken| *taken);
        let (closing, is_value) = match tag.as_bytes().get(1) {
            Some(b'{') => ("}}", true),
            Some(b'%') => ("%}", false),
            _ => {
                push(&mut out, shown, rest.get(..at + 1).unwrap_or_default());
                rest = rest.get(at + 1..).unwrap_or_default();
                continue;
            }
        };
        let end = tag.find(closing).ok_or_else(|| format!("no {closing}"))?;
        let inside = tag.get(2..end).unwrap_or_default();
        rest = tag.get(end + 2..).unwrap_or_default();
        // A hyphen takes the space before it away.
        let strips = inside.starts_with('-');
        let before = if strips { before.trim_end() } else { before };
        push(&mut out, shown, before);
        let words: Vec<_> = inside.trim_start_matches('-').split_whitespace().collect();
        match words.as_slice() {
            [name] if is_value => push(&mut out, shown, value(name, values)?),
            ["if", name, "==", text] => taken.push(value(name, values)? == text.trim_matches('"')),
            ["if", name, "!=", text] => taken.push(value(name, values)? != text.trim_matches('"')),
            ["else"] => {
                let last = taken.last_mut().ok_or("else without if")?;
                *last = !*last;
            }
            ["endif"] => {
                taken.pop().ok_or("endif without if")?;
            }
            _ => return Err(format!("what is `{inside}`?")),
        }
    }
    if !taken.is_empty() {
        return Err("if without endif".to_owned());
    }
    push(&mut out, true, rest);
    Ok(out)
}

fn push(out: &mut String, shown: bool, text: &str) {
    if shown {
        // Into memory.
        let _ = out.write_str(text);
    }
}

fn value<'a>(name: &str, values: &Values<'a>) -> Result<&'a str, String> {
    let found = values.iter().find(|(known, _)| *known == name);
    found
        .map(|(_, value)| *value)
        .ok_or_else(|| format!("no value for `{name}`"))
}

#[cfg(test)]
mod tests {
    use super::expand;

    const VALUES: [(&str, &str); 2] = [("chip", "qemu"), ("path", "")];

    #[test]
    fn values_and_choices() {
        let all = |text| expand(text, &VALUES);
        assert_eq!(all("a {{chip}} { {{ chip }}").unwrap(), "a qemu { qemu");
        let choice = "1\n{%- if chip == \"x\" %}\n2{{path}}\n{%- else %}\n3\n{%- endif %}\n4";
        assert_eq!(all(choice).unwrap(), "1\n3\n4");
        assert_eq!(all("{% if path != \"\" %}a{% endif %}b").unwrap(), "b");
        assert!(all("{{other}}").is_err());
        assert!(all("{% if chip == \"qemu\" %}").is_err());
        assert!(all("{% endif %}").is_err());
        assert!(all("{% for x in y %}").is_err());
    }
}
