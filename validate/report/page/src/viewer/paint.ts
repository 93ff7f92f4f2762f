// Layers in colour.
import { colorAt, type Colors, type Packed } from "./colors";
import type { ReportData } from "../data";
import type { LayerKey } from "./layers";
import { roundedUp } from "./numbers";
import type { Reading } from "./readings";

/** Values at the two ends of the colour map. */
export type Range = readonly [low: number, high: number];

export interface Painting {
  /** Packed, row 0 = top. */
  pixels: Uint32Array<ArrayBuffer>;
  /** Pixels in each of the reading's categories. */
  counts: number[];
}

/** Whether a person may set these: 0 is in the middle of errors, and at the low end of all but depths. */
export function isRange(layer: LayerKey, low: number, high: number): boolean {
  if (!(low < high && high > 0)) return false;
  if (layer === "depth_error") return low === -high;
  return layer === "depth" || low === 0;
}

/** Colour of a value; NaN isn't given one. */
function colorOfValue({ palette, maps }: Colors, map: Reading["map"], value: number, [low, high]: Range): Packed {
  switch (map) {
    case "picture":
      return value;
    case "none":
      return palette.invalid;
    case "diverging":
      return colorAt(maps[map], value / high);
    case "sequential":
    case "gray":
      return colorAt(maps[map], (value - low) / (high - low));
  }
}

export function paintLayer(colors: Colors, reading: Reading, range: Range, pixelCount: number): Painting {
  const pixels = new Uint32Array(pixelCount);
  const counts = reading.categories.map(() => 0);
  const categoryColors = reading.categories.map((category) => category.color);
  for (let pixel = 0; pixel < pixelCount; ++pixel) {
    const category = reading.categoryAt(pixel);
    if (category >= 0) {
      pixels[pixel] = categoryColors[category];
      ++counts[category];
    } else {
      pixels[pixel] = colorOfValue(colors, reading.map, reading.valueAt(pixel), range);
    }
  }
  return { pixels, counts };
}

/** Share of the pixels that full colour leaves out to begin with: a few wild values would pale all the rest. */
const kBeyondRange = 0.01;

const ranges = new WeakMap<Reading, Range>();

/** From 0 to what all but the wildest values stay below, rounded up; of depths from the nearest to the farthest. */
function rangeOfValues(reading: Reading, pixelCount: number): Range {
  const values = new Float64Array(pixelCount);
  let count = 0;
  for (let pixel = 0; pixel < pixelCount; ++pixel) if (reading.categoryAt(pixel) < 0) values[count++] = reading.valueAt(pixel);
  const sorted = values.subarray(0, count).sort();
  if (count === 0) return [0, 1];
  if (reading.map === "gray") return [sorted[0], sorted[count - 1]];
  return [0, roundedUp(sorted[Math.floor((count - 1) * (1 - kBeyondRange))])];
}

/** The range that holds the own ranges of all these readings of one layer; never empty. */
function sharedRange(readings: readonly Reading[], pixelCount: number): Range {
  let [low, high] = [Infinity, -Infinity];
  for (const reading of readings) {
    const range = ranges.get(reading) ?? rangeOfValues(reading, pixelCount);
    ranges.set(reading, range);
    low = Math.min(low, range[0]);
    high = Math.max(high, range[1]);
  }
  return low < high ? [low, high] : [low, low + 1];
}

/** Of one layer before anybody chose a range: the same for all panes of it, so that they compare. */
export function usualRange(report: ReportData, readings: readonly Reading[]): Range {
  const [first] = readings;
  if (first.map === "none" || first.map === "picture") return [0, 1];
  if (first.layer === "failing") return [0, Math.max(report.failing.of, 1)];
  if (first.layer !== "depth_error") return sharedRange(readings, report.width * report.height);
  const { world } = report.depth_range;
  const reliefs = report.objects.flatMap(({ relief_depth }) => relief_depth ?? []);
  const end = first.unit === "world units" ? world : world / Math.max(...reliefs);
  return [-end, end];
}
