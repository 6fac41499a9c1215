// @vitest-environment happy-dom
import { afterEach, beforeEach, expect, it } from 'vitest';
import { effectScope, nextTick, type EffectScope } from 'vue';
import { applyTheme, useThemeChoice } from './useTheme.ts';

let scope: EffectScope;
beforeEach(() => {
  localStorage.clear();
  scope = effectScope();
});
afterEach(() => scope.stop());

it('the system decides until a person does, and the choice is kept', async () => {
  const root = document.documentElement;
  const choice = scope.run(() => {
    applyTheme(root);
    return useThemeChoice();
  })!;
  expect(root.dataset['theme']).toBeUndefined();
  choice.value = 'light';
  await nextTick();
  await nextTick();
  expect(root.dataset['theme']).toBe('light');
  expect(localStorage.getItem('ubii.theme')).toBe('light');
  choice.value = 'system';
  await nextTick();
  await nextTick();
  expect(root.dataset['theme']).toBeUndefined();
});
