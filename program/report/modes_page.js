// The page of modes, over several speeds that of a Campbell diagram: the diagram, damping, and the shape of
// the mode that is chosen. Uses speed_plot.js and mode_view.js.

/** A legend whose keys hide branches, and say which is which. */
function addLegend(host, choice) {
  choice.branches.forEach((branch) => {
    const swatch = make('canvas', { className: 'swatch', width: 44, height: 12 });
    const key = make('button', { type: 'button', 'aria-pressed': 'true' }, [swatch, make('span', { textContent: `${branch.of}: ${branch.name}` })]);
    key.addEventListener('click', () => {
      branch.isShown = !branch.isShown;
      key.setAttribute('aria-pressed', String(branch.isShown));
      choice.changed();
    });
    host.append(key);
    choice.listen(() => drawSwatch(swatch, branch.color));
  });
}

/** Lists of branches and of speeds, for whom the diagram is not at hand. */
function addLists(choice) {
  const [branch, speed] = ['mode', 'speed'].map((name) => document.getElementById(`mode-${name}`));
  choice.branches.forEach(({ of, name }, b) => branch.append(make('option', { value: String(b), textContent: `${of}: ${name}` })));
  choice.states.forEach((_, k) => speed.append(make('option', { value: String(k), textContent: choice.valueText(k) })));
  speed.parentElement.hidden = choice.states.length < 2;
  branch.addEventListener('change', () => choice.choose(Number(branch.value), choice.speed));
  speed.addEventListener('change', () => choice.choose(choice.branch, Number(speed.value)));
  choice.listen(() => {
    branch.value = String(choice.branch);
    speed.value = String(choice.speed);
  });
}

/** The diagram, and damping where there is some. */
function addPlots(data, choice, say) {
  const range = new SpeedRange(choice.states.map(({ value }) => value));
  const critical = data.critical && choice.states[data.critical.state].value;
  const shown = data.shown && [0, data.shown];
  const frequencies = { valueOf: (mode) => mode.frequency, harmonics: data.harmonics, shown, critical };
  const diagram = new SpeedPlot(document.getElementById('campbell'), choice, range, frequencies, say);
  const damping = document.getElementById('campbell-damping');
  if (damping) new SpeedPlot(damping, choice, range, { valueOf: (mode) => mode.damping }, say);
  const growth = document.getElementById('campbell-growth');
  if (growth) new SpeedPlot(growth, choice, range, { valueOf: (mode) => mode.growth, critical }, say);
  const reset = document.getElementById('campbell-reset');
  reset.addEventListener('click', () => diagram.reset());
  document.getElementById('campbell-all').addEventListener('click', () => diagram.showAll());
  const centre = ([a, b]) => 0.5 * (a + b);
  const zoom = (factor) => diagram.zoom(factor, centre(range.view), centre(diagram.view));
  document.getElementById('campbell-in').addEventListener('click', () => zoom(0.7));
  document.getElementById('campbell-out').addEventListener('click', () => zoom(1 / 0.7));
  choice.listen(() => (reset.disabled = !diagram.isZoomed));
  addLegend(document.getElementById('campbell-legend'), choice);
}

function startPage() {
  const data = JSON.parse(document.getElementById('steady-data').textContent);
  const states = new SteadyStates(data);
  const choice = new ModeChoice(data.branches, states.states, data.varied);
  const region = document.getElementById('spoken');
  const say = (text) => (region.textContent = text);
  const text = document.getElementById('mode-text');
  choice.listen(({ hovered, branch, speed }) => {
    text.textContent = hovered ? choice.describe(hovered.branch, hovered.speed) : choice.describe(branch, speed);
  });
  if (document.getElementById('campbell')) addPlots(data, choice, say);
  addLists(choice);
  const view = new ModeView(document.getElementById('mode-view'), states, choice);
  // Choose the critical mode, or one that oscillates, if there is one.
  const middle = Math.floor(choice.states.length / 2);
  const first = choice.branches.findIndex((_, b) => choice.modeOf(b, middle)?.frequency > 0);
  choice.choose(data.critical?.branch ?? Math.max(first, 0), data.critical?.state ?? middle);
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => choice.changed());
  if (!matchMedia('(prefers-reduced-motion: reduce)').matches) view.play();
}

startPage();
