import { expect, it } from 'vitest';
import { openInput } from './open-input.ts';
import { aGraphOf, aModule } from './testing/small-graph.ts';

const modules = [
  aModule('clock', {}, { sine: 'double' }),
  aModule('low-pass', { value: 'double', reset: 'bool' }, { smoothed: 'double' }),
];
const openAt = (mappings: Parameters<typeof aGraphOf>[1]): string | undefined => {
  const graph = aGraphOf(modules, mappings);
  return openInput(graph, graph.nodes.get('module:low-pass'))?.name;
};

it('is the first input of a module, while it has no wire', () => {
  expect(openAt({})).toBe('value');
  expect(openAt({ 'low-pass.smoothed': '/out' })).toBe('value');
  expect(openAt({ 'low-pass.value': '/in' })).toBeUndefined();
});

it('is none at a module without inputs, at a topic, and where there is a default', () => {
  const graph = aGraphOf(modules, { 'clock.sine': '/a' });
  expect(openInput(graph, graph.nodes.get('module:clock'))).toBeUndefined();
  expect(openInput(graph, graph.nodes.get('topic:/a'))).toBeUndefined();
  const node = graph.nodes.get('module:low-pass')!;
  const ports = node.ports.map((port) => ({ ...port, defaultJson: '{"double":1}' }));
  expect(openInput(graph, { ...node, ports })).toBeUndefined();
});
