// The frames and layers that the panes show by default.
import type { FrameEntry, ReportData } from "../data";
import { frameById, referenceOf } from "../frames";
import { layersOf, reasonAgainst, type LayerKey } from "./layers";

export const kMostPanes = 4;

export interface PaneChoice {
  /** Id of the frame. */
  frame: string;
  layer: LayerKey;
}

/** Techniques whose frames the standard panes show, by id. */
export interface TechniqueChoice {
  /** "" in a report without techniques. */
  technique: string;
  /** The technique it is compared with; "": with the reference only. */
  comparedWith: string;
}

/**
 * For one technique: color of the reference and of the technique, then its silhouette difference and depth
 * error. For two: color and depth error of each. /
 */
export function standardPanes(
  report: ReportData,
  { technique, comparedWith }: TechniqueChoice,
): PaneChoice[] {
  const reference = referenceOf(report)?.id ?? "";
  if (!technique)
    return Array.from({ length: kMostPanes }, () =>
      possiblePane(report, { frame: reference, layer: "color" }),
    );
  const panes: PaneChoice[] = comparedWith
    ? [
        { frame: technique, layer: "color" },
        { frame: comparedWith, layer: "color" },
        { frame: technique, layer: "depth_error" },
        { frame: comparedWith, layer: "depth_error" },
      ]
    : [
        { frame: reference, layer: "color" },
        { frame: technique, layer: "color" },
        { frame: technique, layer: "silhouette" },
        { frame: technique, layer: "depth_error" },
      ];
  return panes.map((pane) => possiblePane(report, pane));
}

/** The same layers for other techniques; the standard panes if the number of techniques changes. */
export function panesOfOtherTechniques(
  report: ReportData,
  panes: readonly PaneChoice[],
  before: TechniqueChoice,
  now: TechniqueChoice,
): PaneChoice[] {
  const isSameKind = (now.comparedWith === "") === (before.comparedWith === "");
  if (!isSameKind || !panes.some(({ frame }) => frame === before.technique))
    return standardPanes(report, now);
  const successors = new Map([
    [before.comparedWith, now.comparedWith],
    [before.technique, now.technique],
  ]);
  return panes.map(({ frame, layer }) =>
    possiblePane(report, { frame: successors.get(frame) ?? frame, layer }),
  );
}

/**
 * The same frame with a layer that exists: the requested one if possible, otherwise the first in the order of
 * the menu. /
 */
export function possiblePane(report: ReportData, { frame, layer }: PaneChoice): PaneChoice {
  const entry = frameById(report, frame) as FrameEntry;
  const possible = layersOf(report).filter((info) => reasonAgainst(report, info, entry) === undefined);
  return { frame, layer: (possible.find(({ key }) => key === layer) ?? possible[0])?.key ?? layer };
}
