#!/usr/bin/env bash
# How time and memory of a slice grow with triangles and with layers: a bumpy sphere of 80 mm, 2 walls and 20 % lines. Two tables on standard output.
#   bench/growth.sh [TRIANGLES...]      by default 10⁴ to 10⁷
# Needs GNU time. CATERPILLAR names a published program; RUNS sets how often each is run (3), the least counts.
set -eu
cd "$(dirname "$0")/.."
[ $# -gt 0 ] || set -- 10000 30000 100000 300000 1000000 3000000 10000000
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
caterpillar=${CATERPILLAR:-$(bench/publish.sh "$out/caterpillar")}
dotnet build bench -c Release -v quiet --nologo >/dev/null
sphere() { dotnet run -c Release --no-build --project bench -- mesh "$1" "$out/sphere.stl" >/dev/null; }

# Prints processor seconds, wall seconds and the peak in MB.
measure() {
  rm -f "$out/times"
  for _ in $(seq "${RUNS:-3}"); do
    command time -f "%U %S %e %M" -a -o "$out/times" "$caterpillar" slice "$out/sphere.stl" --set layer_height_mm="$1" --set first_layer_height_mm="$1" --set wall_count=2 \
      --set infill_density_percent=20 --set top_layers=0 --set bottom_layers=0 --set skirt_loops=0 -o "$out/sphere.gcode" >/dev/null 2>&1 || { echo "failed" >&2; return 1; }
  done
  sort -n "$out/times" | awk 'NR == 1 { printf "%.2f %.2f %d", $1 + $2, $3, $4 / 1024 }'
}

echo "| triangles | processor | wall | peak | for each triangle |"
echo "|---|---|---|---|---|"
for triangles in "$@"; do
  sphere "$triangles"
  read -r processor wall peak <<<"$(measure 0.2)"
  awk -v n="$triangles" -v p="$processor" -v w="$wall" -v m="$peak" 'BEGIN { printf "| %d | %.2f s | %.2f s | %d MB | %.2f µs |\n", n, p, w, m, 1e6 * p / n }'
done
echo
echo "| layers, of 100,000 triangles | processor | wall | peak | for each layer |"
echo "|---|---|---|---|---|"
sphere 100000
for height in 0.32 0.16 0.08 0.04; do
  read -r processor wall peak <<<"$(measure $height)"
  layers=$(grep -c '^;LAYER' "$out/sphere.gcode" || true)
  awk -v n="$layers" -v h="$height" -v p="$processor" -v w="$wall" -v m="$peak" 'BEGIN { printf "| %d of %.2f mm | %.2f s | %.2f s | %d MB | %.2f ms |\n", n, h, p, w, m, 1000 * p / n }'
done
