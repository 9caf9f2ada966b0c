#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Pictures of the first pages of a case's report, into the case's folder: cases/report_pages.sh CASE...
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
most_pages=5 # then comes the scene's own text

for program in chromium pdftoppm; do
  command -v "$program" >/dev/null || { echo "the program $program is missing: apt-get install chromium poppler-utils" >&2; exit 1; }
done
[ $# -gt 0 ] || { echo "usage: cases/report_pages.sh CASE..." >&2; exit 2; }

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
for case in "$@"; do
  "$root/blockweir" report "$root/cases/$case" --out report.html
  chromium --headless --no-sandbox --disable-gpu --user-data-dir=browser --no-pdf-header-footer --print-to-pdf=report.pdf "file://$work/report.html" 2>browser.log ||
    { cat browser.log >&2; exit 1; }
  rm -f "$root/cases/$case"/report-*.png
  pdftoppm -png -r 75 -l "$most_pages" report.pdf "$root/cases/$case/report"
  ls "$root/cases/$case"/report-*.png
done
