// Prepares the pages of the manual for the site: files outside of docs are copied beside them, and braces of templates stay text.
//   node pages.mjs REPOSITORY DOCS
import { copyFileSync, existsSync, mkdirSync, readFileSync, readdirSync, rmSync, statSync, writeFileSync } from "node:fs";
import { dirname, join, relative, resolve } from "node:path";

const [repository, docs] = process.argv.slice(2);
const pages = readdirSync(docs, { recursive: true }).filter((f) => f.endsWith(".md") && !f.includes("node_modules"));

for (const page of pages) {
  const file = join(docs, page), original = join(repository, "docs", dirname(page));
  let text = readFileSync(file, "utf8");
  text = text.replace(/\[((?:!\[[^\]]*\]\([^)]*\)|[^\[\]])*)\]\((\.\.\/[^)#\s]+)(#[^)]*)?\)/g, (whole, label, link) => {
    const target = resolve(original, link), path = relative(repository, target);
    if (path.startsWith("docs")) return whole;
    if (!existsSync(target)) throw new Error(`${page} links to ${link}, which is missing.`);
    if (statSync(target).isDirectory()) return label;
    const copy = join(docs, "public", "files", path);
    mkdirSync(dirname(copy), { recursive: true });
    copyFileSync(target, copy);
    // As an element: a link of Markdown would get the ending .html.
    return `<a href="/files/${path}" target="_self">${label}</a>`;
  });
  // Vue would take them for expressions and elements.
  text = text.split(/(```[\s\S]*?```|`[^`\n]*`)/).map((part, i) => (i % 2 ? part : part.replace(/\{\{/g, "&#123;&#123;").replace(/<(?=[A-Z])/g, "&lt;"))).join("");
  text = text.replace(/`([^`\n]*\{\{[^`\n]*)`/g, (_, code) => `<code v-pre>${code.replace(/&/g, "&amp;").replace(/</g, "&lt;")}</code>`);
  text = text.replace(/\]\(([^):]*)README\.md/g, "]($1index.md");
  rmSync(file);
  writeFileSync(file.replace(/README\.md$/, "index.md"), text);
}
