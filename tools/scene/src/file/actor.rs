//! `[[actor]]`.

use std::collections::HashMap;

use glam::DVec3;

use super::annotation::{list_of_places, places};
use super::look::look;
use super::table::{Keys, Neutral, Table, to_f64};
use crate::description::{Actor, IDENTITY, Material, Mesh};
use crate::error::Error;
use crate::mesh;

pub(super) const ACTOR: Keys = Keys {
    known: &[
        "name",
        "mesh",
        "sphere",
        "plane",
        "detail",
        "polygon",
        "holes",
        "material",
        "origin",
        "position",
        "orientation",
        "scale",
        "representation",
        "line_width",
        "point_size",
        "point_shape",
        "shear",
        "matrix",
        "parent",
    ],
    later: &[("billboard", Neutral::Never)],
};

/// Where an actor's mesh comes from.
pub(super) enum Shape<'t> {
    /// A file, by its name.
    File(&'t str),
    /// The scene file itself.
    Made(Mesh),
}

/// Triangles of a sphere: 20 times 4 to the power of this.
const DETAIL: u32 = 3;

/// A mesh's file, a sphere, a plane or a polygon.
pub(super) fn shape<'t>(table: &Table<'t, '_>) -> Result<Shape<'t>, Error> {
    let example = "meshes/teapot.obj";
    let shapes = ["mesh", "sphere", "plane", "polygon"];
    let mut given = shapes.into_iter().filter(|key| table.has(key));
    if let (Some(_), Some(second)) = (given.next(), given.next()) {
        let what = "is one mesh too many; expected one of mesh, sphere, plane and polygon";
        return Err(table.error(second, what));
    }
    for (key, owners) in [
        ("detail", ["sphere", "plane"].as_slice()),
        ("holes", &["polygon"]),
    ] {
        if table.has(key) && !owners.iter().any(|owner| table.has(owner)) {
            let owners = owners.join(" or ");
            let what = format!("says nothing here; expected it with {owners}");
            return Err(table.error(key, what));
        }
    }
    if let Some(radius) = table.number("sphere", super::FACTOR)? {
        let detail = table.whole("detail", 0..=6)?.unwrap_or(DETAIL);
        return Ok(Shape::Made(mesh::sphere(radius, detail)));
    }
    if table.has("plane") {
        return plane(table).map(Shape::Made);
    }
    if table.has("polygon") {
        return polygon(table).map(Shape::Made);
    }
    match table.text("mesh", example)? {
        Some(name) => Ok(Shape::File(name)),
        None => {
            let what = format!("is missing; expected e.g. mesh = \"{example}\"");
            Err(table.error("mesh", what))
        }
    }
}

fn plane(table: &Table<'_, '_>) -> Result<Mesh, Error> {
    let example = "[4, 3]";
    let sides = table.numbers::<2>("plane", f64::MAX, example)?;
    let sides = sides.unwrap_or_default();
    if let Some(side) = sides.iter().find(|side| !super::FACTOR.contains(*side)) {
        let what = format!("{side} is out of range (1e-6..=1e6)");
        return Err(table.error("plane", format!("{what}; expected e.g. plane = {example}")));
    }
    let detail = table.whole("detail", 0..=6)?.unwrap_or(0);
    Ok(mesh::rectangle(sides, detail))
}

fn polygon(table: &Table<'_, '_>) -> Result<Mesh, Error> {
    let example = "[[0, 0, 0], [1, 0, 0], [0, 1, 0]]";
    let outline = places(table, "polygon", (3, super::LENGTH), example)?;
    let holes_example = "[[[0.2, 0.2, 0], [0.4, 0.2, 0], [0.2, 0.4, 0]]]";
    let mut holes = Vec::new();
    if let Some(array) = table.array("holes", holes_example)? {
        for hole in array {
            holes.push(list_of_places(
                table,
                "holes",
                hole.get_ref(),
                (3, super::LENGTH),
                holes_example,
            )?);
        }
    }
    let short = |ring: &Vec<[f64; 3]>| ring.len() < 3;
    for (key, short) in [
        ("polygon", short(&outline)),
        ("holes", holes.iter().any(short)),
    ] {
        if short {
            let what = format!("has fewer than 3 corners; expected e.g. polygon = {example}");
            return Err(table.error(key, what));
        }
    }
    mesh::polygon(&outline, &holes).map_err(|what| {
        table.error(
            "polygon",
            format!("{what}; expected e.g. polygon = {example}"),
        )
    })
}

/// Where an actor is, and of what material; its mesh is read by the caller.
pub(super) fn actor(
    table: &Table<'_, '_>,
    index: usize,
    mesh: usize,
    materials: &[Material],
) -> Result<Actor, Error> {
    let name = table.text("name", "pot")?.map(str::to_owned);
    let place = |key, example| {
        let numbers = table.numbers::<3>(key, super::LENGTH, example)?;
        Ok(numbers.unwrap_or_default())
    };
    Ok(Actor {
        name: name.unwrap_or_else(|| format!("actor {index}")),
        mesh,
        material: material(table, materials)?,
        origin: place("origin", "[0, 1.5, 0]")?,
        position: place("position", "[0, 1.5, 0]")?,
        orientation: table
            .numbers("orientation", super::ANGLE, "[0, 45, 0]")?
            .unwrap_or_default(),
        scale: scale(table)?,
        look: look(table)?,
        still: false,
        part: false,
        shear: shear(table)?,
        matrix: matrix(table)?,
        parent: None,
    })
}

/// Gives actors their parents, by name: in `tables`, one an actor.
pub(super) fn parents(tables: &[Table<'_, '_>], actors: &mut [Actor]) -> Result<(), Error> {
    let mut numbers = HashMap::new();
    for (index, actor) in actors.iter().enumerate() {
        numbers.entry(actor.name.clone()).or_insert(index);
    }
    for (index, table) in tables.iter().enumerate() {
        let Some(name) = table.text("parent", "arm")? else {
            continue;
        };
        actors[index].parent = Some(match numbers.get(name) {
            Some(parent) => *parent,
            None => find(table, "parent", name, actors)?,
        });
    }
    // How many actors are above those whose chain is known to end.
    let mut above: Vec<Option<usize>> = vec![None; actors.len()];
    for start in 0..actors.len() {
        let mut chain = Vec::new();
        let mut next = Some(start);
        while let Some(index) = next.filter(|index| above[*index].is_none()) {
            // Twice in a chain: it goes round.
            if chain.len() > actors.len() {
                return Err(ring(tables, actors, index));
            }
            chain.push(index);
            next = actors[index].parent;
        }
        for index in chain.into_iter().rev() {
            let parent = actors[index].parent.and_then(|parent| above[parent]);
            let count = parent.map_or(0, |parent| parent + 1);
            if count > MOST_PARENTS {
                let what =
                    format!("is one too many; expected at most {MOST_PARENTS} above an actor");
                return Err(tables[index].error("parent", what));
            }
            above[index] = Some(count);
        }
    }
    Ok(())
}

/// A ring of parents that goes through an actor: at the last of them in the file, which
/// closes it.
fn ring(tables: &[Table<'_, '_>], actors: &[Actor], through: usize) -> Error {
    let above = |index: &usize| actors[*index].parent;
    let mut ring = vec![through];
    ring.extend(std::iter::successors(above(&through), above).take_while(|at| *at != through));
    let last = ring.iter().copied().max().unwrap_or(through);
    let from_last = std::iter::successors(Some(last), above);
    let names = from_last.map(|at| format!("\"{}\"", actors[at].name));
    let mut names: Vec<String> = names.take(ring.len() + 1).collect();
    if names.len() > FEW {
        names.splice(FEW / 2..names.len() - FEW / 2, ["others".to_owned()]);
    }
    let names = names.join(" of ");
    let what = format!("goes round in a ring ({names}); expected a chain that ends");
    tables[last].error("parent", what)
}

/// An actor by its name.
pub(super) fn find(
    table: &Table<'_, '_>,
    key: &str,
    name: &str,
    actors: &[Actor],
) -> Result<usize, Error> {
    let found = actors.iter().position(|actor| actor.name == name);
    found.ok_or_else(|| {
        let what = format!(
            "no [[actor]] is named \"{name}\"; expected {}",
            one_of(actors.iter().map(|actor| &actor.name))
        );
        table.error(key, what)
    })
}

/// Actors above an actor, as a blob has them at most.
const MOST_PARENTS: usize = 16;
/// Names that a message lists.
const FEW: usize = 8;

/// Names to choose from, for a message: the first few.
fn one_of<'n>(names: impl Iterator<Item = &'n String>) -> String {
    let mut names: Vec<String> = names.take(FEW + 1).map(|n| format!("\"{n}\"")).collect();
    if names.len() > FEW {
        names[FEW] = "another".to_owned();
    }
    names.join(" or ")
}

/// Three factors or six; none is no shear.
fn shear(table: &Table<'_, '_>) -> Result<[f64; 6], Error> {
    const MOST: f64 = 1000.0;
    let example = "[0.5, 0, 0] (y to x, z to x, z to y)";
    let Some(array) = table.array("shear", example)? else {
        return Ok([0.0; 6]);
    };
    if array.len() != 6 {
        let three = table.numbers::<3>("shear", MOST, example)?;
        let [xy, xz, yz] = three.unwrap_or_default();
        return Ok([xy, xz, 0.0, yz, 0.0, 0.0]);
    }
    let example = "[0.5, 0, 0, 0, 0, 0] (y, z to x; x, z to y; x, y to z)";
    let six = table.numbers::<6>("shear", MOST, example)?;
    let six = six.unwrap_or_default();
    let [xy, xz, yx, yz, zx, zy] = six;
    let rows = [[1.0, xy, xz], [yx, 1.0, yz], [zx, zy, 1.0]];
    if flattens(rows) {
        let what = "flattens the actor, its determinant is 0";
        return Err(table.error("shear", format!("{what}; expected e.g. shear = {example}")));
    }
    Ok(six)
}

/// Sixteen numbers, row by row.
fn matrix(table: &Table<'_, '_>) -> Result<[[f64; 4]; 4], Error> {
    let example = "[1, 0, 0, 5, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]";
    let Some(numbers) = table.numbers::<16>("matrix", super::LENGTH, example)? else {
        return Ok(IDENTITY);
    };
    let mut rows = IDENTITY;
    rows.as_flattened_mut().copy_from_slice(&numbers);
    let [x, y, z, last] = rows;
    let what = if last != IDENTITY[3] {
        "the last four numbers are not 0, 0, 0, 1 (a perspective belongs to the camera)"
    } else if flattens([x, y, z].map(|[a, b, c, _]| [a, b, c])) {
        "flattens the actor, its determinant is 0"
    } else {
        return Ok(rows);
    };
    Err(table.error(
        "matrix",
        format!("{what}; expected e.g. matrix = {example}"),
    ))
}

/// Whether a matrix cannot be inverted, or hardly.
fn flattens(rows: [[f64; 3]; 3]) -> bool {
    let [x, y, z] = rows.map(DVec3::from);
    let sizes = x.length() * y.length() * z.length();
    x.cross(y).dot(z).abs() <= sizes * 1e-9
}

/// The material by name; the first one if the actor names none.
fn material(table: &Table<'_, '_>, materials: &[Material]) -> Result<usize, Error> {
    let Some(name) = table.text("material", "clay")? else {
        return Ok(0);
    };
    let found = materials.iter().position(|material| material.name == name);
    found.ok_or_else(|| {
        let what = format!(
            "no [[material]] is named \"{name}\"; expected {}",
            one_of(materials.iter().map(|material| &material.name))
        );
        table.error("material", what)
    })
}

/// One number for all three directions, or three.
fn scale(table: &Table<'_, '_>) -> Result<[f64; 3], Error> {
    let example = "2 or scale = [1, 2, 1]";
    let scale = match table.get("scale").map(|value| to_f64(value.get_ref())) {
        None => return Ok([1.0; 3]),
        Some(Some(number)) => [number; 3],
        Some(None) => table
            .numbers("scale", f64::MAX, example)?
            .unwrap_or([1.0; 3]),
    };
    for factor in scale {
        if !super::FACTOR.contains(&factor.abs()) {
            return Err(table.error(
                "scale",
                format!(
                    "{factor} is out of range (1e-6..=1e6 either side of 0); \
                     expected e.g. scale = {example}"
                ),
            ));
        }
    }
    Ok(scale)
}
