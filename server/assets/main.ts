/* The islands of a page. Every page works without them; each one looks for its own markup and starts only there. */
import "./css/main.css";

import { countDown } from "./ts/countdown.ts";
import { restoreDraft } from "./ts/draft.ts";
import { takeFiles } from "./ts/drop.ts";
import { listenForEcho } from "./ts/echo.ts";
import { growFormulas } from "./ts/formula.ts";
import { followJob } from "./ts/jobs.ts";
import { keepPerson } from "./ts/laboratory/person.ts";
import { moveInGrid } from "./ts/matrix.ts";
import { orderList } from "./ts/order.ts";
import { pasteInGrid } from "./ts/paste.ts";
import { buildPolygon } from "./ts/polygon.ts";
import { followProgress } from "./ts/progress.ts";
import { sketch } from "./ts/sketch.ts";
import { hideStaleVerdicts } from "./ts/stale.ts";
import { guardSubmit } from "./ts/submit.ts";
import { showSymbols } from "./ts/symbols.ts";
import { tellStage, tellTimeLeft } from "./ts/time_left.ts";
import { keepInStep } from "./ts/twin.ts";
import { offerVisual } from "./ts/visual.ts";

document.querySelectorAll<HTMLElement>("[data-polygon]").forEach(buildPolygon);
document.querySelectorAll<HTMLTextAreaElement>("textarea[data-twin]").forEach(keepInStep);
document.querySelectorAll<HTMLElement>("[data-sketch]").forEach(sketch);
document.querySelectorAll<HTMLElement>("[data-order]").forEach(orderList);
document.querySelectorAll<HTMLElement>("[data-drop]").forEach(takeFiles);
document.querySelectorAll<HTMLFormElement>("form").forEach((form) => {
  guardSubmit(form);
  growFormulas(form);
  moveInGrid(form);
  pasteInGrid(form);
  listenForEcho(form);
  hideStaleVerdicts(form);
  restoreDraft(form); // last: what it restores is echoed and grown like typed text
});
document.querySelectorAll<HTMLElement>("[data-visual]").forEach(offerVisual);
document.querySelectorAll<HTMLElement>('.keys[hidden]').forEach(showSymbols);
document.querySelectorAll<HTMLElement>("[data-countdown]").forEach(countDown);
document.querySelectorAll<HTMLElement>("[data-left]").forEach(tellTimeLeft);
document.querySelectorAll<HTMLElement>("[data-late-in], [data-closed-in]").forEach(tellStage);
document.querySelectorAll<HTMLElement>("[data-progress]").forEach(followProgress);
document.querySelectorAll<HTMLElement>('[data-job^="/"]').forEach(followJob);
document.querySelectorAll<HTMLFormElement>("form[data-person]").forEach(keepPerson);
const bench = document.querySelector<HTMLElement>("[data-laboratory]");
if (bench !== null) void import("./ts/laboratory/panel.ts").then(({ start }) => start(bench)); // no other page needs it
