#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# A gate in any CI: gate.sh BASE SCENE [OPTIONS...] fails where the variants and shaders here got slower or less accurate than those in
# BASE, a checkout of the state before.
#   git worktree add ../base origin/main && examples/gate/gate.sh ../base heart --no-time
# The program is an installed one, or LAMINA names it; it reads the variants and shaders of the folder in which this is called.
# junit.xml and the report are in gate-out. Status 3 (the answer is not known) does not fail the job here; change that if you like.
set -u
base=$1 scene=$2
shift 2
[ -d variants ] && export LAMINA_HOME=$PWD
"${LAMINA:-lamina}" gate "$scene" --against "$base" --limits "$(dirname "$0")/gate.toml" --out gate-out "$@"
status=$?
if [ $status -eq 3 ]; then
  echo "the gate could not decide; see gate-out/index.html"
  exit 0
fi
exit $status
