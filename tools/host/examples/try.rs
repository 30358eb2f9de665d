//! x
#![allow(missing_docs)]
fn main() {
    for path in std::env::args().skip(1) {
        let mut scene = fixel_scene::load(path.as_ref()).unwrap_or_else(|e| panic!("{e}"));
        if std::env::var("Q").is_ok() { for m in &mut scene.meshes { let ext = m.positions.iter().flatten().fold(0f64, |a, c| a.max(c.abs())); let s = 2f64.powi(13 - ext.log2().ceil() as i32); for p in &mut m.positions { *p = p.map(|c| (c * s).round() / s); } } }
        let baked = fixel_bake::bake(&scene).unwrap_or_else(|e| panic!("{e}"));
        let parsed = fixel::Scene::parse(baked.bytes()).unwrap_or_else(|e| panic!("{e}"));
        let options = fixel_host::Options::of(&parsed);
        let (frame, planes) = fixel_host::frame(&baked, &parsed, &options);
        let truth = fixel_reference::render(
            &scene,
            fixel_reference::Options {
                width: frame.width,
                height: frame.height,
                frame: 0,
            },
        );
        if std::env::var("D").is_ok() { dump(&truth, &frame); }
 let report = fixel_reference::compare(&truth, &frame);
        println!(
            "{path} {} bytes, {:?}\n{:?}",
            baked.bytes().len(),
            planes.stats,
            report
        );
    }
}
#[allow(dead_code)]
fn dump(truth: &fixel_reference::Truth, frame: &fixel_reference::Frame) {
    let mut by = std::collections::BTreeMap::new();
    for (i, p) in truth.pixels().iter().enumerate() {
        if let Some(h) = p { if frame.depth[i] != 0 && frame.triangle[i] == h.triangle as u32 {
            let e = f64::from(frame.depth[i]) - h.depth_lsb;
            let ent = by.entry((h.actor, h.triangle)).or_insert((0, 0f64, 0f64, 0f64));
            ent.0 += 1; ent.1 += e; ent.2 = ent.2.max(e.abs()); ent.3 = h.depth_lsb;
        } }
    }
    let mut v: Vec<_> = by.into_iter().collect();
    v.sort_by(|a, b| b.1.2.total_cmp(&a.1.2));
    for (k, e) in v.iter().take(40) { println!("{k:?} n {} mean {:.3} max {:.3} z {:.0}", e.0, e.1 / e.0 as f64, e.2, e.3); }
}
