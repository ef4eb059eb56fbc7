"""The JSON schema of `peel schema`, judged by a validator of its own: it takes every scene that there is, and refuses fifty
that the command refuses as well, each one change away from a scene that runs."""

import copy
import json
import subprocess
import sys
from pathlib import Path
from typing import Any, Callable

import jsonschema
import pytest

if sys.version_info < (3, 11):
    pytest.skip("tomllib came with Python 3.11", allow_module_level=True)
import tomllib

Command = Callable[..., dict[str, Any]]


@pytest.fixture(scope="module")
def schema(command: Command) -> jsonschema.Draft7Validator:
    found = command("schema", "-")
    jsonschema.Draft7Validator.check_schema(found)
    return jsonschema.Draft7Validator(found)


def test_takes_every_scene(schema: jsonschema.Draft7Validator, root: Path) -> None:
    scenes = sorted((root / "scenes").rglob("*.toml"))
    assert len(scenes) >= 50
    for scene in scenes:
        with scene.open("rb") as file:
            errors = list(schema.iter_errors(tomllib.load(file)))
        assert not errors, f"{scene}: {errors[0].json_path} {errors[0].message}"


BAD_INPUT = 2


def status(executable: Path, scene: dict[str, Any], folder: Path) -> int:
    """The exit status of the command that is given the scene, which computes two points at most."""

    def value_text(value: Any) -> str:
        if isinstance(value, dict):
            return "{ " + ", ".join(f"{name} = {value_text(of)}" for name, of in value.items()) + " }"
        if isinstance(value, list):
            return "[" + ", ".join(map(value_text, value)) + "]"
        return json.dumps(value, ensure_ascii=False)

    file = folder / "scene.toml"
    file.write_text("\n".join(f"{name} = {value_text(value)}" for name, value in scene.items()), encoding="utf-8")
    words = [str(executable), "run", str(file), "--json"]
    if "points" not in scene.get("bounds", {}):
        words += ["--set", "bounds.points=2"]
    return subprocess.run(words, capture_output=True, cwd=folder).returncode


@pytest.mark.parametrize("unit", ["nm", "um", "µm", "Å", "pm", "angstrom"])
def test_takes_what_the_parser_takes(
    schema: jsonschema.Draft7Validator, executable: Path, tmp_path: Path, unit: str
) -> None:
    scene = changed({"strip": {"length": f" +1e2{unit} "}})
    assert schema.is_valid(scene)
    assert status(executable, scene, tmp_path) != BAD_INPUT


STRIP: dict[str, Any] = {
    "title": "Strip",
    "strip": {"length": "100 nm", "height": "10 nm", "youngs_modulus": "2 GPa"},
    "adhesion": {"hamaker_constant": "1e-19 J", "equilibrium_distance": "0.4 nm"},
}
GONE = object()


def changed(change: dict[str, Any]) -> dict[str, Any]:
    """The strip with these entries changed, or removed where they are GONE."""
    scene = copy.deepcopy(STRIP)
    for name, entries in change.items():
        if entries is GONE:
            del scene[name]
        elif isinstance(entries, dict):
            table = scene.setdefault(name, {})
            for key, value in entries.items():
                if value is GONE:
                    del table[key]
                else:
                    table[key] = value
        else:
            scene[name] = entries
    return scene


PIECE = {"length": "50 nm", "width": "1 nm", "height": "5 nm"}
BEAM = {"youngs_modulus": "2 GPa"}
INPUT = {"key": "strip.height", "distribution": "normal", "mean": "10 nm", "deviation": "1 nm"}

WRONG: list[dict[str, Any]] = [
    # names
    {"tite": "a key that there is not"},
    {"stripe": {"length": "1 nm"}},
    {"strip": {"lenght": "100 nm"}},
    {"strip": {"pad_length": "100 nm"}},
    {"adhesion": {"hamaker": "1e-19 J"}},
    {"grip": {"angle": "90 deg"}},
    {"drive": {"rotation": "free"}},
    {"bounds": {"step": 3}},
    # what is missing
    {"strip": GONE},
    {"adhesion": GONE},
    {"strip": {"length": GONE}},
    {"strip": {"youngs_modulus": GONE}},
    {"adhesion": {"hamaker_constant": GONE}},
    {"adhesion": {"equilibrium_distance": GONE}},
    {"substrate": {"shape": "sphere"}},
    {"substrate": {"shape": "sinusoid", "height": "1 nm"}},
    {"time": {"density": "1000 kg/m3"}},
    {"fit": {"loss": "huber"}},
    {"uncertainty": {"samples": 1000}},
    # what does not belong together
    {"spatula": {"pad_length": "100 nm"}},
    {"substrate": {"shape": "flat", "radius": "10 nm"}},
    {"substrate": {"shape": "sphere", "radius": "10 nm", "wavelength": "3 nm"}},
    {"strip": GONE, "profile": BEAM},
    {"strip": GONE, "profile": {**BEAM, "pieces": [PIECE], "table": "s_nm,width_nm\n"}},
    # types
    {"title": 3},
    {"strip": "100 nm"},
    {"strip": {"length": 100}},
    {"strip": {"poissons_ratio": "0.3"}},
    {"adhesion": {"far_face": "yes"}},
    {"accuracy": {"elements": 16.5}},
    {"drive": {"steps": "press 1 nm"}},
    {"drive": {"steps": [1]}},
    # units
    {"strip": {"length": "100"}},
    {"strip": {"length": "100 GPa"}},
    {"strip": {"length": "100 furlong"}},
    {"strip": {"length": "1,5 nm"}},
    {"strip": {"youngs_modulus": "2 nm"}},
    {"drive": {"angle": "90"}},
    {"bounds": {"time": "3 nm"}},
    # ranges
    {"strip": {"length": "-100 nm"}},
    {"strip": {"height": "0 nm"}},
    {"strip": {"poissons_ratio": 0.6}},
    {"accuracy": {"relative": 2.0}},
    {"accuracy": {"elements": 0}},
    {"bounds": {"points": 0}},
    # words
    {"terms": "some"},
    {"grip": {"rotation": "loose"}},
    {"adhesion": {"law": "velcro"}},
    {"drive": {"steps": ["jump 3 nm"]}},
    {"path": {"until": "lunch"}},
    # values with entries of their own
    {"strip": GONE, "profile": {**BEAM, "pieces": [{**PIECE, "depth": "1 nm"}]}},
    {"strip": GONE, "profile": {**BEAM, "pieces": [{"length": "50 nm", "width": "1 nm"}]}},
    {"uncertainty": {"inputs": [{**INPUT, "distribution": "gauss"}]}},
    {"uncertainty": {"inputs": [{**INPUT, "key": "strip.color"}]}},
    {"optimise": {"objective": "beauty", "parameters": [{"key": "strip.height", "from": "1 nm", "to": "2 nm"}]}},
]


def test_there_are_fifty(schema: jsonschema.Draft7Validator, executable: Path, tmp_path: Path) -> None:
    assert len(WRONG) >= 50
    assert schema.is_valid(STRIP)
    assert status(executable, STRIP, tmp_path) != BAD_INPUT


@pytest.mark.parametrize("change", WRONG, ids=str)
def test_refuses_what_the_parser_refuses(
    schema: jsonschema.Draft7Validator, executable: Path, tmp_path: Path, change: dict[str, Any]
) -> None:
    scene = changed(change)
    assert status(executable, scene, tmp_path) == BAD_INPUT
    assert not schema.is_valid(scene)
