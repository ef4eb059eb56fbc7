//! The law of a seta as files: seta_law.toml, which `setae.law` reads, seta_paths.csv, the resolved paths of its root, and the object summary.json.

use crate::records::summary::{Found, Summary};
use crate::writing::error::ReportError;
use crate::writing::file::write_whole;
use crate::writing::record::write_table;
use crate::writing::record::{Fields, Record};
use crate::writing::reference::Output;
use peelkit::study::coarsening::{LawSheet, RootPath, RootPoint, SetaLaw, SetaLawErrors, SetaLawOptions};
use peelkit_scene::{CHECK, KEYS, SETA_LAW, Scene, seta_lines};
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// The law of a seta, and what it is made of.
#[derive(Clone, Debug)]
pub struct SetaLawFound {
    /// The law that is written
    pub law: SetaLaw,
    /// What was asked of it
    pub asked: SetaLawOptions,
    /// Errors of laws of degree 2, 3 and 4 of the same paths; none where the paths do not determine one
    pub by_degree: [Option<SetaLawErrors>; 3],
    /// Directions of the pulls, rad from the ground, and their paths
    pub paths: Vec<(f64, RootPath)>,
    /// That it took
    pub seconds: f64,
}

/// The law as a text, with the seta of a scene that it is of.
pub fn seta_law_text(law: &SetaLaw, scene: &Scene) -> String {
    let list = |numbers: &[f64]| {
        let all: Vec<String> = numbers.iter().map(|number| format!("{number:?}")).collect();
        format!("[{}]", all.join(", "))
    };
    let mut text = format!(
        "# The law of a seta: E(u, v) = sum of a_ij (u/s)^i (v/s)^j on each sheet, up to u d_x + v d_y = c; behind the last one the seta is detached.\n\
         # u is the way of its root along the ground, v off it, in nm; E in aJ. a_ij by rising i + j, and by falling i where that is the same.\n\
         # tips: the most that adhere on a sheet. On the first one all do, and its potential has the degree; those of the others have degree 2.\n\
         degree = {}\nscale_nm = {:?}\n",
        law.degree, law.scale
    );
    let SetaLawErrors { force, force_left_out, exit, exit_left_out, peak, peak_left_out, work, work_left_out } =
        law.errors;
    let numbers = [
        ("largest_force_nN", law.largest_force),
        ("force_error", force),
        ("force_error_left_out", force_left_out),
        ("exit_error", exit),
        ("exit_error_left_out", exit_left_out),
        ("peak_error", peak),
        ("peak_error_left_out", peak_left_out),
        ("work_error", work),
        ("work_error_left_out", work_left_out),
    ];
    numbers.iter().for_each(|(name, number)| _ = writeln!(text, "{name} = {number:?}"));
    text += "sheets = [\n";
    for LawSheet { tips, coefficients, exit } in &law.sheets {
        let (coefficients, direction) = (list(coefficients), list(&exit.direction));
        let distance = exit.distance;
        _ = writeln!(
            text,
            "  {{ tips = {tips}, exit_nm = {distance:?}, exit_direction = {direction}, coefficients_aJ = {coefficients} }},"
        );
    }
    text += "]\n";
    text += "# the seta\nof = [\n";
    for line in seta_lines(scene, KEYS) {
        _ = writeln!(text, "  {},", serde_json::Value::from(line));
    }
    text += "]\n";
    let check = crc32fast::hash(text.as_bytes());
    text + &format!("{CHECK}\"{check:08x}\"\n")
}

/// A point of a path.
struct PathRow<'a> {
    law: &'a SetaLaw,
    angle: f64,
    point: &'a RootPoint,
}

impl PathRow<'_> {
    /// The sheet on which a pull straight to it is.
    fn sheet(&self) -> usize {
        self.law.sheet(0, self.point.root)
    }

    fn by_law(&self) -> [f64; 2] {
        self.law.response(self.sheet(), self.point.root).force
    }
}

impl Record for PathRow<'_> {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("angle_deg", "of the pull to the ground", |row| row.angle.to_degrees());
        of.field("along_nm", "u: of the root along the ground", |row| row.point.root[0]);
        of.field("normal_nm", "v: of the root off the ground", |row| row.point.root[1]);
        of.field("along_force_nN", "that holds the root of the resolved seta along the ground", |row| row.point.force[0]);
        of.field("normal_force_nN", "the same off the ground", |row| row.point.force[1]);
        of.field("energy_aJ", "of the resolved seta, against being detached", |row| row.point.energy);
        of.field("work_aJ", "of the root from the start", |row| row.point.work);
        of.field("tips", "that adhere", |row| row.point.tips);
        of.field("law_sheet", "on which the law is, from 0 on; their number where it is detached", PathRow::sheet);
        of.field("law_along_force_nN", "∂E/∂u of the law", |row| row.by_law()[0]);
        of.field("law_normal_force_nN", "∂E/∂v of the law", |row| row.by_law()[1]);
    }
}

/// Errors of a law.
struct Errors<'a>(&'a SetaLawErrors);

impl Record for Errors<'_> {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("force", "largest difference of the force from that of the resolved seta before the first loss of a tip, over the largest force there", |errors| errors.0.force);
        of.field("force_left_out", "the same of each path by the law of all others: what is to be expected between them", |errors| errors.0.force_left_out);
        of.field("exit", "largest distance of a first loss from the exit plane, over c", |errors| errors.0.exit);
        of.field("exit_left_out", "the same of each path by the plane of all others", |errors| errors.0.exit_left_out);
        of.field("peak", "largest difference of the largest force of a pull from that of the resolved seta, over that", |errors| errors.0.peak);
        of.field("peak_left_out", "the same of each path by the law of all others", |errors| errors.0.peak_left_out);
        of.field("work", "largest difference of the work until the seta is detached from that of the resolved seta, over that", |errors| errors.0.work);
        of.field("work_left_out", "the same of each path by the law of all others", |errors| errors.0.work_left_out);
    }
}

impl Record for SetaLawFound {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("end", "`converged`; `tolerance-not-met`: more sheets help little or may not be, and `errors.peak` or `errors.work` are above the tolerance", |found| if found.is_within() { "converged" } else { "tolerance-not-met" });
        of.field("law_of", "`seta`: what holds the root of a whole seta; the law of a tip has other keys", |_| "seta");
        of.field("tolerance", "error asked of peak and work; null where one sheet was asked for, which leaves out what the tips behind the first one hold", |found| (found.asked.sheets > 1).then_some(found.asked.tolerance));
        of.field("degree", "of the potential of the first sheet; those behind it have degree 2", |found| found.law.degree);
        of.field("sheets", "in the order in which they are left", |found| found.law.sheets.iter().map(Sheet).collect::<Vec<_>>());
        of.field("exit_nm", "c of the first sheet: the first tip lets go where u d_x + v d_y = c", |found| found.law.first_exit().distance);
        of.field("exit_deg", "angle of its d to the ground", |found| found.law.first_exit().angle().to_degrees());
        of.field("soft_nN_per_nm", "smaller eigenvalue of the stiffness where the root has not moved", |found| found.stiffness()[0]);
        of.field("stiff_nN_per_nm", "larger eigenvalue", |found| found.stiffness()[1]);
        of.field("largest_force_nN", "of all paths before the first loss of a tip: what errors of forces are measured by", |found| found.law.largest_force);
        of.field("errors", "of the law", |found| Errors(&found.law.errors));
        of.field("degree_2", "errors of a law of degree 2 of the same paths, which a band takes; null where they do not determine it", |found| found.by_degree[0].as_ref().map(Errors));
        of.field("degree_3", "of degree 3", |found| found.by_degree[1].as_ref().map(Errors));
        of.field("degree_4", "of degree 4", |found| found.by_degree[2].as_ref().map(Errors));
        of.field("paths", "pulls of the root, each followed until its last tip lets go", |found| found.paths.len());
        of.field("equilibria", "on all of them", |found| found.paths.iter().map(|(_, path)| path.points.len()).sum::<usize>());
        of.field("solve_s", "time of the computation", |found| found.seconds);
    }
}

/// A sheet of a law.
struct Sheet<'a>(&'a LawSheet);

impl Record for Sheet<'_> {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("tips", "most tips that adhere on it; the fewest are one more than the most on the next one", |sheet| sheet.0.tips);
        of.field("exit_nm", "c: it is left where u d_x + v d_y = c", |sheet| sheet.0.exit.distance);
        of.field("exit_deg", "angle of d to the ground", |sheet| sheet.0.exit.angle().to_degrees());
    }
}

impl SetaLawFound {
    /// Whether peak and work are within what was asked; one sheet is asked no such thing.
    pub fn is_within(&self) -> bool {
        let SetaLawErrors { peak, work, .. } = self.law.errors;
        self.asked.sheets == 1 || peak.max(work) <= self.asked.tolerance
    }

    /// Eigenvalues of the stiffness where the root has not moved, the smaller one first, nN/nm.
    pub fn stiffness(&self) -> [f64; 2] {
        let [[a, b], [_, c]] = self.law.response(0, [0.0; 2]).stiffness;
        let (mean, half) = (0.5 * (a + c), (0.5 * (a - c)).hypot(b));
        [mean - half, mean + half]
    }
}

impl Found for &SetaLawFound {
    const PARAMETERS: &'static str = "the scene as it was computed";
}

/// A law of a seta as one object.
pub type SetaLawSummary<'a> = Summary<'a, &'a SetaLawFound>;

impl<'a> SetaLawSummary<'a> {
    /// The summary of the law of the seta of a scene.
    pub fn new(scene: &'a Scene, found: &'a SetaLawFound) -> Self {
        Summary::of(scene, found)
    }
}

/// Writes seta_law.toml and seta_paths.csv.
///
/// Fails with [`ReportError::Write`] where a file cannot be written or a number is not finite.
pub fn write_seta_law(dir: &Path, scene: &Scene, found: &SetaLawFound) -> Result<Vec<PathBuf>, ReportError> {
    let path = dir.join(SETA_LAW);
    write_whole(&path, seta_law_text(&found.law, scene).as_bytes())?;
    let rows = found
        .paths
        .iter()
        .flat_map(|(angle, path)| path.points.iter().map(|point| PathRow { law: &found.law, angle: *angle, point }));
    Ok(vec![path, write_table(dir, "seta_paths.csv", rows)?])
}

/// The table and the object.
pub(crate) fn outputs() -> Vec<Output> {
    vec![
        Output::object("peel coarsen of a seta", SetaLawSummary::keys()),
        Output::table("seta_paths.csv", PathRow::keys()),
    ]
}
