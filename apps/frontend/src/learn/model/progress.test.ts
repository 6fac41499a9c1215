import { describe, expect, it } from 'vitest';
import { storedProgress, withLesson } from './progress.ts';

describe('progress of lessons', () => {
  it('comes back as it was kept', () => {
    const progress = withLesson({}, 'a', { reached: 2, isDone: false });
    expect(storedProgress.read(storedProgress.write(progress))).toEqual(progress);
  });

  it.each(['', '{', '[]', 'null', '{"a":1}', '{"a":{"reached":"x","isDone":true}}'])(
    'starts empty from %s',
    (text) => expect(storedProgress.read(text)).toEqual({}),
  );
});
