// Takes the picture of a trace for the documentation (docs/reading_a_trace.md says of which one).
//   node picture.mjs TRACE.html PICTURE.png STEP NODE [WIDTH HEIGHT]
import { openPage } from './browser.mjs';

const [file, picture, step, node, width = 1280, height = 800] = process.argv.slice(2);
const { page, problems, close } = await openPage(file, { width: Number(width), height: Number(height) });
await page.evaluate(([number, name]) => {
  const { state } = window.spokeViewer;
  state.setStep(state.recording.trace.steps.findIndex((entry) => String(entry.number) === number));
  state.select({ node: state.recording.byName.get(name), pass: -1 });
}, [step, node]);
await page.waitForTimeout(600);  // until what glides has come to rest
await page.screenshot({ path: picture });
await close();
if (problems.length > 0) throw new Error(problems.join('\n'));
