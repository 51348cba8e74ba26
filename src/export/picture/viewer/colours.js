// Colours for curvature: blue for negative, white for zero, red for positive.

export const DIVERGING = [
  [33, 84, 148], [94, 146, 196], [176, 205, 228], [247, 247, 245], [244, 194, 170],
  [221, 121, 95], [165, 40, 44],
].map((own) => own.map((one) => one / 255));

// The colour at a ratio from 0 to 1.
export function blended(palette, ratio) {
  const bounded = Math.min(1, Math.max(0, Number.isFinite(ratio) ? ratio : 0.5));
  const place = bounded * (palette.length - 1);
  const low = Math.min(palette.length - 2, Math.floor(place));
  const rest = place - low;
  return palette[low].map((own, k) => own + rest * (palette[low + 1][k] - own));
}

// A range about 0 that holds nine tenths of the values.
export function range(values) {
  const sizes = values.filter(Number.isFinite).map(Math.abs).sort((a, b) => a - b);
  const bound = sizes[Math.floor(0.9 * (sizes.length - 1))] || 1;
  return [-bound, bound];
}

export const gradient = (palette) =>
  `linear-gradient(to top, ${palette
    .map((own) => `rgb(${own.map((one) => Math.round(255 * one)).join(" ")})`)
    .join(", ")})`;
