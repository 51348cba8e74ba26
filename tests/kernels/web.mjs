// Evaluates surfaces in three.js and verb: questions come as JSON, and so do the answers.

import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";
import { pathToFileURL } from "node:url";

const modules = process.env.SWEEPC_NODE_MODULES;
const part = (path) => import(pathToFileURL(join(modules, path)));
const { Vector3 } = await part("three/build/three.module.js");
const { NURBSSurface } = await part("three/examples/jsm/curves/NURBSSurface.js");
// verb expects a browser, and tells its version.
globalThis.window = globalThis;
console.log = () => {};
const verb = createRequire(join(modules, "web.cjs"))("verb-nurbs");

function three({ degree1, degree2, knots1, knots2, controlPoints }) {
  const surface = new NURBSSurface(degree1, degree2, knots1, knots2, controlPoints);
  // Its parameters run from 0 to 1.
  const share = (knots, value) => (value - knots[0]) / (knots.at(-1) - knots[0]);
  return {
    degree: [surface.degree1, surface.degree2],
    controls: surface.controlPoints.map((row) => row.map(({ x, y, z, w }) => [x, y, z, w])),
    at: (u, v) => {
      const point = new Vector3();
      surface.getPoint(share(knots1, u), share(knots2, v), point);
      return point.toArray();
    },
  };
}

function nurbs(data) {
  const surface = new verb.geom.NurbsSurface(data);
  return {
    degree: [surface.degreeU(), surface.degreeV()],
    controls: data.controlPoints,
    at: (u, v) => surface.point(u, v),
  };
}

const answers = JSON.parse(readFileSync(0, "utf8")).map(({ path, u, v }) => {
  const data = JSON.parse(readFileSync(path, "utf8"));
  const { degree, controls, at } = path.endsWith(".verb.json") ? nurbs(data) : three(data);
  return { degree, controls, points: u.map((own) => v.map((other) => at(own, other))) };
});
process.stdout.write(JSON.stringify(answers));
