// A point of a net of rational numbers by Bernstein sums: another road than the viewer's, which
// goes by repeated affine combination.

const read = (text) => {
  const [above, below = "1"] = text.split("/");
  return [BigInt(above), BigInt(below)];
};
const plus = ([a, b], [c, d]) => [a * d + c * b, b * d];
const times = ([a, b], [c, d]) => [a * c, b * d];

const gcd = (a, b) => (b ? gcd(b, a % b) : a < 0n ? -a : a);

function spell([above, below]) {
  const sign = below < 0n ? -1n : 1n;
  const common = sign * gcd(above, below);
  const [a, b] = [above / common, below / common];
  return b === 1n ? `${a}` : `${a}/${b}`;
}

// C(n, k) tᵏ (1 − t)ⁿ⁻ᵏ
function bernstein(degree, at) {
  const rest = plus([1n, 1n], times([-1n, 1n], at));
  const power = (base, exponent) => [base[0] ** BigInt(exponent), base[1] ** BigInt(exponent)];
  let binomial = 1n;
  return Array.from({ length: degree + 1 }, (_, k) => {
    const own = times([binomial, 1n], times(power(at, k), power(rest, degree - k)));
    binomial = (binomial * BigInt(degree - k)) / BigInt(k + 1);
    return own;
  });
}

// x, y, z of the one patch of a net on [0, 1]².
export function point(net, u, v) {
  const [in_u, in_v] = [u, v].map((own, axis) => bernstein(net.degree[axis], read(own)));
  const sum = [0, 1, 2, 3].map(() => [0n, 1n]);
  in_u.forEach((left, i) =>
    in_v.forEach((right, j) => {
      const weight = times(times(left, right), read(net.weights[i][j]));
      const own = [[1n, 1n], ...net.points[i][j].map(read)].map((one) => times(weight, one));
      own.forEach((one, axis) => {
        sum[axis] = plus(sum[axis], one);
      });
    }),
  );
  const [weight, ...rest] = sum;
  return rest.map((own) => spell(times(own, [weight[1], weight[0]])));
}
