import { describe, expect, it } from 'vitest';
import { parseProgress, withLesson } from './progress.ts';

describe('progress of lessons', () => {
  it('comes back as it was kept', () => {
    const progress = withLesson({}, 'a', { reached: 2, isDone: false });
    expect(parseProgress(JSON.stringify(progress))).toEqual(progress);
  });

  it.each([null, '', '{', '[]', 'null', '{"a":1}', '{"a":{"reached":"x","isDone":true}}'])(
    'starts empty from %s',
    (text) => expect(parseProgress(text)).toEqual({}),
  );
});
