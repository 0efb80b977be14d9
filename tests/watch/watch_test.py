# SPDX-License-Identifier: Apache-2.0
"""A person writes a shader under `lamina compare --watch`: watch_test.py PROGRAM SCENE

The page gets the new picture, the compiler's words with the last good picture, the picture of what was mended; Ctrl-C leaves a record.
"""
import json
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import time

program, scene = sys.argv[1:]
MANIFEST = """[variant]
name = "mine"
effect = "layered_material"
[[pass]]
name = "composite"
draw = "objects"
vertex = "common/object.vert"
fragment = "mine.frag"
write = ["frame"]
depth = "read_write"
"""
SHADER = """#include "common/frame.glsl"
#include "common/surface.glsl"
#include "common/mesh_in.glsl"
layout(location = 0) out vec4 color;
void main() { color = vec4(RED, 0.5, 0.25, 1.0); }
"""


def check(holds, what):
    if not holds:
        raise AssertionError(what)


with tempfile.TemporaryDirectory() as folder:
    folder = pathlib.Path(folder)
    mine, out = folder / "mine", folder / "out"
    mine.mkdir()
    (mine / "mine.toml").write_text(MANIFEST)
    (mine / "mine.frag").write_text(SHADER.replace("RED", "0.25"))
    watch = subprocess.Popen([program, "compare", scene, "--watch", "--variants-dir", mine, "--variant", "mine", "--size", "48x48",
                              "--backend", "vulkan", "--out", out], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)

    def page_of(generation):
        """The page of this change, once it is there."""
        end = time.monotonic() + 120
        while time.monotonic() < end:
            if watch.poll() is not None:
                raise AssertionError(f"ended with {watch.returncode}: {watch.stdout.read()}")
            if (out / "watch.js").exists() and f"({generation})" in (out / "watch.js").read_text():
                return (out / "watch.html").read_text()
            time.sleep(0.05)
        raise AssertionError(f"no page {generation}")

    def picture_of(page):
        section = page[page.index("<h2>mine "):]
        return (out / re.search(r'<img src="\./([^?"]+)', section).group(1)).read_bytes()

    try:
        first = page_of(1)
        check("pre class=\"failure\"" not in first, "the first page has a mistake")
        check("fetches" in first and "SSIM" in first, "no counts or errors")
        before = picture_of(first)

        (mine / "mine.frag").write_text(SHADER.replace("RED", "0.75"))
        second = page_of(2)
        check("mine.frag changed" in second, "the page does not name the file")
        check(picture_of(second) != before, "the picture is the old one")
        check(second.count('class="fresh"') == 1, "only what changed is drawn again")
        good = picture_of(second)

        (mine / "mine.frag").write_text(SHADER.replace("RED", "rde"))
        third = page_of(3)
        check("mine.frag:5" in third and "rde" in third, "the compiler's words are not there")
        check("last good one" in third and picture_of(third) == good, "the last good picture is not there")

        (mine / "mine.toml").write_text(MANIFEST.replace('"objects"', '"object"'))
        fourth = page_of(4)
        check("mine.toml:6" in fourth and "did you mean" in fourth, "a manifest's mistake is not said")
        check(picture_of(fourth) == good, "the picture is gone")

        (mine / "mine.toml").write_text(MANIFEST)
        (mine / "mine.frag").write_text(SHADER.replace("RED", "0.5"))
        for generation in (5, 6):   # the two files may be seen together
            mended = page_of(generation)
            if "pre class=\"failure\"" not in mended:
                break
        check("pre class=\"failure\"" not in mended and picture_of(mended) not in (good, before), "the mended picture is not there")
    except BaseException:
        watch.kill()
        raise
    watch.send_signal(signal.SIGINT)
    said, _ = watch.communicate(timeout=120)
    check(watch.returncode == 0, f"status {watch.returncode}: {said}")
    lines = [json.loads(line) for line in (out / "record.jsonl").read_text().splitlines()]
    cells = [line for line in lines if line["kind"] == "cell"]
    check([cell["variant"] for cell in cells] == ["light_map", "mine"], f"cells {cells}")
    check(all(cell["status"] == "ok" and cell["fetches"] is not None for cell in cells), "a cell is not well")
    check((out / "index.html").exists() and "report:" in said, "no report")

# What cannot be: one message and status 2.
for arguments, words in ((["--view", "front"], "--watch"), (["--watch", "--view", "frnt"], "did you mean 'front'"),
                         (["--watch", "--variant", "nobody"], "unknown variant")):
    ran = subprocess.run([program, "compare", scene, "--size", "16x16", "--backend", "vulkan", *arguments, "--out", "/tmp/unused"],
                         capture_output=True, text=True)
    check(ran.returncode == 2 and words in ran.stderr + ran.stdout, f"{arguments}: {ran.returncode}: {ran.stderr}")
