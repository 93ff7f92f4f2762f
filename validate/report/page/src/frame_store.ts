// A frame's planes, loaded and unpacked. The page is opened from disk, where scripts may load scripts but not read files: so planes come
// as base64 in a script that calls plumblineFrame(), or, in a report of a single file, in an element. validate/report/frame_data.cpp
// writes them.
import type { FrameEntry, LayerName, ReportData } from "./data";
import { frameById, frameLabel } from "./frames";

/** One plane or three as stored. */
interface StoredLayer {
  type: "u8" | "u16" | "f32";
  components: number;
  /** value = stored * scale; absent: 1. Only u8 and u16 have one. */
  scale?: number;
  /** The largest value of u8 and u16 stands for "none" (NaN in the page) if true. */
  has_none?: boolean;
  /** base64 of zlib of bytes. */
  data: string;
}
type StoredFrame = { [layer: string]: StoredLayer };

/** Planes of a layer as stored, row 0 = top, a component after another; width * height values each. */
export class Layer {
  constructor(
    private readonly stored: Uint8Array | Uint16Array | Float32Array,
    private readonly scale = 1,
    /** Stands for "none"; undefined where every value is one. */
    private readonly none?: number,
  ) {}

  /** NaN for none. `index`: pixel + component * width * height. */
  at(index: number): number {
    const value = this.stored[index];
    return value === this.none ? NaN : value * this.scale;
  }
}
/** A frame's layers as far as they are unpacked. */
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
  /** Without the layers that are unpacked. */
  stored: StoredFrame;
  unpacked: Map<LayerName, Promise<void>>;
}

/** Frames kept unpacked, those in sight included where there are so many. */
const kMostKept = 8;

/** Frames by id: each is loaded once while it is kept, each of its layers unpacked once, when it is asked for. */
export class FrameStore {
  /** Last used last. */
  private readonly loaded = new Map<string, Promise<LoadedFrame>>();
  private readonly loading = new Set<string>();

  constructor(private readonly report: ReportData) {}

  /** The frame with at least those of these layers that it has. Rejects with a sentence for a person if its file is missing or damaged. */
  async load(id: string, layers: readonly LayerName[]): Promise<FrameData> {
    const entry = frameById(this.report, id);
    if (!entry) throw new Error(`there is no frame '${id}'`);
    const frame = await this.loadOnce(entry);
    await Promise.all(layers.filter((layer) => entry.layers.includes(layer)).map((layer) => this.unpackOnce(frame, layer)));
    return frame.data;
  }

  /** Forgets the frames used longest ago, never those of these ids. */
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
      unpacking = unpack(stored[layer], pixels, `${data.label}, ${layer}`).then((values) => {
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
    script.onerror = () => reject(new Error(`${file} is missing beside the page`));
    script.onload = () => {
      script.remove();
      if (waiting.delete(file)) reject(new Error(`${file} doesn't hold the frame it should`));
    };
    document.head.append(script);
  });
}

/** Undoes the packing: base64, zlib, differences between neighbouring bytes, bytes of equal weight side by side (most significant first). */
async function unpack(stored: StoredLayer | undefined, pixels: number, what: string): Promise<Layer> {
  if (!stored) throw new Error(`${what}: the plane is missing`);
  const { type, components, scale } = stored;
  const bytes = await inflate(stored.data, what);
  const size = { u8: 1, u16: 2, f32: 4 }[type];
  const count = pixels * components;
  if (bytes.length !== count * size) throw new Error(`${what}: ${bytes.length} bytes instead of ${count * size}`);
  undoDifferences(bytes);
  if (type === "f32") return new Layer(floatsOf(bytes, count));
  if (type === "u16") return new Layer(wordsOf(bytes, count), scale, stored.has_none ? 65535 : undefined);
  return new Layer(bytes, scale, stored.has_none ? 255 : undefined);
}

async function inflate(base64: string, what: string): Promise<Uint8Array> {
  try {
    const letters = atob(base64);
    const packed = new Uint8Array(letters.length);
    for (let at = 0; at < packed.length; ++at) packed[at] = letters.charCodeAt(at);
    const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate"));
    return new Uint8Array(await new Response(stream).arrayBuffer());
  } catch (error) {
    throw new Error(`${what}: the data is damaged`, { cause: error });
  }
}

function undoDifferences(bytes: Uint8Array): void {
  let value = 0;
  for (let at = 0; at < bytes.length; ++at) {
    value = (value + bytes[at]) & 255;
    bytes[at] = value;
  }
}

function floatsOf(bytes: Uint8Array, count: number): Float32Array {
  const values = new Float32Array(count);
  const bits = new Uint32Array(values.buffer);
  for (let at = 0; at < count; ++at)
    bits[at] = (bytes[at] << 24) | (bytes[count + at] << 16) | (bytes[2 * count + at] << 8) | bytes[3 * count + at];
  return values;
}

function wordsOf(bytes: Uint8Array, count: number): Uint16Array {
  const words = new Uint16Array(count);
  for (let at = 0; at < count; ++at) words[at] = (bytes[at] << 8) | bytes[count + at];
  return words;
}
