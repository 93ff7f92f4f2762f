// A reference, a technique and the summary with sixteen pixels, painted by hand.
import { bytes, colors, floats, words, writeReport } from "./painted_report.mjs";

export const kWidth = 4;
export const kHeight = 4;
const kNone8 = 255;
const kNone16 = 65535;
// Pixels 0 nothing, 2 missing, 3 extra, 4 another object, 5 and 7 uncertain but equal (7: "none" in the
// plane), 6 uncertain and missing; all others equal.
const kReferenceIds = [0, 1, 1, 0, 1, 1, 1, 1, 3, 2, 1, 1, 1, 1, 1, 1];
const kIds = [0, 1, 0, 1, 2, 1, 0, 1, 3, 2, 1, 1, 1, 1, 1, 1];
const kUncertain = [0, 0, 0, 0, 0, 1, 1, kNone8, 0, 0, 0, 0, 0, 0, 0, 0];
// Errors, world units: 1 -0.125, 5 +0.5, 7 -0.5, 8 +0.25, 9 +0.125, 10 none, 11 +0.0625; all others 0.
const kReferenceDepth = [NaN, 2, 4, NaN, 3, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2];
const kDepth = [NaN, 1.875, NaN, 2, 2, 2.5, NaN, 1.5, 2.25, 2.125, NaN, 2.0625, 2, 2, 2, 2];
// 1 lit, 8 dark, 9 and 15 false light, 10 and 14 false shadow, 11 none; 5 and 12 agree, 7 and 13 differ: the
// object of 5 and 7 is uncertain, the shadow of 12 and 13; 14 and 15 are close to the threshold.
const kReferenceSun = [0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 0, 0, 1, 0, 0.25, 0.5];
const kSun = [0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 1, NaN, 1, 1, 0.5, 0.49];
const kUncertainSun = [0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 0, 0];
export const kRgb = Array.from({ length: 16 }, (_, i) => [3 * i, 5 * i, 255 - i]);
/**
 * In units of 1/256 degree: 1 and 11 0, 8 45, 9 90 degrees, 10 none, otherwise 22.5 if both show the same.
 */
const kAngles = [
  kNone16,
  0,
  kNone16,
  kNone16,
  kNone16,
  5760,
  kNone16,
  5760,
  11520,
  23040,
  kNone16,
  0,
  5760,
  5760,
  5760,
  5760,
];
const kFetches = [0, 0, 0, 10, 20, 20, 0, 20, 40, kNone8, 20, 20, 20, 20, 20, 20];
const kIterations = [0, 0, 0, 300, 600, 600, 0, 600, 600, 600, 600, 600, 600, 600, 600, 600];
const kFailing = [0, 1, 2, 3, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0];

export const kReference = {
  id: "r",
  name: "reference",
  kind: "reference",
  stored: {
    color: colors(kRgb.map(([r, g, b]) => [b, r, g])),
    id: bytes(kReferenceIds, { has_none: true }),
    depth: floats(kReferenceDepth),
    "shadow.sun": floats(kReferenceSun),
    uncertain: bytes(kUncertain, { has_none: true }),
    "uncertain.shadow.sun": bytes(kUncertainSun, { has_none: true }),
  },
};
export const kTechnique = {
  id: "t1",
  name: "painted",
  kind: "technique",
  stored: {
    color: colors(kRgb),
    id: bytes(kIds, { has_none: true }),
    depth: floats(kDepth),
    "shadow.sun": floats(kSun),
    normal_angle: words(kAngles, { has_none: true, scale: 1 / 256 }),
    fetches: bytes(kFetches, { has_none: true }),
    iterations: words(kIterations),
  },
};
export const kSummary = {
  id: "s",
  name: "all techniques",
  kind: "summary",
  stored: { failing: bytes(kFailing, { has_none: true }) },
};
export const kObjects = [
  { id: 1, name: "stone", relief_depth: 0.25 },
  { id: 2, name: "ball", relief_depth: null },
  { id: 3, name: "wall", relief_depth: 0.5 },
];
/** A report of these frames; `more`: as for writeReport(). */
export const painted = (t, more = {}) =>
  writeReport(t, {
    width: kWidth,
    height: kHeight,
    frames: [kReference, kTechnique, kSummary],
    objects: kObjects,
    ...more,
  });

export const hex = (...rgb) => `#${rgb.map((code) => code.toString(16).padStart(2, "0")).join("")}`;

/** Colors "#rrggbb" of the first pane's canvas; "" for transparent pixels. */
export const shownPixels = (page) =>
  page
    .locator(".pane canvas")
    .first()
    .evaluate((canvas) => {
      const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
      const two = (code) => code.toString(16).padStart(2, "0");
      return Array.from({ length: data.length / 4 }, (_, i) => {
        const [r, g, b, alpha] = data.slice(4 * i, 4 * i + 4);
        return alpha === 255 ? `#${two(r)}${two(g)}${two(b)}` : alpha === 0 ? "" : `alpha ${alpha}`;
      });
    });
