import { readFileSync, readdirSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const docs = join(dirname(fileURLToPath(import.meta.url)), "..");

// The sidebar is the index of the manual: its headings and the first link of each line.
function sidebar() {
  const groups = [];
  for (const line of readFileSync(join(docs, "index.md"), "utf8").split("\n")) {
    const heading = /^## (.*)/.exec(line), links = [...line.matchAll(/\[([^\]]+)\]\(([^)]+)\)/g)];
    if (heading) groups.push({ text: heading[1], collapsed: false, items: [] });
    else if (groups.length) for (const [, text, link] of links) groups.at(-1).items.push({ text: text[0].toUpperCase() + text.slice(1), link: "/" + link.replace(/index\.md$|\.md$/, "") });
  }
  groups.push({ text: "API", collapsed: true, items: readdirSync(join(docs, "api")).sort().map((f) => f.replace(/\.md$/, "")).map((f) => ({ text: f, link: "/api/" + f })) });
  return groups;
}

export default {
  title: "Caterpillar",
  description: "Designs to 3D-printer motion, and G-code back to toolpaths.",
  cleanUrls: false,
  // Files beside the pages; pages.mjs has looked for them.
  ignoreDeadLinks: [/^\/files\//],
  srcExclude: ["public/**"],
  head: [["link", { rel: "icon", href: "/icon.png" }]],
  markdown: {
    languages: ["python", "bash", "json", "csv", "csharp", "html", "powershell"],
    // Programs of turtles have the comments of Python.
    languageAlias: { turtle: "python" },
    // The names of headings are those of the same pages on GitHub.
    anchor: { slugify: (heading) => heading.trim().toLowerCase().replace(/[^\p{L}\p{N}\s_-]/gu, "").replace(/\s/g, "-") },
  },
  themeConfig: { logo: "/icon.png", search: { provider: "local" }, sidebar: sidebar(), outline: [2, 3], nav: [{ text: "Components", link: "/components/" }] },
};
