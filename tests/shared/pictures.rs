//! What the pictures of several programs are held against.

use resvg::usvg;
use std::path::{Path, PathBuf};

/// Checks every picture among the files; returns the texts of the SVGs.
pub fn check_pictures(files: &[PathBuf]) -> String {
    let mut texts = String::new();
    for svg in files.iter().filter(|f| f.extension().is_some_and(|e| e == "svg")) {
        let text = std::fs::read_to_string(svg).unwrap();
        let tree = usvg::Tree::from_str(&text, &usvg::Options::default()).unwrap();
        let png = svg.with_extension("png");
        assert!(files.contains(&png), "{} is missing", png.display());
        let size = (tree.size().width() as u32, tree.size().height() as u32);
        assert_eq!(size.0, 800);
        assert_eq!(png_size(&png), (2 * size.0, 2 * size.1));
        assert!(!text.contains("NaN") && !text.contains("inf "), "{} holds no number somewhere", svg.display());
        texts += &text;
    }
    texts
}

/// Width and height from the header of a PNG.
fn png_size(path: &Path) -> (u32, u32) {
    let bytes = std::fs::read(path).unwrap();
    assert_eq!(&bytes[..8], b"\x89PNG\r\n\x1a\n");
    let number = |at: usize| u32::from_be_bytes(bytes[at..at + 4].try_into().unwrap());
    (number(16), number(20))
}
