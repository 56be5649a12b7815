// The pages that the program writes for the shipped rotor. SPOKE_PROGRAM and SPOKE_SCENARIO name both.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { openPage } from './browser.mjs';
import { checkFit, drawn, frame, pixel, placeOf } from './trace_view.mjs';

const folder = mkdtempSync(join(tmpdir(), 'spoke-rotor-'));
after(() => rmSync(folder, { recursive: true }));

const run = (...command) => execFileSync(process.env.SPOKE_PROGRAM, command, { encoding: 'utf8' });

/** The executors of this build. */
const executors = run('trace', '--help').match(/--executor NAME:\{([\w,]+)\}/)[1].split(',');

/** Traces the rotor; the folder of the files, and the slices of nodes, the steps and the stages of its trace.json. */
function trace(name, ...options) {
  const out = join(folder, name);
  run('trace', process.env.SPOKE_SCENARIO, '--from', '0.1', '--out', out, ...options);
  const { traceEvents, spoke } = JSON.parse(readFileSync(join(out, 'trace.json'), 'utf8'));
  const slices = traceEvents.filter((event) => event.ph === 'X' && event.cat !== 'step' && event.cat !== 'run');
  return { out, slices, steps: spoke.steps.map(({ step }) => step), stages: spoke.stages };
}

const sumOf = (slices) => slices.reduce((total, slice) => total + slice.dur, 0);

/** A time as the page writes it, rounded, with a unit. */
function checkTime(text, expected) {
  const [, number, unit] = text.match(/^([\d.]+) (µs|ms|s)/);
  const scale = { µs: 1, ms: 1e3, s: 1e6 }[unit];
  const lastDigit = 10 ** -(number.split('.')[1] ?? '').length;
  assert.ok(Math.abs(Number(number) - expected / scale) <= 0.501 * lastDigit, `${text}, not ${expected} µs`);
}

/** The table of stages shows these slices. */
async function checkStages(page, stages, slices) {
  const rows = await page.$$eval('#stagetable tbody tr', (found) => found.map((row) => ({
    stage: row.dataset.stage,
    texts: [...row.querySelectorAll('td')].slice(0, 2).map((cell) => cell.textContent),
    values: [...row.querySelectorAll('[data-value]')].slice(0, 2).map((cell) => Number(cell.dataset.value)),
  })));
  const byStage = stages.map((stage) => [stage, slices.filter((slice) => slice.cat === stage)]).filter(([, own]) => own.length > 0);
  assert.deepEqual(rows.map(({ stage }) => stage), byStage.map(([stage]) => stage));
  byStage.forEach(([stage, own], k) => {
    const { texts, values } = rows[k];
    assert.deepEqual([texts[0], values[0]], [String(own.length), own.length], stage);
    assert.ok(Math.abs(values[1] - sumOf(own)) < 1e-6, `${stage}: ${values[1]}, not ${sumOf(own)}`);
    checkTime(texts[1], sumOf(own));
  });
  assert.equal(await page.textContent('#stagetable tfoot td'), String(slices.length));
  checkTime(await page.textContent('#stagetable tfoot td:nth-child(3)'), sumOf(slices));
}

const recordings = executors.map((executor) => [executor, ['--executor', executor, '--threads', '2']]);
recordings.push(['flow_graph, windows of steps', ['--executor', 'flow_graph', '--threads', '2', '--window', '4']]);
for (const scheme of executors.filter((executor) => executor.startsWith('openmp_scheme'))) {
  recordings.push([`${scheme}, nested teams`, ['--executor', scheme, '--threads', '2x2']]);
}

/** The table of a page, for some steps one by one and for all. */
async function checkTables(page, { slices, steps, stages }) {
  assert.ok(steps.length === 20 && slices.length >= 60 * 20, `${slices.length} slices of ${steps.length} steps`);
  assert.match(await page.textContent('#stepname'), /, the median\)/);
  await page.focus('#step');
  await page.keyboard.press('Home');
  for (const step of steps.slice(0, 5)) {
    assert.match(await page.textContent('#stepname'), new RegExp(`^step ${step} `));
    await checkStages(page, stages, slices.filter(({ args }) => args.step === step));
    await page.keyboard.press(']');
  }
  await page.click('#scope button:has-text("all steps")');
  await checkStages(page, stages, slices);
}

test('the table of stages holds the slices of trace.json', { timeout: 120000 }, async (t) => {
  const recorded = recordings.map(([name, options]) => [name, trace(name.replaceAll(/\W+/g, '_'), ...options)]);
  const { page, problems, close } = await openPage(join(recorded[0][1].out, 'trace.html'));
  try {
    for (const [name, files] of recorded) {
      await page.goto(pathToFileURL(join(files.out, 'trace.html')).href);
      await t.test(name, () => checkTables(page, files));
    }
    assert.deepEqual(problems, []);
  } finally {
    await close();
  }
});

/** Shows the step that other programs disturbed least; its number. The hub's solution, a few nanoseconds, is longer there
 * than a step of the machine's counter: a slice without length has no place for its colour. */
const showShortestStep = (page) => page.evaluate(() => {
  const { state } = window.spokeViewer;
  const { steps, slices } = state.recording.trace;
  const hub = state.recording.byName.get('hub solve');
  const length = (k) => (slices.duration[state.recording.sliceOf(hub, k, 0)] > 0 ? state.recording.analysis(k).makespan : Infinity);
  state.setStep(steps.reduce((best, _, k) => (length(k) < length(best) ? k : best), 0));
  return steps[state.step].number;
});

/** Shows the slice of a node a third as wide as the chart, or with null the whole step. */
async function zoomTo(page, name) {
  await page.evaluate((wanted) => {
    const { state: { recording, step }, window: shown } = window.spokeViewer;
    if (wanted === null) return shown.fit(false);
    const slice = recording.sliceOf(recording.byName.get(wanted), step, 0);
    const { begin, duration } = recording.trace.slices;
    const [from, width] = [begin[slice] - recording.analysis(step).begin, Math.max(duration[slice], 0.01)];
    return shown.show(from - width, from + 2 * width, false);
  }, name);
  await frame(page);
}

/** Whether a node in the graph, or its slice of the first pass in the chart, has its stage's full colour. */
async function isBright(page, where, name) {
  if (where === 'gantt0') await zoomTo(page, name);
  const place = await placeOf(page, where, name);
  return page.evaluate(([host, node, { x, y }]) => {
    const { graph: { palette }, state: { recording: { trace, byName } } } = window.spokeViewer;
    const { plain } = palette.stage(trace.stages[trace.graph.stage[byName.get(node)]]);
    const canvas = document.querySelector(`#${host} canvas`);
    const box = canvas.getBoundingClientRect();
    const { data } = canvas.getContext('2d').getImageData(x - box.x - 5, y - box.y - 5, 11, 11);
    let count = 0;  // beside the letters of its name
    for (let k = 0; k < data.length; k += 4) {
      count += plain === `#${[...data.slice(k, k + 3)].map((part) => part.toString(16).padStart(2, '0')).join('')}`;
    }
    return count >= 20;
  }, [where, name, place]);
}

async function checkDrawing(page) {
  assert.equal(await page.textContent('h1'), 'wu_haug_rotor');
  assert.match(await page.textContent('#graphnote'), /61 nodes, 78 edges/);
  assert.equal((await page.$$('#morethreads tbody tr')).length, 7);
  await checkFit(page);
  for (const where of ['graph', 'gantt0']) {
    assert.ok(await drawn(page, where, 0) > 1000, where);
    for (const name of ['hub solve', 'blade 1 / position', 'blade 2 / body 4 / mass', 'blade 3 / body 1 / recovery']) {
      assert.ok(await isBright(page, where, name), `${name} in ${where}`);
    }
  }
  await zoomTo(page, null);
}

async function checkHovering(page) {
  const name = 'blade 2 / body 3 / inverse';
  const passes = await page.evaluate((wanted) => {
    const { recording, step } = window.spokeViewer.state;
    return recording.slicesOfNode(recording.byName.get(wanted), step).map((slice) => recording.trace.slices.pass[slice]);
  }, name);
  assert.equal(passes[0], 0);
  const [before, node] = [await placeOf(page, 'graph', 'blade 2 / body 3 / mass'), await placeOf(page, 'graph', name)];
  const middle = { x: (node.x + before.x) / 2, y: (node.y + before.y) / 2 };
  await page.mouse.move(before.x, before.y);
  await frame(page);
  assert.deepEqual((await pixel(page, 'graph', 1, middle)).slice(0, 3), [213, 94, 0], 'the edge to what waits for it is orange');
  await page.mouse.move(node.x, node.y);
  await frame(page);
  assert.deepEqual((await pixel(page, 'graph', 1, middle)).slice(0, 3), [0, 114, 178], 'the edge from what it waits for is blue');
  for (const pass of passes) {
    const slice = await placeOf(page, 'gantt0', name, pass);
    assert.equal((await pixel(page, 'gantt0', 1, slice))[3], 255, `slice of pass ${pass + 1}`);
  }
  assert.match(await page.textContent('#tip'), /blade 2 \/ body 3 \/ inverse\s*pass 1/);
  await page.mouse.move(5, 5);
  await frame(page);
  assert.equal(await drawn(page, 'graph'), 0);
  assert.equal(await drawn(page, 'gantt0'), 0);
}

async function checkFilters(page) {
  const names = ['blade 1 / body 1 / mass', 'blade 2 / body 1 / mass', 'blade 1 / body 1 / inverse'];
  const look = async () => {
    await frame(page);
    const found = [];
    for (const where of ['graph', 'gantt0']) for (const name of names) found.push(await isBright(page, where, name));
    return found;
  };
  assert.deepEqual(await look(), [true, true, true, true, true, true]);
  await page.click('#stages button:has-text("mass")');
  await page.click('#subsystems button:has-text("1")');
  assert.deepEqual(await look(), [true, false, false, true, false, false]);
  await page.click('#clear');
  assert.deepEqual(await look(), [true, true, true, true, true, true]);
  await zoomTo(page, null);
}

/** Compares the page's trace with another one from a file. */
async function checkComparison(page, step, own, other, file) {
  await page.setInputFiles('#file', join(other.out, file));
  await page.waitForFunction(() => /serial/.test(document.querySelector('#chartname1').textContent));
  await frame(page);
  await checkFit(page);
  for (const [row, { slices }] of [['A', own], ['B', other]]) {
    const work = sumOf(slices.filter(({ args }) => args.step === step));
    checkTime(await page.textContent(`#figures tr[data-trace=${row}] td[data-figure="T1, work"]`), work);
  }
  const node = await placeOf(page, 'graph', 'blade 1 / effective');
  await page.mouse.move(node.x, node.y);
  await frame(page);
  for (const where of ['gantt0', 'gantt1']) {
    assert.ok(await drawn(page, where, 0) > 1000, `${where} is drawn`);
    assert.ok(await drawn(page, where) > 0, `highlighted in ${where}`);
  }
  await page.mouse.move(5, 5);
  await page.click('#remove');
  assert.equal(await page.isVisible('#chart1'), false);
  await frame(page);
}

test('the page of the shipped rotor', { timeout: 120000 }, async (t) => {
  const rotor = trace('rotor', '--executor', 'flow_graph', '--threads', '2');
  const serial = trace('one_thread', '--executor', 'serial');
  for (const [width, height] of [[1280, 800], [1920, 1080]]) {
    const { page, problems, close } = await openPage(join(rotor.out, 'trace.html'), { width, height });
    try {
      const step = await showShortestStep(page);
      await frame(page);
      await t.test(`is drawn, ${width} x ${height}`, () => checkDrawing(page));
      await t.test(`highlights edges and slices of a node, ${width} x ${height}`, () => checkHovering(page));
      await t.test(`fades what filters leave out, ${width} x ${height}`, () => checkFilters(page));
      for (const file of ['trace.html', 'trace.json']) {
        await t.test(`is compared with a ${file}, ${width} x ${height}`,
          () => checkComparison(page, step, rotor, serial, file));
      }
      assert.deepEqual(problems, []);
    } finally {
      await close();
    }
  }
});
