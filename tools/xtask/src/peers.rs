//! The other renderers' figures, for the table beside ours. Measured on the
//! same emulated cores with the same workloads, at the best setting of each.

/// One workload.
#[derive(Debug)]
pub struct Peer {
    /// The bench scene.
    pub scene: &'static str,
    /// What it draws.
    pub what: &'static str,
    /// Pixels drawn, each as often as it is.
    pub drawn_px: u64,
    /// The best peer on a Cortex-M4F, millions of instructions a frame.
    pub cortex_m4f: &'static str,
    /// The best peer on thumbv6m code, millions of instructions a frame.
    pub cortex_m0plus: &'static str,
}

/// Every workload that peers were measured on.
pub const PEERS: [Peer; 9] = [
    Peer {
        scene: "w1_teapot_flat",
        what: "teapot, flat",
        drawn_px: 20_092,
        cortex_m4f: "1.11 tgx",
        cortex_m0plus: "2.22 small3dlib (one depth a triangle), 4.81 (a pixel)",
    },
    Peer {
        scene: "w2_teapot_gouraud",
        what: "teapot, Gouraud",
        drawn_px: 20_092,
        cortex_m4f: "1.45 tgx",
        cortex_m0plus: "5.11 small3dlib",
    },
    Peer {
        scene: "w3_bunny_gouraud",
        what: "bunny, Gouraud",
        drawn_px: 17_620,
        cortex_m4f: "2.62 tgx",
        cortex_m0plus: "10.8 small3dlib",
    },
    Peer {
        scene: "w4_cube_textured",
        what: "cube, 64x64 texture in perspective",
        drawn_px: 43_271,
        cortex_m4f: "1.84 tgx",
        cortex_m0plus: "21.1 small3dlib (exact), 5.88 (a divide every 32 px)",
    },
    Peer {
        scene: "w5_fill",
        what: "20 full-screen triangles, back to front",
        drawn_px: 768_000,
        cortex_m4f: "13.4 tgx, 9.02 small3dlib (one depth a triangle)",
        cortex_m0plus: "14.2 small3dlib (one depth a triangle), 46.6 (a pixel)",
    },
    Peer {
        scene: "w6_bunny_64x64",
        what: "bunny at 64x64",
        drawn_px: 1_254,
        cortex_m4f: "1.51 tgx",
        cortex_m0plus: "6.2 small3dlib",
    },
    Peer {
        scene: "r1_bunny_rays",
        what: "rays: bunny, Lambert",
        drawn_px: 17_620,
        cortex_m4f: "92 tinybvh (float)",
        cortex_m0plus: "2867 tinybvh (soft float)",
    },
    Peer {
        scene: "r2_bunny_shadow",
        what: "rays: bunny over a ground, shadows",
        drawn_px: 47_700,
        cortex_m4f: "195 tinybvh (float)",
        cortex_m0plus: "6082 tinybvh (soft float)",
    },
    Peer {
        scene: "r3_spheres_whitted",
        what: "rays: nine spheres over a plane, mirror, glass, shadows",
        drawn_px: 76_800,
        cortex_m4f: "71 tinybvh (float)",
        cortex_m0plus: "4041 tinybvh (soft float)",
    },
];

/// The peers' figures for a scene.
pub fn find(scene: &str) -> Option<&'static Peer> {
    PEERS.iter().find(|peer| peer.scene == scene)
}
