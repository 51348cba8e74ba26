// Bundles the viewer with the part of three.js that it uses: node build.mjs FILE

import { readFile } from "node:fs/promises";
import { build } from "esbuild";

const [outfile] = process.argv.slice(2);
const licence = await readFile(new URL("node_modules/three/LICENSE", import.meta.url), "utf8");

await build({
  entryPoints: [new URL("viewer.js", import.meta.url).pathname],
  outfile,
  bundle: true,
  minify: true,
  format: "iife",
  target: "es2021",
  charset: "utf8",
  legalComments: "none",
  banner: { js: `/*! This page holds three.js.\n\n${licence.trim()}\n*/` },
});
