import { describe, expect, it } from 'vitest';
import { modifierKey } from './modifier-key.ts';
import { GROUPS, HOME, isOn, isUnder, PAGES } from './pages.ts';
import { matchShortcut, SHORTCUTS } from './shortcuts.ts';

describe('matchShortcut', () => {
  it('finds single keys', () => {
    expect(matchShortcut(undefined, '?').shortcut?.does).toEqual({
      kind: 'open',
      dialog: 'shortcuts',
    });
  });

  it('finds pairs, whatever the case', () => {
    const { pending } = matchShortcut(undefined, 'g');
    expect(pending).toBe('G');
    expect(matchShortcut(pending, 't').shortcut?.does).toEqual({ kind: 'go', to: '/topics' });
  });

  it('lets a key that completes no pair begin again', () => {
    expect(matchShortcut('G', '/').shortcut?.text).toBe('Search or run a command');
    expect(matchShortcut('G', 'g')).toEqual({ pending: 'G' });
    expect(matchShortcut('G', 'Escape')).toEqual({});
  });

  it('no keys mean two things', () => {
    const keys = SHORTCUTS.map((shortcut) => shortcut.keys);
    expect(new Set(keys).size).toBe(keys.length);
  });
});

it('a page stays marked on the pages below it, Home does not', () => {
  expect(isUnder('/examples/mouse-pointer', '/examples')).toBe(true);
  expect(isUnder('/examples-of-old', '/examples')).toBe(false);
  expect(isUnder('/topics', '/')).toBe(false);
  expect(isUnder('/', '/')).toBe(true);
});

it('Clients stay marked on the devices, which belong to them', () => {
  const marked = GROUPS.flatMap(({ pages }) => pages).filter((page) =>
    isOn('/devices/camera', page),
  );
  expect(marked.map(({ title }) => title)).toEqual(['Clients']);
});

it('the navigation has ten entries, and every page has one place', () => {
  const entries = [HOME, ...GROUPS.flatMap(({ pages }) => pages), 'Tools'];
  expect(entries).toHaveLength(10);
  expect(new Set(PAGES.map(({ to }) => to)).size).toBe(PAGES.length);
});

it('the modifier is called as on this machine', () => {
  expect(modifierKey('MacIntel')).toBe('⌘');
  expect(modifierKey('Linux x86_64')).toBe('Ctrl');
});
