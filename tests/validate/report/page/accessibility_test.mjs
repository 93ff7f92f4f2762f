// axe-core finds nothing serious or critical, and the page fits a phone.
import assert from "node:assert/strict";
import { createRequire } from "node:module";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { frameId, openReport, panesLoaded, reportFile } from "./browser.mjs";

const axeSource = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

async function seriousFindings(page) {
  await page.evaluate(axeSource);
  const { violations } = await page.evaluate(() => window.axe.run(document, { resultTypes: ["violations"] }));
  return violations
    .filter(({ impact }) => impact === "serious" || impact === "critical")
    .flatMap(({ id, nodes }) => nodes.map(({ target }) => `${id}: ${target.join(" ")}`));
}

for (const [what, options] of Object.entries({
  light: {},
  dark: { colorScheme: "dark" },
  "on a phone": { width: 390, height: 844 },
  "with everything in use": {
    hash: `#view=blend&plot.b=${frameId("torus", "linear_binary")}&plot.histogram=1&plot.badpix=1&sort=silhouette.iou:desc&pixel=90,60`,
  },
}))
  test(`no serious finding, ${what}`, async (t) => {
    const { page } = await openReport(t, reportFile("torus"), options);
    await panesLoaded(page);
    assert.deepEqual(await seriousFindings(page), []);
  });

test("button without a name: axe-core finds it", async (t) => {
  const { page } = await openReport(t, reportFile("torus"));
  await page.evaluate(() => document.body.append(document.createElement("button")));
  assert.equal(
    (await seriousFindings(page)).filter((finding) => finding.startsWith("button-name")).length,
    1,
  );
});

for (const width of [390, 1280])
  test(`${width} pixels wide: nothing overflows, targets are 24 pixels high`, async (t) => {
    const { page } = await openReport(t, reportFile("torus"), { width });
    await panesLoaded(page);
    assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), width);
    const small = await page
      .locator("button:visible, select:visible")
      .evaluateAll((controls) =>
        controls
          .filter((control) => control.getBoundingClientRect().height < 24)
          .map((control) => control.outerHTML.slice(0, 120)),
      );
    assert.deepEqual(small, []);
  });
