// Colours of the difference pictures: the same as validate/report/pictures.cpp, so that page and plain pictures read alike. Told apart
// with any common colour blindness (categories: Okabe and Ito 2008, "Color universal design"). A colour is packed as a canvas holds it
// on a little-endian machine: 0xAABBGGRR, opaque.

export type Packed = number;

export function packColor(r: number, g: number, b: number): Packed {
  return (0xff000000 | (b << 16) | (g << 8) | r) >>> 0;
}

export function channelsOf(color: Packed): [number, number, number] {
  return [color & 255, (color >>> 8) & 255, (color >>> 16) & 255];
}

/** "#e69f00". */
export function cssColor(color: Packed): string {
  return `#${channelsOf(color)
    .map((channel) => channel.toString(16).padStart(2, "0"))
    .join("")}`;
}

export const palette = {
  nothing: packColor(24, 26, 30),
  unshared: packColor(60, 64, 72),
  agree: packColor(190, 190, 190),
  bothDark: packColor(90, 90, 90),
  missing: packColor(230, 159, 0),
  extra: packColor(0, 114, 178),
  other: packColor(204, 121, 167),
  invalid: packColor(240, 228, 66),
  // Of the page alone: pixels where the reference itself isn't sure.
  uncertainDiffers: packColor(0, 158, 115),
  uncertainAgrees: packColor(150, 205, 188),
} as const;

function mix(a: Packed, b: Packed, t: number): Packed {
  const at = (shift: number) => Math.round((1 - t) * ((a >>> shift) & 255) + t * ((b >>> shift) & 255));
  return packColor(at(0), at(8), at(16));
}

const kNear = packColor(5, 76, 135);
const kNearMiddle = packColor(100, 170, 215);
const kZero = packColor(247, 247, 247);
const kFarMiddle = packColor(240, 165, 80);
const kFar = packColor(150, 65, 0);

/** Of x in [-1, 1], clamped: blue, white at 0, orange; luminance falls evenly to both ends. */
export function divergingColor(x: number): Packed {
  const strength = Math.min(Math.abs(x), 1);
  const middle = x < 0 ? kNearMiddle : kFarMiddle;
  return strength < 0.5 ? mix(kZero, middle, 2 * strength) : mix(middle, x < 0 ? kNear : kFar, 2 * strength - 1);
}

const kPale = packColor(255, 247, 205);
const kMedium = packColor(225, 130, 35);
const kDark = packColor(70, 25, 5);

/** Of x in [0, 1], clamped: pale to dark; luminance falls evenly. */
export function sequentialColor(x: number): Packed {
  const t = Math.min(Math.max(x, 0), 1);
  return t < 0.5 ? mix(kPale, kMedium, 2 * t) : mix(kMedium, kDark, 2 * t - 1);
}

const kNearGrey = packColor(240, 240, 240);
const kFarGrey = packColor(48, 48, 48);

/** Of x in [0, 1], clamped: light is near. */
export function greyColor(x: number): Packed {
  return mix(kNearGrey, kFarGrey, Math.min(Math.max(x, 0), 1));
}
