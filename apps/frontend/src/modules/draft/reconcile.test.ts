import { describe, expect, it } from 'vitest';
import { reconcile } from './reconcile.ts';
import { TEMPLATES } from './templates.ts';

const base = TEMPLATES[1]!.draft;
const mine = { ...base, description: 'mine' };
const other = { ...base, description: 'theirs' };
const sides = { draft: base, base, stored: base, refused: undefined };

describe('changes of another user', () => {
  it('is taken at once while there is no work on it here', () => {
    expect(reconcile({ ...sides, stored: other })).toEqual({ kind: 'take', draft: other });
    expect(reconcile({ ...sides, draft: undefined, base: undefined })).toEqual({
      kind: 'take',
      draft: base,
    });
  });

  it('is a question when both changed, and asked once', () => {
    const both = { ...sides, draft: mine, stored: other };
    expect(reconcile(both)).toEqual({ kind: 'ask', theirs: other });
    expect(reconcile({ ...both, refused: other })).toEqual({ kind: 'keep' });
  });

  it('is none when both users made the same change, or none', () => {
    expect(reconcile({ ...sides, draft: mine, stored: mine })).toEqual({
      kind: 'same',
      base: mine,
    });
    expect(reconcile({ ...sides, draft: mine })).toEqual({ kind: 'keep' });
  });

  it('may be a deletion; a module that was never saved is not missed', () => {
    expect(reconcile({ ...sides, stored: undefined })).toEqual({ kind: 'gone' });
    expect(reconcile({ ...sides, base: undefined, stored: undefined })).toEqual({ kind: 'keep' });
  });
});
