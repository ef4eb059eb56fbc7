//! A picture as SVG and PNG.

use super::font;
use super::picture::Picture;
use crate::writing::error::ReportError;
use crate::writing::file::write_whole;
use resvg::{tiny_skia, usvg};
use std::borrow::Borrow;
use std::panic::resume_unwind;
use std::path::{Path, PathBuf};
use std::thread;

/// Pixels of the PNG to a pixel of the SVG.
const PNG_SCALE: u32 = 2;

/// Writes `dir/stem.svg` and `dir/stem.png`.
///
/// Fails where the picture cannot be drawn ([`ReportError::Draw`]) or a file cannot be written ([`ReportError::Write`]).
pub fn save(picture: &Picture, dir: &Path, stem: &str) -> Result<Vec<PathBuf>, ReportError> {
    save_all(&[(picture, stem)], dir)
}

/// The same of several pictures: their SVGs, which take little time, and then their pixels, each picture's on a thread of its own.
///
/// Fails as [`save`].
pub(crate) fn save_all<P, S>(pictures: &[(P, S)], dir: &Path) -> Result<Vec<PathBuf>, ReportError>
where
    P: Borrow<Picture>,
    S: AsRef<str>,
{
    let path = |stem: &S, kind: &str| dir.join(format!("{}.{kind}", stem.as_ref()));
    let undrawn = |path: &Path, reason: String| ReportError::Draw { path: path.to_path_buf(), reason };
    let mut written = Vec::new();
    for (picture, stem) in pictures {
        let path = path(stem, "svg");
        let svg = picture.borrow().svg().map_err(|error| undrawn(&path, error.to_string()))?;
        write_whole(&path, svg.as_bytes())?;
        written.push((path, svg));
    }
    let pixels: Vec<Result<Vec<u8>, String>> = thread::scope(|scope| {
        let threads: Vec<_> = written.iter().map(|(_, svg)| scope.spawn(|| png(svg))).collect();
        let joined = |thread: thread::ScopedJoinHandle<_>| thread.join().unwrap_or_else(|panic| resume_unwind(panic));
        threads.into_iter().map(joined).collect()
    });
    let mut files = Vec::new();
    for (((svg, _), (_, stem)), pixels) in written.into_iter().zip(pictures).zip(pixels) {
        let path = path(stem, "png");
        write_whole(&path, &pixels.map_err(|reason| undrawn(&path, reason))?)?;
        files.extend([svg, path]);
    }
    Ok(files)
}

fn png(svg: &str) -> Result<Vec<u8>, String> {
    let options = usvg::Options { fontdb: font::database(), ..Default::default() };
    // polygons are filled and have no outline: the same to the eye, and no layer of their own, which took half of the time
    let svg = svg.replace("<polygon opacity=", "<polygon fill-opacity=");
    let tree = usvg::Tree::from_str(&svg, &options).map_err(|e| e.to_string())?;
    let size = tree.size().to_int_size();
    let (width, height) = (size.width() * PNG_SCALE, size.height() * PNG_SCALE);
    let mut pixels =
        tiny_skia::Pixmap::new(width, height).ok_or_else(|| format!("{width} x {height} pixels is no picture"))?;
    let scale = tiny_skia::Transform::from_scale(PNG_SCALE as f32, PNG_SCALE as f32);
    resvg::render(&tree, scale, &mut pixels.as_mut());
    packed(&pixels).map_err(|e| e.to_string())
}

/// The pixels, which are all opaque, as a PNG.
fn packed(pixels: &tiny_skia::Pixmap) -> Result<Vec<u8>, png::EncodingError> {
    let mut packed = Vec::new();
    let mut encoder = png::Encoder::new(&mut packed, pixels.width(), pixels.height());
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    // rows are most often as the one above: to try all filters on each took a quarter of the time of a run
    encoder.set_deflate_compression(png::DeflateCompression::Level(1));
    encoder.set_filter(png::Filter::Up);
    let mut colours = Vec::with_capacity(3 * pixels.pixels().len());
    pixels.pixels().iter().for_each(|at| colours.extend([at.red(), at.green(), at.blue()]));
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&colours)?;
    writer.finish()?;
    Ok(packed)
}
