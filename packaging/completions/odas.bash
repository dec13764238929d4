# SPDX-License-Identifier: MIT
# bash completion of odas, odaslive and odasserver

# Arrays by name, and files.
_odas_configurations() {
  compopt -o filenames
  mapfile -t COMPREPLY < <(compgen -W "$(odas arrays 2>/dev/null | cut -d ' ' -f 1)" -- "$1"
    compgen -f -X '!*.cfg' -- "$1"; compgen -d -- "$1")
}

_odas() {
  local cur=${COMP_WORDS[COMP_CWORD]} prev=${COMP_WORDS[COMP_CWORD - 1]} command='' word options
  COMPREPLY=()
  for word in "${COMP_WORDS[@]:1:COMP_CWORD-1}"; do
    if [[ $word != -* ]]; then command=$word; break; fi
  done
  case $prev in
    -c | --config) _odas_configurations "$cur"; return ;;
    -o | --out) compopt -o filenames; mapfile -t COMPREPLY < <(compgen -d -- "$cur"); return ;;
  esac
  case $command in
    '') options='run live studio devices arrays array check tune learn-noise targets simulate score bench -h --help --version' ;;
    run) options='-h --help -c --config -o --out --odas-files' ;;
    live) options='-h --help -c --config -v --verbose --studio' ;;
    studio) options='-h --help -l --listen --token --recordings --play --loop --odas --no-qr --any-port' ;;
    devices) options='-h --help --json' ;;
    array) options='-h --help --svg --png --tdoa-error' ;;
    tune) options='-h --help -o --out --silence --talk --svg --png --seconds' ;;
    learn-noise) options='-h --help -o --out --seconds --entries --anyway' ;;
    arrays) options='-h --help -p --paths' ;;
    simulate) options='-h --help -o --out --flac' ;;
    score) options='-h --help --json' ;;
    bench) options='-h --help --scenes --half --filter --seed --jobs --keep --config --set --odas -o --out --json --list' ;;
    targets) options='-h --help --add --remove --set --clear --token' ;;
    check) options='-h --help --keys' ;;
    *) return ;;
  esac
  if [[ $cur == -* || -z $command ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$options" -- "$cur")
  elif [[ $command == live || $command == check || $command == array || $command == tune ]]; then
    _odas_configurations "$cur"
  elif [[ $command == devices ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$(odas devices 2>/dev/null | sed -n 's/^  \([^ ].*\)/\1/p')" -- "$cur")
  elif [[ $command != arrays && $command != targets ]]; then
    compopt -o filenames
    mapfile -t COMPREPLY < <(compgen -f -- "$cur")
  fi
}

_odaslive() {
  local cur=${COMP_WORDS[COMP_CWORD]} prev=${COMP_WORDS[COMP_CWORD - 1]}
  if [[ $prev == -c ]]; then
    compopt -o filenames
    mapfile -t COMPREPLY < <(compgen -f -X '!*.cfg' -- "$cur"; compgen -d -- "$cur")
  else
    mapfile -t COMPREPLY < <(compgen -W '-c -s -v -h' -- "$cur")
  fi
}

_odasserver() {
  local cur=${COMP_WORDS[COMP_CWORD]} prev=${COMP_WORDS[COMP_CWORD - 1]}
  COMPREPLY=()
  case $prev in
    -c | --config) compopt -o filenames; mapfile -t COMPREPLY < <(compgen -f -X '!*.cfg' -- "$cur"; compgen -d -- "$cur") ;;
    -o | --out) compopt -o filenames; mapfile -t COMPREPLY < <(compgen -d -- "$cur") ;;
    --listen | --allow) mapfile -t COMPREPLY < <(compgen -A hostname -- "$cur") ;;
    --bits) mapfile -t COMPREPLY < <(compgen -W '8 16 24 32' -- "$cur") ;;
    --tracked | --potential | --category | --separated | --postfiltered) mapfile -t COMPREPLY < <(compgen -W 'off 0' -- "$cur") ;;
    --rate | --channels) ;;
    *) mapfile -t COMPREPLY < <(compgen -W '-o --out -c --config --tracked --potential --category --separated
      --postfiltered --rate --channels --bits --listen --allow -q --quiet -h --help --version' -- "$cur") ;;
  esac
}

complete -F _odas odas
complete -F _odaslive odaslive
complete -F _odasserver odasserver
