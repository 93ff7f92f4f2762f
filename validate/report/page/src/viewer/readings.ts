// A layer of a frame read pixel by pixel: each pixel has a value, or belongs to a category that says why it has none (of layers that
// are categories altogether, every pixel does). Painting, legend, ranges and the read-out all go by this.
import type { FrameData, LayerName, ReportData } from "../data";
import { packColor, palette, type Packed } from "./colormaps";
import type { LayerKey } from "./layers";

export type DepthUnit = "world" | "relief";

export interface Category {
  label: string;
  color: Packed;
  /** Named in the legend even where no pixel is in it. */
  always?: boolean;
}

export interface Reading {
  layer: LayerKey;
  /** How a value becomes a colour. */
  map: "none" | "diverging" | "sequential" | "grey" | "picture";
  /** Of a value; "" of pictures and categories. */
  unit: string;
  /** A sentence for the legend. */
  note?: string;
  categories: Category[];
  /** Index into categories; -1 if the pixel has a value. */
  categoryAt(pixel: number): number;
  /** NaN if it has none; of a picture the packed colour. */
  valueAt(pixel: number): number;
}

const kNothing: Category = { label: "nothing there", color: palette.nothing };
const kInvalid: Category = { label: "not a finite number", color: palette.invalid };
const kUnshared: Category = { label: "not the same object in both", color: palette.unshared };

/** Throws where a plane it needs is missing. */
export function readLayer(report: ReportData, layer: LayerKey, frame: FrameData, reference: FrameData, unit: DepthUnit): Reading {
  switch (layer) {
    case "color":
      return readColor(frame);
    case "silhouette":
      return readSilhouette(frame, reference);
    case "depth_error":
      return readDepthError(report, frame, reference, unit);
    case "normal_angle":
      return readCovered(layer, "degrees", frame, "sequential");
    case "fetches":
      return readCovered(layer, "look-ups", frame, "sequential");
    case "iterations":
      return readCovered(layer, "iterations", frame, "sequential");
    case "depth":
      return readCovered(layer, "world units", frame, "grey");
    case "failing":
      return readFailing(report, frame);
    default:
      return readShadow(layer, frame, reference);
  }
}

export function plane(frame: FrameData, name: LayerName): Float32Array {
  const layer = frame.get(name);
  if (!layer) throw new Error(`${frame.name} has no plane '${name}'`);
  return layer.values;
}

function readColor(frame: FrameData): Reading {
  const codes = plane(frame, "color");
  const pixels = codes.length / 3;
  const colorAt = (pixel: number) => packColor(codes[pixel], codes[pixels + pixel], codes[2 * pixels + pixel]);
  return { layer: "color", map: "picture", unit: "", categories: [], categoryAt: () => -1, valueAt: colorAt };
}

function readSilhouette(frame: FrameData, reference: FrameData): Reading {
  const test = plane(frame, "id");
  const truth = plane(reference, "id");
  const uncertain = reference.get("uncertain")?.values;
  const categories: Category[] = [
    { ...kNothing, label: "nothing in both" },
    { label: "agree", color: palette.agree, always: true },
    { label: "missing", color: palette.missing, always: true },
    { label: "extra", color: palette.extra, always: true },
    { label: "another object", color: palette.other, always: true },
    { label: "agree, reference uncertain", color: palette.uncertainAgrees, always: uncertain !== undefined },
    { label: "differ, reference uncertain", color: palette.uncertainDiffers, always: uncertain !== undefined },
  ];
  const categoryAt = (pixel: number) => {
    const agrees = test[pixel] === truth[pixel];
    if (uncertain?.[pixel]) return agrees ? 5 : 6;
    if (agrees) return truth[pixel] === 0 ? 0 : 1;
    if (test[pixel] === 0) return 2;
    return truth[pixel] === 0 ? 3 : 4;
  };
  return { layer: "silhouette", map: "none", unit: "", categories, categoryAt, valueAt: () => NaN };
}

/** Index into [kNothing, kUnshared] of pixels that the two don't share; -1 of those they do. */
function unsharedAt(test: Float32Array, truth: Float32Array, pixel: number): number {
  if (test[pixel] !== truth[pixel]) return 1;
  return truth[pixel] === 0 ? 0 : -1;
}

/** The error's divisor by object number; NaN where the relief's depth isn't known. */
function errorUnits(report: ReportData, unit: DepthUnit): number[] {
  const units: number[] = [];
  for (const object of report.objects) units[object.id] = unit === "world" ? 1 : (object.relief_depth ?? NaN);
  return units;
}

function readDepthError(report: ReportData, frame: FrameData, reference: FrameData, unit: DepthUnit): Reading {
  const test = plane(frame, "id");
  const truth = plane(reference, "id");
  const depth = plane(frame, "depth");
  const trueDepth = plane(reference, "depth");
  const units = errorUnits(report, unit);
  const errorAt = (pixel: number) => depth[pixel] - trueDepth[pixel];
  const divisorAt = (pixel: number) => units[truth[pixel]] ?? (unit === "world" ? 1 : NaN);
  return {
    layer: "depth_error",
    map: "diverging",
    unit: unit === "world" ? "world units" : "relief depths",
    note: `The usual range: ${report.depth_range.note}`,
    categories: [kNothing, kUnshared, kInvalid, { label: "no relief", color: palette.bothDark }],
    categoryAt: (pixel) => {
      const unshared = unsharedAt(test, truth, pixel);
      if (unshared >= 0) return unshared;
      if (!Number.isFinite(errorAt(pixel))) return 2;
      return divisorAt(pixel) > 0 ? -1 : 3;
    },
    valueAt: (pixel) => (unsharedAt(test, truth, pixel) < 0 ? errorAt(pixel) / divisorAt(pixel) : NaN),
  };
}

function readShadow(layer: `shadow.${string}`, frame: FrameData, reference: FrameData): Reading {
  const test = plane(frame, "id");
  const truth = plane(reference, "id");
  const shadow = plane(frame, layer);
  const trueShadow = plane(reference, layer);
  const uncertain = reference.get(`uncertain.${layer}`)?.values;
  const categories: Category[] = [
    kNothing,
    kUnshared,
    kInvalid,
    { label: "lit in both", color: palette.agree, always: true },
    { label: "dark in both", color: palette.bothDark, always: true },
    { label: "false light", color: palette.missing, always: true },
    { label: "false shadow", color: palette.extra, always: true },
    { label: "agree, reference uncertain", color: palette.uncertainAgrees, always: uncertain !== undefined },
    { label: "differ, reference uncertain", color: palette.uncertainDiffers, always: uncertain !== undefined },
  ];
  const categoryAt = (pixel: number) => {
    const unshared = unsharedAt(test, truth, pixel);
    if (unshared >= 0) return unshared;
    if (!Number.isFinite(shadow[pixel]) || !Number.isFinite(trueShadow[pixel])) return 2;
    const dark = shadow[pixel] >= 0.5;
    const agrees = dark === trueShadow[pixel] >= 0.5;
    if (uncertain?.[pixel]) return agrees ? 7 : 8;
    if (agrees) return dark ? 4 : 3;
    return dark ? 6 : 5;
  };
  return { layer, map: "none", unit: "", categories, categoryAt, valueAt: () => NaN };
}

/** A plane over the pixels the frame covers. */
function readCovered(
  layer: "normal_angle" | "fetches" | "iterations" | "depth",
  unit: string,
  frame: FrameData,
  map: "sequential" | "grey",
): Reading {
  const id = plane(frame, "id");
  const values = plane(frame, layer);
  // Angles are there only where both show the same object.
  const none = layer === "normal_angle" ? kUnshared : kInvalid;
  return {
    layer,
    map,
    unit,
    categories: [kNothing, none],
    categoryAt: (pixel) => (id[pixel] === 0 ? 0 : Number.isFinite(values[pixel]) ? -1 : 1),
    valueAt: (pixel) => (id[pixel] === 0 ? NaN : values[pixel]),
  };
}

function readFailing(report: ReportData, frame: FrameData): Reading {
  const counts = plane(frame, "failing");
  return {
    layer: "failing",
    map: "sequential",
    unit: `of ${report.failing.of} techniques`,
    note: `Failing: ${report.failing.meaning}`,
    categories: [{ ...kNothing, label: "none fails" }],
    categoryAt: (pixel) => (counts[pixel] > 0 ? -1 : 0),
    valueAt: (pixel) => counts[pixel],
  };
}
