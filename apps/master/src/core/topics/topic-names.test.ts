import { describe, expect, it } from 'vitest';
import { isLongerThan } from '../texts/text-length.ts';
import { quote, topicFault } from './topic-names.ts';

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

describe('isLongerThan', () => {
  it.each(['a', 'é', '€', '🙂', 'aé€🙂'])('counts the bytes of %j in UTF-8', (text) => {
    const { byteLength } = new TextEncoder().encode(text);
    expect(isLongerThan(text, byteLength)).toBe(false);
    expect(isLongerThan(text, byteLength - 1)).toBe(true);
  });
});

describe('quote', () => {
  it('keeps any text on one short line', () => {
    expect(quote('/a\n"b"')).toBe('"/a\\n\\"b\\""');
    expect(quote('x'.repeat(100_000)).length).toBeLessThan(130);
  });
});
