// Exact numbers: elements of a tower of real square roots ℚ(r1)(r2)…, as the files spell them.
//
// A number is {top, bottom}: integers, one for each product of generators, over one positive
// integer. Entry k of `top` belongs to the product of those generators whose bit is set in k.

const abs = (a) => (a < 0n ? -a : a);

function gcd(a, b) {
  a = abs(a);
  b = abs(b);
  while (b) [a, b] = [b, a % b];
  return a;
}

function root(n) {
  if (n < 2n) return n;
  let x = 1n << BigInt((n.toString(2).length + 1) >> 1);
  for (;;) {
    const next = (x + n / x) >> 1n;
    if (next >= x) return x;
    x = next;
  }
}

const bits = (a) => abs(a).toString(2).length;

export class Field {
  // The generators of a file: [{name, square}], each the positive root of its square.
  constructor(generators) {
    this.names = generators.map((own) => own.name);
    this.size = 1 << generators.length;
    this.squares = [];
    for (const { square } of generators) {
      const { top, bottom } = this.parse(square);
      if (bottom !== 1n) throw new Error(`the square ${square} is not integral`);
      this.squares.push(top);
    }
    this.enclosures = new Map();
  }

  number(top, bottom) {
    if (bottom < 0n) {
      top = top.map((own) => -own);
      bottom = -bottom;
    }
    let common = bottom;
    for (const own of top) {
      if (common === 1n) break;
      common = gcd(common, own);
    }
    return common === 1n
      ? { top, bottom }
      : { top: top.map((own) => own / common), bottom: bottom / common };
  }

  rational(numerator, denominator = 1n) {
    const top = Array(this.size).fill(0n);
    top[0] = numerator;
    return this.number(top, denominator);
  }

  // Reads `3/2 + 1/4*r1 - r1*r2`.
  parse(text) {
    let sum = this.rational(0n);
    for (const [, sign, term] of text.matchAll(/(^-|^|[+-]\s)\s*([^\s+-]+)/g)) {
      let place = 0;
      let [numerator, denominator] = [1n, 1n];
      for (const factor of term.split("*")) {
        const generator = this.names.indexOf(factor);
        if (generator >= 0) {
          place |= 1 << generator;
        } else {
          const [above, below = "1"] = factor.split("/");
          numerator *= BigInt(above);
          denominator *= BigInt(below);
        }
      }
      const top = Array(this.size).fill(0n);
      top[place] = sign.startsWith("-") ? -numerator : numerator;
      sum = this.plus(sum, { top, bottom: denominator });
    }
    return sum;
  }

  plus(a, b) {
    const top = a.top.map((own, k) => own * b.bottom + b.top[k] * a.bottom);
    return this.number(top, a.bottom * b.bottom);
  }

  minus(a, b) {
    const top = a.top.map((own, k) => own * b.bottom - b.top[k] * a.bottom);
    return this.number(top, a.bottom * b.bottom);
  }

  times(a, b) {
    return this.number(this.product(a.top, b.top), a.bottom * b.bottom);
  }

  isZero(a) {
    return a.top.every((own) => own === 0n);
  }

  // (a + b r)(c + d r) = (a c + b d r²) + (a d + b c) r, from the last generator down.
  product(left, right) {
    const half = left.length >> 1;
    if (half === 0) return [left[0] * right[0]];
    const [a, b] = [left.slice(0, half), left.slice(half)];
    const [c, d] = [right.slice(0, half), right.slice(half)];
    const plain = (own) => own.every((one) => one === 0n);
    if (plain(b) && plain(d)) return [...this.product(a, c), ...Array(half).fill(0n)];
    const square = this.squares[Math.log2(half)].slice(0, half);
    const low = this.product(a, c);
    const high = this.product(this.product(b, d), square);
    const one = this.product(a, d);
    const other = this.product(b, c);
    return [
      ...low.map((own, k) => own + high[k]),
      ...one.map((own, k) => own + other[k]),
    ];
  }

  // 1/(a + b r) = (a − b r)/(a² − b² r²); none for 0.
  inverse(number) {
    const invert = (top) => {
      const half = top.length >> 1;
      if (half === 0) return { top: [1n], bottom: top[0] };
      const [a, b] = [top.slice(0, half), top.slice(half)];
      const square = this.squares[Math.log2(half)].slice(0, half);
      const across = this.product(this.product(b, b), square);
      const norm = this.product(a, a).map((own, k) => own - across[k]);
      const under = invert(norm);
      const times = (own) => this.product(own, under.top);
      return { top: [...times(a), ...times(b.map((own) => -own))], bottom: under.bottom };
    };
    if (this.isZero(number)) return null;
    const { top, bottom } = invert(number.top);
    return this.number(top.map((own) => own * number.bottom), bottom);
  }

  // The spelling of the files: products of generators by their number of factors are not
  // reordered; the file's own order of terms is that of `order`.
  spell(number) {
    const terms = [];
    for (let k = 0; k < this.size; k++) {
      if (number.top[k] === 0n) continue;
      const common = gcd(number.top[k], number.bottom);
      const [above, below] = [abs(number.top[k]) / common, number.bottom / common];
      const scale = below === 1n ? `${above}` : `${above}/${below}`;
      const names = this.names.filter((_, bit) => k & (1 << bit));
      const factors = scale === "1" && names.length ? names : [scale, ...names];
      terms.push([number.top[k] < 0n, factors.join("*")]);
    }
    if (!terms.length) return "0";
    return terms
      .map(([negative, text], k) => (k ? (negative ? " - " : " + ") : negative ? "-" : "") + text)
      .join("");
  }

  // Bounds of every product of generators, times 2^precision.
  bounds(precision) {
    if (this.enclosures.has(precision)) return this.enclosures.get(precision);
    const one = 1n << BigInt(precision);
    let list = [[one, one]];
    for (const square of this.squares) {
      const [low, high] = this.combined(square, list);
      const own = [root(low << BigInt(precision)), root(high << BigInt(precision)) + 1n];
      const scaled = list.map(([below, above]) => [
        (below * own[0]) >> BigInt(precision),
        ((above * own[1]) >> BigInt(precision)) + 1n,
      ]);
      list = [...list, ...scaled];
    }
    this.enclosures.set(precision, list);
    return list;
  }

  combined(top, list) {
    let [low, high] = [0n, 0n];
    list.forEach(([below, above], k) => {
      const own = top[k] ?? 0n;
      low += own * (own < 0n ? above : below);
      high += own * (own < 0n ? below : above);
    });
    return [low, high];
  }

  // The decimal with so many significant digits, rounded to the nearest.
  decimal(number, digits) {
    if (this.isZero(number)) return "0";
    const rational = number.top.every((own, k) => k === 0 || own === 0n);
    if (rational) return significant(number.top[0], number.bottom, digits);
    const size = Math.max(...number.top.map(bits));
    for (let precision = 64 + size + 4 * digits; ; precision *= 2) {
      const [low, high] = this.combined(number.top, this.bounds(precision));
      const bottom = number.bottom << BigInt(precision);
      if (low > 0n !== high > 0n || low === 0n || high === 0n) continue;
      const text = significant(low, bottom, digits);
      if (text === significant(high, bottom, digits)) return text;
    }
  }

  double(number) {
    return Number(this.decimal(number, 40));
  }
}

// A quotient of integers to so many significant digits.
function significant(numerator, denominator, digits) {
  const sign = numerator < 0n ? "-" : "";
  const above = abs(numerator);
  const ten = (power) => 10n ** BigInt(power);
  let exponent = above.toString().length - denominator.toString().length;
  const reaches = (power) =>
    power >= 0 ? above >= denominator * ten(power) : above * ten(-power) >= denominator;
  if (!reaches(exponent)) exponent -= 1;
  const shift = digits - 1 - exponent;
  const [dividend, divisor] =
    shift >= 0 ? [above * ten(shift), denominator] : [above, denominator * ten(-shift)];
  let rounded = (2n * dividend + divisor) / (2n * divisor);
  let text = rounded.toString();
  if (text.length > digits) {
    exponent += 1;
    text = text.slice(0, digits);
  }
  if (exponent < -7 || exponent >= digits) {
    return `${sign}${text[0]}.${text.slice(1)}e${exponent}`.replace(/\.?0*e/, "e");
  }
  const padded = exponent < 0 ? "0".repeat(-exponent) + text : text;
  const point = exponent < 0 ? 1 : exponent + 1;
  const plain = `${padded.slice(0, point)}.${padded.slice(point)}`;
  return sign + plain.replace(/\.?0+$/, "");
}
