// Shared by the tests of the page: a browser, pages that record errors and requests, and the values of
// frames.
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { after } from "node:test";
import { dirname } from "node:path";
import { pathToFileURL } from "node:url";
import { chromium } from "playwright-core";

/** Folders and programs, set by run_page_test.sh. */
const { REPORTS_DIR, CHROMIUM, FRAME_PIXEL } = process.env;

export const reportsFolder = REPORTS_DIR;
export const reportFile = (name) => `${REPORTS_DIR}/${name}/report/index.html`;

let browser;
async function startedBrowser() {
  // No sandbox, because tests run as root in containers; all pages are trusted.
  browser ??= await chromium.launch({
    executablePath: CHROMIUM,
    args: ["--no-sandbox", "--disable-gpu", "--disable-background-networking"],
  });
  return browser;
}
after(() => browser?.close());

/**
 * A page with `file` loaded. `account` records what a report must not do: errors, dialogs, requests outside
 * its folder. It is closed after the test `t`. /
 */
export async function openReport(
  t,
  file,
  { hash = "", width = 1280, height = 900, colorScheme = "light" } = {},
) {
  const context = await (
    await startedBrowser()
  ).newContext({ viewport: { width, height }, colorScheme, acceptDownloads: true });
  t.after(() => context.close());
  const page = await context.newPage();
  const account = { errors: [], dialogs: [], requests: [] };
  page.on("console", (message) => {
    if (message.type() === "error" || message.type() === "warning") account.errors.push(message.text());
  });
  page.on("pageerror", (error) => account.errors.push(String(error)));
  page.on("dialog", (dialog) => {
    account.dialogs.push(dialog.message());
    dialog.dismiss();
  });
  const folder = `${pathToFileURL(dirname(file))}/`;
  page.on("request", (request) => {
    const url = request.url();
    if (!/^(data|blob):/.test(url) && !url.startsWith(folder)) account.requests.push(url);
  });
  await page.goto(pathToFileURL(file) + hash);
  return { page, account };
}

/** Waits until every visible pane shows its picture, or the reason why there is none. */
export async function panesLoaded(page) {
  await page.waitForFunction(() => {
    const panes = [...document.querySelectorAll(".pane:not([hidden])")];
    return (
      panes.length > 0 &&
      panes.every((pane) => pane.dataset.state === "ready" || pane.dataset.state === "error")
    );
  });
  // The picture is drawn in the next animation frame.
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
}

/** Waits, because the page writes its state to the address with a delay. */
export async function addressHolds(page, text) {
  await page.waitForFunction((wanted) => decodeURIComponent(location.hash).includes(wanted), text);
}

/** Floats of a frame's channel at pixels [[x, y], …], read by Plumbline's reader. */
export function framePixels(frameFile, channel, pixels) {
  const out = execFileSync(FRAME_PIXEL, [frameFile, channel, ...pixels.flat().map(String)], {
    encoding: "utf8",
  });
  return out
    .trim()
    .split("\n")
    .map((text) => (text === "inf" ? Infinity : Math.fround(Number(text))));
}

/** The data that the program passes to the page (page/src/data.ts). */
export function reportDataOf(report) {
  const page = readFileSync(reportFile(report), "utf8");
  const [, json] = page.match(/<script type="application\/json" id="report-data">([^]*?)<\/script>/);
  return JSON.parse(json);
}

/** Id of a technique's frame in panes and in the address. */
export function frameId(report, technique) {
  return reportDataOf(report).frames.find(({ kind, name }) => kind === "technique" && name === technique).id;
}

export function resultsOf(name) {
  return JSON.parse(readFileSync(`${REPORTS_DIR}/${name}/results.json`, "utf8"));
}
