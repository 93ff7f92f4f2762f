// Below a picture: a colour bar with its ends, middle and unit and the controls of its range, or categories with their pixels.
import { cssColor, type Colors } from "./colors";
import { make, setText } from "./dom";
import { significant, wholeNumber } from "./numbers";
import { isRange, type Range } from "./paint";
import type { Reading } from "./readings";

/** The slider runs over so many decades each side of the range to begin with. */
const kDecades = 2;
const kStepsPerDecade = 50;

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

  /** `usual`: the range to begin with. */
  show(reading: Reading, range: Range, usual: Range, counts: readonly number[]): void {
    const kind = `${reading.layer} ${reading.map} ${usual}`;
    if (kind !== this.shown) this.build(reading, usual);
    this.shown = kind;
    if (this.high) this.showRange(reading, range);
    this.showCategories(reading, counts);
  }

  private build(reading: Reading, usual: Range): void {
    const map = reading.map === "none" || reading.map === "picture" ? undefined : this.colors.maps[reading.map];
    this.low = this.high = null;
    this.element.replaceChildren(...(map ? [this.bar, this.ends, this.controls] : []), this.categories, this.note);
    setText(this.note, reading.note ?? "");
    if (!map) return;
    this.bar.style.background = `linear-gradient(to right, ${map.stops.map(cssColor).join(", ")})`;
    const tell = () => {
      const high = this.high?.value ?? NaN;
      const low = reading.map === "diverging" ? -high : (this.low?.value ?? 0);
      if (isRange(reading.layer, low, high)) this.onRange([low, high]);
    };
    const where = `pane ${this.paneIndex + 1}`;
    const linear = reading.map === "gray" ? usual : null;
    if (linear) this.low = new RangeEnd("lightest at", where, usual[0], linear, tell);
    this.high = new RangeEnd(linear ? "darkest at" : "full colour at", where, usual[1], linear, tell);
    const reset = make("button", { type: "button", click: () => this.onRange(undefined), "aria-label": `Reset range, ${where}` }, "Reset");
    this.controls.replaceChildren(...(this.low ? [this.low.element] : []), this.high.element, reset);
  }

  private showRange(reading: Reading, range: Range): void {
    const [low, high] = range;
    const sign = (value: number) => (reading.map === "diverging" && value > 0 ? "+" : "") + significant(value, 4);
    const words = reading.map === "diverging" ? [" too near", "", " too far"] : ["", "", ""];
    [sign(low) + words[0], `${sign((low + high) / 2)} ${reading.unit}`, sign(high) + words[2]].forEach((text, i) =>
      setText(this.ends.children[i], text),
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

/** One end of a range: a slider to feel and a field to be exact. */
class RangeEnd {
  readonly element: HTMLElement;
  value: number;
  private readonly slider: HTMLInputElement;
  private readonly field: HTMLInputElement;

  /** Linear between two limits, or logarithmic about the usual value. */
  constructor(
    label: string,
    where: string,
    private readonly usual: number,
    private readonly linear: Range | null,
    tell: () => void,
  ) {
    this.value = usual;
    const steps = kDecades * kStepsPerDecade;
    this.slider = make("input", {
      type: "range",
      min: linear ? 0 : -steps,
      max: linear ? 2 * steps : steps,
      "aria-label": `${label}, ${where}`,
      input: () => {
        this.value = this.ofSlider(Number(this.slider.value));
        tell();
      },
    });
    this.field = make("input", {
      type: "number",
      step: "any",
      "aria-label": `${label}, ${where}, number`,
      change: () => {
        const value = this.field.valueAsNumber;
        if (Number.isFinite(value) && (linear || value > 0)) {
          this.value = value;
          tell();
        }
        this.show(this.value);
      },
    });
    this.element = make("span", { class: "range-end" }, `${label} `, this.slider, this.field);
  }

  show(value: number): void {
    this.value = value;
    const text = significant(value, 6);
    if (document.activeElement !== this.field || Number(this.field.value) !== Number(text)) this.field.value = text;
    const step = Math.round(this.toSlider(value));
    if (Number(this.slider.value) !== step) this.slider.value = String(step);
    this.slider.setAttribute("aria-valuetext", text);
  }

  private ofSlider(step: number): number {
    if (!this.linear) return step === 0 ? this.usual : Number((this.usual * 10 ** (step / kStepsPerDecade)).toPrecision(3));
    const [low, high] = this.linear;
    return Number((low + ((high - low) * step) / (2 * kDecades * kStepsPerDecade)).toPrecision(5));
  }

  private toSlider(value: number): number {
    if (!this.linear) return Math.log10(value / this.usual) * kStepsPerDecade;
    const [low, high] = this.linear;
    return ((value - low) / (high - low)) * 2 * kDecades * kStepsPerDecade;
  }
}
