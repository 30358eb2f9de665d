//! Textures as the core draws them: sides that are powers of two, all smaller copies,
//! and instead of colours the numbers of a few base colours. What light makes of a
//! base colour is looked up in a shade table.

use fixel_scene::{Filter, Scene, Texturing, Wrap};

use crate::oklab::{Lab, distance2, from_rgb};
use crate::palette::{Sample, choose};
use crate::picture::{Picture, Texel};

/// A texel of which nothing is seen.
pub(crate) const NOTHING: u8 = 255;
/// Base colours of all textures of a scene, at most: any number below [`NOTHING`]
/// would do; a row of a shade table has as many bytes.
pub(crate) const BASES: usize = 64;
/// What the textures of a scene become.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Textures {
    /// The base colours, display-encoded, at most [`BASES`]; none without a texture.
    pub bases: Vec<[u8; 3]>,
    /// One for each different [`Texturing`] that the scene's materials have.
    pub textures: Vec<Texture>,
    /// For each material, the index of its texture.
    pub of_material: Vec<Option<usize>>,
}

/// A texture as one or more materials lay it on.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Texture {
    /// Texels across, a power of two.
    pub width: u32,
    /// Texels down, a power of two.
    pub height: u32,
    /// The texture and its smaller copies, down to 1 by 1 texel, or the texture alone
    /// if the material wants no copies: texels by rows from the top left, each the
    /// number of a base colour, or [`NOTHING`] if it fails the alpha test.
    pub copies: Vec<Vec<u8>>,
    /// As the description has it.
    pub filter: Filter,
    /// As the description has it.
    pub wrap: Wrap,
    /// As the description has it.
    pub perspective: bool,
}

/// All textures that materials lay on surfaces.
pub(crate) fn textures(scene: &Scene) -> Textures {
    let mut different: Vec<Texturing> = Vec::new();
    let of_material = scene.materials.iter().map(|material| {
        let texturing = material.texture?;
        let known = different.iter().position(|other| *other == texturing);
        Some(known.unwrap_or_else(|| {
            different.push(texturing);
            different.len() - 1
        }))
    });
    let of_material = of_material.collect();
    let pictures: Vec<Vec<Picture>> = different
        .iter()
        .map(|texturing| Picture::copies(scene, texturing))
        .collect();

    let seen = |(texturing, copies): (&Texturing, &Vec<Picture>)| {
        let least = texturing.alpha_test;
        // The copies' colours are those of the picture, but mixed.
        let texels = copies.iter().flat_map(|copy| copy.texels.clone());
        let sample = |texel: Texel| Sample {
            colour: texel.colour,
            weight: 1.0,
        };
        let passing = texels.filter(move |texel| texel.alpha >= least);
        passing.map(sample).collect::<Vec<_>>()
    };
    let samples: Vec<Sample> = different.iter().zip(&pictures).flat_map(seen).collect();
    let bases = if different.is_empty() {
        Vec::new()
    } else {
        choose(&samples, &[], BASES)
    };
    let quantised =
        |(texturing, copies): (&Texturing, &Vec<Picture>)| quantise(texturing, copies, &bases);
    Textures {
        textures: different.iter().zip(&pictures).map(quantised).collect(),
        bases,
        of_material,
    }
}

/// The numbers of the base colours that are nearest in Oklab.
fn quantise(texturing: &Texturing, copies: &[Picture], bases: &[[u8; 3]]) -> Texture {
    let lab: Vec<Lab> = bases
        .iter()
        .map(|base| from_rgb(base.map(|c| f64::from(c) / 255.0)))
        .collect();
    let base = |texel: &Texel| {
        if texel.alpha < texturing.alpha_test {
            return NOTHING;
        }
        let own = from_rgb(texel.colour);
        let distance = |i: &usize| distance2(lab[*i], own);
        let nearest = (0..lab.len()).min_by(|a, b| distance(a).total_cmp(&distance(b)));
        nearest.unwrap_or(0) as u8
    };
    let (width, height) = (copies[0].width as u32, copies[0].height as u32);
    let copies: Vec<Vec<u8>> = copies
        .iter()
        .map(|copy| copy.texels.iter().map(base).collect())
        .collect();
    Texture {
        width,
        height,
        copies,
        filter: texturing.filter,
        wrap: texturing.wrap,
        perspective: texturing.perspective,
    }
}

#[cfg(test)]
mod tests {
    use fixel_scene::Material;

    use super::*;
    use crate::picture::tests::picture;

    /// A scene with these textures, each worn by a material.
    fn scene(textures: Vec<fixel_scene::Texture>, how: impl Fn(usize) -> Texturing) -> Scene {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes/cube.toml");
        let mut scene = fixel_scene::load(path.as_ref()).unwrap();
        let material = |i| Material {
            texture: Some(how(i)),
            ..Material::default()
        };
        scene.materials.extend((0..textures.len()).map(material));
        scene.textures = textures;
        scene
    }

    #[test]
    fn few_colours_stay_and_holes_are_marked() {
        let (red, green) = ([255, 0, 0, 255], [0, 255, 0, 255]);
        let hole = [0, 0, 255, 10];
        let checks = picture(2, &[red, green, green, hole]);
        let how = |mipmaps| Texturing {
            alpha_test: 0.5,
            mipmaps,
            ..Texturing::new(0)
        };
        let one = textures(&scene(vec![checks.clone()], |_| how(false)));
        let texture = &one.textures[0];
        assert_eq!((texture.width, texture.height), (2, 2));
        assert_eq!(texture.copies.len(), 1);
        let colour = |texel: u8| one.bases[usize::from(texel)];
        let [a, b, c, d] = texture.copies[0][..] else {
            panic!("four texels");
        };
        assert_eq!(
            [a, b, c].map(colour),
            [[255, 0, 0], [0, 255, 0], [0, 255, 0]]
        );
        assert_eq!(d, NOTHING);
        assert_eq!(one.bases.len(), 2);
        let last = one.of_material.len() - 1;
        assert_eq!(one.of_material[last], Some(0));
        assert!(one.of_material[..last].iter().all(Option::is_none));

        let small = textures(&scene(vec![checks], |_| how(true)));
        let copies = &small.textures[0].copies;
        assert_eq!(copies.iter().map(Vec::len).collect::<Vec<_>>(), [4, 1]);
        // Three quarters pass the test.
        assert_ne!(copies[1], [NOTHING]);
    }

    #[test]
    fn bases_are_shared_and_stand_for_all_textures() {
        let ramp = |channel: usize| {
            let texel = |i: u8| {
                let mut texel = [0, 0, 0, 255];
                texel[channel] = i;
                texel
            };
            picture(16, &(0..=255).map(texel).collect::<Vec<_>>())
        };
        let same = |i: usize| Texturing::new(i / 2);
        let all = textures(&scene(vec![ramp(0), ramp(0), ramp(1), ramp(2)], same));
        assert_eq!(all.textures.len(), 2);
        let all = textures(&scene(vec![ramp(0), ramp(1), ramp(2)], Texturing::new));
        assert!((48..=BASES).contains(&all.bases.len()));
        for (channel, texture) in all.textures.iter().enumerate() {
            assert_eq!(texture.copies.len(), 5);
            for (value, texel) in texture.copies[0].iter().enumerate() {
                let base = all.bases[usize::from(*texel)];
                let mut own = [0.0; 3];
                own[channel] = value as f64 / 255.0;
                let off = distance2(from_rgb(own), from_rgb(base.map(|c| f64::from(c) / 255.0)));
                assert!(off.sqrt() < 0.05, "{own:?} {base:?} {off}");
            }
        }
        assert!(
            textures(&scene(Vec::new(), Texturing::new))
                .bases
                .is_empty()
        );
    }
}
