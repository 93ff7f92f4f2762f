// The plots: the Pareto front equals its definition, curves pass through the results, choices are kept in the
// address, saved files are self-contained.
import assert from "node:assert/strict";
import { cpSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";
import { addressHolds, frameId, openReport, reportFile, resultsOf } from "./browser.mjs";

const frontShown = (page) => page.locator("#plots .front button").allInnerTexts();
const notOnFront = async (page) =>
  (await page.locator("#plots .left-out").count()) ? page.locator("#plots .left-out").innerText() : "";

/** The definition: no other point is at least as good in both dimensions and better in one. */
function frontByDefinition(points) {
  const asGood = (a, b) => a.cost <= b.cost && a.merit >= b.merit;
  const better = (a, b) => a.cost < b.cost || a.merit > b.merit;
  return points
    .filter((point) => !points.some((other) => asGood(other, point) && better(other, point)))
    .map(({ name }) => name)
    .sort();
}

/** A copy of the report of the torus with changed data. */
function changedReport(t, change) {
  const folder = mkdtempSync(join(tmpdir(), "plumbline-report-"));
  t.after(() => rmSync(folder, { recursive: true }));
  cpSync(join(reportFile("torus"), ".."), folder, { recursive: true });
  const file = join(folder, "index.html");
  const page = readFileSync(file, "utf8").replace(
    /(<script type="application\/json" id="report-data">)([^]*?)(<\/script>)/,
    (_whole, open, json, close) => {
      const data = JSON.parse(json);
      change(data);
      return open + JSON.stringify(data).replaceAll("<", "\\u003c") + close;
    },
  );
  writeFileSync(file, page);
  return file;
}

/** As many techniques as points, each with an IoU, a depth RMSE, a bias and lookups. */
function techniquesAt(data, points) {
  const [model] = data.results.techniques;
  data.results.techniques = points.map(({ name, quality, bias, cost }) => {
    const technique = structuredClone(model);
    technique.name = name;
    technique.silhouette.iou = quality;
    technique.depth.rmse_relief = quality;
    technique.depth.bias_relief = bias ?? 0;
    technique.cost.fetches_mean = cost;
    return technique;
  });
}

test("front of real results: equals the definition, for metrics of either direction", async (t) => {
  const { page } = await openReport(t, reportFile("torus"));
  const competing = resultsOf("torus").techniques.filter(({ control }) => !control);
  const qualities = {
    "silhouette.iou": ({ silhouette }) => silhouette.iou,
    "depth.rmse_relief": ({ depth }) => -depth.rmse_relief,
    "shadow.sun.agreement": ({ shadow }) => shadow.sun.agreement,
    "normal.mean_degrees": ({ normal }) => -normal.mean_degrees,
  };
  for (const [key, merit] of Object.entries(qualities))
    for (const cost of ["cost.fetches_mean", "cost.ms_median"]) {
      await page.getByLabel("Quality", { exact: true }).selectOption(key);
      await page.getByLabel("Cost", { exact: true }).selectOption(cost);
      const points = competing.map((each) => ({
        name: each.name,
        cost: each.cost[cost.slice("cost.".length)],
        merit: merit(each),
      }));
      assert.deepEqual((await frontShown(page)).sort(), frontByDefinition(points), `${key} over ${cost}`);
    }
  assert.match(await notOnFront(page), /micro_triangles is a control/);
});

test("front with ties: keeps them all; a bias counts by its magnitude", async (t) => {
  const points = [
    { name: "tie 1", cost: 10, quality: 0.5, bias: -0.1 },
    { name: "tie 2", cost: 10, quality: 0.5, bias: 0.1 },
    { name: "same cost, worse either way", cost: 10, quality: 0.4, bias: -0.2 },
    { name: "dearer, as good", cost: 12, quality: 0.5, bias: 0.1 },
    { name: "dearest, best", cost: 20, quality: 0.9, bias: 0.01 },
    { name: "cheapest, worst", cost: 1, quality: 0.1, bias: -0.9 },
  ];
  const { page } = await openReport(
    t,
    changedReport(t, (data) => techniquesAt(data, points)),
  );
  const wanted = ["cheapest, worst", "dearest, best", "tie 1", "tie 2"];
  assert.deepEqual((await frontShown(page)).sort(), wanted);
  await page.getByLabel("Quality", { exact: true }).selectOption("depth.bias_relief");
  assert.deepEqual((await frontShown(page)).sort(), wanted);
  await page.getByLabel("Quality", { exact: true }).selectOption("depth.rmse_relief"); // low is better
  assert.deepEqual(await frontShown(page), ["cheapest, worst"]);
});

test("front of random points: equals the definition", async (t) => {
  let seed = 7;
  const random = (count) => (seed = (seed * 48271) % 2147483647) % count; // coarse: many ties
  for (let round = 0; round < 5; ++round) {
    const points = Array.from({ length: 40 }, (_, index) => ({
      name: `t${index}`,
      cost: 1 + random(12),
      quality: random(10) / 10,
    }));
    const { page } = await openReport(
      t,
      changedReport(t, (data) => techniquesAt(data, points)),
    );
    assert.deepEqual(
      (await frontShown(page)).sort(),
      frontByDefinition(points.map(({ name, cost, quality }) => ({ name, cost, merit: quality }))),
    );
  }
});

test("technique without lookups: listed as left out, with the reason", async (t) => {
  const file = changedReport(t, (data) => {
    const [first, second] = data.results.techniques;
    delete first.cost.fetches_mean;
    first.cost.absent = { fetches_mean: "the shader counts none" };
    for (const key of Object.keys(second))
      if (!["name", "parameters", "gl"].includes(key)) delete second[key];
    second.error = "it doesn't compile";
  });
  const { page, account } = await openReport(t, file);
  const note = await notOnFront(page);
  assert.match(note, /linear_binary has no .*the shader counts none/);
  assert.match(note, /linear_binary@quadric failed/);
  assert.deepEqual(account.errors, []);
});

test("report without figures: a sentence instead of plots", async (t) => {
  const file = changedReport(t, (data) => {
    for (const technique of data.results.techniques)
      for (const group of ["silhouette", "depth", "shadow", "normal", "st", "image", "cost"])
        delete technique[group];
    for (const frame of data.frames) {
      delete frame.badpix;
      delete frame.histogram;
    }
  });
  const { page, account } = await openReport(t, file);
  assert.match(await page.locator("#plots").innerText(), /no figures to plot/);
  assert.equal(await page.locator("#plots figure").count(), 0);
  assert.deepEqual(account.errors, []);
});

test("names in the plot: inside of it, none covers another", async (t) => {
  const points = Array.from({ length: 12 }, (_, index) => ({
    name: `technique_number_${index}@quadric`,
    cost: 10 + index / 4,
    quality: 0.9 + index / 500,
  }));
  for (const width of [390, 1280]) {
    const { page } = await openReport(
      t,
      changedReport(t, (data) => techniquesAt(data, points)),
      { width },
    );
    const { boxes, frame } = await page
      .locator("#plots svg")
      .first()
      .evaluate((svg) => {
        const box = (element) =>
          (({ left, top, right, bottom }) => ({ left, top, right, bottom }))(element.getBoundingClientRect());
        return { boxes: [...svg.querySelectorAll("text[paint-order]")].map(box), frame: box(svg) };
      });
    assert.ok(boxes.length >= 6, `${boxes.length} names at ${width} pixels`);
    const slack = 1; // glyphs may extend beyond their line by a pixel
    for (const [i, a] of boxes.entries()) {
      assert.ok(
        a.left >= frame.left - slack &&
          a.right <= frame.right + slack &&
          a.top >= frame.top - slack &&
          a.bottom <= frame.bottom + slack,
      );
      for (const b of boxes.slice(i + 1))
        assert.ok(
          a.right <= b.left + slack ||
            b.right <= a.left + slack ||
            a.bottom <= b.top + slack ||
            b.bottom <= a.top + slack,
        );
    }
  }
});

test("BadPix curve: passes through the figures of the results", async (t) => {
  const { page } = await openReport(t, reportFile("torus"));
  const { curves, frames } = await page.evaluate(() =>
    JSON.parse(document.getElementById("report-data").textContent),
  );
  for (const { name, depth } of resultsOf("torus").techniques) {
    const { badpix, histogram } = frames.find((frame) => frame.name === name);
    for (const [key, threshold] of [
      ["badpix_1pct", 0.01],
      ["badpix_5pct", 0.05],
      ["badpix_25pct", 0.25],
    ])
      assert.equal(
        badpix[curves.thresholds.findIndex((each) => Math.abs(each - threshold) < 1e-12)],
        depth[key],
        `${name}, ${key}`,
      );
    assert.equal(
      histogram.counts.reduce((sum, count) => sum + count, histogram.below + histogram.above),
      depth.domain_px,
    );
  }
});

test("choices: survive a reload", async (t) => {
  const { page } = await openReport(t, reportFile("torus"));
  await page.getByLabel("Quality", { exact: true }).selectOption("depth.rmse_relief");
  await page.getByLabel("Cost", { exact: true }).selectOption("cost.ms_median");
  await page.getByLabel("Highlight A").selectOption(frameId("torus", "parallax_slope"));
  await page.getByLabel("compared with B").selectOption(frameId("torus", "linear_binary"));
  await page.getByLabel("Logarithmic share").first().check();
  await addressHolds(page, "plot.badpix=1");
  const shown = () =>
    page
      .locator("#plots")
      .evaluate((element) =>
        [...element.querySelectorAll("select, svg, .front")].map((each) => each.value ?? each.outerHTML),
      );
  const before = await shown();
  await page.reload();
  await page.waitForSelector("#plots svg[aria-label]");
  assert.deepEqual(await shown(), before);
});

test("pan in the viewer: plots aren't drawn again", async (t) => {
  const { page } = await openReport(t, reportFile("torus"));
  await page.waitForSelector("#plots svg[aria-label]");
  await page.evaluate(() => document.querySelector("#plots svg").setAttribute("data-kept", ""));
  await page.evaluate(() => (location.hash = "zoom=3,100,75"));
  await page.waitForFunction(() => document.querySelector(".pane").dataset.scale === "3");
  assert.equal(await page.locator("#plots svg[data-kept]").count(), 1);
});

test("saved plots: self-contained, on white, in the dark scheme too", async (t) => {
  const { page } = await openReport(t, reportFile("torus"), {
    colorScheme: "dark",
    hash: `#plot.b=${frameId("torus", "linear_binary")}`,
  });
  const buttons = await page.getByRole("button", { name: /^Save SVG/ }).all();
  assert.equal(buttons.length, 3);
  for (const button of buttons) {
    const [download] = await Promise.all([page.waitForEvent("download"), button.click()]);
    assert.match(download.suggestedFilename(), /^[a-z-]+\.svg$/);
    const text = readFileSync(await download.path(), "utf8");
    assert.doesNotMatch(text, /var\(|currentColor|<style|class=|https?:(?!\/\/www\.w3\.org\/)/);
    const { parsed, name, background, texts } = await page.evaluate((source) => {
      const document_ = new DOMParser().parseFromString(source, "image/svg+xml");
      return {
        parsed: document_.documentElement.nodeName,
        name: document_.querySelector("title")?.textContent,
        background: document_.querySelector("rect")?.getAttribute("fill"),
        texts: document_.querySelectorAll("text").length,
      };
    }, text);
    assert.equal(parsed, "svg");
    assert.ok(name);
    assert.equal(background, "#ffffff");
    assert.ok(texts > 5);
  }
});
