// The program's colors, which validate/report/colors.h defines. A color is packed as in a canvas on a
// little-endian machine: 0xAABBGGRR, opaque.
import type { MapName, PaletteColor, ReportData } from "../data";

export type Packed = number;

/** Equidistant stops with linear interpolation of sRGB codes between them. */
export interface ColorMap {
  /** x of the first stop: 0, or -1 for a map that diverges from its middle stop. x of the last one is 1. */
  low: number;
  stops: readonly Packed[];
}

export interface Colors {
  palette: { readonly [color in PaletteColor]: Packed };
  maps: { readonly [map in MapName]: ColorMap };
}

export function colorsOf({ colors }: ReportData): Colors {
  const palette = Object.entries(colors.palette).map(([name, text]) => [name, packCssColor(text)]);
  const maps = Object.entries(colors.maps).map(([name, { low, stops }]) => [
    name,
    { low, stops: stops.map(packCssColor) },
  ]);
  return { palette: Object.fromEntries(palette), maps: Object.fromEntries(maps) };
}

/**
 * `x` is clamped to the ends of the map. The operations are those of colorAt() in validate/report/colors.cpp,
 * so that the codes are equal. /
 */
export function colorAt({ low, stops }: ColorMap, x: number): Packed {
  const inside = Math.min(Math.max(x, low), 1);
  const first = low < 0 ? Math.floor(stops.length / 2) : 0;
  const last = stops.length - 1 - first;
  const at = Math.abs(inside) * last;
  const below = Math.min(Math.floor(at), last - 1);
  const stop = (i: number) => stops[inside < 0 ? first - i : first + i];
  return mix(stop(below), stop(below + 1), at - below);
}

function mix(a: Packed, b: Packed, t: number): Packed {
  const at = (shift: number) => Math.round((1 - t) * ((a >>> shift) & 255) + t * ((b >>> shift) & 255));
  return packColor(at(0), at(8), at(16));
}

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

/** Parses "#e69f00". */
function packCssColor(text: string): Packed {
  const code = Number.parseInt(text.slice(1), 16);
  return packColor(code >> 16, (code >> 8) & 255, code & 255);
}
