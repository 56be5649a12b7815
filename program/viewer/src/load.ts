// Traces from files: a trace.html, the data of one, or Chrome trace events with the key "spoke".
import { readTrace, Trace, TraceError } from './trace';

interface ChromeEvent {
  ph: string;
  cat?: string;
  name?: string;
  tid?: number;
  ts?: number;
  dur?: number;
  args?: Record<string, unknown>;
}

/** The position of each thread id in `threads`: by its name, or else by the order of the ids. */
function threadsById(events: ChromeEvent[], threads: string[]): Map<number, number> {
  const byId = new Map<number, number>();
  for (const event of events) {
    if (event.ph !== 'M' || event.name !== 'thread_name') continue;
    const place = threads.indexOf(String(event.args?.name));
    if (place >= 0) byId.set(event.tid ?? 0, place);
  }
  const others = events.filter((event) => event.ph === 'X' && !byId.has(event.tid ?? 0));
  const ids = [...new Set(others.map((event) => event.tid ?? 0))].sort((a, b) => a - b);
  const free = threads.map((_, k) => k).filter((k) => ![...byId.values()].includes(k));
  ids.forEach((id, k) => byId.set(id, free[k] ?? 0));
  return byId;
}

function fromChromeTrace(data: { spoke: Record<string, unknown>; traceEvents: ChromeEvent[] }): Trace {
  const threads = (data.spoke.threads as string[] | undefined) ?? [];
  const nodes = data.traceEvents.filter(
    (event) => event.ph === 'X' && event.cat !== 'step' && event.cat !== 'run' && event.args?.node !== undefined,
  );
  const events = data.traceEvents.filter((event) => event.ph === 'M');
  const byId = threadsById(events.concat(nodes), threads);
  const argument = (key: string) => nodes.map((event) => event.args?.[key] ?? -1);
  return readTrace({
    ...data.spoke,
    slices: {
      node: argument('node'),
      step: argument('step'),
      pass: argument('pass'),
      cluster: argument('cluster'),
      thread: nodes.map((event) => byId.get(event.tid ?? 0)),
      begin_us: nodes.map((event) => event.ts),
      duration_us: nodes.map((event) => event.dur),
    },
  });
}

function dataOfPage(text: string): string {
  const page = new DOMParser().parseFromString(text, 'text/html');
  const data = page.getElementById('spoke-trace')?.textContent;
  if (!data) throw new TraceError('it is a page, but none that holds a trace of Spoke');
  return data;
}

/** Reads the text of a trace.html or trace.json. Throws TraceError with what is wrong. */
export function loadText(text: string): Trace {
  const source = /^\s*</.test(text) ? dataOfPage(text) : text;
  let data: unknown;
  try {
    data = JSON.parse(source);
  } catch (error) {
    throw new TraceError(`it is neither a trace.html nor JSON (${(error as Error).message})`);
  }
  const object = data as Record<string, unknown> | null;
  if (object && Array.isArray(object.traceEvents)) {
    if (!object.spoke) throw new TraceError('these Chrome trace events were not written by Spoke');
    return fromChromeTrace(object as unknown as Parameters<typeof fromChromeTrace>[0]);
  }
  return readTrace(data);
}
