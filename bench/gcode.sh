#!/usr/bin/env bash
# Reading G-code, whole programs side by side: Caterpillar against the parser of gcode-preview, and reading and writing again,
# unchanged and with relative E, which changes every line that extrudes where E is absolute.
#   bench/gcode.sh FILE.gcode [FOLDER]
# Needs GNU time; gcode-preview is run where node is found, from FOLDER/node_modules, or installed by npm into a temporary folder.
# The runs of the programs take turns, so that a busy machine is as slow for all of them; medians, and their ratio, are printed.
set -eu
cd "$(dirname "$0")/.."
gcode=$(realpath "$1")
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
runs=5

dotnet publish src/Caterpillar.Cli -c Release -o "$out/caterpillar" -v quiet --nologo >/dev/null
caterpillar="$out/caterpillar/Caterpillar.Cli"
jobs=(decode again relative)
decode() { "$caterpillar" decode "$gcode" --json; }
again() { "$caterpillar" convert "$gcode" -o /dev/null; }
relative() { "$caterpillar" convert "$gcode" --e-mode relative -o /dev/null; }

if command -v node >/dev/null; then
  peer=${2:-$out/peer}
  [ -d "$peer/node_modules/gcode-preview" ] || { mkdir -p "$peer"; (cd "$peer" && npm install --silent --no-fund --no-audit gcode-preview@2.18.0 three >/dev/null); }
  # The package shows its viewer only; its parser is the class with parseGCode.
  cat >"$peer/parse.mjs" <<'JS'
import fs from 'fs';
const source = fs.readFileSync(new URL('./node_modules/gcode-preview/dist/gcode-preview.es.js', import.meta.url), 'latin1');
const name = source.slice(source.lastIndexOf('class ', source.indexOf('parseGCode('))).match(/^class (\w+)/)[1];
const module = new URL('./node_modules/gcode-preview/dist/parser.mjs', import.meta.url);
if (process.argv.length < 3) fs.writeFileSync(module, source + `;export{${name} as Parser};`, 'latin1');
else {
  const { Parser } = await import(module);
  new Parser(0).parseGCode(fs.readFileSync(process.argv[2], 'latin1'));
}
JS
  node "$peer/parse.mjs"
  preview() { node "$peer/parse.mjs" "$gcode"; }
  jobs+=(preview)
fi

export -f decode again relative preview 2>/dev/null || true
export caterpillar gcode peer 2>/dev/null || true
for _ in $(seq $runs); do
  for job in "${jobs[@]}"; do command time -f "%e %U %S %M" -a -o "$out/$job" bash -c "$job" >/dev/null 2>"$out/errors" || { cat "$out/errors"; exit 1; }; done
done
median() { sort -n "$out/$1" | awk '{ e[NR] = $1; m[NR] = $4 / 1024; c += $2 + $3 } END { printf "%.2f %.2f %d", e[int((NR + 1) / 2)], c / NR, m[int((NR + 1) / 2)] }'; }
read -r first _ _ <<<"$(median decode)"
for job in "${jobs[@]}"; do
  read -r wall cpu memory <<<"$(median "$job")"
  awk -v job="$job" -v wall="$wall" -v cpu="$cpu" -v memory="$memory" -v first="$first" 'BEGIN { printf "%-8s %6.2f s wall (median), %5.2f s processor (mean), %4d MB, %5.1f x decode\n", job, wall, cpu, memory, wall / first }'
done
