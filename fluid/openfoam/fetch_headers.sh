#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Headers of the installed Debian OpenFOAM, which has none: from the source package of the same version, which apt
# verifies. Usage: fetch_headers.sh FOLDER; src/LIB/lnInclude stand in it afterwards. The system's own lists of sources
# are left alone.
set -euo pipefail
folder=$(mkdir -p "$1" && cd "$1" && pwd)
libraries=(OpenFOAM OSspecific/POSIX finiteVolume meshTools)

die() {
  echo "fetch_headers: $*" >&2
  exit 1
}

version=$(dpkg-query -W -f='${source:Version}' openfoam 2>/dev/null) || die "Debian's package openfoam is not installed"
[ "$(cat "$folder/version" 2>/dev/null)" != "$version" ] || exit 0

work=$folder/download
rm -rf "$work" "$folder/src"
mkdir -p "$work"/{parts,lists/partial,cache}
# The machine's own sources, asked for source packages. Both of apt's formats; options in brackets stay.
for list in /etc/apt/sources.list /etc/apt/sources.list.d/*.list; do
  [ ! -f "$list" ] || sed -n 's/^deb /deb-src /p' "$list" >>"$work/parts/all.list"
done
for list in /etc/apt/sources.list.d/*.sources; do
  [ ! -f "$list" ] || sed 's/^Types:.*/Types: deb-src/' "$list" >"$work/parts/$(basename "$list")"
done
apt=(apt-get -o Dir::Etc::sourcelist=/dev/null -o "Dir::Etc::sourceparts=$work/parts" -o "Dir::State::lists=$work/lists"
  -o "Dir::Cache=$work/cache" -o APT::Sandbox::User=root -qq)
cd "$work"
"${apt[@]}" update || die "apt cannot read the lists of source packages"
"${apt[@]}" source --download-only "openfoam=$version" || die "apt cannot fetch the source of openfoam $version"

mkdir unpacked
tar -xf openfoam_*.orig.tar.* -C unpacked --strip-components=1 --wildcards '*/src/OpenFOAM/*' '*/src/OSspecific/*' \
  '*/src/finiteVolume/*' '*/src/meshTools/*' '*/wmake/*'
for library in "${libraries[@]}"; do
  sh unpacked/wmake/wmakeLnInclude -s "unpacked/src/$library" >/dev/null
done
mv unpacked/src "$folder/src"
cd "$folder"
rm -rf "$work"
echo "$version" >"$folder/version"
