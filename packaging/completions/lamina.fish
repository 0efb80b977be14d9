# SPDX-License-Identifier: Apache-2.0
# Completion for fish; the program itself says what may come next.
function __lamina_complete
    set -l before (commandline -opc)
    set -l now (commandline -ct)
    for line in ($before[1] complete -- $before[2..-1] "$now" 2>/dev/null)
        switch $line
            case ':folders'
                __fish_complete_directories $now
            case ':files*'
                set -l endings (string split -n ' ' (string replace ':files' '' -- $line))
                if test (count $endings) -gt 0
                    for ending in $endings
                        __fish_complete_suffix .$ending
                    end
                else
                    __fish_complete_path $now
                end
            case '*'
                echo $line
        end
    end
end
complete -c lamina -f -a '(__lamina_complete)'
