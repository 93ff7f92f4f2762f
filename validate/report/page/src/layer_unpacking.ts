// Unpacks planes of numbers that validate/report/layer_packing.cpp packed: bytes of equal significance are
// stored together, the most significant first, each as the difference from the one before; zlib; base64.

/** One or three planes, packed. */
export interface StoredLayer {
  type: "u8" | "u16" | "f32";
  components: number;
  /** value = stored * scale; absent: 1. Only u8 and u16 have one. */
  scale?: number;
  /** If true, the largest value of u8 and u16 means "none" (NaN in the page). */
  has_none?: boolean;
  /** base64 of zlib of bytes. */
  data: string;
}

/** Planes of a layer, one component after another; each has width * height values, row 0 = top. */
export class Layer {
  constructor(
    private readonly stored: Uint8Array | Uint16Array | Float32Array,
    private readonly scale = 1,
    /** The stored value that means "none"; undefined if there is no such value. */
    private readonly none?: number,
  ) {}

  /** NaN for none. `index`: pixel + component * width * height. */
  at(index: number): number {
    const value = this.stored[index];
    return value === this.none ? NaN : value * this.scale;
  }
}

/** Rejects with a sentence that begins with `what` if data is missing or damaged. */
export async function unpackLayer(
  stored: StoredLayer | undefined,
  pixels: number,
  what: string,
): Promise<Layer> {
  if (!stored) throw new Error(`${what}: the plane is missing`);
  const { type, components, scale } = stored;
  const bytes = await inflate(stored.data, what);
  const size = { u8: 1, u16: 2, f32: 4 }[type];
  const count = pixels * components;
  if (bytes.length !== count * size)
    throw new Error(`${what}: ${bytes.length} bytes instead of ${count * size}`);
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
    bits[at] =
      (bytes[at] << 24) | (bytes[count + at] << 16) | (bytes[2 * count + at] << 8) | bytes[3 * count + at];
  return values;
}

function wordsOf(bytes: Uint8Array, count: number): Uint16Array {
  const words = new Uint16Array(count);
  for (let at = 0; at < count; ++at) words[at] = (bytes[at] << 8) | bytes[count + at];
  return words;
}
