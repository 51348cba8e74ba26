// node look.mjs BROWSER SWEEPC EXAMPLES SCRATCH [--keep]

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { existsSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";

import pixelmatch from "pixelmatch";
import { chromium } from "playwright-core";
import { PNG } from "pngjs";

import { point } from "./net.mjs";

const [executablePath, sweepc, examples, scratch, mode] = process.argv.slice(2);
const kept = new URL("kept/", import.meta.url);
const seen = new URL("out/", import.meta.url);
const SIZE = { width: 1280, height: 800 };
// The part of the pixels that may differ from the kept picture: browsers smooth lines in their ways.
const TOLERANCE = 0.001;
// The pixels that each part of a picture changes at least.
const PART = 200;
const THRESHOLD = 0.2;

// An example, the page to look at, and the surface that a click in the middle meets.
const PAGES = [
  { example: "paper/example_2", page: "example_2-R" },
  { example: "paper/quarter_torus", page: "quarter_torus-R", at: [0.56, 0.42] },
  { example: "design/duct_bend", page: "duct_bend", at: [0.62, 0.5] },
];
const DRAWINGS = ["example_2-R", "duct_bend"];

function compile(example) {
  const file = join(examples, `${example}.sweep`);
  const own = spawnSync(sweepc, ["compile", file, "--emit", "html,svg,json", "-o", scratch]);
  assert.equal(own.status, 0, `${example}: ${own.stderr}`);
}

// Whether the compiler proves of an example that its surface has a point at some parameters.
function proves(example, surface, [u, v], coordinates, generators) {
  const source = readFileSync(join(examples, `${example}.sweep`), "utf8");
  // r2 before r1: a square is written in the generators before it.
  const written = [...generators].reverse().reduce(
    (text, { name, square }) => text.replaceAll(name, `sqrt(${square})`),
    coordinates.join(", "),
  );
  const text = `${source}\nexpect ${surface}(${u}, ${v}) == (${written})\n`;
  const own = spawnSync(sweepc, ["check", "-", "--quiet"], { input: text });
  assert.ok([0, 1].includes(own.status), `${own.stderr}`);
  return own.status === 0;
}

function difference(one, other) {
  const { width, height } = one;
  return pixelmatch(one.data, other.data, null, width, height, { threshold: THRESHOLD });
}

function compare(name, bytes) {
  mkdirSync(seen, { recursive: true });
  mkdirSync(kept, { recursive: true });
  writeFileSync(new URL(`${name}.png`, seen), bytes);
  const picture = PNG.sync.read(bytes);
  const colours = new Set();
  for (let k = 0; k < picture.data.length; k += 4) {
    colours.add(picture.data.readUInt32BE(k));
  }
  assert.ok(colours.size > 200, `${name} is blank: ${colours.size} colours`);
  const place = new URL(`${name}.png`, kept);
  if (mode === "--keep") writeFileSync(place, bytes);
  assert.ok(existsSync(place), `no kept picture of ${name}: run with --keep`);
  const other = PNG.sync.read(readFileSync(place));
  const { width, height } = picture;
  assert.deepEqual([other.width, other.height], [width, height], name);
  const count = difference(picture, other);
  const part = count / (width * height);
  assert.ok(part <= TOLERANCE, `${name} differs from the kept picture in ${count} pixels`);
  console.log(`${name}: ${count} of ${width * height} pixels differ`);
}

const browser = await chromium.launch({
  executablePath,
  args: [
    "--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
    "--disable-quic", "--no-first-run", "--disable-background-networking",
    "--disable-component-update", "--disable-sync",
  ],
});

// A page without a network, which must say nothing on its console.
async function open(file) {
  const context = await browser.newContext({ viewport: SIZE, offline: true });
  const page = await context.newPage();
  const told = [];
  page.on("console", (own) => {
    // The driver of software rendering tells of its own speed.
    if (!/GPU stall|swiftshader/i.test(own.text())) told.push(`${own.type()}: ${own.text()}`);
  });
  page.on("pageerror", (own) => told.push(own.message));
  page.on("request", (own) => {
    if (!/^(file|data|blob):/.test(own.url())) told.push(`asks for ${own.url()}`);
  });
  await page.goto(pathToFileURL(file).href);
  return { page, told, close: () => context.close() };
}

async function lookAt({ example, page: name, at = [0.5, 0.5] }) {
  const { page, told, close } = await open(join(scratch, `${name}.html`));
  await page.waitForSelector("html[data-ready]", { timeout: 60_000 });
  const canvas = page.locator("#stage canvas");
  compare(`${name}-page`, await canvas.screenshot({ style: "header, #tools { visibility: hidden }" }));

  const whole = PNG.sync.read(await canvas.screenshot());
  for (const part of ["surface", "isoparametric", "edges", "net", "curves"]) {
    const shown = page.locator(`#shown input[name=${part}]`);
    await shown.uncheck();
    const count = difference(PNG.sync.read(await canvas.screenshot()), whole);
    assert.ok(count > PART, `${name} without ${part}: ${count}`);
    await shown.check();
  }

  const box = await canvas.boundingBox();
  const [x, y] = [box.x + at[0] * box.width, box.y + at[1] * box.height];
  await page.mouse.click(x, y);
  const reading = page.locator("#reading[data-surface]");
  await reading.waitFor({ timeout: 10_000 });
  const surface = await reading.getAttribute("data-surface");
  const exact = async (own) => reading.locator(`dd[data-name="${own}"] .exact`).textContent();
  const [u, v] = [await exact("u"), await exact("v")];
  const coordinates = [await exact("x"), await exact("y"), await exact("z")];
  const stem = name.split("-")[0];
  const net = JSON.parse(readFileSync(join(scratch, `${stem}-${surface}.json`), "utf8"));
  if (!net.field.length) assert.deepEqual(coordinates, point(net, u, v), name);
  assert.ok(proves(example, surface, [u, v], coordinates, net.field), `${name}: ${coordinates}`);
  const wrong = [`${coordinates[0]} + 1/1000000`, ...coordinates.slice(1)];
  assert.ok(!proves(example, surface, [u, v], wrong, net.field), "a wrong point is refuted");
  console.log(`${name}: ${surface}(${u}, ${v}) is read exactly`);

  // A drag turns the surface and reads nothing; a colour brings its scale.
  const before = await canvas.screenshot();
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 120, y + 40, { steps: 5 });
  await page.mouse.up();
  assert.notDeepEqual(await canvas.screenshot(), before, "a drag turns the surface");
  assert.deepEqual([await exact("u"), await exact("v")], [u, v], "a drag reads nothing");
  await page.mouse.wheel(0, -240);
  for (const colour of ["gaussian", "mean"]) {
    await page.selectOption("#tools select", colour);
    assert.ok(await page.locator("#scale").isVisible());
  }
  await page.selectOption("#tools select", "gaussian");
  await page.getByRole("button", { name: "start" }).click();
  compare(`${name}-gaussian`, await canvas.screenshot({ style: "header, #tools, #scale { visibility: hidden }" }));
  assert.deepEqual(told, [], `${name} tells something on the console`);
  await close();
}

async function lookAtDrawing(name) {
  const { page, told, close } = await open(join(scratch, `${name}.svg`));
  // Names are left out: fonts are those of the machine.
  await page.evaluate(() => document.querySelectorAll("text").forEach((own) => own.remove()));
  compare(`${name}-drawing`, await page.locator("svg").screenshot());
  assert.deepEqual(told, [], `${name} tells something on the console`);
  await close();
}

try {
  for (const own of PAGES) {
    compile(own.example);
    await lookAt(own);
  }
  for (const own of DRAWINGS) await lookAtDrawing(own);
} finally {
  await browser.close();
}
console.log("all pictures are well");
