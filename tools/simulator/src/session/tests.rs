use super::*;

const CUBE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 1\nf 1 2 3\nf 1 3 4\nf 1 4 2\nf 2 4 3\n";

fn with_file(path: &str, bytes: &[u8]) -> Session {
    let mut session = Session::default();
    let mut input = (path.len() as u32).to_le_bytes().to_vec();
    input.extend(path.as_bytes());
    input.extend(bytes);
    assert!(session.call(2, &input).done);
    session
}

fn json(answer: &Answer) -> Value {
    assert!(answer.done, "{}", answer.text);
    serde_json::from_str(&answer.text).unwrap()
}

fn open(session: &mut Session, path: &str, panel: &str) -> Answer {
    let request = json!({ "path": path, "panel": panel }).to_string();
    session.call(3, request.as_bytes())
}

fn frame(session: &mut Session, request: Value) -> Answer {
    session.call(4, request.to_string().as_bytes())
}

#[test]
fn a_mesh_is_baked_drawn_and_handed_over() {
    let mut session = with_file("a/cube.obj", CUBE.as_bytes());
    let facts = json(&open(&mut session, "a/cube.obj", "st7789-240x240"));
    assert_eq!(facts["triangles"], 4);
    let drawn = frame(&mut session, json!({ "number": 0 }));
    let stats = json(&drawn);
    assert_eq!(
        (&stats["width"], &stats["height"]),
        (&240.into(), &240.into())
    );
    assert_eq!(drawn.bytes.len(), 240 * 240 * 4);
    assert!(stats["covered_px"].as_u64() > Some(1000));
    // It turns, so that one sees how fast a board is.
    let later = frame(&mut session, json!({ "number": 5 }));
    assert_ne!(later.bytes, drawn.bytes);
    let blob = session.call(5, &[]);
    assert_eq!(facts["blob_bytes"], blob.bytes.len());

    // The same from what was baked, on another panel too.
    let mut again = with_file("cube.fxl", &blob.bytes);
    json(&open(&mut again, "cube.fxl", "st7789-240x240"));
    assert_eq!(frame(&mut again, json!({})).bytes, drawn.bytes);
    json(&open(&mut again, "cube.fxl", "ssd1306-128x64"));
    let mono = frame(&mut again, json!({}));
    assert_eq!(mono.bytes.len(), 128 * 64 * 4);
}

#[test]
fn a_hand_moves_the_view_and_it_goes_back() {
    let mut session = Session::default();
    json(&open(&mut session, "scenes/teapot.toml", "st7789-240x240"));
    let first = frame(&mut session, json!({})).bytes;
    for moves in [
        json!({ "azimuth": 20.0 }),
        json!({ "elevation": -160.0 }),
        json!({ "zoom": 1.5 }),
        json!({ "right": 0.1, "up": -0.1 }),
    ] {
        let turned = frame(&mut session, moves.clone());
        assert_ne!(turned.bytes, first, "{moves}");
        // Nothing is cut away.
        assert!(json(&turned)["covered_px"].as_u64() > Some(2000), "{moves}");
        assert_eq!(frame(&mut session, json!({})).bytes, turned.bytes);
    }
    // Zoom and view stay when the panel changes.
    json(&open(&mut session, "scenes/teapot.toml", "st7789-320x240"));
    assert_eq!(json(&frame(&mut session, json!({})))["moved"], true);
    assert!(frame(&mut session, json!({ "reset": true })).done);
    json(&open(&mut session, "scenes/teapot.toml", "st7789-240x240"));
    assert_eq!(frame(&mut session, json!({})).bytes, first);
}

#[test]
fn boards_are_estimated() {
    let mut session = Session::default();
    json(&open(&mut session, "scenes/teapot.toml", "st7789-240x240"));
    let mut estimate = |board: &str| {
        let asked = json!({ "board": board, "number": 3 }).to_string();
        session.call(7, asked.as_bytes())
    };
    let [pico, microbit] = ["rp2040-st7789", "microbit"].map(|board| json(&estimate(board)));
    let rate = |estimate: &Value| estimate["frames_a_second"].as_f64().unwrap();
    assert!(rate(&pico) > 2.0 * rate(&microbit), "{pico} {microbit}");
    assert!(rate(&pico) < 67.9, "more than the bus brings");
    assert!(pico["ram_bytes"].as_u64() > Some(20_000));
    assert!(!estimate("abacus").done);
}

#[test]
fn mistakes_say_where_they_are_and_change_nothing() {
    let mut session = with_file("wrong.obj", b"v 0 0 0\nv 1 0 zero\n");
    let answer = open(&mut session, "wrong.obj", "st7789-240x240");
    assert!(!answer.done);
    assert_eq!(
        answer.text,
        "wrong.obj:2: v: \"zero\" is not a number; expected e.g. v 0 0.5 1"
    );
    let answer = open(&mut session, "absent.obj", "st7789-240x240");
    assert!(
        answer
            .text
            .starts_with("absent.obj: is not among the files"),
        "{}",
        answer.text
    );
    assert!(!open(&mut session, "wrong.obj", "vfd").done);
    assert!(!frame(&mut session, json!({})).done);
    assert!(!session.call(99, &[]).done);
    for input in [&[][..], &[1, 0], &[9, 0, 0, 0, b'a']] {
        assert!(!session.call(2, input).done);
    }
}

#[test]
fn every_sample_opens_on_every_panel() {
    let catalogue = json(&Session::default().call(0, &[]));
    let list = |name: &str| catalogue[name].as_array().unwrap().clone();
    for sample in list("samples") {
        for panel in list("panels") {
            let mut session = Session::default();
            let path = match panel["mono"].as_bool() {
                Some(true) => sample["mono"].as_str().or(sample["path"].as_str()),
                _ => sample["path"].as_str(),
            };
            json(&open(
                &mut session,
                path.unwrap(),
                panel["name"].as_str().unwrap(),
            ));
        }
    }
}
