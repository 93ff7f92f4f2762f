// The table of metrics: sorting, the choice in the address, the buttons that show a technique in the viewer.
import assert from "node:assert/strict";
import { test } from "node:test";
import { addressHolds, frameId, openReport, panesLoaded, reportFile } from "./browser.mjs";

const table = (page) => page.locator("#techniques table");
const names = (page) =>
  table(page)
    .locator("tbody tr")
    .evaluateAll((rows) => rows.map((row) => row.dataset.technique));
const valuesOf = (page, key) =>
  table(page).evaluate((element, wanted) => {
    const column = [...element.tHead.rows[0].cells].findIndex((cell) => cell.dataset.key === wanted);
    return [...element.tBodies[0].rows].map((row) => row.cells[column]?.dataset.value ?? null);
  }, key);
const head = (page, key) => table(page).locator(`th[data-key="${key}"]`);

/** Whether numbers are in the order of `compare`, followed by nulls only. */
function expectSorted(values, compare) {
  const first = values.indexOf(null);
  const present = first < 0 ? values : values.slice(0, first);
  assert.ok(
    values.slice(present.length).every((value) => value === null),
    `absent figures last: ${values}`,
  );
  const numbers = present.map(Number);
  assert.ok(numbers.length > 1);
  assert.deepEqual(numbers, [...numbers].sort(compare));
}

test("three presses: better first, worse first, the program's order", async (t) => {
  const { page } = await openReport(t, reportFile("torus"));
  const original = await names(page);
  const key = "silhouette.iou";
  const button = head(page, key).getByRole("button");
  await button.click();
  expectSorted(await valuesOf(page, key), (a, b) => b - a);
  assert.equal(await head(page, key).getAttribute("aria-sort"), "descending");
  await button.press("Enter");
  expectSorted(await valuesOf(page, key), (a, b) => a - b);
  assert.equal(await head(page, key).getAttribute("aria-sort"), "ascending");
  await button.press("Space");
  assert.deepEqual(await names(page), original);
  assert.equal(await table(page).locator("[aria-sort]").count(), 0);
});

test("lower is better: the first press puts low figures first", async (t) => {
  const { page } = await openReport(t, reportFile("torus"));
  for (const key of await table(page)
    .locator("th[data-better=low]")
    .evaluateAll((heads) => heads.map((cell) => cell.dataset.key))) {
    await head(page, key).getByRole("button").click();
    expectSorted(await valuesOf(page, key), (a, b) => Math.abs(a) - Math.abs(b));
  }
});

test("lower is better: signed figures are sorted by magnitude", async (t) => {
  const { page } = await openReport(t, reportFile("torus"));
  const key = "depth.rmse_relief";
  await table(page).evaluate((element, wanted) => {
    const column = [...element.tHead.rows[0].cells].findIndex((cell) => cell.dataset.key === wanted);
    ["-0.3", "0.1", "-0.05", "0.2"].forEach(
      (value, row) => (element.tBodies[0].rows[row].cells[column].dataset.value = value),
    );
  }, key);
  await head(page, key).getByRole("button").click();
  assert.deepEqual(await valuesOf(page, key), ["-0.05", "0.1", "0.2", "-0.3"]);
});

test("absent figures: last in either direction", async (t) => {
  const { page } = await openReport(t, reportFile("torus"));
  const key = "cost.fetches_mean"; // micro_triangles has none
  assert.ok((await valuesOf(page, key)).includes(null));
  for (let press = 0; press < 2; ++press) {
    await head(page, key).getByRole("button").click();
    assert.equal((await valuesOf(page, key)).at(-1), null);
  }
});

test("equal figures: keep the program's order", async (t) => {
  const { page } = await openReport(t, reportFile("torus"));
  const key = "silhouette.missing_px"; // linear_binary and parallax_slope have equal silhouettes
  await head(page, key).getByRole("button").click();
  for (let press = 0; press < 2; ++press) {
    const order = await names(page);
    assert.ok(order.indexOf("linear_binary") < order.indexOf("parallax_slope"), order.join());
    await head(page, key).getByRole("button").click();
  }
});

test("sorting: survives a reload", async (t) => {
  const { page } = await openReport(t, reportFile("torus"));
  await head(page, "depth.rmse_relief").getByRole("button").click();
  await addressHolds(page, "sort=depth.rmse_relief:asc");
  const order = await names(page);
  await page.reload();
  assert.deepEqual(await names(page), order);
  assert.equal(await head(page, "depth.rmse_relief").getAttribute("aria-sort"), "ascending");
});

test("address with unknown choices: the program's order", async (t) => {
  const { page: plain } = await openReport(t, reportFile("torus"));
  const { page, account } = await openReport(t, reportFile("torus"), {
    hash: "#sort=no.such:asc&plot.quality=nothing&plot.a=nobody",
  });
  assert.deepEqual(await names(page), await names(plain));
  assert.equal(await page.locator("#plots svg[aria-label]").count(), 3);
  assert.deepEqual(account.errors, []);
});

test("button 'view': shows the technique in the viewer and highlights it in the plots", async (t) => {
  const { page } = await openReport(t, reportFile("torus"));
  await page.getByRole("button", { name: "View parallax_slope" }).click();
  await panesLoaded(page);
  assert.ok(
    (await page.locator(`.pane:not([hidden])[data-frame="${frameId("torus", "parallax_slope")}"]`).count()) >
      0,
  );
  assert.equal(await page.getByLabel("Highlight A").inputValue(), frameId("torus", "parallax_slope"));
  await page.getByRole("button", { name: "View linear_binary", exact: true }).click();
  await panesLoaded(page);
  assert.ok(
    (await page.locator(`.pane:not([hidden])[data-frame="${frameId("torus", "linear_binary")}"]`).count()) >
      0,
  );
});
