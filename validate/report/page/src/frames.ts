// Selects the frames of a report by kind. Ids are unique; a technique may have any name, even "reference".
import type { FrameEntry, ReportData } from "./data";

export function frameById(report: ReportData, id: string): FrameEntry | undefined {
  return report.frames.find((frame) => frame.id === id);
}

/** undefined in a report without any frame. */
export function referenceOf(report: ReportData): FrameEntry | undefined {
  return report.frames.find(({ kind }) => kind === "reference");
}

export function techniqueFrames(report: ReportData): FrameEntry[] {
  return report.frames.filter(({ kind }) => kind === "technique");
}

/** `name`: in the results. Returns undefined for a technique that drew no frame. */
export function frameOfTechnique(report: ReportData, name: string): FrameEntry | undefined {
  return techniqueFrames(report).find((frame) => frame.name === name);
}

export function frameLabel(frame: FrameEntry): string {
  switch (frame.kind) {
    case "reference":
      return "Reference";
    case "proxy":
      return "Reference on the proxy";
    case "summary":
      return "All techniques";
    case "technique":
      return frame.name;
  }
}

/** The technique shown by default: the first that isn't a control, if there is one. */
export function defaultTechnique(report: ReportData): FrameEntry | undefined {
  const controls = new Set(
    report.results.techniques.filter(({ control }) => control).map(({ name }) => name),
  );
  const frames = techniqueFrames(report);
  return frames.find(({ name }) => !controls.has(name)) ?? frames[0];
}
