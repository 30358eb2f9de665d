//! Bakes the examples' scenes.

fn main() {
    let scenes = [
        "attitude",
        "clock",
        "dashboard",
        "globe",
        "heat_map",
        "hello_triangle",
        "spinning_logo",
    ];
    for scene in scenes {
        fixel_bake::scene(format!("scenes/{scene}.toml"));
    }
    fixel_bake::SceneFile::new("scenes/epaper.toml")
        .rays(true)
        .build();
}
