// @vitest-environment happy-dom
import { afterEach, expect, it } from 'vitest';
import { isSingleKeyShortcut } from './single-key.ts';

afterEach(() => document.body.replaceChildren());

/** Presses C on an element of the page. */
function mayFire(target: string, owner?: string): boolean {
  const find = (selector: string): Element => document.querySelector(selector)!;
  let result = false;
  const listen = (event: KeyboardEvent): void =>
    void (result = isSingleKeyShortcut(event, owner === undefined ? undefined : find(owner)));
  document.addEventListener('keydown', listen);
  find(target).dispatchEvent(new KeyboardEvent('keydown', { key: 'c', bubbles: true }));
  document.removeEventListener('keydown', listen);
  return result;
}

it('a panel in a dialog has keys there, outside of fields and below no other layer', () => {
  document.body.innerHTML =
    '<div role="dialog" data-state="open" id="dialog"><div id="panel"><input><button></button></div></div>';
  expect(mayFire('button', '#panel')).toBe(true);
  expect(mayFire('#dialog', '#panel')).toBe(true);
  expect(mayFire('input', '#panel')).toBe(false);
  expect(mayFire('button')).toBe(false);
  document.body.insertAdjacentHTML('beforeend', '<div role="listbox" data-state="open"></div>');
  expect(mayFire('button', '#panel')).toBe(false);
});
