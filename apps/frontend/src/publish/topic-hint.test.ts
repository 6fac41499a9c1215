import { expect, it } from 'vitest';
import { topicHint } from './topic-hint.ts';

it.each([
  ['', undefined],
  ['/lab/light', undefined],
  ['/lab/light 1', /contains spaces/],
  ['/lab/light ', /contains spaces/],
  ['lab/light', /"lab\/light" and "\/lab\/light" are two different topics/],
  ['/', /empty part/],
  ['/lab//light', /empty part/],
])('hints at what is unusual about %j', (topic, hint) => {
  if (hint === undefined) expect(topicHint(topic)).toBeUndefined();
  else expect(topicHint(topic)).toMatch(hint);
});
