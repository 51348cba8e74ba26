// The picture of the page: what is drawn, from where, and which point is under the pointer.

import {
  AmbientLight, BackSide, BufferAttribute, BufferGeometry, Color, DirectionalLight,
  FrontSide, Group, Mesh, MeshStandardMaterial, PerspectiveCamera, Raycaster, Scene, Vector2,
  Vector3, WebGLRenderer,
} from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { LineMaterial } from "three/addons/lines/LineMaterial.js";
import { LineSegments2 } from "three/addons/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/addons/lines/LineSegmentsGeometry.js";

import { blended } from "./colours.js";

const STEPS = 96;
// Isoparametric lines: divisors of the steps, so that the lines are sides of triangles.
const COUNTS = [4, 6, 8, 12, 16];

const COLOURS = {
  front: 0xcfdde9, back: 0xe6d9be, fine: 0x4a5f74, edge: 0x1d2b3a, net: 0xb5843f,
  profile: 0x1f6fb2, sweep: 0xb9483a, mark: 0xd23c2a,
};

export class Picture {
  // `fronts` tells for each surface whether its front is the side of its normal.
  constructor(place, surfaces, fronts, curves, view) {
    this.place = place;
    this.surfaces = surfaces;
    this.renderer = new WebGLRenderer({ antialias: true, preserveDrawingBuffer: true });
    this.renderer.setClearColor(0xffffff);
    place.append(this.renderer.domElement);
    this.scene = new Scene();
    this.camera = new PerspectiveCamera(26, 1, 0.01, 1000);
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, this.renderer.domElement);
    this.controls.addEventListener("change", () => this.draw());
    this.materials = [];
    this.groups = {};
    for (const name of ["surface", "isoparametric", "edges", "net", "curves", "mark"]) {
      this.groups[name] = new Group();
      this.scene.add(this.groups[name]);
    }
    this.light();
    this.samples = surfaces.map((own) => sampled(own, STEPS));
    this.frame(curves);
    surfaces.forEach((own, index) => this.add(own, index, fronts[index]));
    this.addCurves(curves);
    this.look(view);
    new ResizeObserver(() => this.resize()).observe(place);
    this.resize();
  }

  light() {
    this.scene.add(new AmbientLight(0xffffff, 1.35));
    const sun = new DirectionalLight(0xffffff, 2.1);
    sun.position.set(-0.5, 0.8, 1);
    this.camera.add(sun);
    this.scene.add(this.camera);
  }

  // Everything is drawn about the middle of what there is, in units of its size: single precision
  // is enough there, wherever the surface lies.
  frame(curves) {
    const low = [Infinity, Infinity, Infinity];
    const high = low.map((own) => -own);
    const points = [
      ...this.samples.flatMap((own) => own.points.map((one) => one.point)),
      ...curves.flatMap((own) => own.points),
    ];
    for (const point of points) {
      point.forEach((own, axis) => {
        if (!Number.isFinite(own)) return;
        low[axis] = Math.min(low[axis], own);
        high[axis] = Math.max(high[axis], own);
      });
    }
    this.middle = low.map((own, axis) => (own + high[axis]) / 2);
    this.size = Math.hypot(...low.map((own, axis) => high[axis] - own)) || 1;
  }

  placed(point) {
    return point.map((own, axis) => (own - this.middle[axis]) / this.size);
  }

  add(surface, index, isNormalFront) {
    const { points } = this.samples[index];
    const geometry = new BufferGeometry();
    const floats = (values) => new BufferAttribute(new Float32Array(values), 3);
    geometry.setAttribute("position", floats(points.flatMap((own) => this.placed(own.point))));
    geometry.setAttribute("normal", floats(points.flatMap((own) => own.normal)));
    geometry.setAttribute("color", floats(points.flatMap(() => [1, 1, 1])));
    const width = STEPS + 1;
    const faces = [];
    for (let i = 0; i < STEPS; i++) {
      for (let j = 0; j < STEPS; j++) {
        const a = i * width + j;
        faces.push(a, a + width, a + width + 1, a, a + width + 1, a + 1);
      }
    }
    geometry.setIndex(faces);
    for (const side of [FrontSide, BackSide]) {
      const plain = (side === FrontSide) === isNormalFront ? COLOURS.front : COLOURS.back;
      const material = new MeshStandardMaterial({
        color: plain, side, roughness: 0.62, metalness: 0, vertexColors: true,
        polygonOffset: true, polygonOffsetFactor: 1.5, polygonOffsetUnits: 2,
      });
      const mesh = new Mesh(geometry, material);
      mesh.userData = { index, plain };
      this.groups.surface.add(mesh);
    }
    this.addLines(surface);
    this.addNet(surface);
  }

  // Isoparametric lines about as far apart in both directions, and the sides of the domain.
  addLines(surface) {
    const lengths = [0, 1].map((axis) => length(line(surface, 1 - axis, 0.5)));
    const longest = Math.max(...this.surfaces.flatMap((own) =>
      [0, 1].map((axis) => length(line(own, 1 - axis, 0.5)))));
    const [edges, fine] = [[], []];
    lengths.forEach((own, axis) => {
      const ideal = (COUNTS[COUNTS.length - 1] * own) / longest;
      const far = (count) => Math.abs(count - ideal);
      const count = COUNTS.reduce((best, one) => (far(one) < far(best) ? one : best));
      for (let k = 0; k <= count; k++) {
        const points = line(surface, axis, k / count);
        (k === 0 || k === count ? edges : fine).push(...this.segments(points));
      }
    });
    this.groups.isoparametric.add(this.lines(fine, COLOURS.fine, 1));
    this.groups.edges.add(this.lines(edges, COLOURS.edge, 2, 1));
  }

  addNet(surface) {
    const segments = [];
    const { control } = surface;
    control.forEach((row, i) =>
      row.forEach((own, j) => {
        for (const other of [control[i + 1]?.[j], row[j + 1]]) {
          if (own && other) segments.push(...this.placed(own), ...this.placed(other));
        }
      }),
    );
    if (segments.length) this.groups.net.add(this.lines(segments, COLOURS.net, 1.2));
  }

  addCurves(curves) {
    for (const own of curves) {
      const colour = own.profile ? COLOURS.profile : COLOURS.sweep;
      this.groups.curves.add(this.lines(this.segments(own.points), colour, 3, 2));
    }
  }

  segments(points) {
    return points.slice(1).flatMap((own, k) => [...this.placed(points[k]), ...this.placed(own)]);
  }

  // Lines of a width in pixels, nearer than they are by a rank where they coincide with others.
  lines(positions, color, linewidth, rank = 0) {
    const material = new LineMaterial({
      color, linewidth, polygonOffset: true, polygonOffsetFactor: -rank, polygonOffsetUnits: -8 * rank,
    });
    this.materials.push(material);
    const geometry = new LineSegmentsGeometry();
    geometry.setPositions(positions.length ? positions : [0, 0, 0, 0, 0, 0]);
    return new LineSegments2(geometry, material);
  }

  // Colours the surfaces by a quantity of their samples; by none as plain sides.
  colour(quantity, range, palette) {
    this.groups.surface.children.forEach((mesh) => {
      const { index, plain } = mesh.userData;
      mesh.material.color.set(quantity ? 0xffffff : plain);
      const colours = mesh.geometry.getAttribute("color");
      this.samples[index].points.forEach((own, k) => {
        const ratio = quantity ? (own[quantity] - range[0]) / (range[1] - range[0]) : 0;
        const [r, g, b] = quantity ? blended(palette, ratio) : [1, 1, 1];
        const colour = new Color().setRGB(r, g, b, "srgb");
        colours.setXYZ(k, colour.r, colour.g, colour.b);
      });
      colours.needsUpdate = true;
    });
    this.draw();
  }

  show(name, isShown) {
    this.groups[name].visible = isShown;
    this.draw();
  }

  // Looks from the direction of azimuth and elevation, in degrees.
  look(view) {
    const toward = new Vector3(...direction(view));
    this.controls.target.set(0, 0, 0);
    this.camera.position.copy(toward.multiplyScalar(this.distance()));
    this.camera.near = 0.01;
    this.camera.far = 50;
    this.camera.updateProjectionMatrix();
    this.controls.update();
    this.draw();
  }

  distance() {
    const aspect = this.camera.aspect || 1;
    return 2.25 * Math.max(1, 0.95 / aspect);
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.place;
    if (!width || !height) return;
    this.renderer.setPixelRatio(Math.min(2, window.devicePixelRatio));
    this.renderer.setSize(width, height);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.materials.forEach((own) => own.resolution.set(width, height));
    this.draw();
  }

  draw() {
    this.renderer.render(this.scene, this.camera);
  }

  // The surface under a point of the window, with its place in the domain from 0 to 1.
  pick(clientX, clientY) {
    const box = this.renderer.domElement.getBoundingClientRect();
    const at = new Vector2(
      (2 * (clientX - box.left)) / box.width - 1,
      1 - (2 * (clientY - box.top)) / box.height,
    );
    const caster = new Raycaster();
    caster.setFromCamera(at, this.camera);
    const [hit] = caster.intersectObjects(this.groups.surface.children, false);
    if (!hit) return null;
    const corners = [hit.face.a, hit.face.b, hit.face.c];
    const positions = hit.object.geometry.getAttribute("position");
    const [a, b, c] = corners.map((own) => new Vector3().fromBufferAttribute(positions, own));
    const parts = barycentric(hit.point, a, b, c);
    const width = STEPS + 1;
    const along = (pick) =>
      corners.reduce((sum, own, k) => sum + parts[k] * pick(own), 0) / STEPS;
    return {
      index: hit.object.userData.index,
      ratios: [along((own) => Math.floor(own / width)), along((own) => own % width)],
    };
  }

  // Marks a point and the isoparametric lines through it.
  mark(index, [s, t]) {
    const { mark } = this.groups;
    mark.clear();
    const surface = this.surfaces[index];
    const cross = [...this.segments(line(surface, 0, s)), ...this.segments(line(surface, 1, t))];
    mark.add(this.lines(cross, COLOURS.mark, 1.6, 3));
    const [u, v] = [at(surface, 0, s), at(surface, 1, t)];
    const point = this.placed(surface.sample(u, v).point);
    const dot = this.lines([...point, ...point.map((own) => own + 1e-6)], COLOURS.mark, 9);
    dot.material.depthTest = false;
    mark.add(dot);
    this.resize();
  }
}

// The direction to the viewer; from straight above and below a little to the front, so that it is
// known what is up.
function direction([azimuth, elevation]) {
  const bounded = Math.min(89.99, Math.max(-89.99, elevation));
  const [a, e] = [azimuth, bounded].map((own) => (own * Math.PI) / 180);
  return [Math.cos(e) * Math.cos(a), Math.cos(e) * Math.sin(a), Math.sin(e)];
}

const at = (surface, axis, ratio) => {
  const [from, to] = surface.domain[axis];
  return (1 - ratio) * from + ratio * to;
};

function sampled(surface, steps) {
  const points = [];
  for (let i = 0; i <= steps; i++) {
    for (let j = 0; j <= steps; j++) {
      points.push(surface.sample(at(surface, 0, i / steps), at(surface, 1, j / steps)));
    }
  }
  return { points };
}

// The line at a fixed ratio along one axis.
function line(surface, axis, ratio) {
  const fixed = at(surface, axis, ratio);
  return Array.from({ length: STEPS + 1 }, (_, k) => {
    const free = at(surface, 1 - axis, k / STEPS);
    return surface.sample(...(axis === 0 ? [fixed, free] : [free, fixed])).point;
  });
}

function length(points) {
  return points.slice(1).reduce(
    (sum, own, k) => sum + Math.hypot(...own.map((one, axis) => one - points[k][axis])), 0);
}

function barycentric(point, a, b, c) {
  const [ab, ac, ap] = [b, c, point].map((own) => own.clone().sub(a));
  const [d00, d01, d11] = [ab.dot(ab), ab.dot(ac), ac.dot(ac)];
  const [d20, d21] = [ap.dot(ab), ap.dot(ac)];
  const below = d00 * d11 - d01 * d01 || 1;
  const second = (d11 * d20 - d01 * d21) / below;
  const third = (d00 * d21 - d01 * d20) / below;
  return [1 - second - third, second, third];
}
