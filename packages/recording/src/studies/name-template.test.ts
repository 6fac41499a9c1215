import { describe, expect, it } from 'vitest';
import { labelOf, labelOfNumber, NameTemplate } from './name-template.ts';

const facts = {
  study: 'Touch & feel',
  participant: 'P01',
  session: '1',
  condition: 'with haptics',
  repetition: 2,
  block: 3,
  timeMs: Date.UTC(2026, 2, 4, 23, 59),
};
const format = (text: string, run = 1): string => new NameTemplate(text).format({ ...facts, run });

describe('a template of names', () => {
  it('is that of the Brain Imaging Data Structure when it is empty [ST-12]', () => {
    expect(format('')).toBe('sub-P01_ses-1_task-withHaptics_run-01');
  });

  it('replaces each placeholder by a label [ST-12] [ST-13]', () => {
    expect(format('{study}.{participant}-{run}')).toBe('TouchFeel.P01-01');
    expect(format('{date}_{block}_{repetition}_{participant}{run}', 123)).toBe(
      '20260304_03_02_P01123',
    );
  });

  it.each([
    ['{participant}_{colour}_{run}', /unknown placeholder "\{colour\}".*\{study\}, .*\{date\}/],
    ['{participant}_{}_{run}', /unknown placeholder "\{\}"/],
    ['{Participant}_{run}', /unknown placeholder "\{Participant\}"/],
    ['{__proto__}{participant}{run}', /unknown placeholder/],
    ['{participant}', /does not have \{run\}/],
    ['{run}', /does not have \{participant\}/],
    ['lab/{participant}_{run}', /the text "lab\/"/],
    ['{participant}\\{run}', /the text "\\\\"/],
    ['{participant} {run}', /the text " "/],
    ['{participant}_{run', /does not have \{run\}/],
    ['{participant}_{run}}', /the text "\}"/],
    ['é{participant}_{run}', /the text "é"/],
    ['.{participant}_{run}', /a dot/],
    ['{participant}_{run}.', /a dot/],
  ])('refuses %s [ST-12]', (text, message) => {
    expect(() => new NameTemplate(text)).toThrow(message);
  });

  it('gives the first name that is not taken [ST-14]', () => {
    const template = new NameTemplate('{participant}_{condition}_{run}');
    const taken = new Set(['P01_withHaptics_01', 'P01_withHaptics_02', 'P01_without_03']);
    expect(template.firstFree(facts, taken)).toEqual({ name: 'P01_withHaptics_03', run: 3 });
    const other = { ...facts, condition: 'without' };
    expect(template.firstFree(other, taken)).toEqual({ name: 'P01_without_01', run: 1 });
  });
});

describe('a label', () => {
  it.each([
    ['rest', 'rest'],
    ['eyes closed, 2nd', 'eyesClosed2nd'],
    ['../../etc', 'etc'],
    ['灯', ''],
  ])('of %s is "%s" [ST-13]', (name, label) => {
    expect(labelOf(name)).toBe(label);
  });

  it('of a number has two digits at least [ST-13]', () => {
    expect([1, 12, 123].map(labelOfNumber)).toEqual(['01', '12', '123']);
  });
});
