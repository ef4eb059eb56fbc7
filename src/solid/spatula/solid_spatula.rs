//! Half a spatula as a solid: its mesh, its elements, and what is asked of its displacements.

use super::element::{Element, ElementPlace, ElementWork};
use super::end_face::EndFace;
use super::geometry::SolidGeometry;
use super::ground::SolidGround;
use super::layout::{ELEMENT, Layout, OF_FACE};
use super::material::NeoHookean;
use crate::adhesion::levels::half_space::HalfSpace;
use crate::adhesion::substrate::Substrate;
use crate::beam::varying::BeamGeometry;
use crate::solid::contact::{DETACHED, GAP_SCALE};
use crate::solid::grip::{GripDrive, ROTATION, turned};
use crate::solid::mesh::halved;
use crate::solve::state::{Mesh, State};
use rayon::prelude::*;
use std::sync::Arc;

/// Where a spatula is cut: stations along S, and lines across its half width.
#[derive(Clone, Debug, PartialEq)]
pub struct SpatulaMesh {
    /// S of the stations, ascending from 0 to the length, nm; the outline's breaks among them
    pub stations: Vec<f64>,
    /// t of the lines across, ascending from 0, the plane of symmetry, to 1, the free edge
    pub sides: Vec<f64>,
    /// S up to which the underside adheres, nm; a station
    pub adhering: f64,
    /// S of the end of the pad, which follows uneven ground before it settles; none: it settles from the crests
    pub pressed: Option<f64>,
}

impl SpatulaMesh {
    /// t of a line of nodes across: at the ends of elements and in their middles.
    pub(super) fn line(&self, line: usize) -> f64 {
        let ends = &self.sides[line / 2..];
        if line.is_multiple_of(2) { ends[0] } else { 0.5 * (ends[0] + ends[1]) }
    }
}

/// Points along S of an element of the underside: five where it is 2 nm long and r0 is 0.4 nm, eight at 4 nm.
const FACE_POINTS: f64 = 3.0;
const A_FACE_POINT: f64 = 2.0;
const MOST_FACE_POINTS: usize = 20;

/// A spatula as a solid in space, in the grip of a machine that moves its end face along y.
///
/// Unknowns are those of half of it; energy and forces are those of the whole.
#[derive(Clone, Debug)]
pub struct SolidSpatula {
    pub(crate) mesh: SpatulaMesh,
    pub(super) layout: Layout,
    elements: Vec<Element>,
    /// Of each element, where its unknowns stand in the front of its column
    places: Vec<Vec<Option<usize>>>,
    pub(super) geometry: SolidGeometry,
    /// x and y of the axis at the stations, nm
    pub(super) axis: Vec<[f64; 2]>,
    /// x and y of the nodes of the underside at rest, station by station, nm
    underside: Vec<Vec<[f64; 2]>>,
    /// Unknowns that stay, where the tip is held along the ground: in the middle of its thickness
    pub(super) anchored: Vec<usize>,
    pub(super) end_face: EndFace,
    pub(super) drive: GripDrive,
    pub(super) ground: SolidGround,
    pub(super) half_space: HalfSpace,
    pub(super) material: NeoHookean,
    /// E, GPa
    pub(super) youngs_modulus: f64,
}

impl SolidSpatula {
    /// Of an outline, of E (GPa) and ν, on a half space with this surface, in a grip. Its tip is held along the ground, in the middle of its thickness,
    /// unless the ground is level and the grip goes straight up and holds nothing across: then no force is needed for that.
    pub fn new(
        outline: Arc<dyn BeamGeometry>,
        (youngs_modulus, poissons_ratio): (f64, f64),
        (half_space, substrate): (HalfSpace, Substrate),
        drive: GripDrive,
        mesh: SpatulaMesh,
    ) -> Self {
        let geometry = SolidGeometry::new(outline, half_space.equilibrium_gap());
        let ground = SolidGround { half_space, substrate };
        let material = NeoHookean::new(youngs_modulus, poissons_ratio);
        Self::on(geometry, (material, youngs_modulus), ground, drive, mesh)
    }

    /// The same with every element cut in two along S and across.
    pub(crate) fn refined(&self) -> Self {
        let SpatulaMesh { stations, sides, .. } = &self.mesh;
        let mesh = SpatulaMesh { stations: halved(stations), sides: halved(sides), ..self.mesh };
        Self::on(self.geometry.clone(), (self.material, self.youngs_modulus), self.ground.clone(), self.drive, mesh)
    }

    fn on(
        geometry: SolidGeometry,
        (material, youngs_modulus): (NeoHookean, f64),
        ground: SolidGround,
        drive: GripDrive,
        mesh: SpatulaMesh,
    ) -> Self {
        let axis = geometry.axis(&mesh.stations);
        let layout = Layout::new(mesh.stations.len() - 1, mesh.sides.len() - 1);
        let of = |index: usize| {
            let (column, strip) = (index / layout.strips, index % layout.strips);
            let stations = [mesh.stations[column], mesh.stations[column + 1]];
            let adheres = stations[1] <= mesh.adhering;
            let points =
                FACE_POINTS + (stations[1] - stations[0]) / (A_FACE_POINT * ground.half_space.equilibrium_distance);
            let place = ElementPlace {
                stations,
                axis: [axis[column], axis[column + 1]],
                sides: [mesh.sides[strip], mesh.sides[strip + 1]],
                face_points: if adheres { (points.ceil() as usize).min(MOST_FACE_POINTS) } else { 0 },
                geometry: &geometry,
                material: &material,
            };
            (Element::new(&place), layout.places(column, strip))
        };
        let (elements, places) = (0..layout.columns * layout.strips).into_par_iter().map(of).unzip();
        let node = |station: usize, zeta: f64, line: usize| {
            geometry.in_plane(mesh.stations[station], axis[station], zeta, mesh.line(line)).place
        };
        let lines = layout.lines();
        let underside =
            (0..=layout.columns).map(|station| (0..lines).map(|line| node(station, -1.0, line)).collect()).collect();
        let end_face = EndFace::new(lines, |(through, line)| {
            let ([x, y], middle) = (node(layout.columns, through as f64 - 1.0, line), axis[layout.columns]);
            [x - middle[0], y - middle[1]]
        });
        let half_space = ground.half_space;
        let slides = ground.substrate.is_flat() && !drive.pulls_along();
        let anchor = |line: usize| layout.unknown(0, (1, line), false, 0).filter(|_| !slides);
        let anchored = (0..lines).filter_map(anchor).collect();
        Self {
            mesh,
            layout,
            elements,
            places,
            geometry,
            axis,
            underside,
            anchored,
            end_face,
            drive,
            ground,
            half_space,
            material,
            youngs_modulus,
        }
    }

    /// Number of elements.
    pub fn elements(&self) -> usize {
        self.elements.len()
    }

    /// Number of unknowns.
    pub fn unknowns(&self) -> usize {
        self.layout.unknowns()
    }

    /// Volume of the whole body, nm³.
    pub fn volume(&self) -> f64 {
        self.elements.iter().map(Element::volume).sum()
    }

    /// Numbers that a factorisation keeps.
    pub fn factor_numbers(&self) -> usize {
        let own = self.layout.station.len();
        (0..self.layout.columns).map(|column| own * (own + self.layout.at(column + 1))).sum()
    }

    /// The stress-free configuration.
    pub fn at_rest(&self) -> State {
        let mesh = Mesh { boundaries: self.mesh.stations.clone(), ..Mesh::default() };
        State { mesh, values: vec![0.0; self.unknowns()], force: 0.0, history: None }
    }

    /// The column and strip of an element.
    pub(super) fn column_of(&self, index: usize) -> usize {
        index / self.layout.strips
    }

    /// Where the unknowns of an element stand in the front of its column.
    pub(super) fn places(&self, index: usize) -> &[Option<usize>] {
        &self.places[index]
    }

    /// Displacements of the functions of an element.
    pub(super) fn moved(&self, values: &[f64], index: usize) -> [f64; ELEMENT] {
        let own = &values[self.layout.start(self.column_of(index))..];
        let places = &self.places[index];
        let mut moved = std::array::from_fn(|k| places[k].map_or(0.0, |place| own[place]));
        for (k, lever) in self.on_end_face(index) {
            let [x, y] = turned(self.rotation(values), lever);
            (moved[3 * k], moved[3 * k + 1]) = (moved[3 * k] + x, moved[3 * k + 1] + y);
        }
        moved
    }

    /// The functions of an element that move with the end face, with their levers: none unless it is next to it.
    pub(super) fn on_end_face(&self, index: usize) -> impl Iterator<Item = (usize, [f64; 2])> {
        let strip = (self.column_of(index) + 1 == self.layout.columns).then_some(index % self.layout.strips);
        strip.into_iter().flat_map(|strip| self.end_face.functions(strip))
    }

    /// The first unknown of the interface.
    pub(super) fn interface_start(&self) -> usize {
        self.unknowns() - OF_FACE
    }

    /// How far the end face has turned, rad.
    pub(super) fn rotation(&self, values: &[f64]) -> f64 {
        values[self.interface_start() + ROTATION]
    }

    /// The rotation of the end face, rad.
    pub(crate) fn end_rotation(&self, values: &[f64]) -> f64 {
        self.geometry.rotation_at(self.mesh.stations[self.layout.columns]) + self.rotation(values)
    }

    /// What an element adds at these values.
    pub(super) fn element_at(&self, values: &[f64], index: usize, tangent: bool, work: &mut ElementWork) {
        let moved = self.moved(values, index);
        self.elements[index].at(&moved, &self.material, &self.ground, tangent, work);
    }

    /// Calls `at` for each point of the underside with its gap and area, and with what adds the change of the gap to a gradient.
    pub(super) fn over_underside(&self, values: &[f64], mut at: impl FnMut(f64, f64, &mut dyn FnMut(f64, &mut [f64]))) {
        for (index, element) in self.elements.iter().enumerate().filter(|(_, element)| !element.face.is_empty()) {
            let moved = self.moved(values, index);
            let start = self.layout.start(self.column_of(index));
            for point in &element.face {
                let (gap, normal) = self.ground.distance(Element::place(point, &moved));
                let mut add = |factor: f64, gradient: &mut [f64]| {
                    for (k, value) in point.values.iter().enumerate() {
                        for (axis, share) in normal.into_iter().enumerate().filter(|(_, share)| *share != 0.0) {
                            if let Some(place) = self.places[index][3 * Element::on_face(k) + axis] {
                                gradient[start + place] += factor * share * value;
                            }
                        }
                    }
                };
                at(gap, point.area, &mut add);
            }
        }
    }

    /// Whether no node of the underside is nearer to the ground than 10 r0.
    pub(crate) fn is_detached(&self, values: &[f64]) -> bool {
        let cutoff = DETACHED * self.half_space.equilibrium_distance;
        self.gaps(values).into_iter().take(self.adhering_stations()).all(|gap| gap > cutoff)
    }

    /// The surface of the ground.
    pub(crate) fn substrate(&self) -> &Substrate {
        &self.ground.substrate
    }

    /// r_eq, the gap at rest, nm.
    pub(crate) fn rest_gap(&self) -> f64 {
        self.half_space.equilibrium_gap()
    }

    /// Distance of the stations of what adheres, the longest, nm.
    pub(crate) fn longest_column(&self) -> f64 {
        let adhering = &self.mesh.stations[..self.adhering_stations()];
        adhering.windows(2).map(|pair| pair[1] - pair[0]).fold(0.0, f64::max)
    }

    /// What is added to a gap before changes are taken relative to it, nm.
    pub(super) fn gap_scale(&self) -> f64 {
        GAP_SCALE * self.half_space.equilibrium_distance
    }

    /// The smallest gap of the underside at each station, nm.
    pub(crate) fn gaps(&self, values: &[f64]) -> Vec<f64> {
        let own = |station: usize| {
            let gap = |(line, place): (usize, &[f64; 2])| {
                let [x, y, _] = self.displacement(values, station, (0, line));
                self.ground.distance([place[0] + x, place[1] + y]).0
            };
            self.underside[station].iter().enumerate().map(gap).fold(f64::INFINITY, f64::min)
        };
        (0..=self.layout.columns).map(own).collect()
    }

    /// Stations whose underside adheres.
    pub(super) fn adhering_stations(&self) -> usize {
        self.mesh.stations.partition_point(|&place| place <= self.mesh.adhering)
    }
}
