// The controls above the panes.
import type { ReportData } from "../data";
import { techniqueFrames } from "../frames";
import { make, setOptions, setText } from "./dom";
import { FlickerControls } from "./flicker_controls";
import { arrangements, hasRelief, type Arrangement, type Settings } from "./settings";
import { kMostPanes, type TechniqueChoice } from "./standard_panes";

export interface ToolbarEvents {
  chooseTechniques(choice: TechniqueChoice): void;
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

export class Toolbar {
  readonly element: HTMLElement;
  private readonly technique: HTMLSelectElement;
  private readonly comparedWith: HTMLSelectElement;
  private readonly arrangement = new Map<Arrangement, HTMLButtonElement>();
  private readonly counts: HTMLButtonElement[] = [];
  private readonly countGroup = make("div", {
    class: "buttons",
    role: "group",
    "aria-label": "Panes side by side",
  });
  private readonly flicker: FlickerControls;
  private readonly opacity: HTMLInputElement;
  private readonly opacityText = make("output");
  private readonly blend: HTMLElement;
  private readonly unit: HTMLSelectElement;
  private readonly zoomText = make("output", { class: "zoom-text", "aria-live": "off" });

  constructor(
    private readonly report: ReportData,
    private readonly events: ToolbarEvents,
    reducedMotion: boolean,
  ) {
    const chosen = () =>
      events.chooseTechniques({ technique: this.technique.value, comparedWith: this.comparedWith.value });
    this.technique = make("select", { change: chosen });
    this.comparedWith = make("select", { change: chosen });
    this.flicker = new FlickerControls(events.swap, reducedMotion);
    const setOpacity = () => events.setOpacity(this.opacity.valueAsNumber);
    this.opacity = make("input", { type: "range", min: 0, max: 1, step: 0.01, input: setOpacity });
    this.blend = make("label", { class: "field" }, "B over A ", this.opacity, this.opacityText);
    this.unit = make("select", { change: () => events.setUnit(this.unit.value as Settings["unit"]) });
    this.addCountButtons();
    this.element = make(
      "div",
      { class: "toolbar", role: "group", "aria-label": "What the panes show" },
      make("label", { class: "field" }, "Technique ", this.technique),
      make("label", { class: "field" }, "compared with ", this.comparedWith),
      make("button", { type: "button", click: () => events.standardPanes() }, "Standard panes"),
      this.arrangementButtons(),
      this.countGroup,
      this.flicker.element,
      this.blend,
      this.zoomButtons(),
      make("label", { class: "field" }, "Depth errors in ", this.unit),
    );
  }

  private arrangementButtons(): HTMLElement {
    const group = make("div", { class: "buttons", role: "group", "aria-label": "Arrangement" });
    for (const name of arrangements) {
      const press = () => this.events.arrange(name, this.pressedCount());
      const button = make(
        "button",
        { type: "button", click: press, "data-view": name },
        kArrangementWords[name],
      );
      this.arrangement.set(name, button);
      group.append(button);
    }
    return group;
  }

  private addCountButtons(): void {
    for (let count = 1; count <= kMostPanes; ++count) {
      const press = () => this.events.arrange("side", count);
      const button = make("button", { type: "button", click: press, "data-count": count }, String(count));
      this.counts.push(button);
      this.countGroup.append(button);
    }
  }

  private zoomButtons(): HTMLElement {
    const { events } = this;
    const button = (label: string, text: string, click: () => void) =>
      make("button", { type: "button", click, "aria-label": label }, text);
    return make(
      "div",
      { class: "buttons", role: "group", "aria-label": "Zoom" },
      button("Zoom out", "−", () => events.zoomBy(1 / 2)),
      this.zoomText,
      button("Zoom in", "+", () => events.zoomBy(2)),
      button("Fit the whole frame", "Fit", () => events.fit()),
    );
  }

  show(settings: Settings): void {
    const techniques = techniqueFrames(this.report).map(({ id, name }) => ({ value: id, label: name }));
    this.technique.disabled = this.comparedWith.disabled = techniques.length === 0;
    setOptions(this.technique, techniques, settings.technique);
    setOptions(
      this.comparedWith,
      [{ value: "", label: "the reference" }, ...techniques],
      settings.comparedWith,
    );
    setOptions(
      this.unit,
      [
        { value: "world", label: "world units" },
        {
          value: "relief",
          label: "relief depths",
          ...(hasRelief(this.report) ? {} : { reason: "no relief depth is known" }),
        },
      ],
      settings.unit,
    );
    for (const [name, button] of this.arrangement)
      button.setAttribute("aria-pressed", String(name === settings.arrangement));
    this.counts.forEach((button, i) =>
      button.setAttribute("aria-pressed", String(i + 1 === settings.paneCount)),
    );
    this.countGroup.hidden = settings.arrangement !== "side";
    this.flicker.show(settings.arrangement === "flicker", settings.second);
    this.blend.hidden = settings.arrangement !== "blend";
    this.opacity.value = String(settings.opacity);
    setText(this.opacityText, `${Math.round(100 * settings.opacity)} %`);
  }

  /** `scale`: CSS pixels per frame pixel. */
  showZoom(scale: number): void {
    setText(this.zoomText, `${scale < 10 ? scale.toFixed(2) : scale.toFixed(1)}×`);
  }

  private pressedCount(): number {
    return this.counts.findIndex((button) => button.getAttribute("aria-pressed") === "true") + 1;
  }
}
