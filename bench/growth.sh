#!/usr/bin/env bash
# How time and memory of a slice grow: with triangles and with layers (a bumpy sphere of 80 mm), with copies of a small sphere of 8 mm and with islands (pins of 3 mm
# in one mesh). 2 walls and 20 % lines, all checks. And those of curves: with their number (lines of 1.5 mm, 10,000 in a layer). Five tables on standard output.
#   bench/growth.sh [TRIANGLES...]      by default 10⁴ to 10⁷
# LAYER_HEIGHTS, COPIES, ISLANDS and PATHS set the other rows; empty ones leave a table out.
# Needs GNU time. CATERPILLAR names a published program; RUNS sets how often each is run (3), the least counts.
set -eu
cd "$(dirname "$0")/.."
[ $# -gt 0 ] || set -- 10000 30000 100000 300000 1000000 3000000 10000000
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
caterpillar=${CATERPILLAR:-$(bench/publish.sh "$out/caterpillar")}
dotnet build bench -c Release -v quiet --nologo >/dev/null
sphere() { dotnet run -c Release --no-build --project bench -- mesh "$1" "$out/sphere.stl" >/dev/null; }

# Prints processor seconds, wall seconds and the peak in MB: timed VERB FILE OPTION...
timed() {
  rm -f "$out/times"
  for _ in $(seq "${RUNS:-3}"); do
    command time -f "%U %S %e %M" -a -o "$out/times" "$caterpillar" "$@" -o "$out/print.gcode" >/dev/null 2>&1 || { echo "failed" >&2; return 1; }
  done
  sort -n "$out/times" | awk 'NR == 1 { printf "%.2f %.2f %d", $1 + $2, $3, $4 / 1024 }'
}

# The same of a slice: measure MODEL LAYER_HEIGHT OPTION...
measure() {
  local model=$1 height=$2
  shift 2
  timed slice "$out/$model.stl" --set layer_height_mm="$height" --set first_layer_height_mm="$height" --set wall_count=2 --set infill_density_percent=20 \
    --set skirt_loops=0 "$@"
}

# A row: row COUNT UNITS_PER_SECOND UNIT PROCESSOR WALL PEAK
row() { awk -v n="$1" -v k="$2" -v u="$3" -v p="$4" -v w="$5" -v m="$6" 'BEGIN { printf "| %s | %.2f s | %.2f s | %d MB | %.2f %s |\n", n, p, w, m, k * p / n, u }'; }

open=(--set top_layers=0 --set bottom_layers=0)
echo "| triangles | processor | wall | peak | for each triangle |"
echo "|---|---|---|---|---|"
for triangles in "$@"; do
  sphere "$triangles"
  read -r processor wall peak <<<"$(measure sphere 0.2 "${open[@]}")"
  row "$triangles" 1e6 µs "$processor" "$wall" "$peak"
done
echo
echo "| layers, of 100,000 triangles | processor | wall | peak | for each layer |"
echo "|---|---|---|---|---|"
sphere 100000
for height in ${LAYER_HEIGHTS-0.32 0.16 0.08 0.04}; do
  read -r processor wall peak <<<"$(measure sphere $height "${open[@]}")"
  layers=$(grep -c '^;LAYER' "$out/print.gcode" || true)
  row "$layers" 1000 ms "$processor" "$wall" "$peak"
done
echo
echo "| copies | processor | wall | peak | for each copy |"
echo "|---|---|---|---|---|"
sphere 2000
for copies in ${COPIES-10 20 40 80 160 320 1000}; do
  read -r processor wall peak <<<"$(measure sphere 0.2 --scale 8mm --copies "$copies" --set "build_volume_mm=[1000,1000,100]")"
  row "$copies" 1000 ms "$processor" "$wall" "$peak"
done
echo
echo "| islands a layer | processor | wall | peak | for each island |"
echo "|---|---|---|---|---|"
for islands in ${ISLANDS-1 10 100 1000 3000 10000}; do
  dotnet run -c Release --no-build --project bench -- pins "$islands" "$out/pins.stl" >/dev/null
  read -r processor wall peak <<<"$(measure pins 0.2 --set "build_volume_mm=[1000,1000,100]")"
  row "$islands" 1000 ms "$processor" "$wall" "$peak"
done
echo
echo "| paths | processor | wall | peak | for each path |"
echo "|---|---|---|---|---|"
for paths in ${PATHS-100 1000 10000 100000 1000000}; do
  awk -v n="$paths" 'BEGIN {
    print "curve,x,y,z"
    for (i = 0; i < n; i++) {
      x = 10 + i % 100 * 2; y = 10 + int(i / 100) % 100 * 2; z = 0.2 + int(i / 10000) * 0.2
      printf "%d,%g,%g,%g\n%d,%g,%g,%g\n", i, x, y, z, i, x + 1.5, y, z
    }
  }' >"$out/paths.csv"
  read -r processor wall peak <<<"$(timed curves "$out/paths.csv")"
  row "$paths" 1e6 µs "$processor" "$wall" "$peak"
done
