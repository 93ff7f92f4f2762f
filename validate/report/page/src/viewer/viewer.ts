// The viewer shows frames and their differences in panes with a common zoom: side by side, or two on top of
// each other (wipe, flicker, blend). `settings` is what is shown; toolbar, panes and keys change it, and the
// address stores it.
import "../viewer.css";
import type { ReportData } from "../data";
import type { FrameStore } from "../frame_store";
import { referenceOf, techniqueFrames } from "../frames";
import { onStateChange } from "../state";
import { make, setText } from "./dom";
import { listenToKeys, makeKeyHelp } from "./keys";
import type { LayerKey } from "./layers";
import { PaneGrid } from "./pane_grid";
import type { Range } from "./ranges";
import { Readout } from "./readout";
import { isViewerKey, rangeKey, readSettings, writeSettings, type Settings } from "./settings";
import { panesOfOtherTechniques, standardPanes, type TechniqueChoice } from "./standard_panes";
import { Toolbar } from "./toolbar";
import { SharedZoom, type Pixel } from "./zoom";

/** Without frames, a sentence is shown instead. */
export function startViewer(report: ReportData, store: FrameStore, root: HTMLElement): void {
  root.append(make("h2", {}, "Frames"));
  root.classList.add("viewer");
  if (!referenceOf(report)) {
    root.append(make("p", {}, "There are no frames to view."));
    return;
  }
  if (techniqueFrames(report).length === 0)
    root.append(make("p", {}, "No technique drew a frame; only the reference can be viewed."));
  new Viewer(report, store, root);
}

class Viewer {
  private settings: Settings;
  private readonly grid: PaneGrid;
  private readonly toolbar: Toolbar;
  private readonly readout: Readout;
  private readonly note = make("p", { class: "viewer-note", role: "status" });
  private readonly zoom: SharedZoom;
  /** The pixel under the pointer; if there is none, the held pixel is read. */
  private hovered: Pixel | null = null;
  private isDrawScheduled = false;
  private isWriting = false;

  constructor(
    private readonly report: ReportData,
    store: FrameStore,
    root: HTMLElement,
  ) {
    this.settings = this.readState();
    const reducedMotion = matchMedia("(prefers-reduced-motion: reduce)").matches;
    this.zoom = new SharedZoom(report, () => this.cameraMoved(), reducedMotion);
    this.toolbar = this.makeToolbar(reducedMotion);
    this.readout = new Readout(report);
    this.grid = this.makeGrid(store);
    root.append(this.toolbar.element, this.note, this.grid.element, this.readout.element, makeKeyHelp());
    this.listenToKeys(root);
    onStateChange((changed) => this.stateChanged(changed));
    this.zoom.set(this.settings.camera);
    void this.showAll();
  }

  private makeToolbar(reducedMotion: boolean): Toolbar {
    const events = {
      chooseTechniques: (choice: TechniqueChoice) => this.chooseTechniques(choice),
      standardPanes: () => this.change({ panes: standardPanes(this.report, this.settings) }),
      arrange: (arrangement: Settings["arrangement"], paneCount: number) =>
        this.change({ arrangement, paneCount }),
      setUnit: (unit: Settings["unit"]) => this.change({ unit }),
      setOpacity: (opacity: number) => this.change({ opacity }),
      swap: () => this.change({ second: !this.settings.second }),
      zoomBy: (factor: number) => this.zoomBy(factor),
      fit: () => this.zoom.fit(),
    };
    return new Toolbar(this.report, events, reducedMotion);
  }

  private makeGrid(store: FrameStore): PaneGrid {
    return new PaneGrid(this.report, store, this.zoom, this.settings, {
      choose: (pane, choice) =>
        this.change({ panes: this.settings.panes.map((old, i) => (i === pane ? choice : old)) }),
      setRange: (layer, range) => this.setRange(layer, range),
      setWipe: (wipe) => this.change({ wipe }),
      hover: (pixel) => this.hover(pixel),
      hold: (held) => this.change({ held }),
      painted: () => this.scheduleDraw(),
    });
  }

  private listenToKeys(root: HTMLElement): void {
    listenToKeys(root, {
      arrange: (arrangement, paneCount) =>
        this.change({ arrangement, paneCount: paneCount ?? this.settings.paneCount }),
      flicker: () => this.flicker(),
      zoomBy: (factor) => this.zoomBy(factor),
      fit: () => this.zoom.fit(),
      moveCursor: (dx, dy) => this.moveHeld(dx, dy),
      releaseCursor: () => this.change({ held: null }),
    });
  }

  private readState(): Settings {
    const { refused, ...settings } = readSettings(this.report);
    setText(
      this.note,
      refused.length > 0 ? `This report can't show these settings of the address: ${refused.join(", ")}` : "",
    );
    return settings;
  }

  private writeState(): void {
    this.isWriting = true;
    writeSettings(this.report, this.settings);
    this.isWriting = false;
  }

  /** Changes made by another part of the page or by a new address. */
  private stateChanged(changed: ReadonlySet<string>): void {
    const keys = [...changed].filter(isViewerKey);
    if (this.isWriting || keys.length === 0) return;
    const settings = this.readState();
    if (keys.length === 1 && keys[0] === "t") {
      this.chooseTechniques({ technique: settings.technique, comparedWith: this.settings.comparedWith });
      return;
    }
    this.settings = settings;
    this.zoom.set(settings.camera);
    void this.showAll();
  }

  private chooseTechniques({ technique, comparedWith }: TechniqueChoice): void {
    const choice = { technique, comparedWith: comparedWith === technique ? "" : comparedWith };
    this.change({
      ...choice,
      panes: panesOfOtherTechniques(this.report, this.settings.panes, this.settings, choice),
    });
  }

  private change(changes: Partial<Settings>): void {
    Object.assign(this.settings, changes);
    setText(this.note, "");
    const isPixelOnly = Object.keys(changes).every((key) => key === "held");
    if (isPixelOnly) this.scheduleDraw();
    else void this.showAll();
    this.writeState();
  }

  private setRange(layer: LayerKey, range: Range | undefined): void {
    const { [rangeKey(layer, this.settings.unit)]: _, ...others } = this.settings.ranges;
    this.change({ ranges: range ? { ...others, [rangeKey(layer, this.settings.unit)]: range } : others });
  }

  private flicker(): void {
    const isThere = this.settings.arrangement === "flicker";
    this.change({ arrangement: "flicker", second: isThere ? !this.settings.second : true });
  }

  private showAll(): Promise<void> {
    this.toolbar.show(this.settings);
    return this.grid.show(this.settings);
  }

  private hover(pixel: Pixel | null): void {
    this.hovered = pixel;
    this.scheduleDraw();
  }

  /**
   * Moves the held pixel, or starts at the center of the view. The view follows a pixel that would leave
   * it.
   */
  private moveHeld(dx: number, dy: number): void {
    const { camera } = this.settings;
    const from = this.settings.held ?? { x: Math.floor(camera.x), y: Math.floor(camera.y) };
    const held = {
      x: Math.min(Math.max(from.x + dx, 0), this.report.width - 1),
      y: Math.min(Math.max(from.y + dy, 0), this.report.height - 1),
    };
    this.hovered = null;
    this.change({ held });
    if (!this.zoom.isInSight(this.grid.firstView, held))
      this.zoom.set({ ...camera, x: held.x + 0.5, y: held.y + 0.5 });
    this.readout.speak(this.grid.readPanes(), held);
  }

  /** Zooms about the pixel that is read, if it is visible. */
  private zoomBy(factor: number): void {
    const pixel = this.hovered ?? this.settings.held;
    const isAboutPixel = pixel && this.zoom.isInSight(this.grid.firstView, pixel);
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
    this.grid.draw(cursor);
    this.toolbar.showZoom(this.zoom.placement(this.grid.firstView).scale);
    this.readout.show(this.grid.readPanes(), cursor);
    const root = document.documentElement.dataset;
    if (this.grid.hasPicture) root.firstPicture ??= String(Math.round(performance.now()));
  }
}
