// The small label at the pointer.
import { byId } from './dom';

export function installTip(host: HTMLElement, text: () => string): void {
  const tip = byId('tip');
  const hide = () => (tip.hidden = true);
  host.addEventListener('pointermove', (event) => {
    const shown = event.buttons === 0 ? text() : '';
    tip.hidden = shown === '';
    if (tip.hidden) return;
    tip.textContent = shown;
    const { offsetWidth, offsetHeight } = tip;
    const x = event.clientX + 14 + offsetWidth > innerWidth ? event.clientX - offsetWidth - 12 : event.clientX + 14;
    const y = event.clientY + 18 + offsetHeight > innerHeight ? event.clientY - offsetHeight - 12 : event.clientY + 18;
    tip.style.left = `${Math.max(4, x)}px`;
    tip.style.top = `${Math.max(4, y)}px`;
  });
  host.addEventListener('pointerleave', hide);
  host.addEventListener('pointerdown', hide);
}
