// Colours of the difference pictures, as the program hands them over, so that page and plain pictures read alike
// (validate/report/pictures.cpp). A colour is packed as a canvas holds it on a little-endian machine: 0xAABBGGRR, opaque.
import type { PaletteColor, ReportData } from "../data";

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

/** Of "#e69f00". */
function packCssColor(text: string): Packed {
  const code = Number.parseInt(text.slice(1), 16);
  return packColor(code >> 16, (code >> 8) & 255, code & 255);
}

/** Pixels where the reference itself isn't sure: of the page alone. */
const kUncertainColors = {
  uncertainDiffers: packColor(0, 158, 115),
  uncertainAgrees: packColor(150, 205, 188),
} as const;
const kGreyStops = [packColor(240, 240, 240), packColor(48, 48, 48)];

export interface Colors {
  palette: { readonly [color in PaletteColor | keyof typeof kUncertainColors]: Packed };
  /** Of x in [-1, 1], clamped: too near, 0, too far. */
  diverging(x: number): Packed;
  /** Of x in [0, 1], clamped. */
  sequential(x: number): Packed;
  /** Of x in [0, 1], clamped: light is near. */
  grey(x: number): Packed;
}

export function colorsOf(report: ReportData): Colors {
  const palette = Object.fromEntries(Object.entries(report.palette).map(([name, text]) => [name, packCssColor(text)]));
  const [near, nearMiddle, zero, farMiddle, far] = report.diverging.map(packCssColor);
  const sequential = report.sequential.map(packCssColor);
  return {
    palette: { ...(palette as { [color in PaletteColor]: Packed }), ...kUncertainColors },
    diverging: (x) => colorAlong(x < 0 ? [zero, nearMiddle, near] : [zero, farMiddle, far], Math.abs(x)),
    sequential: (x) => colorAlong(sequential, x),
    grey: (x) => colorAlong(kGreyStops, x),
  };
}

/** Between stops equally apart, of t in [0, 1], clamped. */
function colorAlong(stops: readonly Packed[], t: number): Packed {
  const at = Math.min(Math.max(t, 0), 1) * (stops.length - 1);
  const below = Math.min(Math.floor(at), stops.length - 2);
  return mix(stops[below], stops[below + 1], at - below);
}

function mix(a: Packed, b: Packed, t: number): Packed {
  const at = (shift: number) => Math.round((1 - t) * ((a >>> shift) & 255) + t * ((b >>> shift) & 255));
  return packColor(at(0), at(8), at(16));
}
