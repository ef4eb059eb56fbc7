//! Which terms of a model were left out and which not, and why.

use crate::number::Finite;
use peelkit::study::{KeptReason, LeftOut, Term, TermDecisions};

/// What was decided of the terms as summary.json reports it.
#[derive(Debug, serde::Serialize)]
pub(super) struct TermDecisionsSummary {
    left_out: Vec<Left>,
    kept: Vec<Kept>,
}

/// What leaving a term in would change.
#[derive(Debug, serde::Serialize)]
struct Left {
    term: &'static str,
    #[serde(rename = "initiation_peak_change_nN")]
    force: Finite,
    #[serde(rename = "initiation_peak_change_nm")]
    displacement: Finite,
    largest_relative_change: Finite,
}

#[derive(Debug, serde::Serialize)]
struct Kept {
    term: &'static str,
    why: String,
}

impl From<&TermDecisions> for TermDecisionsSummary {
    fn from(considered: &TermDecisions) -> Self {
        let left = |left: &LeftOut| Left {
            term: left.term.word(),
            force: Finite(left.force),
            displacement: Finite(left.displacement),
            largest_relative_change: Finite(left.largest),
        };
        let kept = |(term, why): &(Term, KeptReason)| Kept { term: term.word(), why: why_kept(why) };
        Self {
            left_out: considered.left_out.iter().map(left).collect(),
            kept: considered.kept.iter().map(kept).collect(),
        }
    }
}

/// Why a term was not left out, in words.
pub fn why_kept(why: &KeptReason) -> String {
    match why {
        KeptReason::Matters(share) => format!("neglecting it would change a result by {share:.1e}, relative"),
        KeptReason::NothingSaved => "neglecting it would not reduce the computational cost".into(),
        KeptReason::NotEstimated(why) => format!("its effect was not estimated: {why}"),
    }
}
