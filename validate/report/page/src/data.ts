// What the program hands to the page, and the way to it. The page is opened from disk, where scripts may load scripts but not read
// files: so a frame's planes come as base64 in a script that calls plumblineFrame(), or, in a report of a single file, in an element.
// validate/report/frame_data.cpp writes them.

/** results.json, as far as the page reads it; groups hold numbers, and `absent` the reasons of those that aren't there. */
export interface Results {
  schema: number;
  program: string;
  base: string | null;
  scene: { name: string; purpose: string; hash: string; width: number; height: number; changes?: string[] };
  techniques: TechniqueResult[];
}
export type Group = { [key: string]: unknown; absent?: { [key: string]: string } };
export interface TechniqueResult {
  name: string;
  parameters: { [key: string]: string };
  gl: { backend: string; renderer: string };
  error: string | null;
  /** Of what shows how much of an error isn't the technique's: it doesn't compete. */
  control?: boolean;
  silhouette?: Group;
  depth?: Group;
  shadow?: { [light: string]: Group };
  normal?: Group;
  st?: Group;
  image?: Group;
  cost?: Group;
}

/** A row of the program's table of metrics (`plumbline list metrics`). */
export interface MetricInfo {
  /** As "depth.rmse_relief"; of shadows as "shadow.agreement", one for each light in the results. */
  key: string;
  label: string;
  unit: string;
  meaning: string;
  /** Which end is better; "" where neither is. */
  better: "high" | "low" | "";
}

/** Planes a frame may have. */
export type LayerName =
  | "color" // sRGB codes, three planes: r, g, b
  | "id" // object shown, 0 for none
  | "depth" // planar camera depth, world units; NaN or infinite where nothing is seen
  | "normal_angle" // angle to the reference's normal; `scale` makes degrees of it
  | "fetches" // look-ups
  | "iterations" // rounds of the search
  | "uncertain" // 1: the reference can't tell what is seen (reference only)
  | "failing" // how many techniques fail at the pixel (of the summary only)
  | `shadow.${string}` // 1 in shadow of that light, 0 lit
  | `uncertain.shadow.${string}`; // 1: the reference can't tell lit from dark (reference only)

/** A frame the page can show. */
export interface FrameEntry {
  /** Unique; of a technique its name in the results. */
  name: string;
  kind: "reference" | "proxy" | "technique" | "summary";
  /** Beside the page; absent in a report of a single file. */
  file: string;
  layers: LayerName[];
  /** Share of the domain whose depth is off by more than curves.thresholds[i]; absent without depth or relief. */
  badpix?: number[];
  /** Pixels by signed depth error: counts[i] in edges[i] <= e < edges[i+1] of curves.edges; below and above are beyond the ends. */
  histogram?: { counts: number[]; below: number; above: number };
}

export interface ReportData {
  schema: 1;
  width: number;
  height: number;
  results: Results;
  metrics: MetricInfo[];
  /** The reference first. */
  frames: FrameEntry[];
  /** Objects by id - 1; their relief depth in world units, null where it isn't known or there is none. */
  objects: { id: number; name: string; relief_depth: number | null }[];
  /** Full colour of the signed depth error to begin with, world units, and how it came about. */
  depth_range: { world: number; note: string };
  /** Techniques counted in the layer "failing", and what counts as failing, in words. */
  failing: { of: number; meaning: string };
  /** In relief depths. */
  curves: { thresholds: number[]; edges: number[] };
}

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

/** Planes of a layer, row 0 = top, a component after another; width * height values each. */
export interface Layer {
  components: number;
  values: Float32Array;
}
/** A frame's layers as far as they are unpacked. */
export class FrameData {
  readonly layers = new Map<LayerName, Layer>();
  constructor(readonly name: string) {}
  get(name: LayerName): Layer | undefined {
    return this.layers.get(name);
  }
}

export function readReportData(): ReportData {
  const element = document.getElementById("report-data");
  if (!element) throw new Error("the page holds no data");
  return JSON.parse(element.textContent ?? "") as ReportData;
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
  stored: StoredFrame;
  unpacked: Map<LayerName, Promise<void>>;
}

/** Frames by name: each is loaded once, each of its layers unpacked once, when it is asked for. */
export class FrameStore {
  private readonly loaded = new Map<string, Promise<LoadedFrame>>();

  constructor(private readonly report: ReportData) {}

  /** The frame with at least those of these layers that it has. Rejects with a sentence for a person if its file is missing or damaged. */
  async load(name: string, layers: readonly LayerName[]): Promise<FrameData> {
    const entry = this.report.frames.find((frame) => frame.name === name);
    if (!entry) throw new Error(`there is no frame '${name}'`);
    let loading = this.loaded.get(name);
    if (!loading) {
      loading = loadStored(entry.file).then((stored) => ({ data: new FrameData(name), stored, unpacked: new Map() }));
      this.loaded.set(name, loading);
      loading.catch(() => this.loaded.delete(name));
    }
    const frame = await loading;
    await Promise.all(layers.filter((layer) => entry.layers.includes(layer)).map((layer) => this.unpackOnce(frame, layer)));
    return frame.data;
  }

  private unpackOnce({ data, stored, unpacked }: LoadedFrame, layer: LayerName): Promise<void> {
    let unpacking = unpacked.get(layer);
    if (!unpacking) {
      const pixels = this.report.width * this.report.height;
      unpacking = unpack(stored[layer], pixels, `${data.name}, ${layer}`).then((values) => void data.layers.set(layer, values));
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
  const { type, components, scale = 1 } = stored;
  const bytes = await inflate(stored.data, what);
  const size = { u8: 1, u16: 2, f32: 4 }[type];
  const count = pixels * components;
  if (bytes.length !== count * size) throw new Error(`${what}: ${bytes.length} bytes instead of ${count * size}`);
  undoDifferences(bytes);
  if (type === "f32") return { components, values: floatsOf(bytes, count) };
  const none = stored.has_none ? (size === 1 ? 255 : 65535) : -1;
  return { components, values: wholesOf(bytes, count, size, scale, none) };
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

function wholesOf(bytes: Uint8Array, count: number, size: number, scale: number, none: number): Float32Array {
  const values = new Float32Array(count);
  for (let at = 0; at < count; ++at) {
    const whole = size === 1 ? bytes[at] : (bytes[at] << 8) | bytes[count + at];
    values[at] = whole === none ? NaN : whole * scale;
  }
  return values;
}
