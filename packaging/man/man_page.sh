#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Writes a program's manual page (man(7)) to standard output: NAME.1.in of this folder, with the line @VERSION@ and the
# line @OPTIONS@ or @COMMANDS@ filled in from the program's own --help. Usage: man_page.sh PROGRAM
set -euo pipefail
program=${1:?the program, such as build/release/bin/gripscope-cli}
name=$(basename "$program")
here=$(cd "$(dirname "$0")" && pwd)
export LC_ALL=C.UTF-8 LANGUAGE=en QT_QPA_PLATFORM=offscreen
help() { "$program" "$@" --help 2>/dev/null; }

# options: from a help text, the description above "Options:" as a paragraph, and the options as a list.
options() {
  awk '
    function escaped(text) {
      gsub(/\\/, "\\e", text); gsub(/-/, "\\-", text); gsub(/^[.'"'"']/, "\\\\&&", text)
      return text
    }
    function flush() {
      if (option != "") print ".TP\n.B " escaped(option) "\n" escaped(described)
      option = described = ""
    }
    /^Usage: / { sub(/^Usage: /, ""); sub(/^[^ ]*\//, ""); print ".B " escaped($0) "\n.PP"; next }
    /^(Options|Arguments):$/ { listed = 1; next }
    !listed { if ($0 != "") print escaped($0); next }
    /^  [^ ]/ {
      flush(); line = substr($0, 3); at = match(line, /   *[^ ]/)
      option = at ? substr(line, 1, at - 1) : line; described = at ? substr(line, at) : ""
      sub(/^ */, "", described); next
    }
    /^ / { sub(/^ */, ""); described = described (described == "" ? "" : " ") $0 }
    END { flush() }'
}

# commands [WORD...]: a section for each command, and below it for each of its actions.
commands() {
  local command text
  for command in $(help | awk '/^Commands:$/ { in_list = 1; next } in_list && /^  [a-z]/ { print $1 } in_list && /^$/ { exit }'); do
    echo ".SS $command"
    text=$(help "$command")
    options <<<"$text"
    actions "$command" "$text"
  done
}

# actions COMMAND HELP: a help text that speaks of ACTION --help names them as "name: what it does; name: ...".
actions() {
  local action text
  [[ $2 =~ \"$1\ (ACTION|NAME)\ --help\" ]] || return 0
  for action in $(grep -oE '(\. |; )[a-z0-9-]+:' <<<"${2%%Options:*}" | tr -d ' .;:'); do
    text=$(help "$1" "$action")
    echo ".SS $1 $action"
    options <<<"$text"
  done
}

version=$(sed -nE 's/^project\(Gripscope VERSION ([0-9.]+).*/\1/p' "$here/../../CMakeLists.txt")
while IFS= read -r line; do
  case $line in
    @OPTIONS@) help | options ;;
    @COMMANDS@) commands ;;
    *) printf '%s\n' "${line//@VERSION@/$version}" ;;
  esac
done <"$here/$name.1.in"
