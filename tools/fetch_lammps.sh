#!/bin/bash
# Fetch and unpack the sources of a LAMMPS release, if they are not there yet.
# usage: tools/fetch_lammps.sh VERSION FOLDER        for example 4Feb2025 /tmp/lammps
#
# They come from the Debian archive this machine's own apt is configured for: apt verifies the signed index and, with
# it, the SHA256 of the tarball. Where there is no such archive: the public release on GitHub.
set -euo pipefail
# shellcheck source=tools/common.sh
source "$(dirname "$0")/common.sh"
version=${1:?usage: fetch_lammps.sh VERSION FOLDER}
folder=${2:?usage: fetch_lammps.sh VERSION FOLDER}

case $version in    # Debian suite, version there, SHA256 of the tarball
  4Feb2025) suite=trixie debian=20250204 sha256=3671165bd52fad36734e0a9136c5bc5ecb225e03988f8c89aa13366a8b53b1c7 ;;
  4Jul2026) suite=forky debian=20260704 sha256=cddbc45a047416bd48a4a0b87f24a5b61b3446982b74d18cafe619c22b17eb62 ;;
  *) die "LAMMPS $version is not one of 4Feb2025, 4Jul2026; for your own set LAMMPS_SOURCE_DIR and LAMMPS_EXECUTABLE" ;;
esac
lock "$folder.lock"
if [ -e "$folder" ]; then exit 0; fi
work=$folder.part    # everything happens here; the finished tree is moved to its place as the last step
mkdir -p "$work"

# URI of the Debian archive in apt's configuration; from the files themselves if apt has no lists yet.
debian_archive() {
  # shellcheck disable=SC2016 # for apt, not for the shell
  apt-get indextargets --format '$(ORIGIN)|$(LABEL)|$(COMPONENT)|$(REPO_URI)' 'Created-By: Packages' 2>/dev/null |
    awk -F'|' '$1 == "Debian" && $2 == "Debian" && $3 == "main" && !found++ { print $4 }' | grep . && return
  { cat /etc/apt/sources.list /etc/apt/sources.list.d/*.{list,sources} 2>/dev/null || true; } |
    awk '$1 ~ /^#/ { next }
         tolower($1) == "uris:" || $1 ~ /^deb/ {
           for (i = 2; i <= NF; i++) if ($i ~ /:\/\/.*\/debian\/?$/ && !found++) print $i
         }' |
    grep .
}

# apt with a state of its own: nothing of the system's lists and sources is touched.
private_apt() {
  local tool=$1
  shift
  "$tool" -o Dir::Etc::SourceList="$work/apt/sources.list" -o Dir::Etc::SourceParts=/dev/null \
    -o Dir::State::Lists="$work/apt/lists" -o Dir::Cache="$work/apt/cache" \
    -o APT::Sandbox::User="$(id -un)" -o Acquire::Retries=3 -o Acquire::Languages=none "$@"
}

# "DIRECTORY FILE SHA256" of the tarball of Debian version $debian, from the index of sources.
tarball_record() {
  private_apt apt-cache showsrc --only-source lammps 2>/dev/null | awk -v wanted="$debian" '
    /^Version:/ { version = $2; directory = ""; in_sums = 0 }
    /^Directory:/ { directory = $2 }
    /^[^ ]/ { in_sums = /^Checksums-Sha256:/ }
    in_sums && $3 ~ /\.orig\.tar\.[a-z0-9]+$/ { sum = $1; file = $3 }
    /^$/ && index(version, wanted) == 1 && file { print directory, file, sum; file = "" }
    END { if (index(version, wanted) == 1 && file) print directory, file, sum }' | sort -u | tail -n 1
}

fetch_from_debian() {
  local uri key=/usr/share/keyrings/debian-archive-keyring.gpg directory file sum
  command -v apt-get >/dev/null && [ -r "$key" ] && uri=$(debian_archive) || return 1
  mkdir -p "$work"/apt/{lists/partial,cache/archives/partial}
  echo "deb-src [signed-by=$key] $uri $suite main" >"$work/apt/sources.list"
  private_apt apt-get -qq update || return 1
  read -r directory file sum < <(tarball_record) || { say "no LAMMPS $debian in Debian $suite any more"; return 1; }
  if [ "$sum" != "$sha256" ]; then
    # forky is not released: its tarball may be packed again; the signed index still vouches for it
    [ "$suite" = forky ] || die "Debian's $file has SHA256 $sum instead of $sha256"
    say "note: $file has been packed again (SHA256 $sum)"
  fi
  tarball=$work/$file
  if ! sha256sum -c --status <<<"$sum  $tarball" 2>/dev/null; then
    say "fetching $file from Debian $suite"
    private_apt /usr/lib/apt/apt-helper download-file "${uri%/}/$directory/$file" "$tarball" "SHA256:$sum" || return 1
  fi
}

fetch_from_github() {
  local tag
  tarball=$work/github.tar.gz
  for tag in patch_$version stable_$version; do
    say "fetching $tag from GitHub"
    if curl -fsSL --retry 3 -o "$tarball" "https://github.com/lammps/lammps/archive/refs/tags/$tag.tar.gz"; then
      say "note: no checksum is known for this file. SHA256: $(sha256sum <"$tarball")"
      return
    fi
  done
  return 1
}

fetch_from_debian || fetch_from_github ||
  die "cannot fetch LAMMPS $version, neither from Debian nor from GitHub; or set LAMMPS_SOURCE_DIR and LAMMPS_EXECUTABLE"

say "unpacking $(basename "$tarball")"
rm -rf "$work/tree"
mkdir "$work/tree"
tar -xf "$tarball" --no-same-owner -C "$work/tree"
tree=$work/tree
[ -d "$tree/cmake" ] || tree=$(echo "$work"/tree/*)    # some tarballs have one top folder, some have none
found=$(awk -F'"' '/LAMMPS_VERSION/ { gsub(" ", "", $2); print $2 }' "$tree/src/version.h")
[ "$found" = "$version" ] || die "$tarball holds LAMMPS $found, not $version"
mv "$tree" "$folder"
rm -rf "$work"
