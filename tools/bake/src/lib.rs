//! Baker: a scene description becomes a `.fxl` blob for flash.
