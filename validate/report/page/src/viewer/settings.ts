// What the viewer shows, read from the page's state (state.ts) and written to it.
import type { ReportData } from "../data";
import { techniqueFrames, defaultTechnique } from "../frames";
import { getState, updateState } from "../state";
import { layersOf, type LayerKey } from "./layers";
import { isRange, type Range } from "./ranges";
import type { DepthUnit } from "./reading";
import {
  kMostPanes,
  possiblePane,
  standardPanes,
  type PaneChoice,
  type TechniqueChoice,
} from "./standard_panes";
import type { Camera, Pixel } from "./zoom";

export const arrangements = ["side", "wipe", "flicker", "blend"] as const;
export type Arrangement = (typeof arrangements)[number];

export interface Settings extends TechniqueChoice {
  arrangement: Arrangement;
  /** Number of panes side by side. Wipe, flicker and blend use the first two. */
  paneCount: number;
  panes: PaneChoice[];
  camera: Camera;
  unit: DepthUnit;
  /** Chosen ranges of color maps, by rangeKey(). */
  ranges: { [key: string]: Range };
  /** The pixel held by a click, marked by the crosshair. */
  held: Pixel | null;
  /** For flicker: whether the second pane is shown. */
  second: boolean;
  /** Share of the width that shows the first pane, and opacity of the second, 0 to 1. */
  wipe: number;
  opacity: number;
}

/** Width in CSS pixels below which viewer.css stacks the panes. */
const kNarrowPx = 700;

/** A report with the reference only needs one pane. */
function defaultPaneCount(report: ReportData): "1" | "2" | "4" {
  if (techniqueFrames(report).length === 0) return "1";
  return window.innerWidth < kNarrowPx ? "2" : "4";
}

/** Whether the relief depth of any object is known, so that depth errors can be given in relief depths. */
export function hasRelief(report: ReportData): boolean {
  return report.objects.some(({ relief_depth }) => relief_depth !== null);
}

/** Whether writeSettings() writes this key of the page's state. */
export function isViewerKey(key: string): boolean {
  return kKeys.has(key) || key.startsWith(kRangePrefix);
}
const kKeys = new Set(["t", "vs", "view", "n", "zoom", "unit", "pixel", "side", "wipe", "opacity"]);
for (let pane = 1; pane <= kMostPanes; ++pane) kKeys.add(`f${pane}`).add(`l${pane}`);
const kRangePrefix = "range.";

export function rangeKey(layer: LayerKey, unit: DepthUnit): string {
  return layer === "depth_error" && unit === "relief" ? kReliefRange.key : layer;
}
const kReliefRange = { key: "depth_error.relief", layer: "depth_error" } as const;

/** Every range that can be chosen; depth errors have one for each unit. */
function rangesOf(report: ReportData): { key: string; layer: LayerKey }[] {
  return [...layersOf(report).map(({ key }) => ({ key, layer: key })), kReliefRange];
}

/** Reads values of the page's state and lists those that this report can't show. */
class StateReader {
  readonly refused: string[] = [];

  oneOf<Value extends string>(key: string, values: readonly Value[], otherwise: Value): Value {
    const text = getState(key);
    if (text === undefined) return otherwise;
    if ((values as readonly string[]).includes(text)) return text as Value;
    this.refused.push(`${key}=${text}`);
    return otherwise;
  }

  /** `count` numbers with commas between. */
  numbers(key: string, count: number, areGood: (...values: number[]) => boolean): number[] | undefined {
    const text = getState(key);
    if (text === undefined) return undefined;
    const read = text.split(",").map((part) => (part.trim() === "" ? NaN : Number(part)));
    if (read.length === count && read.every(Number.isFinite) && areGood(...read)) return read;
    this.refused.push(`${key}=${text}`);
    return undefined;
  }

  /** From 0 to 1. */
  share(key: string): number {
    return this.numbers(key, 1, (value) => value >= 0 && value <= 1)?.[0] ?? 0.5;
  }
}

/**
 * Reads the settings from the page's state. Values that this report can't show keep their defaults and are
 * listed in `refused`. /
 */
export function readSettings(report: ReportData): Settings & { refused: string[] } {
  const state = new StateReader();
  const techniques = techniqueFrames(report).map(({ id }) => id);
  const technique = state.oneOf("t", techniques, defaultTechnique(report)?.id ?? "");
  const comparedWith = state.oneOf("vs", techniques, "");
  return {
    technique,
    comparedWith,
    arrangement: state.oneOf("view", arrangements, "side"),
    paneCount: Number(state.oneOf("n", ["1", "2", "3", "4"], defaultPaneCount(report))),
    panes: standardPanes(report, { technique, comparedWith }).map((pane, index) =>
      readPane(report, state, index, pane),
    ),
    camera: readCamera(report, state),
    unit: state.oneOf("unit", hasRelief(report) ? ["world", "relief"] : ["world"], "world"),
    ranges: readRanges(report, state),
    held: readHeld(report, state),
    second: state.oneOf("side", ["1", "2"], "1") === "2",
    wipe: state.share("wipe"),
    opacity: state.share("opacity"),
    refused: state.refused,
  };
}

function readPane(report: ReportData, state: StateReader, index: number, standard: PaneChoice): PaneChoice {
  const frames = report.frames.map(({ id }) => id);
  const layers = layersOf(report).map(({ key }) => key);
  const wanted = {
    frame: state.oneOf(`f${index + 1}`, frames, standard.frame),
    layer: state.oneOf(`l${index + 1}`, layers, standard.layer),
  };
  const possible = possiblePane(report, wanted);
  const isRefused = getState(`l${index + 1}`) === wanted.layer && possible.layer !== wanted.layer;
  if (isRefused) state.refused.push(`l${index + 1}=${wanted.layer}`);
  return possible;
}

function readCamera(report: ReportData, state: StateReader): Camera {
  const [scale, x, y] = state.numbers("zoom", 3, (wanted) => wanted >= 1) ?? [
    1,
    report.width / 2,
    report.height / 2,
  ];
  return { scale, x, y };
}

function readHeld({ width, height }: ReportData, state: StateReader): Pixel | null {
  const isPixel = (x: number, y: number) =>
    [x, y].every(Number.isInteger) && x >= 0 && y >= 0 && x < width && y < height;
  const held = state.numbers("pixel", 2, isPixel);
  return held ? { x: held[0], y: held[1] } : null;
}

function readRanges(report: ReportData, state: StateReader): Settings["ranges"] {
  const ranges: Settings["ranges"] = {};
  for (const { key, layer } of rangesOf(report)) {
    const ends = state.numbers(kRangePrefix + key, 2, (low, high) => isRange(layer, low, high));
    if (ends) ranges[key] = [ends[0], ends[1]];
  }
  return ranges;
}

/** Writes all settings that differ from their defaults. */
export function writeSettings(report: ReportData, settings: Settings): void {
  const unless = (isDefault: boolean, text: string | number) => (isDefault ? undefined : String(text));
  const { camera, held } = settings;
  const changes: { [key: string]: string | undefined } = {
    t: unless(settings.technique === (defaultTechnique(report)?.id ?? ""), settings.technique),
    vs: unless(settings.comparedWith === "", settings.comparedWith),
    view: unless(settings.arrangement === "side", settings.arrangement),
    n: unless(String(settings.paneCount) === defaultPaneCount(report), settings.paneCount),
    zoom: unless(
      camera.scale === 1 && camera.x === report.width / 2 && camera.y === report.height / 2,
      `${camera.scale},${camera.x},${camera.y}`,
    ),
    unit: unless(settings.unit === "world", settings.unit),
    pixel: held ? `${held.x},${held.y}` : undefined,
    side: unless(!settings.second, 2),
    wipe: unless(settings.wipe === 0.5, settings.wipe),
    opacity: unless(settings.opacity === 0.5, settings.opacity),
  };
  standardPanes(report, settings).forEach((standard, index) => {
    const pane = settings.panes[index];
    changes[`f${index + 1}`] = unless(pane.frame === standard.frame, pane.frame);
    changes[`l${index + 1}`] = unless(pane.layer === standard.layer, pane.layer);
  });
  for (const { key } of rangesOf(report)) changes[kRangePrefix + key] = settings.ranges[key]?.join(",");
  updateState(changes);
}
