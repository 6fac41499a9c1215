import { expect, it } from 'vitest';
import { isInternalTopic } from './internal-topics.ts';

it.each([
  ['/0c9a/graph_editor/presence', true],
  ['/0c9a/graph_editor/presence/more', false],
  ['/0c9a/identify', true],
  ['/0c9a/robot/identify', false],
  ['/0c9a/preflight', true],
  ['/0c9a/robot/preflight', false],
  ['/0c9a/pointer/position', false],
])('[EX-49] %s is internal: %s', (topic, isInternal) => {
  expect(isInternalTopic(topic)).toBe(isInternal);
});
