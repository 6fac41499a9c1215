import { expect, it } from 'vitest';
import { graphOf } from '../model/graph-of.ts';
import { aModule, aSessionOf } from '../model/testing/small-graph.ts';
import { listedPorts } from './listed-ports.ts';

const TOUCH = '/me/web-interface-smart-device/touch_position';

function portsOf(topic: string, wires: Record<string, string>) {
  const module = aModule('a', { i: 'vector2' }, { o: 'vector2' });
  const graph = graphOf(aSessionOf([module], wires));
  const node = graph.nodes.get(`topic:${topic}`)!;
  return listedPorts(graph, node, 'me').map(({ direction }) => direction);
}

it('leaves out the input of a topic that this smart device writes', () => {
  expect(portsOf(TOUCH, { 'a.i': TOUCH })).toEqual(['out']);
});

it('lists the input when a module writes the topic, and both sides of other topics', () => {
  expect(portsOf(TOUCH, { 'a.o': TOUCH })).toContain('in');
  expect(portsOf('/colour', { 'a.i': '/colour' })).toEqual(['in', 'out']);
});
