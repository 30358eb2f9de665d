//! What `--help` of each command ends with.

pub const RENDER: &str = "\
Examples:
  fixel render scenes/teapot.toml
  fixel render bunny.stl -o bunny.png --size 240x240
  fixel render scene.toml --display ssd1306-128x64 --dithering blue_noise
  fixel render scene.toml --frame 12 --depth-out depth.png --stats -
  fixel render scene.toml --renderer ray -o rays.png";

pub const COMPARE: &str = "\
Examples:
  fixel compare scenes/teapot.toml
  fixel compare scene.toml --renderer ray --report report
  fixel compare scene.toml --json figures.json";

pub const BAKE: &str = "\
Examples:
  fixel bake scenes/teapot.toml -o teapot.fxl
  fixel bake bunny.stl -o bunny.fxl --colours 16
  fixel bake mirror.toml -o mirror.fxl --ray";

pub const INFO: &str = "\
Example:
  fixel info teapot.fxl";

pub const ANIMATE: &str = "\
Examples:
  fixel animate scenes/teapot.toml -o teapot.gif
  fixel animate bunny.stl -o bunny.gif --frames 100
  fixel animate scene.toml -o frames --frames 50
  fixel animate scene.toml -o turn.png --size 160x120 --fps 30";

pub const VIEW: &str = "\
Examples:
  fixel view scenes/teapot.toml
  fixel view bunny.stl --display ssd1306-128x64
  fixel view scenes/teapot.toml --renderer reference --zoom 3

In the window, ? or F1 shows the keys. Saving the scene, or a mesh or texture of it, shows it
anew.";

pub const ESTIMATE: &str = "\
Examples:
  fixel estimate scenes/teapot.toml --board rp2040-st7789
  fixel estimate bunny.stl --board microbit
  fixel estimate scene.toml --board stm32l4 --display st7735-160x128 --bands 8

The panel is the board's own, unless --display names another or the scene is for a display that
the board's panel can stand for. The longest lists and highest bands are taken that the board has
the RAM for; the figures say which.";

pub const COMPLETIONS: &str = "\
Examples:
  fixel completions bash > ~/.local/share/bash-completion/completions/fixel
  fixel completions zsh > ~/.zfunc/_fixel
  fixel completions fish > ~/.config/fish/completions/fixel.fish";
