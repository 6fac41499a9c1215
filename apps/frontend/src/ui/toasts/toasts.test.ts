// @vitest-environment happy-dom
import { mount } from '@vue/test-utils';
import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import UiToast from './UiToast.vue';
import { createToasts, TOAST_MS } from './toasts.ts';

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

it('keeps the newest two', () => {
  const toasts = createToasts();
  for (const text of ['one', 'two', 'three']) toasts.show(text);
  expect(toasts.list.value.map(({ text }) => text)).toEqual(['two', 'three']);
  toasts.dismiss(toasts.list.value[0]!.id);
  expect(toasts.list.value.map(({ text }) => text)).toEqual(['three']);
});

it('has one about a place, which goes when the place is left', () => {
  const toasts = createToasts();
  const texts = (): string[] => toasts.list.value.map(({ text }) => text);
  toasts.show('Copied');
  toasts.show('Connected a', undefined, 'graph');
  toasts.show('Connected b', undefined, 'graph');
  expect(texts()).toEqual(['Copied', 'Connected b']);
  toasts.leave('graph');
  expect(texts()).toEqual(['Copied']);
});

it('leaves after its time, but not while a pointer is on it', async () => {
  const toast = mount(UiToast, { props: { toast: { id: 1, text: 'Copied' } } });
  await toast.trigger('pointerenter');
  vi.advanceTimersByTime(2 * TOAST_MS);
  expect(toast.emitted('dismiss')).toBeUndefined();
  await toast.trigger('pointerleave');
  vi.advanceTimersByTime(TOAST_MS);
  expect(toast.emitted('dismiss')).toHaveLength(1);
});

it('its action runs once and takes it away', async () => {
  const run = vi.fn();
  const toast = mount(UiToast, {
    props: { toast: { id: 1, text: 'Deleted', action: { text: 'Undo', run } } },
  });
  await toast.get('button').trigger('click');
  expect(run).toHaveBeenCalledOnce();
  expect(toast.emitted('dismiss')).toHaveLength(1);
});
