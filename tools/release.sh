#!/usr/bin/env bash
# Builds what a release consists of: NuGet packages (the library, the tool), an archive of the program for each system, and checksums.
#   tools/release.sh FOLDER [RUNTIME...]     for example linux-x64 win-x64 osx-arm64; by default all
set -eu
cd "$(dirname "$0")/.."
[ $# -ge 1 ] || { echo "usage: $0 FOLDER [RUNTIME...]" >&2; exit 2; }
mkdir -p "$1"
out=$(cd "$1" && pwd)
shift
[ $# -gt 0 ] || set -- linux-x64 linux-arm64 osx-x64 osx-arm64 win-x64
version=$(sed -n 's:.*<Version>\(.*\)</Version>.*:\1:p' Directory.Build.props)

dotnet pack src/Caterpillar.Core -c Release -o "$out" --nologo -v quiet
dotnet pack src/Caterpillar.Cli -c Release -o "$out" --nologo -v quiet

# For the machine's own kind of system the program is compiled to native code, where it can be linked; the others bring the runtime with them.
host=$(dotnet --info | sed -n 's/^ *RID: *//p' | head -n 1)
native() { [ "$1" = "$host" ] && { command -v cc >/dev/null || [[ $1 == win-* ]]; }; }

# The notices of the runtime that the program contains, as the SDK states them.
dotnet_notices() { find "$(dirname "$(realpath "$(command -v dotnet)")")" -maxdepth 1 -iname 'ThirdPartyNotices.txt' | head -n 1; }

for runtime in "$@"; do
  name=caterpillar-$version-$runtime
  rm -rf "${out:?}/$name" && mkdir "$out/$name"
  kind=-p:PublishSingleFile=true
  native "$runtime" && kind=-p:Native=true
  dotnet publish src/Caterpillar.Cli -c Release -r "$runtime" --self-contained "$kind" -p:DebugType=none -o "$out/$name/build" --nologo -v quiet
  case $runtime in
    win-*) mv "$out/$name/build/Caterpillar.Cli.exe" "$out/$name/caterpillar.exe" ;;
    *) mv "$out/$name/build/Caterpillar.Cli" "$out/$name/caterpillar" ;;
  esac
  rm -r "$out/$name/build"
  cp README.md LICENSE THIRD-PARTY-NOTICES.md CHANGELOG.md "$out/$name/"
  cp "$(dotnet_notices)" "$out/$name/DOTNET-NOTICES.txt"
  case $runtime in
    win-*) (cd "$out" && zip -qr "$name.zip" "$name") ;;
    *) tar -C "$out" -czf "$out/$name.tar.gz" "$name" ;;
  esac
  rm -r "${out:?}/$name"
done
cd "$out" && sha256sum -- *.nupkg *.snupkg *.tar.gz *.zip 2>/dev/null >SHA256SUMS || true
cat SHA256SUMS
