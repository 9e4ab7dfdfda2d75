#!/bin/sh
# Unpacks CPython of Debian's newest suite into a folder, for a machine of any kind: packages/debian.sh ARCHITECTURE VERSION FOLDER
# Nothing is installed here: its own lists, its own library of C, and no package of this system changes.
set -eu
architecture=$1 version=$2 folder=$3 suite=${SUITE:-sid}
state=$(mktemp -d)
trap 'rm -rf "$state"' EXIT
mkdir -p "$state/lists/partial" "$state/cache/archives/partial" "$folder"
touch "$state/status"
mirror=$(sed -n 's/^URIs: *//p' /etc/apt/sources.list.d/debian.sources 2>/dev/null | head -1)
echo "deb ${mirror:-http://deb.debian.org/debian} $suite main" >"$state/sources.list"
cat >"$state/conf" <<END
Dir::Etc::SourceList "$state/sources.list";
Dir::Etc::SourceParts "/dev/null";
Dir::State::Lists "$state/lists";
Dir::State::status "$state/status";
Dir::Cache "$state/cache";
APT::Architecture "$architecture";
APT::Architectures { "$architecture"; };
APT::Install-Recommends "false";
Acquire::Languages "none";
APT::Sandbox::User "root";
END
export APT_CONFIG="$state/conf"
apt-get -qq update
apt-get -qq -y --download-only install "python$version" "libpython$version-stdlib" libstdc++6 >/dev/null
for package in "$state"/cache/archives/*.deb; do
  dpkg-deb --fsys-tarfile "$package" | tar -x -C "$folder" --exclude=./usr/share
done
# Where libraries and programs stand since bin and lib are links into usr.
for each in bin lib lib64 sbin; do
  [ -e "$folder/$each" ] || { [ -d "$folder/usr/$each" ] && ln -s "usr/$each" "$folder/$each"; } || true
done
