import { fromJson, type ProcessingModule } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { aSession } from '../../sessions/testing/a-session.ts';
import { graphOf } from '../model/graph-of.ts';
import { addables, findAddables, insertables, sentenceOf } from './addable.ts';

const module = (name: string, input: string): ProcessingModule =>
  fromJson('ubii.processing.ProcessingModule', {
    name,
    inputs: [{ internalName: 'value', messageFormat: input }],
    outputs: [{ internalName: 'out', messageFormat: input }],
  });
const sources = {
  modules: [module('low-pass', 'double'), module('mirror', 'vector2')],
  topics: [
    { topic: '/a/number', format: 'double' },
    { topic: '/a/point', format: 'vector2' },
    { topic: '/info/session/new', format: 'session' },
  ],
};
const graph = graphOf(aSession());
const texts = (typed: string, end?: { node: string; port: string }): string[] =>
  addables(graph, sources, typed, end).map(({ text }) => text);

describe('nodes that can be added', () => {
  it('are modules, topics and the rest; what the master tells of itself is none', () => {
    expect(texts('')).toEqual([
      // Accepts the format of the topic that has no reader yet.
      'mirror',
      'low-pass',
      'Muxer',
      'Demuxer',
      'Value',
      'Note',
      'Frame',
      '/a/number',
      '/a/point',
    ]);
  });

  it('are found by words; an unused name is a new topic', () => {
    expect(texts('low')).toEqual(['low-pass', 'New topic /low']);
    expect(texts('/a/number')).toEqual(['/a/number']);
  });

  it('are ordered by where the words are, then by use', () => {
    const modules = [module('high-pass', 'double'), module('pass', 'double'), ...sources.modules];
    const found = (typed: string, ...recent: string[]): string[] =>
      findAddables(graph, { modules, topics: [] }, typed, { recent }).map(({ text }) => text);
    expect(found('pass').slice(0, 3)).toEqual(['pass', 'high-pass', 'low-pass']);
    expect(found('pass', 'low-pass').slice(0, 3)).toEqual(['pass', 'low-pass', 'high-pass']);
    expect(found('', 'low-pass')[0]).toBe('low-pass');
  });

  it('say in one sentence what they are', () => {
    const said = (typed: string): string => sentenceOf(findAddables(graph, sources, typed, {})[0]!);
    expect(said('low')).toBe('double → double');
    expect(said('/a/point')).toBe('topic, vector2');
    expect(said('muxer')).toMatch(/^Collects/);
  });

  it('fit the wire at hand', () => {
    const out = { node: 'module:module', port: 'out:mirrored' };
    const found = texts('', out);
    expect(found).toContain('mirror');
    expect(found).toContain('/a/point');
    expect(found).not.toContain('low-pass');
    expect(found).not.toContain('/a/number');
  });
});

it('what goes into a wire takes what it carries, and gives what it feeds', () => {
  const [wire] = graph.wires.keys();
  expect(insertables(graph, sources, '', wire!).map(({ text }) => text)).toEqual(['mirror']);
  expect(insertables(graph, sources, 'low', wire!)).toEqual([]);
});
