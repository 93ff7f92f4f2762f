// Readings of the differences between a frame and the reference.
import { saysUncertain, type LayerName, type ReportData } from "../data";
import type { FrameData } from "../frame_store";
import type { Layer } from "../layer_unpacking";
import {
  invalid,
  nothing,
  plane,
  type Category,
  type DepthUnit,
  type Palette,
  type Reading,
} from "./reading";

const unshared = ({ unshared: color }: Palette): Category => ({
  label: "not the same object in both",
  color,
});

export function readSilhouette(palette: Palette, frame: FrameData, reference: FrameData): Reading {
  const ids = plane(frame, "id");
  const referenceIds = plane(reference, "id");
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
    const [shown, expected] = [ids.at(pixel), referenceIds.at(pixel)];
    if (isUncertain(uncertain, pixel)) return shown === expected ? 5 : 6;
    if (shown === expected) return expected === 0 ? 0 : 1;
    if (shown === 0) return 2;
    return expected === 0 ? 3 : 4;
  };
  const note = countsNote(
    ...uncertainNote(uncertain, "missing or extra like all other pixels"),
    "The table counts another object as missing from the one and extra in the other.",
  );
  return { layer: "silhouette", map: "none", unit: "", note, categories, categoryAt, valueAt: () => NaN };
}

/** Divisor of the error by object id; NaN if the relief depth is unknown. */
function errorUnits(report: ReportData, unit: DepthUnit): number[] {
  const units: number[] = [];
  for (const object of report.objects) units[object.id] = unit === "world" ? 1 : (object.relief_depth ?? NaN);
  return units;
}

export function readDepthError(
  report: ReportData,
  palette: Palette,
  frame: FrameData,
  reference: FrameData,
  unit: DepthUnit,
): Reading {
  const ids = plane(frame, "id");
  const referenceIds = plane(reference, "id");
  const depth = plane(frame, "depth");
  const referenceDepth = plane(reference, "depth");
  const units = errorUnits(report, unit);
  const errorAt = (pixel: number) => depth.at(pixel) - referenceDepth.at(pixel);
  const divisorAt = (pixel: number) => units[referenceIds.at(pixel)] ?? (unit === "world" ? 1 : NaN);
  return {
    layer: "depth_error",
    map: "diverging",
    unit: unit === "world" ? "world units" : "relief depths",
    note: `Default range: ${report.depth_range.note}`,
    categories: [
      nothing(palette),
      unshared(palette),
      invalid(palette),
      { label: "no relief", color: palette.dark },
    ],
    categoryAt: (pixel) => {
      const unshared = unsharedAt(ids, referenceIds, pixel);
      if (unshared >= 0) return unshared;
      if (!Number.isFinite(errorAt(pixel))) return 2;
      return divisorAt(pixel) > 0 ? -1 : 3;
    },
    valueAt: (pixel) => (unsharedAt(ids, referenceIds, pixel) < 0 ? errorAt(pixel) / divisorAt(pixel) : NaN),
  };
}

export function readShadow(
  report: ReportData,
  palette: Palette,
  layer: `shadow.${string}`,
  frame: FrameData,
  reference: FrameData,
): Reading {
  const ids = plane(frame, "id");
  const referenceIds = plane(reference, "id");
  const shadow = plane(frame, layer);
  const referenceShadow = plane(reference, layer);
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
    const notShared = unsharedAt(ids, referenceIds, pixel);
    if (notShared >= 0) return notShared;
    const [shown, expected] = [shadow.at(pixel), referenceShadow.at(pixel)];
    if (!Number.isFinite(shown) || !Number.isFinite(expected)) return 2;
    const dark = shown >= report.shadow_threshold;
    const agrees = dark === expected >= report.shadow_threshold;
    if (isUncertain(uncertain, pixel)) return agrees ? 7 : 8;
    if (agrees) return dark ? 4 : 3;
    return dark ? 6 : 5;
  };
  const note = countsNote(...uncertainNote(uncertain, "right or wrong like all other pixels"));
  return { layer, map: "none", unit: "", note, categories, categoryAt, valueAt: () => NaN };
}

export function readNormalAngle(palette: Palette, frame: FrameData, reference: FrameData): Reading {
  const ids = plane(frame, "id");
  const referenceIds = plane(reference, "id");
  const angles = plane(frame, "normal_angle");
  return {
    layer: "normal_angle",
    map: "sequential",
    unit: "degrees",
    categories: [nothing(palette), unshared(palette), { ...invalid(palette), label: "no normal" }],
    categoryAt: (pixel) => {
      const notShared = unsharedAt(ids, referenceIds, pixel);
      if (notShared >= 0) return notShared;
      return Number.isFinite(angles.at(pixel)) ? -1 : 2;
    },
    valueAt: (pixel) => (unsharedAt(ids, referenceIds, pixel) < 0 ? angles.at(pixel) : NaN),
  };
}

/**
 * Index into [nothing, unshared] for a pixel that doesn't show the same object in both frames; otherwise -1.
 */
function unsharedAt(ids: Layer, referenceIds: Layer, pixel: number): number {
  const expected = referenceIds.at(pixel);
  if (ids.at(pixel) !== expected) return 1;
  return expected === 0 ? 0 : -1;
}

/**
 * Why the legend's counts differ from the table's. `inTable`: how the table counts differently, a sentence
 * each. /
 */
function countsNote(...inTable: string[]): string {
  return ["These counts cover all objects, the table only those with a relief.", ...inTable].join(" ");
}

/** `asWhat`: how the table counts the pixels of the two uncertain categories. */
function uncertainNote(uncertain: readonly Layer[], asWhat: string): string[] {
  if (uncertain.length === 0) return [];
  return [
    `Pixels where the reference is uncertain are counted separately; the table counts them as ${asWhat}.`,
  ];
}

function uncertainPlanes(reference: FrameData, ...names: LayerName[]): Layer[] {
  return names.flatMap((name) => reference.get(name) ?? []);
}

/** Whether any of the planes marks the pixel. */
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
