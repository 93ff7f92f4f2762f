// What the viewer shows, and its way into the page's state (state.ts) and back.
import type { FrameEntry, ReportData } from "../data";
import { frameById, referenceOf, techniqueFrames, usualTechnique } from "../frames";
import { getState, updateState } from "../state";
import { layersOf, reasonAgainst, type LayerKey } from "./layers";
import { isRange, type Range } from "./paint";
import type { DepthUnit } from "./readings";
import type { Camera } from "./zoom";

export const arrangements = ["side", "wipe", "flicker", "blend"] as const;
export type Arrangement = (typeof arrangements)[number];

export interface PaneChoice {
  /** Its id. */
  frame: string;
  layer: LayerKey;
}

export interface Settings {
  /** The technique's frame that the standard panes show, its id; "" in a report without. */
  technique: string;
  /** That of the technique it is held against in them; "": none. */
  against: string;
  arrangement: Arrangement;
  /** Panes side by side. Wipe, flicker and blend take the first two. */
  paneCount: number;
  panes: PaneChoice[];
  camera: Camera;
  unit: DepthUnit;
  /** Ends of colour maps that somebody chose, by rangeKey(). */
  ranges: { [key: string]: Range };
  /** The pixel held with the crosshair, from the left and the top. */
  held: { x: number; y: number } | null;
  /** Of flicker: whether the second pane is seen. */
  second: boolean;
  /** Share of the width the first pane has, and how much of the second is seen, 0 to 1. */
  wipe: number;
  opacity: number;
}

export const kMostPanes = 4;
/** CSS pixels of width below which panes stand one below the other, as viewer.css has it. */
const kNarrowPx = 700;

/** Nothing but the reference there is is looked at once. */
function usualPaneCount(report: ReportData): "1" | "2" | "4" {
  if (techniqueFrames(report).length === 0) return "1";
  return window.innerWidth < kNarrowPx ? "2" : "4";
}

/** Whether any object's relief depth is known: without, errors can't be told in it. */
export function hasRelief(report: ReportData): boolean {
  return report.objects.some(({ relief_depth }) => relief_depth !== null);
}

/** Whether the key of the page's state is one of those that writeSettings() writes. */
export function isViewerKey(key: string): boolean {
  return kKeys.has(key) || key.startsWith(kRangePrefix);
}
const kKeys = new Set(["t", "vs", "view", "n", "zoom", "unit", "pixel", "side", "wipe", "opacity"]);
for (let pane = 1; pane <= kMostPanes; ++pane) kKeys.add(`f${pane}`).add(`l${pane}`);
const kRangePrefix = "range.";

export function rangeKey(layer: LayerKey, unit: DepthUnit): string {
  return layer === "depth_error" && unit === "relief" ? "depth_error.relief" : layer;
}

/** What is looked at first of a technique: itself beside the truth, then where the silhouette and the depth differ; of two, in turn. */
export function standardPanes(report: ReportData, technique: string, against: string): PaneChoice[] {
  const reference = referenceOf(report)?.id ?? "";
  if (!technique) return Array.from({ length: kMostPanes }, () => possiblePane(report, { frame: reference, layer: "color" }));
  const panes: PaneChoice[] = against
    ? [
        { frame: technique, layer: "color" },
        { frame: against, layer: "color" },
        { frame: technique, layer: "depth_error" },
        { frame: against, layer: "depth_error" },
      ]
    : [
        { frame: reference, layer: "color" },
        { frame: technique, layer: "color" },
        { frame: technique, layer: "silhouette" },
        { frame: technique, layer: "depth_error" },
      ];
  return panes.map((pane) => possiblePane(report, pane));
}

/** The same frame with a layer that it has: the one asked for if it can be, else the first in the order of the menu. */
export function possiblePane(report: ReportData, { frame, layer }: PaneChoice): PaneChoice {
  const entry = frameById(report, frame) as FrameEntry;
  const possible = layersOf(report).filter((info) => reasonAgainst(report, info, entry) === undefined);
  return { frame, layer: (possible.find(({ key }) => key === layer) ?? possible[0])?.key ?? layer };
}

/** As the page's state has it. What can't be is left at its default and told in `refused`. */
export function readSettings(report: ReportData): Settings & { refused: string[] } {
  const refused: string[] = [];
  const techniques = techniqueFrames(report).map(({ id }) => id);
  const oneOf = <Value extends string>(key: string, values: readonly Value[], otherwise: Value): Value => {
    const text = getState(key);
    if (text === undefined) return otherwise;
    if ((values as readonly string[]).includes(text)) return text as Value;
    refused.push(`${key}=${text}`);
    return otherwise;
  };
  const numbers = (key: string, count: number, areGood: (...values: number[]) => boolean): number[] | undefined => {
    const text = getState(key);
    if (text === undefined) return undefined;
    const read = text.split(",").map((part) => (part.trim() === "" ? NaN : Number(part)));
    if (read.length === count && read.every(Number.isFinite) && areGood(...read)) return read;
    refused.push(`${key}=${text}`);
    return undefined;
  };
  const share = (key: string) => numbers(key, 1, (value) => value >= 0 && value <= 1)?.[0] ?? 0.5;

  const technique = oneOf("t", techniques, usualTechnique(report)?.id ?? "");
  const against = oneOf("vs", techniques, "");
  const panes = standardPanes(report, technique, against).map((standard, index) => {
    const wanted = {
      frame: oneOf(`f${index + 1}`, report.frames.map(({ id }) => id), standard.frame),
      layer: oneOf(`l${index + 1}`, layersOf(report).map(({ key }) => key), standard.layer),
    };
    const possible = possiblePane(report, wanted);
    if (getState(`l${index + 1}`) === wanted.layer && possible.layer !== wanted.layer) refused.push(`l${index + 1}=${wanted.layer}`);
    return possible;
  });
  const [scale, x, y] = numbers("zoom", 3, (wanted) => wanted >= 1) ?? [1, report.width / 2, report.height / 2];
  const isPixel = (column: number, row: number) =>
    [column, row].every(Number.isInteger) && column >= 0 && row >= 0 && column < report.width && row < report.height;
  const held = numbers("pixel", 2, isPixel);
  const ranges: { [key: string]: Range } = {};
  for (const { key } of layersOf(report)) {
    for (const unit of ["world", "relief"] as const) {
      const areEnds = (low: number, high: number) => isRange(key, low, high);
      const ends = unit === "world" || key === "depth_error" ? numbers(kRangePrefix + rangeKey(key, unit), 2, areEnds) : undefined;
      if (ends) ranges[rangeKey(key, unit)] = [ends[0], ends[1]];
    }
  }
  return {
    technique,
    against,
    arrangement: oneOf("view", arrangements, "side"),
    paneCount: Number(oneOf("n", ["1", "2", "3", "4"], usualPaneCount(report))),
    panes,
    camera: { scale, x, y },
    unit: oneOf("unit", hasRelief(report) ? ["world", "relief"] : ["world"], "world"),
    ranges,
    held: held ? { x: held[0], y: held[1] } : null,
    second: oneOf("side", ["1", "2"], "1") === "2",
    wipe: share("wipe"),
    opacity: share("opacity"),
    refused,
  };
}

/** Everything that isn't as it would be without. */
export function writeSettings(report: ReportData, settings: Settings): void {
  const unless = (usual: boolean, text: string | number) => (usual ? undefined : String(text));
  const { camera, held } = settings;
  const changes: { [key: string]: string | undefined } = {
    t: unless(settings.technique === (usualTechnique(report)?.id ?? ""), settings.technique),
    vs: unless(settings.against === "", settings.against),
    view: unless(settings.arrangement === "side", settings.arrangement),
    n: unless(String(settings.paneCount) === usualPaneCount(report), settings.paneCount),
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
  standardPanes(report, settings.technique, settings.against).forEach((standard, index) => {
    const pane = settings.panes[index];
    changes[`f${index + 1}`] = unless(pane.frame === standard.frame, pane.frame);
    changes[`l${index + 1}`] = unless(pane.layer === standard.layer, pane.layer);
  });
  for (const { key } of layersOf(report)) {
    for (const unit of ["world", "relief"] as const) {
      const ends = settings.ranges[rangeKey(key, unit)];
      changes[kRangePrefix + rangeKey(key, unit)] = ends && ends.join(",");
    }
  }
  updateState(changes);
}
