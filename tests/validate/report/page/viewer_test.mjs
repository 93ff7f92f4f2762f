// The viewer: shared zoom, wipe, flicker, blend, and a readout with the floats of the frames.
import assert from "node:assert/strict";
import { createHash } from "node:crypto";
import { test } from "node:test";
import {
  addressHolds,
  frameId,
  framePixels,
  openReport,
  panesLoaded,
  reportFile,
  reportsFolder,
} from "./browser.mjs";

const panes = (page) => page.locator(".pane:not([hidden])");
const arrangement = (page, name) => page.locator(`button[data-view="${name}"]`);
const cameras = (page) =>
  panes(page).evaluateAll((elements) => elements.map(({ dataset: { scale, x, y } }) => ({ scale, x, y })));
const nextFrame = (page) =>
  page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));

async function openPanes(t, hash = "") {
  const { page, account } = await openReport(t, reportFile("torus"), { hash, width: 1920, height: 1080 });
  await panesLoaded(page);
  await page.locator("#viewer").evaluate((viewer) => viewer.scrollIntoView());
  return { page, account };
}

/**
 * A hash of a screenshot of the first pane, between two fractions of its width, once it no longer changes.
 * Leaves out the frame's edges, where smoothing blends with what lies below, and the focus ring. /
 */
async function seen(page, from = 0.2, to = 0.8) {
  const { x, y, width, height } = await page.locator(".pane-view:visible").first().boundingBox();
  const clip = { x: x + from * width, y: y + 0.1 * height, width: (to - from) * width, height: 0.8 * height };
  const look = async () => {
    await nextFrame(page);
    const picture = await page.screenshot({ clip });
    return createHash("sha256").update(picture).digest("hex");
  };
  let [before, now] = [await look(), await look()];
  for (let tries = 0; before !== now; ++tries) {
    assert.ok(tries < 20, "the picture doesn't come to rest");
    [before, now] = [now, await look()];
  }
  return now;
}

const kSlope = frameId("torus", "parallax_slope");
/** The reference's color as A, a technique's depth error as B. */
const kTwo = `f1=r&l1=color&f2=${kSlope}&l2=depth_error`;

test("wheel, drag and keys: zoom and pan all panes together", async (t) => {
  const { page } = await openPanes(t);
  assert.equal(await panes(page).count(), 4);
  const before = await cameras(page);
  const box = await panes(page).nth(1).locator(".pane-view").boundingBox();
  await page.mouse.move(box.x + 0.7 * box.width, box.y + 0.3 * box.height);
  await page.mouse.wheel(0, -400);
  await page.waitForFunction((old) => document.querySelector(".pane").dataset.scale !== old, before[0].scale);
  await nextFrame(page);
  const zoomed = await cameras(page);
  assert.ok(Number(zoomed[0].scale) > Number(before[0].scale));
  assert.equal(new Set(zoomed.map((camera) => JSON.stringify(camera))).size, 1);

  await page.mouse.down();
  await page.mouse.move(box.x + 0.5 * box.width, box.y + 0.5 * box.height, { steps: 4 });
  await page.mouse.up();
  await nextFrame(page);
  const panned = await cameras(page);
  assert.notDeepEqual([panned[0].x, panned[0].y], [zoomed[0].x, zoomed[0].y]);
  assert.equal(panned[0].scale, zoomed[0].scale);
  assert.equal(new Set(panned.map((camera) => JSON.stringify(camera))).size, 1);

  await panes(page).nth(2).locator(".pane-view").focus();
  await page.keyboard.press("0");
  await page.waitForFunction(() => document.querySelector(".pane").dataset.scale === "1");
});

test("wheel: the pixel under the pointer stays there", async (t) => {
  const { page } = await openPanes(t);
  const box = await panes(page).first().locator(".pane-view").boundingBox();
  await page.mouse.move(box.x + 0.62 * box.width, box.y + 0.41 * box.height);
  await nextFrame(page);
  const pixel = await page.locator(".readout caption").innerText();
  assert.match(pixel, /^Pixel \d+ /);
  await page.mouse.wheel(0, -300);
  await page.waitForFunction(() => document.querySelector(".pane").dataset.scale !== "1");
  await nextFrame(page);
  assert.equal(await page.locator(".readout caption").innerText(), pixel);
});

test("wipe: A left of the divider, B right of it", async (t) => {
  const { page } = await openPanes(t, `#view=wipe&${kTwo}`);
  const divider = page.locator("input.divider");
  const halves = async (wipe) => {
    await divider.fill(wipe);
    return { left: await seen(page, 0.2, 0.4), right: await seen(page, 0.6, 0.8) };
  };
  const [b, a, both] = [await halves("0"), await halves("1"), await halves("0.5")];
  assert.deepEqual(both, { left: a.left, right: b.right });
  assert.notEqual(a.left, b.left);
  assert.notEqual(a.right, b.right);
  await divider.focus();
  await page.keyboard.press("ArrowRight");
  assert.ok(Number(await divider.inputValue()) > 0.5);
});

test("key F: alternates between A and B", async (t) => {
  const { page } = await openPanes(t, `#view=flicker&${kTwo}`);
  await page.locator(".pane-view:visible:not([inert])").first().focus();
  const pictures = [];
  for (let press = 0; press < 4; ++press) {
    pictures.push(await seen(page));
    await page.keyboard.press("f");
  }
  assert.notEqual(pictures[0], pictures[1]);
  assert.equal(pictures[0], pictures[2]);
  assert.equal(pictures[1], pictures[3]);
});

test("keys in a menu: left to the menu", async (t) => {
  const { page } = await openPanes(t);
  await page.locator("#viewer select").first().focus();
  await page.keyboard.press("w");
  assert.equal(await arrangement(page, "side").getAttribute("aria-pressed"), "true");
});

test("blend: from A alone to B alone", async (t) => {
  const alone = async (frame, layer) => seen((await openPanes(t, `#n=1&f1=${frame}&l1=${layer}`)).page);
  const [a, b] = [await alone("r", "color"), await alone(kSlope, "depth_error")];
  const { page } = await openPanes(t, `#view=blend&${kTwo}&opacity=0`);
  const slider = page.getByLabel("B over A");
  const pictures = [];
  for (const opacity of ["0", "0.5", "1"]) {
    await slider.fill(opacity);
    pictures.push(await seen(page));
  }
  assert.equal(pictures[0], a);
  assert.notEqual(pictures[1], a);
  assert.notEqual(pictures[1], b);
  assert.equal(pictures[2], b);
});

test("key held down: flickers once", async (t) => {
  const { page } = await openPanes(t, `#view=flicker&${kTwo}`);
  await page.locator(".pane-view:visible:not([inert])").first().focus();
  const shown = () => page.locator(".toolbar output").first().innerText();
  await page.keyboard.down("f");
  assert.equal(await shown(), "B");
  await page.keyboard.down("f"); // already down, so this is a key repeat
  assert.equal(await shown(), "B");
  await page.keyboard.up("f");
  await page.keyboard.press("f");
  assert.equal(await shown(), "A");
});

test("readout: equals the frames' values, float by float", async (t) => {
  const technique = "linear_binary";
  const { page } = await openPanes(t, `#n=2&f1=r&l1=depth&f2=${frameId("torus", technique)}&l2=depth_error`);
  const pixels = [];
  for (let y = 3; y < 150; y += 21) for (let x = 5; x < 200; x += 29) pixels.push([x, y]);
  const frame = (name) => `${reportsFolder}/torus/frames/${name}.exr`;
  const expected = framePixels(frame("reference"), "Z", pixels);
  const drawn = framePixels(frame(technique), "Z", pixels);
  const ids = [frame("reference"), frame(technique)].map((file) => framePixels(file, "id", pixels));
  assert.ok(ids[0].filter((id) => id > 0).length > 10);

  for (const [index, [x, y]] of pixels.entries()) {
    await page.evaluate(
      (pixel) => {
        const state = new URLSearchParams(location.hash.slice(1));
        state.set("pixel", pixel.join());
        location.hash = state.toString();
      },
      [x, y],
    );
    await page.waitForFunction(
      ([px, py]) =>
        document
          .querySelector(".readout caption")
          .textContent.startsWith(`Pixel ${px} from the left, ${py} from the top`),
      [x, y],
    );
    const cells = await page
      .locator(".readout tbody tr")
      .evaluateAll((rows) => rows.map((row) => [...row.cells].map((cell) => cell.textContent)));
    for (const [row, depths] of [expected, drawn].entries()) {
      const text = cells[row][2];
      if (ids[row][index] > 0) assert.equal(Math.fround(Number(text)), depths[index], `${x}, ${y}: ${text}`);
      else assert.equal(text, "");
    }
    if (ids[0][index] > 0 && ids[0][index] === ids[1][index]) {
      const error = drawn[index] - expected[index];
      const shown = Number(cells[1][3].split(" ")[0]);
      assert.ok(
        Math.abs(shown - error) <= 1e-5 * Math.abs(error),
        `${x}, ${y}: ${shown} instead of ${error}`,
      ); // six digits
    }
  }
});

test("arrow keys: move the pixel that is read", async (t) => {
  const { page } = await openPanes(t, "#pixel=100,75");
  await page.locator(".pane-view:visible:not([inert])").first().focus();
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("Shift+ArrowDown");
  await nextFrame(page);
  assert.match(
    await page.locator(".readout caption").innerText(),
    /^Pixel 101 from the left, 85 from the top/,
  );
});

test("reload: shows the same", async (t) => {
  const { page } = await openPanes(t);
  await arrangement(page, "wipe").click();
  await page.locator("input.divider").fill("0.3");
  await page.getByLabel("Pane 2: layer").selectOption("depth_error");
  await page.locator(".pane-view:visible:not([inert])").first().focus();
  await page.keyboard.press("+");
  await page.keyboard.press("ArrowRight");
  await addressHolds(page, "wipe=0.3");
  await addressHolds(page, "zoom=");
  await addressHolds(page, "pixel=");
  const shown = async () => ({
    panes: await panes(page).evaluateAll((elements) => elements.map(({ dataset }) => ({ ...dataset }))),
    view: await page.locator(".panes").getAttribute("data-view"),
    wipe: await page.locator("input.divider").inputValue(),
    pixel: await page.locator(".readout caption").innerText(),
  });
  await panesLoaded(page);
  const before = await shown();
  await page.reload();
  await panesLoaded(page);
  assert.deepEqual(await shown(), before);
});

test("pan of four panes at 1920 x 1080: frames per second (reported only)", async (t) => {
  const { page } = await openPanes(t);
  const box = await panes(page).first().locator(".pane-view").boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.wheel(0, -500);
  await nextFrame(page);
  await page.evaluate(() => {
    window.framesDrawn = 0;
    const count = () => {
      ++window.framesDrawn;
      requestAnimationFrame(count);
    };
    requestAnimationFrame(count);
  });
  await page.mouse.down();
  const begin = Date.now();
  for (let step = 0; Date.now() - begin < 2000; ++step)
    await page.mouse.move(
      box.x + box.width * (0.5 + 0.3 * Math.sin(step / 9)),
      box.y + box.height * (0.5 + 0.3 * Math.cos(step / 9)),
    );
  await page.mouse.up();
  const frames = await page.evaluate(() => window.framesDrawn);
  t.diagnostic(`${((1000 * frames) / (Date.now() - begin)).toFixed(0)} frames per second`);
  assert.equal(new Set((await cameras(page)).map((camera) => JSON.stringify(camera))).size, 1);
});
