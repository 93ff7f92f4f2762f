// The figure of a plot: heading, save button, controls, a drawing as wide as the page allows, notes.
import { saveSvg } from "./svg_file";

export interface PlotFigure {
  controls: HTMLElement;
  /** Below the drawing; filled by the caller. */
  notes: HTMLElement;
  redraw(): void;
}

/** Width of a saved plot in pixels, independent of the width of the page. */
const kSavedWidthPx = 720;

/** `draw` returns the SVG for a width in pixels, or undefined if there is nothing to show. */
export function plotFigure(
  root: HTMLElement,
  title: string,
  fileName: string,
  draw: (widthPx: number) => SVGSVGElement | undefined,
): PlotFigure {
  const figure = document.createElement("figure");
  figure.className = "plot";
  const heading = document.createElement("h3");
  heading.textContent = title;
  const controls = document.createElement("div");
  controls.className = "plot-controls";
  const save = document.createElement("button");
  save.type = "button";
  save.textContent = "Save SVG";
  save.setAttribute("aria-label", `Save SVG: ${title}`);
  save.addEventListener("click", () => {
    const svg = draw(kSavedWidthPx);
    if (svg) saveSvg(svg, title, fileName);
  });
  const drawing = document.createElement("div");
  drawing.className = "plot-drawing";
  const notes = document.createElement("figcaption");
  const head = document.createElement("div");
  head.className = "plot-head";
  head.append(heading, save);
  figure.append(head, controls, drawing, notes);
  root.append(figure);

  let drawnWidth = 0;
  const redraw = () => {
    const width = Math.floor(drawing.clientWidth);
    if (width === 0) return;
    drawnWidth = width;
    const svg = draw(width);
    svg?.setAttribute("role", "img");
    save.disabled = !svg;
    drawing.replaceChildren(svg ?? "Nothing to show: no figures.");
  };
  new ResizeObserver(() => {
    if (Math.floor(drawing.clientWidth) !== drawnWidth) redraw();
  }).observe(drawing);
  return { controls, notes, redraw };
}
