# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
#
# Completion of topple's command line for bash. Commands, charts and options are read from what the
# program's own --help prints, as it is asked, so that there is no second list of them.

# The options in the help: --name, or --name= where a value must follow.
_topple_options() {
  local line
  while IFS= read -r line; do
    [[ $line =~ ^\ +(-[a-zA-Z?],\ )?(--[a-z-]+=?) ]] && echo "${BASH_REMATCH[2]}"
  done
}

# The commands in the help, or the charts in that of `topple chart`.
_topple_commands() {
  local line
  while IFS= read -r line; do
    [[ $line =~ ^\ \ ([a-z]+)\ + || $line =~ \[OPTION\.\.\.\]\ ([a-z]+) ]] && echo "${BASH_REMATCH[1]}"
  done
}

_topple_files() { # WORD ENDING…
  local ending
  compgen -d -- "$1"
  for ending in "${@:2}"; do
    compgen -f -X "!*.$ending" -- "$1"
  done
}

_topple_values() { # OPTION WORD COMMAND
  case $1 in
  --figure) _topple_files "$2" svg pdf png ;;
  --output)
    case $3 in
    examples | new) _topple_files "$2" yaml ;;
    *) _topple_files "$2" svg pdf png csv ;;
    esac
    ;;
  --write-profile) _topple_files "$2" csv ;;
  --level) compgen -W "double compensated ball exact" -- "$2" ;;
  --pivots) compgen -W "all governing" -- "$2" ;;
  --for-all) compgen -W "count" -- "$2" ;;
  --resample) compgen -W "linear spline" -- "$2" ;;
  --detrend) compgen -W "none line ends" -- "$2" ;;
  --window) compgen -W "hann none" -- "$2" ;;
  --color) compgen -W "auto always never" -- "$2" ;;
  --towards) compgen -W "left right both" -- "$2" ;;
  --frame) compgen -W "base world" -- "$2" ;;
  --unit) compgen -W "mm cm m km in ft" -- "$2" ;;
  --for)
    compgen -S = -W "critical_angle fos sliding_angle sliding_fos limit_angle limit_fos onset_angle" -- "$2"
    ;;
  esac
}

# Where files are proposed: folders end in a slash, blanks are quoted. Outside of a completion, no more.
_topple_how() {
  compopt -o "$1" 2>/dev/null
}

_topple() {
  local program=${1/#\~/$HOME} words=("${COMP_WORDS[@]:0:COMP_CWORD}") word=${COMP_WORDS[COMP_CWORD]}
  local last=${words[-1]} command=${words[1]-} option='' help options commands kind
  COMPREPLY=()
  # bash takes --name=value for three words
  if [[ $word == = || $last == = ]]; then
    [[ $word == = ]] && option=$last word='' || option=${words[-2]}
  fi
  [[ $command == *.yaml || $command == *.yml ]] && command=solve
  help=$("$program" ${command:+"$command"} --help 2>/dev/null)
  options=$(_topple_options <<<"$help")
  [[ $last == -o ]] && last=--output
  [[ $'\n'$options$'\n' == *$'\n'"$last="$'\n'* ]] && option=$last

  if [[ -n $option ]]; then
    mapfile -t COMPREPLY < <(_topple_values "$option" "$word" "$command")
    case $option in
    --figure | --output | --write-profile) _topple_how filenames ;;
    --for) _topple_how nospace ;;
    esac
    return
  fi
  if [[ $word == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$options" -- "$word")
    [[ ${#COMPREPLY[@]} -eq 1 && ${COMPREPLY[0]} == *= ]] && _topple_how nospace
    return
  fi
  commands=$(_topple_commands <<<"$help")
  for kind in "${words[@]:2}"; do
    [[ $'\n'$commands$'\n' == *$'\n'"$kind"$'\n'* ]] && commands=''
  done
  [[ -z $command || -z $commands ]] && _topple_how filenames
  mapfile -t COMPREPLY < <(
    compgen -W "$commands" -- "$word"
    [[ -z $command || -z $commands && $command != @(examples|new|solid) ]] && _topple_files "$word" yaml yml
    [[ $command == examples ]] && compgen -W "$("$program" examples 2>/dev/null | grep -x '[a-z0-9_/]*')" -- "$word"
    [[ $command == new ]] && compgen -f -X '!*.csv' -- "$word"
    [[ $command == solid ]] && _topple_files "$word" stl ply obj
    [[ $command == profile ]] && compgen -f -X '!*.csv' -- "$word"
  )
}

complete -F _topple topple
