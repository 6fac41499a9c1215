import { describe, expect, it } from 'vitest';
import { aGraphOf, aModule, ref } from '../model/testing/small-graph.ts';
import { connectables, replacedAt } from './connectable.ts';

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

  it('offers what makes a loop at the end, and says so [SE-70]', () => {
    const loop = aGraphOf(
      [
        aModule('source', { v: 'double' }, { o: 'double' }),
        aModule('after', { v: 'double' }, { o: 'double' }),
        aModule('far', { v: 'double' }),
      ],
      { 'source.o': '/x', 'after.v': '/x' },
    );
    const sockets = (from: string) =>
      connectables(loop, ref(loop, from), '', [], placeOf).map(({ text, hint, isLoop }) => ({
        text,
        isLoop,
        says: hint.includes('makes a loop'),
      }));
    expect(sockets('after.o')).toEqual([
      { text: 'far · v', isLoop: false, says: false },
      { text: 'source · v', isLoop: true, says: true },
    ]);
    expect(sockets('source.v')).toContainEqual({ text: 'after · o', isLoop: true, says: true });
  });

  it('says what is replaced at an input that has a wire', () => {
    expect(replacedAt(graph, ref(graph, 'near.value'))).toEqual(ref(graph, 'other.o'));
    expect(replacedAt(graph, ref(graph, 'far.value'))).toBeUndefined();
    expect(replacedAt(graph, ref(graph, 'other.o'))).toBeUndefined();
  });
});
