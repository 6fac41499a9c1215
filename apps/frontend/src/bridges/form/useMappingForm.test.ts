import { flushPromises } from '@vue/test-utils';
import { effectScope, shallowRef } from 'vue';
import { afterEach, describe, expect, it, onTestFinished, vi } from 'vitest';
import { applyChange, type MappingChange, type WrittenMapping } from '../model/mapping-changes.ts';
import type { CheckResult, LoadedMappings, SaveResult } from '../useBridgeMappings.ts';
import { useMappingForm } from './useMappingForm.ts';

const heat = { name: 'heat', direction: 'in', foreign: 'heat', topic: '/heat', format: 'double' };
const problem = (member: string, message: string) => ({ index: 0, member, message });

afterEach(() => void vi.useRealTimers());

/** A form over a store in memory. @param before what it edits; `undefined`: a new mapping */
function open(before: WrittenMapping | undefined = heat) {
  vi.useFakeTimers();
  const loaded = shallowRef<LoadedMappings | undefined>({
    protocol: 'mqtt',
    list: [heat],
    revision: 'r1',
    file: 'bridge.json',
    fileExists: true,
    fileProblem: '',
  });
  const answers = {
    check: undefined as CheckResult | undefined,
    save: undefined as SaveResult | undefined,
  };
  const checked: MappingChange[] = [];
  const saved: MappingChange[] = [];
  const store = {
    loaded,
    failure: shallowRef<string>(),
    async check(change: MappingChange) {
      checked.push(change);
      return answers.check;
    },
    async save(change: MappingChange): Promise<SaveResult> {
      if (answers.save !== undefined) return answers.save;
      const changed = applyChange(loaded.value!.list, change);
      return changed === undefined ? { kind: 'conflict' } : { kind: 'saved', index: changed.index };
    },
  };
  const scope = effectScope();
  onTestFinished(() => scope.stop());
  const form = scope.run(() =>
    useMappingForm({
      store,
      protocol: 'mqtt',
      before,
      index: 0,
      onSaved: (change) => saved.push(change),
    }),
  )!;
  const others = (list: readonly WrittenMapping[]): void => {
    loaded.value = { ...loaded.value!, list, revision: 'r2' };
  };
  return { form, answers, checked, saved, others };
}
const pause = async (): Promise<void> => {
  await vi.advanceTimersByTimeAsync(400);
  await flushPromises();
};

describe('form for a mapping', () => {
  it('is checked once after a pause in typing [BR-81]', async () => {
    const { form, checked } = open();
    await pause();
    checked.length = 0;
    for (const topic of ['/h', '/he', '/hea']) form.draft.topic = topic;
    await pause();
    expect(checked).toMatchObject([{ kind: 'replace', mapping: { topic: '/hea' } }]);
  });

  it('shows problems of a field once it was touched, and all when saved', async () => {
    const { form, answers } = open(undefined);
    const problems = [problem('foreign', 'Enter a value.'), problem('topic', 'Enter a value.')];
    answers.check = { problems, matches: [], moreMatches: 0 };
    form.draft.topic = '/x';
    await pause();
    expect([form.errorOf('foreign'), form.errorOf('topic')]).toEqual([undefined, 'Enter a value.']);
    answers.save = { kind: 'refused', problems };
    await form.save();
    expect(form.errorOf('foreign')).toBe('Enter a value.');
  });

  it('shows problems that belong to no field', async () => {
    const { form, answers } = open();
    answers.save = { kind: 'refused', problems: [problem('', 'Each side needs a wildcard.')] };
    await form.save();
    expect(form.otherProblems.value).toEqual(['Each side needs a wildcard.']);
  });

  it('saves over what others made of the mapping only when its author says so [BR-82]', async () => {
    const { form, others, saved } = open();
    const theirs = { ...heat, topic: '/theirs' };
    form.draft.topic = '/mine';
    others([theirs]);
    await form.save();
    expect(form.conflict.value).toEqual({ theirs });
    expect(saved).toEqual([]);
    form.keepMine();
    await flushPromises();
    expect(saved).toMatchObject([{ kind: 'replace', before: theirs, mapping: { topic: '/mine' } }]);
  });

  it('continues with what others made of it', async () => {
    const { form, others } = open();
    form.draft.topic = '/mine';
    others([{ ...heat, topic: '/theirs' }]);
    await form.save();
    form.takeTheirs();
    expect(form.draft.topic).toBe('/theirs');
    expect(form.isUnchanged.value).toBe(true);
  });

  it('adds a mapping again that others removed', async () => {
    const { form, others, saved } = open();
    others([]);
    form.draft.topic = '/mine';
    await form.save();
    expect(form.conflict.value).toEqual({ theirs: undefined });
    form.keepMine();
    await flushPromises();
    expect(saved).toMatchObject([{ kind: 'add', mapping: { topic: '/mine' } }]);
  });
});
