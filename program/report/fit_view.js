// Fits a view to one state of a scene: its bounds, and the zoom that shows all of it. Uses
// page_tools.js, space_math.js, scene.js and camera.js.

/** The sphere in which a state is. */
function boundsOfState(scene, state) {
  const places = placesOf(scene, state, 1).map((p, k) => ({ p, reach: scene.reachOf(k) }));
  placesOfMeshes(scene, state).forEach((p) => places.push({ p, reach: 0 }));
  places.push({ p: [0, 0, 0], reach: scene.reachOf(-1) });
  const bound = (pick, sign) => [0, 1, 2].map((c) => pick(...places.map(({ p, reach }) => p[c] + sign * reach)));
  return boundsOf(places, bound(Math.min, -1), bound(Math.max, 1), [[0, 0, 0]]);
}

/** The zoom and pan by which all of the model fills the view, seen as it is. */
function fit(scene, state, camera, bounds, canvas) {
  const half = Math.min(canvas.clientWidth, canvas.clientHeight) / 2;
  const basis = camera.basis();
  const low = [Infinity, Infinity];
  const high = [-Infinity, -Infinity];
  const include = (p, reach) => {
    const v = turn(basis, sub(p, bounds.centre));
    for (let c = 0; c < 2; ++c) {
      low[c] = Math.min(low[c], v[c] - reach);
      high[c] = Math.max(high[c], v[c] + reach);
    }
  };
  placesOf(scene, state, 1).forEach((p, k) => include(p, scene.reachOf(k)));
  placesOfMeshes(scene, state).forEach((p) => include(p, 0));
  include([0, 0, 0], scene.reachOf(-1));
  const spans = [canvas.clientWidth, canvas.clientHeight].map((length, c) => (length - 120) / (high[c] - low[c]));
  const pixels = Math.min(...spans.filter((span) => span > 0), 4 * (half / bounds.radius));
  const zoom = (pixels * 1.06 * bounds.radius) / half;
  const pan = [0, 1].map((c) => (-pixels * (low[c] + high[c])) / 2 / half);
  return { zoom, pan };
}
