// One pane: a menu of frames and of layers, the picture under the shared zoom with its crosshair, and a legend.
import type { FrameData, FrameStore, ReportData } from "../data";
import { make, setOptions, setText } from "./dom";
import { frameLabel, layersOf, reasonAgainst, referenceOf } from "./layers";
import { Legend } from "./legend";
import { paintLayer, type Range } from "./paint";
import { readLayer, type DepthUnit, type Reading } from "./readings";
import { possiblePane, type PaneChoice } from "./settings";
import type { SharedZoom } from "./zoom";

/** Called with what a person chose in the pane. */
export interface PaneEvents {
  choose(choice: PaneChoice): void;
  setRange(layer: Reading["layer"], range: Range | undefined): void;
}

/** CSS pixels of the crosshair's box at the least. */
const kBoxPx = 11;

export class Pane {
  readonly element: HTMLElement;
  /** What zooms and listens to pointers and keys. */
  readonly view: HTMLElement;
  readonly canvas = make("canvas");
  /** What is shown, once it is loaded; the one before while it isn't. */
  reading: Reading | null = null;
  frame: FrameData | null = null;
  private choice: PaneChoice = { frame: "", layer: "color" };
  private unit: DepthUnit = "world";
  private paintedWith = "";
  private readonly source = document.createElement("canvas");
  private readonly name = make("span", { class: "pane-name" });
  private readonly frameMenu: HTMLSelectElement;
  private readonly layerMenu: HTMLSelectElement;
  private readonly status = make("p", { class: "pane-status" });
  private readonly crosshair = make("div", { class: "crosshair", hidden: true }, make("i"), make("i"), make("i"), make("i"));
  private readonly legend: Legend;

  constructor(
    private readonly report: ReportData,
    private readonly store: FrameStore,
    index: number,
    private readonly events: PaneEvents,
  ) {
    this.frameMenu = make("select", { "aria-label": `Pane ${index + 1}: frame`, change: () => this.chosen() });
    this.layerMenu = make("select", { "aria-label": `Pane ${index + 1}: layer`, change: () => this.chosen() });
    this.view = make("div", { class: "pane-view", tabindex: 0, role: "application" }, this.canvas, this.crosshair, this.status);
    this.legend = new Legend(index, (range) => this.reading && events.setRange(this.reading.layer, range));
    this.element = make(
      "div",
      { class: "pane", role: "group" },
      make("div", { class: "pane-head" }, this.name, this.frameMenu, this.layerMenu),
      this.view,
      this.legend.element,
    );
    this.source.width = report.width;
    this.source.height = report.height;
    this.view.style.aspectRatio = `${report.width} / ${report.height}`;
  }

  /** Loads and reads what is to be shown; resolves when there is a reading or a text that says why not. */
  async show(choice: PaneChoice, unit: DepthUnit, name: string): Promise<void> {
    setText(this.name, name);
    const changed = choice.frame !== this.choice.frame || choice.layer !== this.choice.layer || unit !== this.unit;
    this.choice = choice;
    this.unit = unit;
    this.showChoice(name);
    if (!changed && this.element.dataset.state === "ready") return;
    this.setStatus("loading", "Loading…"); // the style sheet holds the text back for a moment: most have loaded by then
    const isCurrent = () => choice === this.choice && unit === this.unit;
    try {
      const [frame, reference] = await this.loadFrames(choice);
      if (!isCurrent()) return;
      this.reading = readLayer(this.report, choice.layer, frame, reference, unit);
      this.frame = frame;
      this.paintedWith = "";
      this.setStatus("ready", "");
    } catch (error) {
      if (!isCurrent()) return;
      this.reading = this.frame = null;
      this.setStatus("error", error instanceof Error ? error.message : String(error));
    }
  }

  private async loadFrames(choice: PaneChoice) {
    const layer = layersOf(this.report).find(({ key }) => key === choice.layer);
    const frame = this.store.load(choice.frame);
    // Layers of the frame alone don't wait for the reference, nor fail with it.
    const reference = layer?.ofReference.length ? this.store.load(referenceOf(this.report).name) : frame;
    return Promise.all([frame, reference]);
  }

  /** Only where the reading or the range isn't what was painted last. */
  paint(range: Range, usual: Range): void {
    const { reading } = this;
    if (!reading) {
      this.legend.clear();
      return;
    }
    const key = range.join(",");
    if (this.paintedWith === key) return;
    this.paintedWith = key;
    const painting = paintLayer(reading, range, this.report.width * this.report.height);
    const image = new ImageData(new Uint8ClampedArray(painting.pixels.buffer), this.report.width, this.report.height);
    this.source.getContext("2d")?.putImageData(image, 0, 0);
    this.legend.show(reading, range, usual, painting.counts);
  }

  draw(zoom: SharedZoom, cursor: { x: number; y: number } | null): void {
    const { scale, left, top } = zoom.placement(this.view);
    const { width, height } = zoom.size(this.view);
    if (width === 0) return;
    this.drawPicture(scale, left, top, width, height);
    this.drawCrosshair(cursor, scale, left, top);
    const camera = zoom.get();
    this.element.dataset.scale = String(camera.scale);
    this.element.dataset.x = String(camera.x);
    this.element.dataset.y = String(camera.y);
  }

  private drawPicture(scale: number, left: number, top: number, width: number, height: number): void {
    const density = window.devicePixelRatio;
    const [wide, high] = [Math.round(width * density), Math.round(height * density)];
    if (this.canvas.width !== wide || this.canvas.height !== high) {
      this.canvas.width = wide;
      this.canvas.height = high;
    }
    const context = this.canvas.getContext("2d");
    if (!context) return;
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.clearRect(0, 0, wide, high);
    if (!this.reading) return;
    // The part in sight, in whole pixels of the frame.
    const { width: columns, height: rows } = this.source;
    const x0 = Math.max(0, Math.floor(-left / scale));
    const y0 = Math.max(0, Math.floor(-top / scale));
    const x1 = Math.min(columns, Math.ceil((width - left) / scale));
    const y1 = Math.min(rows, Math.ceil((height - top) / scale));
    if (x1 <= x0 || y1 <= y0) return;
    const s = scale * density;
    context.imageSmoothingEnabled = s < 1; // shrunk, single pixels must not vanish; enlarged, they stay squares
    context.setTransform(s, 0, 0, s, left * density, top * density);
    context.drawImage(this.source, x0, y0, x1 - x0, y1 - y0, x0, y0, x1 - x0, y1 - y0);
  }

  private drawCrosshair(cursor: { x: number; y: number } | null, scale: number, left: number, top: number): void {
    this.crosshair.hidden = cursor === null;
    if (!cursor) return;
    const size = Math.max(scale, kBoxPx);
    const x = left + (cursor.x + 0.5) * scale - size / 2;
    const y = top + (cursor.y + 0.5) * scale - size / 2;
    this.crosshair.style.transform = `translate(${x}px, ${y}px)`;
    this.crosshair.style.width = this.crosshair.style.height = `${size}px`;
  }

  private chosen(): void {
    const wanted = { frame: this.frameMenu.value, layer: this.layerMenu.value as PaneChoice["layer"] };
    this.events.choose(possiblePane(this.report, wanted));
  }

  private showChoice(name: string): void {
    const { frame: frameName, layer } = this.choice;
    const frames = this.report.frames;
    setOptions(this.frameMenu, frames.map((frame) => ({ value: frame.name, label: frameLabel(frame) })), frameName);
    const entry = frames.find((frame) => frame.name === frameName);
    if (!entry) throw new Error(`there is no frame '${frameName}'`);
    const layers = layersOf(this.report);
    setOptions(
      this.layerMenu,
      layers.map((info) => ({ value: info.key, label: info.label, reason: reasonAgainst(this.report, info, entry) })),
      layer,
    );
    this.element.dataset.frame = frameName;
    this.element.dataset.layer = layer;
    const title = `${frameLabel(entry)}, ${layers.find(({ key }) => key === layer)?.label ?? layer}`;
    this.element.setAttribute("aria-label", `Pane ${name}`);
    this.view.setAttribute("aria-label", `Picture ${name}: ${title}. Arrow keys move the pixel that is read.`);
  }

  private setStatus(state: "loading" | "ready" | "error", text: string): void {
    this.element.dataset.state = state;
    setText(this.status, text);
    this.status.hidden = text === "";
  }
}
