//! One part of the picture is sent while the next is drawn: by a bus that works in the
//! background, and by futures.

use std::cell::RefCell;
use std::future::{Future, poll_fn};
use std::pin::{Pin, pin};
use std::rc::Rc;
use std::task::{Context, Poll, Waker};

use fixel::display::{Background, BufferedError, DoubleBuffered};
use fixel::palette::Rgb565Table;
use fixel::render::{Bands, palette};
use fixel::{Band, Display, Scene, Scratch};
use fixel_bake::Baked;
use fixel_tests::{load, root};

const FRAME: u32 = 3;

/// What a bus did, and the picture on its panel.
#[derive(Default)]
struct Log {
    sending: bool,
    transfers: usize,
    pixels: Vec<u16>,
}

/// Sends nothing before it is waited for; fails at one transfer, from 0.
struct Bus {
    log: Rc<RefCell<Log>>,
    width: usize,
    under_way: Option<(u16, Vec<u16>, usize)>,
    fails: Option<(usize, Step)>,
}

#[derive(Clone, Copy, PartialEq, Debug)]
enum Step {
    Start,
    Wait,
}

#[derive(Debug, PartialEq)]
struct BusError(Step);

impl Background for Bus {
    type Buffer = Vec<u16>;
    type Error = BusError;

    fn start(
        &mut self,
        top: u16,
        buffer: Vec<u16>,
        pixels: usize,
    ) -> Result<(), (BusError, Vec<u16>)> {
        let mut log = self.log.borrow_mut();
        assert!(!log.sending, "started while it is sending");
        log.transfers += 1;
        if self.fails == Some((log.transfers - 1, Step::Start)) {
            return Err((BusError(Step::Start), buffer));
        }
        log.sending = true;
        self.under_way = Some((top, buffer, pixels));
        Ok(())
    }

    fn wait(&mut self) -> Result<Vec<u16>, (BusError, Vec<u16>)> {
        let mut log = self.log.borrow_mut();
        let (top, buffer, pixels) = self.under_way.take().expect("something was started");
        log.sending = false;
        if self.fails == Some((log.transfers - 1, Step::Wait)) {
            return Err((BusError(Step::Wait), buffer));
        }
        let start = usize::from(top) * self.width;
        log.pixels[start..start + pixels].copy_from_slice(&buffer[..pixels]);
        Ok(buffer)
    }
}

fn teapot() -> Baked {
    load(&root().join("scenes/teapot.toml")).1
}

/// The picture as it should be.
fn wanted(scene: &Scene<'_>) -> Vec<u16> {
    let mut pixels = Vec::new();
    let mut table = Rgb565Table::new();
    table.set(&palette(scene, &scene.pose(FRAME)));
    drawn(scene, 240, |rows| {
        let start = pixels.len();
        pixels.resize(start + rows.indices.len(), 0);
        table.resolve(rows.indices, &mut pixels[start..]);
    });
    pixels
}

/// Hands on a frame in bands.
fn drawn(scene: &Scene<'_>, rows: u16, mut to: impl FnMut(fixel::frame::BandRows<'_>)) {
    let pixels = usize::from(scene.frame_width()) * usize::from(rows);
    let (mut indices, mut depths) = (vec![0; pixels], vec![0; pixels]);
    let mut band = Band::new(scene.frame_width(), &mut indices, &mut depths).expect("a band");
    let mut scratch = Box::new(Scratch::<64, 8, 4>::new());
    let (pose, mut work) = (scene.pose(FRAME), scratch.workspace());
    let mut bands = Bands::new(scene, &pose, &mut work, &mut band);
    while let Some(rows) = bands.next() {
        to(rows);
    }
    assert_eq!(
        bands.stats().bands,
        u32::from(scene.height().div_ceil(rows))
    );
}

/// A display with buffers of so many pixels, and what its bus does.
fn display(
    scene: &Scene<'_>,
    pixels: usize,
    fails: Option<(usize, Step)>,
) -> (DoubleBuffered<Bus>, Rc<RefCell<Log>>) {
    let size = usize::from(scene.width()) * usize::from(scene.height());
    let log = Rc::new(RefCell::new(Log {
        pixels: vec![0x1234; size],
        ..Log::default()
    }));
    let bus = Bus {
        log: Rc::clone(&log),
        width: scene.width().into(),
        under_way: None,
        fails,
    };
    (
        DoubleBuffered::new(bus, [vec![0; pixels], vec![0; pixels]]),
        log,
    )
}

/// A frame in 16-row bands.
fn show(
    scene: &Scene<'_>,
    display: &mut DoubleBuffered<Bus>,
    log: &Rc<RefCell<Log>>,
) -> Result<(), BufferedError<BusError>> {
    let mut result = display.begin(&palette(scene, &scene.pose(FRAME)));
    drawn(scene, 16, |rows| {
        if result.is_ok() {
            result = display.show(rows);
            // The next band is drawn meanwhile.
            assert!(result.is_err() || log.borrow().sending);
        }
    });
    result?;
    display.flush()
}

#[test]
fn a_band_is_sent_while_the_next_is_drawn() {
    let baked = teapot();
    let scene = baked.scene().expect("baked a moment ago");
    let width = usize::from(scene.width());
    for (pixels, transfers) in [
        (width * 16, 15),
        (width * 16 + 9, 15),
        (width * 5, 60),
        (width, 240),
    ] {
        let (mut display, log) = display(&scene, pixels, None);
        for _ in 0..2 {
            show(&scene, &mut display, &log).expect("a good bus");
            assert!(!log.borrow().sending);
        }
        assert!(log.borrow().pixels == wanted(&scene), "{pixels} pixels");
        assert_eq!(log.borrow().transfers, 2 * transfers);
        let (_, free) = display.release();
        assert!(free.iter().all(Option::is_some), "a buffer is lost");
    }
    let (mut display, log) = display(&scene, width - 1, None);
    assert_eq!(show(&scene, &mut display, &log), Err(BufferedError::Small));
}

#[test]
fn after_any_fault_the_next_frame_is_right() {
    let baked = teapot();
    let scene = baked.scene().expect("baked a moment ago");
    let width = usize::from(scene.width());
    let wanted = wanted(&scene);
    for transfer in 0..15 {
        for step in [Step::Start, Step::Wait] {
            let (mut display, log) = display(&scene, width * 16, Some((transfer, step)));
            let failed = show(&scene, &mut display, &log);
            assert_eq!(failed, Err(BufferedError::Bus(BusError(step))));
            // What was under way before the fault is still to be waited for.
            display.flush().expect("no second fault");
            show(&scene, &mut display, &log).expect("no second fault");
            assert!(log.borrow().pixels == wanted, "{transfer}, {step:?}");
        }
    }
}

/// Both at once, the first one first, as `join` of `embassy-futures` does it.
async fn join(first: impl Future<Output = ()>, second: impl Future<Output = ()>) {
    let (mut first, mut second) = (pin!(first), pin!(second));
    let mut done = [false; 2];
    let poll =
        |done: &mut bool, future: Pin<&mut dyn Future<Output = ()>>, context: &mut Context<'_>| {
            *done = *done || future.poll(context).is_ready();
        };
    poll_fn(|context| {
        let [first_done, second_done] = &mut done;
        poll(first_done, first.as_mut(), context);
        poll(second_done, second.as_mut(), context);
        if *first_done && *second_done {
            Poll::Ready(())
        } else {
            Poll::Pending
        }
    })
    .await;
}

fn block_on(future: impl Future<Output = ()>) {
    let mut future = pin!(future);
    while future
        .as_mut()
        .poll(&mut Context::from_waker(Waker::noop()))
        .is_pending()
    {}
}

/// A transfer that takes a few looks, as one by DMA does.
async fn send(
    pixels: &[u16],
    panel: &RefCell<Vec<u16>>,
    log: &RefCell<Vec<String>>,
    number: usize,
) {
    log.borrow_mut().push(format!("start {number}"));
    let mut looks = 0;
    poll_fn(|_| {
        looks += 1;
        if looks > 3 {
            Poll::Ready(())
        } else {
            Poll::Pending
        }
    })
    .await;
    panel.borrow_mut().extend(pixels);
    log.borrow_mut().push(format!("sent {number}"));
}

#[test]
fn futures_send_a_band_while_the_next_is_drawn() {
    let baked = teapot();
    let scene = baked.scene().expect("baked a moment ago");
    let width = usize::from(scene.width());
    let (panel, log) = (RefCell::new(Vec::new()), RefCell::new(Vec::new()));
    let (mut indices, mut depths) = (vec![0; width * 16], vec![0; width * 16]);
    let mut band = Band::new(scene.frame_width(), &mut indices, &mut depths).expect("a band");
    let mut scratch = Box::new(Scratch::<64, 8, 4>::new());
    let (pose, mut work) = (scene.pose(FRAME), scratch.workspace());
    let mut table = Rgb565Table::new();
    table.set(&palette(&scene, &pose));
    let mut bands = Bands::new(&scene, &pose, &mut work, &mut band);
    block_on(async {
        let (mut sent, mut next) = (vec![0; width * 16], vec![0; width * 16]);
        let (mut number, mut more) = (0, true);
        let mut draw = |number: usize, pixels: &mut [u16]| {
            let Some(rows) = bands.next() else {
                return false;
            };
            table.resolve(rows.indices, pixels);
            log.borrow_mut().push(format!("draw {number}"));
            true
        };
        draw(0, &mut sent);
        while more {
            let sending = send(&sent, &panel, &log, number);
            let drawing = async { more = draw(number + 1, &mut next) };
            join(sending, drawing).await;
            std::mem::swap(&mut sent, &mut next);
            number += 1;
        }
    });
    assert!(panel.into_inner() == wanted(&scene));
    let log = log.into_inner();
    assert_eq!(
        log[..5],
        ["draw 0", "start 0", "draw 1", "sent 0", "start 1"]
    );
    assert_eq!(log.len(), 45);
}
