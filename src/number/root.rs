//! A root of a function of one number, between two places that are known to hold it.
//!
//! Newton's method, kept inside the bracket: a step that would leave it goes to the middle instead. Without any slope that is
//! bisection.

use thiserror::Error;

/// Most places at which the function is looked at: bisection alone comes down to round-off in some 60.
const MOST_LOOKS: usize = 100;

/// Two places between which a function goes from below zero to above.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bracket {
    /// Where it is below zero.
    pub low: f64,
    /// Where it is not.
    pub high: f64,
}

/// One look at the function.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Look {
    /// The place
    pub at: f64,
    /// The function there
    pub value: f64,
    /// Its slope there
    pub slope: f64,
    /// Where Newton's method would go.
    pub newton: f64,
    /// Where to look next: there if that is within the bracket, else in its middle.
    pub next: f64,
    /// What is left of the bracket.
    pub bracket: Bracket,
}

impl Look {
    /// Whether Newton's method goes on within the bracket.
    #[inline]
    pub(crate) fn is_newton(&self) -> bool {
        self.next == self.newton
    }
}

/// No look was good enough. Where the bracket holds a root, round-off leaves no better than `next`.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
#[error("no root found in {looks} looks; {} to {} is left of its bracket", bracket.low, bracket.high)]
pub struct RootNotFound {
    /// What is left of the bracket.
    pub bracket: Bracket,
    /// Where the next look would have been.
    pub next: f64,
    /// How often the function was looked at.
    pub looks: usize,
}

impl Bracket {
    /// The root of `function`, which gives value and slope, by Newton's method from `start` on until a look `settles` it: then that says where
    /// it is.
    ///
    /// # Errors
    /// Where no look of the first hundred does: what is left then.
    #[inline]
    pub(crate) fn newton(
        self,
        start: f64,
        function: impl Fn(f64) -> (f64, f64),
        settles: impl Fn(&Look) -> Option<f64>,
    ) -> Result<f64, RootNotFound> {
        self.search(start, function, settles).map(|(root, _)| root)
    }

    /// What is left of the bracket when it has been halved until it `is_narrow`, or until no number is left between its ends. Of the
    /// function no more is known than where it is below zero.
    pub fn bisected(self, is_below: impl Fn(f64) -> bool, is_narrow: impl Fn(&Self) -> bool) -> Self {
        let sign = |at: f64| (if is_below(at) { -1.0 } else { 1.0 }, f64::NAN);
        let settles = |look: &Look| {
            let Self { low, high } = look.bracket;
            (is_narrow(&look.bracket) || look.next == low || look.next == high).then_some(look.next)
        };
        self.search(self.middle(), sign, settles).map_or_else(|left| left.bracket, |(_, narrow)| narrow)
    }

    /// The root, and what is left of the bracket.
    #[inline]
    fn search(
        mut self,
        start: f64,
        function: impl Fn(f64) -> (f64, f64),
        settles: impl Fn(&Look) -> Option<f64>,
    ) -> Result<(f64, Self), RootNotFound> {
        let mut at = start;
        for _ in 0..MOST_LOOKS {
            let (value, slope) = function(at);
            if value < 0.0 {
                self.low = at;
            } else {
                self.high = at;
            }
            let newton = at - value / slope;
            let next = if newton > self.low && newton < self.high { newton } else { self.middle() };
            if let Some(root) = settles(&Look { at, value, slope, newton, next, bracket: self }) {
                return Ok((root, self));
            }
            at = next;
        }
        Err(RootNotFound { bracket: self, next: at, looks: MOST_LOOKS })
    }

    /// Half-way between its ends.
    #[inline]
    pub fn middle(&self) -> f64 {
        0.5 * (self.low + self.high)
    }

    /// From end to end.
    #[inline]
    pub fn width(&self) -> f64 {
        self.high - self.low
    }
}

/// Most looks of [`passed`].
const MOST_SOLVES: usize = 40;

/// Where what is solved for at a place passes zero, between two places with their values, of which it is above at one alone: by the rule of false
/// position, in which an end that stays once more has half of its value, so that the other does not creep (Illinois). `solve` gives what is there and its
/// value; `is_met` says by the value, the place and what is left of the bracket whether that is near enough. The last one where none is.
///
/// # Errors
/// As of `solve`.
pub fn passed<T, E>(
    mut low: (f64, f64),
    mut high: (f64, f64),
    mut solve: impl FnMut(f64) -> Result<(T, f64), E>,
    is_met: impl Fn(f64, f64, f64) -> bool,
) -> Result<(T, Passing), E> {
    let (mut looks, mut low_moved) = (0, None);
    loop {
        let share = if looks % 4 == 3 { 0.5 } else { low.1 / (low.1 - high.1) };
        let place = low.0 + share.clamp(0.0, 1.0) * (high.0 - low.0);
        let (found, value) = solve(place)?;
        let passing = Passing { place, value, left: (high.0 - low.0).abs() };
        looks += 1;
        if is_met(value, place, passing.left) || looks == MOST_SOLVES {
            return Ok((found, passing));
        }
        let moves_low = (value >= 0.0) == (low.1 >= 0.0);
        let (moving, staying) = if moves_low { (&mut low, &mut high) } else { (&mut high, &mut low) };
        *moving = (place, value);
        if low_moved == Some(moves_low) {
            staying.1 *= 0.5;
        }
        low_moved = Some(moves_low);
    }
}

/// Where something was found to pass zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Passing {
    /// The place
    pub place: f64,
    /// What is left of the value there
    pub value: f64,
    /// What was left of the bracket before
    pub left: f64,
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    fn close(look: &Look) -> Option<f64> {
        ((look.next - look.at).abs() <= 4.0 * f64::EPSILON * look.at.abs()).then_some(look.next)
    }

    #[test]
    fn newtons_method_finds_a_root() {
        let root = Bracket { low: 0.0, high: 3.0 }.newton(1.0, |x| (x * x - 2.0, 2.0 * x), close);
        assert_relative_eq!(root.unwrap(), 2f64.sqrt(), max_relative = 1e-15);
    }

    /// Of the arc tangent Newton's method alone goes to and fro, ever farther away.
    #[test]
    fn steps_that_would_leave_the_bracket_halve_it() {
        let atan = |x: f64| ((x - 1.0).atan(), (1.0 + (x - 1.0).powi(2)).recip());
        let root = Bracket { low: -40.0, high: 60.0 }.newton(50.0, atan, close);
        assert_relative_eq!(root.unwrap(), 1.0, max_relative = 1e-15);
    }

    #[test]
    fn false_position_passes_a_root_and_says_what_is_left() {
        let cube = |x: f64| Ok::<_, ()>((x, x * x * x - 2.0));
        let (root, passing) = passed((0.0, -2.0), (2.0, 6.0), cube, |value, _, _| value.abs() < 1e-13).unwrap();
        assert_relative_eq!(root, 2f64.cbrt(), max_relative = 1e-13);
        assert!(passing.place == root && passing.value.abs() < 1e-13 && passing.left < 2.0);
        assert_eq!(passed((0.0, -2.0), (2.0, 6.0), |_| Err::<((), f64), _>("why"), |_, _, _| true), Err("why"));
    }

    #[test]
    fn bisection_ends_between_neighbours_or_before() {
        let whole = Bracket { low: 1.0, high: 2.0 };
        let narrow = whole.bisected(|x| x * x < 2.0, |_| false);
        assert_eq!(narrow.high, narrow.low.next_up());
        assert!(narrow.low * narrow.low < 2.0 && narrow.high * narrow.high >= 2.0);
        assert_eq!(whole.bisected(|x| x < 1.3, |left| left.width() <= 0.25), Bracket { low: 1.25, high: 1.5 });
    }

    #[test]
    fn what_never_is_good_enough_is_an_error_with_what_is_left() {
        let left = Bracket { low: 0.0, high: 1.0 }.newton(0.5, |x| (x - 0.3, f64::NAN), |_| None).unwrap_err();
        assert_relative_eq!(left.next, 0.3, max_relative = 1e-15);
        assert_eq!(left.looks, MOST_LOOKS);
    }
}
