// Frames and their differences in panes with one zoom: side by side, or two of them in one place (wipe, flicker, blend).
import "../viewer.css";
import type { ReportData } from "../data";
import type { FrameStore } from "../frame_store";
import { frameById, frameLabel, referenceOf, techniqueFrames } from "../frames";
import { onStateChange } from "../state";
import { make, setText } from "./dom";
import { listenToKeys, makeKeyHelp } from "./keys";
import { layersOf } from "./layers";
import { Pane } from "./pane";
import { usualRange, type Range } from "./paint";
import type { Reading } from "./readings";
import { Readout, type ReadPane } from "./readout";
import {
  kMostPanes,
  isViewerKey,
  possiblePane,
  rangeKey,
  readSettings,
  standardPanes,
  writeSettings,
  type Settings,
} from "./settings";
import { Toolbar } from "./toolbar";
import { SharedZoom } from "./zoom";

interface Pixel {
  x: number;
  y: number;
}

/** Says so where there is nothing to view. */
export function startViewer(report: ReportData, store: FrameStore, root: HTMLElement): void {
  root.append(make("h2", {}, "Frames"));
  root.classList.add("viewer");
  if (!referenceOf(report)) {
    root.append(make("p", {}, "There are no frames to view."));
    return;
  }
  if (techniqueFrames(report).length === 0) root.append(make("p", {}, "No technique drew a frame: there is the reference alone."));
  new Viewer(report, store, root);
}

class Viewer {
  private settings: Settings;
  private readonly panes: Pane[];
  private readonly grid = make("div", { class: "panes" });
  private readonly divider: HTMLInputElement;
  private readonly toolbar: Toolbar;
  private readonly readout: Readout;
  private readonly note = make("p", { class: "viewer-note", role: "status" });
  private readonly zoom: SharedZoom;
  /** Under the pointer; the held pixel is read where there is none. */
  private hovered: Pixel | null = null;
  private isDrawScheduled = false;
  private isWriting = false;

  constructor(
    private readonly report: ReportData,
    private readonly store: FrameStore,
    root: HTMLElement,
  ) {
    this.settings = this.readState();
    const reducedMotion = matchMedia("(prefers-reduced-motion: reduce)").matches;
    this.zoom = new SharedZoom(report, () => this.cameraMoved(), reducedMotion);
    this.toolbar = new Toolbar(
      report,
      {
        chooseTechniques: (technique, against) => this.chooseTechniques(technique, against),
        standardPanes: () => this.showStandardPanes(),
        arrange: (arrangement, paneCount) => this.change({ arrangement, paneCount }),
        setUnit: (unit) => this.change({ unit }),
        setOpacity: (opacity) => this.change({ opacity }),
        swap: () => this.change({ second: !this.settings.second }),
        zoomBy: (factor) => this.zoomBy(factor),
        fit: () => this.zoom.fit(),
      },
      reducedMotion,
    );
    this.readout = new Readout(report);
    this.divider = make("input", {
      type: "range",
      class: "divider",
      min: 0,
      max: 1,
      step: 0.001,
      "aria-label": "Divider between A on the left and B on the right",
      input: () => this.change({ wipe: this.divider.valueAsNumber }),
    });
    this.panes = Array.from({ length: kMostPanes }, (_, index) => this.makePane(index));
    this.grid.append(...this.panes.map((pane) => pane.element), this.divider);
    root.append(this.toolbar.element, this.note, this.grid, this.readout.element, makeKeyHelp());
    listenToKeys(root, {
      arrange: (arrangement, paneCount) => this.change({ arrangement, paneCount: paneCount ?? this.settings.paneCount }),
      flicker: () => this.flicker(),
      zoomBy: (factor) => this.zoomBy(factor),
      fit: () => this.zoom.fit(),
      moveCursor: (dx, dy) => this.moveHeld(dx, dy),
      releaseCursor: () => this.change({ held: null }),
    });
    onStateChange((changed) => this.stateChanged(changed));
    this.zoom.set(this.settings.camera);
    void this.showAll();
  }

  private makePane(index: number): Pane {
    const pane = new Pane(this.report, this.store, index, {
      choose: (choice) => this.change({ panes: this.settings.panes.map((old, i) => (i === index ? choice : old)) }),
      setRange: (layer, range) => this.setRange(layer, range),
    });
    this.zoom.attach(pane.view);
    pane.view.addEventListener("pointermove", (event) => {
      if (event.pointerType !== "touch") this.hover(this.pixelAt(pane, event)); // a finger pans; its tap is a click
    });
    pane.view.addEventListener("pointerleave", () => this.hover(null));
    pane.view.addEventListener("pointerdown", () => pane.view.focus({ preventScroll: true }));
    pane.view.addEventListener("click", (event) => this.change({ held: this.pixelAt(pane, event) }));
    return pane;
  }

  private readState(): Settings {
    const { refused, ...settings } = readSettings(this.report);
    setText(this.note, refused.length > 0 ? `This report can't show what the address asks for: ${refused.join(", ")}` : "");
    return settings;
  }

  /** From outside: another module, or an address. */
  private stateChanged(changed: ReadonlySet<string>): void {
    const keys = [...changed].filter(isViewerKey);
    if (this.isWriting || keys.length === 0) return;
    const settings = this.readState();
    if (keys.length === 1 && keys[0] === "t") {
      this.chooseTechniques(settings.technique, this.settings.against);
      return;
    }
    this.settings = settings;
    this.zoom.set(settings.camera);
    void this.showAll();
  }

  /** Panes of the techniques so far take up the new ones with the layers they have. */
  private chooseTechniques(technique: string, chosenAgainst: string): void {
    const old = this.settings;
    const against = chosenAgainst === technique ? "" : chosenAgainst;
    const successors = new Map([[old.against, against], [old.technique, technique]]);
    const isSameKind = (against === "") === (old.against === "") && old.panes.some(({ frame }) => frame === old.technique);
    const panes = isSameKind
      ? old.panes.map(({ frame, layer }) => possiblePane(this.report, { frame: successors.get(frame) ?? frame, layer }))
      : standardPanes(this.report, technique, against);
    this.change({ technique, against, panes });
  }

  private showStandardPanes(): void {
    this.change({ panes: standardPanes(this.report, this.settings.technique, this.settings.against) });
  }

  private change(changes: Partial<Settings>): void {
    Object.assign(this.settings, changes);
    setText(this.note, "");
    const isPixelOnly = Object.keys(changes).every((key) => key === "held");
    if (isPixelOnly) this.scheduleDraw();
    else void this.showAll();
    this.writeState();
  }

  private setRange(layer: Reading["layer"], range: Range | undefined): void {
    const { [rangeKey(layer, this.settings.unit)]: _, ...others } = this.settings.ranges;
    this.change({ ranges: range ? { ...others, [rangeKey(layer, this.settings.unit)]: range } : others });
  }

  private flicker(): void {
    const isThere = this.settings.arrangement === "flicker";
    this.change({ arrangement: "flicker", second: isThere ? !this.settings.second : true });
  }

  private get isStacked(): boolean {
    return this.settings.arrangement !== "side";
  }
  private get shownPanes(): Pane[] {
    return this.panes.slice(0, this.isStacked ? 2 : this.settings.paneCount);
  }

  /** Brings everything up to the settings; what isn't loaded yet follows as it comes. */
  private async showAll(): Promise<void> {
    this.toolbar.show(this.settings);
    this.arrangePanes();
    const show = async (pane: Pane, index: number) => {
      const { panes, unit } = this.settings; // of now: they may have changed while the first was loading
      await pane.show(panes[index], unit, this.paneName(index));
      this.store.forgetOthers(new Set(this.panes.flatMap((each) => each.framesInUse())));
      this.paintAll();
    };
    await show(this.panes[0], 0); // alone, so that there is a picture soon
    await Promise.all(this.shownPanes.slice(1).map((pane, i) => show(pane, i + 1)));
  }

  private paneName(index: number): string {
    return this.isStacked ? "AB"[index] : String(index + 1);
  }

  private arrangePanes(): void {
    const { arrangement, wipe, opacity, second, paneCount } = this.settings;
    this.grid.dataset.view = arrangement;
    this.grid.dataset.count = String(this.isStacked ? 1 : paneCount);
    this.panes.forEach((pane, index) => (pane.element.hidden = index >= this.shownPanes.length));
    this.panes[1].view.tabIndex = this.isStacked ? -1 : 0; // the first hears for both
    this.divider.hidden = arrangement !== "wipe";
    this.divider.value = String(wipe);
    this.divider.setAttribute("aria-valuetext", `${Math.round(100 * wipe)} % A`);
    this.grid.style.setProperty("--wipe", String(wipe));
    const [first, top] = this.panes.map((pane) => pane.picture.style);
    first.visibility = arrangement === "flicker" && second ? "hidden" : "";
    top.visibility = arrangement === "flicker" && !second ? "hidden" : "";
    top.opacity = arrangement === "blend" ? String(opacity) : "";
    top.clipPath = arrangement === "wipe" ? `inset(0 0 0 ${100 * wipe}%)` : "";
  }

  private paintAll(): void {
    const readings = this.shownPanes.flatMap(({ reading }) => reading ?? []);
    for (const pane of this.shownPanes) {
      const { reading } = pane;
      const usual = reading ? usualRange(this.report, readings.filter(({ layer }) => layer === reading.layer)) : ([0, 1] as const);
      const chosen = reading && this.settings.ranges[rangeKey(reading.layer, this.settings.unit)];
      pane.paint(chosen ?? usual, usual);
    }
    this.scheduleDraw();
  }

  private hover(pixel: Pixel | null): void {
    this.hovered = pixel;
    this.scheduleDraw();
  }

  /** null beside the frame. */
  private pixelAt(pane: Pane, event: MouseEvent): Pixel | null {
    const box = pane.view.getBoundingClientRect();
    const { scale, left, top } = this.zoom.placement(pane.view);
    const x = Math.floor((event.clientX - box.left - pane.view.clientLeft - left) / scale);
    const y = Math.floor((event.clientY - box.top - pane.view.clientTop - top) / scale);
    return x >= 0 && y >= 0 && x < this.report.width && y < this.report.height ? { x, y } : null;
  }

  /** From where it is, or from the middle of the view; the view follows where it would leave. */
  private moveHeld(dx: number, dy: number): void {
    const { camera } = this.settings;
    const from = this.settings.held ?? { x: Math.floor(camera.x), y: Math.floor(camera.y) };
    const held = {
      x: Math.min(Math.max(from.x + dx, 0), this.report.width - 1),
      y: Math.min(Math.max(from.y + dy, 0), this.report.height - 1),
    };
    this.hovered = null;
    this.change({ held });
    if (!this.zoom.isInSight(this.panes[0].view, held)) this.zoom.set({ ...camera, x: held.x + 0.5, y: held.y + 0.5 });
    this.readout.speak(this.readPanes(), held);
  }

  /** About the pixel that is read while it is in sight. */
  private zoomBy(factor: number): void {
    const pixel = this.hovered ?? this.settings.held;
    const isAboutPixel = pixel && this.zoom.isInSight(this.panes[0].view, pixel);
    this.zoom.zoomBy(factor, isAboutPixel ? { x: pixel.x + 0.5, y: pixel.y + 0.5 } : this.settings.camera);
  }

  private cameraMoved(): void {
    const camera = this.zoom.get();
    const { scale, x, y } = this.settings.camera;
    this.scheduleDraw();
    if (camera.scale === scale && camera.x === x && camera.y === y) return; // only the panes' size changed
    this.settings.camera = camera;
    this.writeState();
  }

  private scheduleDraw(): void {
    if (this.isDrawScheduled) return;
    this.isDrawScheduled = true;
    requestAnimationFrame(() => {
      this.isDrawScheduled = false;
      this.draw();
    });
  }

  private draw(): void {
    const cursor = this.hovered ?? this.settings.held;
    for (const pane of this.shownPanes) pane.draw(this.zoom, cursor);
    this.toolbar.showZoom(this.zoom.placement(this.panes[0].view).scale);
    this.readout.show(this.readPanes(), cursor);
    const root = document.documentElement.dataset;
    if (this.panes[0].reading) root.firstPicture ??= String(Math.round(performance.now()));
  }

  private readPanes(): ReadPane[] {
    return this.shownPanes.map((pane, index) => {
      const { frame, layer } = this.settings.panes[index];
      const entry = frameById(this.report, frame);
      const words = layersOf(this.report).find(({ key }) => key === layer)?.label ?? layer;
      return { name: this.paneName(index), title: `${entry ? frameLabel(entry) : frame}, ${words}`, frame: pane.frame, reading: pane.reading };
    });
  }

  private writeState(): void {
    this.isWriting = true;
    writeSettings(this.report, this.settings);
    this.isWriting = false;
  }
}
