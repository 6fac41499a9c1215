import type { MenuAction, MenuEntry } from '../canvas/menu/menu-entry.ts';

const CANVAS_ONLY: ReadonlySet<string> = new Set(['collapse', 'group', 'setFrame', 'hideTopic']);
const CANVAS_REQUESTS: ReadonlySet<string> = new Set(['copy', 'cut', 'selectMore']);

/** Returns the menu entries that make sense without a canvas. */
export function listEntries(entries: readonly MenuEntry[]): MenuAction[] {
  return entries.flatMap((entry) => {
    if (entry.kind !== 'action') return [];
    const isOnCanvas =
      CANVAS_ONLY.has(entry.command?.kind ?? '') || CANVAS_REQUESTS.has(entry.request?.kind ?? '');
    return isOnCanvas ? [] : [entry];
  });
}
