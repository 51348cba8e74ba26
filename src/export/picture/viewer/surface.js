// A surface of the page: the exact net, and the same in doubles for drawing.

import { Field } from "./exact.js";

export class Surface {
  // A net in the form `sweepc-net/1`.
  constructor(net) {
    this.name = net.name;
    this.field = new Field(net.field);
    const field = this.field;
    const read = (text) => field.parse(text);
    const homogeneous = (weight, point) => {
      const factor = field.isZero(weight) ? field.rational(1n) : weight;
      return [weight, ...point.map((own) => field.times(own, factor))];
    };
    this.lattice = {
      along: ["u", "v"].map((name, axis) => ({
        degree: net.degree[axis],
        knots: net.knots[name].map(read),
      })),
      rows: net.weights.map((row, i) =>
        row.map((weight, j) => homogeneous(read(weight), net.points[i][j].map(read))),
      ),
    };
    this.control = net.float.points.map((row, i) =>
      row.map((point, j) => (net.float.weights[i][j] === 0 ? null : point)),
    );
    const value = this.lattice;
    const [u, v] = [0, 1].map((axis) => derivative(field, value, axis));
    this.splines = [
      value,
      u,
      v,
      derivative(field, u, 0),
      derivative(field, u, 1),
      derivative(field, v, 1),
    ].map((own) => rounded(field, own));
    this.domain = this.splines[0].along.map(({ knots }) => [knots[0], knots[knots.length - 1]]);
  }

  // The parameter a whole number of steps from the start of a domain, exactly.
  parameter(axis, step, steps) {
    const { field } = this;
    const { knots } = this.lattice.along[axis];
    const width = field.minus(knots[knots.length - 1], knots[0]);
    const ratio = field.rational(BigInt(step), BigInt(steps));
    return field.plus(knots[0], field.times(width, ratio));
  }

  // The exact point at exact parameters, by repeated affine combination; null at a pole.
  point(u, v) {
    const { field, lattice } = this;
    const [along_u, along_v] = lattice.along;
    const column = lattice.rows.map((row) => blend(field, along_v, row, v));
    const [weight, ...point] = blend(field, along_u, column, u);
    const scale = field.inverse(weight);
    return scale && point.map((own) => field.times(own, scale));
  }

  // Point, unit normal, Gaussian and mean curvature at doubles.
  sample(u, v) {
    const [in_u, in_v] = [basis(this.splines[0].along[0], u), basis(this.splines[0].along[1], v)];
    const lower = (axis, at, order) => basis(this.splines[order].along[axis], at);
    const [first_u, first_v] = [lower(0, u, 1), lower(1, v, 2)];
    const [second_u, second_v] = [lower(0, u, 3), lower(1, v, 5)];
    const all = [
      [in_u, in_v],
      [first_u, in_v],
      [in_u, first_v],
      [second_u, in_v],
      [first_u, first_v],
      [in_u, second_v],
    ].map(([left, right], k) => combined(this.splines[k].rows, left, right));
    const [p, pu, pv, puu, puv, pvv] = all;
    const w = p[0];
    const axis = [1, 2, 3];
    const s = axis.map((k) => p[k] / w);
    const su = axis.map((k) => (pu[k] - pu[0] * s[k - 1]) / w);
    const sv = axis.map((k) => (pv[k] - pv[0] * s[k - 1]) / w);
    const suu = axis.map((k) => (puu[k] - 2 * pu[0] * su[k - 1] - puu[0] * s[k - 1]) / w);
    const suv = axis.map(
      (k) => (puv[k] - pu[0] * sv[k - 1] - pv[0] * su[k - 1] - puv[0] * s[k - 1]) / w,
    );
    const svv = axis.map((k) => (pvv[k] - 2 * pv[0] * sv[k - 1] - pvv[0] * s[k - 1]) / w);
    const across = cross(su, sv);
    const length = Math.hypot(...across);
    const normal = length > 0 ? across.map((own) => own / length) : [0, 0, 0];
    const [e, f, g] = [dot(su, su), dot(su, sv), dot(sv, sv)];
    const [l, m, n] = [suu, suv, svv].map((own) => dot(own, normal));
    const area = e * g - f * f;
    return {
      point: s,
      normal,
      gaussian: (l * n - m * m) / area,
      mean: (e * n - 2 * f * m + g * l) / (2 * area),
    };
  }
}

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

// d (P_{i+1} − P_i) / (t_{i+d+1} − t_{i+1}) over the inner knots, exactly.
function derivative(field, { along, rows }, axis) {
  if (axis === 1) return turned(derivative(field, turned({ along, rows }), 0));
  const { degree, knots } = along[0];
  if (degree === 0) {
    const zero = field.rational(0n);
    return { along, rows: rows.map((row) => row.map((own) => own.map(() => zero))) };
  }
  const difference = (i) => {
    const width = field.minus(knots[i + degree + 1], knots[i + 1]);
    const scale = field.times(field.inverse(width), field.rational(BigInt(degree)));
    return rows[i].map((low, j) =>
      low.map((own, k) => field.times(field.minus(rows[i + 1][j][k], own), scale)),
    );
  };
  return {
    along: [{ degree: degree - 1, knots: knots.slice(1, -1) }, along[1]],
    rows: rows.slice(1).map((_, i) => difference(i)),
  };
}

const turned = ({ along, rows }) => ({
  along: [along[1], along[0]],
  rows: rows[0].map((_, j) => rows.map((row) => row[j])),
});

const rounded = (field, { along, rows }) => ({
  along: along.map(({ degree, knots }) => ({
    degree,
    knots: knots.map((own) => field.double(own)),
  })),
  rows: rows.map((row) => row.map((own) => own.map((one) => field.double(one)))),
});

// De Boor's scheme, which on one span is de Casteljau's, for homogeneous points.
function blend(field, { degree, knots }, points, at) {
  const isBelow = (a, b) => field.double(field.minus(a, b)) < 0;
  let span = degree;
  while (span < points.length - 1 && !isBelow(at, knots[span + 1])) span += 1;
  const first = span - degree;
  const corner = points.slice(first, span + 1);
  for (let step = 1; step <= degree; step++) {
    for (let k = degree; k >= step; k--) {
      const [low, high] = [knots[first + k], knots[first + k + 1 + degree - step]];
      const ratio = field.times(field.minus(at, low), field.inverse(field.minus(high, low)));
      const rest = field.minus(field.rational(1n), ratio);
      corner[k] = corner[k].map((own, axis) =>
        field.plus(field.times(corner[k - 1][axis], rest), field.times(own, ratio)),
      );
    }
  }
  return corner[degree];
}

// The basis functions that are not 0 at a parameter, with the index of the first.
function basis({ degree, knots }, at) {
  let span = degree;
  while (span < knots.length - degree - 2 && knots[span + 1] <= at) span += 1;
  let values = [1];
  for (let step = 1; step <= degree; step++) {
    const next = Array(step + 1).fill(0);
    values.forEach((own, k) => {
      const [low, high] = [knots[span + 1 + k - step], knots[span + 1 + k]];
      const ratio = (at - low) / (high - low);
      next[k] += (1 - ratio) * own;
      next[k + 1] += ratio * own;
    });
    values = next;
  }
  return { first: span - degree, values };
}

function combined(rows, left, right) {
  const sum = [0, 0, 0, 0];
  left.values.forEach((one, i) => {
    const row = rows[left.first + i];
    right.values.forEach((other, j) => {
      const point = row[right.first + j];
      for (let k = 0; k < 4; k++) sum[k] += one * other * point[k];
    });
  });
  return sum;
}
