#!/usr/bin/env bash
# Builds what a release consists of: NuGet packages (the library, the tool), an archive of the program for each system, a bill of materials, and checksums.
# The same sources give the same bytes: in archives and packages, files are in one order and have one time.
#   tools/release.sh FOLDER [RUNTIME...]     for example linux-x64 win-x64 osx-arm64; by default all
set -eu
cd "$(dirname "$0")/.."
[ $# -ge 1 ] || { echo "usage: $0 FOLDER [RUNTIME...]" >&2; exit 2; }
mkdir -p "$1"
out=$(cd "$1" && pwd)
shift
[ $# -gt 0 ] || set -- linux-x64 linux-arm64 osx-x64 osx-arm64 win-x64
# Paths of this folder stay out of what is compiled.
export ContinuousIntegrationBuild=true
version=$(sed -n 's:.*<Version>\(.*\)</Version>.*:\1:p' Directory.Build.props)

dotnet pack src/Caterpillar.Core -c Release -o "$out" --nologo -v quiet
# The tool is compiled ahead of time for each of these systems; on all others it is compiled when it runs.
tool=$(printf '%s;' "$@")any
dotnet pack src/Caterpillar.Cli -c Release -o "$out" --nologo -v quiet "-p:ToolPackageRuntimeIdentifiers=\"$tool\""

same_time() { find "$1" -exec touch -d 2000-01-01T00:00:00Z {} +; }

# Adds names from standard input, of files in the folder: zipped FOLDER FILE.zip
zipped() { (cd "$1" && LC_ALL=C sort | zip -qX "$2" -@); }

for package in "$out"/*.nupkg "$out"/*.snupkg; do
  parts=$(mktemp -d)
  unzip -q "$package" -d "$parts"
  rm "$package"
  same_time "$parts"
  (cd "$parts" && find . -type f) | zipped "$parts" "$package"
  rm -r "$parts"
done

# For the machine's own kind of system the program is compiled to native code, where it can be linked; the others bring the runtime with them.
host=$(dotnet --info | sed -n 's/^ *RID: *//p' | head -n 1)
native() { [ "$1" = "$host" ] && { command -v cc >/dev/null || [[ $1 == win-* ]]; }; }

# The notices of the runtime that the program contains, as the SDK states them.
dotnet_notices() { find "$(dirname "$(realpath "$(command -v dotnet)")")" -maxdepth 1 -iname 'ThirdPartyNotices.txt' | head -n 1; }

for runtime in "$@"; do
  name=caterpillar-$version-$runtime
  rm -rf "${out:?}/$name" && mkdir "$out/$name"
  kind=-p:BundleRuntime=true
  native "$runtime" && kind=-p:Native=true
  dotnet publish src/Caterpillar.Cli -c Release -r "$runtime" "$kind" -p:DebugType=none -o "$out/$name/build" --nologo -v quiet
  case $runtime in
    win-*) mv "$out/$name/build/Caterpillar.Cli.exe" "$out/$name/caterpillar.exe" ;;
    *) mv "$out/$name/build/Caterpillar.Cli" "$out/$name/caterpillar" ;;
  esac
  rm -r "$out/$name/build"
  cp src/Caterpillar.Cli/README.md LICENSE THIRD-PARTY-NOTICES.md CHANGELOG.md "$out/$name/"
  cp "$(dotnet_notices)" "$out/$name/DOTNET-NOTICES.txt"
  mkdir "$out/$name/examples"
  cp -r examples/models examples/turtle examples/curves "$out/$name/examples/"
  same_time "$out/$name"
  case $runtime in
    win-*) (cd "$out" && find "$name" -type f) | zipped "$out" "$out/$name.zip" ;;
    *) tar -C "$out" --sort=name --owner=0 --group=0 --numeric-owner -c "$name" | gzip -n >"$out/$name.tar.gz" ;;
  esac
  rm -r "${out:?}/$name"
done
# What is inside, for whoever has to know: CycloneDX.
tools=$(mktemp -d)
trap 'rm -rf "$tools"' EXIT
dotnet tool install CycloneDX --version 6.3.1 --tool-path "$tools" >/dev/null
for project in Core Cli GH; do
  "$tools/dotnet-CycloneDX" "src/Caterpillar.$project/Caterpillar.$project.csproj" -o "$out" -fn "caterpillar-$version-$(echo $project | tr A-Z a-z).cdx.json" -F Json -rs -ns >/dev/null
done
cd "$out" && sha256sum -- *.nupkg *.snupkg *.tar.gz *.zip *.cdx.json 2>/dev/null >SHA256SUMS || true
cat SHA256SUMS
