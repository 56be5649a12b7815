// The page of a model that is not simulated: one view, as the model stands at t = 0. Uses page_tools.js,
// scene.js, scene_view.js and fit_view.js.

function startPage() {
  const data = JSON.parse(document.getElementById('model-data').textContent);
  const scene = new Scene(data.scene);
  const numbers = decode(data.groups, Float32Array);
  // A model on a support is drawn in the inertial frame, others in that of the hub.
  const hub = data.hub ? poseBetween(decode(data.hub, Float32Array), 0, 0, 0) : undefined;
  const groups = Array.from({ length: scene.groups }, (_, g) =>
    g === 0 ? hub : poseBetween(numbers, 7 * (g - 1), 7 * (g - 1), 0));
  const state = scene.stateAtRest(groups);
  const settings = { scale: 1, outline: false };
  const camera = makeCamera(scene);
  const canvas = document.getElementById('model-view');
  const bounds = boundsOfState(scene, state);
  const view = new SceneView(canvas, scene, camera, settings, { isInertial: true, bounds });
  for (const name of ['axes', 'joints', 'loads', 'sensors', 'names']) {
    const box = document.getElementById(`model-${name}`);
    settings[name] = box.checked;
    box.parentElement.hidden = Array.isArray(scene[name]) && scene[name].length + (name === 'joints' ? scene.loops.length : 0) === 0;
    box.addEventListener('change', () => {
      settings[name] = box.checked;
      view.draw(state);
    });
  }
  camera.fit = () => fit(scene, state, camera, bounds, canvas);
  camera.reset();
  addLooks(document.getElementById('model-looks'), camera);
  camera.listen(() => view.draw(state));
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => view.draw(state));
  view.draw(state);
}

startPage();
