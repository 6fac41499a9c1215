import { fromJson, type ProcessingModule } from '@ubii/proto';
import { expect, it } from 'vitest';
import { aSession } from '../../../sessions/testing/a-session.ts';
import { graphOf } from '../../model/graph-of.ts';
import { paletteEntries, wantedFormat } from './palette-entries.ts';

const module = (name: string, input: string): ProcessingModule =>
  fromJson('ubii.processing.ProcessingModule', {
    name,
    inputs: [{ internalName: 'value', messageFormat: input }],
    outputs: [{ internalName: 'out', messageFormat: input }],
  });
const sources = { modules: [module('low-pass', 'double'), module('turn', 'vector2')], topics: [] };
const graph = graphOf(aSession());
const end = { node: 'module:module', port: 'out:mirrored' };
const [wire] = graph.wires.keys();

it('what does not fit the wire is last, with the reason, once the filter is removed', () => {
  for (const wish of [{ end }, { wire }]) {
    const filtered = paletteEntries(graph, sources, '', { ...wish, isFiltered: true, recent: [] });
    expect(filtered.map(({ text }) => text)).toContain('turn');
    expect(filtered.map(({ text }) => text)).not.toContain('low-pass');
    const all = paletteEntries(graph, sources, '', { ...wish, isFiltered: false, recent: [] });
    expect(all.slice(0, filtered.length)).toEqual(filtered);
    expect(all.find(({ text }) => text === 'low-pass')?.misfit).toBe('Does not fit vector2.');
    expect(new Set(all.map(({ text }) => text)).size).toBe(all.length);
  }
});

it('favourites are first, with a wire, too', () => {
  const two = [...sources.modules, module('mirror', 'vector2'), module('swap', 'vector2')];
  const first = (wish: object): string | undefined =>
    paletteEntries(graph, { ...sources, modules: two }, '', {
      isFiltered: true,
      recent: ['turn'],
      favourites: ['swap'],
      ...wish,
    }).find(({ offer, item }) => (offer ?? item)?.kind === 'module')?.text;
  expect(first({})).toBe('swap');
  expect(first({ end })).toBe('swap');
  expect(first({ wire })).toBe('swap');
});

it('without a wire nothing is required', () => {
  const wish = { isFiltered: true, recent: [] };
  expect(wantedFormat(graph, wish)).toBe('');
  expect(paletteEntries(graph, sources, 'low', wish)[0]?.misfit).toBeUndefined();
});
