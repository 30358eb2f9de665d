use super::*;

#[test]
fn a_tone_gives_the_light_of_its_grey() {
    for most in [1u8, 3, 15] {
        for grey in 0..=255u8 {
            let found = tone(grey, most);
            let level = f64::from(found >> 8);
            let light = |level: f64| (level / f64::from(most)).powi(2);
            let part = f64::from(found & 255) / 256.0;
            let next = light((level + 1.0).min(most.into()));
            let shown = light(level) + part * (next - light(level));
            let wanted = (f64::from(grey) / 255.0).powi(2);
            let half = (next - light(level)) / 512.0;
            assert!((shown - wanted).abs() <= half + 1e-9, "{grey} of {most}");
        }
        assert_eq!(tone(0, most), 0);
        assert_eq!(tone(255, most), u16::from(most) << 8);
    }
}
