// Looks up every link of the site, and the place on the page that it names.
//   node links.mjs SITE
import { existsSync, readFileSync, readdirSync, statSync } from "node:fs";
import { dirname, join } from "node:path";

const [site] = process.argv.slice(2);
const texts = new Map(readdirSync(site, { recursive: true }).filter((f) => f.endsWith(".html")).map((f) => [join(site, f), readFileSync(join(site, f), "utf8")]));
const places = new Map([...texts].map(([file, text]) => [file, new Set([...text.matchAll(/\sid="([^"]+)"/g)].map((m) => m[1]))]));
const faults = new Set();
let count = 0;
for (const [file, text] of texts) {
  for (const [, link] of text.matchAll(/\s(?:href|src)="([^"]+)"/g)) {
    if (/^([a-z]+:|\/\/)/.test(link)) continue;
    count++;
    const [path, place] = decodeURI(link.replaceAll("&amp;", "&")).split("#");
    let target = path === "" ? file : path.startsWith("/") ? join(site, path) : join(dirname(file), path);
    if (existsSync(target) && statSync(target).isDirectory()) target = join(target, "index.html");
    if (!existsSync(target) || (place && places.has(target) && !places.get(target).has(place))) faults.add(`${file.slice(site.length + 1)} links to ${link}, which is missing.`);
  }
}
for (const fault of faults) console.error(fault);
console.log(`${texts.size} pages, ${count} links`);
process.exit(faults.size ? 1 : 0);
