import { describe, expect, it } from 'vitest';
import { topicFault } from './topic-names.ts';

describe('topicFault', () => {
  it.each(['a', '/a/b', 'with space', '/ä/🙂', '/' + 'a'.repeat(1023), ' '])(
    'lets %j be a topic [TD-13]',
    (topic) => {
      expect(topicFault(topic, 1024)).toBeUndefined();
    },
  );

  it.each([
    ['', 'is empty'],
    ['a'.repeat(1025), 'is too long'],
    ['ä'.repeat(513), 'is too long'],
    ['/a\nb', 'contains a control character'],
    ['/a\u0000', 'contains a control character'],
    ['/a\u007f', 'contains a control character'],
    ['/a\u0085', 'contains a control character'],
  ])('finds what is wrong with %j [TD-13]', (topic, fault) => {
    expect(topicFault(topic, 1024)).toBe(fault);
  });
});
