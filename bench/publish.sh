#!/usr/bin/env bash
# Publishes the program into a folder, as native code where a C compiler is found to link it, and prints its path.
#   bench/publish.sh FOLDER
set -eu
cd "$(dirname "$0")/.."
dotnet publish src/Caterpillar.Cli -c Release -o "$1" -v quiet --nologo >&2
echo "$1/Caterpillar.Cli"
