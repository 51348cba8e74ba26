// The page: reads the exact nets in it, draws them, and tells the exact point under a click.

import { DIVERGING, gradient, range } from "./colours.js";
import { Picture } from "./scene.js";
import { Surface } from "./surface.js";

// Steps of the grid in each parameter at which points are read.
const STEPS = 1024;
const DIGITS = 30;
// How far the pointer may move between press and release of a click.
const STILL = 4;

const VIEWS = {
  start: null, front: [-90, 0], right: [0, 0], top: [-90, 90],
};
const SHOWN = {
  surface: "surface", isoparametric: "isoparametric lines", edges: "edges", net: "control net",
  curves: "profile and sweep curve",
};

const element = (name, properties = {}, ...children) => {
  const own = Object.assign(document.createElement(name), properties);
  own.append(...children);
  return own;
};

const model = JSON.parse(document.getElementById("model").textContent);
const surfaces = model.nets.map((own) => new Surface(own));
const stage = document.getElementById("stage");
const picture = new Picture(stage, surfaces, model.fronts, model.curves, model.view);

for (const [name, angles] of Object.entries(VIEWS)) {
  const button = element("button", { type: "button", textContent: name });
  button.addEventListener("click", () => picture.look(angles ?? model.view));
  document.getElementById("views").append(button);
}
for (const [name, label] of Object.entries(SHOWN)) {
  const box = element("input", { type: "checkbox", checked: true, name });
  box.addEventListener("change", () => picture.show(name, box.checked));
  document.getElementById("shown").append(element("label", {}, box, label));
}

const choice = document.getElementById("colour");
choice.addEventListener("change", () => colour(choice.value));

// Colours by a curvature, with a scale of its values.
function colour(quantity) {
  const scale = document.getElementById("scale");
  scale.hidden = quantity === "plain";
  if (scale.hidden) {
    picture.colour(null);
    return;
  }
  const values = picture.samples.flatMap((own) => own.points.map((one) => one[quantity]));
  const [low, high] = range(values);
  picture.colour(quantity, [low, high], DIVERGING);
  scale.querySelector("i").style.background = gradient(DIVERGING);
  const labels = [high, high / 2, 0, low / 2, low].map((own) => Number(own.toPrecision(3)));
  scale.querySelector("ol").replaceChildren(
    ...labels.map((own) => element("li", { textContent: `${own}`.replace("-", "−") })));
}

let pressed = null;
stage.addEventListener("pointerdown", (event) => {
  pressed = [event.clientX, event.clientY];
});
stage.addEventListener("pointerup", (event) => {
  const moved = pressed && Math.hypot(event.clientX - pressed[0], event.clientY - pressed[1]);
  if (moved === null || moved > STILL) return;
  const found = picture.pick(event.clientX, event.clientY);
  if (found) read(found.index, found.ratios);
});

// Reads the exact point at the nearest place of the grid.
function read(index, ratios) {
  const surface = surfaces[index];
  const { field } = surface;
  const steps = ratios.map((own) => Math.round(Math.min(1, Math.max(0, own)) * STEPS));
  const parameters = steps.map((own, axis) => surface.parameter(axis, own, STEPS));
  const point = surface.point(...parameters);
  picture.mark(index, steps.map((own) => own / STEPS));
  const entry = (name, value) => {
    const exact = field.spell(value);
    const decimal = field.decimal(value, DIGITS);
    const lines = [element("span", { className: "exact", textContent: exact })];
    if (decimal !== exact) {
      const text = `${isShort(value, decimal) ? "=" : "≈"} ${decimal}`;
      lines.push(element("span", { className: "decimal", textContent: text }));
    }
    const description = element("dd", {}, ...lines);
    description.dataset.name = name;
    return [element("dt", { textContent: name }), description];
  };
  // A decimal with fewer digits than were asked for says all there is.
  const isShort = (value, decimal) => {
    const digits = decimal.replace(/e.*/, "").replace(/[^0-9]/g, "").replace(/^0+/, "");
    return digits.length < DIGITS && value.top.every((own, k) => k === 0 || own === 0n);
  };
  const sample = surface.sample(...parameters.map((own) => field.double(own)));
  const about = (own) => Number(own.toPrecision(6)).toString();
  const names = ["u", "v", "x", "y", "z"];
  const values = [...parameters, ...(point ?? [])];
  const list = element("dl", {}, ...values.flatMap((own, k) => entry(names[k], own)));
  const generators = model.nets[index].field;
  const notes = generators.map(({ name, square }) =>
    element("p", { textContent: `${name} is the positive root of ${square}` }));
  const curvature = element("p", {
    textContent: point
      ? `Gaussian curvature ≈ ${about(sample.gaussian)}, mean curvature ≈ ${about(sample.mean)}, for the normal R_u × R_v`
      : "the surface has no point there: W = 0",
  });
  const text = values.map((own, k) => `${names[k]} = ${field.spell(own)}`).join("\n");
  const copy = element("button", { type: "button", className: "copy", textContent: "Copy" });
  copy.addEventListener("click", () => navigator.clipboard?.writeText(text));
  const reading = document.getElementById("reading");
  const heading = element("h2", {}, element("i", { textContent: surface.name }), "(u, v)");
  reading.replaceChildren(heading, list, ...notes, curvature, copy);
  reading.dataset.surface = surface.name;
}

document.documentElement.dataset.ready = "true";
