// The page's canvases and the program's PNG images have equal sRGB codes for the same frames.
import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import { dirname, join } from "node:path";
import { test } from "node:test";
import { schemeYlOrBr } from "d3-scale-chromatic";
import { openReport, panesLoaded, reportDataOf, reportFile, resultsOf } from "./browser.mjs";
import { shownPixels } from "./painted_frames.mjs";

const kReport = "exact"; // exact_plain holds the PNG pictures of its frames
const { colors, frames } = reportDataOf(kReport);
const { palette } = colors;
const [technique] = frames.filter(({ kind }) => kind === "technique");
const { iterations_p99: kMostIterations } = resultsOf(kReport).techniques[0].cost; // where the PNG's map ends

/** The PNG image whose name has this ending, decoded by the browser. */
async function pngPixels(page, ending) {
  const folder = dirname(reportFile("exact_plain"));
  const found = readdirSync(folder).filter((name) => name.endsWith(`_${ending}.png`));
  assert.equal(found.length, 1, `one picture *_${ending}.png in ${folder}`);
  const data = `data:image/png;base64,${readFileSync(join(folder, found[0])).toString("base64")}`;
  return page.evaluate(async (source) => {
    const image = new Image();
    image.src = source;
    await image.decode();
    const canvas = new OffscreenCanvas(image.naturalWidth, image.naturalHeight);
    canvas.getContext("2d").drawImage(image, 0, 0);
    const codes = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data;
    const two = (code) => code.toString(16).padStart(2, "0");
    return Array.from(
      { length: codes.length / 4 },
      (_, i) => `#${two(codes[4 * i])}${two(codes[4 * i + 1])}${two(codes[4 * i + 2])}`,
    );
  }, data);
}

/** Colors that the PNG may have where the page marks pixels because the reference is uncertain. */
const kMarked = {
  [palette.uncertain_agrees]: [palette.nothing, palette.agree, palette.dark],
  [palette.uncertain_differs]: [palette.missing, palette.extra, palette.other],
};

for (const { layer, ending, leastColors, minMarked = 0 } of [
  { layer: "color", ending: "color", leastColors: 50 },
  { layer: "silhouette", ending: "silhouette", leastColors: 3, minMarked: 1 },
  { layer: "depth_error", ending: "depth", leastColors: 50 },
  { layer: "shadow.sun", ending: "shadow_sun", leastColors: 4, minMarked: 10 },
  { layer: "iterations", ending: "iterations", leastColors: 10 },
])
  test(`${layer}: the canvas agrees with the PNG picture, code for code`, async (t) => {
    const range = layer === "iterations" ? `&range.iterations=0,${kMostIterations}` : "";
    const { page } = await openReport(t, reportFile(kReport), {
      hash: `#n=1&f1=${technique.id}&l1=${layer}${range}`,
    });
    await panesLoaded(page);
    const [canvas, png] = [await shownPixels(page), await pngPixels(page, ending)];
    const marked = canvas.filter((color) => kMarked[color]).length;
    assert.ok(new Set(canvas).size >= leastColors, `${new Set(canvas).size} colors`);
    assert.ok(marked >= minMarked && marked < 0.25 * canvas.length, `${marked} marked pixels`);
    const wrong = canvas.flatMap((color, at) =>
      (kMarked[color] ?? [color]).includes(png[at]) ? [] : [`${at}: ${color}, PNG ${png[at]}`],
    );
    assert.deepEqual(wrong, []);
    assert.equal(png.length, canvas.length);
  });

test("the sequential map is YlOrBr of d3-scale-chromatic", () => {
  assert.deepEqual(
    colors.maps.sequential.stops,
    schemeYlOrBr[9].map((stop) => stop.toLowerCase()),
  );
});
