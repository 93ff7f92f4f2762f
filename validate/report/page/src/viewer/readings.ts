// A layer of a frame read pixel by pixel: each pixel has a value, or belongs to a category that says why it has none (of layers that
// are categories altogether, every pixel does). Painting, legend, ranges and the read-out all go by this.
import { saysUncertain, type LayerName, type MapName, type ReportData } from "../data";
import type { FrameData, Layer } from "../frame_store";
import { colorsOf, packColor, type Colors, type Packed } from "./colors";
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
  /** How a value becomes a colour; "picture": it is one, "none": there are no values. */
  map: MapName | "picture" | "none";
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

/** Throws where a plane it needs is missing. */
export function readLayer(report: ReportData, layer: LayerKey, frame: FrameData, reference: FrameData, unit: DepthUnit): Reading {
  const { palette } = colorsOf(report);
  switch (layer) {
    case "color":
      return readColor(frame, report.width * report.height);
    case "silhouette":
      return readSilhouette(palette, frame, reference);
    case "depth_error":
      return readDepthError(report, palette, frame, reference, unit);
    case "normal_angle":
      return readNormalAngle(palette, frame, reference);
    case "fetches":
      return readCovered(palette, layer, "look-ups", frame, "sequential");
    case "iterations":
      return readCovered(palette, layer, "iterations", frame, "sequential");
    case "depth":
      return readCovered(palette, layer, "world units", frame, "gray");
    case "failing":
      return readFailing(report, palette, frame);
    default:
      return readShadow(report, palette, layer, frame, reference);
  }
}

type Palette = Colors["palette"];
const nothing = ({ nothing: color }: Palette): Category => ({ label: "nothing there", color });
const invalid = ({ invalid: color }: Palette): Category => ({ label: "not a finite number", color });
const unshared = ({ unshared: color }: Palette): Category => ({ label: "not the same object in both", color });

function plane(frame: FrameData, name: LayerName): Layer {
  const layer = frame.get(name);
  if (!layer) throw new Error(`${frame.label} has no plane '${name}'`);
  return layer;
}

function readColor(frame: FrameData, pixels: number): Reading {
  const codes = plane(frame, "color");
  const colorAt = (pixel: number) => packColor(codes.at(pixel), codes.at(pixels + pixel), codes.at(2 * pixels + pixel));
  return { layer: "color", map: "picture", unit: "", categories: [], categoryAt: () => -1, valueAt: colorAt };
}

/** Says why a legend's counts aren't the table's. */
function countsNote(uncertain: readonly Layer[], uncertainInTable: string, more = ""): string {
  const apart = uncertain.length > 0 ? ", pixels that the reference isn't sure of apart" : "";
  const inTable = uncertain.length > 0 ? `, ${uncertainInTable}` : "";
  return `Counted over all objects${apart}. The table counts the objects that have a relief alone${inTable}${more}.`;
}

function uncertainPlanes(reference: FrameData, ...names: LayerName[]): Layer[] {
  return names.flatMap((name) => reference.get(name) ?? []);
}

/** Whether any of the planes says so. */
function isUncertain(planes: readonly Layer[], pixel: number): boolean {
  for (const each of planes) if (saysUncertain(each.at(pixel))) return true;
  return false;
}

function uncertainCategories(palette: Palette, planes: readonly Layer[]): Category[] {
  const always = planes.length > 0;
  return [
    { label: "agree, reference uncertain", color: palette.uncertain_agrees, always },
    { label: "differ, reference uncertain", color: palette.uncertain_differs, always },
  ];
}

function readSilhouette(palette: Palette, frame: FrameData, reference: FrameData): Reading {
  const test = plane(frame, "id");
  const truth = plane(reference, "id");
  const uncertain = uncertainPlanes(reference, "uncertain");
  const categories: Category[] = [
    { ...nothing(palette), label: "nothing in both" },
    { label: "agree", color: palette.agree, always: true },
    { label: "missing", color: palette.missing, always: true },
    { label: "extra", color: palette.extra, always: true },
    { label: "another object", color: palette.other, always: true },
    ...uncertainCategories(palette, uncertain),
  ];
  const categoryAt = (pixel: number) => {
    const [shown, wanted] = [test.at(pixel), truth.at(pixel)];
    if (isUncertain(uncertain, pixel)) return shown === wanted ? 5 : 6;
    if (shown === wanted) return wanted === 0 ? 0 : 1;
    if (shown === 0) return 2;
    return wanted === 0 ? 3 : 4;
  };
  const note = countsNote(
    uncertain,
    "these pixels as missing or extra like all others",
    ", and another object as missing of the one and extra of the other",
  );
  return { layer: "silhouette", map: "none", unit: "", note, categories, categoryAt, valueAt: () => NaN };
}

/** Index into [nothing, unshared] of pixels that the two don't share; -1 of those they do. */
function unsharedAt(test: Layer, truth: Layer, pixel: number): number {
  const wanted = truth.at(pixel);
  if (test.at(pixel) !== wanted) return 1;
  return wanted === 0 ? 0 : -1;
}

/** The error's divisor by object number; NaN where the relief's depth isn't known. */
function errorUnits(report: ReportData, unit: DepthUnit): number[] {
  const units: number[] = [];
  for (const object of report.objects) units[object.id] = unit === "world" ? 1 : (object.relief_depth ?? NaN);
  return units;
}

function readDepthError(
  report: ReportData,
  palette: Palette,
  frame: FrameData,
  reference: FrameData,
  unit: DepthUnit,
): Reading {
  const test = plane(frame, "id");
  const truth = plane(reference, "id");
  const depth = plane(frame, "depth");
  const trueDepth = plane(reference, "depth");
  const units = errorUnits(report, unit);
  const errorAt = (pixel: number) => depth.at(pixel) - trueDepth.at(pixel);
  const divisorAt = (pixel: number) => units[truth.at(pixel)] ?? (unit === "world" ? 1 : NaN);
  return {
    layer: "depth_error",
    map: "diverging",
    unit: unit === "world" ? "world units" : "relief depths",
    note: `The usual range: ${report.depth_range.note}`,
    categories: [nothing(palette), unshared(palette), invalid(palette), { label: "no relief", color: palette.dark }],
    categoryAt: (pixel) => {
      const unshared = unsharedAt(test, truth, pixel);
      if (unshared >= 0) return unshared;
      if (!Number.isFinite(errorAt(pixel))) return 2;
      return divisorAt(pixel) > 0 ? -1 : 3;
    },
    valueAt: (pixel) => (unsharedAt(test, truth, pixel) < 0 ? errorAt(pixel) / divisorAt(pixel) : NaN),
  };
}

function readShadow(
  report: ReportData,
  palette: Palette,
  layer: `shadow.${string}`,
  frame: FrameData,
  reference: FrameData,
): Reading {
  const test = plane(frame, "id");
  const truth = plane(reference, "id");
  const shadow = plane(frame, layer);
  const trueShadow = plane(reference, layer);
  const uncertain = uncertainPlanes(reference, "uncertain", `uncertain.${layer}`);
  const categories: Category[] = [
    nothing(palette),
    unshared(palette),
    invalid(palette),
    { label: "lit in both", color: palette.agree, always: true },
    { label: "dark in both", color: palette.dark, always: true },
    { label: "false light", color: palette.missing, always: true },
    { label: "false shadow", color: palette.extra, always: true },
    ...uncertainCategories(palette, uncertain),
  ];
  const categoryAt = (pixel: number) => {
    const notShared = unsharedAt(test, truth, pixel);
    if (notShared >= 0) return notShared;
    const [shown, wanted] = [shadow.at(pixel), trueShadow.at(pixel)];
    if (!Number.isFinite(shown) || !Number.isFinite(wanted)) return 2;
    const dark = shown >= report.shadow_threshold;
    const agrees = dark === wanted >= report.shadow_threshold;
    if (isUncertain(uncertain, pixel)) return agrees ? 7 : 8;
    if (agrees) return dark ? 4 : 3;
    return dark ? 6 : 5;
  };
  const note = countsNote(uncertain, "these pixels as right or wrong like all others");
  return { layer, map: "none", unit: "", note, categories, categoryAt, valueAt: () => NaN };
}

function readNormalAngle(palette: Palette, frame: FrameData, reference: FrameData): Reading {
  const test = plane(frame, "id");
  const truth = plane(reference, "id");
  const angles = plane(frame, "normal_angle");
  return {
    layer: "normal_angle",
    map: "sequential",
    unit: "degrees",
    categories: [nothing(palette), unshared(palette), { ...invalid(palette), label: "no normal" }],
    categoryAt: (pixel) => {
      const notShared = unsharedAt(test, truth, pixel);
      if (notShared >= 0) return notShared;
      return Number.isFinite(angles.at(pixel)) ? -1 : 2;
    },
    valueAt: (pixel) => (unsharedAt(test, truth, pixel) < 0 ? angles.at(pixel) : NaN),
  };
}

/** A plane over the pixels the frame covers. */
function readCovered(
  palette: Palette,
  layer: "fetches" | "iterations" | "depth",
  unit: string,
  frame: FrameData,
  map: "sequential" | "gray",
): Reading {
  const id = plane(frame, "id");
  const values = plane(frame, layer);
  return {
    layer,
    map,
    unit,
    categories: [nothing(palette), invalid(palette)],
    categoryAt: (pixel) => (id.at(pixel) === 0 ? 0 : Number.isFinite(values.at(pixel)) ? -1 : 1),
    valueAt: (pixel) => (id.at(pixel) === 0 ? NaN : values.at(pixel)),
  };
}

function readFailing(report: ReportData, palette: Palette, frame: FrameData): Reading {
  const counts = plane(frame, "failing");
  return {
    layer: "failing",
    map: "sequential",
    unit: `of ${report.failing.of} techniques`,
    note: `Failing: ${report.failing.meaning}`,
    categories: [{ ...nothing(palette), label: "none fails" }],
    categoryAt: (pixel) => (counts.at(pixel) > 0 ? -1 : 0),
    valueAt: (pixel) => counts.at(pixel),
  };
}
