#!/usr/bin/env bash
# How exactly layers are filled: solid prints of Caterpillar, PrusaSlicer (Arachne) and CuraEngine against the sections of the model.
#   bench/coverage.sh MODEL...
# The settings are the same: 0.2 mm layers, lines of 0.45 mm, 2 walls, 100 % infill of lines, no skins, no skirt.
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
dotnet publish "$root/src/Caterpillar.Cli" -c Release -o "$out/caterpillar" -v quiet --nologo >/dev/null
dotnet publish "$root/bench" -c Release -o "$out/bench" -v quiet --nologo >/dev/null
failed() { echo "$1 failed: $(tail -n 1 "$out/log")"; }
export CURA_ENGINE_SEARCH_PATH=${CURA_ENGINE_SEARCH_PATH:-/usr/share/cura/resources/definitions:/usr/share/cura/resources/extruders}
for mesh in "$@"; do
  echo "$(basename "$mesh")"
  # Not every program reads OBJ and PLY.
  dotnet "$out/bench/Caterpillar.Bench.dll" stl "$mesh" "$out/model.stl" >/dev/null
  files=()
  "$out/caterpillar/Caterpillar.Cli" slice "$mesh" --set layer_height_mm=0.2 --set first_layer_height_mm=0.2 --set line_width_mm=0.45 --set wall_count=2 --set infill_density_percent=100 \
    --set skirt_loops=0 --set top_layers=0 --set bottom_layers=0 -o "$out/caterpillar.gcode" >/dev/null 2>"$out/log" && files+=("$out/caterpillar.gcode") || failed Caterpillar
  if command -v prusa-slicer >/dev/null; then
    prusa-slicer --export-gcode --loglevel 0 -o "$out/prusa.gcode" --nozzle-diameter 0.4 --filament-diameter 1.75 --layer-height 0.2 --first-layer-height 0.2 --center 110,110 --perimeters 2 \
      --perimeter-generator arachne --fill-density 100% --fill-pattern rectilinear --top-solid-layers 0 --bottom-solid-layers 0 --skirts 0 --extrusion-width 0.45 --perimeter-extrusion-width 0.45 \
      --external-perimeter-extrusion-width 0.45 --infill-extrusion-width 0.45 --solid-infill-extrusion-width 0.45 --first-layer-extrusion-width 0.45 "$out/model.stl" >/dev/null 2>"$out/log" && files+=("$out/prusa.gcode") || failed PrusaSlicer
  fi
  if command -v CuraEngine >/dev/null; then
    definition=$(IFS=:; for folder in $CURA_ENGINE_SEARCH_PATH; do [ -e "$folder/fdmprinter.def.json" ] && echo "$folder/fdmprinter.def.json" && break; done)
    CuraEngine slice -j "$definition" -o "$out/cura.gcode" -s layer_height=0.2 -s layer_height_0=0.2 -s wall_line_count=2 -s infill_pattern=lines -s infill_sparse_density=100 -s infill_line_distance=0.45 \
      -s top_layers=0 -s bottom_layers=0 -s initial_bottom_layers=0 -s adhesion_type=none -s support_enable=false -s machine_nozzle_size=0.4 -s machine_width=220 -s machine_depth=220 -s machine_height=250 \
      -s machine_center_is_zero=false -s center_object=true -s line_width=0.45 -s wall_line_width=0.45 -s wall_line_width_0=0.45 -s wall_line_width_x=0.45 -s infill_line_width=0.45 -s fill_outline_gaps=true \
      -s material_diameter=1.75 -e0 -s material_diameter=1.75 -l "$out/model.stl" >/dev/null 2>"$out/log" && files+=("$out/cura.gcode") || failed CuraEngine
  fi
  [ ${#files[@]} -eq 0 ] || dotnet "$out/bench/Caterpillar.Bench.dll" coverage "$mesh" "${files[@]}"
done
