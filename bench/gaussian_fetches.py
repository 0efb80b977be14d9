#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What skin's six Gaussians cost over their texture fetches alone: gaussian_fetches.py PROGRAM FOLDER [OPTION of compare ...].

Makes a variant of the baseline whose blurs and sum look up the same texels and do nothing else (bench/gaussian_fetches), and has
`lamina compare skin_head` measure both in one run, in shuffled rounds. Prints for each backend and view the median over rounds of the
ratio of both sums of passes, with an interval of that median by order statistics, 95% from six rounds on. The fetches of both are
compared first; exit status 1 where they differ. Times count in a release build on a quiet machine alone.
"""
import json
import math
import pathlib
import statistics
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent


def fetches_alone():
    """The baseline's manifest with other shaders for blurs and sum; it tells no truth."""
    text = (ROOT / "variants/skin/six_gaussians.toml").read_text()
    head, *passes = text.split("[[pass]]\n")
    head = head.replace('name = "six_gaussians"', 'name = "fetches_alone"\neffect = "skin"').replace("baseline = true\n", "")
    kept = []
    for one in passes:
        if 'when = "truth"' in one:
            continue
        for shader in ("blur", "combine"):
            one = one.replace(f'"skin/{shader}.frag"', f'"{shader}.frag"')
        if '"blur.frag"' in one:  # which does not ask how wide it is
            one = one.replace(one[one.index('BLUR = "'):one.index("AXIS")], "")
        kept.append(one)
    return "[[pass]]\n".join([head] + kept)


def is_blur(name):
    return name == "combine" or name.startswith(("across_", "along_"))


def blurs(cell):
    return [one for one in cell["passes"] if is_blur(one["name"])]


def interval(values):
    """Of the median, at least 95% sure, by order statistics (binomial)."""
    ordered, n = sorted(values), len(values)
    low = n // 2
    while low > 0 and sum(math.comb(n, k) for k in range(low + 1)) / 2**n > 0.025:
        low -= 1
    return ordered[low], ordered[n - 1 - low]


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    program, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    mine, out = folder / "fetches_alone", folder / "run"
    mine.mkdir(parents=True, exist_ok=True)
    (mine / "fetches_alone.toml").write_text(fetches_alone())
    for shader in ("blur", "combine"):
        (mine / f"{shader}.frag").write_text((ROOT / f"bench/gaussian_fetches/{shader}.frag").read_text())
    options = sys.argv[3:] or ["--size", "64x64"]
    subprocess.run([program, "compare", "skin_head", "--variants-dir", mine, "--variant", "six_gaussians", "--variant", "fetches_alone",
                    "--truth-rays", "0", "--out", out, *options], stdout=subprocess.DEVNULL, check=False)
    cells = {}
    for line in (out / "record.jsonl").read_text().splitlines():
        row = json.loads(line)
        if row["kind"] == "cell" and row["effect"] == "skin":
            if row["status"] != "ok":
                sys.exit(f"{row['variant']} on {row['backend']}: {row['reason']}")
            cells[row["backend"], row["view"], row["variant"]] = row
    status = 0
    for (backend, view, variant), whole in cells.items():
        if variant != "six_gaussians":
            continue
        alone = cells[backend, view, "fetches_alone"]
        for one, other in zip(blurs(whole), blurs(alone), strict=True):
            if one["name"] != other["name"] or one["fetches"] != other["fetches"]:
                print(f"{backend} {view}: {one['name']} fetches {one['fetches']}, {other['name']} {other['fetches']}")
                status = 1
        rounds = [sum(times) for times in zip(*(one["ms"] for one in blurs(whole)))]
        alone_rounds = [sum(times) for times in zip(*(one["ms"] for one in blurs(alone)))]
        ratios = [a / b for a, b in zip(rounds, alone_rounds)]
        if not ratios:
            print(f"{backend} {view}: not timed")
            continue
        low, high = interval(ratios)
        print(f"{backend} {view}: six Gaussians {statistics.median(rounds):.2f} ms, their fetches alone "
              f"{statistics.median(alone_rounds):.2f} ms, ratio {statistics.median(ratios):.3f} [{low:.3f}, {high:.3f}], "
              f"{len(ratios)} rounds")
    sys.exit(status)


if __name__ == "__main__":
    main()
