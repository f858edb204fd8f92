#!/usr/bin/env bash
# Builds the release of the plug-in and packs it for Rhino's package manager: artifacts/package/*.yak
#   ./package.sh               against McNeel's packages from NuGet
set -eu
cd "$(dirname "$0")"
# Paths of this folder stay out of what is compiled.
export ContinuousIntegrationBuild=true
version=$(sed -nE 's/.*<Version>(.*)<\/Version>.*/\1/p' Directory.Build.props)
dotnet build src/Caterpillar.GH -c Release -p:RhinoSdk=nuget --nologo -v quiet
gha=artifacts/nuget/gha
dotnet run --project tools/Caterpillar.Package -- "$gha/net48" "$gha/net8.0" src/Caterpillar.GH/Resources/package.png . "$version" artifacts/package
