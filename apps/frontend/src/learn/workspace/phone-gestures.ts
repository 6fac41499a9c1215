import type { Answer } from '../model/lesson.ts';

/** Interval between two simulated key presses, milliseconds: the pad sends each of them. */
const KEY_MS = 40;
const times = (count: number, key: string): string[] => Array.from({ length: count }, () => key);

/** Arrow keys of a gesture: along the edge of the pad, or a single press. */
const GESTURES: Readonly<Record<Extract<Answer, { kind: 'touch' }>['gesture'], string[]>> = {
  circle: [
    ...times(4, 'ArrowRight'),
    ...times(4, 'ArrowUp'),
    ...times(8, 'ArrowLeft'),
    ...times(8, 'ArrowDown'),
    ...times(8, 'ArrowRight'),
    ...times(4, 'ArrowUp'),
    ...times(4, 'ArrowLeft'),
  ],
  tap: ['ArrowRight', 'ArrowLeft'],
};

/** Moves a finger on the pad of the page in a frame, with the keys of the pad. */
export async function touchPad(
  frame: HTMLIFrameElement,
  gesture: keyof typeof GESTURES,
): Promise<void> {
  const pad = frame.contentDocument?.querySelector<HTMLElement>('[role="application"]');
  const view = frame.contentWindow as (Window & typeof globalThis) | null;
  if (!pad || !view) return;
  const press = (key: string): void => {
    pad.dispatchEvent(new view.KeyboardEvent('keydown', { key, shiftKey: true, bubbles: true }));
  };
  for (const key of GESTURES[gesture]) {
    press(key);
    await new Promise((resolve) => setTimeout(resolve, KEY_MS));
  }
  press('Escape');
}
