//! The sketch of the concepts is there as SVG and as PNG.
//!
//!     PEELKIT_WRITE=1 cargo test --test report sketch        draws the PNG again

use crate::shared_pictures::check_pictures;
use resvg::{tiny_skia, usvg};
use std::path::Path;

#[test]
fn the_sketch_is_drawn() {
    let root = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."));
    let [svg, png] = ["svg", "png"].map(|kind| root.join(format!("docs/reference/concepts.{kind}")));
    if std::env::var_os("PEELKIT_WRITE").is_some() {
        let mut options = usvg::Options::default();
        let font = std::fs::read(root.join("crates/report/font/DejaVuSans.ttf")).unwrap();
        options.fontdb_mut().load_font_data(font);
        let tree = usvg::Tree::from_str(&std::fs::read_to_string(&svg).unwrap(), &options).unwrap();
        let size = tree.size().to_int_size();
        let mut pixels = tiny_skia::Pixmap::new(2 * size.width(), 2 * size.height()).unwrap();
        resvg::render(&tree, tiny_skia::Transform::from_scale(2.0, 2.0), &mut pixels.as_mut());
        pixels.save_png(&png).unwrap();
    }
    let text = check_pictures(&[svg, png]);
    for word in ["initiation peak", "plateau", "snap-off", "snap-back", "detachment", "limit point"] {
        assert!(text.contains(word), "{word}");
    }
}
