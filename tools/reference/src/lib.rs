//! f64 reference renderer.
