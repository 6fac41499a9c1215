// @vitest-environment happy-dom
import { mount } from '@vue/test-utils';
import { describe, expect, it } from 'vitest';
import ValueField from './ValueField.vue';
import { choiceOptions, isUnknownChoice } from './choice-options.ts';

const BACKENDS = ['auto', 'wasm', 'cpu'];
const AUTO = '{"string":"auto"}';

function show(json: string | undefined, choices: readonly string[] = BACKENDS, fallback = AUTO) {
  const field = mount(ValueField, {
    props: { format: 'string', json, label: 'Value of backend', optional: true, fallback, choices },
  });
  return {
    field,
    select: field.find('select'),
    options: () => field.findAll('option:not([hidden])').map((option) => option.text()),
    shown: () => field.find('select').element.selectedOptions[0]?.text,
  };
}

describe('an input that understands certain texts [PM-7]', () => {
  it('offers them, and shows its default while none is set', () => {
    const { select, options, shown } = show(undefined);
    expect(select.attributes('aria-label')).toBe('Value of backend');
    expect(options()).toEqual(BACKENDS);
    expect(shown()).toBe('auto');
  });

  it('sets the chosen text as a constant, as one step', async () => {
    const { field, select } = show(undefined);
    await select.setValue('=wasm');
    expect(field.emitted('change')).toEqual([['{"string":"wasm"}']]);
    expect(field.emitted('done')).toHaveLength(1);
  });

  it('can be given back for the default', async () => {
    const { field, shown } = show('{"string":"cpu"}');
    expect(shown()).toBe('cpu');
    await field.get('button').trigger('click');
    expect(field.emitted('change')).toEqual([[undefined]]);
  });

  it('keeps and marks a text that it does not know', () => {
    const { select, options, shown } = show('{"string":"cuda"}');
    expect(shown()).toBe('cuda (unknown)');
    expect(options()).toEqual(['cuda (unknown)', ...BACKENDS]);
    expect(select.attributes('aria-invalid')).toBe('true');
    expect(show('{"string":"cpu"}').select.attributes('aria-invalid')).toBeUndefined();
  });

  it('shows a constant of another format as it is written', () => {
    expect(show('{"double":1}').shown()).toBe('{"double":1} (unknown)');
  });

  it('takes an empty default for a choice', () => {
    const { options, shown } = show('{"string":""}', ['RGB8'], '{"string":""}');
    expect(options()).toEqual(['RGB8', 'empty']);
    expect(shown()).toBe('empty');
  });

  it('is a text field without choices', () => {
    const { field, select } = show('{"string":"cuda"}', []);
    expect(select.exists()).toBe(false);
    expect(field.get('input').element.value).toBe('cuda');
  });
});

describe('the options of choices', () => {
  it('have the default once, also where it is none of the choices', () => {
    const texts = (fallback: string | undefined) =>
      choiceOptions(['a', 'b'], undefined, fallback).map(({ value }) => value);
    expect(texts('{"string":"b"}')).toEqual(['a', 'b']);
    expect(texts('{"string":"c"}')).toEqual(['a', 'b', 'c']);
    expect(texts(undefined)).toEqual(['a', 'b']);
  });

  it('tell constants of inputs that are none of them', () => {
    const port = { choices: ['a'], defaultJson: '{"string":"b"}' };
    const isUnknown = (text: string) => isUnknownChoice(port, JSON.stringify({ string: text }));
    expect(['a', 'b', 'c'].map(isUnknown)).toEqual([false, false, true]);
    expect(isUnknownChoice({}, '{"string":"c"}')).toBe(false);
  });
});
