// Writes a report of a few hand-painted pixels in the format of the page.
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { deflateSync } from "node:zlib";
import { reportFile } from "./browser.mjs";

const kSizes = { u8: 1, u16: 2, f32: 4 };

/**
 * Bytes of equal significance stored together, the most significant first, each as the difference from the
 * one before; zlib; base64. /
 */
function packed(type, values) {
  const size = kSizes[type];
  const bytes = Buffer.alloc(size * values.length);
  values.forEach((value, index) => {
    const one = Buffer.alloc(size);
    if (type === "f32") one.writeFloatBE(value);
    else one.writeUIntBE(value, 0, size);
    one.forEach((byte, weight) => (bytes[weight * values.length + index] = byte));
  });
  for (let at = bytes.length - 1; at > 0; --at) bytes[at] -= bytes[at - 1]; // modulo 256
  return deflateSync(bytes).toString("base64");
}

export const bytes = (values, more = {}) => ({
  type: "u8",
  components: 1,
  data: packed("u8", values),
  ...more,
});
export const words = (values, more = {}) => ({
  type: "u16",
  components: 1,
  data: packed("u16", values),
  ...more,
});
export const floats = (values) => ({ type: "f32", components: 1, data: packed("f32", values) });
/** Packs colors [r, g, b]. */
export const colors = (pixels) => ({
  type: "u8",
  components: 3,
  data: packed(
    "u8",
    [0, 1, 2].flatMap((c) => pixels.map((rgb) => rgb[c])),
  ),
});

export const palette = {
  nothing: "#010203",
  agree: "#111213",
  missing: "#212223",
  extra: "#313233",
  other: "#414243",
  dark: "#515253",
  invalid: "#616263",
  unshared: "#717273",
  uncertain_agrees: "#818283",
  uncertain_differs: "#919293",
};
/** Blue for too near, white, orange for too far; all differ from the program's colors. */
export const diverging = ["#000080", "#4040ff", "#ffffff", "#ffc040", "#804000"];
export const sequential = ["#f0f0e0", "#808040", "#202000"];
export const gray = ["#e0e0e0", "#404040"];
const maps = {
  diverging: { low: -1, stops: diverging },
  sequential: { low: 0, stops: sequential },
  gray: { low: 0, stops: gray },
};

/** `frames`: entries with their `stored` layers. Removed after the test `t`. */
export function writeReport(t, { width, height, frames, objects = [], techniques = [], change = () => {} }) {
  const folder = mkdtempSync(join(tmpdir(), "plumbline-report-"));
  t.after(() => rmSync(folder, { recursive: true }));
  mkdirSync(join(folder, "data"));
  const data = {
    schema: 1,
    width,
    height,
    results: {
      schema: 1,
      program: "test",
      base: null,
      scene: { name: "painted", purpose: "", hash: "", width, height },
      techniques,
    },
    metrics: [],
    frames: frames.map(({ stored, ...entry }) => ({
      file: `data/${entry.id}.js`,
      layers: Object.keys(stored),
      ...entry,
    })),
    objects,
    depth_range: { world: 0.5, note: "of the test" },
    failing: { of: 3, meaning: "of the test" },
    curves: { thresholds: [0.01, 0.1], named: [0.01], edges: [-0.1, 0, 0.1] },
    colors: { palette, maps },
    shadow_threshold: 0.5,
  };
  change(data);
  for (const { id, stored } of frames)
    writeFileSync(
      join(folder, `data/${id}.js`),
      `plumblineFrame(${JSON.stringify(`data/${id}.js`)},${JSON.stringify(stored)});\n`,
    );
  const built = reportFile("torus"); // for its script and style
  writeFileSync(join(folder, "report.js"), readFileSync(join(built, "../report.js")));
  const [style] = readFileSync(built, "utf8").match(/<style>[^]*?<\/style>/);
  writeFileSync(
    join(folder, "index.html"),
    `<!DOCTYPE html><html lang="en"><head><meta charset="utf-8"><title>painted</title><script src="report.js" defer></script>${style}</head>
<body><main><section id="techniques"><div class="wide"><table><thead><tr><th data-key="name">technique</th><th data-key="silhouette.iou" data-better="high">IoU</th></tr></thead>
<tbody>${techniques
      .map(
        ({ name, silhouette }) =>
          `<tr data-technique="${name}"><th>${name}</th><td data-value="${silhouette.iou}">${silhouette.iou}</td></tr>`,
      )
      .join(
        "\n",
      )}</tbody></table></div></section><section id="viewer" aria-label="Pictures"></section><section id="plots"></section></main>
<script type="application/json" id="report-data">${JSON.stringify(data).replaceAll("<", "\\u003c")}</script></body></html>\n`,
  );
  return join(folder, "index.html");
}
