#!/usr/bin/env bash
# Makes the manual a site with search and the reference of the library. Needs the .NET SDK and Node.
#   tools/site.sh FOLDER     writes FOLDER/index.html and all other pages, and looks up their links
set -eu
cd "$(dirname "$0")/.."
[ $# = 1 ] || { echo "usage: $0 FOLDER" >&2; exit 2; }
mkdir -p "$1"
out=$(cd "$1" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# The pages with what they link to outside of docs, in one folder, so that nothing is written into the sources.
cp -r docs tools/site "$work/"
mkdir -p "$work/docs/public"
cp src/Caterpillar.GH/Resources/package.png "$work/docs/public/icon.png"
dotnet build src/Caterpillar.Core -c Release -f net8.0 --nologo -v quiet
node tools/site/api.mjs src/Caterpillar.Core/PublicApi.txt artifacts/headless/bin/Caterpillar.Core/release_net8.0/Caterpillar.Core.xml "$work/docs/api"
node tools/site/pages.mjs "$PWD" "$work/docs"
cd "$work/site"
npm install --silent --no-fund --no-audit
mkdir -p "$work/docs/.vitepress" && cp config.mjs "$work/docs/.vitepress/"
ln -s "$work/site/node_modules" "$work/node_modules"
npx vitepress build "$work/docs" --outDir "$out"
node links.mjs "$out"
