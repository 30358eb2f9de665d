//! Arithmetic, colours and poses, with whatever numbers their arguments' types hold.

use fixel::math::{
    Angle, Divider, Factor, Model, Rect, Rotation, Scaled, Transform, Vec3, World, WorldSpace,
    bayer4, bayer8, blue_noise, cross, direction, dot, mul_high, mul_q30, normalise, power,
    product, reciprocal, reciprocal_root, root, scaled_reciprocal, short_dot, square, unit,
    unit_vector,
};
use fixel::palette::{
    Cycle, Palette, Rgb444Table, Rgb565Table, Tones, bgr555, cmy, cmyk, cmyk_of, cross_fade, fade,
    hsv, hsv_of, light_of_rgb565, luma, mixed, pack_rgb888, rgb565, rgb565_of_light, rgb565_of_sum,
    tone,
};

use super::numbers::Numbers;

/// One of them after the other for as long as there are bytes.
pub fn arithmetic(bytes: &[u8]) {
    let all = [
        whole, units, scaled, angles, rotation, transform, colours, palette,
    ];
    let mut n = Numbers(bytes);
    while !n.0.is_empty() {
        all[n.below(all.len())](&mut n);
    }
}

fn three(n: &mut Numbers<'_>) -> [i32; 3] {
    [0; 3].map(|_| n.extreme())
}

fn whole(n: &mut Numbers<'_>) {
    let (a, b, wide) = (n.extreme(), n.extreme(), n.wide());
    let _ = (mul_high(a, b), mul_q30(a, b), product(a, b), square(a));
    let _ = (reciprocal(a as u32), reciprocal_root(a as u32));
    let _ = (root(wide as u64), power(a as u32, b as u16));
    let _ = (bayer4([a, b]), bayer8([a, b]), blue_noise([a, b]));
    let divider = Divider::new(a);
    assert!(divider.divisor() > 0);
    let _ = (divider.floor(b), divider.ceil(b));
    let _ = (divider.floor_wide(wide), divider.ceil_wide(wide));
    let rect = Rect {
        left: a as u16,
        top: b as u16,
        right: n.extreme() as u16,
        bottom: n.extreme() as u16,
    };
    let _ = (rect.width(), rect.height());
}

fn units(n: &mut Numbers<'_>) {
    let (a, b) = (three(n), three(n));
    let _ = (unit(a), unit_vector(a), direction(a));
    let _ = (cross(a, b), dot(a, b), short_dot(a, b));
    let _ = normalise([0; 3].map(|_| n.wide()));
}

fn scaled(n: &mut Numbers<'_>) {
    let mut number = || Scaled::new(n.extreme() as u32, n.extreme());
    let (a, b) = (number(), number());
    let _ = (a.times(b), a.plus(b), scaled_reciprocal(a));
    let _ = (a.shifted(n.extreme()), a.fixed(n.extreme() as u32));
}

fn angles(n: &mut Numbers<'_>) {
    let (a, b) = (n.extreme() as u32, n.extreme() as u32);
    let turn = Angle::from_bits(a);
    let _ = (turn.sin_cos(), turn.tangent(), Angle::of_tangent(b));
    let _ = (
        Angle::fraction(a, b),
        turn.plus(Angle::from_turns16(b as u16)),
    );
}

fn rotation(n: &mut Numbers<'_>) {
    let angle = |n: &mut Numbers<'_>| Angle::from_bits(n.extreme() as u32);
    let any = Rotation {
        rows: [0; 3].map(|_| three(n)),
    };
    let about = Rotation::about(three(n), angle(n));
    let orientation = Rotation::from_orientation([0; 3].map(|_| angle(n)));
    let both = any.then(&about).then(&orientation);
    let _ = both.transposed().apply(three(n));
    let _ = any.apply_wide([0; 3].map(|_| n.wide()));
}

fn transform(n: &mut Numbers<'_>) {
    type InModel = Transform<Model, Model>;
    let place = |n: &mut Numbers<'_>| Vec3::from_bits(three(n));
    let angle = Angle::from_bits(n.extreme() as u32);
    let rows = [0; 3].map(|_| three(n));
    let [x, y, z] = three(n).map(World::from_bits);
    let all = [
        InModel::translation(place(n)),
        InModel::rotation(&Rotation { rows }),
        InModel::rotation_about_x_through(place(n), angle),
        InModel::scale(x, y, z),
    ];
    let mut sum = InModel::identity();
    for _ in 0..1 + n.below(5) {
        sum = sum.then(&all[n.below(4)]);
    }
    let _ = sum.apply(place(n));
    let view = Transform::look_at(place(n), place(n), place(n));
    let _ = view.map(|view| {
        let to_world = Transform::<Model, WorldSpace>::translation(place(n));
        to_world.then(&view).apply(place(n))
    });
}

fn colour(n: &mut Numbers<'_>) -> [u8; 3] {
    [0; 3].map(|_| n.byte())
}

fn colours(n: &mut Numbers<'_>) {
    let (a, b, part) = (colour(n), colour(n), n.extreme() as u16);
    let _ = (cmy(a), cmyk_of(a), cmyk([part as u8, a[0], a[1], a[2]]));
    let _ = (hsv_of(a), hsv(part, b[0], b[1]), mixed(a, b, part));
    let _ = (rgb565(a), bgr555(a), light_of_rgb565(part), luma(a));
    let _ = (
        rgb565_of_light(three(n).map(|c| c as u16)),
        tone(a[0], a[1]),
    );
    let _ = rgb565_of_sum(n.extreme() as u32);
}

fn palette(n: &mut Numbers<'_>) {
    let colours: Vec<[u8; 3]> = (0..n.below(256)).map(|_| colour(n)).collect();
    let (to, part) = (colour(n), n.extreme() as u16);
    let mut faded = vec![[0; 3]; n.below(256)];
    fade(&colours, to, part, &mut faded);
    cross_fade(&colours, &[to, to], part, &mut faded);
    let cycle = Cycle {
        first: n.extreme() as u16,
        count: n.extreme() as u16,
        shift: n.extreme() as u16,
    };
    let palette = Palette {
        cycle,
        ..Palette::new(&colours)
    };
    let index = n.byte();
    let _ = (palette.rgb888(index), palette.nearest(to));
    let mut tones = Tones::new(n.byte());
    tones.set(&palette);
    let _ = (tones.of(index), tones.most());
    let (mut of_12, mut of_16) = (Rgb444Table::new(), Rgb565Table::new());
    of_12.set(&palette);
    of_16.set(&palette);
    let indices: Vec<u8> = (0..n.below(40)).map(|_| n.byte()).collect();
    let from = n.below(8).min(indices.len());
    let mut bytes = vec![0; n.below(64)];
    let mut pixels = vec![0; n.below(64)];
    let _ = of_12.pack(&indices[from..], &mut bytes);
    let _ = pack_rgb888(&palette, &indices, &mut bytes);
    of_16.resolve(&indices[from..], &mut pixels);
    let _ = Factor::from_bits(n.word());
}
