// Opens traces from files: by the picker, or dropped onto the page. The second one is compared.
import { byId } from './dom';
import { loadText } from './load';
import { Recording } from './recording';
import { State } from './state';
import { Trace } from './trace';

const kShown = 9000;

/** What tells recordings from each other: executor and threads; scenario and formulation unless equal. */
export function namesOf(recordings: Recording[]): string[] {
  const differ = (value: (trace: Trace) => unknown) =>
    recordings.some(({ trace }) => value(trace) !== value(recordings[0].trace));
  const scenarios = differ((trace) => trace.scenario);
  const formulations = differ((trace) => trace.settings.formulation);
  return recordings.map(({ trace }) => {
    const { settings, scenario, threads } = trace;
    const size = String(settings.threads ?? threads.length);  // "3x4" for nested teams
    const text = `${settings.executor}, ${size} ${size === '1' ? 'thread' : 'threads'}`;
    return `${scenarios ? `${scenario}: ` : ''}${text}${formulations ? `, ${settings.formulation}` : ''}`;
  });
}

function tellProblem(text: string): void {
  const host = byId('problem');
  host.textContent = text;
  host.hidden = false;
  setTimeout(() => (host.hidden = true), kShown);
}

async function open(state: State, file: File): Promise<void> {
  try {
    const recording = new Recording(loadText(await file.text()));
    byId('problem').hidden = true;
    const recordings = [...state.recordings.slice(0, 1), recording];
    state.setTraces(recordings, namesOf(recordings));
  } catch (error) {
    tellProblem(`${file.name} cannot be shown: ${(error as Error).message}`);
  }
}

export function installComparison(state: State): void {
  const picker = byId<HTMLInputElement>('file');
  for (const button of ['compare', 'open']) byId(button).addEventListener('click', () => picker.click());
  picker.addEventListener('change', () => {
    const file = picker.files?.[0];
    picker.value = '';
    if (file) void open(state, file);
  });
  byId('remove').addEventListener('click', () => {
    state.setTraces([state.recordings[0]], namesOf([state.recordings[0]]));
    byId('compare').focus();
  });
  const drop = byId('drop');
  const isFile = (event: DragEvent) => event.dataTransfer?.types.includes('Files') ?? false;
  document.addEventListener('dragover', (event) => {
    if (!isFile(event)) return;
    event.preventDefault();
    drop.hidden = false;
  });
  document.addEventListener('dragleave', (event) => {
    if (!event.relatedTarget) drop.hidden = true;
  });
  document.addEventListener('drop', (event) => {
    drop.hidden = true;
    if (!isFile(event)) return;
    event.preventDefault();
    const file = event.dataTransfer?.files[0];
    if (file) void open(state, file);
  });
}
