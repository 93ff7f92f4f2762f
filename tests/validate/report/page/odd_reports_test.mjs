// Reports with missing frames or equal names, and addresses with values that can't be shown.
import assert from "node:assert/strict";
import { test } from "node:test";
import { openReport, panesLoaded } from "./browser.mjs";
import {
  hex,
  kObjects,
  kReference,
  kSummary,
  kTechnique,
  kWidth,
  painted,
  shownPixels,
} from "./painted_frames.mjs";
import { colors } from "./painted_report.mjs";

test("frames of equal names: are distinguished", async (t) => {
  const namesakes = ["reference", "all techniques"].map((name, i) => ({
    ...kTechnique,
    id: `t${i + 1}`,
    name,
    stored: { ...kTechnique.stored, color: colors(Array(16).fill([i + 1, 0, 0])) },
  }));
  const techniques = namesakes.map(({ name }) => ({
    name,
    parameters: {},
    gl: {},
    error: null,
    silhouette: { iou: 0.5 },
  }));
  const { page } = await openReport(
    t,
    painted(t, { frames: [kReference, ...namesakes, kSummary], techniques }),
  );
  for (const [index, { name }] of namesakes.entries()) {
    await page.getByRole("button", { name: `View ${name}` }).click();
    await panesLoaded(page);
    assert.deepEqual(
      await page.locator(".pane").evaluateAll((panes) => panes.map(({ dataset }) => dataset.frame)),
      ["r", `t${index + 1}`, `t${index + 1}`, `t${index + 1}`],
    );
    const second = page.locator(".pane canvas").nth(1);
    const [red] = await second.evaluate((canvas) => [
      ...canvas.getContext("2d").getImageData(0, 0, 1, 1).data,
    ]);
    assert.equal(red, index + 1);
  }
  const labels = await page.getByLabel("Pane 1: frame").locator("option").allInnerTexts();
  assert.deepEqual(labels, ["Reference", "reference", "all techniques", "All techniques"]);
});

const kTwoRows = [
  { name: "first", silhouette: { iou: 0.25 } },
  { name: "second", silhouette: { iou: 0.5 } },
];

for (const { what, frames, text, panes } of [
  { what: "without a frame", frames: [], text: "There are no frames to view.", panes: 0 },
  { what: "with the reference alone", frames: [kReference], text: "No technique drew a frame", panes: 1 },
])
  test(`report ${what}: says so, sorts and plots`, async (t) => {
    const techniques = kTwoRows.map((row, i) => ({
      ...row,
      parameters: {},
      gl: {},
      error: null,
      cost: { fetches_mean: 5 + i },
    }));
    const metrics = [
      { key: "silhouette.iou", label: "IoU", unit: "", meaning: "", better: "high" },
      { key: "cost.fetches_mean", label: "lookups", unit: "1", meaning: "", better: "low" },
    ];
    const change = (data) => (data.metrics = metrics);
    const { page, account } = await openReport(t, painted(t, { frames, techniques, change }));
    assert.ok((await page.locator("#viewer").innerText()).includes(text));
    assert.equal(await page.locator(".pane:not([hidden])").count(), panes);
    if (panes > 0) await panesLoaded(page);
    await page.getByRole("button", { name: "IoU" }).click();
    assert.deepEqual(
      await page
        .locator("#techniques tbody tr")
        .evaluateAll((rows) => rows.map(({ dataset }) => dataset.technique)),
      ["second", "first"],
    );
    assert.deepEqual(await page.locator("#plots .front button").allInnerTexts(), ["first", "second"]);
    assert.equal(await page.locator("#plots svg[aria-label]").count(), 1);
    assert.deepEqual(account.errors, []);
  });

test("unknown relief depths: aren't offered as a unit", async (t) => {
  const objects = kObjects.map((object) => ({ ...object, relief_depth: null }));
  const { page } = await openReport(t, painted(t, { objects }), {
    hash: "#n=1&f1=t1&l1=depth_error&unit=relief",
  });
  await panesLoaded(page);
  assert.equal(await page.getByLabel("Depth errors in").inputValue(), "world");
  assert.match(await page.locator(".viewer-note").innerText(), /unit=relief/);
  assert.ok(
    await page
      .getByLabel("Depth errors in")
      .locator("option[value=relief]")
      .evaluate((option) => option.disabled),
  );
});

test("address with impossible numbers: is reported, defaults are used", async (t) => {
  const refused = [
    "zoom=,,",
    "pixel=,",
    "wipe=",
    "range.fetches=-5,-1",
    "range.fetches=5,10",
    "range.depth=-2,0",
    "range.depth_error=,",
    "f1=nobody",
  ];
  const file = painted(t);
  for (const each of refused) {
    const { page, account } = await openReport(t, file, { hash: `#n=1&${each}` });
    await panesLoaded(page);
    assert.ok((await page.locator(".viewer-note").innerText()).includes(each), each);
    assert.equal(await page.locator(".pane").first().getAttribute("data-scale"), "1");
    await page.getByRole("button", { name: "Wipe" }).click();
    assert.equal(await page.locator(".viewer-note").innerText(), "", "the note goes with the next choice");
    assert.deepEqual(account.errors, []);
  }
});

test("zoom beyond the closest: is clamped, at any size", async (t) => {
  const { page } = await openReport(t, painted(t), { hash: "#n=1&zoom=1e300,2,2" });
  await panesLoaded(page);
  const scale = async () => Number(await page.locator(".pane").first().getAttribute("data-scale"));
  const width = () =>
    page
      .locator(".pane-view")
      .first()
      .evaluate((view) => view.clientWidth);
  const perPixel = async () => ((await scale()) * (await width())) / kWidth;
  const usable = async () => assert.ok((await scale()) <= 8 || (await perPixel()) <= 97, `${await scale()}`);
  await usable();
  await page.setViewportSize({ width: 390, height: 844 });
  await page.waitForTimeout(100);
  await usable();
});

test("other keys of the address: leave the viewer unchanged", async (t) => {
  const { page } = await openReport(t, painted(t), { hash: "#n=1&f1=nobody" });
  await panesLoaded(page);
  const note = await page.locator(".viewer-note").innerText();
  assert.match(note, /f1=nobody/);
  await page.evaluate(() => {
    document.querySelector(".viewer-note").textContent = "untouched";
    location.hash += "&sort=silhouette.iou:asc&plot.a=x";
  });
  await page.waitForTimeout(100);
  assert.equal(await page.locator(".viewer-note").innerText(), "untouched");
});

test("frame that can't be loaded: the earlier picture disappears", async (t) => {
  const broken = { ...kTechnique, id: "t2", name: "broken", file: "data/missing.js" };
  const { page } = await openReport(t, painted(t, { frames: [kReference, kTechnique, broken] }), {
    hash: "#n=1&f1=t1&l1=color",
  });
  await panesLoaded(page);
  assert.equal((await shownPixels(page))[7], "#1523f8");
  await page.getByLabel("Pane 1: frame").selectOption("t2");
  await page.waitForSelector('.pane[data-state="error"]');
  assert.deepEqual(await shownPixels(page), Array(16).fill(""));
});

test("frames out of sight: are forgotten, and loaded again on demand", async (t) => {
  const many = Array.from({ length: 12 }, (_, i) => ({
    ...kTechnique,
    id: `t${i + 1}`,
    name: `technique ${i + 1}`,
    stored: { ...kTechnique.stored, color: colors(Array(16).fill([i + 1, 0, 0])) },
  }));
  const { page } = await openReport(t, painted(t, { frames: [kReference, ...many] }), {
    hash: "#n=1&f1=r&l1=color",
  });
  const loads = new Map();
  page.on("request", (request) => {
    const name = request.url().split("/").at(-1);
    loads.set(name, (loads.get(name) ?? 0) + 1);
  });
  const look = async (i) => {
    await page.getByLabel("Pane 1: frame").selectOption(`t${i}`);
    await page.waitForFunction(
      (id) => document.querySelector(`.pane[data-frame="${id}"][data-state="ready"]`),
      `t${i}`,
    );
    await panesLoaded(page);
    assert.equal((await shownPixels(page))[0], hex(i, 0, 0));
  };
  for (let i = 1; i <= 12; ++i) await look(i);
  await look(11); // kept
  await look(1); // forgotten
  assert.equal(loads.get("t11.js"), 1);
  assert.equal(loads.get("t1.js"), 2);
});
