#!/usr/bin/env bash
# Every target of speed that needs no other program, whole processes and library calls, in one run of some minutes: a table on standard output.
#   bench/targets.sh BIG.gcode FOLDER_OF_MESHES
# Needs GNU time. BIG.gcode is the file of make_big_gcode.sh.
set -eu
cd "$(dirname "$0")/.."
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
dotnet publish src/Caterpillar.Cli -c Release -o "$out" -v quiet --nologo >&2
dotnet run -c Release --project bench -- targets "$out/Caterpillar.Cli" "$(realpath "$1")" "$(realpath "$2")"
