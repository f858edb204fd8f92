#!/usr/bin/env bash
# Builds everything and runs the tests: on .NET and, where `mono` is found, on Mono too. About five minutes on two cores.
#   ./test.sh             run
#   ./test.sh --full      every test on both runtimes, and all random rounds; analyzers for tests, tools and every framework, too
#   ./test.sh --install   install Mono first (Debian, Ubuntu: apt-get, as root or with sudo)
# Closes with "N passed, N failed" on a line of its own, both runtimes counted.
#
# What runs where by default:
#   .NET, the library, the terminal program, the plug-in      every test; random rounds of a size that finds faults
#   Mono, the library      what can differ there: numbers, text, files, archives, JSON, formulas, scripts, G-code, golden files of whole programs; not the rooms
#                          of plain arithmetic over our own types, for which whole programs stand, nor what reads our sources. Of those rooms: category Runtime;
#                          of the others not: category Arithmetic
#   Mono, and the real RhinoCommon and GH_IO on .NET, the plug-in      what depends on the assemblies of the host or on the runtime: category Host
set -u
cd "$(dirname "$0")"

install=no
full=no
for argument in "$@"; do
  case "$argument" in
    --install) install=yes ;;
    --full) full=yes ;;
    *) echo "usage: ./test.sh [--full] [--install]" >&2; exit 2 ;;
  esac
done

if [ "$install" = yes ] && ! command -v mono >/dev/null; then
  sudo=; [ "$(id -u)" = 0 ] || sudo=sudo
  $sudo apt-get update -qq && $sudo env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends mono-complete >/dev/null \
    || { echo "Mono could not be installed." >&2; exit 1; }
fi

mono=yes
command -v mono >/dev/null || { mono=no; echo "Mono not found: Mono tests skipped, ./test.sh --install installs it"; }
real=../shared/reference/real
[ -f "$real/RhinoCommon.dll" ] && [ -f "$real/librhcommon_c.so" ] || real=

# Compilers and tests run too briefly for the profiling of their code to pay. W^X maps all code twice, which takes time where most of it is new.
export DOTNET_TieredPGO=0 DOTNET_EnableWriteXorExecute=0
# Tests make many short-lived arrays, some of them large: with room for these, they take up to a third less processor time.
export DOTNET_GCgen0size=0x4000000 DOTNET_GCLOHThreshold=0x2000000
echo "Building Caterpillar.sln"
analyzers=
[ "$full" = yes ] && analyzers=-p:RunAnalyzers=true
# One compiler that stays for all projects takes a quarter less time; it ends with the last build. It uses more than one core itself: two projects at once on two
# cores only slow each other down.
shared=-p:UseSharedCompilation=true
cores=$(nproc 2>/dev/null || sysctl -n hw.ncpu 2>/dev/null || echo 2)
dotnet build Caterpillar.sln -c Release "-m:$(((cores + 1) / 2))" $shared $analyzers --nologo -v quiet || exit 1
[ -n "$real" ] || echo "Skipped: the plug-in's tests on the real RhinoCommon and GH_IO, which are not at ../shared/reference/real"

arithmetic=
for room in Architecture Checks Curved Geometry Planning Simulation Slicing Toolpaths; do
  arithmetic="$arithmetic&FullyQualifiedName!~Caterpillar.Tests.$room."
done
runtime="(${arithmetic#&}&TestCategory!=Arithmetic)|(FullyQualifiedName~Caterpillar.Tests.Geometry.Meshes.&TestCategory!=Arithmetic)|TestCategory=Runtime"
host="TestCategory=Host"
if [ "$full" = yes ]; then
  export CATERPILLAR_FULL=1
  runtime=
  host=
fi

# Lanes: what is tested, its assembly, and which of its tests; the longest first.
headless=artifacts/headless/bin
lanes=("Caterpillar.Core.Tests on net10.0|$headless/Caterpillar.Core.Tests/release_net10.0/Caterpillar.Core.Tests.dll|")
[ "$mono" = yes ] && lanes+=("Caterpillar.Core.Tests on net48|$headless/Caterpillar.Core.Tests/release_net48/Caterpillar.Core.Tests.dll|$runtime")
lanes+=("Caterpillar.Cli.Tests on net10.0|$headless/Caterpillar.Cli.Tests/release/Caterpillar.Cli.Tests.dll|")
lanes+=("Caterpillar.GH.Tests on net10.0|$headless/Caterpillar.GH.Tests/release_net10.0/Caterpillar.GH.Tests.dll|")
[ "$mono" = yes ] && lanes+=("Caterpillar.GH.Tests on net48|$headless/Caterpillar.GH.Tests/release_net48/Caterpillar.GH.Tests.dll|$host")
real_frameworks=${real:+net10.0}
[ "$full" = yes ] && [ "$mono" = yes ] && real_frameworks="$real_frameworks${real:+ net48}"
for framework in $real_frameworks; do
  lanes+=("Caterpillar.GH.Tests on $framework with the real RhinoCommon and GH_IO|artifacts/real/bin/Caterpillar.GH.Tests/release_$framework/Caterpillar.GH.Tests.dll|$host")
done

# Jobs of their own, so that they take an interrupt as a program in a terminal does.
set -m
log=$(mktemp -d)
lane_jobs=()
trap 'for job in "${lane_jobs[@]}"; do kill -- "-$job" 2>/dev/null; done; rm -rf "$log"; exit 130' INT TERM

# The plug-in for the real RhinoCommon is compiled while the first lane runs. The sources are the same; analyzers have read them.
build_real() {
  local code=0
  for framework in $real_frameworks; do
    dotnet build tests/Caterpillar.GH.Tests -c Release -f "$framework" -p:RhinoSdk=real $shared -p:RunAnalyzers=false --nologo -v quiet || code=1
  done >"$log/real.build" 2>&1 </dev/null
  echo "$code" >"$log/real.code"
  dotnet build-server shutdown --vbcscompiler >/dev/null 2>&1 </dev/null
}

# A folder for temporary files each, where the names that tests choose do not meet. The first lane is the longest: the others leave a core to it.
run() {
  local started=$SECONDS rest=${2#*|}
  local dll=${rest%%|*} filter=${rest#*|}
  mkdir "$log/$1.tmp"
  case "$dll" in artifacts/real/*) while [ ! -f "$log/real.code" ]; do sleep 0.2; done ;; esac
  TMPDIR="$log/$1.tmp" MONO_GC_PARAMS=nursery-size=8m nice -n $(($1 > 0 ? 5 : 0)) \
    dotnet test "$dll" ${filter:+--filter "$filter"} --nologo -v quiet --logger "console;verbosity=minimal" >"$log/$1.log" 2>&1 </dev/null
  echo "$? $((SECONDS - started))" >"$log/$1.done"
}

# As many lanes at once as there are cores; with one more, all of them take a third longer. Only one where golden files are renewed. Their output is shown in
# the order of the lanes.
slots=$cores
[ "${CATERPILLAR_RENEW:-}" = 1 ] && slots=1
failed_lanes=0
next=0
build_real &
lane_jobs+=($!)
for ((shown = 0; shown < ${#lanes[@]}; )); do
  while [ "$next" -lt "${#lanes[@]}" ] && [ "$(jobs -pr | wc -l)" -lt "$slots" ]; do
    run "$next" "${lanes[next]}" &
    lane_jobs+=($!)
    next=$((next + 1))
  done
  if [ -f "$log/$shown.done" ]; then
    read -r code seconds <"$log/$shown.done"
    [ "$code" = 0 ] || failed_lanes=$((failed_lanes + 1))
    echo "Tested ${lanes[shown]%%|*} in $seconds s"
    grep -vE '^(Test run for|VSTest version|Starting test execution|A total of)' "$log/$shown.log" | sed '/^ *$/d'
    shown=$((shown + 1))
  else
    sleep 0.2
  fi
done
set +m
if [ "$(cat "$log/real.code")" != 0 ]; then
  cat "$log/real.build"
  failed_lanes=$((failed_lanes + 1))
fi

# "Passed!  - Failed:     0, Passed:    65, Skipped:     0, Total:    65, ..."
total() { sed -nE "s/.*- Failed: .*$1: +([0-9]+),.*/\1/p" "$log"/*.log | awk '{ n += $1 } END { print n + 0 }'; }
failed=$(sed -nE 's/.*- Failed: +([0-9]+), Passed.*/\1/p' "$log"/*.log | awk '{ n += $1 } END { print n + 0 }')
# A test process that died, or found nothing to run, has no summary line; it counts as a failure.
silent=$(grep -LE -- '- Failed: +[0-9]+, Passed: +[1-9]' "$log"/*.log | wc -l)
if [ "$failed" = 0 ]; then failed=$((failed_lanes > silent ? failed_lanes : silent)); fi
skipped=$(total Skipped)
passed=$(total Passed)
if [ "$failed" = 0 ]; then rm -rf "$log"; else echo "What the lanes wrote is in $log"; fi
echo "$skipped skipped"
echo "$passed passed, $failed failed"
[ "$failed" = 0 ]
