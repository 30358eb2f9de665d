//! x
#![allow(missing_docs)]
fn main() {
    for path in std::env::args().skip(1) {
        let scene = fixel_scene::load(path.as_ref()).unwrap_or_else(|e| panic!("{e}"));
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
        let report = fixel_reference::compare(&truth, &frame);
        println!(
            "{path} {} bytes, {:?}\n{:?}",
            baked.bytes().len(),
            planes.stats,
            report
        );
    }
}
