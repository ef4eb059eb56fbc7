//! Colours and sizes of every picture.

use plotters::style::RGBColor;

/// Okabe and Ito's palette, which colour-blind readers tell apart.
pub mod colour {
    use plotters::style::RGBColor;
    /// Blue.
    pub const BLUE: RGBColor = RGBColor(0, 114, 178);
    /// Vermillion.
    pub const VERMILLION: RGBColor = RGBColor(213, 94, 0);
    /// Bluish green.
    pub const GREEN: RGBColor = RGBColor(0, 158, 115);
    /// Orange.
    pub const ORANGE: RGBColor = RGBColor(230, 159, 0);
    /// Nearly black: text and frames.
    pub const INK: RGBColor = RGBColor(30, 30, 30);
    /// Dark grey: what stands small below a picture.
    pub const CAPTION: RGBColor = RGBColor(80, 80, 80);
    /// Middle grey: what is secondary.
    pub const GREY: RGBColor = RGBColor(120, 120, 120);
    /// Light grey: bands and grids.
    pub const PALE: RGBColor = RGBColor(232, 232, 232);
}

/// The width of every picture, pixels: what a README shows.
pub const WIDTH: u32 = 800;

/// Text sizes, pixels.
pub(crate) mod size {
    pub(crate) const TITLE: f64 = 15.0;
    pub(crate) const LABEL: f64 = 14.0;
    pub(crate) const TEXT: f64 = 13.0;
    /// From one line of text to the next.
    pub(crate) const LEADING: f64 = 17.0;
}

/// Colours from dark to light, for `count` things in an order.
pub fn order_shade(index: usize, count: usize) -> RGBColor {
    // Five knots of viridis, its last fifth left out: too pale on white.
    const KNOTS: [(f64, f64, f64); 5] =
        [(68.0, 1.0, 84.0), (62.0, 73.0, 137.0), (38.0, 130.0, 142.0), (53.0, 170.0, 110.0), (140.0, 190.0, 50.0)];
    let part = index as f64 / count.saturating_sub(1).max(1) as f64;
    let along = part.min(1.0) * (KNOTS.len() - 1) as f64;
    let i = (along as usize).min(KNOTS.len() - 2);
    let (a, b, t) = (KNOTS[i], KNOTS[i + 1], along - i as f64);
    let mix = |p: f64, q: f64| (p + t * (q - p)).round() as u8;
    RGBColor(mix(a.0, b.0), mix(a.1, b.1), mix(a.2, b.2))
}

/// Colours for a number with a sign, from -1 to 1: blue below zero, white at zero, vermillion above, each darker towards its end. Readers
/// who are colour-blind tell the two apart.
pub fn signed_shade(value: f64) -> RGBColor {
    const BELOW: [(f64, f64, f64); 3] = [(255.0, 255.0, 255.0), (86.0, 170.0, 220.0), (0.0, 60.0, 120.0)];
    const ABOVE: [(f64, f64, f64); 3] = [(255.0, 255.0, 255.0), (240.0, 160.0, 90.0), (140.0, 45.0, 0.0)];
    let knots = if value < 0.0 { BELOW } else { ABOVE };
    let along = 2.0 * value.abs().min(1.0);
    let i = (along as usize).min(1);
    let (a, b, t) = (knots[i], knots[i + 1], along - i as f64);
    let mix = |p: f64, q: f64| (p + t * (q - p)).round() as u8;
    RGBColor(mix(a.0, b.0), mix(a.1, b.1), mix(a.2, b.2))
}
