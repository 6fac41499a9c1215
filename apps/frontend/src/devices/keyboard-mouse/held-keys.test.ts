import { describe, expect, it } from 'vitest';
import { HeldKeys, isCaptured } from './held-keys.ts';

describe('keys that are held', () => {
  it('go down once however often the keyboard repeats them', () => {
    const keys = new HeldKeys();
    expect(keys.press('KeyA', 'a')).toBe(true);
    expect(keys.press('KeyA', 'a')).toBe(false);
    expect(keys.release('KeyA')).toBe('a');
    expect(keys.release('KeyA')).toBeUndefined();
  });

  it('come up under the name they went down with', () => {
    const keys = new HeldKeys();
    keys.press('KeyA', 'A');
    expect(keys.release('KeyA')).toBe('A');
  });

  it('are all let go of when the pad is left', () => {
    const keys = new HeldKeys();
    keys.press('KeyA', 'a');
    keys.press('ArrowUp', 'ArrowUp');
    expect(keys.releaseAll()).toEqual(['a', 'ArrowUp']);
    expect([...keys.codes]).toEqual([]);
  });
});

describe('keys of the browser', () => {
  const key = (name: string, held: 'ctrlKey' | 'none' = 'none') =>
    isCaptured({
      key: name,
      ctrlKey: held === 'ctrlKey',
      metaKey: false,
      altKey: false,
    });
  it('stay its own', () => {
    expect(['Tab', 'Escape', 'F5'].map((name) => key(name))).toEqual([false, false, false]);
    expect(key('r', 'ctrlKey')).toBe(false);
    expect(key('Control', 'ctrlKey')).toBe(true);
    expect(['a', 'Enter', ' ', 'F'].map((name) => key(name))).toEqual([true, true, true, true]);
  });
});
