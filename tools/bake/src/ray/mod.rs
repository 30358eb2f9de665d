//! What the ray caster needs: a hierarchy over each mesh's triangles, whose leaves are
//! runs of a meshlet's triangles, and exact balls and rectangles in place of
//! their triangles.

mod hierarchy;
mod seen;

use fixel::scene::{LightArea, Node, Optics, RaySettings, Shape};
use fixel_scene::{Actor, Element, Material, Primitive, Scene};
use glam::{DMat3, DVec3};

use crate::error::{BakeError, Problem, Spot};
use crate::facing::point;
use crate::grid::Grid;
use crate::instance::Instance;
use crate::mesh::Parts;
use crate::units::{Units, unit_q30};
use hierarchy::{Box3, Item};
pub(crate) use seen::seen;

/// The ray caster's sections; all empty for a scene that is only rasterised.
#[derive(Default)]
pub(crate) struct Rays {
    pub settings: Vec<RaySettings>,
    pub shapes: Vec<Shape>,
    pub nodes: Vec<Node>,
    pub optics: Vec<Optics>,
    pub areas: Vec<LightArea>,
}

/// Whether pixels mix the colours of several surfaces, so that all have to be colours.
pub(crate) fn mixes(scene: &Scene) -> bool {
    let several = |m: &Material| m.reflectivity > 0.0 || m.opacity < 1.0;
    scene.ray.samples > 1 || scene.materials.iter().any(several)
}

/// Puts the triangles of all meshlets in the order of their hierarchies' leaves.
pub(crate) fn rays(
    scene: &Scene,
    units: &Units,
    instances: &[Instance],
    parts: &mut Parts,
) -> Result<Rays, BakeError> {
    let mut rays = Rays {
        settings: vec![settings(scene)],
        optics: scene.materials.iter().map(optics).collect(),
        ..Rays::default()
    };
    for (mesh, instance) in instances.iter().enumerate() {
        let textured = |actor: &Actor| {
            actor.mesh == instance.mesh && scene.materials[actor.material].texture.is_some()
        };
        let shape = match scene.meshes[instance.mesh].primitive {
            // A picture needs the triangles' texture coordinates.
            Some(Primitive::Sphere { radius }) if !scene.actors.iter().any(textured) => {
                ball(radius, instance, &parts.grids[mesh])
            }
            Some(Primitive::Rectangle { width, depth }) if even(instance) => {
                rectangle([width, depth], instance, &parts.grids[mesh])
            }
            _ => triangles(parts, mesh, &mut rays.nodes)?,
        };
        rays.shapes.push(shape);
    }
    for (number, light) in scene.lights.iter().enumerate() {
        let spot = Spot::new(Element::Light(number), "light.edges");
        let mut area = LightArea::POINT;
        if let Some(edges) = light.edges {
            for (to, edge) in area.edges.iter_mut().zip(edges) {
                *to = units.vector(spot, DVec3::from(edge))?;
            }
        }
        rays.areas.push(area);
    }
    Ok(rays)
}

fn settings(scene: &Scene) -> RaySettings {
    let ray = &scene.ray;
    RaySettings {
        shadows: ray.shadows,
        depth: ray.depth.clamp(1, 8) as u8,
        samples: ray.samples.clamp(1, 16) as u8,
        light_samples: ray.light_samples.clamp(1, 16) as u8,
        threshold: (ray.threshold.clamp(0.0, 1.0) * 255.0 * 64.0).round() as u16,
        up: unit_q30(DVec3::from(scene.camera.view_up)),
    }
}

fn optics(material: &Material) -> Optics {
    let part = |v: f64| (v * 65536.0).round() as u32;
    Optics {
        reflectivity: part(material.reflectivity.clamp(0.0, 1.0)),
        opacity: part(material.opacity.clamp(0.0, 1.0)),
        index: part(material.refractive_index.clamp(1.0, 4.0)),
    }
}

/// A sphere about its mesh's origin, in the mesh's grid.
fn ball(radius: f64, instance: &Instance, grid: &Grid) -> Shape {
    let steps = f64::exp2(f64::from(grid.exponent));
    // The origin is a grid point.
    let centre = (-grid.centre * steps).round().as_ivec3().to_array();
    let linear = instance.linear * radius * steps;
    let [x, y, z] = [linear.x_axis, linear.y_axis, linear.z_axis];
    let length = x.length();
    let even = |a: f64, b: f64| (a - b).abs() < 1e-9 * length;
    let square = [x.dot(y), y.dot(z), z.dot(x)];
    let round = even(y.length(), length)
        && even(z.length(), length)
        && square.iter().all(|c| c.abs() < 1e-9 * length * length);
    if round {
        return Shape::Ball {
            centre,
            radius: (length * 256.0).round() as u32,
        };
    }
    let inverse = linear.inverse();
    let largest = inverse
        .to_cols_array()
        .iter()
        .fold(0.0, |m: f64, c| m.max(c.abs()));
    let exponent = (30.0 - largest.log2()).floor().clamp(30.0, 60.0);
    let entry = |c: f64| (c * f64::exp2(exponent)).round() as i32;
    let row = |row: usize| inverse.row(row).to_array().map(entry);
    Shape::Ellipsoid {
        centre,
        rows: [row(0), row(1), row(2)],
        exponent: exponent as u8,
    }
}

/// Whether an instance only scales along its axes.
fn even(instance: &Instance) -> bool {
    let linear = instance.linear;
    let scales = DVec3::new(linear.x_axis.x, linear.y_axis.y, linear.z_axis.z);
    scales.abs().min_element() > 0.0 && linear == DMat3::from_diagonal(scales)
}

/// A rectangle about its mesh's origin, in the mesh's grid.
fn rectangle(sides: [f64; 2], instance: &Instance, grid: &Grid) -> Shape {
    let steps = f64::exp2(f64::from(grid.exponent));
    let linear = instance.linear;
    let scales = [linear.x_axis.x, linear.y_axis.y, linear.z_axis.z];
    let half = |side: f64, scale: f64| ((side / 2.0 * scale.abs() * steps * 256.0).round()) as u32;
    let ([width, depth], [x, _, z]) = (sides, scales);
    Shape::Rectangle {
        centre: (-grid.centre * steps).round().as_ivec3().to_array(),
        half: [half(width, x), half(depth, z)],
        against: scales.map(|scale| scale < 0.0),
    }
}

/// The hierarchy of a mesh.
fn triangles(parts: &mut Parts, mesh: usize, nodes: &mut Vec<Node>) -> Result<Shape, BakeError> {
    let record = parts.meshes[mesh];
    let first = record.first_meshlet as usize;
    let count = record.meshlets as usize;
    crate::error::at_most("meshlets of a mesh that rays meet", count, 1 << 22)?;
    let mut items = Vec::new();
    for meshlet in 0..count {
        let own = parts.meshlets[first + meshlet];
        for triangle in 0..own.triangles {
            let indices = parts.triangles[own.first_triangle as usize + usize::from(triangle)];
            items.push(Item {
                meshlet: meshlet as u32,
                triangle,
                bounds: Box3::of(indices.map(|v| point(parts, mesh, first + meshlet, v))),
            });
        }
    }
    let built = hierarchy::build(items, count);
    if !hierarchy::fits(&built.nodes) {
        let problem = Problem::TooMany {
            what: "boxes that a ray leaves behind",
            found: hierarchy::stack(&built.nodes),
            most: fixel::scene::layout::RAY_STACK,
        };
        return Err(problem.into());
    }
    let before = (parts.triangles.clone(), parts.face_normals.clone());
    let sources = parts.sources.triangles.clone();
    let mut placed = vec![0; count];
    for item in &built.order {
        let own = &parts.meshlets[first + item.meshlet as usize];
        let base = own.first_triangle as usize;
        let (from, to) = (
            base + usize::from(item.triangle),
            base + placed[item.meshlet as usize],
        );
        placed[item.meshlet as usize] += 1;
        parts.triangles[to] = before.0[from];
        parts.sources.triangles[to] = sources[from];
        if let (Some(normal), true) = (before.1.get(from), record.face_normals) {
            parts.face_normals[to] = *normal;
        }
    }
    let first_node = nodes.len() as u32;
    nodes.extend(&built.nodes);
    Ok(Shape::Triangles {
        first_node,
        nodes: built.nodes.len() as u32,
    })
}
