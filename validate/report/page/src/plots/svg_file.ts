// Saves a plot as a self-contained file: colors for white paper, generic fonts, a title, nothing from the
// page's style sheets.

const kSvg = "http://www.w3.org/2000/svg";

export function saveSvg(svg: SVGSVGElement, title: string, fileName: string): void {
  const url = URL.createObjectURL(new Blob([standaloneSvg(svg, title)], { type: "image/svg+xml" }));
  const link = document.createElement("a");
  link.href = url;
  link.download = fileName;
  link.click();
  // Chromium reads the blob after the click has returned.
  setTimeout(() => URL.revokeObjectURL(url), 10_000);
}

export function standaloneSvg(svg: SVGSVGElement, title: string): string {
  const copy = svg.cloneNode(true) as SVGSVGElement;
  const [, , width, height] = (copy.getAttribute("viewBox") ?? "0 0 0 0").split(" ");
  for (const element of copy.querySelectorAll("style, .transient")) element.remove();
  const background = document.createElementNS(kSvg, "rect");
  background.setAttribute("width", width);
  background.setAttribute("height", height);
  background.setAttribute("fill", "#ffffff");
  const name = document.createElementNS(kSvg, "title");
  name.textContent = title;
  copy.prepend(name, background);
  copy.setAttribute("font-size", copy.style.fontSize);
  copy.removeAttribute("style");
  for (const element of [copy, ...copy.querySelectorAll("*")])
    for (const attribute of ["class", "role", "aria-label", "aria-hidden"])
      element.removeAttribute(attribute);
  copy.setAttribute("font-family", "sans-serif");
  copy.setAttribute("color", "var(--text)");
  copy.setAttribute("fill", "var(--text)");
  return `<?xml version="1.0" encoding="UTF-8"?>\n${onPaper(new XMLSerializer().serializeToString(copy))}\n`;
}

/** Replaces custom properties, which only browsers support, by their values in the light scheme. */
function onPaper(source: string): string {
  const paper = document.createElement("div");
  paper.className = "on-paper";
  document.body.append(paper);
  const style = getComputedStyle(paper);
  const text = style.getPropertyValue("--text").trim();
  const replaced = source
    .replace(/var\((--[\w-]+)\)/g, (whole, name: string) => style.getPropertyValue(name).trim() || whole)
    .replaceAll("currentColor", text);
  paper.remove();
  return replaced;
}
