// The controls above the panes.
import type { ReportData } from "../data";
import { techniqueFrames } from "../frames";
import { make, setOptions, setText } from "./dom";
import { arrangements, hasRelief, kMostPanes, type Arrangement, type Settings } from "./settings";

export interface ToolbarEvents {
  chooseTechniques(technique: string, against: string): void;
  standardPanes(): void;
  arrange(arrangement: Arrangement, paneCount: number): void;
  setUnit(unit: Settings["unit"]): void;
  setOpacity(opacity: number): void;
  swap(): void;
  zoomBy(factor: number): void;
  fit(): void;
}

const kArrangementWords: { [arrangement in Arrangement]: string } = {
  side: "Side by side",
  wipe: "Wipe",
  flicker: "Flicker",
  blend: "Blend",
};

/** Swaps a second by itself; three flashes a second are the most that don't endanger anybody (WCAG 2.3.1). */
const kFlickerRates = [0.5, 1, 2, 3];

export class Toolbar {
  readonly element: HTMLElement;
  private readonly technique: HTMLSelectElement;
  private readonly against: HTMLSelectElement;
  private readonly arrangement = new Map<Arrangement, HTMLButtonElement>();
  private readonly counts: HTMLButtonElement[] = [];
  private readonly countGroup = make("div", { class: "buttons", role: "group", "aria-label": "Panes side by side" });
  private readonly flicker: FlickerControls;
  private readonly opacity: HTMLInputElement;
  private readonly opacityText = make("output");
  private readonly blend: HTMLElement;
  private readonly unit: HTMLSelectElement;
  private readonly zoomText = make("output", { class: "zoom-text", "aria-live": "off" });

  constructor(
    private readonly report: ReportData,
    events: ToolbarEvents,
    reducedMotion: boolean,
  ) {
    const chosen = () => events.chooseTechniques(this.technique.value, this.against.value);
    this.technique = make("select", { change: chosen });
    this.against = make("select", { change: chosen });
    const arranging = make("div", { class: "buttons", role: "group", "aria-label": "Arrangement" });
    for (const name of arrangements) {
      const press = () => events.arrange(name, this.pressedCount());
      const button = make("button", { type: "button", click: press, "data-view": name }, kArrangementWords[name]);
      this.arrangement.set(name, button);
      arranging.append(button);
    }
    for (let count = 1; count <= kMostPanes; ++count) {
      const button = make("button", { type: "button", click: () => events.arrange("side", count), "data-count": count }, String(count));
      this.counts.push(button);
      this.countGroup.append(button);
    }
    this.flicker = new FlickerControls(events.swap, reducedMotion);
    this.opacity = make("input", { type: "range", min: 0, max: 1, step: 0.01, input: () => events.setOpacity(this.opacity.valueAsNumber) });
    this.blend = make("label", { class: "field" }, "B over A ", this.opacity, this.opacityText);
    this.unit = make("select", { change: () => events.setUnit(this.unit.value as Settings["unit"]) });
    const zoomButton = (label: string, text: string, click: () => void) => make("button", { type: "button", click, "aria-label": label }, text);
    const zooming = make(
      "div",
      { class: "buttons", role: "group", "aria-label": "Zoom" },
      zoomButton("Zoom out", "−", () => events.zoomBy(1 / 2)),
      this.zoomText,
      zoomButton("Zoom in", "+", () => events.zoomBy(2)),
      zoomButton("Fit the whole frame", "Fit", () => events.fit()),
    );
    this.element = make(
      "div",
      { class: "toolbar", role: "group", "aria-label": "What the panes show" },
      make("label", { class: "field" }, "Technique ", this.technique),
      make("label", { class: "field" }, "against ", this.against),
      make("button", { type: "button", click: () => events.standardPanes() }, "Standard panes"),
      arranging,
      this.countGroup,
      this.flicker.element,
      this.blend,
      zooming,
      make("label", { class: "field" }, "Depth errors in ", this.unit),
    );
  }

  show(settings: Settings): void {
    const techniques = techniqueFrames(this.report).map(({ id, name }) => ({ value: id, label: name }));
    this.technique.disabled = this.against.disabled = techniques.length === 0;
    setOptions(this.technique, techniques, settings.technique);
    setOptions(this.against, [{ value: "", label: "the reference" }, ...techniques], settings.against);
    setOptions(
      this.unit,
      [
        { value: "world", label: "world units" },
        { value: "relief", label: "relief depths", ...(hasRelief(this.report) ? {} : { reason: "no relief's depth is known" }) },
      ],
      settings.unit,
    );
    for (const [name, button] of this.arrangement) button.setAttribute("aria-pressed", String(name === settings.arrangement));
    this.counts.forEach((button, i) => button.setAttribute("aria-pressed", String(i + 1 === settings.paneCount)));
    this.countGroup.hidden = settings.arrangement !== "side";
    this.flicker.show(settings.arrangement === "flicker", settings.second);
    this.blend.hidden = settings.arrangement !== "blend";
    this.opacity.value = String(settings.opacity);
    setText(this.opacityText, `${Math.round(100 * settings.opacity)} %`);
  }

  /** Screen pixels a frame pixel. */
  showZoom(scale: number): void {
    setText(this.zoomText, `${scale < 10 ? scale.toFixed(2) : scale.toFixed(1)}×`);
  }

  private pressedCount(): number {
    return this.counts.findIndex((button) => button.getAttribute("aria-pressed") === "true") + 1;
  }
}

/** A button that swaps A and B, and a clock that does. */
class FlickerControls {
  readonly element: HTMLElement;
  private readonly seen = make("output");
  private readonly automatic: HTMLInputElement;
  private readonly rate: HTMLSelectElement;
  private clock: number | undefined;

  constructor(
    private readonly swap: () => void,
    reducedMotion: boolean,
  ) {
    this.automatic = make("input", { type: "checkbox", disabled: reducedMotion, change: () => this.restart() });
    this.rate = make("select", { "aria-label": "Swaps a second", disabled: reducedMotion, change: () => this.restart() });
    setOptions(this.rate, kFlickerRates.map((rate) => ({ value: String(rate), label: `${rate} a second` })), "1");
    const why = reducedMotion ? "off: this system asks for less motion" : "";
    this.element = make(
      "div",
      { class: "field" },
      make("button", { type: "button", class: "swap", click: swap }, "Swap (F)"),
      this.seen,
      make("label", { title: why }, this.automatic, " by itself "),
      this.rate,
      ...(why ? [make("small", {}, why)] : []),
    );
  }

  show(isShown: boolean, second: boolean): void {
    this.element.hidden = !isShown;
    setText(this.seen, second ? "B" : "A");
    if (!isShown && this.automatic.checked) {
      this.automatic.checked = false;
      this.restart();
    }
  }

  private restart(): void {
    window.clearInterval(this.clock);
    this.clock = this.automatic.checked ? window.setInterval(this.swap, 1000 / Number(this.rate.value)) : undefined;
  }
}
