//! Each kind of mistake, and the exact words that a user reads.

use super::{read, refused};

macro_rules! messages {
    ($($name:ident: $text:expr => $message:expr;)*) => {$(
        #[test]
        fn $name() {
            assert_eq!(refused($text), $message);
            // Each says what was meant.
            assert!(["expected", "did you mean"].iter().any(|said| $message.contains(said)));
        }
    )*};
}

messages! {
    syntax: "[display]\nwidth = = 3"
        => "t.toml:2:9: not TOML: extra `=`, expected nothing";
    unknown_key: "[display]\n\nwidht = 3"
        => "t.toml:3: display.widht: is an unknown key; did you mean width?";
    american_colour: "[[material]]\ncolor = \"#ffffff\""
        => "t.toml:2: material.color: is an unknown key; did you mean colour?";
    unknown_table: "[cameras]"
        => "t.toml:1: cameras: is an unknown key; did you mean camera?";
    nothing_near: "[animation]\nxyzzyplugh = 1"
        => "t.toml:2: animation.xyzzyplugh: is an unknown key; expected one of turntable, frames, \
            key, palette_cycle";
    table_of_many: "[light]\nkind = \"ambient\""
        => "t.toml:1: light: is not a list of tables; expected [[light]]";
    table_of_one: "[[camera]]\nposition = [0, 0, 1]"
        => "t.toml:1: camera: is not a table; expected [camera] once";
    width_zero: "[display]\nwidth = 0"
        => "t.toml:2: display.width: 0 is out of range; expected a whole number in 1..=2048";
    width_text: "[display]\nwidth = \"wide\""
        => "t.toml:2: display.width: \"wide\" is not a whole number; expected a whole number in 1..=2048";
    colour_format: "[display]\ncolour = \"rgb\""
        => "t.toml:2: display.colour: \"rgb\" is unknown; expected \"rgb888\" or \"rgb565\" or \
            \"rgb444\" or \"gray8\" or \"gray4\" or \"gray2\" or \"mono\"";
    dithering_of_colours: "[display]\ndithering = \"bayer8\""
        => "t.toml:2: display.dithering: is for grey panels of few levels; expected it beside \
            colour = \"gray4\", \"gray2\" or \"mono\" (colours are dithered by \
            palette.dithering)";
    background: "[display]\nbackground = \"blue\""
        => "t.toml:2: display.background: \"blue\" is not a colour; \
            expected e.g. background = \"#ff8800\"";
    gradient: "[display]\nbackground = [\"#000000\"]"
        => "t.toml:2: display.background: has 1 colours where 2 belong; \
            expected e.g. background = [\"#204060\", \"#000000\"]";
    near_and_far: "[camera]\nposition = [0, 0, 5]\nclipping_range = [5, 5]"
        => "t.toml:3: camera.clipping_range: near 5 is not less than far 5; \
            expected [near, far], e.g. clipping_range = [0.1, 100]";
    near_zero: "[camera]\nposition = [0, 0, 5]\nclipping_range = [0, 5]"
        => "t.toml:3: camera.clipping_range: near 0 is not greater than 0; \
            expected [near, far], e.g. clipping_range = [0.1, 100]";
    same_points: "[camera]\nposition = [1, 2, 3]\nfocal_point = [1, 2, 3]"
        => "t.toml:3: camera.focal_point: position and focal_point are the same; \
            expected e.g. position = [0, 0, 5], focal_point = [0, 0, 0]";
    view_up_parallel: "[camera]\nposition = [0, 5, 0]\nview_up = [0, 2, 0]"
        => "t.toml:3: camera.view_up: view_up is parallel to the line of sight; \
            expected e.g. view_up = [0, 0, 1]";
    view_up_default_parallel: "[camera]\nposition = [0, 5, 0]"
        => "t.toml:2: camera.position: view_up is parallel to the line of sight; \
            expected e.g. view_up = [0, 0, 1]";
    view_up_zero: "[camera]\nview_up = [0, 0, 0]"
        => "t.toml:2: camera.view_up: has length 0; expected e.g. view_up = [0, 1, 0]";
    view_angle: "[camera]\nview_angle = 180"
        => "t.toml:2: camera.view_angle: 180 is out of range; expected a number in 0.01..=179";
    infinite: "[camera]\nposition = [0, inf, 5]"
        => "t.toml:2: camera.position: inf is out of range (-1e9..=1e9); \
            expected e.g. position = [0, 0, 5]";
    not_a_number: "[[material]]\nambient = nan"
        => "t.toml:2: material.ambient: NaN is out of range; expected a number in 0..=1";
    two_numbers: "[camera]\nposition = [0, 5]"
        => "t.toml:2: camera.position: has 2 numbers where 3 belong; \
            expected e.g. position = [0, 0, 5]";
    light_kind: "[[light]]\nkind = \"sun\""
        => "t.toml:2: light.kind: \"sun\" is unknown; \
            expected \"directional\" or \"ambient\" or \"point\" or \"spot\"";
    light_without_kind: "\n[[light]]\ndirection = [0, 0, -1]"
        => "t.toml:2: light.kind: is missing; \
            expected e.g. kind = \"directional\" or kind = \"ambient\"";
    one_edge: "[[light]]\nkind = \"point\"\nposition = [0, 1, 0]\nedges = [[1, 0, 0]]"
        => "t.toml:4: light.edges: has 1 edges where 2 belong; \
            expected e.g. edges = [[1, 0, 0], [0, 0, 1]]";
    edges_of_the_sun: "[[light]]\nkind = \"directional\"\nedges = [[1, 0, 0], [0, 0, 1]]"
        => "t.toml:3: light.edges: a directional light has none; expected no such key";
    refractive_index: "[[material]]\nrefractive_index = 0.5"
        => "t.toml:2: material.refractive_index: 0.5 is out of range; \
            expected a number in 1..=4";
    plane_of_three: "[[actor]]\nplane = [1, 2, 3]"
        => "t.toml:2: actor.plane: has 3 numbers where 2 belong; \
            expected e.g. plane = [4, 3]";
    plane_without_area: "[[actor]]\nplane = [1, 0]"
        => "t.toml:2: actor.plane: 0 is out of range (1e-6..=1e6); \
            expected e.g. plane = [4, 3]";
    lod_error: "[lod]\nerror = 0"
        => "t.toml:2: lod.error: 0 is out of range; expected a number in 0.01..=8";
    ray_depth: "[ray]\ndepth = 9"
        => "t.toml:2: ray.depth: 9 is out of range; expected a whole number in 1..=8";
    ray_samples: "[ray]\nsamples = 5"
        => "t.toml:2: ray.samples: 5 is out of range; expected 1, 4, 8 or 16";
    ray_shadows: "[ray]\nshadows = 1"
        => "t.toml:2: ray.shadows: 1 is neither true nor false; expected e.g. shadows = true";
    point_without_position: "[[light]]\nkind = \"point\""
        => "t.toml:1: light.position: is missing; \
            expected the light's place, e.g. position = [0, 4, 2]";
    point_with_a_direction: "[[light]]\nkind = \"point\"\nposition = [0, 1, 0]\ndirection = [0, -1, 0]"
        => "t.toml:4: light.direction: a point light has none; expected no such key";
    ambient_with_a_position: "[[light]]\nkind = \"ambient\"\nposition = [0, 1, 0]"
        => "t.toml:3: light.position: an ambient light has none; expected no such key";
    directional_with_attenuation: "[[light]]\nkind = \"directional\"\nattenuation = [1, 0, 0]"
        => "t.toml:3: light.attenuation: a directional light has none; expected no such key";
    negative_attenuation: "[[light]]\nkind = \"point\"\nposition = [0, 1, 0]\nattenuation = [1, -0.5, 0]"
        => "t.toml:4: light.attenuation: -0.5 is less than 0; \
            expected [constant, linear, quadratic] of 1 / (c + l d + q d^2), \
            e.g. attenuation = [1, 0, 0.1]";
    no_attenuation: "[[light]]\nkind = \"point\"\nposition = [0, 1, 0]\nattenuation = [0, 0, 0]"
        => "t.toml:4: light.attenuation: all three are 0, which is light without end; \
            expected [constant, linear, quadratic] of 1 / (c + l d + q d^2), \
            e.g. attenuation = [1, 0, 0.1]";
    two_attenuations: "[[light]]\nkind = \"point\"\nposition = [0, 1, 0]\nattenuation = [1, 0]"
        => "t.toml:4: light.attenuation: has 2 numbers where 3 belong; \
            expected e.g. attenuation = [1, 0, 0.1]";
    spot_without_direction: "[[light]]\nkind = \"spot\"\nposition = [0, 1, 0]"
        => "t.toml:1: light.direction: is missing; \
            expected the way the light travels, e.g. direction = [1, -1, -1]";
    cone_angle: "[[light]]\nkind = \"spot\"\nposition = [0, 1, 0]\ndirection = [0, -1, 0]\ncone_angle = 90"
        => "t.toml:5: light.cone_angle: 90 is out of range; expected a number in 1..=89";
    exponent: "[[light]]\nkind = \"spot\"\nposition = [0, 1, 0]\ndirection = [0, -1, 0]\nexponent = 129"
        => "t.toml:5: light.exponent: 129 is out of range; expected a number in 0..=128";
    light_without_direction: "[[light]]\nkind = \"directional\""
        => "t.toml:1: light.direction: is missing; \
            expected the way the light travels, e.g. direction = [1, -1, -1]";
    direction_zero: "[[light]]\nkind = \"directional\"\ndirection = [0, 0, 0]"
        => "t.toml:3: light.direction: has length 0; expected e.g. direction = [1, -1, -1]";
    light_colour: "[[light]]\nkind = \"ambient\"\ncolour = \"red\""
        => "t.toml:3: light.colour: \"red\" is not a colour; expected e.g. colour = \"#ff8800\"";
    shading: "[[material]]\nshading = \"smooth\""
        => "t.toml:2: material.shading: \"smooth\" is unknown; \
            expected \"flat\" or \"gouraud\" or \"phong\"";
    specular: "[[material]]\nspecular = 1.5"
        => "t.toml:2: material.specular: 1.5 is out of range; expected a number in 0..=1";
    specular_power: "[[material]]\nspecular_power = 0"
        => "t.toml:2: material.specular_power: 0 is out of range; expected a number in 1..=128";
    specular_colour: "[[material]]\nspecular_color = \"#ffffff\""
        => "t.toml:2: material.specular_color: is an unknown key; did you mean specular_colour?";
    opacity: "[[material]]\nopacity = 50"
        => "t.toml:2: material.opacity: 50 is out of range; expected a number in 0..=1";
    transparency: "[[material]]\nopacity = 0.5\ntransparency = \"alpha\""
        => "t.toml:3: material.transparency: \"alpha\" is unknown; \
            expected \"blend\" or \"screen_door\"";
    texture: "[[material]]\ntexture = \"wood.png\""
        => "t.toml:2: material.texture: \"wood.png\" does not exist; expected a file's name, \
            relative to the scene file, e.g. texture = \"textures/wood.png\"";
    texture_kind: "[[material]]\ntexture = \"meshes/cube.obj\""
        => "t.toml:2: material.texture: \"meshes/cube.obj\" is not a kind of picture; \
            expected a PNG or a JPEG file";
    texture_number: "[[material]]\ntexture = 3"
        => "t.toml:2: material.texture: is neither a file's name nor a table; \
            expected e.g. texture = \"textures/wood.png\" \
            or texture = { file = \"textures/wood.png\", filter = \"nearest\" }";
    texture_without_file: "[[material]]\ntexture = { wrap = \"repeat\" }"
        => "t.toml:2: material.texture.file: is missing; \
            expected e.g. file = \"textures/wood.png\"";
    texture_key: "[[material]]\n[material.texture]\nfile = \"a.png\"\nfilters = \"nearest\""
        => "t.toml:4: material.texture.filters: is an unknown key; did you mean filter?";
    same_names: "[[material]]\nname = \"a\"\n[[material]]\nname = \"a\""
        => "t.toml:4: material.name: \"a\" is the name of another; expected a name of its own";
    too_fine: "[display]\nwidth = 1100\nantialiasing = \"2x2\""
        => "t.toml:2: display.width: 1100 is too much with anti-aliasing or an anaglyph, which \
            draw 2 times as many pixels; expected at most 1024, e.g. width = 1024";
    antialiasing: "[display]\nantialiasing = \"4x4\""
        => "t.toml:2: display.antialiasing: \"4x4\" is unknown; expected \"none\" or \"2x2\" or \
            \"2x1\" or \"1x2\"";
    stereo: "[display]\nstereo = \"both\""
        => "t.toml:2: display.stereo: \"both\" is unknown; expected \"none\" or \"anaglyph\" or \
            \"side_by_side\"";
    one_eye: "[display]\neye_angle = 2"
        => "t.toml:2: display.eye_angle: means nothing for one eye; \
            expected e.g. stereo = \"anaglyph\" beside it";
    fog_density: "[fog]\ncolour = \"#808080\"\ndensity = 0.1"
        => "t.toml:3: fog.density: means nothing here; \
            expected e.g. start = 10, end = 100, or mode = \"exponential\"";
    fog_end: "[fog]\ncolour = \"#808080\"\nstart = 5\nend = 4"
        => "t.toml:4: fog.end: 4 is not beyond start 5; expected e.g. start = 10, end = 100";
    fog_without_colour: "[fog]\nend = 4"
        => "t.toml:1: fog.colour: is missing; expected e.g. colour = \"#c0c8d0\"";
    fog_mode: "[fog]\nmode = \"thick\""
        => "t.toml:2: fog.mode: \"thick\" is unknown; expected \"linear\" or \"exponential\" or \
            \"exponential_squared\"";
    fog_missing_density: "[fog]\nmode = \"exponential\"\ncolour = \"#808080\""
        => "t.toml:1: fog.density: is missing; expected e.g. density = 0.02";
    viewport_key: "[[viewport]]\nx = 0"
        => "t.toml:2: viewport.x: is an unknown key; expected one of rectangle, camera, \
            background, aspect";
    viewport_beyond: "[[viewport]]\nrectangle = [0.5, 0, 0.6, 1]"
        => "t.toml:2: viewport.rectangle: [0.5, 0.0, 0.6, 1.0] reaches beyond the picture; \
            expected [x, y, width, height] in 0..=1 from the picture's lower left corner, \
            e.g. rectangle = [0.7, 0.7, 0.3, 0.3]";
    viewport_empty: "[[viewport]]\nrectangle = [0, 0, 0, 1]"
        => "t.toml:2: viewport.rectangle: 0 x 1 has no area; \
            expected [x, y, width, height] in 0..=1 from the picture's lower left corner, \
            e.g. rectangle = [0.7, 0.7, 0.3, 0.3]";
    viewport_aspect: "[[viewport]]\naspect = \"fit\""
        => "t.toml:2: viewport.aspect: \"fit\" is unknown; expected \"keep\" or \"stretch\"";
    viewport_camera: "[[viewport]]\ncamera = 3"
        => "t.toml:2: viewport.camera: is not a table; \
            expected [viewport.camera] below its [[viewport]]";
    viewport_camera_key: "[[viewport]]\n[viewport.camera]\nview_angel = 3"
        => "t.toml:3: viewport.camera.view_angel: is an unknown key; did you mean view_angle?";
    turntable: "[animation]\nturntable = 0"
        => "t.toml:2: animation.turntable: 0 is out of range; \
            expected a whole number in 1..=100000";
    colours: "[palette]\ncolours = 257"
        => "t.toml:2: palette.colours: 257 is out of range; expected a whole number in 2..=256";
    palette_kind: "[palette]\nfile = \"warm.act\""
        => "t.toml:2: palette.file: \"warm.act\" is not a kind of palette file; \
            expected one of .gpl, .hex, .png";
    palette_missing: "[palette]\nfile = \"warm.gpl\""
        => "t.toml:2: palette.file: \"warm.gpl\" does not exist; \
            expected a file's name, relative to the scene file, e.g. file = \"palettes/warm.gpl\"";
    palette_file_and_colours: "[palette]\nfile = \"warm.gpl\"\ncolours = 16"
        => "t.toml:3: palette.colours: does not go with file, which has all entries; \
            expected one of the two";
    ramps: "[palette]\nramps = 16"
        => "t.toml:2: palette.ramps: is not a list; \
            expected e.g. ramps = [{ from = \"#000000\", to = \"#ff8800\", steps = 16 }]";
    ramp_without_end: "[palette]\nramps = [\n{ from = \"#000000\", steps = 4 }]"
        => "t.toml:3: palette.ramps.to: is missing; \
            expected e.g. { from = \"#000000\", to = \"#ff8800\", steps = 16 }";
    too_many_steps: "[palette]\ncolours = 8\nramps = [\n\
            { from = \"#000000\", to = \"#ff0000\", steps = 5 },\n\
            { from = \"#000000\", to = \"#00ff00\", steps = 4 }]"
        => "t.toml:3: palette.ramps: have 9 steps together; \
            expected at most 8, as colours says";
    dithering: "[palette]\ndithering = \"floyd\""
        => "t.toml:2: palette.dithering: \"floyd\" is unknown; \
            expected \"none\" or \"bayer4\" or \"bayer8\"";
    no_material: "[[material]]\nname = \"a\"\n[[actor]]\nmesh = \"meshes/cube.obj\"\nmaterial = \"b\""
        => "t.toml:5: actor.material: no [[material]] is named \"b\"; expected \"a\"";
    no_mesh_key: "[[actor]]\nname = \"a\""
        => "t.toml:1: actor.mesh: is missing; expected e.g. mesh = \"meshes/teapot.obj\"";
    no_mesh_file: "[[actor]]\nmesh = \"meshes/none.obj\""
        => "t.toml:2: actor.mesh: \"meshes/none.obj\" does not exist; \
            expected a file's name, relative to the scene file, e.g. mesh = \"meshes/teapot.obj\"";
    no_mesh_kind: "[[actor]]\nmesh = \"meshes/cube.dae\""
        => "t.toml:2: actor.mesh: \"meshes/cube.dae\" is not a kind of mesh file; \
            expected one of .obj, .glb, .gltf, .stl, .ply";
    scale_zero: "[[actor]]\nmesh = \"meshes/cube.obj\"\nscale = [1, 0, 1]"
        => "t.toml:3: actor.scale: 0 is out of range (1e-6..=1e6 either side of 0); \
            expected e.g. scale = 2 or scale = [1, 2, 1]";
    two_meshes: "[[actor]]\nmesh = \"meshes/cube.obj\"\nsphere = 1"
        => "t.toml:3: actor.sphere: is one mesh too many; \
            expected one of mesh, sphere, plane and polygon";
    detail_of_nothing: "[[actor]]\nmesh = \"meshes/cube.obj\"\ndetail = 1"
        => "t.toml:3: actor.detail: says nothing here; expected it with sphere or plane";
    hole_of_two: "[[actor]]\npolygon = [[0, 0, 0], [9, 0, 0], [0, 9, 0]]\n\
                  holes = [[[1, 1, 0], [2, 1, 0]]]"
        => "t.toml:3: actor.holes: has fewer than 3 corners; \
            expected e.g. polygon = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]";
    flat_polygon: "[[actor]]\npolygon = [[0, 0, 0], [1, 0, 0], [2, 0, 0]]"
        => "t.toml:2: actor.polygon: has no area; \
            expected e.g. polygon = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]";
    line_width_of_a_surface: "[[actor]]\nmesh = \"meshes/cube.obj\"\nline_width = 2"
        => "t.toml:3: actor.line_width: says nothing here; expected it with \
            representation = \"wireframe\" or representation = \"hidden_line\"";
    line_of_one_point: "[[line]]\npoints = [[0, 0, 0]]"
        => "t.toml:2: line.points: has 1 points where at least 2 belong; \
            expected e.g. points = [[0, 0, 0], [1, 0, 0]]";
    line_without_points: "[[line]]\nspace = \"screen\""
        => "t.toml:1: line.points: is missing; \
            expected e.g. points = [[10.5, 20.5], [30.5, 20.5]]";
    point_in_space_on_the_screen: "[[marker]]\nspace = \"screen\"\npoints = [[1, 2, 3]]"
        => "t.toml:3: marker.points: point 0 has 3 numbers where 2 belong; \
            expected e.g. points = [[10.5, 20.5], [30.5, 20.5]]";
    depth_on_the_screen: "[[marker]]\nspace = \"screen\"\npoints = [[1, 2]]\ndepth_test = true"
        => "t.toml:4: marker.depth_test: says nothing on the screen, which has no depth; \
            expected no such key";
    closed_by_a_word: "[[line]]\npoints = [[0, 0, 0], [1, 0, 0]]\nclosed = \"yes\""
        => "t.toml:3: line.closed: \"yes\" is neither true nor false; expected e.g. closed = true";
    strange_letter: "[[text]]\nposition = [0, 0, 0]\ntext = \"\u{3bb}\""
        => "t.toml:3: text.text: '\u{3bb}' is in none of the fonts; \
            expected letters of ISO 8859-1, e.g. text = \"Hello\"";
    text_nowhere: "[[text]]\ntext = \"a\""
        => "t.toml:1: text.position: is missing; expected e.g. position = [0, 1.5, 0]";
    font: "[[text]]\ntext = \"a\"\nposition = [0, 0, 0]\nfont = \"8x8\""
        => "t.toml:4: text.font: \"8x8\" is unknown; expected \"6x10\" or \"4x6\" or \"5x8\" or \
            \"7x13\" or \"9x15\" or \"10x20\"";
    shear_of_two: "[[actor]]\nmesh = \"meshes/cube.obj\"\nshear = [0, 1]"
        => "t.toml:3: actor.shear: has 2 numbers where 3 belong; \
            expected e.g. shear = [0.5, 0, 0] (y to x, z to x, z to y)";
    shear_flattens: "[[actor]]\nmesh = \"meshes/cube.obj\"\nshear = [1, 0, 1, 0, 0, 0]"
        => "t.toml:3: actor.shear: flattens the actor, its determinant is 0; \
            expected e.g. shear = [0.5, 0, 0, 0, 0, 0] (y, z to x; x, z to y; x, y to z)";
    matrix_flattens: "[[actor]]\nmesh = \"meshes/cube.obj\"\n\
        matrix = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1]"
        => "t.toml:3: actor.matrix: flattens the actor, its determinant is 0; \
            expected e.g. matrix = [1, 0, 0, 5, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]";
    matrix_with_a_perspective: "[[actor]]\nmesh = \"meshes/cube.obj\"\n\
        matrix = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0]"
        => "t.toml:3: actor.matrix: the last four numbers are not 0, 0, 0, 1 (a perspective \
            belongs to the camera); \
            expected e.g. matrix = [1, 0, 0, 5, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]";
    parent_unknown: "[[actor]]\nmesh = \"meshes/cube.obj\"\nparent = \"arm\""
        => "t.toml:3: actor.parent: no [[actor]] is named \"arm\"; \
            expected \"actor 0\" or \"actor 1\"";
    parents_in_a_ring: "[[actor]]\nmesh = \"meshes/cube.obj\"\nname = \"a\"\nparent = \"b\"\n\
        [[actor]]\nmesh = \"meshes/cube.obj\"\nname = \"b\"\nparent = \"a\""
        => "t.toml:8: actor.parent: goes round in a ring (\"b\" of \"a\" of \"b\"); \
            expected a chain that ends";
    parallel_scale_in_perspective: "[camera]\nparallel_scale = 2"
        => "t.toml:2: camera.parallel_scale: is for a parallel camera; \
            expected view_angle, or projection = \"parallel\" too";
    zoomed_too_far: "[camera]\nview_angle = 100\nzoom = 0.5"
        => "t.toml:3: camera.zoom: makes the view angle 200 degrees; \
            expected it to stay in 0.01..=179.0";
    dolly_zero: "[camera]\ndolly = 0"
        => "t.toml:2: camera.dolly: 0 is out of range; expected a number in 0.001..=100";
    pan_of_three: "[camera]\npan = [0, 0, 1]"
        => "t.toml:2: camera.pan: has 3 numbers where 2 belong; expected e.g. pan = [1, 0.5]";
    elevation_to_a_pole: "[camera]\nposition = [0, 0, 5]\nelevation = 90"
        => "t.toml:2: camera.position: view_up is parallel to the line of sight; \
            expected e.g. view_up = [0, 0, 1]";
    cycle_of_one: "[animation]\npalette_cycle = { first = 4, last = 4, frames = 9 }"
        => "t.toml:2: animation.palette_cycle.last: 4 is out of range; \
            expected a whole number in 5..=255";
    cycle_without_frames: "[animation]\npalette_cycle = { first = 4, last = 9 }"
        => "t.toml:2: animation.palette_cycle.frames: is missing; \
            expected e.g. palette_cycle = { first = 0, last = 15, frames = 32 }";
    key_of_nobody: "[[animation.key]]\nframe = 1\nroll = 5"
        => "t.toml:1: animation.key.actor: is missing; \
            expected the name of an [[actor]], or actor = \"camera\"";
    key_of_a_viewport_without_a_camera: "[[viewport]]\n[[animation.key]]\nactor = \"camera\"\n\
        viewport = 0\nframe = 1\nroll = 5"
        => "t.toml:4: animation.key.viewport: viewport 0 has no camera of its own; \
            expected [viewport.camera] below it";
    key_of_a_viewport_too_many: "[[animation.key]]\nactor = \"camera\"\nviewport = 2\n\
        frame = 1\nroll = 5"
        => "t.toml:3: animation.key.viewport: viewport 2 is not there, the file has 0; \
            expected e.g. viewport = 0 for the first [[viewport]]";
    key_of_an_unknown_actor: "[[animation.key]]\nactor = \"arm\"\nframe = 1\nscale = 5"
        => "t.toml:2: animation.key.actor: no [[actor]] is named \"arm\"; \
            expected \"actor 0\"";
    key_without_a_frame: "[[animation.key]]\nactor = \"camera\"\nroll = 5"
        => "t.toml:1: animation.key.frame: is missing; expected e.g. frame = 12";
    key_that_moves_nothing: "[[animation.key]]\nactor = \"camera\"\nframe = 5"
        => "t.toml:3: animation.key.frame: a key that moves nothing; expected e.g. position";
    key_past_the_end: "[animation]\nframes = 10\n[[animation.key]]\nactor = \"camera\"\n\
        frame = 11\nroll = 5"
        => "t.toml:5: animation.key.frame: 11 is out of range; \
            expected a whole number in 0..=10";
    key_of_the_wrong_kind: "[[animation.key]]\nactor = \"camera\"\nframe = 1\nscale = 5"
        => "t.toml:4: animation.key.scale: the camera has none; expected no such key";
    key_twice: "[[animation.key]]\nactor = \"camera\"\nframe = 1\nroll = 5\n\
        [[animation.key]]\nactor = \"camera\"\nframe = 1\nroll = 6"
        => "t.toml:8: animation.key.roll: \"camera\" has it in frame 1 already; \
            expected it once";
}

#[test]
fn no_actor() {
    let message = "t.toml: actor: is missing; expected at least one [[actor]] with a mesh, or a \
                   [[material]] for what is drawn by call";
    assert_eq!(read("").unwrap_err(), message);
    assert!(read("[[material]]\nname = \"a\"").is_ok());
}
