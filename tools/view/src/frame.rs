//! The window's picture: the panel in its bezel, figures under it, and what is laid over.

use crate::canvas::{Canvas, Colour, LETTER, LINE, Rect, wrapped};
use crate::draw::Picture;
use crate::keys::HELP;
use crate::state::{BAND_ROWS, State};

const AROUND: Colour = 0x002B_2F36;
const BEZEL: Colour = 0x0012_1316;
const EDGE: Colour = 0x0054_5B66;
const SCREEN: Colour = 0x0000_0000;
const WORDS: Colour = 0x00E8_EAED;
const QUIET: Colour = 0x009A_A3AF;
const SHADE: Colour = 0x0010_1216;
const ERROR: Colour = 0x0098_1B1B;
const BEAM: Colour = 0x00FF_C400;

/// The bezel's width, and what is left free about it, in pixels at a scale of 1.
const BEZEL_WIDTH: u32 = 10;
const MARGIN: u32 = 14;
/// Lines of figures at most, a line of words among them.
const FIGURES: u32 = 6;

/// Where the panel is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PanelPlace {
    /// Its pixels in the window.
    pub rect: Rect,
    /// Window pixels that a panel pixel takes.
    pub zoom: u32,
}

/// What a window of a size and scale looks like.
#[derive(Clone, Copy, Debug)]
pub struct Look {
    /// Width and height in pixels.
    pub size: [u32; 2],
    /// Window pixels that a pixel of a letter takes: 2 on screens of twice the density.
    pub scale: u32,
    /// Window pixels that a panel pixel takes; none: as many as fit.
    pub zoom: Option<u32>,
}

/// Pixels of the window around the panel: of both sides, and of top and bottom.
fn around(scale: u32, figures: bool) -> [u32; 2] {
    let side = (BEZEL_WIDTH + MARGIN) * 2 * scale;
    let words = if figures {
        FIGURES * LINE * scale + MARGIN * scale
    } else {
        0
    };
    [side, side + words]
}

/// The size of a window that just holds a panel.
pub fn wanted(panel: [u32; 2], scale: u32, zoom: u32) -> [u32; 2] {
    let [across, down] = around(scale, true);
    let width = (panel[0] * zoom + across).max(90 * LETTER * scale);
    [width, panel[1] * zoom + down]
}

/// The largest zoom at which a panel fits, at least 1.
pub fn fitting(panel: [u32; 2], scale: u32, size: [u32; 2], figures: bool) -> u32 {
    let around = around(scale, figures);
    let axis = |axis: usize| size[axis].saturating_sub(around[axis]) / panel[axis].max(1);
    axis(0).min(axis(1)).max(1)
}

/// Where the panel is in a window.
pub fn place(state: &State, look: &Look) -> PanelPlace {
    let panel = state.size();
    let figures = state.figures();
    let zoom = look
        .zoom
        .unwrap_or_else(|| fitting(panel, look.scale, look.size, figures));
    let [across, down] = around(look.scale, figures);
    let side = ((BEZEL_WIDTH + MARGIN) * look.scale) as i32;
    let middle = |axis: usize, around: u32| {
        let room = i64::from(look.size[axis]) - i64::from(around) - i64::from(panel[axis] * zoom);
        side + (room / 2).max(0) as i32
    };
    PanelPlace {
        rect: Rect {
            x: middle(0, across),
            y: middle(1, down),
            width: panel[0] * zoom,
            height: panel[1] * zoom,
        },
        zoom,
    }
}

/// Draws the window.
pub fn draw(state: &State, picture: Option<&Picture>, look: &Look) -> Canvas {
    let mut canvas = Canvas::new(look.size, look.scale, AROUND);
    let place = place(state, look);
    let bezel = place.rect.grown((BEZEL_WIDTH * look.scale) as i32);
    canvas.fill(bezel.grown(look.scale as i32), EDGE);
    canvas.fill(bezel, BEZEL);
    canvas.fill(place.rect, SCREEN);
    if let Some(picture) = picture
        && [picture.width, picture.height] == state.size()
    {
        let Rect { x, y, .. } = place.rect;
        canvas.picture(x, y, place.zoom, picture.width, &picture.rgb);
        if let Some(bands) = state.bands() {
            beam(&mut canvas, &place, bands);
        }
    }
    if state.figures() {
        words(&mut canvas, state, picture, look);
    }
    if let Some(error) = state.error() {
        // Over the figures: the last picture stays in sight.
        let lines = wrapped(error, letters(look));
        let top = look.size[1] as i32 - box_height(look, &lines);
        box_of_lines(&mut canvas, look, top, ERROR, &lines);
    }
    if state.help() {
        help(&mut canvas, look);
    }
    canvas
}

/// What is not sent yet is dark; a line marks the band that is drawn.
fn beam(canvas: &mut Canvas, place: &PanelPlace, bands: u32) {
    let Rect {
        x,
        y,
        width,
        height,
    } = place.rect;
    let done = (bands * BAND_ROWS * place.zoom).min(height);
    if done == height {
        return;
    }
    let rest = Rect {
        x,
        y: y + done as i32,
        width,
        height: height - done,
    };
    canvas.mix(rest, SCREEN, 176);
    let edge = BEZEL_WIDTH as i32;
    let band = Rect {
        x: x - edge,
        height: (BAND_ROWS * place.zoom).min(height - done),
        width: width.saturating_add_signed(2 * edge),
        ..rest
    };
    for side in [band.x, band.x + band.width as i32 - edge / 2] {
        let mark = Rect {
            x: side,
            width: edge as u32 / 2,
            ..band
        };
        canvas.fill(mark, BEAM);
    }
}

/// Letters that fit a line.
fn letters(look: &Look) -> usize {
    (look.size[0].saturating_sub(2 * MARGIN * look.scale) / (LETTER * look.scale)) as usize
}

fn words(canvas: &mut Canvas, state: &State, picture: Option<&Picture>, look: &Look) {
    let most = letters(look);
    let cut = |text: String| text.chars().take(most).collect::<String>();
    let figures = picture.map_or(&[][..], |picture| &picture.figures);
    let coarse = picture.is_some_and(|picture| !picture.whole);
    let mut lines = vec![(WORDS, state.headline())];
    let mut quiet = figures.to_vec();
    if coarse {
        quiet = vec!["drawing finer ...".into()];
    }
    if picture.is_none() && state.error().is_none() {
        quiet = vec!["drawing ...".into()];
    }
    match state.note() {
        Some(note) => quiet.insert(0, note.to_owned()),
        None if quiet.len() < FIGURES as usize - 1 => {
            quiet.resize(FIGURES as usize - 2, String::new());
            quiet.push("? shows the keys".into());
        }
        None => {
            if let Some(last) = quiet.last_mut() {
                last.push_str("; ? shows the keys");
            }
        }
    }
    lines.extend(quiet.into_iter().map(|line| (QUIET, line)));
    let step = (LINE * look.scale) as i32;
    let x = (MARGIN * look.scale) as i32;
    let y = look.size[1] as i32 - (MARGIN / 2 * look.scale) as i32 - FIGURES as i32 * step;
    for (row, (colour, line)) in (0..FIGURES as i32).zip(lines) {
        canvas.text(x, y + row * step, colour, &cut(line));
    }
}

/// How high a box of lines is.
fn box_height(look: &Look, lines: &[String]) -> i32 {
    (lines.len() as i32 * LINE as i32 + MARGIN as i32) * look.scale as i32
}

/// Lines in a box across the window, from a row on.
fn box_of_lines(canvas: &mut Canvas, look: &Look, top: i32, back: Colour, lines: &[String]) {
    let step = (LINE * look.scale) as i32;
    let edge = (MARGIN / 2 * look.scale) as i32;
    let rect = Rect {
        x: 0,
        y: top,
        width: look.size[0],
        height: box_height(look, lines) as u32,
    };
    canvas.mix(rect, back, 236);
    for (row, line) in (0..).zip(lines) {
        let y = top + edge + row * step;
        canvas.text((MARGIN * look.scale) as i32, y, WORDS, line);
    }
}

/// Letters of a column of the help: of the keys, and in all.
const HELP_KEYS: usize = 19;
const HELP_COLUMN: usize = 46;

fn help(canvas: &mut Canvas, look: &Look) {
    let columns = if letters(look) >= 2 * HELP_COLUMN {
        2
    } else {
        1
    };
    let rows = HELP.len().div_ceil(columns);
    let cell = |number: usize| match HELP.get(number) {
        Some(row) => {
            let text = format!("{:<HELP_KEYS$}{}", row.keys, row.what);
            format!("{text:<HELP_COLUMN$}")
        }
        None => String::new(),
    };
    let line = |row: usize| {
        (0..columns)
            .map(|c| cell(c * rows + row))
            .collect::<String>()
    };
    let lines: Vec<String> = (0..rows).map(line).collect();
    box_of_lines(canvas, look, 0, SHADE, &lines);
}

#[cfg(test)]
mod tests;
