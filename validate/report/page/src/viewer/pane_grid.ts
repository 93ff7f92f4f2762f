// The grid of panes: which panes are visible and what they show, side by side or two on top of each other.
import type { ReportData } from "../data";
import type { FrameStore } from "../frame_store";
import { frameById, frameLabel } from "../frames";
import { make } from "./dom";
import { layersOf, type LayerKey } from "./layers";
import { Pane } from "./pane";
import { defaultRange, type Range } from "./ranges";
import type { ReadPane } from "./readout";
import { rangeKey, type Settings } from "./settings";
import { kMostPanes, type PaneChoice } from "./standard_panes";
import type { Pixel, SharedZoom } from "./zoom";

export interface PaneGridEvents {
  choose(pane: number, choice: PaneChoice): void;
  setRange(layer: LayerKey, range: Range | undefined): void;
  setWipe(wipe: number): void;
  /** The pixel under the pointer; null: none. */
  hover(pixel: Pixel | null): void;
  hold(pixel: Pixel | null): void;
  /** Panes have changed and draw() must be called. */
  painted(): void;
}

export class PaneGrid {
  readonly element = make("div", { class: "panes" });
  private readonly panes: Pane[];
  private readonly divider: HTMLInputElement;

  constructor(
    private readonly report: ReportData,
    private readonly store: FrameStore,
    private readonly zoom: SharedZoom,
    private settings: Settings,
    private readonly events: PaneGridEvents,
  ) {
    this.panes = Array.from({ length: kMostPanes }, (_, index) => this.makePane(index));
    this.divider = make("input", {
      type: "range",
      class: "divider",
      min: 0,
      max: 1,
      step: 0.001,
      "aria-label": "Divider between A on the left and B on the right",
      input: () => events.setWipe(this.divider.valueAsNumber),
    });
    this.element.append(...this.panes.map((pane) => pane.element), this.divider);
  }

  private makePane(index: number): Pane {
    const { events } = this;
    const pane = new Pane(this.report, this.store, index, {
      choose: (choice) => events.choose(index, choice),
      setRange: (layer, range) => events.setRange(layer, range),
    });
    this.zoom.attach(pane.view);
    pane.view.addEventListener("pointermove", (event) => {
      // Touch pans; a tap is a click.
      if (event.pointerType !== "touch") events.hover(this.pixelAt(pane, event));
    });
    pane.view.addEventListener("pointerleave", () => events.hover(null));
    pane.view.addEventListener("pointerdown", () => pane.view.focus({ preventScroll: true }));
    pane.view.addEventListener("click", (event) => events.hold(this.pixelAt(pane, event)));
    return pane;
  }

  /** null outside the frame. */
  private pixelAt(pane: Pane, event: MouseEvent): Pixel | null {
    const box = pane.view.getBoundingClientRect();
    const { scale, left, top } = this.zoom.placement(pane.view);
    const x = Math.floor((event.clientX - box.left - pane.view.clientLeft - left) / scale);
    const y = Math.floor((event.clientY - box.top - pane.view.clientTop - top) / scale);
    return x >= 0 && y >= 0 && x < this.report.width && y < this.report.height ? { x, y } : null;
  }

  /** All panes have the same zoom and size. */
  get firstView(): HTMLElement {
    return this.panes[0].view;
  }

  /** Whether the first pane shows a picture. */
  get hasPicture(): boolean {
    return this.panes[0].reading !== null;
  }

  /** Resolves when all frames are loaded. Each pane shows its frame as soon as it is loaded. */
  async show(settings: Settings): Promise<void> {
    this.settings = settings;
    this.arrange();
    const show = async (pane: Pane, index: number) => {
      // Read again, because another call may have changed them while the first pane was loading.
      const { panes, unit } = this.settings;
      await pane.show(panes[index], unit, this.paneName(index));
      this.store.forgetOthers(new Set(this.panes.flatMap((each) => each.framesInUse())));
      this.paint();
    };
    await show(this.panes[0], 0); // before the others, so that a picture appears early
    await Promise.all(this.shownPanes.slice(1).map((pane, i) => show(pane, i + 1)));
  }

  draw(cursor: Pixel | null): void {
    for (const pane of this.shownPanes) pane.draw(this.zoom, cursor);
  }

  readPanes(): ReadPane[] {
    return this.shownPanes.map((pane, index) => {
      const { frame, layer } = this.settings.panes[index];
      const entry = frameById(this.report, frame);
      const label = layersOf(this.report).find(({ key }) => key === layer)?.label ?? layer;
      const title = `${entry ? frameLabel(entry) : frame}, ${label}`;
      return { name: this.paneName(index), title, frame: pane.frame, reading: pane.reading };
    });
  }

  /** Whether two panes are on top of each other. */
  private get isStacked(): boolean {
    return this.settings.arrangement !== "side";
  }

  private get shownPanes(): Pane[] {
    return this.panes.slice(0, this.isStacked ? 2 : this.settings.paneCount);
  }

  private paneName(index: number): string {
    return this.isStacked ? "AB"[index] : String(index + 1);
  }

  private arrange(): void {
    const { arrangement, wipe, opacity, second, paneCount } = this.settings;
    this.element.dataset.view = arrangement;
    this.element.dataset.count = String(this.isStacked ? 1 : paneCount);
    this.panes.forEach((pane, index) => (pane.element.hidden = index >= this.shownPanes.length));
    this.panes[1].view.tabIndex = this.isStacked ? -1 : 0; // the first one handles the keys of both
    this.divider.hidden = arrangement !== "wipe";
    this.divider.value = String(wipe);
    this.divider.setAttribute("aria-valuetext", `${Math.round(100 * wipe)} % A`);
    this.element.style.setProperty("--wipe", String(wipe));
    const [first, top] = this.panes.map((pane) => pane.picture.style);
    first.visibility = arrangement === "flicker" && second ? "hidden" : "";
    top.visibility = arrangement === "flicker" && !second ? "hidden" : "";
    top.opacity = arrangement === "blend" ? String(opacity) : "";
    top.clipPath = arrangement === "wipe" ? `inset(0 0 0 ${100 * wipe}%)` : "";
  }

  private paint(): void {
    const readings = this.shownPanes.flatMap(({ reading }) => reading ?? []);
    for (const pane of this.shownPanes) {
      const { reading } = pane;
      const ofLayer = readings.filter(({ layer }) => layer === reading?.layer);
      const byDefault = reading ? defaultRange(this.report, ofLayer) : ([0, 1] as const);
      const chosen = reading && this.settings.ranges[rangeKey(reading.layer, this.settings.unit)];
      pane.paint(chosen ?? byDefault, byDefault);
    }
    this.events.painted();
  }
}
