#!/usr/bin/env bash
# Builds everything and runs all tests: on .NET and, where `mono` is found, on Mono too.
#   ./test.sh             run
#   ./test.sh --install   install Mono first (Debian, Ubuntu: apt-get, as root or with sudo)
# Closes with "N passed, N failed" on a line of its own, both runtimes counted.
set -u
cd "$(dirname "$0")"

install=no
for argument in "$@"; do
  case "$argument" in
    --install) install=yes ;;
    *) echo "usage: ./test.sh [--install]" >&2; exit 2 ;;
  esac
done

if [ "$install" = yes ] && ! command -v mono >/dev/null; then
  sudo=; [ "$(id -u)" = 0 ] || sudo=sudo
  $sudo apt-get update -qq && $sudo env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends mono-complete >/dev/null \
    || { echo "Mono could not be installed." >&2; exit 1; }
fi

log=$(mktemp -d)
trap 'rm -rf "$log"' EXIT
failed_steps=0

echo "Building Caterpillar.sln"
dotnet build Caterpillar.sln --nologo -v quiet || exit 1

frameworks="net10.0"
if command -v mono >/dev/null; then
  frameworks="net10.0 net48"
else
  echo "Mono not found: Mono tests skipped, ./test.sh --install installs it"
fi

for project in tests/*.Tests/*.Tests.csproj; do
  name=$(basename "$project" .csproj)
  # These run inside Rhino only.
  [ "$name" = Caterpillar.Rhino.Tests ] && continue
  for framework in $frameworks; do
    grep -q "$framework" "$project" || continue
    echo "Testing $name on $framework"
    out="$log/$name.$framework"
    dotnet test "$project" -f "$framework" --no-build --nologo -v quiet --logger "console;verbosity=minimal" >"$out" 2>&1 || failed_steps=$((failed_steps + 1))
    grep -vE '^(Test run for|VSTest version|Starting test execution|A total of)' "$out" | sed '/^ *$/d'
  done
done

# The plug-in's tests again on McNeel's own RhinoCommon and GH_IO, where they lie next to the project.
real=../shared/reference/real
if [ -f "$real/RhinoCommon.dll" ] && [ -f "$real/librhcommon_c.so" ]; then
  for framework in $frameworks; do
    echo "Testing Caterpillar.GH.Tests on $framework with the real RhinoCommon and GH_IO"
    out="$log/real.$framework"
    dotnet build tests/Caterpillar.GH.Tests -f "$framework" -p:RhinoSdk=real --nologo -v quiet || { failed_steps=$((failed_steps + 1)); continue; }
    dotnet test tests/Caterpillar.GH.Tests -f "$framework" -p:RhinoSdk=real --no-build --nologo -v quiet --logger "console;verbosity=minimal" >"$out" 2>&1 || failed_steps=$((failed_steps + 1))
    grep -vE '^(Test run for|VSTest version|Starting test execution|A total of)' "$out" | sed '/^ *$/d'
  done
else
  echo "Skipped: the plug-in's tests on the real RhinoCommon and GH_IO, which are not at $real"
fi

# "Passed!  - Failed:     0, Passed:    65, Skipped:     0, Total:    65, ..."
total() { sed -nE "s/.*- Failed: .*$1: +([0-9]+),.*/\1/p" "$log"/* | awk '{ n += $1 } END { print n + 0 }'; }
failed=$(sed -nE 's/.*- Failed: +([0-9]+), Passed.*/\1/p' "$log"/* | awk '{ n += $1 } END { print n + 0 }')
# A test process that died has no summary line; it counts as a failure.
if [ "$failed" = 0 ] && [ "$failed_steps" -gt 0 ]; then failed=$failed_steps; fi
echo "$(total Skipped) skipped"
echo "$(total Passed) passed, $failed failed"
[ "$failed" = 0 ]
