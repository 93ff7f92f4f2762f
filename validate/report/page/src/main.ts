// The interactive part of the report. The page is whole without it but for pictures and plots.
import "./page.css";
import { readReportData } from "./data";

readReportData();
