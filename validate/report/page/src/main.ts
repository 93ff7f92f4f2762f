// The interactive part of the report. The page is whole without it but for pictures and plots.
import "./page.css";
import { FrameStore, readReportData } from "./data";
import { startViewer } from "./viewer/viewer";

const report = readReportData();
const store = new FrameStore(report);

const viewer = document.getElementById("viewer");
if (viewer) startViewer(report, store, viewer);
