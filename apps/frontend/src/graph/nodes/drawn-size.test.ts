import { expect, it } from 'vitest';
import { topicNode } from '../model/make-node.ts';
import { nodeWidth } from './drawn-size.ts';
import { NODE } from './node-geometry.ts';

const widthOf = (topic: string): number => nodeWidth(topicNode(topic));

it('a topic is as wide as its last level needs, within limits', () => {
  expect(widthOf('/a/position')).toBe(NODE.topicWidth);
  const long = widthOf('/a/mouse_client_position');
  expect(long).toBeGreaterThan(NODE.topicWidth);
  expect(widthOf('/a/mouse_client_position_smoothed')).toBeGreaterThan(long);
  expect(widthOf(`/a/${'long_'.repeat(20)}`)).toBe(widthOf(`/a/${'long_'.repeat(40)}`));
});
