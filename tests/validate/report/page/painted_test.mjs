// Compares every layer of the viewer with pixels painted by hand: picture, legend and readout, pixel by
// pixel.
import assert from "node:assert/strict";
import { test } from "node:test";
import { openReport, panesLoaded } from "./browser.mjs";
import { hex, kRgb, kWidth, painted, shownPixels } from "./painted_frames.mjs";
import { diverging, gray, palette, sequential } from "./painted_report.mjs";

const [kNear, kNearMiddle, kZero, kFarMiddle, kFar] = diverging;
const [kPale, kMedium, kDark] = sequential;
const [kLightest, kDarkest] = gray;

/** Sixteen times `otherwise`, except for the pixels listed by color. */
function picture(otherwise, ...exceptions) {
  const pixels = Array(16).fill(otherwise);
  for (const [color, ...at] of exceptions) for (const pixel of at) pixels[pixel] = color;
  return pixels;
}
const {
  nothing,
  agree,
  missing,
  extra,
  other,
  dark,
  invalid,
  unshared,
  uncertain_agrees,
  uncertain_differs,
} = palette;

/** Pixels outside every comparison: nothing in both frames, then those with different objects. */
const kUncompared = [
  [nothing, 0],
  [unshared, 2, 3, 4, 6],
];

const kLayers = [
  {
    what: "color",
    frame: "t1",
    layer: "color",
    pixels: kRgb.map((rgb) => hex(...rgb)),
    legend: [],
    read: { 0: "#0000ff · sRGB 0 0 255", 7: "#1523f8 · sRGB 21 35 248" },
  },
  {
    what: "color of the reference",
    frame: "r",
    layer: "color",
    pixels: kRgb.map(([r, g, b]) => hex(b, r, g)),
    legend: [],
    read: { 7: "#f81523 · sRGB 248 21 35" },
  },
  {
    what: "silhouette",
    frame: "t1",
    layer: "silhouette",
    pixels: picture(
      agree,
      [nothing, 0],
      [missing, 2],
      [extra, 3],
      [other, 4],
      [uncertain_agrees, 5, 7],
      [uncertain_differs, 6],
    ),
    legend: [
      "nothing in both 1",
      "agree 9",
      "missing 1",
      "extra 1",
      "another object 1",
      "agree, reference uncertain 2",
      "differ, reference uncertain 1",
    ],
    note: /^These counts cover all objects.* counts them as missing or extra .* another object as missing/,
    read: {
      0: "nothing in both",
      2: "missing",
      3: "extra",
      4: "another object",
      6: "differ, reference uncertain",
    },
  },
  {
    what: "depth error in world units", // full color at 0.5
    frame: "t1",
    layer: "depth_error",
    pixels: picture(
      kZero,
      ...kUncompared,
      [hex(160, 160, 255), 1], // a quarter of the range: halfway from white to the middle blue
      [kFar, 5],
      [kNear, 7],
      [kFarMiddle, 8],
      [hex(255, 224, 160), 9],
      [invalid, 10],
      [hex(255, 239, 207), 11], // an eighth
    ),
    legend: ["nothing there 1", "not the same object in both 4", "not a finite number 1"],
    ends: ["-0.5 too near", "0 world units", "+0.5 too far"],
    read: {
      1: "-0.125 world units · -0.5 relief depths",
      8: "0.25 world units · 0.5 relief depths",
      9: "0.125 world units",
      10: "not a finite number",
      4: "not the same object in both",
    },
  },
  {
    what: "depth error in relief depths", // full color at 0.5 world units, relative to the deepest relief
    frame: "t1",
    layer: "depth_error",
    unit: "relief",
    pixels: picture(
      kZero,
      ...kUncompared,
      [kNearMiddle, 1], // -0.125 / 0.25
      [kFar, 5],
      [kNear, 7],
      [kFarMiddle, 8], // 0.25 / 0.5
      [dark, 9],
      [invalid, 10],
      [hex(255, 224, 160), 11], // 0.0625 / 0.25
    ),
    legend: ["nothing there 1", "not the same object in both 4", "not a finite number 1", "no relief 1"],
    ends: ["-1 too near", "0 relief depths", "+1 too far"],
    read: {
      1: "-0.125 world units · -0.5 relief depths",
      9: "no relief",
      11: "0.0625 world units · 0.25 relief depths",
    },
  },
  {
    what: "shadow",
    frame: "t1",
    layer: "shadow.sun",
    pixels: picture(
      agree,
      ...kUncompared,
      [dark, 8],
      [missing, 9, 15],
      [extra, 10, 14],
      [invalid, 11],
      [uncertain_agrees, 5, 12],
      [uncertain_differs, 7, 13],
    ),
    legend: [
      "nothing there 1",
      "not the same object in both 4",
      "not a finite number 1",
      "lit in both 1",
      "dark in both 1",
      "false light 2",
      "false shadow 2",
      "agree, reference uncertain 2",
      "differ, reference uncertain 2",
    ],
    note: /^These counts cover all objects.* counts them as right or wrong/,
    read: {
      1: "lit in both",
      8: "dark in both",
      9: "false light",
      14: "false shadow",
      7: "differ, reference uncertain",
    },
  },
  {
    what: "normal angle", // the 99th percentile of ten angles is 45
    frame: "t1",
    layer: "normal_angle",
    pixels: picture(kMedium, ...kUncompared, [kPale, 1, 11], [kDark, 8, 9], [invalid, 10]),
    legend: ["nothing there 1", "not the same object in both 4", "no normal 1"],
    ends: ["0", "22.5 degrees", "45"],
    read: { 1: "0.00°", 5: "22.50°", 9: "90.00°", 10: "no normal", 2: "not the same object in both" },
  },
  {
    what: "lookups",
    frame: "t1",
    layer: "fetches",
    pixels: picture(kDark, [nothing, 0, 2, 6], [kPale, 1], [kMedium, 3], [invalid, 9]),
    legend: ["nothing there 3", "not a finite number 1"],
    ends: ["0", "10 lookups", "20"],
    read: { 3: "10 lookups", 8: "40 lookups", 6: "nothing there" },
  },
  {
    what: "iterations",
    frame: "t1",
    layer: "iterations",
    pixels: picture(kDark, [nothing, 0, 2, 6], [kPale, 1], [kMedium, 3]),
    legend: ["nothing there 3"],
    ends: ["0", "300 iterations", "600"],
    read: { 3: "300 iterations", 8: "600 iterations" },
  },
  {
    what: "depth of the reference", // near is light
    frame: "r",
    layer: "depth",
    pixels: picture(kLightest, [nothing, 0, 3], [kDarkest, 2], ["#909090", 4]),
    legend: ["nothing there 2"],
    ends: ["2", "3 world units", "4"],
    read: { 2: "4 world units", 8: "2 world units" },
  },
  {
    what: "share of failing techniques",
    frame: "s",
    layer: "failing",
    pixels: picture(nothing, [hex(165, 165, 117), 1], [hex(96, 96, 43), 2], [kDark, 3]), // 1/3, 2/3, all
    legend: ["none fails 13"],
    ends: ["0", "1.5 of 3 techniques", "3"],
    read: { 0: "none fails", 2: "fails in 2 of 3 techniques" },
  },
];

async function readAt(page, pixel) {
  const [x, y] = [pixel % kWidth, Math.floor(pixel / kWidth)];
  await page.evaluate((text) => {
    const state = new URLSearchParams(location.hash.slice(1));
    state.set("pixel", text);
    location.hash = state.toString();
  }, `${x},${y}`);
  await page.waitForFunction(
    (text) => document.querySelector(".readout caption").textContent.startsWith(text),
    `Pixel ${x} from the left, ${y} from the top`,
  );
  return page.locator(".readout tbody tr").first().locator("td").last().innerText();
}

for (const { what, frame, layer, unit, pixels, legend, note, ends, read } of kLayers)
  test(`${what}: picture, legend and read-out`, async (t) => {
    const { page, account } = await openReport(t, painted(t), {
      hash: `#n=1&f1=${frame}&l1=${layer}${unit ? `&unit=${unit}` : ""}`,
    });
    await panesLoaded(page);
    assert.equal(await page.locator(".pane").first().getAttribute("data-layer"), layer);
    assert.deepEqual(await shownPixels(page), pixels);
    const pane = page.locator(".pane").first();
    assert.deepEqual(await pane.locator(".categories li").allInnerTexts(), legend);
    if (note) assert.match(await pane.locator(".legend-note").innerText(), note);
    assert.deepEqual(await pane.locator(".bar-ends span").allInnerTexts(), ends ?? []);
    for (const [pixel, text] of Object.entries(read))
      assert.equal(await readAt(page, Number(pixel)), text, `pixel ${pixel}`);
    assert.deepEqual(account.errors, []);
  });
