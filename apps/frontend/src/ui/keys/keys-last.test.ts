// @vitest-environment happy-dom
import { expect, it } from 'vitest';
import { effectScope } from 'vue';
import { useKeysLast } from './keys-last.ts';

it('follows keys and pointers, and ignores keys that are held while a pointer works', () => {
  const scope = effectScope();
  const isKeys = scope.run(useKeysLast)!;
  const press = (key: string): boolean =>
    window.dispatchEvent(new KeyboardEvent('keydown', { key }));
  press('Shift');
  expect(isKeys.value).toBe(false);
  press('l');
  expect(isKeys.value).toBe(true);
  window.dispatchEvent(new PointerEvent('pointerdown'));
  expect(isKeys.value).toBe(false);
  scope.stop();
  press('l');
  expect(isKeys.value).toBe(false);
});
