//! The line load of a beam section above a flat half space.

/// Which distributed load the adhesion puts on the axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LineLoad {
    /// Line force and line moment, eqs. (17)-(22).
    Full,
    /// The line force of eq. (17) without the moment of eq. (20); it has no potential.
    ForceOnly,
    /// The traction at the gap below the axis, blind to tilt.
    AxisGap,
}
