// The page of an equilibrium: one view, its deflections magnified at will. Uses steady_states.js,
// fit_view.js and scene_view.js.

function startPage() {
  const states = new SteadyStates(JSON.parse(document.getElementById('steady-data').textContent));
  const { scene, bounds } = states;
  const state = states.at(0);
  const settings = { scale: 1, color: 'tree', outline: true, joints: false, loads: true, names: false };
  const camera = makeCamera(scene);
  const canvas = document.getElementById('steady-view');
  const view = new SceneView(canvas, scene, camera, settings, { isInertial: false, bounds });
  const [scale, factor] = ['scale', 'times'].map((name) => document.getElementById(`steady-${name}`));
  const draw = () => {
    factor.textContent = `\u00d7 ${settings.scale}`;
    scale.setAttribute('aria-valuetext', `${settings.scale} times`);
    view.draw(state);
  };
  scale.addEventListener('input', () => {
    settings.scale = Number((10 ** (scale.value / 100)).toPrecision(2));
    draw();
  });
  for (const name of ['outline', 'joints', 'loads', 'names']) {
    const box = document.getElementById(`steady-${name}`);
    box.checked = settings[name];
    box.parentElement.hidden = Array.isArray(scene[name]) && scene[name].length === 0;
    box.addEventListener('change', () => {
      settings[name] = box.checked;
      draw();
    });
  }
  camera.fit = () => fit(scene, state, camera, bounds, canvas);
  camera.reset();
  addLooks(document.getElementById('steady-looks'), camera);
  camera.listen(draw);
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', draw);
  draw();
}

startPage();
