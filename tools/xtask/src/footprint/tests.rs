use super::*;

const SMALL: Footprint = Footprint {
    code: 8000,
    static_ram: 20_000,
    stack: 1000,
    mesh: 30_000,
};

#[test]
fn limits_can_be_exceeded() {
    assert!(limits(&BOARDS[0], &CASES[0], SMALL).is_ok());
    let large = Footprint {
        static_ram: 31_768,
        ..SMALL
    };
    assert!(limits(&BOARDS[0], &CASES[0], large).is_err());
    assert!(limits(&BOARDS[0], &CASES[0], Footprint { mesh: 0, ..SMALL }).is_err());
}

#[test]
fn working_memory_in_flash_is_found() {
    let image = |initialised_bytes| elf::Image {
        initialised_bytes,
        ..elf::Image::default()
    };
    assert!(promises(&image(INITIALISED_LIMIT)).is_ok());
    assert!(promises(&image(28_000)).is_err());
}

#[test]
fn unwanted_code_is_found() {
    let with = |name: &str| elf::Image {
        symbols: vec![name.into()],
        ..elf::Image::default()
    };
    let phong = with("_ZN5fixel5light5model13SurfaceLights5parts17h00E");
    assert!(only(&phong, Parts::Gouraud).is_err());
    assert!(only(&phong, Parts::All).is_ok());
    let levels = with("_ZN5fixel6raster11perspective7gouraud17h00E");
    assert!(only(&levels, Parts::Flat).is_err());
    assert!(only(&levels, Parts::Gouraud).is_ok());
    assert!(only(&with("_ZN5fixel5scene11parse_light17h00E"), Parts::Flat).is_ok());
    assert!(unused_is_not_linked(&[(Parts::Flat, 5), (Parts::Gouraud, 5)]).is_err());
    assert!(unused_is_not_linked(&[(Parts::Flat, 5), (Parts::Gouraud, 6)]).is_ok());
}

#[test]
fn growth_with_the_mesh_is_found() {
    let grown = Footprint {
        static_ram: 20_004,
        ..SMALL
    };
    assert!(independent_of_mesh(&SMALL, &SMALL).is_ok());
    assert!(independent_of_mesh(&SMALL, &grown).is_err());
    let deeper = Footprint {
        stack: 1300,
        ..SMALL
    };
    assert!(independent_of_mesh(&SMALL, &deeper).is_err());
}

#[test]
fn stack_among_lines() {
    assert_eq!(stack_bytes("{\"stack\":660}\n").ok(), Some(660));
    assert!(stack_bytes("{\"error\":\"panic\"}\n").is_err());
}
