// Light and dark, and the colours of the style sheet for the canvases.

export interface Theme {
  paper: string;
  panel: string;
  ink: string;
  soft: string;
  rule: string;
  waiting: string;
  series: string[];
  share: [number, number, number][];
  font: string;
}

const kKey = 'spoke-theme';

export function readTheme(): Theme {
  const style = getComputedStyle(document.documentElement);
  const value = (name: string) => style.getPropertyValue(name).trim();
  return {
    paper: value('--paper'), panel: value('--panel'), ink: value('--ink'), soft: value('--soft'),
    rule: value('--rule'), waiting: value('--waiting'),
    series: Array.from({ length: 8 }, (_, k) => value(`--s${k}`)),
    share: [rgb(value('--share-least')), rgb(value('--share-middle')), rgb(value('--share-most'))],
    font: getComputedStyle(document.body).fontFamily,
  };
}

/** "#rrggbb" as three numbers. */
export function rgb(hex: string): [number, number, number] {
  const value = parseInt(hex.slice(1), 16);
  return [(value >> 16) & 255, (value >> 8) & 255, value & 255];
}

/** Black or white, whichever is easier to read on a colour. */
export function inkOn([r, g, b]: [number, number, number]): string {
  const linear = [r, g, b].map((c) => (c / 255 <= 0.04045 ? c / 255 / 12.92 : ((c / 255 + 0.055) / 1.055) ** 2.4));
  const luminance = 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2];
  return luminance > 0.2 ? '#10141a' : '#ffffff';
}

function remembered(): string | null {
  try {
    return localStorage.getItem(kKey);
  } catch {
    return null;  // pages opened from a file may have no storage
  }
}

/** Follows the system until the button has chosen; calls `changed` when colours have changed. */
export function installTheme(button: HTMLButtonElement, changed: () => void): void {
  const dark = matchMedia('(prefers-color-scheme: dark)');
  let chosen = remembered();
  const apply = () => {
    const name = chosen ?? (dark.matches ? 'dark' : 'light');
    document.documentElement.dataset.theme = name;
    button.setAttribute('aria-label', name === 'dark' ? 'Use light colours' : 'Use dark colours');
    button.title = button.getAttribute('aria-label') ?? '';
    changed();
  };
  button.addEventListener('click', () => {
    chosen = document.documentElement.dataset.theme === 'dark' ? 'light' : 'dark';
    try {
      localStorage.setItem(kKey, chosen);
    } catch {
      // it then holds until the page is closed
    }
    apply();
  });
  dark.addEventListener('change', apply);
  apply();
}
