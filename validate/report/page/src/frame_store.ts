// Loads and unpacks the planes of frames on demand. A page opened from disk may load scripts but not read
// files, so planes are base64 in a script that calls plumblineFrame() or, if the report is a single file, in
// an element of the page. validate/report/frame_data.cpp writes them.
import type { FrameEntry, LayerName, ReportData } from "./data";
import { frameById, frameLabel } from "./frames";
import { unpackLayer, type Layer, type StoredLayer } from "./layer_unpacking";

type StoredFrame = { [layer: string]: StoredLayer };

/** The layers of a frame that have been unpacked. */
export class FrameData {
  readonly layers = new Map<LayerName, Layer>();
  constructor(readonly label: string) {}
  get(name: LayerName): Layer | undefined {
    return this.layers.get(name);
  }
}

const waiting = new Map<string, (frame: StoredFrame) => void>();
declare global {
  interface Window {
    plumblineFrame(file: string, frame: StoredFrame): void;
  }
}
window.plumblineFrame = (file, frame) => {
  waiting.get(file)?.(frame);
  waiting.delete(file);
};

interface LoadedFrame {
  data: FrameData;
  /** Without the layers that have been unpacked. */
  stored: StoredFrame;
  unpacked: Map<LayerName, Promise<void>>;
}

/** Maximum number of frames kept unpacked; frames shown in panes are kept in any case. */
const kMostKept = 8;

/**
 * Caches frames by id. While a frame is cached it is loaded only once, and each layer is unpacked only once,
 * when it is first used. /
 */
export class FrameStore {
  /** Ordered by last use. */
  private readonly loaded = new Map<string, Promise<LoadedFrame>>();
  private readonly loading = new Set<string>();

  constructor(private readonly report: ReportData) {}

  /**
   * The frame with (at least) those of the given layers that exist. Rejects with a sentence if its file is
   * missing or damaged. /
   */
  async load(id: string, layers: readonly LayerName[]): Promise<FrameData> {
    const entry = frameById(this.report, id);
    if (!entry) throw new Error(`there is no frame '${id}'`);
    const frame = await this.loadOnce(entry);
    await Promise.all(
      layers.filter((layer) => entry.layers.includes(layer)).map((layer) => this.unpackOnce(frame, layer)),
    );
    return frame.data;
  }

  /** Removes the least recently used frames, except those with the given ids. */
  forgetOthers(inUse: ReadonlySet<string>): void {
    for (const id of [...this.loaded.keys()]) {
      if (this.loaded.size <= kMostKept) return;
      if (!inUse.has(id) && !this.loading.has(id)) this.loaded.delete(id);
    }
  }

  private loadOnce(entry: FrameEntry): Promise<LoadedFrame> {
    const { id } = entry;
    let frame = this.loaded.get(id);
    if (!frame) {
      this.loading.add(id);
      frame = loadStored(entry.file)
        .then((stored) => ({ data: new FrameData(frameLabel(entry)), stored, unpacked: new Map() }))
        .finally(() => this.loading.delete(id));
      frame.catch(() => this.loaded.delete(id));
    }
    this.loaded.delete(id);
    this.loaded.set(id, frame);
    return frame;
  }

  private unpackOnce({ data, stored, unpacked }: LoadedFrame, layer: LayerName): Promise<void> {
    let unpacking = unpacked.get(layer);
    if (!unpacking) {
      const pixels = this.report.width * this.report.height;
      unpacking = unpackLayer(stored[layer], pixels, `${data.label}, ${layer}`).then((values) => {
        data.layers.set(layer, values);
        delete stored[layer];
      });
      unpacked.set(layer, unpacking);
    }
    return unpacking;
  }
}

function loadStored(file: string): Promise<StoredFrame> {
  const embedded = document.querySelector(`script[type="application/json"][data-file="${CSS.escape(file)}"]`);
  if (embedded) return Promise.resolve(JSON.parse(embedded.textContent ?? "") as StoredFrame);
  return new Promise((resolve, reject) => {
    waiting.set(file, resolve);
    const script = document.createElement("script");
    script.src = file.split("/").map(encodeURIComponent).join("/");
    script.onerror = () => reject(new Error(`${file} is missing in the folder of the page`));
    script.onload = () => {
      script.remove();
      if (waiting.delete(file)) reject(new Error(`${file} doesn't contain the frame of that name`));
    };
    document.head.append(script);
  });
}
