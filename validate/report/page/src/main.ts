// The interactive part of the report. The page is whole without it but for pictures and plots.
import { readReportData } from "./data";

readReportData();
