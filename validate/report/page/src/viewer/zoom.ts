// The common zoom and pan of all panes, by d3-zoom: wheel, drag, pinch, double click.
import { select } from "d3-selection";
import { zoom, zoomIdentity, type D3ZoomEvent, type ZoomTransform } from "d3-zoom";

/** A point or pixel of the frame, from its left and top edge. */
export interface Pixel {
  x: number;
  y: number;
}

/**
 * scale: 1 shows the whole frame. x, y: the point of the frame at the center of the pane, in pixels from the
 * left and top edge of the frame. /
 */
export interface Camera {
  scale: number;
  x: number;
  y: number;
}

/**
 * The position of a frame in a pane: `scale` CSS pixels per frame pixel, and its left and top edge in CSS
 * pixels from those of the pane. /
 */
export interface Placement {
  scale: number;
  left: number;
  top: number;
}

interface Size {
  width: number;
  height: number;
}

/** CSS pixels per frame pixel at the maximum zoom. */
const kClosestPx = 96;
/** Decimals of the camera in the address and in the attributes of panes. */
const kDecimals = 4;

const round = (value: number) => Number(value.toFixed(kDecimals));

export class SharedZoom {
  private camera: Camera;
  private readonly sizes = new Map<HTMLElement, Size>();
  private readonly behavior = zoom<HTMLElement, unknown>();
  private readonly resizes = new ResizeObserver((entries) => {
    for (const entry of entries) this.resize(entry.target as HTMLElement, entry.contentRect);
    this.set(this.camera); // the maximum zoom depends on the size of the panes
  });

  constructor(
    private readonly frame: Size,
    private readonly onChange: () => void,
    reducedMotion: boolean,
  ) {
    this.camera = this.fitting();
    const shared = this;
    const constrain = this.behavior.constrain();
    // The frame stays visible.
    this.behavior
      .constrain((transform, extent) => constrain(transform, extent, extent))
      .duration(reducedMotion ? 0 : 200)
      .on("zoom", function (this: HTMLElement, event: D3ZoomEvent<HTMLElement, unknown>) {
        shared.follow(this, event.transform);
      });
  }

  attach(view: HTMLElement): void {
    select(view).call(this.behavior);
    this.resizes.observe(view);
  }

  get(): Camera {
    return this.camera;
  }

  set(camera: Camera): void {
    this.camera = this.clamped(camera);
    for (const view of this.sizes.keys()) this.tellBehavior(view);
    this.onChange();
  }

  fit(): void {
    this.set(this.fitting());
  }

  /** Zooms by the factor about a point of the frame, which stays in place. */
  zoomBy(factor: number, about: { x: number; y: number }): void {
    const scale = Math.min(Math.max(this.camera.scale * factor, 1), this.closest());
    const stays = this.camera.scale / scale;
    this.set({
      scale,
      x: about.x + (this.camera.x - about.x) * stays,
      y: about.y + (this.camera.y - about.y) * stays,
    });
  }

  placement(view: HTMLElement): Placement {
    const { width, height } = this.size(view);
    const scale = this.fitScale(view) * this.camera.scale;
    return { scale, left: width / 2 - this.camera.x * scale, top: height / 2 - this.camera.y * scale };
  }

  isInSight(view: HTMLElement, pixel: Pixel): boolean {
    const { width, height } = this.size(view);
    const { scale, left, top } = this.placement(view);
    const [x, y] = [left + (pixel.x + 0.5) * scale, top + (pixel.y + 0.5) * scale];
    return x >= 0 && y >= 0 && x <= width && y <= height;
  }

  size(view: HTMLElement): Size {
    return this.sizes.get(view) ?? { width: 0, height: 0 };
  }

  private clamped(camera: Camera): Camera {
    const clamp = (value: number, low: number, high: number) => Math.min(Math.max(value, low), high);
    return {
      scale: round(clamp(camera.scale, 1, this.closest())),
      x: round(clamp(camera.x, 0, this.frame.width)),
      y: round(clamp(camera.y, 0, this.frame.height)),
    };
  }

  private fitting(): Camera {
    return { scale: 1, x: this.frame.width / 2, y: this.frame.height / 2 };
  }

  private fitScale(view: HTMLElement): number {
    const { width, height } = this.size(view);
    return Math.min(width / this.frame.width, height / this.frame.height);
  }

  private closest(): number {
    const scales = [...this.sizes.keys()].map((view) => this.fitScale(view)).filter((scale) => scale > 0);
    return scales.length > 0 ? Math.max(kClosestPx / Math.min(...scales), 8) : Infinity;
  }

  private resize(view: HTMLElement, { width, height }: Size): void {
    if (width > 0 && height > 0) this.sizes.set(view, { width, height });
    else this.sizes.delete(view); // not shown
    this.behavior.scaleExtent([1, this.closest()]);
  }

  /** d3's transform is relative to the frame fitted to the pane. */
  private tellBehavior(view: HTMLElement): void {
    const { width, height } = this.size(view);
    const { scale, x, y } = this.camera;
    const fit = this.fitScale(view);
    const left = (width - fit * this.frame.width) / 2;
    const top = (height - fit * this.frame.height) / 2;
    const transform = zoomIdentity
      .translate(width / 2 - scale * (left + fit * x), height / 2 - scale * (top + fit * y))
      .scale(scale);
    select(view).property("__zoom", transform);
  }

  private follow(view: HTMLElement, transform: ZoomTransform): void {
    const { width, height } = this.size(view);
    const fit = this.fitScale(view);
    const [x, y] = transform.invert([width / 2, height / 2]);
    this.camera = {
      scale: round(transform.k),
      x: round((x - (width - fit * this.frame.width) / 2) / fit),
      y: round((y - (height - fit * this.frame.height) / 2) / fit),
    };
    for (const other of this.sizes.keys()) if (other !== view) this.tellBehavior(other);
    this.onChange();
  }
}
