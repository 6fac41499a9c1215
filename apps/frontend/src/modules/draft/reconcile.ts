import { isSameDraft, type ModuleDraft } from './module-draft.ts';

/** Versions to compare. */
export interface Sides {
  readonly draft: ModuleDraft | undefined;
  /** Version that the draft is based on. */
  readonly base: ModuleDraft | undefined;
  /** Version on the master now. */
  readonly stored: ModuleDraft | undefined;
  /** Version of the master that the user has rejected. */
  readonly refused: ModuleDraft | undefined;
}

/**
 * Action: replace the unchanged draft (`take`), equal versions (`same`), conflict (`ask`), deleted on the master
 * (`gone`), or none (`keep`).
 */
export type Reconciled =
  | { readonly kind: 'take'; readonly draft: ModuleDraft }
  | { readonly kind: 'same'; readonly base: ModuleDraft }
  | { readonly kind: 'ask'; readonly theirs: ModuleDraft }
  | { readonly kind: 'gone' }
  | { readonly kind: 'keep' };

export function reconcile({ draft, base, stored, refused }: Sides): Reconciled {
  if (stored === undefined) return base === undefined ? { kind: 'keep' } : { kind: 'gone' };
  if (draft === undefined) return { kind: 'take', draft: stored };
  // A new module with a name in use: the name's field shows the error.
  if (base === undefined) return { kind: 'keep' };
  if (isSameDraft(stored, base)) return { kind: 'keep' };
  if (isSameDraft(stored, draft)) return { kind: 'same', base: stored };
  if (isSameDraft(draft, base)) return { kind: 'take', draft: stored };
  if (refused !== undefined && isSameDraft(stored, refused)) return { kind: 'keep' };
  return { kind: 'ask', theirs: stored };
}
