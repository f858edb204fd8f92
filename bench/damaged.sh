#!/usr/bin/env bash
# Damaged meshes: where layers lose more than a tenth of their area, and what CuraEngine makes of the same meshes.
#   bench/damaged.sh FOLDER [FIRST [COUNT]]
# COUNT (500) seeds from FIRST (0) damage the closed meshes of the folder. CURA_ENGINE_SEARCH_PATH names the definitions and extruders of CuraEngine.
set -eu
folder=$(realpath "$1")
cd "$(dirname "$0")/.."
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
dotnet publish bench -c Release -o "$out/bench" -v quiet --nologo >/dev/null
bench() { dotnet "$out/bench/Caterpillar.Bench.dll" "$@"; }
bench damaged "$folder" "${2:-0}" "${3:-500}" "$out"
export CURA_ENGINE_SEARCH_PATH=${CURA_ENGINE_SEARCH_PATH:-/usr/share/cura/resources/definitions:/usr/share/cura/resources/extruders}
definition=$(IFS=:; for path in $CURA_ENGINE_SEARCH_PATH; do [ -e "$path/fdmprinter.def.json" ] && echo "$path/fdmprinter.def.json" && break; done) || true
[ -n "$definition" ] && command -v CuraEngine >/dev/null || { echo "CuraEngine was not found."; exit 0; }
# A wall and 100 % infill, without what depends on other layers: the material of a layer is its area.
set=()
for option in layer_height=0.2 layer_height_0=0.2 slicing_tolerance=middle wall_line_count=1 infill_pattern=lines infill_sparse_density=100 infill_line_distance=0.4 top_layers=0 \
  bottom_layers=0 initial_bottom_layers=0 adhesion_type=none support_enable=false retraction_enable=false machine_nozzle_size=0.4 machine_width=220 machine_depth=220 machine_height=250 \
  machine_center_is_zero=false center_object=true line_width=0.4 wall_line_width=0.4 wall_line_width_0=0.4 wall_line_width_x=0.4 infill_line_width=0.4; do set+=(-s "$option"); done
echo "CuraEngine:"
for bad in "$out"/*-bad.stl; do
  [ -e "$bad" ] || continue
  good=${bad%-bad.stl}-good.stl
  for mesh in "$good" "$bad"; do
    CuraEngine slice -j "$definition" -o "${mesh%.stl}.gcode" "${set[@]}" -s material_diameter=1.75 -e0 -s material_diameter=1.75 -l "$mesh" >/dev/null 2>&1
  done
  bench lost "${good%.stl}.gcode" "${bad%.stl}.gcode"
done
