# SPDX-License-Identifier: Apache-2.0
"""Holds files against the JSON Schemas that `lamina schema` makes: validate.py PROGRAM SOURCE RECORDS...

The tree's own files and the records must pass; files with one mistake each must not, and the program must refuse them too.
"""
import json
import pathlib
import subprocess
import sys
import tempfile
import tomllib

import jsonschema

program, source, records = sys.argv[1], pathlib.Path(sys.argv[2]), sys.argv[3:]
failures = []


def mistakes(validator, value):
    return [f"{'.'.join(map(str, error.absolute_path))}: {error.message[:200]}" for error in validator.iter_errors(value)]


def expect_valid(validator, value, name):
    for mistake in mistakes(validator, value):
        failures.append(f"{name}: {mistake}")


def read(file):
    return tomllib.loads(file.read_text())


own = ["--variants-dir", str(source / "tests/data/effects"), "--variants-dir", str(source / "examples/effect")]
validators = {}
with tempfile.TemporaryDirectory() as made:
    subprocess.run([program, "schema", "--out", made, *own], check=True)
    for file in sorted(pathlib.Path(made).iterdir()):
        schema = json.loads(file.read_text())
        jsonschema.Draft7Validator.check_schema(schema)
        validators[file.name.removesuffix(".schema.json")] = jsonschema.Draft7Validator(schema)
counts = dict.fromkeys(validators, 0)


def check(kind, value, name):
    counts[kind] += 1
    expect_valid(validators[kind], value, name)


# Every TOML file of the tree, by what it is.
for file in sorted([*source.glob("variants/**/*.toml"), *source.glob("shaders/**/*.toml"), *source.glob("tests/data/**/*.toml"),
                    *source.glob("examples/**/*.toml")]):
    value = read(file)
    kinds = {"effect": "effect", "variant": "manifest", "family": "family", "scene": "scene", "default": "gate", "limit": "gate"}
    kind = next((kinds[key] for key in ("effect", "variant", "family", "default", "limit", "scene") if key in value), None)
    if kind is None:
        failures.append(f"{file}: is none of the kinds of files")
    else:
        check(kind, value, file)

for record in records:
    for number, line in enumerate(pathlib.Path(record).read_text().splitlines(), 1):
        check("record", json.loads(line), f"{record}:{number}")

for kind, least in {"scene": 5, "manifest": 50, "effect": 8, "family": 10, "gate": 1, "record": 10}.items():
    if counts[kind] < least:
        failures.append(f"{counts[kind]} files of kind {kind} were looked at, at least {least} are there")

# One mistake each: the schema marks it, and the program refuses it with status 2.
SCENE = '[scene]\nbuiltin = "heart"\n'
MANIFEST = ('[variant]\nname = "mine"\neffect = "layered_material"\n[[pass]]\nname = "composite"\ndraw = "objects"\n'
            'vertex = "common/object.vert"\nfragment = "surface/lambert.frag"\nwrite = ["frame"]\n')
EFFECT = (source / "tests/data/effects/lantern/effect.toml").read_text()
GATE = "[default]\nmin_ssim = 0.9\n"
WRONG = {
    "scene": [SCENE.replace("builtin", "biultin"), SCENE.replace('"heart"', '"hart"'), SCENE + "time = 1e9\n",
              SCENE + "[objects.heart]\nthickness = -1\n", SCENE + '[objects.heart]\nthickness = "thin"\n',
              SCENE + "[objects.heart]\nposition = [0, 1]\n", SCENE + '[lights.a]\nkind = "pint"\n',
              SCENE + '[lights.a]\nkind = "point"\nposition = [0, 0, 0]\ndirection = [0, 0, 1]\n',
              SCENE + "[views.a]\neye = [0, 0, 1]\n", SCENE + "[objects.heart.outer]\nalbdeo = [1, 1, 1]\n",
              SCENE + "[effects.volume_fog]\ndensity = -1\n", SCENE + "[effects.nothing]\nx = 1\n",
              SCENE + "background = [0, 0, 1e6]\n", "[objects.heart]\nthickness = 1\n"],
    "manifest": [MANIFEST.replace('name = "mine"\n', ""), MANIFEST.replace('"objects"', '"object"'),
                 MANIFEST.replace('draw = "objects"\n', ""), MANIFEST + 'blend = "addtive"\n', MANIFEST + "repeat = 5000\n",
                 MANIFEST + "clear = [0, 0, 0]\n", MANIFEST + "colour = 1\n", MANIFEST + "clear_depth = 2\n",
                 MANIFEST + '[targets.t]\nformat = "rgba8"\n', MANIFEST + '[targets.t]\nformat = "r8_unorm"\nbuffers = 3\n',
                 MANIFEST + "[parameters.p]\nmin = 1\n", MANIFEST.split("[[pass]]")[0]],
    "effect": [EFFECT.replace("[effect]\n", "[effect]\nordr = 1\n"), EFFECT.replace("[effect]\n", '[effect]\nbake = "nobody"\n'),
               EFFECT.replace("[effect]\n", '[effect]\nsolid = "no"\n'), EFFECT + "[numbers.x]\nrange = [1]\n",
               EFFECT + '[textures.x]\nmeaning = "color"\n', EFFECT + '[features.X]\nneeds = ["a"]\n'],
    "gate": [GATE + "min_sim = 1\n", GATE.replace("0.9", "2"), GATE + '[[limit]]\nvariant = "nobody"\nmin_ssim = 0.5\n',
             GATE + 'times = "perhaps"\n', GATE + 'max_slowdown = "a little"\n', GATE + "same_image = 1\n"],
}


def refusal(kind, folder, text):
    """What the program says of the text as a file of that kind, and its status."""
    reads_variants = ["schema", "--out", folder / "schemas"]  # and neither makes a scene nor looks for devices
    (folder / "variants").mkdir()
    if kind == "scene":
        (folder / "mine.toml").write_text(text)
        command = ["plan", folder / "mine.toml"]
    elif kind == "manifest":
        (folder / "variants/mine.toml").write_text(text)
        command = [*reads_variants, "--variants-dir", folder / "variants"]
    elif kind == "effect":
        (folder / "variants/lantern").mkdir()
        for file in (source / "tests/data/effects/lantern").iterdir():
            if file.is_file():
                (folder / "variants/lantern" / file.name).write_bytes(file.read_bytes())
        (folder / "variants/lantern/effect.toml").write_text(text)
        command = [*reads_variants, "--variants-dir", folder / "variants"]
    else:
        (folder / "gate.toml").write_text(text)
        command = ["gate", source / "tests/data/scenes/square.toml", "--limits", folder / "gate.toml", "--against", source, "--out", folder / "out", "--size", "16x16",
                   "--no-time"]
    ran = subprocess.run([program, *map(str, command)], capture_output=True, text=True)
    return ran.returncode, ran.stderr


for kind, right in {"scene": SCENE, "manifest": MANIFEST, "effect": EFFECT, "gate": GATE}.items():
    expect_valid(validators[kind], tomllib.loads(right), f"the {kind} that has no mistake")
for kind, texts in WRONG.items():
    for number, text in enumerate(texts):
        if not mistakes(validators[kind], tomllib.loads(text)):
            failures.append(f"the schema of kind {kind} lets this pass:\n{text}")
        if number % 4:   # the program is asked for a quarter: each takes a second with sanitizers
            continue
        with tempfile.TemporaryDirectory() as folder:
            status, said = refusal(kind, pathlib.Path(folder), text)
            if status != 2 or ".toml" not in said:
                failures.append(f"the program does not refuse this {kind} with status 2 and a file ({status}: {said}):\n{text}")

# A record with a mistake.
for line in ('{"kind":"run"}', '{"kind":"run","schema":2}', '{"kind":"sell"}', '{"schema":1}',
             '{"kind":"phase","backend":"vulkan","effect":"x","rounds":-1,"wall_ms":1,"device_ms":1}',
             '{"kind":"phase","backend":"vulkan","effect":"x","wall_ms":1,"device_ms":1}'):
    if not mistakes(validators["record"], json.loads(line)):
        failures.append(f"the schema of records lets this pass: {line}")

print(", ".join(f"{count} of kind {kind}" for kind, count in counts.items()))
for failure in failures:
    print(failure, file=sys.stderr)
sys.exit(1 if failures else 0)
