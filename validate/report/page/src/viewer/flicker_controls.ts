// The controls of the flicker arrangement: a button that swaps A and B, and automatic swapping.
import { make, setOptions, setText } from "./dom";

/** Automatic swaps per second; more than three flashes may cause seizures (WCAG 2.3.1). */
const kFlickerRates = [0.5, 1, 2, 3];

export class FlickerControls {
  readonly element: HTMLElement;
  private readonly shown = make("output");
  private readonly automatic: HTMLInputElement;
  private readonly rate: HTMLSelectElement;
  private clock: number | undefined;

  constructor(
    private readonly swap: () => void,
    reducedMotion: boolean,
  ) {
    this.automatic = make("input", {
      type: "checkbox",
      disabled: reducedMotion,
      change: () => this.restart(),
    });
    this.rate = make("select", {
      "aria-label": "Swaps a second",
      disabled: reducedMotion,
      change: () => this.restart(),
    });
    setOptions(
      this.rate,
      kFlickerRates.map((rate) => ({ value: String(rate), label: `${rate} a second` })),
      "1",
    );
    const why = reducedMotion ? "off: the system is set to reduced motion" : "";
    this.element = make(
      "div",
      { class: "field" },
      make("button", { type: "button", class: "swap", click: swap }, "Swap (F)"),
      this.shown,
      make("label", { title: why }, this.automatic, " automatically "),
      this.rate,
      ...(why ? [make("small", {}, why)] : []),
    );
  }

  show(isShown: boolean, second: boolean): void {
    this.element.hidden = !isShown;
    setText(this.shown, second ? "B" : "A");
    if (!isShown && this.automatic.checked) {
      this.automatic.checked = false;
      this.restart();
    }
  }

  private restart(): void {
    window.clearInterval(this.clock);
    this.clock = this.automatic.checked
      ? window.setInterval(this.swap, 1000 / Number(this.rate.value))
      : undefined;
  }
}
