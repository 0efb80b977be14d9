#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Installs the program into a folder and uses it there as a person would, from elsewhere: installed_test.sh BUILD_FOLDER SOURCE_FOLDER
set -euo pipefail
build=$1 source=$2
unset LAMINA_HOME
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cmake --install "$build" --prefix "$scratch/usr" >/dev/null
cd "$scratch"
lamina=$scratch/usr/bin/lamina
failed=0
check() { [ "$2" = "$3" ] || { echo "$1: is '$2', not '$3'" >&2; failed=1; }; }
holds() { [[ $2 == *"$3"* ]] || { echo "$1: '$3' is not in: $2" >&2; failed=1; }; }
# says STATUS WORDS ARGUMENTS...
says() {
  local status=0 output
  output=$("$lamina" "${@:3}" 2>&1) || status=$?
  check "status of '${*:3}'" "$status" "$1"
  holds "output of '${*:3}'" "$output" "$2"
}

# The data is beside the program, or where LAMINA_HOME says, and nowhere else.
says 0 "light_map" man
says 0 "(commit " --version
mv usr/share/lamina elsewhere
says 2 "set LAMINA_HOME to a folder that holds both" man
LAMINA_HOME=$scratch/elsewhere says 0 "light_map" man
LAMINA_HOME=$scratch/usr says 2 "LAMINA_HOME names this folder, which lacks variants/ or shaders/" man
mv elsewhere usr/share/lamina

# A user's own variant, from the installed program.
cp -r "$source/examples/variant" mine
says 0 "one_tap" plan heart --variants-dir mine

# The manual: a page for each command, with its options; roff has nothing to complain of.
"$lamina" --help | sed -n '/^Subcommands:/,$p' | awk 'NR > 1 && /^  [a-z]/ { print $1 }' >commands
check "pages" "$(ls usr/share/man/man1 | wc -l)" "$(($(wc -l <commands) + 1))"
if command -v groff >/dev/null; then
  for page in usr/share/man/man1/*; do check "groff of $page" "$(groff -man -ww -Tascii "$page" 2>&1 >/dev/null)" ""; done
  groff -man -Tascii usr/share/man/man1/lamina-gate.1 | sed 's/.\x08//g' >text
  for option in $("$lamina" gate --help | grep -oE '^ +(-h,)?--[a-z-]+' | tr -d ' ' | sed 's/^-h,//'); do
    grep -q -e "$option" text || { echo "lamina-gate.1 lacks $option" >&2; failed=1; }
  done
else
  echo "skipped: groff is not installed"
fi
says 2 "did you mean 'compare'?" man comapre

# Completion in the shells that are here.
in_bash() {   # the line is split as bash itself does, at '=' too
  bash --norc -c 'source usr/share/bash-completion/completions/lamina; COMP_LINE=$1 COMP_POINT=${#1}
    _lamina '"$lamina"' 2>/dev/null; printf "%s " "${COMPREPLY[@]}"' - "$1"
}
check "bash: a scene" "$(in_bash 'lamina compare terr')" "terrain "
check "bash: an option" "$(in_bash 'lamina compare --back')" "--backend "
check "bash: after =" "$(in_bash 'lamina compare --backend=os')" "osmesa "
check "bash: a path" "$(in_bash 'lamina sweep heart --set objects.heart.th')" "objects.heart.thickness= "
check "bash: a variant of one's own" "$(in_bash 'lamina compare --variants-dir mine --variant one_t')" "one_tap "
check "bash: a folder" "$(in_bash 'lamina compare --variants-dir mi')" "mine "
check "bash: nothing of a scene that is none" "$(in_bash 'lamina sweep no.toml --set ')" " "
if command -v fish >/dev/null; then
  in_fish() { PATH=$scratch/usr/bin:$PATH fish --no-config -c "source usr/share/fish/vendor_completions.d/lamina.fish; complete -C '$1'"; }
  check "fish: a family" "$(in_fish 'lamina stress cap')" "$(printf 'caps\tthe area that two spherical caps share')"
else
  echo "skipped: fish is not installed"
fi
if command -v zsh >/dev/null; then
  in_zsh() {
    zsh -f -c 'zmodload zsh/zpty; zpty z "zsh -f -i"
      zpty -w z "PS1= PATH='"$scratch/usr/bin"':\$PATH; autoload -Uz compinit; compinit -u -D; source usr/share/zsh/vendor-completions/_lamina; echo rea''dy"
      zpty -r -m z line "*ready*"; zpty -w -n z "$1"$'"'\\t'"'; zpty -r -m z line "*$2*"; print -r -- found; zpty -d z' - "$1" "$2"
  }
  check "zsh: a scene" "$(in_zsh 'lamina compare hear' 't')" "found"
else
  echo "skipped: zsh is not installed"
fi
exit $failed
