// The values at the two ends of a color map.
import type { ReportData } from "../data";
import type { LayerKey } from "./layers";
import { roundedUp } from "./numbers";
import type { Reading } from "./reading";

/** Values at the two ends of the color map. */
export type Range = readonly [low: number, high: number];

/**
 * Whether a range can be chosen: 0 must be the middle for errors, and the low end for all layers but depth.
 */
export function isRange(layer: LayerKey, low: number, high: number): boolean {
  if (!(low < high && high > 0)) return false;
  if (layer === "depth_error") return low === -high;
  return layer === "depth" || low === 0;
}

/** Share of the pixels beyond the default range, because a few outliers would make all others pale. */
const kBeyondRange = 0.01;

const ranges = new WeakMap<Reading, Range>();

/**
 * From 0 to the percentile given by kBeyondRange, rounded up; for depths from the nearest to the farthest.
 */
function rangeOfValues(reading: Reading, pixelCount: number): Range {
  const values = new Float64Array(pixelCount);
  let count = 0;
  for (let pixel = 0; pixel < pixelCount; ++pixel)
    if (reading.categoryAt(pixel) < 0) values[count++] = reading.valueAt(pixel);
  const sorted = values.subarray(0, count).sort();
  if (count === 0) return [0, 1];
  if (reading.map === "gray") return [sorted[0], sorted[count - 1]];
  return [0, roundedUp(sorted[Math.floor((count - 1) * (1 - kBeyondRange))])];
}

/** The union of the ranges of these readings of one layer; never empty. */
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

/** The range shared by all panes that show the same layer, so that they can be compared. */
export function defaultRange(report: ReportData, readings: readonly Reading[]): Range {
  const [first] = readings;
  if (first.map === "none" || first.map === "picture") return [0, 1];
  if (first.layer === "failing") return [0, Math.max(report.failing.of, 1)];
  if (first.layer !== "depth_error") return sharedRange(readings, report.width * report.height);
  const { world } = report.depth_range;
  const reliefs = report.objects.flatMap(({ relief_depth }) => relief_depth ?? []);
  const end = first.unit === "world units" ? world : world / Math.max(...reliefs);
  return [-end, end];
}
