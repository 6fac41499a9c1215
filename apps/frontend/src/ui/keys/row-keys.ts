/** Action of a key on the focused row. */
export type RowIntent = 'toggle' | 'rename' | 'remove';

const INTENTS: Readonly<Record<string, RowIntent>> = {
  ' ': 'toggle',
  F2: 'rename',
  Delete: 'remove',
};

const links = (list: HTMLElement): HTMLElement[] => [
  ...list.querySelectorAll<HTMLElement>('[data-row-link]'),
];

function neighbour(list: HTMLElement, from: HTMLElement, key: string): HTMLElement | undefined {
  const all = links(list);
  const at = all.indexOf(from);
  switch (key) {
    case 'ArrowDown':
      return all[at + 1];
    case 'ArrowUp':
      return all[at - 1];
    case 'Home':
      return all[0];
    case 'End':
      return all.at(-1);
    default:
      return undefined;
  }
}

/**
 * Moves the focus along a list of rows, and returns other actions of keys.
 * @returns the index of the row and the action, if the key has one
 */
export function handleRowKey(
  event: KeyboardEvent,
): { readonly index: number; readonly intent: RowIntent } | undefined {
  const { currentTarget: list, target } = event;
  if (!(list instanceof HTMLElement) || !(target instanceof HTMLElement)) return undefined;
  if (!target.matches('[data-row-link]') || event.ctrlKey || event.metaKey || event.altKey) {
    return undefined;
  }
  const next = neighbour(list, target, event.key);
  const intent = INTENTS[event.key];
  if (next === undefined && intent === undefined) return undefined;
  event.preventDefault();
  next?.focus();
  return intent && { index: links(list).indexOf(target), intent };
}
