#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Brings resources/translations/*.ts up to date with the words in the source: new ones come in unfinished, those that
# went are taken out. Then translate what is unfinished (Qt Linguist, or any editor), after GLOSSARY.md beside them.
# Usage: packaging/update_translations.sh [FILE.ts...]    (another file: the words go there instead)
set -euo pipefail
cd "$(dirname "$0")/.."
lupdate=$(command -v lupdate-qt6 || echo /usr/lib/qt6/bin/lupdate)
[[ $# -gt 0 ]] || set -- resources/translations/*.ts
log=$(mktemp)
trap 'rm -f "$log"' EXIT
# -I: without the headers it cannot tell which class a word belongs to.
"$lupdate" -tr-function-alias tr+=say -no-obsolete -locations none -no-ui-lines -I . core devices ui app/desktop -ts "$@" >"$log" 2>&1 || {
  cat "$log" >&2
  exit 1
}
# A word outside a class with Q_OBJECT or Q_DECLARE_TR_FUNCTIONS is looked for under another name than it is kept by.
if grep "lacks Q_OBJECT macro" "$log" >&2; then
  echo "Give these classes Q_DECLARE_TR_FUNCTIONS, or use Words::say() in core, Words::tr() in devices." >&2
  exit 1
fi
grep "Found" "$log"
