"""What a result holds: arrays of numpy, located points, states, pictures.

Reference: `summary()`, which is that of the command. Expected: attributes are its numbers, None where it has
null; arrays own no copy of their memory; pictures stand on axes that are given.
"""

from xml.etree import ElementTree

import matplotlib
import numpy as np
import pytest

import peelkit

matplotlib.use("Agg")


def test_points_are_those_of_the_summary(peel: peelkit.Peel) -> None:
    summary = peel.summary()
    peak, first = peel.peak, peel.initiation_peak
    assert peak is not None and first is not None
    assert (peak.force, peak.error, peak.force_error) == (summary["peak"]["force_nN"],) + 2 * (
        summary["peak"]["error_nN"],
    )
    assert peak.displacement == summary["peak"]["displacement_nm"]
    assert peel.end == summary["end"] and peel.reason is None
    assert [at.force for at in peel.limit_points] == [at["force_nN"] for at in summary["limit_points"]]
    assert [at.kind for at in peel.limit_points] == [at["kind"] for at in summary["limit_points"]]
    jump = peel.first_jump
    assert jump is not None and jump.work == summary["first_jump"]["work_aJ"]
    assert (peel.plateau is None) == (summary["plateau"] is None)
    # it is the caller's
    summary["peak"] = None
    assert peel.peak == peak


def test_what_does_not_occur_is_none(strip: peelkit.Scene) -> None:
    with pytest.warns(peelkit.ComputationWarning, match="bounds.points = 3"):
        peel = strip.with_("bounds.points", 3).run()
    assert peel.peak is None and peel.first_jump is None and peel.detachment is None
    assert "no peak" in repr(peel)


def test_columns_are_arrays(peel: peelkit.Peel) -> None:
    curve = peel.curve
    assert curve.force.dtype == np.float64 and curve.negative_eigenvalues.dtype == np.int64
    assert not curve.force.flags.owndata and curve.force.flags.writeable
    assert curve is peel.curve and curve["force"] is curve.force and "torque" not in curve
    assert len(curve.force) == peel.summary()["path"]["points"]
    assert list(curve.to_pandas())[:2] == ["displacement_nm", "force_nN"]


def test_stations_have_exactly_what_was_asked(peel: peelkit.Peel) -> None:
    """Of `verification/stations.csv`, a collocation without finite elements: the strip of 100 nm at u = 30 nm."""
    before, behind = peel.at(displacement=30.0)[:2]
    for found, force in [(before, 0.0504094198094), (behind, 0.0124050647891)]:
        assert found.displacement == pytest.approx(30.0, abs=1e-9)
        assert found.error is not None and abs(found.force - force) <= found.error
    assert (before.stable, behind.stable) == (True, False)
    assert peel.at(force="0.04 nN")[1].displacement == pytest.approx(47.6567102566, rel=1e-7)
    assert peel.at(end_rotation="30 deg")[0].displacement == pytest.approx(19.5215706734, rel=1e-6)
    assert peel.at(front=1e6) == []
    asked = peel.scene.with_("output.stations", {"displacement": ["30 nm"]}).run().summary()["stations"]
    assert [at["force_nN"] for at in asked[0]["found"]] == [at.force for at in peel.at(displacement=30.0)]
    with pytest.raises(peelkit.PeelkitError, match="which is none of"):
        peel.at(place=3.0)
    with pytest.raises(peelkit.PeelkitError, match="not a force"):
        peel.at(force="3 nm")
    with pytest.raises(peelkit.PeelkitError, match="2 values"):
        peel.at(force=1.0, front=3.0)


def test_a_number_of_the_fields_passes_a_value_where_the_quantity_does_that_it_equals(peel: peelkit.Peel) -> None:
    """The gap of the free end by name, and by a function of the fields; a product of two numbers, which has no name."""
    gap = peel.at(free_end_gap=0.25)
    own = peel.where(lambda state: float(state["gap_nm"][0]), 0.25)
    assert len(own) == len(gap) > 0
    for found, named in zip(own, gap, strict=True):
        assert found.displacement == pytest.approx(named.displacement, rel=1e-7)
    both = peel.where(lambda state: state.force * state.displacement, 1.0)
    assert both and all(at.force * at.displacement == pytest.approx(1.0, rel=1e-8) for at in both)
    rising = peel.where(lambda state: state.force * state.displacement, 1.0, ">")
    falling = peel.where(lambda state: state.force * state.displacement, 1.0, "<")
    assert len(rising) + len(falling) == len(both)
    with pytest.raises(peelkit.PeelkitError, match="none of"):
        peel.where(lambda state: state.force, 1.0, "up")
    with pytest.raises(ZeroDivisionError):
        peel.where(lambda state: 1.0 / 0.0)
    with pytest.raises(KeyError):
        peel.where(lambda state: float(state["no_such_field"][0]))
    with pytest.raises(peelkit.ComputationError):
        peel.where(lambda state: float("nan"))


def test_a_path_ends_where_a_number_of_the_fields_passes_zero(strip: peelkit.Scene, peel: peelkit.Peel) -> None:
    def product(state: peelkit.State) -> float:
        return state.force * state.displacement - 1.0

    stopped = strip.run(stop_where=product)
    last = stopped.curve.force[-1] * stopped.curve.displacement[-1]
    assert (stopped.end, last) == ("event", pytest.approx(1.0, rel=1e-8))
    assert stopped.reason is not None and "stop_where" in stopped.reason
    count = len(stopped.curve.force) - 1
    assert count > 0 and list(stopped.curve.force[:count]) == list(peel.curve.force[:count])
    with pytest.raises(ZeroDivisionError):
        strip.run(stop_where=lambda state: 1.0 / 0.0)


def test_states_are_in_equilibrium(peel: peelkit.Peel) -> None:
    """The adhesion of a free strip carries the force of the grip: the integral of the line force is P."""
    states = peel.states(4)
    assert sum(state.limit_point is not None for state in states) == len(peel.limit_points)
    assert (states[0].path_position, states[-1].path_position) == (0.0, 1.0)
    for state in states:
        held = float(np.sum(state["weight_nm"] * state["line_force_nN_per_nm"]))
        assert held == pytest.approx(state.force, abs=1e-6)
        assert state.x.shape == state.y.shape
    assert len(peel.states()) == len(peel.limit_points)
    with pytest.raises(peelkit.PeelkitError, match="out of range"):
        peel.states(-1)


def test_a_test_jumps_at_the_first_displacement_limit_point(strip: peelkit.Scene, peel: peelkit.Peel) -> None:
    test, jump = strip.test(), peel.first_jump
    assert jump is not None and test.jumps
    before = test.jumps[0]["before"]
    assert before["displacement_nm"] == pytest.approx(jump.displacement, rel=1e-6)
    assert test.pull_off_force is not None and test.jump.dtype == np.bool_
    assert set(test.branch.tolist()) == {"retreat", "approach"}
    assert test.hysteresis is None or test.hysteresis > 0.0


def test_a_picture_takes_axes(peel: peelkit.Peel, strip: peelkit.Scene) -> None:
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(1, 2)
    assert peel.plot(axes[0], color="C3", label="strip") is axes[0]
    lines = axes[0].get_lines()
    assert {line.get_color() for line in lines} == {"C3"}
    assert {line.get_linestyle() for line in lines} == {"-", "--"}
    assert [text.get_text() for text in axes[0].legend().get_texts()] == ["strip"]
    assert strip.test().plot(axes[1]) is axes[1]
    plt.close(figure)
    figure = plt.figure()
    assert peel.plot() is figure.gca()
    plt.close(figure)
    svg = peel._repr_svg_()
    assert svg is not None and svg.startswith("<svg") and "Strip" in svg


def test_a_path_is_driven_point_by_point(strip: peelkit.Scene) -> None:
    forces = []
    for point in strip.path(step_tolerance=5e-3):
        forces.append(point.force)
        if point.negative_eigenvalues_load > 0:
            break
    peak = strip.run().initiation_peak
    assert peak is not None
    # the peak is behind the last stable point
    assert len(forces) > 3 and max(forces) <= peak.force * (1.0 + 1e-6)
    path = strip.path()
    first = next(path)
    assert (iter(path) is path) and first.negative_eigenvalues == 0
    assert next(path).displacement > first.displacement


def test_a_path_that_is_iterated_ends_where_the_run_does(strip: peelkit.Scene) -> None:
    path = strip.path()
    points = list(path)
    # the last point is the first beyond the end: there the force has come back to zero
    assert path.end == strip.run().end == "pivoting"
    assert points[-1].force <= 0.0 < points[-2].force
    assert next(path, None) is None
    with pytest.warns(peelkit.ComputationWarning, match="goes on"):
        assert len(list(strip.with_("bounds.points", 5).path())) == 5


def test_a_curve_as_an_array_has_its_numbers(strip: peelkit.Scene) -> None:
    curve = strip.run().curve
    array = np.asarray(curve)
    assert array.dtype == np.float64 and array.shape == (len(curve.force), len(curve))
    assert (array[:, list(curve).index("force")] == curve.force).all()
    assert np.asarray(curve, dtype=np.float32).dtype == np.float32
    with pytest.raises(ValueError, match="copy"):
        curve.__array__(copy=False)


def test_the_steps_before_a_pull_are_arrays(strip: peelkit.Scene) -> None:
    steps = strip.with_({"drive.steps": ["lift 10 nm", "press 4 nm"]}).run().steps
    assert sorted(set(steps.step.tolist())) == [1, 2]
    assert steps.displacement.max() == pytest.approx(10.0) and steps.displacement[-1] == pytest.approx(6.0)
    assert (steps.displacement == steps.y).all() and (steps.force == steps.vertical_force).all()
    assert "z" not in steps and len(strip.run().steps.force) == 0


def cells(html: str) -> list[list[str]]:
    """The cells of a table of HTML, row by row."""
    table = ElementTree.fromstring(html[html.index("<table>") :])
    return [["".join(cell.itertext()) for cell in row] for row in table.iter("tr")]


def test_a_notebook_shows_tables(peel: peelkit.Peel, strip: peelkit.Scene) -> None:
    shown = dict(cells(strip._repr_html_()))
    assert shown["strip.length"] == "100 nm" and shown["title"] == "Strip"
    assert "&lt;b&gt;" in strip.with_("title", "<b>")._repr_html_()
    peak = peel.peak
    assert peak is not None
    assert dict(cells(peel._repr_html_()))["peak.force_nN"] == f"{peak.force:.6g}"
    assert peel._repr_html_().startswith("<svg")
    head, first, *rest = cells(peel.curve._repr_html_())
    assert head[:3] == ["", "displacement (nm)", "force (nN)"] and len(head) == len(first) == 1 + len(peel.curve)
    assert first[0] == "0" and len(rest) == 9 and rest[-1][0] == str(len(peel.curve.force) - 1)
    test = strip.test()
    assert dict(cells(test._repr_html_()))["end"] == test.end
    seta = peelkit.Scene(
        seta={"forks": 1}, spatula={}, adhesion={"hamaker_constant": "1e-19 J", "equilibrium_distance": "0.4 nm"}
    ).pull_off()
    assert dict(cells(seta._repr_html_()))["tips"] == "2"


def test_a_curve_is_a_dataset_with_units(peel: peelkit.Peel) -> None:
    pytest.importorskip("xarray")
    curve = peel.curve
    dataset = curve.to_xarray()
    assert list(dataset.data_vars) == list(curve) and dataset.force.dims == ("point",)
    assert dataset.force.attrs == {"units": "nN"} and dataset.newton_iterations.attrs == {"units": "1"}
    assert (dataset.force.values == curve["force"]).all()
