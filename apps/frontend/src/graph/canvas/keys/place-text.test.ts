import { describe, expect, it } from 'vitest';
import { topicNode } from '../../model/make-node.ts';
import { applyCommand } from '../../model/commands/apply-command.ts';
import { aGraphOf, aModule, ref } from '../../model/testing/small-graph.ts';
import { startOf } from './key-walk.ts';
import { placeText, valueText } from './place-text.ts';

const graph = applyCommand(
  aGraphOf(
    [
      aModule('source', {}, { o: 'double', p: 'double' }),
      aModule('sink', { i: 'double', free: 'vector2' }),
    ],
    { 'source.o': '/a', 'sink.i': '/a' },
  ),
  { kind: 'add', nodes: [topicNode('/hand/left')] },
).graph;
const valueOf = (topic: string): string | undefined => (topic === '/a' ? '0.52' : undefined);

describe('placeText', () => {
  it('names a node in full', () => {
    expect(placeText(graph, { node: 'topic:/hand/left', port: undefined })).toEqual({
      name: '/hand/left',
      rest: 'topic, no wires',
    });
  });

  it('names a socket, its format and what it is connected to', () => {
    expect(placeText(graph, ref(graph, 'sink.i'))).toEqual({
      name: 'sink · i',
      rest: 'input, double, connected to source · o',
    });
    expect(placeText(graph, ref(graph, 'sink.free'))?.rest).toBe('input, vector2, not connected');
  });
});

describe('valueText', () => {
  it('says the value on a wire', () => {
    expect(valueText(graph, ref(graph, 'sink.i'), valueOf)).toBe('Value 0.52.');
    expect(valueText(graph, ref(graph, 'sink.free'), valueOf)).toBe('');
  });

  it('says that nothing was published', () => {
    const place = { node: 'topic:/hand/left', port: undefined };
    expect(valueText(graph, place, valueOf)).toBe('Nothing published.');
  });
});

describe('startOf', () => {
  it('prefers an output without wires', () => {
    expect(startOf(graph, 'module:source')?.name).toBe('p');
    expect(startOf(graph, 'module:sink')?.name).toBe('free');
    expect(startOf(graph, 'nowhere')).toBeUndefined();
  });

  it('is the main input of a module that nothing feeds', () => {
    const low = aGraphOf([aModule('low-pass', { value: 'double' }, { smoothed: 'double' })]);
    expect(startOf(low, 'module:low-pass')?.name).toBe('value');
  });
});
