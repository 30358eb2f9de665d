use super::*;
use serde_json::json;

fn held(mismatch: usize, depth: f64, psnr: f64) -> Held {
    let report = json!({
        "width": 320, "height": 240, "covered_px": 20_000,
        "coverage_mismatch_px": mismatch, "depth_max_lsb": 1.0, "depth_mean_lsb": 0.25,
        "visible_mismatch_px": 0, "level_max": 1.0, "level_mean": 0.3,
        "rgb_psnr_db": 60.0, "rgb_psnr_true_db": psnr, "index_equal_percent": 90.0,
        "agreeing_px": 20_000, "coverage_mismatch_percent": 0.0,
        "depth_within_1_percent": depth, "level_within_2_percent": 100.0,
        "rgb_psnr_true_covered_db": psnr, "depth_max_at": null, "level_max_at": null,
        "mismatches": [],
    });
    Held {
        report: serde_json::from_value(report).expect("every field is there"),
        rgb888_psnr_db: psnr,
        one_material: true,
        without_palette: false,
        lod: false,
    }
}

#[test]
fn each_limit_of_rays_can_be_broken() {
    let good = Report {
        lit_px: 1000,
        rgb_psnr_db: 40.0,
        ..held(0, 99.9, 45.0).report
    };
    let holds = |change: fn(&mut Report)| {
        let mut report = good.clone();
        change(&mut report);
        ray_limits(&report).is_ok()
    };
    assert!(holds(
        |r| (r.visible_mismatch_px, r.coverage_mismatch_px) = (3, 4)
    ));
    assert!(!holds(|r| (
        r.visible_mismatch_px,
        r.coverage_mismatch_px
    ) = (4, 4)));
    assert!(!holds(|r| r.depth_within_1_percent = 99.8));
    assert!(holds(|r| r.shadow_mismatch_px = 1));
    assert!(!holds(|r| r.shadow_mismatch_px = 2));
    assert!(!holds(|r| r.shadow_mismatch_clusters = 1));
    assert!(!holds(|r| r.rgb_psnr_db = 39.9));
}

#[test]
fn each_limit_can_be_broken() {
    assert!(limits(&held(4, 99.9, 45.0)).is_ok());
    assert!(limits(&held(5, 99.9, 45.0)).is_err());
    assert!(limits(&held(4, 99.8, 45.0)).is_err());
    assert!(limits(&held(4, 99.9, 44.9)).is_err());
    let holds = |change: fn(&mut Report)| {
        let mut held = held(0, 99.9, 45.0);
        change(&mut held.report);
        limits(&held).is_ok()
    };
    assert!(holds(
        |r| (r.level_within_2_percent, r.rgb_psnr_db) = (99.0, 40.0)
    ));
    let direct = |db| {
        let held = Held {
            without_palette: true,
            one_material: false,
            ..held(0, 99.9, db)
        };
        limits(&held).is_ok()
    };
    assert!(direct(40.0) && !direct(39.9));
    assert!(!holds(|r| r.level_within_2_percent = 98.9));
    assert!(!holds(|r| r.rgb_psnr_db = 39.9));
    assert!(!holds(|r| r.rgb_psnr_true_db = 29.9));
    assert!(holds(|r| r.texel_mean = 0.25));
    assert!(!holds(|r| r.texel_mean = 0.26));
}

#[test]
fn each_limit_of_level_of_detail_can_be_broken() {
    let good = held(90, 10.0, 35.0).report;
    let holds = |change: fn(&mut Report)| {
        let mut report = good.clone();
        change(&mut report);
        lod_limits(&report).is_ok()
    };
    assert!(holds(|_| {}));
    assert!(!holds(|r| r.coverage_mismatch_percent = 0.6));
    assert!(!holds(|r| r.level_mean = 2.1));
    assert!(!holds(|r| r.rgb_psnr_db = 39.9));
}
