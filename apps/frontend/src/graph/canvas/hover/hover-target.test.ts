import { expect, it } from 'vitest';
import { aGraphOf, aModule } from '../../model/testing/small-graph.ts';
import { inputPort } from '../../model/ports.ts';
import { hoverWords } from './hover-target.ts';

it('tells at a socket what its values mean, with and without a wire [PM-6]', () => {
  const module = aModule('low-pass', { value: 'double', cutoffHz: 'double' });
  module.inputs[0]!.description = 'Value to smooth.';
  const graph = aGraphOf([module], { 'low-pass.value': '/in' });
  const words = (input: string) =>
    hoverWords(graph, { kind: 'port', ref: { node: 'module:low-pass', port: inputPort(input) } });
  expect(words('value')).toMatchObject({ about: 'Value to smooth.', topic: '/in' });
  expect(words('cutoffHz')?.about).toBeUndefined();
});
