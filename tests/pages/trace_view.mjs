// Looks at an open trace page: where its nodes and slices stand, and what its canvases show.
import assert from 'node:assert/strict';

/** Waits until what was asked for is drawn. */
export const frame = (page) => page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));

/** The place of a node in the graph, or of a slice in a chart, on the screen. */
export async function placeOf(page, where, name, pass = 0) {
  return page.evaluate(([view, node, p]) => {
    const { state, graph, gantts } = window.spokeViewer;
    const number = state.recording.byName.get(node);
    const shown = view === 'graph' ? graph : gantts[0];
    const point = view === 'graph' ? graph.pointOf(number) : gantts[0].pointOf(state.recording.sliceOf(number, state.step, p));
    const box = shown.canvas.getBoundingClientRect();
    return { x: box.x + point.x, y: box.y + point.y };
  }, [where, name, pass]);
}

/** Red, green, blue, alpha of a canvas at a place of the screen; layer 0 = base, 1 = overlay. */
export async function pixel(page, host, layer, { x, y }) {
  return page.evaluate(([id, k, px, py]) => {
    const canvas = document.querySelectorAll(`#${id} canvas`)[k];
    const box = canvas.getBoundingClientRect();
    return [...canvas.getContext('2d').getImageData((px - box.x) * devicePixelRatio, (py - box.y) * devicePixelRatio, 1, 1).data];
  }, [host, layer, x, y]);
}

/** How many pixels of a canvas are drawn; layer 0 = base, 1 = overlay. */
export const drawn = (page, host, layer = 1) => page.evaluate(([id, k]) => {
  const canvas = document.querySelectorAll(`#${id} canvas`)[k];
  const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
  return data.reduce((count, value, at) => count + (at % 4 === 3 && value > 0 ? 1 : 0), 0);
}, [host, layer]);

/** The page fits the window, and no table is cut off at its side. */
export async function checkFit(page) {
  const layout = await page.evaluate(() => ({
    wide: document.documentElement.scrollWidth - innerWidth, high: document.documentElement.scrollHeight - innerHeight,
    clipped: [...document.querySelectorAll('header, #figures, #stagetable, #threadtable, .view > h2')]
      .filter((e) => e.scrollWidth > e.clientWidth + 1).map((e) => e.id || e.textContent),
  }));
  assert.deepEqual(layout, { wide: 0, high: 0, clipped: [] });
}
