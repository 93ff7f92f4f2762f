// The legend below a picture: a color bar with its ends, middle and unit, the controls of its range, and
// categories with their pixel counts.
import { cssColor, type Colors } from "./colors";
import { make, setText } from "./dom";
import { significant, wholeNumber } from "./numbers";
import { RangeEnd } from "./range_end";
import { isRange, type Range } from "./ranges";
import type { Reading } from "./reading";

export class Legend {
  readonly element = make("div", { class: "legend" });
  private shown = "";
  private readonly bar = make("div", { class: "color-bar", "aria-hidden": "true" });
  private readonly ends = make("div", { class: "bar-ends" }, make("span"), make("span"), make("span"));
  private readonly controls = make("div", { class: "range-controls" });
  private readonly note = make("p", { class: "legend-note" });
  private readonly categories = make("ul", { class: "categories" });
  private low: RangeEnd | null = null;
  private high: RangeEnd | null = null;

  constructor(
    private readonly colors: Colors,
    private readonly paneIndex: number,
    private readonly onRange: (range: Range | undefined) => void,
  ) {}

  clear(): void {
    this.shown = "";
    this.element.replaceChildren();
  }

  show(reading: Reading, range: Range, defaultRange: Range, counts: readonly number[]): void {
    const kind = `${reading.layer} ${reading.map} ${defaultRange}`;
    if (kind !== this.shown) this.build(reading, defaultRange);
    this.shown = kind;
    if (this.high) this.showRange(reading, range);
    this.showCategories(reading, counts);
  }

  private build(reading: Reading, defaultRange: Range): void {
    const map =
      reading.map === "none" || reading.map === "picture" ? undefined : this.colors.maps[reading.map];
    this.low = this.high = null;
    this.element.replaceChildren(
      ...(map ? [this.bar, this.ends, this.controls] : []),
      this.categories,
      this.note,
    );
    setText(this.note, reading.note ?? "");
    if (!map) return;
    this.bar.style.background = `linear-gradient(to right, ${map.stops.map(cssColor).join(", ")})`;
    const choose = () => {
      const high = this.high?.value ?? NaN;
      const low = reading.map === "diverging" ? -high : (this.low?.value ?? 0);
      if (isRange(reading.layer, low, high)) this.onRange([low, high]);
    };
    const where = `pane ${this.paneIndex + 1}`;
    const linear = reading.map === "gray" ? defaultRange : null;
    if (linear) this.low = new RangeEnd("lightest at", where, defaultRange[0], linear, choose);
    this.high = new RangeEnd(
      linear ? "darkest at" : "full color at",
      where,
      defaultRange[1],
      linear,
      choose,
    );
    const reset = make(
      "button",
      { type: "button", click: () => this.onRange(undefined), "aria-label": `Reset range, ${where}` },
      "Reset",
    );
    this.controls.replaceChildren(...(this.low ? [this.low.element] : []), this.high.element, reset);
  }

  private showRange(reading: Reading, range: Range): void {
    const [low, high] = range;
    const sign = (value: number) =>
      (reading.map === "diverging" && value > 0 ? "+" : "") + significant(value, 4);
    const words = reading.map === "diverging" ? [" too near", "", " too far"] : ["", "", ""];
    [sign(low) + words[0], `${sign((low + high) / 2)} ${reading.unit}`, sign(high) + words[2]].forEach(
      (text, i) => setText(this.ends.children[i], text),
    );
    this.low?.show(low);
    this.high?.show(high);
  }

  private showCategories(reading: Reading, counts: readonly number[]): void {
    const listed = reading.categories
      .map((category, i) => ({ ...category, count: counts[i] }))
      .filter(({ always, count }) => always || count > 0);
    this.categories.replaceChildren(
      ...listed.map(({ label, color, count }) => {
        const swatch = make("i");
        swatch.style.background = cssColor(color);
        return make("li", {}, swatch, `${label} `, make("b", {}, wholeNumber(count)));
      }),
    );
    this.categories.hidden = listed.length === 0;
  }
}
