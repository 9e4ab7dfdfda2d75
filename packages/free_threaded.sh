#!/bin/sh
# Builds CPython without its lock from Debian's source package, into a folder: packages/free_threaded.sh VERSION FOLDER
# No registry ships such an interpreter; its source is that of python3.14 of Debian's newest suite. 5 minutes on two cores.
set -eu
version=$1 folder=$(mkdir -p "$2" && cd "$2" && pwd) suite=${SUITE:-sid}
state=$(mktemp -d)
trap 'rm -rf "$state"' EXIT
mkdir -p "$state/lists/partial" "$state/cache/archives/partial"
touch "$state/status"
mirror=$(sed -n 's/^URIs: *//p' /etc/apt/sources.list.d/debian.sources 2>/dev/null | head -1)
echo "deb-src ${mirror:-http://deb.debian.org/debian} $suite main" >"$state/sources.list"
cat >"$state/conf" <<END
Dir::Etc::SourceList "$state/sources.list";
Dir::Etc::SourceParts "/dev/null";
Dir::State::Lists "$state/lists";
Dir::State::status "$state/status";
Dir::Cache "$state/cache";
Acquire::Languages "none";
APT::Sandbox::User "root";
END
export APT_CONFIG="$state/conf"
apt-get -qq update
cd "$state"
apt-get -qq source --download-only "python$version" >/dev/null
tar -xf python*.orig.tar.*
cd Python-* 2>/dev/null || cd python*/
./configure --quiet --disable-gil --prefix="$folder" --without-static-libpython >/dev/null
make -s -j2 >/dev/null 2>&1
make -s install >/dev/null 2>&1
"$folder/bin/python${version}t" -c 'import ssl, zlib, ctypes, venv, sys; assert not sys._is_gil_enabled()'
