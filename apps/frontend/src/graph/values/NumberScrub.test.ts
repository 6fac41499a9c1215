// @vitest-environment happy-dom
import { mount } from '@vue/test-utils';
import { describe, expect, it } from 'vitest';
import { nextTick } from 'vue';
import NumberScrub from './NumberScrub.vue';

function field(props: { value?: number; range?: { min: number; max: number } } = {}) {
  const wrapper = mount(NumberScrub, { props: { value: 0.5, label: 'x', ...props } });
  const input = wrapper.get('input');
  return {
    input,
    async type(text: string): Promise<void> {
      await input.setValue(text);
      await input.trigger('blur');
    },
    press: (key: string) => input.trigger('keydown', { key }),
    changed: () => wrapper.emitted('change')?.map(([value]) => value) ?? [],
    problem: () => wrapper.emitted('problem')?.at(-1)?.[0],
  };
}

describe('a number with a range', () => {
  const range = { min: 0, max: 1 };

  it('does not take what is outside of it, and says the range until it is corrected', async () => {
    const { input, type, changed, problem } = field({ range });
    await type('5');
    expect(changed()).toEqual([]);
    expect(problem()).toBe('x is 0 to 1, not 5.');
    expect(input.element.value).toBe('5');
    await type('0.7');
    expect(changed()).toEqual([0.7]);
    expect(problem()).toBeUndefined();
  });

  it('stops at its ends when it is stepped', async () => {
    const { input, changed } = field({ value: 1, range });
    await input.trigger('keydown', { key: 'ArrowUp' });
    expect(changed()).toEqual([1]);
  });
});

it('keeps a text that is no number, and why, and takes back what Escape cancels', async () => {
  const { input, type, changed, problem } = field();
  await type('abc');
  expect(changed()).toEqual([]);
  expect(problem()).toBe('Enter a number, such as 0.5.');
  await input.trigger('keydown', { key: 'Escape' });
  expect(input.element.value).toBe('0.5');
  expect(problem()).toBeUndefined();
});

it('takes back a refused text by Ctrl Z, and leaves other steps to the history of the graph', async () => {
  const { input, type, problem } = field();
  await type('abc');
  const first = new KeyboardEvent('keydown', { key: 'z', ctrlKey: true, cancelable: true });
  input.element.dispatchEvent(first);
  await nextTick();
  expect(first.defaultPrevented).toBe(true);
  expect(input.element.value).toBe('0.5');
  expect(problem()).toBeUndefined();
  const next = new KeyboardEvent('keydown', { key: 'z', ctrlKey: true, cancelable: true });
  input.element.dispatchEvent(next);
  expect(next.defaultPrevented).toBe(false);
});

it('keeps the focus when Enter takes a number, and when Escape cancels one', async () => {
  const { input, press, changed } = field();
  document.body.append(input.element);
  input.element.focus();
  await input.setValue('0.7');
  await press('Enter');
  expect(changed()).toEqual([0.7]);
  expect(document.activeElement).toBe(input.element);
  await input.setValue('0.9');
  await press('Escape');
  expect(input.element.value).toBe('0.5');
  expect(document.activeElement).toBe(input.element);
  input.element.remove();
});
