#!/usr/bin/env bash
# Whole programs side by side: Caterpillar against the slicers that are installed.
#   bench/peers.sh MESH.stl
# Needs GNU time; CuraEngine (CURA_ENGINE_SEARCH_PATH names its definitions and extruders) and prusa-slicer are used where found.
# The settings are the same: 0.2 mm layers, width 0.4 mm, 2 walls, 20 % line infill, no skins, no skirt. A comparison counts where printed length and volume agree within 2 %.
set -eu
cd "$(dirname "$0")/.."
mesh=$(realpath "$1")
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
runs=5

dotnet publish src/Caterpillar.Cli -c Release -o "$out/caterpillar" -v quiet --nologo >/dev/null
caterpillar="$out/caterpillar/Caterpillar.Cli"

# Seconds and MB of each run in turn, then the medians.
measure() {
  local name=$1; shift
  for _ in $(seq $runs); do command time -f "%e %U %M" -a -o "$out/$name.times" "$@" >/dev/null 2>&1 || { echo "$name failed"; return; }; done
  sort -n "$out/$name.times" | awk -v name="$name" '{ e[NR] = $1; m[NR] = $3 / 1024 } { u += $2 } END { printf "%-28s %6.2f s wall (median), %5.2f s user (mean), %4d MB\n", name, e[int((NR + 1) / 2)], u / NR, m[int((NR + 1) / 2)] }'
}

settings=(--set layer_height_mm=0.2 --set first_layer_height_mm=0.2 --set line_width_mm=0.4 --set bead_shape=rectangle --set wall_count=2 --set infill_percent=20 --set skirt_loops=0)
measure caterpillar-slice "$caterpillar" slice "$mesh" "${settings[@]}" -o "$out/caterpillar.gcode"

if command -v CuraEngine >/dev/null; then
  definition=$(IFS=:; for folder in ${CURA_ENGINE_SEARCH_PATH:-/usr/share/cura/resources/definitions}; do [ -e "$folder/fdmprinter.def.json" ] && echo "$folder/fdmprinter.def.json" && break; done)
  export CURA_ENGINE_SEARCH_PATH=${CURA_ENGINE_SEARCH_PATH:-/usr/share/cura/resources/definitions:/usr/share/cura/resources/extruders}
  measure cura-slice CuraEngine slice -m"$(nproc)" -j "$definition" -o "$out/cura.gcode" -s layer_height=0.2 -s layer_height_0=0.2 -s wall_line_count=2 -s infill_pattern=lines -s infill_sparse_density=20 \
    -s infill_line_distance=2 -s top_layers=0 -s bottom_layers=0 -s initial_bottom_layers=0 -s adhesion_type=none -s support_enable=false -s machine_nozzle_size=0.4 -s machine_width=220 -s machine_depth=220 \
    -s machine_height=250 -s machine_center_is_zero=false -s center_object=true -s retraction_enable=true -s retraction_amount=0.8 -s retraction_min_travel=1.5 -s line_width=0.4 -s wall_line_width=0.4 -s wall_line_width_0=0.4 \
    -s wall_line_width_x=0.4 -s infill_line_width=0.4 -s material_diameter=1.75 -e0 -s material_diameter=1.75 -l "$mesh"
fi
if command -v prusa-slicer >/dev/null; then
  measure prusa-slice prusa-slicer --export-gcode --loglevel 0 -o "$out/prusa.gcode" --nozzle-diameter 0.4 --filament-diameter 1.75 --layer-height 0.2 --first-layer-height 0.2 --center 110,110 --perimeters 2 \
    --fill-density 20% --fill-pattern rectilinear --top-solid-layers 0 --bottom-solid-layers 0 --skirts 0 --extrusion-width 0.4 --perimeter-extrusion-width 0.4 --external-perimeter-extrusion-width 0.4 \
    --infill-extrusion-width 0.4 --first-layer-extrusion-width 0.4 "$mesh"
fi
for file in caterpillar cura prusa; do
  [ -e "$out/$file.gcode" ] || continue
  "$caterpillar" decode "$out/$file.gcode" --json 2>/dev/null | awk -v name="$file" -F'[:,]' '/"print_length"/ { l = $2 } /"e_used"/ { e = $2 } END { printf "%-28s %s mm printed, %s mm of filament\n", name, l, e }'
done
