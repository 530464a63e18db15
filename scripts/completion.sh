#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Writes the shell completion of myoface-cli from what the program says of itself:
#   scripts/completion.sh build/release/bin/myoface-cli > packaging/myoface-cli.bash
set -euo pipefail
cli=$1
commands=$("$cli" --help | sed -n '/^Subcommands:/,$p' | awk 'NR > 1 && /^  [a-z]/ {print $1}' | tr '\n' ' ')
echo "# SPDX-License-Identifier: Apache-2.0"
echo "# Made by scripts/completion.sh."
echo "_myoface_cli() {"
echo "    local word=\${COMP_WORDS[COMP_CWORD]} options="
echo "    if [ \"\$COMP_CWORD\" -eq 1 ]; then"
echo "        COMPREPLY=(\$(compgen -W '$commands' -- \"\$word\"))"
echo "        return"
echo "    fi"
echo "    case \${COMP_WORDS[1]} in"
for command in $commands; do
  options=$("$cli" "$command" --help | grep -oE '(^| |,)--?[a-z-]+' | tr -d ' ,' | sort -u | tr '\n' ' ')
  echo "        $command) options='$options' ;;"
done
echo "    esac"
echo "    if [[ \$word == -* ]]; then"
echo "        COMPREPLY=(\$(compgen -W \"\$options\" -- \"\$word\"))"
echo "    else"
echo "        COMPREPLY=(\$(compgen -f -- \"\$word\") generic)"
echo "    fi"
echo "}"
echo "complete -o filenames -F _myoface_cli myoface-cli"
