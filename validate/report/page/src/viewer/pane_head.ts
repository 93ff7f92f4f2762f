// The head of a pane: its name, a menu of frames and a menu of layers.
import type { ReportData } from "../data";
import { frameById, frameLabel } from "../frames";
import { make, setOptions, setText } from "./dom";
import { layersOf, reasonAgainst } from "./layers";
import { possiblePane, type PaneChoice } from "./standard_panes";

export class PaneHead {
  readonly element: HTMLElement;
  private readonly name = make("span", { class: "pane-name" });
  private readonly frameMenu: HTMLSelectElement;
  private readonly layerMenu: HTMLSelectElement;

  constructor(
    private readonly report: ReportData,
    index: number,
    choose: (choice: PaneChoice) => void,
  ) {
    const change = () => {
      const layer = this.layerMenu.value as PaneChoice["layer"];
      choose(possiblePane(report, { frame: this.frameMenu.value, layer }));
    };
    const menu = (what: string) => make("select", { "aria-label": `Pane ${index + 1}: ${what}`, change });
    this.frameMenu = menu("frame");
    this.layerMenu = menu("layer");
    this.element = make("div", { class: "pane-head" }, this.name, this.frameMenu, this.layerMenu);
  }

  /** Returns the title of what is chosen. */
  show(name: string, { frame, layer }: PaneChoice): string {
    const entry = frameById(this.report, frame);
    if (!entry) throw new Error(`there is no frame '${frame}'`);
    const frames = this.report.frames.map((each) => ({ value: each.id, label: frameLabel(each) }));
    const layers = layersOf(this.report).map((info) => ({
      value: info.key,
      label: info.label,
      reason: reasonAgainst(this.report, info, entry),
    }));
    setText(this.name, name);
    setOptions(this.frameMenu, frames, frame);
    setOptions(this.layerMenu, layers, layer);
    return `${frameLabel(entry)}, ${layers.find(({ value }) => value === layer)?.label ?? layer}`;
  }
}
