"""What is wrong with a scene is an exception with the key, the value and what would be right.

Reference: the messages of the command. Expected: the same words, the place where a file was read, and the
parts of the message as attributes, also behind a pickle.
"""

import pickle
import warnings
from pathlib import Path

import pytest
from matplotlib.figure import Figure

import peelkit


def test_a_value_that_is_refused(strip: peelkit.Scene) -> None:
    with pytest.raises(peelkit.SceneError) as refused:
        strip.with_("strip.length", "50")
    error = refused.value
    assert isinstance(error, (peelkit.PeelkitError, ValueError))
    assert (error.key, error.value, error.place) == ("strip.length", "50", None)
    assert error.remedy.startswith('Write "50 nm" if nm is meant.')
    assert str(error) == f'`strip.length` is "50", a number without a unit\n{error.remedy}'
    again = pickle.loads(pickle.dumps(error))
    assert (str(again), again.key, again.value) == (str(error), error.key, error.value)


def test_a_key_that_there_is_not() -> None:
    with pytest.raises(peelkit.SceneError) as refused:
        peelkit.Scene(strip=dict(lenght="100 nm"))
    assert (refused.value.key, refused.value.value) == ("strip.lenght", None)
    assert refused.value.remedy == "Did you mean `length`?"
    # the text that the tables were written as is nobody's
    assert "line" not in str(refused.value)


def test_a_file_names_its_line(tmp_path: Path) -> None:
    path = tmp_path / "a.toml"
    path.write_text("[strip]\nlength = -3\n", encoding="utf-8")
    with pytest.raises(peelkit.SceneError) as refused:
        peelkit.Scene.read(path)
    assert refused.value.place == f"{path}, line 2"
    assert str(refused.value).startswith(f"{path}, line 2: `strip.length` is -3")
    path.write_bytes(b"title = 'a'\n\xff")
    with pytest.raises(peelkit.SceneError, match="line 2: this is not text in UTF-8"):
        peelkit.Scene.read(path)
    with pytest.raises(FileNotFoundError):
        peelkit.Scene.read(tmp_path / "b.toml")


@pytest.mark.parametrize("value", [None, object(), float("nan"), float("inf"), b"50 nm"])
def test_a_value_that_is_none(strip: peelkit.Scene, value: object) -> None:
    with pytest.raises(peelkit.SceneError) as refused:
        strip.with_("strip.length", value)
    assert refused.value.key == "strip.length" and refused.value.remedy


def test_what_stopped_short_is_returned_with_a_warning(strip: peelkit.Scene) -> None:
    """A strip that is too soft for its adhesion has no stable state at rest: there is nothing to peel."""
    with pytest.warns(peelkit.ComputationWarning, match="stopped short: .*1.7620 times"):
        peel = strip.with_("strip.youngs_modulus", "5 MPa").run()
    assert (peel.end, peel.peak, len(peel.curve.force)) == ("refused", None, 0)
    assert peel._repr_svg_() is None and peel.states(3) == []
    assert not peel.plot(Figure().subplots()).get_lines()
    again = pickle.loads(pickle.dumps(peel))
    assert again.end == "refused" and again.states(3) == []
    with pytest.raises(peelkit.ComputationError, match="1.7620 times"):
        peel.raise_for_failure()


def test_a_bound_of_the_scene_is_no_failure(strip: peelkit.Scene) -> None:
    poor = strip.with_({"bounds.points": 5})
    with pytest.warns(peelkit.ComputationWarning, match="the path goes on: bounds.points = 5"):
        peel = poor.run()
    assert (peel.end, len(peel.curve.force)) == ("bound", 5)
    peel.raise_for_failure()


def test_a_path_that_is_followed_as_far_as_was_asked_is_whole(strip: peelkit.Scene) -> None:
    whole = strip.with_("path.until", "first-jump")
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        peel = whole.run()
        assert len(list(whole.path())) > 3
    assert peel.end == "bound" and peel.peak is not None
    peel.raise_for_failure()


def test_a_scene_says_what_an_analysis_lacks(strip: peelkit.Scene) -> None:
    with pytest.raises(peelkit.SceneError, match="optimise"):
        peelkit.optimise(strip)
    with pytest.raises(peelkit.SceneError, match="uncertainty"):
        peelkit.uncertainty(strip)
    with pytest.raises(peelkit.SceneError):
        peelkit.fit(strip, [1.0, 2.0, 3.0, 4.0], [0.1, 0.2, 0.3, 0.2])
    with pytest.raises(TypeError, match="force"):
        peelkit.fit(strip, [1.0, 2.0])
    with pytest.raises(peelkit.SceneError, match="terms"):
        strip.with_("terms", "auto").sensitivities()
    with pytest.raises(peelkit.SceneError, match="elements"):
        strip.path(elements=0)
