import { describe, expect, it } from 'vitest';
import { aGraphOf, aModule, ref } from '../model/testing/small-graph.ts';
import { connectables } from './connectable.ts';

const graph = aGraphOf(
  [
    aModule('source', {}, { o: 'double' }),
    aModule('near', { value: 'double', turn: 'vector2' }),
    aModule('far', { value: 'double' }),
    aModule('other', {}, { o: 'double' }),
  ],
  { 'other.o': '/x', 'near.value': '/x' },
);
const places = { 'module:source': 0, 'module:near': 100, 'module:far': 900, 'module:other': 50 };
const placeOf = ({ node }: { node: string }) => ({
  x: places[node as keyof typeof places],
  y: 0,
});
const found = (typed: string): string[] =>
  connectables(graph, ref(graph, 'source.o'), typed, placeOf).map(({ text }) => text);

describe('connectables', () => {
  it('lists what fits, free sockets first', () => {
    expect(found('')).toEqual(['far · value', 'near · value']);
  });

  it('finds by words', () => {
    expect(found('NEAR')).toEqual(['near · value']);
    expect(found('turn')).toEqual([]);
  });

  it('says what a wire would replace, and leaves out what is connected', () => {
    const [, near] = connectables(graph, ref(graph, 'source.o'), '', placeOf);
    expect(near?.hint).toBe('double, replaces a wire');
    const names = connectables(graph, ref(graph, 'other.o'), '', placeOf).map(({ text }) => text);
    expect(names).toEqual(['far · value']);
  });
});
