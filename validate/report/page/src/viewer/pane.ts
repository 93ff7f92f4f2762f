// One pane: its head, the picture with the shared zoom and a crosshair, and a legend.
import type { ReportData } from "../data";
import type { FrameData, FrameStore } from "../frame_store";
import { referenceOf } from "../frames";
import { colorsOf, type Colors } from "./colors";
import { Crosshair } from "./crosshair";
import { make, setText } from "./dom";
import { layersOf } from "./layers";
import { Legend } from "./legend";
import { paintLayer } from "./paint";
import { PaneHead } from "./pane_head";
import type { Range } from "./ranges";
import type { DepthUnit, Reading } from "./reading";
import { readLayer } from "./readings";
import type { PaneChoice } from "./standard_panes";
import type { Pixel, Placement, SharedZoom } from "./zoom";

/** Choices made in the pane. */
export interface PaneEvents {
  choose(choice: PaneChoice): void;
  setRange(layer: Reading["layer"], range: Range | undefined): void;
}

/** Planes that the readout shows for any frame. */
const kReadPlanes = ["id", "depth"] as const;
export class Pane {
  readonly element: HTMLElement;
  /** The element that is zoomed and receives pointer and key events. */
  readonly view: HTMLElement;
  /** Contains the canvas and is as large as the view. A wipe clips it, a blend makes it translucent. */
  readonly picture: HTMLElement;
  private readonly canvas = make("canvas");
  /** The reading that is shown; while another loads, the previous one. */
  reading: Reading | null = null;
  frame: FrameData | null = null;
  private choice: PaneChoice = { frame: "", layer: "color" };
  private unit: DepthUnit = "world";
  private paintedWith = "";
  private readonly head: PaneHead;
  private readonly status = make("p", { class: "pane-status" });
  private readonly crosshair = new Crosshair();
  private readonly legend: Legend;
  private readonly colors: Colors;
  /** Ids of the frames used by `reading`. */
  private shownFrames: string[] = [];

  constructor(
    private readonly report: ReportData,
    private readonly store: FrameStore,
    index: number,
    events: PaneEvents,
  ) {
    this.head = new PaneHead(report, index, (choice) => events.choose(choice));
    this.picture = make("div", { class: "pane-picture" }, this.canvas);
    this.view = make(
      "div",
      { class: "pane-view", tabindex: 0, role: "application" },
      this.picture,
      this.crosshair.element,
      this.status,
    );
    this.colors = colorsOf(report);
    this.legend = new Legend(
      this.colors,
      index,
      (range) => this.reading && events.setRange(this.reading.layer, range),
    );
    this.element = make(
      "div",
      { class: "pane", role: "group" },
      this.head.element,
      this.view,
      this.legend.element,
    );
    this.canvas.width = report.width;
    this.canvas.height = report.height;
    this.view.style.aspectRatio = `${report.width} / ${report.height}`;
  }

  /**
   * Loads and reads the choice; resolves when there is a reading or a text with the reason why there is none.
   */
  async show(choice: PaneChoice, unit: DepthUnit, name: string): Promise<void> {
    const changed =
      choice.frame !== this.choice.frame || choice.layer !== this.choice.layer || unit !== this.unit;
    this.choice = choice;
    this.unit = unit;
    this.showChoice(name);
    if (!changed && this.element.dataset.state === "ready") return;
    // The style sheet shows it after a delay, in which most frames load.
    this.setStatus("loading", "Loading…");
    const isCurrent = () => choice === this.choice && unit === this.unit;
    try {
      const [frame, reference] = await this.loadFrames(choice);
      if (!isCurrent()) return;
      this.reading = readLayer(this.report, choice.layer, frame, reference, unit);
      this.frame = frame;
      this.shownFrames = this.framesFor(choice);
      this.paintedWith = "";
      this.setStatus("ready", "");
    } catch (error) {
      if (!isCurrent()) return;
      this.reading = this.frame = null;
      this.shownFrames = [];
      this.setStatus("error", error instanceof Error ? error.message : String(error));
    }
  }

  /** Ids of the frames that are shown or loading. */
  framesInUse(): string[] {
    return [...this.shownFrames, ...this.framesFor(this.choice)];
  }

  /** The frame, then the reference if the layer needs it. */
  private framesFor({ frame, layer }: PaneChoice): string[] {
    const info = layersOf(this.report).find(({ key }) => key === layer);
    const reference = info && info.ofReference.length > 0 ? referenceOf(this.report) : undefined;
    return reference ? [frame, reference.id] : [frame];
  }

  private async loadFrames(choice: PaneChoice): Promise<[FrameData, FrameData]> {
    const layer = layersOf(this.report).find(({ key }) => key === choice.layer);
    if (!layer) throw new Error(`there is no layer '${choice.layer}'`);
    const [frameId, referenceId] = this.framesFor(choice);
    const frame = this.store.load(frameId, [...layer.ofFrame, ...kReadPlanes]);
    // It doesn't wait for the reference and doesn't fail with it.
    if (referenceId === undefined) return [await frame, await frame];
    return Promise.all([
      frame,
      this.store.load(referenceId, [...layer.ofReference, ...(layer.uncertain ?? [])]),
    ]);
  }

  /** Paints only if the reading or the range has changed. */
  paint(range: Range, defaultRange: Range): void {
    const { reading } = this;
    if (!reading) {
      this.legend.clear();
      this.canvas.getContext("2d")?.clearRect(0, 0, this.canvas.width, this.canvas.height);
      this.paintedWith = "";
      return;
    }
    const key = range.join(",");
    if (this.paintedWith === key) return;
    this.paintedWith = key;
    const painting = paintLayer(this.colors, reading, range, this.report.width * this.report.height);
    const image = new ImageData(
      new Uint8ClampedArray(painting.pixels.buffer),
      this.report.width,
      this.report.height,
    );
    this.canvas.getContext("2d")?.putImageData(image, 0, 0);
    this.legend.show(reading, range, defaultRange, painting.counts);
  }

  draw(zoom: SharedZoom, cursor: Pixel | null): void {
    if (zoom.size(this.view).width === 0) return;
    const placement = zoom.placement(this.view);
    this.drawPicture(placement);
    this.crosshair.draw(cursor, placement);
    const camera = zoom.get();
    this.element.dataset.scale = String(camera.scale);
    this.element.dataset.x = String(camera.x);
    this.element.dataset.y = String(camera.y);
  }

  /**
   * The canvas contains the frame at its own resolution. Only the compositor transforms it, which keeps the
   * frame rate high without a GPU. /
   */
  private drawPicture({ scale, left, top }: Placement): void {
    this.canvas.style.transform = `translate(${left}px, ${top}px) scale(${scale})`;
    // When the frame is minified, single pixels must not disappear.
    this.canvas.style.imageRendering = scale * window.devicePixelRatio < 1 ? "auto" : "pixelated";
  }

  private showChoice(name: string): void {
    const title = this.head.show(name, this.choice);
    this.element.dataset.frame = this.choice.frame;
    this.element.dataset.layer = this.choice.layer;
    this.element.setAttribute("aria-label", `Pane ${name}`);
    const label = `Picture ${name}: ${title}. Arrow keys move the pixel that is read.`;
    this.view.setAttribute("aria-label", label);
  }

  private setStatus(state: "loading" | "ready" | "error", text: string): void {
    this.element.dataset.state = state;
    setText(this.status, text);
    this.status.hidden = text === "";
  }
}
