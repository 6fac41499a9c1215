import { isSameDraft, type ModuleDraft } from './module-draft.ts';

/** What is known on both sides. */
export interface Sides {
  readonly draft: ModuleDraft | undefined;
  /** What the draft was made of. */
  readonly base: ModuleDraft | undefined;
  /** What the master has now. */
  readonly stored: ModuleDraft | undefined;
  /** What of the master's was refused already. */
  readonly refused: ModuleDraft | undefined;
}

/**
 * What to do: nothing of one's own would be lost (`take`), both say the same (`same`), both changed
 * (`ask`), it was deleted there (`gone`), or nothing (`keep`).
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
  // A new module of a name that is taken: the field of the name says so
  if (base === undefined) return { kind: 'keep' };
  if (isSameDraft(stored, base)) return { kind: 'keep' };
  if (isSameDraft(stored, draft)) return { kind: 'same', base: stored };
  if (isSameDraft(draft, base)) return { kind: 'take', draft: stored };
  if (refused !== undefined && isSameDraft(stored, refused)) return { kind: 'keep' };
  return { kind: 'ask', theirs: stored };
}
