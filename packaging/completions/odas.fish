# SPDX-License-Identifier: MIT
# fish completion of odas and odaslive
complete -c odas -n __fish_use_subcommand -f -a run -d 'Process a recording'
complete -c odas -n __fish_use_subcommand -f -a live -d 'Run a configuration as it stands'
complete -c odas -n __fish_use_subcommand -f -a devices -d 'List microphones and what each offers'
complete -c odas -n __fish_use_subcommand -f -a arrays -d 'List the arrays that are known by name'
complete -c odas -n __fish_use_subcommand -f -a simulate -d 'Make a recording, and its truth, of a scene'
complete -c odas -n __fish_use_subcommand -f -a score -d 'Hold what was heard against the truth'
complete -c odas -n __fish_use_subcommand -f -a targets -d 'Add, move and remove the fixed directions of a run'
complete -c odas -n __fish_use_subcommand -f -a check -d 'Look at a configuration'
complete -c odas -s h -l help -d 'Help'
complete -c odas -n __fish_use_subcommand -l version -d 'Version'

complete -c odas -n '__fish_seen_subcommand_from run live' -s c -l config -r -d 'Configuration'
complete -c odas -n '__fish_seen_subcommand_from live check' -a "(odas arrays 2>/dev/null | string replace -r '  +' \t)"
complete -c odas -n '__fish_seen_subcommand_from run simulate' -s o -l out -r -a '(__fish_complete_directories)' -d 'Folder to write to'
complete -c odas -n '__fish_seen_subcommand_from run' -l odas-files -d "ODAS's own formats, too"
complete -c odas -n '__fish_seen_subcommand_from live' -s v -l verbose -d 'Say at the end what it has cost'
complete -c odas -n '__fish_seen_subcommand_from devices' -f -a "(odas devices 2>/dev/null | string match -rg '^  (\S.*)')"
complete -c odas -n '__fish_seen_subcommand_from devices' -l json -d 'Print a JSON array'
complete -c odas -n '__fish_seen_subcommand_from arrays' -f -s p -l paths -d 'Where each file is'
complete -c odas -n '__fish_seen_subcommand_from simulate' -l flac -d 'Write mics.flac'
complete -c odas -n '__fish_seen_subcommand_from score' -l json -d 'Print one JSON object'
complete -c odas -n '__fish_seen_subcommand_from targets' -x -l add -d 'Add or move one: TAG=AZIMUTH,ELEVATION'
complete -c odas -n '__fish_seen_subcommand_from targets' -x -l remove -d 'Let one go'
complete -c odas -n '__fish_seen_subcommand_from targets' -x -l set -d 'In place of all'
complete -c odas -n '__fish_seen_subcommand_from targets' -f -l clear -d 'Let all go'
complete -c odas -n '__fish_seen_subcommand_from targets' -x -l token -d 'That of the run'
complete -c odas -n '__fish_seen_subcommand_from check' -l keys -d 'Print the reference of all keys'

complete -c odaslive -s c -r -d 'Configuration'
complete -c odaslive -s s -d 'One thread'
complete -c odaslive -s v -d 'Say what is done'
complete -c odaslive -s h -d 'Help'
