// The page of an equilibrium: one view, its deflections magnified at will. Uses steady_states.js,
// fit_view.js and scene_view.js.

/** The largest value of each kind of colours that solids show. */
function largestOf(scene, state) {
  const largest = (values) => values?.reduce((most, value) => Math.max(most, value), 0) ?? 0;
  const most = (valuesOf) => Math.max(0, ...scene.meshes.map((_, m) => largest(valuesOf(m))));
  return {
    displacement: most((m) => meshDisplacements(scene, state, m)),
    von_mises: most((m) => state.solids[m].vonMises()),
  };
}

function startPage() {
  const states = new SteadyStates(JSON.parse(document.getElementById('steady-data').textContent));
  const { scene, bounds } = states;
  const state = states.at(0);
  const settings = { scale: 1, color: 'tree', outline: true, joints: false, loads: true, names: false };
  const camera = makeCamera(scene);
  const canvas = document.getElementById('steady-view');
  const most = largestOf(scene, state);
  const colors = (shown) => new SceneColors(scene, shown, settings.color, most[settings.color]);
  const view = new SceneView(canvas, scene, camera, settings, { isInertial: false, bounds, colors });
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
  const color = document.getElementById('steady-color');
  for (const option of [...color.options])
    if (option.value !== 'tree' && !(most[option.value] > 0)) option.remove();
  color.parentElement.hidden = color.options.length < 2;
  color.addEventListener('change', () => {
    settings.color = color.value;
    showScale(document.getElementById('steady-colors'), color.value, most[color.value]);
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
