//! `Renderer` draws what the functions draw that it is made of.

use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::{PrimitiveStyle, Rectangle};

use fixel::math::Angle;
use fixel::{DrawTargetDisplay, Renderer, render_frame};
use fixel_tests::{load, root};

type Picture = Vec<(Point, Rgb888)>;

/// Keeps what is drawn.
#[derive(Default)]
struct Panel(Picture);

impl OriginDimensions for Panel {
    fn size(&self) -> Size {
        Size::new(64, 48)
    }
}

impl DrawTarget for Panel {
    type Color = Rgb888;
    type Error = core::convert::Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<Rgb888>>>(
        &mut self,
        pixels: I,
    ) -> Result<(), Self::Error> {
        self.0.extend(pixels.into_iter().map(|p| (p.0, p.1)));
        Ok(())
    }
}

fn drawn(draw: impl FnOnce(&mut DrawTargetDisplay<Panel>)) -> Picture {
    let mut display = DrawTargetDisplay::new(Panel::default(), Point::new(1, 2));
    draw(&mut display);
    display.release().0
}

#[test]
fn a_renderer_draws_what_a_band_and_a_scratch_draw() {
    let (_, baked) = load(&root().join("scenes/teapot.toml"));
    let scene = baked.scene().expect("baked a moment ago");
    let mut pose = scene.pose(3);
    pose.height = 48;
    let mut renderer = Renderer::<64, 16>::new();
    let own = drawn(|panel| {
        let Ok(stats) = renderer.draw(&scene, &pose, panel);
        assert_eq!(stats.bands, 3);
    });
    let parts = drawn(|panel| {
        let (mut work, mut band) = renderer.parts();
        assert_eq!((band.width(), band.rows()), (64, 16));
        let Ok(_) = render_frame(&scene, &pose, &mut work, &mut band, panel);
    });
    assert!(own == parts);
    assert_eq!(own.len(), 64 * 48);

    let mark = Rectangle::new(Point::new(5, 14), Size::new(3, 4));
    let over = drawn(|panel| {
        let Ok(_) = renderer.draw_over(&scene, &pose, panel, |over| {
            let Ok(()) = mark
                .into_styled(PrimitiveStyle::with_fill(Rgb888::WHITE))
                .draw(over);
        });
    });
    let changed = own.iter().zip(&over).filter(|(a, b)| a != b);
    assert_eq!(changed.count(), 12, "a rectangle over two bands");
}

#[test]
fn an_actor_is_turned_and_stays_where_it_is() {
    let (_, baked) = load(&root().join("scenes/parents.toml"));
    let scene = baked.scene().expect("baked a moment ago");
    let mut pose = scene.pose(5);
    pose.turn = Angle::ZERO;
    for index in 0..scene.actor_count() {
        let actor = scene.actor(index);
        let own = pose.placement(&scene, index, &actor);
        let same = pose.turned(&scene, index, own.orientation);
        assert_eq!(same, (index, own));
        let orientation = [Angle::QUARTER, Angle::ZERO, Angle::QUARTER];
        let moved = [pose.turned(&scene, index, orientation)];
        let mut turned = pose;
        turned.moved = &moved;
        let placement = turned.placement(&scene, index, &actor);
        assert_eq!(placement.orientation, orientation);
        assert_eq!(placement.position, own.position);
    }
}
