"""Values of a scene: texts, numbers of Python and numpy, quantities of pint.

Reference: the same value as a text with its unit. Expected: equal scenes, because a number is in the unit
that the documentation names, and pint converts others to it.
"""

from pathlib import Path
from typing import Any

import numpy as np
import pint
import pytest

import peelkit

units: Any = pint.UnitRegistry()


@pytest.mark.parametrize(
    "value",
    [50, 50.0, np.float64(50.0), np.int32(50), np.array(50.0), 50.0 * units.nm, 0.05 * units.um, "0.05 um"],
    ids=lambda value: type(value).__name__,
)
def test_a_length_is_a_text_a_number_in_nm_or_a_quantity(strip: peelkit.Scene, value: object) -> None:
    assert strip.with_("strip.length", value) == strip.with_("strip.length", "50 nm")


@pytest.mark.parametrize(
    ("key", "number", "text"),
    [
        ("strip.youngs_modulus", 3.0, "3 GPa"),
        ("adhesion.hamaker_constant", 0.2, "0.2 aJ"),
        ("drive.angle", 60.0, "60 deg"),
        ("bounds.time", 5, "5 s"),
    ],
)
def test_numbers_are_in_the_units_that_the_command_lists(
    strip: peelkit.Scene, key: str, number: float, text: str
) -> None:
    assert strip.with_(key, number) == strip.with_(key, text)


def test_quantities_of_pint_are_converted(strip: peelkit.Scene) -> None:
    for key, quantity, text in [
        ("strip.youngs_modulus", 3e9 * units.Pa, "3 GPa"),
        ("strip.youngs_modulus", 3e9 * units.kg / units.m / units.s**2, "3 GPa"),
        ("adhesion.hamaker_constant", 1e-19 * units.J, "0.1 aJ"),
        ("strip.poissons_ratio", 0.25 * units.dimensionless, 0.25),
    ]:
        assert strip.with_(key, quantity) == strip.with_(key, text)
    with pytest.raises(peelkit.SceneError, match="strip.length") as error:
        strip.with_("strip.length", 3.0 * units.GPa)
    assert error.value.key == "strip.length" and "nm" in error.value.remedy


def test_a_scene_of_tables_is_that_of_its_text(strip: peelkit.Scene) -> None:
    text = """
        title = "Strip"
        strip = { length = "100 nm", height = "10 nm", youngs_modulus = "2 GPa" }
        adhesion = { hamaker_constant = "1e-19 J", equilibrium_distance = "0.4 nm" }
    """
    assert peelkit.Scene.from_toml(text) == strip
    assert peelkit.Scene.from_toml(strip.to_toml()) == strip
    assert len({strip, peelkit.Scene.from_toml(text)}) == 1


def test_lists_and_nested_tables_are_written(strip: peelkit.Scene) -> None:
    fit = strip.with_("fit.parameters", ["strip.youngs_modulus from 1 GPa to 5 GPa"])
    assert '{ from = "1 GPa", key = "strip.youngs_modulus", to = "5 GPa" }' in fit.to_toml()
    height = {"key": "strip.height", "from": 5.0 * units.nm, "to": "12 nm"}
    free = strip.with_(
        {"optimise.objective": "peak.force_nN", "optimise.parameters": [height], "optimise.starts": np.int64(3)}
    )
    assert "starts = 3" in free.to_toml() and "12 nm" in free.to_toml()
    quoted = strip.with_("title", 'A "title"\nwith \\ and \x7f')
    assert quoted.title == 'A "title"\nwith \\ and \x7f'


def test_a_table_is_looked_for_beside_the_scene(tmp_path: Path) -> None:
    (tmp_path / "beam.csv").write_text("s_nm,width_nm,height_nm\n0,1,8\n50,1,9\n100,1,10\n", encoding="utf-8")
    path = tmp_path / "beam.toml"
    path.write_text(
        'profile = { table = "beam.csv", youngs_modulus = "2 GPa" }\n'
        'adhesion = { hamaker_constant = "1e-19 J", equilibrium_distance = "0.4 nm" }\n',
        encoding="utf-8",
    )
    scene = peelkit.Scene.read(path)
    assert "s_nm" in scene.to_toml()
    assert scene.with_("profile.youngs_modulus", "3 GPa") != scene


SCENES = Path(__file__).parents[2] / "scenes"


@pytest.mark.parametrize("path", sorted(SCENES.rglob("*.toml")), ids=lambda path: path.stem)
def test_a_scene_is_its_dictionary(path: Path) -> None:
    scene = peelkit.Scene.read(path)
    found = scene.to_dict()
    assert peelkit.Scene(**found) == scene
    # it is the caller's
    found.clear()
    assert scene.to_dict()


def test_a_key_of_a_scene_is_a_number_in_its_usual_unit(strip: peelkit.Scene) -> None:
    assert (strip["strip.length"], strip["strip.youngs_modulus"], strip["drive.angle"]) == (100.0, 2.0, 90.0)
    assert strip.with_("drive.angle", 60)["drive.angle"] == 60.0
    assert (strip["title"], strip["grip.rotation"], strip["space"]) == ("Strip", "free", False)
    points = strip["bounds.points"]
    assert isinstance(points, int) and points > 0
    for key in ("strip.length", "drive.angle", "adhesion.hamaker_constant", "accuracy.relative", "grip.rotation"):
        assert strip.with_(key, strip[key]) == strip
    for key in ("strip.lenght", "seta.forks", "bounds.displacement"):
        with pytest.raises(KeyError, match=key):
            strip[key]
