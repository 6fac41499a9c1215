import type { Study } from '@ubii/proto';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { effectScope, type EffectScope } from 'vue';
import { aStudy } from '../testing/a-study.ts';
import { useStudyDraft, type StudyDraft } from './useStudyDraft.ts';

let scope: EffectScope;
beforeEach(() => {
  vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout'] });
  scope = effectScope();
});
afterEach(() => {
  scope.stop();
  vi.useRealTimers();
});

function edit(save: (study: Study) => Promise<Study | undefined>): StudyDraft {
  return scope.run(() => useStudyDraft(aStudy({ name: 'Taps', revision: 1 }), save))!;
}
/** As the master does: the next revision. */
const accept = async (study: Study): Promise<Study> => ({ ...study, revision: study.revision + 1 });

describe('a draft of a study', () => {
  it('is saved once when changes have ended, with the revision of the last reply', async () => {
    const save = vi.fn(accept);
    const draft = edit(save);
    draft.change({ name: 'Tap' }, 'name');
    draft.change({ name: 'Tap study' }, 'name');
    expect(draft.state.value).toBe('changed');
    await vi.runAllTimersAsync();
    expect(save.mock.calls.map(([{ name, revision }]) => [name, revision])).toEqual([
      ['Tap study', 1],
    ]);
    expect(draft.state.value).toBe('saved');
    draft.change({ notes: 'pilot' });
    await vi.runAllTimersAsync();
    expect(save).toHaveBeenLastCalledWith(expect.objectContaining({ notes: 'pilot', revision: 2 }));
  });

  it('saves a change that is made during a save after that save', async () => {
    const replies: (() => void)[] = [];
    const save = vi.fn(
      (study: Study) =>
        new Promise<Study>((resolve) => replies.push(() => resolve({ ...study, revision: 7 }))),
    );
    const draft = edit(save);
    draft.change({ name: 'One' });
    void draft.flush();
    draft.change({ name: 'Two' });
    await draft.flush();
    expect(save).toHaveBeenCalledOnce();
    replies[0]!();
    await vi.runAllTimersAsync();
    expect(save).toHaveBeenLastCalledWith(expect.objectContaining({ name: 'Two', revision: 7 }));
  });

  it('is not saved while it is invalid, and says which field is', async () => {
    const save = vi.fn(accept);
    const draft = edit(save);
    draft.change({ name: ' ' });
    await vi.runAllTimersAsync();
    expect(save).not.toHaveBeenCalled();
    expect(draft.state.value).toBe('invalid');
    expect(draft.errors.value).toEqual({ name: 'Enter a name.' });
  });

  it('keeps changes that the master refused, until the next change', async () => {
    const save = vi.fn(async () => undefined);
    const draft = edit(save);
    draft.change({ name: 'Other' });
    await vi.runAllTimersAsync();
    expect(draft.state.value).toBe('refused');
    expect(draft.study.value.name).toBe('Other');
    draft.change({ name: 'Again' });
    expect(draft.state.value).toBe('changed');
  });

  it('undoes and redoes gestures, not letters, and saves what is shown then', async () => {
    const save = vi.fn(accept);
    const draft = edit(save);
    for (const name of ['T', 'Ta', 'Tap']) draft.change({ name }, 'name');
    draft.change({ notes: 'pilot' }, 'notes');
    await vi.runAllTimersAsync();
    draft.undo();
    draft.undo();
    expect(draft.study.value).toMatchObject({ name: 'Taps', notes: '', revision: 2 });
    expect(draft.canUndo.value).toBe(false);
    draft.redo();
    expect(draft.study.value).toMatchObject({ name: 'Tap', notes: '' });
    await vi.runAllTimersAsync();
    expect(save).toHaveBeenLastCalledWith(
      expect.objectContaining({ name: 'Tap', notes: '', revision: 2 }),
    );
  });

  it('is saved when its page is left', () => {
    const save = vi.fn(accept);
    edit(save).change({ name: 'Left' });
    scope.stop();
    expect(save).toHaveBeenCalledWith(expect.objectContaining({ name: 'Left' }));
  });
});
