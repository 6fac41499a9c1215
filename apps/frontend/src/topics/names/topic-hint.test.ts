import { expect, it } from 'vitest';
import { topicHint } from './topic-hint.ts';

it.each([
  ['', undefined],
  ['/lab/light', undefined],
  ['/lab/light 1', /contains spaces/],
  ['/lab/light ', /contains spaces/],
  ['lab/light', /"lab\/light" and "\/lab\/light" are two different topics/],
  ['/lab/*', /contains "\*"/],
  ['/', /empty part/],
  ['/lab//light', /empty part/],
])('hints at what is unusual about %j', (topic, hint) => {
  const shown = topicHint(topic, { published: 'double', held: '' });
  if (hint === undefined) expect(shown).toBeUndefined();
  else expect(shown).toMatch(hint);
});

it('hints at another data format than the one that the topic holds', () => {
  const hint = (held: string) => topicHint('/lab/light', { published: 'vector2', held });
  expect(hint('double')).toBe('This topic holds double. Its subscribers may not expect vector2.');
  expect(hint('vector2')).toBeUndefined();
});
