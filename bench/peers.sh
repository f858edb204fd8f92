#!/usr/bin/env bash
# Whole programs side by side: Caterpillar against the slicers that are installed.
#   bench/peers.sh MESH... [-- JOB...]
# Jobs: infill (2 walls and 20 % lines), walls (2 walls alone), vase, full (skins, bridges, supports, seams aligned); all of them by default.
# Caterpillar is published as native code where a C compiler is found to link it; CATERPILLAR names another program. Needs GNU time; CuraEngine (CURA_ENGINE_SEARCH_PATH names its definitions and extruders) and prusa-slicer are used where found. RUNS sets how often (3).
# Caterpillar has two rows: with all its checks, and with the peers' work alone (nothing looks for collisions or at extrusions, as in no peer; what is written is
# still read back and compared with the plan). The settings are the same: 0.2 mm layers, width 0.4 mm, retraction 0.8 mm, no skirt. A comparison counts where printed length and filament agree within 2 %.
# The programs take turns, so that a busy machine is as slow for all of them.
set -eu
cd "$(dirname "$0")/.."
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
runs=${RUNS:-3}
meshes=()
jobs=()
while [ $# -gt 0 ] && [ "$1" != -- ]; do
  mesh=$(realpath "$1")
  # CuraEngine reads STL only; all of them get the same file.
  if [[ $mesh != *.stl ]]; then
    stl="$out/$(basename "${mesh%.*}").stl"
    dotnet run -c Release --project bench -- stl "$mesh" "$stl" >/dev/null
    mesh=$stl
  fi
  meshes+=("$mesh")
  shift
done
[ $# -gt 0 ] && shift
jobs=("$@")
[ ${#jobs[@]} -gt 0 ] || jobs=(infill walls vase full)

caterpillar=${CATERPILLAR:-$(bench/publish.sh "$out/caterpillar")}
export CURA_ENGINE_SEARCH_PATH=${CURA_ENGINE_SEARCH_PATH:-/usr/share/cura/resources/definitions:/usr/share/cura/resources/extruders}
definition=$(IFS=:; for folder in $CURA_ENGINE_SEARCH_PATH; do [ -e "$folder/fdmprinter.def.json" ] && echo "$folder/fdmprinter.def.json" && break; done) || true

slice() {
  case $2 in
    infill) options=(wall_count=2 infill_density_percent=20 top_layers=0 bottom_layers=0 top_thickness_mm=0 bottom_thickness_mm=0);;
    walls) options=(wall_count=2 infill_density_percent=0 top_layers=0 bottom_layers=0 top_thickness_mm=0 bottom_thickness_mm=0);;
    vase) options=(spiral_vase=true bottom_layers=3 bottom_thickness_mm=0 wall_count=1 infill_density_percent=0 top_layers=0 top_thickness_mm=0);;
    full) options=(wall_count=2 infill_density_percent=20 top_layers=4 bottom_layers=4 top_thickness_mm=0 bottom_thickness_mm=0 support=grid support_angle_deg=50 support_density_percent=15);;
  esac
  local set=()
  for option in "${options[@]}" layer_height_mm=0.2 first_layer_height_mm=0.2 line_width_mm=0.4 bead_shape=rectangle skirt_loops=0 retraction_length_mm=0.8; do set+=(--set "$option"); done
  "$caterpillar" slice "$1" "${set[@]}" "${@:3}" --override "bench" -o "$out/caterpillar.gcode"
}
unchecked() {
  slice "$1" "$2" --set check_severities=extrusion.unsupported=off,extrusion.duplicate=off,extrusion.squeezed=off,extrusion.width=off,extrusion.height=off,extrusion.gap=off,extrusion.blob=off,nozzle.too_low=off,\
first_layer.area=off,first_layer.in_air=off,collision.nozzle=off,collision.travel=off,collision.head=off,collision.gantry=off,collision.clip=off,collision.slope=off
}
cura() {
  case $2 in
    infill) options=(wall_line_count=2 infill_sparse_density=20 infill_line_distance=2 top_layers=0 bottom_layers=0 initial_bottom_layers=0 support_enable=false);;
    walls) options=(wall_line_count=2 infill_sparse_density=0 infill_line_distance=0 top_layers=0 bottom_layers=0 initial_bottom_layers=0 support_enable=false);;
    vase) options=(magic_spiralize=true wall_line_count=1 infill_sparse_density=0 infill_line_distance=0 top_layers=0 bottom_layers=3 initial_bottom_layers=3 support_enable=false);;
    full) options=(wall_line_count=2 infill_sparse_density=20 infill_line_distance=2 top_layers=4 bottom_layers=4 initial_bottom_layers=4 support_enable=true support_type=everywhere
      support_angle=50 support_pattern=lines support_infill_rate=15 support_line_distance=2.667 bridge_settings_enabled=true z_seam_type=back);;
  esac
  local set=()
  for option in "${options[@]}" layer_height=0.2 layer_height_0=0.2 infill_pattern=lines adhesion_type=none machine_nozzle_size=0.4 machine_width=220 machine_depth=220 machine_height=250 \
    machine_center_is_zero=false center_object=true retraction_enable=true retraction_amount=0.8 retraction_min_travel=1.5 line_width=0.4 wall_line_width=0.4 wall_line_width_0=0.4 \
    wall_line_width_x=0.4 infill_line_width=0.4 skin_line_width=0.4 support_line_width=0.4 material_diameter=1.75; do set+=(-s "$option"); done
  CuraEngine slice -m"$(nproc)" -j "$definition" -o "$out/cura.gcode" "${set[@]}" -e0 -s material_diameter=1.75 -l "$1"
}
prusa() {
  case $2 in
    infill) options=(--perimeters 2 --fill-density 20% --top-solid-layers 0 --bottom-solid-layers 0);;
    walls) options=(--perimeters 2 --fill-density 0% --top-solid-layers 0 --bottom-solid-layers 0);;
    vase) options=(--spiral-vase --perimeters 1 --fill-density 0% --top-solid-layers 0 --bottom-solid-layers 3);;
    full) options=(--perimeters 2 --fill-density 20% --top-solid-layers 4 --bottom-solid-layers 4 --support-material --support-material-threshold 40 --support-material-spacing 2.667);;
  esac
  prusa-slicer --export-gcode --loglevel 0 -o "$out/prusa.gcode" --nozzle-diameter 0.4 --filament-diameter 1.75 --layer-height 0.2 --first-layer-height 0.2 --center 110,110 --fill-pattern rectilinear \
    --skirts 0 --extrusion-width 0.4 --perimeter-extrusion-width 0.4 --external-perimeter-extrusion-width 0.4 --infill-extrusion-width 0.4 --solid-infill-extrusion-width 0.4 \
    --first-layer-extrusion-width 0.4 --retract-length 0.8 "${options[@]}" "$1"
}
programs=(slice unchecked)
[ -n "$definition" ] && command -v CuraEngine >/dev/null && programs+=(cura)
command -v prusa-slicer >/dev/null && programs+=(prusa)
export -f slice unchecked cura prusa
export caterpillar definition out

echo "| mesh | job | program | wall | user | peak | printed | filament |"
echo "|---|---|---|---|---|---|---|---|"
for mesh in "${meshes[@]}"; do
  for job in "${jobs[@]}"; do
    rm -f "$out"/*.times "$out"/*.gcode
    for _ in $(seq "$runs"); do
      for program in "${programs[@]}"; do
        command time -f "%e %U %M" -a -o "$out/$program.times" timeout 300 bash -c "$program \"\$@\"" "$program" "$mesh" "$job" >/dev/null 2>&1 || echo "$program failed on $(basename "$mesh") ($job)" >&2
      done
    done
    for program in "${programs[@]}"; do
      file="$out/$program.gcode"
      label=$program
      case $program in
        slice) file="$out/caterpillar.gcode"; label="caterpillar, all checks";;
        unchecked) file="$out/caterpillar.gcode"; label="caterpillar, the peers' work";;
      esac
      [ -s "$file" ] || continue
      work=$("$caterpillar" decode "$file" --json 2>/dev/null | awk -F'[:,]' '/"print_length"/ { l = $2 } /"e_used"/ { e = $2 } END { printf "%.1f m | %.2f m", l / 1000, e / 1000 }')
      grep -E '^[0-9.]+ [0-9.]+ [0-9]+$' "$out/$program.times" | sort -n | awk -v mesh="$(basename "$mesh")" -v job="$job" -v name="$label" -v work="$work" \
        '{ e[NR] = $1; u += $2; m[NR] = $3 / 1024 } END { printf "| %s | %s | %s | %.2f s | %.2f s | %d MB | %s |\n", mesh, job, name, e[int((NR + 1) / 2)], u / NR, m[int((NR + 1) / 2)], work }'
    done
  done
done
