// The report opens from disk without errors and without requests outside its folder, and doesn't execute
// texts.
import assert from "node:assert/strict";
import { copyFileSync, cpSync, mkdirSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";
import { pathToFileURL } from "node:url";
import { frameId, openReport, panesLoaded, reportFile, resultsOf } from "./browser.mjs";

function temporaryFolder(t) {
  const folder = mkdtempSync(join(tmpdir(), "plumbline-report-"));
  t.after(() => rmSync(folder, { recursive: true }));
  return folder;
}

function expectQuiet({ errors, dialogs, requests }) {
  assert.deepEqual(errors, []);
  assert.deepEqual(dialogs, []);
  assert.deepEqual(requests, []);
}

test("report on disk: opens without errors and without requests outside its folder", async (t) => {
  const { page, account } = await openReport(t, reportFile("torus"));
  await panesLoaded(page);
  assert.equal(await page.locator(".pane[data-state=error]").count(), 0);
  assert.equal(await page.locator("#plots svg[aria-label]").count(), 3);
  expectQuiet(account);
  const ms = await page.evaluate(() => document.documentElement.dataset.firstPicture);
  t.diagnostic(`first picture after ${ms} ms`);
});

test("page that misbehaves: is recorded", async (t) => {
  const file = join(temporaryFolder(t), "index.html");
  writeFileSync(
    file,
    "<img src='http://127.0.0.1:9/x'><img src='../beside.png'><script>alert(1); console.error(2); fail()</script>",
  );
  const { page, account } = await openReport(t, file);
  await page.waitForTimeout(100);
  assert.ok(account.errors.length >= 2);
  assert.deepEqual(account.dialogs, ["1"]);
  assert.deepEqual(account.requests, [
    "http://127.0.0.1:9/x",
    pathToFileURL(join(file, "../../beside.png")).href,
  ]);
});

test("single file: opens in another folder", async (t) => {
  const folder = temporaryFolder(t);
  copyFileSync(reportFile("single"), join(folder, "moved.html"));
  const { page, account } = await openReport(t, join(folder, "moved.html"));
  await panesLoaded(page);
  assert.equal(await page.locator(".pane[data-state=error]").count(), 0);
  assert.equal(await page.locator("#plots svg[aria-label]").count(), 3);
  const broken = await page.evaluate(
    () => [...document.images].filter((image) => image.complete && image.naturalWidth === 0).length,
  );
  assert.equal(broken, 0);
  expectQuiet(account);
});

test("text that looks like markup: is shown, not run", async (t) => {
  const { page, account } = await openReport(t, reportFile("hostile"));
  await panesLoaded(page);
  const { scene, techniques } = resultsOf("hostile");
  const hostile = techniques.map(({ name }) => name).find((name) => name.includes("<img"));
  assert.equal(await page.locator("h1").innerText(), scene.name);
  assert.ok((await page.locator("header").innerText()).includes(scene.purpose));
  const row = page.locator("tbody tr").filter({ has: page.getByRole("button", { name: `View ${hostile}` }) });
  assert.equal(await row.count(), 1);
  await row.getByRole("button").click();
  await page.locator("#plots select").first().selectOption({ label: hostile });
  await panesLoaded(page);
  const made = await page.evaluate(() => ({
    images: document.querySelectorAll("img[src=x], [onerror], [onload]").length,
    scripts: [...document.scripts].filter((script) => script.text.startsWith("alert")).length,
  }));
  assert.deepEqual(made, { images: 0, scripts: 0 });
  assert.ok(
    await page
      .locator("#plots")
      .innerText()
      .then((text) => text.includes(hostile)),
  );
  expectQuiet(account);
});

test("missing or damaged frame: its pane says so, the rest works", async (t) => {
  const { page: whole } = await openReport(t, reportFile("torus"));
  const files = await whole.evaluate(() =>
    JSON.parse(document.getElementById("report-data").textContent).frames.map(({ file }) => file),
  );
  const folder = join(temporaryFolder(t), "report");
  mkdirSync(folder);
  cpSync(join(reportFile("torus"), ".."), folder, { recursive: true });
  const technique = files[files.findIndex((file) => file.includes("linear_binary"))];
  for (const damage of [
    (file) => rmSync(file),
    (file) => writeFileSync(file, "plumblineFrame("),
    (file) => writeFileSync(file, ""),
  ]) {
    damage(join(folder, technique));
    const { page } = await openReport(t, join(folder, "index.html"));
    await panesLoaded(page);
    const panes = page.locator(".pane:not([hidden])");
    assert.equal(await panes.first().getAttribute("data-state"), "ready"); // the reference
    const failed = page.locator(
      `.pane:not([hidden])[data-frame='${frameId("torus", "linear_binary")}'][data-state=error]`,
    );
    assert.ok((await failed.count()) > 0);
    assert.ok((await failed.first().innerText()).includes(technique));
    assert.equal(await page.locator("#plots svg[aria-label]").count(), 3);
  }
});
