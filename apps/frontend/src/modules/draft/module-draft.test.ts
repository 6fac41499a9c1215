// @vitest-environment happy-dom
import { fromJson } from '@ubii/proto';
import { beforeEach, describe, expect, it } from 'vitest';
import { draftProblems } from './draft-problems.ts';
import { draftNames, dropDraft, keepDraft, readDraft } from './draft-store.ts';
import { draftText } from './draft-text.ts';
import { draftOf, isSameDraft, moduleOf } from './module-draft.ts';
import { TEMPLATES } from './templates.ts';
import { splitText } from '../text/module-text.ts';

const module = fromJson('ubii.processing.ProcessingModule', {
  name: 'doubler',
  tags: ['arithmetic'],
  authors: ['Anna'],
  inputs: [
    { internalName: 'number', messageFormat: 'double', description: 'Number to double.' },
    { internalName: 'mode', messageFormat: 'string', choices: ['exact', 'fast'] },
  ],
  outputs: [
    { internalName: 'each', messageFormat: 'ubii.dataStructure.Vector2', isRecordList: true },
  ],
  processingMode: { triggerOnInput: { minDelayMs: 5, allInputsNeedUpdate: true } },
  language: 'JS',
  onProcessingStringified: '(d, inputs) => ({ outputs: {} })',
  extension: { version: '1.2.0', libraries: ['http'] },
});
const draft = draftOf(module);

describe('a draft', () => {
  it('gives back the module it was made of', () => {
    expect(moduleOf(draft)).toEqual(module);
  });

  it('is the same when only the space between callbacks differs', () => {
    expect(isSameDraft(draft, { ...draft, code: `\n\n${draft.code}` })).toBe(true);
    expect(isSameDraft(draft, { ...draft, code: `${draft.code} x` })).toBe(false);
    expect(isSameDraft(draft, { ...draft, tags: [] })).toBe(false);
  });

  it('is the same in whatever order its fields were filled in', () => {
    const [number, mode] = draft.inputs;
    const filled = (io: object) => ({ ...draft, inputs: [number!, { ...mode!, ...io }] });
    const stored = draftOf(moduleOf(filled({ description: 'How.' })));
    expect(isSameDraft(stored, filled({ description: 'How.' }))).toBe(true);
    expect(isSameDraft(draft, filled({ description: 'How.' }))).toBe(false);
    expect(isSameDraft(draft, filled({ description: '' }))).toBe(true);
    expect(isSameDraft(draft, filled({ choices: ['exact'] }))).toBe(false);
  });

  it('is compared with descriptions and choices as text', () => {
    expect(draftText(draft)).toContain('// Input number: double; Number to double.\n');
    expect(draftText(draft)).toContain('// Input mode: string; one of exact, fast\n');
  });

  it('says what is wrong beside the field', () => {
    const io = { name: 'a', format: 'double', isList: false };
    const broken = {
      ...draft,
      name: 'clock',
      inputs: [
        io,
        io,
        { ...io, name: 'two words', description: 'x'.repeat(201) },
        { ...io, name: 'b', format: 'whatever' },
        { ...io, name: 'c', choices: ['a'] },
      ],
      mode: { ...draft.mode, kind: 'frequency', hertz: Number.NaN },
    } as const;
    expect([...draftProblems(broken, new Set(['clock'])).keys()].sort()).toEqual([
      'inputs[1].name',
      'inputs[2].description',
      'inputs[2].name',
      'inputs[3].format',
      'inputs[4].choices',
      'mode.hertz',
      'name',
    ]);
    expect(draftProblems(draft, new Set()).size).toBe(0);
  });

  it.each(TEMPLATES.map(({ title, draft: one }) => [title, one] as const))(
    'begins well: %s',
    (_title, one) => {
      expect(draftProblems(one, new Set()).size).toBe(0);
      expect(splitText(one.code).problems).toEqual([]);
    },
  );
});

describe('unsaved work', () => {
  beforeEach(() => localStorage.clear());

  it('is there again, until it is dropped', () => {
    keepDraft('doubler', { draft, base: undefined });
    expect(readDraft('doubler')).toEqual({ draft, base: undefined });
    expect(draftNames()).toEqual(['doubler']);
    dropDraft('doubler');
    expect(readDraft('doubler')).toBeUndefined();
  });

  it('is nothing when it cannot be read', () => {
    localStorage.setItem('ubii.moduleDraft.a', '{"draft":{"name":3}}');
    localStorage.setItem('ubii.moduleDraft.b', '{');
    expect(readDraft('a')).toBeUndefined();
    expect(readDraft('b')).toBeUndefined();
  });
});
