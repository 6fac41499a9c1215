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
  x: places[node as keyof typeof places] ?? 0,
  y: 0,
});
const found = (typed: string): string[] =>
  connectables(graph, ref(graph, 'source.o'), typed, [], placeOf).map(({ text }) => text);

describe('ports that can be connected', () => {
  it('lists what fits, free sockets first', () => {
    expect(found('')).toEqual(['far · value', 'near · value']);
  });

  it('lists inputs that a module is about before its parameters, then the nearest [SE-70]', () => {
    const two = aGraphOf([
      aModule('source', {}, { o: 'double' }),
      aModule('near', { point: 'vector2', gain: 'double' }),
      aModule('other', { value: 'double' }),
      aModule('far', { value: 'int32' }),
    ]);
    const texts = connectables(two, ref(two, 'source.o'), '', [], placeOf).map(({ text }) => text);
    expect(texts).toEqual(['other · value', 'far · value', 'near · gain']);
  });

  it('leaves out topics that an output would share with another publisher [SE-70]', () => {
    const read = aGraphOf(
      [aModule('source', {}, { o: 'double' }), aModule('near', { v: 'double' })],
      {
        'near.v': '/x',
      },
    );
    const sockets = (published: readonly string[]): string[] => {
      const topics = published.map((topic) => ({ topic, format: 'double' }));
      return connectables(read, ref(read, 'source.o'), '', topics, placeOf).map(({ text }) => text);
    };
    expect(sockets([])).toContain('/x');
    expect(sockets(['/x'])).not.toContain('/x');
  });

  it('finds by words', () => {
    expect(found('NEAR')).toEqual(['near · value']);
    expect(found('turn')).toEqual([]);
  });

  it('says what a wire would replace, and leaves out what is connected', () => {
    const [, near] = connectables(graph, ref(graph, 'source.o'), '', [], placeOf);
    expect(near?.hint).toBe('double, replaces a wire');
    const names = connectables(graph, ref(graph, 'other.o'), '', [], placeOf).map(
      ({ text }) => text,
    );
    expect(names).toEqual(['far · value']);
  });
});
