# SPDX-License-Identifier: Apache-2.0
# Completion for bash; the program itself says what may come next.
_lamina() {
  local cur words cword line word
  if declare -F _get_comp_words_by_ref >/dev/null; then
    _get_comp_words_by_ref -n =: cur words cword
  else   # without bash-completion: words between blanks
    line=${COMP_LINE:0:COMP_POINT}
    read -ra words <<<"$line"
    [[ $line == *[[:space:]] ]] && words+=("")
    cword=$((${#words[@]} - 1))
    cur=${words[cword]}
  fi
  # bash replaces only what follows the last '=' or ':'.
  local kept=""
  [[ $cur == *[=:]* ]] && kept=${cur%"${cur##*[=:]}"}
  COMPREPLY=()
  while IFS= read -r line; do
    case $line in
      :folders) compopt -o filenames; mapfile -t -O ${#COMPREPLY[@]} COMPREPLY < <(compgen -d -- "${cur#"$kept"}") ;;
      :files*)
        compopt -o filenames
        local endings=${line#:files } all=()
        mapfile -t all < <(compgen -f -- "${cur#"$kept"}")
        for word in "${all[@]}"; do
          if [ -d "$word" ] || [ -z "$endings" ] || [[ " $endings " == *" ${word##*.} "* ]]; then COMPREPLY+=("$word"); fi
        done ;;
      ?*)
        word=${line%%$'\t'*}
        [[ $word == *[=:] ]] && compopt -o nospace
        COMPREPLY+=("${word#"$kept"}") ;;
    esac
  done < <("$1" complete -- "${words[@]:1:cword}" 2>/dev/null)
}
complete -F _lamina lamina
