// The control of one end of a color map's range: a slider, and a field for exact values.
import { make } from "./dom";
import { significant } from "./numbers";
import type { Range } from "./ranges";

/** Decades of the slider on either side of the default. */
const kDecades = 2;
const kStepsPerDecade = 50;

export class RangeEnd {
  readonly element: HTMLElement;
  value: number;
  private readonly slider: HTMLInputElement;
  private readonly field: HTMLInputElement;

  /**
   * `linear`: the limits of a linear slider; null: logarithmic around the default. `onChange`: called with a
   * chosen value.
   */
  constructor(
    label: string,
    where: string,
    private readonly defaultValue: number,
    private readonly linear: Range | null,
    onChange: () => void,
  ) {
    this.value = defaultValue;
    const steps = kDecades * kStepsPerDecade;
    this.slider = make("input", {
      type: "range",
      min: linear ? 0 : -steps,
      max: linear ? 2 * steps : steps,
      "aria-label": `${label}, ${where}`,
      input: () => {
        this.value = this.ofSlider(Number(this.slider.value));
        onChange();
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
          onChange();
        }
        this.show(this.value);
      },
    });
    this.element = make("span", { class: "range-end" }, `${label} `, this.slider, this.field);
  }

  show(value: number): void {
    this.value = value;
    const text = significant(value, 6);
    if (document.activeElement !== this.field || Number(this.field.value) !== Number(text))
      this.field.value = text;
    const step = Math.round(this.toSlider(value));
    if (Number(this.slider.value) !== step) this.slider.value = String(step);
    this.slider.setAttribute("aria-valuetext", text);
  }

  private ofSlider(step: number): number {
    if (!this.linear)
      return step === 0
        ? this.defaultValue
        : Number((this.defaultValue * 10 ** (step / kStepsPerDecade)).toPrecision(3));
    const [low, high] = this.linear;
    return Number((low + ((high - low) * step) / (2 * kDecades * kStepsPerDecade)).toPrecision(5));
  }

  private toSlider(value: number): number {
    if (!this.linear) return Math.log10(value / this.defaultValue) * kStepsPerDecade;
    const [low, high] = this.linear;
    return ((value - low) / (high - low)) * 2 * kDecades * kStepsPerDecade;
  }
}
