import type { SaveState } from './useStudyDraft.ts';

/** Whether what is shown is saved, and how that looks. */
export function saveWords(state: SaveState): { readonly text: string; readonly ink: string } {
  switch (state) {
    case 'saved':
      return { text: 'Saved', ink: 'ink-3' };
    case 'invalid':
      return { text: 'Not saved. Correct the marked fields.', ink: 'ink-err' };
    case 'refused':
      return { text: 'Not saved. Correct what the master reports, or discard.', ink: 'ink-err' };
    default:
      return { text: 'Saving', ink: 'ink-3' };
  }
}
