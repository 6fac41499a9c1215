import { describe, expect, it } from 'vitest';
import { isNewcomer, thingAt, withRecent, type RecentThing } from './recent.ts';

const thing = (id: string, atMs = 0): RecentThing => ({ id, title: id, path: '', atMs });

describe('thingAt()', () => {
  it.each([
    ['/sessions/3f2a', 'session 3f2a'],
    ['/sessions/3f2a/graph', 'session 3f2a'],
    ['/modules/low%20pass/edit', 'module low pass'],
    ['/recordings/r1', 'recording r1'],
    ['/examples/mouse-pointer', 'example mouse-pointer'],
    ['/party', 'example party'],
    ['/panels', 'panels'],
    ['/modules/%E0%A4%A', 'module %E0%A4%A'],
  ])('%s shows %s', (path, id) => {
    expect(thingAt(path)).toBe(id);
  });

  it.each(['/', '/sessions', '/sessions/new', '/sessions/new/text', '/topics/a', '/settings'])(
    '%s shows no thing',
    (path) => {
      expect(thingAt(path)).toBeUndefined();
    },
  );
});

describe('withRecent()', () => {
  it('puts what was opened first, once', () => {
    const before = [thing('session b'), thing('module a', 1)];
    expect(withRecent(before, thing('module a', 2)).map(({ id, atMs }) => [id, atMs])).toEqual([
      ['module a', 2],
      ['session b', 0],
    ]);
  });

  it('keeps name and address of what the palette opened again', () => {
    const opened = { ...thing('session a'), title: 'Waves', path: '/sessions/a' };
    expect(withRecent([opened], { ...thing('session a', 5), title: '' })).toEqual([
      { ...opened, atMs: 5 },
    ]);
  });

  it('keeps a session, however much else is opened afterwards', () => {
    let things = [thing('session a')];
    for (let index = 0; index < 40; index++) things = withRecent(things, thing(`page ${index}`));
    expect(things.map(({ id }) => id)).toContain('session a');
    expect(things).toHaveLength(7);
  });
});

it('a browser is new until it has opened a session or an example', () => {
  expect(isNewcomer([thing('module clock'), thing('page /settings')])).toBe(true);
  expect(isNewcomer([thing('module clock'), thing('example party')])).toBe(false);
  expect(isNewcomer([thing('session 3f2a')])).toBe(false);
});
