# SPDX-License-Identifier: Apache-2.0
"""A record as pandas tables: read_record.py FOLDER_OR_RECORD

Prints, for each variant on each backend, the frame's time, its ratio to the baseline, fetches a pixel and SSIM, over all views.
'lamina schema record' says what every line may hold.
"""
import json
import pathlib
import sys

import pandas as pd

path = pathlib.Path(sys.argv[1])
if path.is_dir():
    path /= "record.jsonl"
lines = [json.loads(line) for line in path.read_text().splitlines()]
run = lines[0]
print(f"{run['command']}: lamina {run['lamina']}, commit {run['commit']}, build {run['build']}")

# One row a cell; what lies deeper gets a name with dots: "error.baseline.ssim".
cells = pd.json_normalize([line for line in lines if line["kind"] == "cell"])
if cells.empty:
    sys.exit(f"{path}: holds no cells")
cells = cells[cells["status"] == "ok"]
columns = ["median_ms", "ratio_to_baseline.median", "fetches_per_pixel", "error.baseline.ssim"]
names = ["effect", "variant", "backend"]
cells = cells.reindex(columns=[*names, *columns]).astype(dict.fromkeys(columns, float))   # what is not known becomes NaN
print(cells.groupby(names, sort=False)[columns].mean().to_string(float_format="%.4f", na_rep="-"))

# Every sample of every pass, in the order of its rounds: for tests and plots of your own.
passes = pd.DataFrame([
    {"variant": cell["variant"], "backend": cell["backend"], "view": cell["view"], "pass": one["name"], "round": round_, "ms": ms}
    for cell in lines if cell["kind"] == "cell"
    for one in cell["passes"]
    for round_, ms in enumerate(one["ms"])
])
print(f"{len(passes)} samples of passes")
