# SPDX-License-Identifier: Apache-2.0
"""Prints the commands of a CI file as one bash script, as the system would run them: steps.py github|gitlab FILE push|pull_request.

Each step becomes a process of its own (GitHub) or a line of one (GitLab), stops at its first failure, and is named before it runs.
A condition that is not known here stops with status 2, so that no step is left out in silence.
"""
import shlex
import sys

import yaml

# `if` of a GitHub step: the events on which it runs in a job that goes well.
CONDITIONS = {
    None: {"push", "pull_request"},
    "${{ !cancelled() }}": {"push", "pull_request"},
    "${{ !cancelled() && steps.build.outcome == 'success' }}": {"push", "pull_request"},
    "${{ !cancelled() && steps.build.outcome == 'success' && github.event_name == 'push' }}": {"push"},
}


def github(workflow, event):
    for job in workflow["jobs"].values():
        for step in job["steps"]:
            name = step.get("name") or step["uses"]
            if step.get("if") not in CONDITIONS:
                print(f"steps.py: step '{name}': unknown condition {step['if']!r}; add it to CONDITIONS", file=sys.stderr)
                sys.exit(2)
            if event not in CONDITIONS[step.get("if")]:
                continue
            if "run" in step:
                yield name, "bash -e -o pipefail -c " + shlex.quote(step["run"])
            else:
                yield f"{name} (not run here)", ":"


def gitlab(workflow, event):
    for job in workflow.values():
        for line in job.get("before_script", []) + job["script"]:
            yield line.splitlines()[0], line


def main():
    system, file, event = sys.argv[1:]
    with open(file) as stream:
        workflow = yaml.safe_load(stream)
    steps = {"github": github, "gitlab": gitlab}[system](workflow, event)
    print("set -e -o pipefail")
    for name, command in steps:
        print("echo", shlex.quote(f"==> {name}"))
        print(command)


if __name__ == "__main__":
    main()
