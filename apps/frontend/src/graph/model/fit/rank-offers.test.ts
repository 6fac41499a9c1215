import { describe, expect, it } from 'vitest';
import type { PortRef } from '../graph.ts';
import { aGraphOf, aModule, ref } from '../testing/small-graph.ts';
import { fittingNodes } from './fitting.ts';

const library = [
  aModule('a-gain', { value: 'vector2', gain: 'double' }, { out: 'vector2' }),
  aModule('b-log', { value: '' }, { text: 'string' }),
  aModule('c-count', { count: 'int32' }, { sum: 'int32', mean: 'double' }),
  aModule('d-low-pass', { value: 'double', cutoff: 'double' }, { smoothed: 'double' }),
];
const modules = [
  aModule('m', { value: 'double' }, { out: 'double' }),
  aModule('other', { value: 'double' }),
];
const graph = aGraphOf(modules, {
  'm.value': '/read',
  'm.out': '/written',
  'other.value': '/free',
});
const topics = [
  { topic: '/a/count', format: 'int32' },
  { topic: '/b/unknown', format: '' },
  { topic: '/c/number', format: 'double' },
];
const offered = (from: PortRef): string[] =>
  fittingNodes(graph, from, library, topics).map(({ kind, label }) => `${kind} ${label}`);

describe('what a wire is offered [SE-70]', () => {
  it('starts with modules whose main input has the format, then what is converted to it', () => {
    expect(offered({ node: 'topic:/read', port: 'out' })).toEqual([
      'module d-low-pass',
      'module c-count',
      'module b-log',
      'module a-gain',
    ]);
  });

  it('for an output, is a topic without publisher before a new one, and others after modules', () => {
    expect(offered(ref(graph, 'm.out'))).toEqual([
      'topic /free',
      'topic /Test/out',
      'module d-low-pass',
      'module c-count',
      'module b-log',
      'module a-gain',
      'topic /read',
      'topic /written',
      'topic /c/number',
      'topic /a/count',
      'topic /b/unknown',
    ]);
  });

  it('for an input, is the topics that there are, those of the graph first', () => {
    expect(offered(ref(graph, 'm.value'))).toEqual([
      'topic /read',
      'topic /free',
      'topic /written',
      'topic /c/number',
      'topic /a/count',
      'constant Constant',
      'module d-low-pass',
      'module c-count',
      'topic /b/unknown',
    ]);
  });
});
