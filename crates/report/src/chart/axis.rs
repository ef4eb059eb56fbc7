//! An axis: its range, where a value lies on it, its ticks and how they are printed.

use peelkit::units::{FORCES, FORCES_PER_WIDTH, LENGTHS, PreferredUnits, Unit, WORKS, WORKS_PER_WIDTH};

/// A labelled axis, linear or logarithmic.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// What it measures, with the unit. The unit alone, "(nm)", is not written: of an axis below which another panel has the same with its words.
    pub label: String,
    /// Where it begins.
    pub from: f64,
    /// Where it ends.
    pub to: f64,
    /// Whether it is logarithmic.
    pub log: bool,
    /// Names of the values 0, 1, 2, … in place of numbers; none of an axis of numbers.
    pub names: Vec<String>,
    /// A number beyond its ends for which its prefix is chosen as well, so that panels side by side have one unit; 0: none.
    pub beside: f64,
    /// The units that the user wants, whatever the prefix that fits.
    pub units: PreferredUnits,
    /// What its ends were made for.
    pub ends: Ends,
}

/// What the ends of an axis were made for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ends {
    /// Those that were given, as of a body that is drawn to scale
    Fixed,
    /// To hold some values: the axis may go on for a legend
    Around,
}

/// A tick; the small ones between carry no text.
#[derive(Clone, Debug, PartialEq)]
pub struct Tick {
    pub value: f64,
    pub text: Option<String>,
}

/// A logarithmic axis is far above the unit of the files where it begins with so many of them.
const FAR_ABOVE: f64 = 1e6;

/// A tick at an end of the axis may lie beside it by so little.
const ROUNDING: f64 = 1e-9;

impl Axis {
    /// A linear axis.
    pub fn linear(label: &str, from: f64, to: f64) -> Self {
        Axis {
            label: label.into(),
            from,
            to,
            log: false,
            names: Vec::new(),
            beside: 0.0,
            units: PreferredUnits::default(),
            ends: Ends::Fixed,
        }
    }

    /// A logarithmic axis; both ends above zero.
    pub fn log(label: &str, from: f64, to: f64) -> Self {
        Axis { log: true, ..Axis::linear(label, from, to) }
    }

    /// Of things with names, the first one at the lower end.
    pub fn of_names(names: Vec<String>) -> Self {
        let to = names.len() as f64 - 0.5;
        Axis { names, ..Axis::linear("", -0.5, to) }
    }

    /// Around the values with a small margin; a linear axis starts at 0 where that costs little.
    pub fn around(label: &str, values: impl IntoIterator<Item = f64>, log: bool) -> Self {
        let usable = values.into_iter().filter(|v| v.is_finite() && (!log || *v > 0.0));
        let (low, high) = usable.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), v| (a.min(v), b.max(v)));
        let around = |from: f64, to: f64| Axis { log, ends: Ends::Around, ..Axis::linear(label, from, to) };
        if low > high {
            return around(if log { 0.1 } else { 0.0 }, 1.0);
        }
        if log {
            let margin = (high / low).powf(0.03).max(1.1);
            return around(low / margin, high * margin);
        }
        let margin = if high > low { 0.06 * (high - low) } else { (0.1 * high.abs()).max(1e-9) };
        let from = if low >= 0.0 && low <= 0.3 * high { 0.0 } else { low - margin };
        around(from, high + margin)
    }

    /// The same, longer by a share of its length at its upper end.
    pub(crate) fn longer(self, share: f64) -> Self {
        let to = if self.log {
            self.to * (self.to / self.from).powf(share)
        } else {
            self.to + share * (self.to - self.from)
        };
        Self { to, ..self }
    }

    /// Where a value lies: 0 at the start of the axis, 1 at its end.
    pub fn place(&self, value: f64) -> f64 {
        if self.log {
            (value / self.from).ln() / (self.to / self.from).ln()
        } else {
            (value - self.from) / (self.to - self.from)
        }
    }

    /// The same with its numbers in the units that the user wants.
    pub fn in_units(self, units: PreferredUnits) -> Self {
        Self { units, ..self }
    }

    /// The unit in which its numbers are written and that of its label, where these differ: of an axis of forces, lengths or works that which the
    /// user wants, and else, in the unit of the files, the prefix that fits; of a logarithmic axis where all of it is far above that unit.
    fn prefixed(&self) -> Option<(Unit, Unit)> {
        let name = self.label.rsplit_once('(')?.1.strip_suffix(')')?;
        let of_label = |units: &&[Unit]| units.iter().any(|known| known.name == name);
        let all = [FORCES, LENGTHS, WORKS, FORCES_PER_WIDTH, WORKS_PER_WIDTH];
        let units = all.into_iter().find(of_label)?;
        let own = *units.iter().find(|known| known.name == name)?;
        let fits = || Unit::fitting(units, self.from.abs().max(self.to.abs()).max(self.beside));
        let has_prefix = own.size == 1.0 && (!self.log || self.from >= FAR_ABOVE);
        let written = self.units.of(units).or_else(|| has_prefix.then(fits))?;
        (written != own).then_some((written, own))
    }

    /// The unit in which its numbers are written, over that of its label.
    fn scale(&self) -> f64 {
        self.prefixed().map_or(1.0, |(written, own)| written.size / own.size)
    }

    /// The power of ten that the texts of the ticks leave out besides: of a linear axis with many zeros.
    fn decades(&self) -> i32 {
        let largest = self.from.abs().max(self.to.abs()) / self.scale();
        if self.log
            || !self.names.is_empty()
            || !largest.is_finite()
            || largest == 0.0
            || (1e-3..1e5).contains(&largest)
        {
            return 0;
        }
        3 * (largest.log10() / 3.0).floor() as i32
    }

    /// The label, with the prefix that fits, or with the power of ten that the texts leave out: "force P (mN)", "stiffness (10⁶ nN/nm)".
    pub(crate) fn title(&self) -> String {
        if self.label.starts_with('(') {
            return String::new();
        }
        let label = match self.prefixed() {
            Some((written, own)) => {
                let words = self.label.strip_suffix(&format!("({})", own.name)).unwrap_or_default();
                format!("{words}({})", written.name)
            }
            None => self.label.clone(),
        };
        let power = match self.decades() {
            0 => return label,
            decades => format!("10{}", raised(decades)),
        };
        match label.rsplit_once('(') {
            Some((words, unit)) => format!("{words}({power} {unit}"),
            None => format!("{label} ({power})"),
        }
    }

    /// A value with so many significant digits, in the unit of the title: "4.1 mN".
    pub(crate) fn text_of(&self, value: f64, digits: i32) -> String {
        let own = || self.label.rsplit_once('(').and_then(|(_, unit)| unit.strip_suffix(')')).unwrap_or_default();
        let (value, unit) = match self.prefixed() {
            Some((written, own)) => (value * own.size / written.size, written.name),
            None => (value, own()),
        };
        format!("{} {unit}", significant(value, digits)).trim_end().to_owned()
    }

    /// Ticks for about `count` texts.
    pub fn ticks(&self, count: usize) -> Vec<Tick> {
        if !self.names.is_empty() {
            let tick = |(k, name): (usize, &String)| Tick { value: k as f64, text: Some(name.clone()) };
            return self.names.iter().enumerate().map(tick).collect();
        }
        let ticks = if self.log { self.log_ticks(count) } else { self.linear_ticks(count) };
        ticks.into_iter().filter(|t| (-ROUNDING..=1.0 + ROUNDING).contains(&self.place(t.value))).collect()
    }

    fn linear_ticks(&self, count: usize) -> Vec<Tick> {
        let scale = self.scale();
        let (from, to) = (self.from / scale, self.to / scale);
        let rough = (to - from) / count.max(1) as f64;
        let decade = 10f64.powf(rough.log10().floor());
        let off = |step: &f64| (step / rough).ln().abs();
        let round = [1.0, 2.0, 5.0, 10.0].map(|m| m * decade);
        let step = round.into_iter().min_by(|a, b| off(a).total_cmp(&off(b))).unwrap_or(rough);
        let shown = step / 10f64.powi(self.decades());
        let digits = (-(shown * 1.000_001).log10().floor()).clamp(0.0, 12.0) as usize;
        let (first, last) = ((from / step - ROUNDING).ceil() as i64, (to / step + ROUNDING).floor() as i64);
        let text = |i: i64| minus(format!("{:.digits$}", i as f64 * shown));
        (first..=last).map(|i| Tick { value: i as f64 * step * scale, text: Some(text(i)) }).collect()
    }

    fn log_ticks(&self, count: usize) -> Vec<Tick> {
        // decades of the unit in which its numbers are written
        let unit = self.scale();
        let (from, to) = ((self.from / unit).log10(), (self.to / unit).log10());
        let (first, last) = (from.floor() as i32, to.ceil() as i32);
        let whole = (to.floor() as i32 - from.ceil() as i32).max(0);
        let every = (whole as usize / count.max(1) + 1) as i32;
        let plain = (-3..=3).contains(&first) && (-3..=4).contains(&last) && whole <= 2;
        let written: &[i32] = if whole >= 2 { &[1] } else { &[1, 2, 5] };
        let mut ticks = Vec::new();
        for decade in first..=last {
            for digit in 1..10 {
                let value = f64::from(digit) * 10f64.powi(decade);
                let shown = written.contains(&digit) && decade.rem_euclid(every) == 0;
                if digit > 1 && every > 1 {
                    continue;
                }
                let text = shown.then(|| match plain {
                    true => format!("{value:.*}", (-decade).max(0) as usize),
                    false if digit == 1 => format!("10{}", raised(decade)),
                    false => format!("{digit}·10{}", raised(decade)),
                });
                ticks.push(Tick { value: value * unit, text });
            }
        }
        ticks
    }
}

/// A number of nN, nm or aJ in this unit, with so many significant digits.
pub fn with_unit(unit: Unit, value: f64, digits: i32) -> String {
    format!("{} {}", significant(unit.of(value), digits), unit.name)
}

/// A number with so many significant digits, as one prints it in a picture.
pub fn significant(value: f64, digits: i32) -> String {
    if value == 0.0 {
        return "0".into();
    }
    if !value.is_finite() {
        return minus(format!("{value}"));
    }
    let decade = value.abs().log10().floor() as i32;
    if !(-4..=6).contains(&decade) {
        let mantissa = value / 10f64.powi(decade);
        return minus(format!("{mantissa:.*}·10{}", (digits - 1).max(0) as usize, raised(decade)));
    }
    minus(format!("{value:.*}", (digits - 1 - decade).max(0) as usize))
}

/// The minus sign of typography in place of the hyphen.
fn minus(text: String) -> String {
    text.replace('-', "−")
}

/// An exponent in raised digits.
fn raised(exponent: i32) -> String {
    exponent
        .to_string()
        .chars()
        .map(|c| match c.to_digit(10) {
            Some(d) => ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'][d as usize],
            None => '⁻',
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn texts(axis: &Axis, count: usize) -> Vec<String> {
        axis.ticks(count).into_iter().filter_map(|t| t.text).collect()
    }

    #[test]
    fn linear_ticks_are_round_and_inside() {
        assert_eq!(texts(&Axis::linear("u", 0.0, 70.0), 7), ["0", "10", "20", "30", "40", "50", "60", "70"]);
        assert_eq!(texts(&Axis::linear("P", -0.011, 0.04), 5), ["−0.01", "0.00", "0.01", "0.02", "0.03", "0.04"]);
    }

    #[test]
    fn many_zeros_go_into_the_label() {
        let small = Axis::linear("stiffness k (nN/nm)", 0.0, 4e-5);
        assert_eq!(
            (texts(&small, 4), small.title()),
            (["0", "10", "20", "30", "40"].map(Into::into).to_vec(), "stiffness k (10⁻⁶ nN/nm)".into())
        );
        let large = Axis::linear("u", 0.0, 3e6);
        assert_eq!(
            (texts(&large, 3), large.title()),
            (["0", "1", "2", "3"].map(Into::into).to_vec(), "u (10⁶)".into())
        );
        assert_eq!(Axis::linear("u (nm)", 0.0, 70.0).title(), "u (nm)");
    }

    #[test]
    fn forces_lengths_and_works_have_the_prefix_that_fits() {
        let force = Axis::linear("force P (nN)", 0.0, 4.1e6);
        assert_eq!(
            (texts(&force, 4), force.title()),
            (["0", "1", "2", "3", "4"].map(Into::into).to_vec(), "force P (mN)".into())
        );
        assert_eq!(
            (force.text_of(2.5e6, 3), Axis::linear("u (nm)", 0.0, 70.0).text_of(3.0, 2)),
            ("2.50 mN".into(), "3.0 nm".into())
        );
        assert_eq!(Axis::linear("displacement u (nm)", 0.0, 2e4).title(), "displacement u (µm)");
        assert_eq!(Axis::linear("work W (aJ)", -2e9, 1.0).title(), "work W (nJ)");
        assert_eq!(Axis::linear("W/b (nJ/m)", 0.0, 3e8).title(), "W/b (mJ/m)");
        let lower = Axis { beside: 4.1e6, ..Axis::linear("force P (nN)", 0.0, 8e5) };
        assert_eq!(
            (lower.title(), texts(&lower, 4)),
            ("force P (mN)".into(), ["0.0", "0.2", "0.4", "0.6", "0.8"].map(Into::into).to_vec())
        );
        assert_eq!(Axis::log("force P (nN)", 1e4, 1e6).title(), "force P (nN)", "a logarithmic axis has powers of ten");
        let far = Axis::log("force P (nN)", 2e9, 3e10);
        assert_eq!(
            (texts(&far, 4), far.title()),
            (["2", "5", "10", "20"].map(Into::into).to_vec(), "force P (N)".into())
        );
    }

    #[test]
    fn what_the_user_wants_comes_before_what_fits() {
        let units = PreferredUnits::parse("mm,µN").unwrap();
        let length = Axis::linear("displacement u (nm)", 0.0, 4e5).in_units(units);
        assert_eq!(
            (texts(&length, 4), length.title(), length.text_of(2.5e5, 3)),
            (
                ["0.0", "0.1", "0.2", "0.3", "0.4"].map(Into::into).to_vec(),
                "displacement u (mm)".into(),
                "0.250 mm".into()
            )
        );
        let short = Axis::linear("u (nm)", 0.0, 70.0).in_units(units);
        assert_eq!(
            (texts(&short, 3), short.title()),
            (["0", "20", "40", "60"].map(Into::into).to_vec(), "u (10⁻⁶ mm)".into())
        );
        let nano = PreferredUnits::parse("nm").unwrap();
        let of_seta = Axis::linear("lift (µm)", 0.0, 0.3).in_units(nano);
        assert_eq!((of_seta.title(), of_seta.text_of(0.25, 3)), ("lift (nm)".into(), "250 nm".into()));
        let above = Axis { label: "(µm)".into(), ..of_seta };
        assert_eq!((above.title(), above.text_of(0.25, 3)), (String::new(), "250 nm".into()));
        let trade = PreferredUnits::parse("N/25mm").unwrap();
        let peel = Axis::linear("P/b (N/m)", 0.0, 400.0).in_units(trade);
        assert_eq!(
            (texts(&peel, 5), peel.title(), peel.text_of(100.0, 3)),
            (["0", "2", "4", "6", "8", "10"].map(Into::into).to_vec(), "P/b (N/25mm)".into(), "2.50 N/25mm".into())
        );
        let force = Axis::log("force P (nN)", 1e2, 1e4).in_units(units);
        assert_eq!(
            (texts(&force, 9), force.title()),
            (["0.1", "1", "10"].map(Into::into).to_vec(), "force P (µN)".into())
        );
    }

    #[test]
    fn log_ticks_are_decades_in_raised_digits() {
        assert_eq!(texts(&Axis::log("f", 1e-4, 1e-1), 9), ["10⁻⁴", "10⁻³", "10⁻²", "10⁻¹"]);
        assert_eq!(texts(&Axis::log("P", 0.03, 0.9), 6), ["0.05", "0.1", "0.2", "0.5"]);
    }

    #[test]
    fn long_log_axes_skip_decades() {
        assert_eq!(
            texts(&Axis::log("f", 1e-8, 1e8), 9),
            ["10⁻⁸", "10⁻⁶", "10⁻⁴", "10⁻²", "10⁰", "10²", "10⁴", "10⁶", "10⁸"]
        );
    }

    #[test]
    fn numbers_keep_their_significant_digits() {
        assert_eq!(significant(48.215_617, 4), "48.22");
        assert_eq!(significant(0.037_562_7, 3), "0.0376");
        assert_eq!(significant(-2.5e-9, 3), "−2.50·10⁻⁹");
        assert_eq!(significant(-0.0, 3), "0");
    }

    #[test]
    fn an_axis_around_nothing_or_one_value_has_a_length() {
        for axis in [Axis::around("x", [], false), Axis::around("x", [3.0], false), Axis::around("x", [0.0], false)] {
            assert!(axis.to > axis.from && !axis.ticks(5).is_empty());
        }
        assert!(Axis::around("x", [2.0], true).ticks(5).iter().any(|t| t.text.is_some()));
    }
}
