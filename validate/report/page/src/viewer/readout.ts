// The readout: the values of one pixel in every pane.
import type { ReportData } from "../data";
import type { FrameData } from "../frame_store";
import { channelsOf, cssColor } from "./colors";
import { make, setText } from "./dom";
import { shortestFloat, significant } from "./numbers";
import type { Reading } from "./reading";
import type { Pixel } from "./zoom";

export interface ReadPane {
  /** "1", or "A". */
  name: string;
  title: string;
  frame: FrameData | null;
  reading: Reading | null;
}

const kColumns = ["Pane", "Object", "Depth", "Value"] as const;

export class Readout {
  readonly element: HTMLElement;
  private readonly where = make("caption");
  private readonly rows = make("tbody");
  private readonly spoken = make("div", { class: "unseen", "aria-live": "polite" });

  constructor(private readonly report: ReportData) {
    const heads = kColumns.map((column) =>
      make("th", { scope: "col" }, column, ...(column === "Depth" ? [make("small", {}, "world units")] : [])),
    );
    const table = make(
      "table",
      { class: "readout" },
      this.where,
      make("thead", {}, make("tr", {}, ...heads)),
      this.rows,
    );
    this.element = make(
      "div",
      { class: "readout-box", tabindex: 0, role: "region", "aria-label": "Values of the pixel" },
      table,
      this.spoken,
    );
  }

  show(panes: readonly ReadPane[], pixel: Pixel | null): void {
    setText(
      this.where,
      pixel
        ? `Pixel ${pixel.x} from the left, ${pixel.y} from the top; its center is at ${pixel.x + 0.5}, ${pixel.y + 0.5}`
        : "Point at a picture, or focus it and press an arrow key, to read a pixel",
    );
    while (this.rows.rows.length > panes.length) this.rows.deleteRow(-1);
    while (this.rows.rows.length < panes.length)
      this.rows.append(
        make(
          "tr",
          {},
          make("th", { scope: "row" }, make("b"), make("span")),
          make("td"),
          make("td"),
          make("td"),
        ),
      );
    panes.forEach((pane, index) => {
      const cells = this.rows.rows[index].cells;
      const at = pixel ? pixel.y * this.report.width + pixel.x : -1;
      const [name, title] = cells[0].children;
      setText(name, pane.name);
      setText(title, pane.title);
      setText(cells[1], at < 0 || !pane.frame ? "" : objectText(this.report, pane.frame, at));
      setText(cells[2], at < 0 || !pane.frame ? "" : depthText(pane.frame, at));
      setText(cells[3], at < 0 || !pane.reading ? "" : valueText(this.report, pane.reading, pane.frame, at));
    });
  }

  /**
   * Text for screen readers. Only for pixels moved by keys, because the pointer would cause a constant
   * stream.
   */
  speak(panes: readonly ReadPane[], pixel: Pixel): void {
    const at = pixel.y * this.report.width + pixel.x;
    const values = panes.map(
      ({ name, reading, frame }) =>
        `${name}: ${reading ? valueText(this.report, reading, frame, at) : "none"}`,
    );
    setText(this.spoken, `${pixel.x}, ${pixel.y}. ${values.join(". ")}`);
  }
}

function objectText(report: ReportData, frame: FrameData, at: number): string {
  const id = frame.get("id")?.at(at);
  if (id === undefined) return "";
  if (id === 0) return "none";
  return report.objects.find((object) => object.id === id)?.name ?? `object ${id}`;
}

function depthText(frame: FrameData, at: number): string {
  const depth = frame.get("depth")?.at(at);
  return depth !== undefined && Number.isFinite(depth) ? shortestFloat(depth) : "";
}

function valueText(report: ReportData, reading: Reading, frame: FrameData | null, at: number): string {
  const category = reading.categoryAt(at);
  if (category >= 0) return reading.categories[category].label;
  const value = reading.valueAt(at);
  switch (reading.layer) {
    case "color":
      return `${cssColor(value)} · sRGB ${channelsOf(value).join(" ")}`;
    case "depth_error":
      return depthErrorText(report, reading, frame, at, value);
    case "normal_angle":
      return `${value.toFixed(2)}°`;
    case "depth":
      return `${shortestFloat(value)} world units`;
    case "failing":
      return `fails in ${value} of ${report.failing.of} techniques`;
    default:
      return `${shortestFloat(value)} ${reading.unit}`;
  }
}

/** In both units if the object has a relief. */
function depthErrorText(
  report: ReportData,
  reading: Reading,
  frame: FrameData | null,
  at: number,
  value: number,
): string {
  const id = frame?.get("id")?.at(at);
  const relief = report.objects.find((object) => object.id === id)?.relief_depth ?? NaN;
  const world = reading.unit === "world units" ? value : value * relief;
  const inWorld = `${significant(world, 6)} world units`;
  return relief > 0 ? `${inWorld} · ${significant(world / relief, 6)} relief depths` : inWorld;
}
