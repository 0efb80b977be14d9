#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Runs the steps of github.yml and gitlab.yml here, in order, in a fresh clone of this repository's last commit: first as a push to the
# main branch, which leaves a baseline, then as a pull request. Stops at the first step that fails, with its status.
#   examples/ci/try.sh [github|gitlab]...      both, where none is named
# Steps that only the CI system can do (checkout, cache, artifacts) are named and left out: the folders stay where they are. The clone
# and its build stay in TRY_FOLDER, if that is set, and are used again.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
repository=$(git -C "$here" rev-parse --show-toplevel)
python3 -c 'import yaml' 2>/dev/null || { echo "try.sh: python3-yaml is missing; install Debian's package of that name" >&2; exit 2; }

scratch=${TRY_FOLDER:-$(mktemp -d)}
mkdir -p "$scratch"
scratch=$(cd "$scratch" && pwd)
[ -n "${TRY_FOLDER:-}" ] || trap 'rm -rf "$scratch"' EXIT
export HOME=$scratch/home CI=true   # settings that the steps make are not to reach the user's own
mkdir -p "$HOME"

# An origin with the last commit as a pull request, and the one before it as the main branch.
commit=$(git -C "$repository" rev-parse HEAD)
rm -rf "$scratch/origin.git"
git clone -q --bare "$repository" "$scratch/origin.git"
git -C "$scratch/origin.git" update-ref refs/heads/pull-request "$commit"
git -C "$scratch/origin.git" update-ref refs/heads/main "$commit^"
[ -d "$scratch/lamina" ] || git clone -q --no-checkout "$scratch/origin.git" "$scratch/lamina"
cd "$scratch/lamina"
git fetch -q --force origin '+refs/heads/*:refs/remotes/origin/*'
git checkout -q --detach "$commit"

# try SYSTEM EVENT [NAME=VALUE...]
try() {
  local system=$1 event=$2 script
  shift 2
  rm -rf build/base && git worktree prune
  echo "=== $system.yml, $event"
  script=$(python3 examples/ci/steps.py "$system" "examples/ci/$system.yml" "$event")
  local status=0
  env "$@" bash -c "$script" || status=$?
  [ "$status" -eq 0 ] || { [ "$system" = gitlab ] && [ "$status" -eq 3 ]; } || exit "$status"   # gitlab.yml allows 3
  echo "=== $system.yml, $event: well$([ "$status" -eq 0 ] || echo ', ambiguous')"
}

if [ $# -eq 0 ]; then set -- github gitlab; fi
for system in "$@"; do
  rm -rf lamina-baseline
  case $system in
    github)
      actions=(GITHUB_ACTIONS=true GITHUB_STEP_SUMMARY="$scratch/summary.md")
      try github push "${actions[@]}"
      try github pull_request "${actions[@]}" GITHUB_BASE_REF=main
      ;;
    gitlab)
      try gitlab push GITLAB_CI=true CI_DEFAULT_BRANCH=main CI_COMMIT_BRANCH=main
      try gitlab pull_request GITLAB_CI=true CI_DEFAULT_BRANCH=main CI_MERGE_REQUEST_TARGET_BRANCH_NAME=main
      ;;
    *) echo "try.sh: unknown system '$system' (known: github, gitlab)" >&2; exit 2 ;;
  esac
done
