// @vitest-environment happy-dom
import { expect, it } from 'vitest';
import { effectScope } from 'vue';
import { useKeysLast } from './keys-last.ts';

it('follows keys and pointers, and ignores keys that users of a pointer press, too', () => {
  const scope = effectScope();
  const isKeys = scope.run(useKeysLast)!;
  const field = document.createElement('input');
  document.body.append(field);
  const press = (key: string, target: Element = document.body): boolean =>
    target.dispatchEvent(new KeyboardEvent('keydown', { key, bubbles: true }));
  press('Shift');
  press('l', field);
  expect(isKeys.value).toBe(false);
  press('l');
  expect(isKeys.value).toBe(true);
  window.dispatchEvent(new PointerEvent('pointerdown'));
  expect(isKeys.value).toBe(false);
  scope.stop();
  press('l');
  expect(isKeys.value).toBe(false);
  field.remove();
});
