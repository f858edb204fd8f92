// The reference of the library as Markdown, a page for each namespace: the list of public members, with the sentences that the compiler writes beside it.
//   node api.mjs PublicApi.txt Caterpillar.Core.xml FOLDER
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";

const [list, xml, folder] = process.argv.slice(2);

const plain = (text) => text
  .replace(/<see(?:also)? cref="[A-Z]:([^"]+)"\s*\/>/g, (_, name) => "`" + name.replace(/\(.*/, "").split(".").slice(-1)[0].replace(/`+\d/, "") + "`")
  .replace(/<(?:see langword|paramref name|typeparamref name)="([^"]+)"\s*\/>/g, "`$1`")
  .replace(/<c>([\s\S]*?)<\/c>/g, "`$1`").replace(/<[^>]+>/g, " ")
  .replace(/&lt;/g, "<").replace(/&gt;/g, ">").replace(/&amp;/g, "&").replace(/\s+/g, " ").replace(/\|/g, "\\|").trim();
const part = (body, tag) => plain(new RegExp(`<${tag}(?:\\s[^>]*)?>([\\s\\S]*?)</${tag}>`).exec(body)?.[1] ?? "");

// Sentences by type and name of a member; overloads in the order of the documentation.
const sentences = new Map();
for (const [, name, body] of readFileSync(xml, "utf8").matchAll(/<member name="[A-Z]:Caterpillar\.([^"]+)">([\s\S]*?)<\/member>/g)) {
  const key = name.replace(/\(.*/, "").replace(/`+\d+/g, "").replace("#ctor", "new");
  const text = [part(body, "summary"), part(body, "value"), part(body, "returns")].filter(Boolean).join(" ");
  const parameters = name.includes("(") ? name.split(",").length : 0;
  sentences.set(key, [...(sentences.get(key) ?? []), { text, parameters }]);
}

function sentenceOf(type, line) {
  const signature = line.replace(/ \{ .*| = [^,)]*$/, ""), open = signature.indexOf("(");
  const name = (open >= 0 ? signature.slice(0, open) : signature).split(" ").at(-1).replace(/<.*/, "");
  const found = sentences.get(`${type.replace(/<.*/, "")}.${name}`) ?? [];
  const parameters = open < 0 || signature[open + 1] === ")" ? 0 : signature.split(", ").length;
  return (found.find((s) => s.parameters === parameters) ?? found[0])?.text ?? "";
}

const spaces = new Map();
for (const line of readFileSync(list, "utf8").split("\n").filter(Boolean)) {
  const at = line.indexOf(" "), type = line.slice(0, at), space = type.split(".")[0];
  if (!spaces.has(space)) spaces.set(space, new Map());
  const types = spaces.get(space);
  types.set(type, [...(types.get(type) ?? []), line.slice(at + 1)]);
}
mkdirSync(folder, { recursive: true });
for (const [space, types] of spaces) {
  const lines = [`# Caterpillar.${space}`, ""];
  for (const [type, members] of types) {
    const kind = members.find((m) => /^((static|sealed|abstract|readonly) )*(class|struct|enum|interface|record)\b/.test(m)) ?? "";
    lines.push(`## ${type.slice(space.length + 1).replace(/</g, "&lt;")}`, "", sentences.get(type.replace(/<.*/, ""))?.[0].text ?? "", "", kind ? `\`${kind}\`` : "", "");
    const own = members.filter((m) => m !== kind);
    if (own.length) lines.push("| member | |", "|---|---|", ...own.map((m) => `| \`${m.replace(/\|/g, "\\|")}\` | ${sentenceOf(type, m)} |`), "");
  }
  writeFileSync(join(folder, space + ".md"), lines.join("\n"));
}
