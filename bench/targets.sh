#!/usr/bin/env bash
# Every target of speed in one run: a table of whole processes and library calls, some minutes; then, where CuraEngine or PrusaSlicer is installed, the same
# meshes sliced by all of them (bench/peers.sh), also the sphere of 500,000 triangles, where memory counts. On standard output, for RESULTS.md.
#   bench/targets.sh BIG.gcode FOLDER_OF_MESHES
# Needs GNU time. BIG.gcode is the file of make_big_gcode.sh.
set -eu
cd "$(dirname "$0")/.."
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
dotnet publish src/Caterpillar.Cli -c Release -o "$out" -v quiet --nologo >&2
meshes=$(realpath "$2")
dotnet run -c Release --project bench -- targets "$out/Caterpillar.Cli" "$(realpath "$1")" "$meshes"
command -v CuraEngine >/dev/null || command -v prusa-slicer >/dev/null || exit 0
echo
[ ! -e "$meshes/igea.ply" ] || bench/peers.sh "$meshes/igea.ply"
dotnet run -c Release --project bench -- mesh 500000 "$out/sphere.stl" >&2
echo
bench/peers.sh "$out/sphere.stl" -- infill full
