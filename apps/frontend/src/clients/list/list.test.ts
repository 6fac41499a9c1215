import { describe, expect, it } from 'vitest';
import { columnsThatFit } from '../model/client-columns.ts';
import { aView } from '../testing/a-client.ts';
import { foldKey, listRows } from './list-rows.ts';

const component = (id: string) => ({ id, name: id, topic: `/${id}` });
const devices = [
  { id: 'd1', name: 'pad', components: [component('x'), component('y')] },
  { id: 'd2', name: 'empty', components: [] },
] as never;
const views = [aView('a', {}, { devices }), aView('b')];

describe('listRows', () => {
  it('shows clients alone at first, and their devices with components when unfolded', () => {
    expect(listRows(views, new Set()).map(({ key, isExpanded }) => [key, isExpanded])).toEqual([
      ['a', false],
      ['b', undefined],
    ]);
    const open = listRows(views, new Set(['a']));
    expect(open.map(({ key, level }) => `${level} ${key}`)).toEqual([
      '1 a',
      '2 a d1',
      '3 a d1 x',
      '3 a d1 y',
      '2 a d2',
      '1 b',
    ]);
    expect(open[2]).toMatchObject({ position: 1, setSize: 2 });
  });

  it('folds a device', () => {
    const device = listRows(views, new Set(['a']))[1]!;
    const rows = listRows(views, new Set(['a', foldKey(device)]));
    expect(rows.map(({ key }) => key)).toEqual(['a', 'a d1', 'a d2', 'b']);
  });
});

describe('columnsThatFit', () => {
  it('keeps the most useful columns, in their order', () => {
    expect(columnsThatFit(300)).toEqual([]);
    expect(columnsThatFit(440).map(({ key }) => key)).toEqual(['in', 'out']);
    const wide = columnsThatFit(1400).map(({ key }) => key);
    expect(wide.slice(0, 3)).toEqual(['state', 'trip', 'in']);
    expect(wide.length).toBeGreaterThan(columnsThatFit(900).length);
  });
});
