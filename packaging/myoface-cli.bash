# SPDX-License-Identifier: Apache-2.0
# Made by scripts/completion.sh.
_myoface_cli() {
    local word=${COMP_WORDS[COMP_CWORD]} options=
    if [ "$COMP_CWORD" -eq 1 ]; then
        COMPREPLY=($(compgen -W 'info landmarks measure compare generate fit simulate replay render report convert bench ' -- "$word"))
        return
    fi
    case ${COMP_WORDS[1]} in
        info) options='--axes --help --known --landmarks --passphrase-file --tissue --unit -h -o ' ;;
        landmarks) options='--axes --help --known --landmarks --passphrase-file --tissue --unit -h -o ' ;;
        measure) options='--age --axes --compare --help --known --landmarks --passphrase-file --sex --tissue --unit -h -o ' ;;
        compare) options='--axes --drag --expression --help --known --landmarks --muscle --passphrase-file --plan --protect --result --strength --target --tissue --unit --volume --weaken -h -o ' ;;
        generate) options='--age --asymmetry --help --landmarks-out --picture --seed --sex --stubble --vertices -h -o ' ;;
        fit) options='--axes --bone-out --help --known --landmarks --muscles-out --passphrase-file --tissue --unit -h -o ' ;;
        simulate) options='--axes --drag --expression --help --known --landmarks --muscle --passphrase-file --plan --protect --report --response --seconds --solver --strength --target --threads --tissue --unit --volume --weaken -h -o ' ;;
        replay) options='--axes --case-out --help --known --landmarks --on-top --passphrase-file --plan-out --report --threads --tissue --unit -h -o ' ;;
        render) options='--axes --cut-away --drag --expression --focus --heatmap --heatmap-max --help --known --landmarks --layers --muscle --no-loose-parts --passphrase-file --plan --protect --size --skin-opacity --span --strength --target --tissue --unit --view --volume --weaken --whole -h -o ' ;;
        report) options='--age --anonymous --axes --date --drag --expression --help --known --landmarks --language --logo --muscle --notes --passphrase-file --patient --plan --protect --sex --strength --target --tissue --title --unit --volume --weaken -h -o ' ;;
        convert) options='--help -h ' ;;
        bench) options='--help --json --vertices -h -o ' ;;
    esac
    if [[ $word == -* ]]; then
        COMPREPLY=($(compgen -W "$options" -- "$word"))
    else
        COMPREPLY=($(compgen -f -- "$word") generic)
    fi
}
complete -o filenames -F _myoface_cli myoface-cli
